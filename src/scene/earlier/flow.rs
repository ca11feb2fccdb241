//! The gas of an earlier run as a state at any place.

use aero_geometry::kernel::{QuinticSpline, SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Pencils, Vector};
use aero_solver::frame::Kind;
use aero_solver::problem::State;

use super::columns::Columns;

/// Two points are one if they are no further apart than this part of their size.
const SAME: f64 = 1e-6;

/// Where the kernels of the gas nearby add up to less, as between a body of the frame and one that the scene has
/// elsewhere, the nearest particle's state is taken.
const SPARSE: f64 = 1e-3;

/// Gas of an earlier run, sorted in space.
pub struct Flow<const D: usize> {
    pencils: Pencils<D>,
    particles: Vec<Particle<D>>,
    /// The furthest that any of them is seen.
    reach: f64,
}

#[derive(Clone, Copy)]
struct Particle<const D: usize> {
    position: Vector<D>,
    smoothing_length: f64,
    state: State<D>,
}

impl<const D: usize> Flow<D> {
    pub fn new(columns: &Columns) -> Result<Self, String> {
        let vector = |numbers: &[f64], n: usize| Vector::from_fn(|k, _| numbers[3 * n + k]);
        let is_gas = |n: &usize| columns.kind[*n] != f64::from(Kind::Ghost as u8);
        let numbers = || (0..columns.density.len()).filter(is_gas);
        let dimension = (0..3)
            .rev()
            .find(|k| numbers().any(|n| columns.position[3 * n + k] != 0.0));
        match dimension.map(|k| k + 1) {
            None => return Err("holds no gas".into()),
            Some(dimension) if dimension != D => {
                let message = format!("is of dimension {dimension}, but the scene of {D}");
                return Err(message);
            }
            Some(_) => {}
        }
        let mut particles = Vec::new();
        for n in numbers() {
            let particle = Particle {
                position: vector(&columns.position, n),
                smoothing_length: columns.smoothing_length[n],
                state: State {
                    density: columns.density[n],
                    velocity: vector(&columns.velocity, n),
                    pressure: columns.pressure[n],
                },
            };
            if !particle.makes_sense() {
                return Err(format!("has no gas that can be at point {n}"));
            }
            particles.push(particle);
        }
        let largest = |most: f64, p: &Particle<D>| most.max(p.smoothing_length);
        let largest = particles.iter().fold(0.0, largest);
        let positions: Vec<_> = particles.iter().map(|p| p.position).collect();
        let pencils = Pencils::new(&positions, 2.0 * largest / SMOOTHING_RATIO);
        let order = pencils.order().iter();
        Ok(Self {
            particles: order.map(|&n| particles[n as usize]).collect(),
            pencils,
            reach: SUPPORT * largest,
        })
    }

    /// The mean of the gas nearby, each particle weighted by its kernel and volume [Shepard 1968].
    pub fn at(&self, position: &Vector<D>) -> State<D> {
        let mut sum = State {
            density: 0.0,
            velocity: Vector::zeros(),
            pressure: 0.0,
        };
        let mut weights = 0.0;
        if let Some(state) = self.of_point(position) {
            return state;
        }
        self.for_each_within(self.reach, position, |particle, distance| {
            let h = particle.smoothing_length;
            let volume = (h / SMOOTHING_RATIO).powi(D as i32);
            let weight = QuinticSpline::<D>::value(distance, h) * volume;
            weights += weight;
            sum.density += particle.state.density * weight;
            sum.velocity += particle.state.velocity * weight;
            sum.pressure += particle.state.pressure * weight;
        });
        if weights < SPARSE {
            return self.nearest(position);
        }
        State {
            density: sum.density / weights,
            velocity: sum.velocity / weights,
            pressure: sum.pressure / weights,
        }
    }

    /// State of the particle that is right there, as on the same lattice.
    fn of_point(&self, position: &Vector<D>) -> Option<State<D>> {
        let mut found = None;
        self.for_each_within(SAME * self.reach, position, |particle, distance| {
            if distance < SAME * particle.smoothing_length {
                found = Some(particle.state);
            }
        });
        found
    }

