//! From `initial.frame`, a frame of an earlier run, to a state of the gas as a function of position: a flow that a coarse
//! lattice has found soon settles on a fine one.

use std::path::Path;
use std::sync::Arc;

use aero_geometry::kernel::{QuinticSpline, SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Pencils, Vector};
use vtkio::model::{Attribute, DataSet, Piece, PolyDataPiece, Vtk};

use super::error::SceneError;
use aero_solver::frame::Kind;
use aero_solver::problem::{Earlier, Field, Initial, Split, State};

/// Two points are one if they are no further apart than this part of their size.
const SAME: f64 = 1e-6;

/// Length of the sum of two directions below which they are opposed, and nothing says about what to turn.
const OPPOSED: f64 = 1e-6;

/// Logarithm of the ratio of two densities or pressures, one place in two flows, above which a shock has passed between them.
const PASSED: f64 = 0.3;

/// Where the kernels of the gas nearby add up to less, as between a body of the frame and one that the scene has
/// elsewhere, the nearest particle's state is taken.
const SPARSE: f64 = 1e-3;

/// A flow that starts as `flow`, or beyond it by a part of the way to it from another one.
pub(super) fn initial<const D: usize>(
    flow: Turned<D>,
    trend: Option<(Turned<D>, f64)>,
) -> Initial<D> {
    let (spacing, split) = (flow.spacing, flow.split.clone());
    let state = move |position: &Vector<D>| {
        let state = flow.at(position);
        match &trend {
            Some((before, part)) => beyond(&state, &before.at(position), *part),
            None => state,
        }
    };
    Initial::Earlier(Earlier {
        field: Field(Arc::new(state)),
        spacing,
        split: split.into(),
    })
}

/// The state that follows on `now` as that did on `before`, so much further; `now` where a shock has passed between them.
fn beyond<const D: usize>(now: &State<D>, before: &State<D>, part: f64) -> State<D> {
    let steps = [now.density / before.density, now.pressure / before.pressure];
    if steps.iter().any(|step| step.ln().abs() > PASSED) {
        return *now;
    }
    State {
        density: now.density * steps[0].powf(part),
        velocity: now.velocity + (now.velocity - before.velocity) * part,
        pressure: now.pressure * steps[1].powf(part),
    }
}

/// An earlier flow, turned to the stream of now.
pub(super) struct Turned<const D: usize> {
    flow: Flow<D>,
    /// Of its lattice.
    spacing: Option<f64>,
    split: Vec<Split<D>>,
    turn: Option<Turn<D>>,
}

impl<const D: usize> Turned<D> {
    /// The flow of the frame at `path`, which the key `place` gives; where its stream was another, `streams` are that one and the one
    /// it is turned to.
    ///
    /// # Errors
    /// A file that is not the frame of a run in `D` dimensions.
    pub(super) fn new(
        place: &str,
        path: &Path,
        streams: Option<[&State<D>; 2]>,
    ) -> Result<Self, SceneError> {
        let flow = read(path)
            .and_then(|columns| Ok((Flow::<D>::new(&columns)?, widest(&columns), split(&columns))));
        let (flow, spacing, split) = flow.map_err(|fault| {
            let path = path.display();
            let message =
                format!("`{path}` {fault}; give a `frame-NNNNNN.vtp` that a run has written");
            SceneError::value(place, message)
        })?;
        Ok(Self {
            flow,
            spacing,
            split,
            turn: streams.map(|[from, to]| Turn::new(from, to)),
        })
    }

    fn at(&self, position: &Vector<D>) -> State<D> {
        let state = self.flow.at(position);
        self.turn.as_ref().map_or(state, |turn| turn.of(&state))
    }
}

/// From one stream to another: turned about the line across both, and scaled.
struct Turn<const D: usize> {
    /// Across the planes of two reflections, whose product turns the one stream into the other.
    across: [Vector<D>; 2],
    speed: f64,
    density: f64,
    pressure: f64,
}

impl<const D: usize> Turn<D> {
    fn new(from: &State<D>, to: &State<D>) -> Self {
        let ways = [from, to].map(|stream| stream.velocity.try_normalize(0.0));
        let across = match ways {
            [Some(a), Some(b)] if a != b => {
                let middle = (a + b).try_normalize(OPPOSED);
                middle.map(|middle| [a, middle])
            }
            _ => None,
        };
        let [before, now] = [from, to].map(|stream| stream.velocity.norm());
        Self {
            across: across.unwrap_or([Vector::zeros(); 2]),
            speed: if before > 0.0 { now / before } else { 1.0 },
            density: to.density / from.density,
            pressure: to.pressure / from.pressure,
        }
    }

    fn of(&self, state: &State<D>) -> State<D> {
        let mirrored = |u: Vector<D>, across: &Vector<D>| u - across * (2.0 * across.dot(&u));
        let [first, second] = &self.across;
        State {
            density: self.density * state.density,
            velocity: mirrored(mirrored(state.velocity, first), second) * self.speed,
            pressure: self.pressure * state.pressure,
        }
    }
}

/// The points of cells that the lattice was split into.
fn split<const D: usize>(columns: &Columns) -> Vec<Split<D>> {
    let Some(widest) = widest(columns) else {
        return Vec::new();
    };
    let numbers = (0..columns.spacing.len()).filter(|&n| columns.spacing[n] < 0.75 * widest);
    let each = numbers.map(|n| Split {
        point: Vector::from_fn(|k, _| columns.position[3 * n + k]),
        level: (widest / columns.spacing[n]).log2().round() as u8,
    });
    each.collect()
}

/// Spacing of the lattice of points that stay.
fn widest(columns: &Columns) -> Option<f64> {
    let spacings = columns.spacing.iter().copied();
    spacings
        .filter(|spacing| spacing.is_finite())
        .max_by(f64::total_cmp)
}

/// What a frame says of its particles; vectors three numbers each.
struct Columns {
    position: Vec<f64>,
    velocity: Vec<f64>,
    density: Vec<f64>,
    pressure: Vec<f64>,
    smoothing_length: Vec<f64>,
    /// Of points that stay, otherwise empty.
    spacing: Vec<f64>,
    kind: Vec<f64>,
}

fn read(path: &Path) -> Result<Columns, String> {
    std::fs::File::open(path).map_err(|error| format!("cannot be read: {error}"))?;
    let vtk = Vtk::import(path).map_err(|_| "is no VTK file, or not all of one")?;
    let DataSet::PolyData { pieces, .. } = vtk.data else {
        return Err("holds no `PolyData`".into());
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        return Err("holds no points".into());
    };
    let position: Vec<f64> = piece.points.cast_into().unwrap_or_default();
    let count = position.len() / 3;
    let column = |name, components| column(&piece, name, components * count);
    Ok(Columns {
        velocity: column("velocity", 3)?,
        density: column("density", 1)?,
        pressure: column("pressure", 1)?,
        smoothing_length: column("smoothing_length", 1)?,
        kind: column("kind", 1)?,
        spacing: column("spacing", 1).unwrap_or_default(),
        position,
    })
}

/// The `length` numbers of a named array.
fn column(piece: &PolyDataPiece, name: &str, length: usize) -> Result<Vec<f64>, String> {
    let arrays = piece.data.point.iter();
    let mut named = arrays.filter_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => Some(&array.data),
        _ => None,
    });
    let data = named
        .next()
        .ok_or_else(|| format!("has no array `{name}`"))?;
    let numbers: Vec<f64> = data.cast_into().unwrap_or_default();
    if numbers.len() == length {
        return Ok(numbers);
    }
    let found = numbers.len();
    Err(format!(
        "has {found} numbers in the array `{name}`, not {length}"
    ))
}

/// Gas of an earlier run, sorted in space.
struct Flow<const D: usize> {
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
    fn new(columns: &Columns) -> Result<Self, String> {
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
    fn at(&self, position: &Vector<D>) -> State<D> {
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
    fn a_flow_is_turned_and_sped_up_with_its_stream() {
        let stream = |mach: f64, degrees: f64| State {
            density: 1.4,
            velocity: Vector::<2>::new(degrees.to_radians().cos(), degrees.to_radians().sin())
                * mach,
            pressure: 1.0,
        };
        let (from, to) = (stream(2.0, 3.0), stream(3.0, 8.0));
        let turn = Turn::new(&from, &to);
        assert!((turn.of(&from).velocity - to.velocity).norm() < 1e-14);
        // What flows at ten degrees to the one flows at ten degrees to the other.
        let aside = turn.of(&stream(1.0, 13.0));
        assert!((aside.velocity - stream(1.5, 18.0).velocity).norm() < 1e-14);
        assert_eq!((aside.density, aside.pressure), (1.4, 1.0));
    }

    #[test]
    fn a_trend_goes_on_unless_a_shock_has_passed() {
        let state = |density: f64, speed: f64| State {
            density,
            velocity: Vector::<2>::new(speed, 0.0),
            pressure: density,
        };
        let on = beyond(&state(1.1, 2.0), &state(1.0, 1.5), 0.5);
        assert!((on.density - 1.1 * 1.1_f64.sqrt()).abs() < 1e-14);
        assert_eq!(on.velocity[0], 2.25);
        let now = state(2.0, 1.0);
        assert_eq!(beyond(&now, &state(1.0, 1.5), 1.0), now);
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