    /// State of the nearest particle; there is one.
    fn nearest(&self, position: &Vector<D>) -> State<D> {
        let mut reach = self.reach;
        let mut nearest = (f64::INFINITY, self.particles[0].state);
        while nearest.0 > reach && reach.is_finite() {
            reach *= 2.0;
            self.for_each_within(reach, position, |particle, distance| {
                if distance < nearest.0 {
                    nearest = (distance, particle.state);
                }
            });
        }
        nearest.1
    }

    /// Calls `visit` with all particles that may be within `reach` of `position`, and their distances.
    fn for_each_within(
        &self,
        reach: f64,
        position: &Vector<D>,
        mut visit: impl FnMut(&Particle<D>, f64),
    ) {
        let (low, high) = (position.add_scalar(-reach), position.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |run| {
            for particle in &self.particles[run] {
                visit(particle, (particle.position - position).norm());
            }
        });
    }
}

impl<const D: usize> Particle<D> {
    fn makes_sense(&self) -> bool {
        let positive = [
            self.state.density,
            self.state.pressure,
            self.smoothing_length,
        ];
        let finite = self.position.iter().chain(&self.state.velocity);
        positive.iter().all(|x| *x > 0.0 && x.is_finite()) && finite.copied().all(f64::is_finite)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice of gas in the plane whose density is `1 + x` and whose velocity is `(y, 0)`, with a ghost far off.
    fn columns(spacing: f64) -> Columns {
        let mut columns = Columns {
            position: vec![9.0, 9.0, 0.0],
            velocity: vec![0.0; 3],
            density: vec![7.0],
            pressure: vec![7.0],
            smoothing_length: vec![1.5 * spacing],
            kind: vec![f64::from(Kind::Ghost as u8)],
            spacing: Vec::new(),
        };
        let count = (1.0 / spacing) as usize;
        for number in 0..count * count {
            let place = |n: usize| (n as f64 + 0.5) * spacing;
            let (x, y) = (place(number % count), place(number / count));
            columns.position.extend([x, y, 0.0]);
            columns.velocity.extend([y, 0.0, 0.0]);
            columns.density.push(1.0 + x);
            columns.pressure.push(1.0);
            columns.smoothing_length.push(1.5 * spacing);
            columns.kind.push(f64::from(Kind::Fluid as u8));
        }
        columns
    }

    #[test]
    fn the_flow_inside_is_that_of_the_frame() {
        let flow = Flow::<2>::new(&columns(0.05)).expect("a flow");
        for (x, y) in [(0.5, 0.5), (0.31, 0.62), (0.72, 0.27)] {
            let state = flow.at(&Vector::<2>::new(x, y));
            // A kernel sum over a lattice is even about its points alone.
            assert!((state.density - 1.0 - x).abs() < 2e-3, "{}", state.density);
            assert!((state.velocity - Vector::<2>::new(y, 0.0)).norm() < 2e-3);
            assert!((state.pressure - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn far_from_all_gas_the_nearest_particle_is_asked() {
        let flow = Flow::<2>::new(&columns(0.05)).expect("a flow");
        let state = flow.at(&Vector::<2>::new(50.0, 0.5));
        assert!((state.density - 1.975).abs() < 1e-12, "{}", state.density);
    }

    #[test]
    fn a_frame_of_another_dimension_or_without_gas_is_refused() {
        let fault = |columns: &Columns| Flow::<3>::new(columns).err().unwrap_or_default();
        assert!(fault(&columns(0.1)).contains("dimension 2"));
        let mut ghosts = columns(0.1);
        ghosts.kind.fill(f64::from(Kind::Ghost as u8));
        assert!(fault(&ghosts).contains("no gas"));
        let mut broken = columns(0.1);
        broken.density[5] = f64::NAN;
        let fault = Flow::<2>::new(&broken).err().unwrap_or_default();
        assert!(fault.contains("point 5"), "{fault}");
    }
}
