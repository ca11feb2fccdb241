//! What the lift of bodies does to a stream slower than sound far away: it goes around them as around a vortex, and on the sides of any box
//! that is felt, by `1 / r` in the plane. Sides that held the stream straight would hold the lift down: an aerofoil at Mach 0.8 by an
//! eighth, ten chords from it.
//!
//! [Thomas & Salas 1986, AIAA J. 24, 1074-1080]

use aero_geometry::{Bounds, Vector};

use super::FixedSimulation;
use super::beyond::Beyond;
use super::cells::Cells;
use super::given::standing;
use super::net::Net;
use super::state::Primitive;
use crate::method::Time;
use crate::problem::{Problem, Side, State};

/// Part of the way that the circulation goes in one iteration to that of the lift now, which swings before it settles.
const RATE: f64 = 0.05;

/// The stream, and the faces that it comes and goes through.
#[derive(Clone, Debug)]
pub struct FarField<const D: usize> {
    faces: Vec<FarFace<D>>,
    stream: State<D>,
    /// Its speed of sound.
    sound: f64,
}

/// A face with the stream beyond it.
#[derive(Clone, Debug)]
struct FarFace<const D: usize> {
    /// Block of its cell.
    block: usize,
    /// Its number there.
    side: usize,
    /// The velocity that a circulation of one adds there.
    turn: Vector<D>,
}

impl<const D: usize> Problem<D> {
    /// True of a plane stream slower than sound around bodies that nothing but the stream and outlets bound: what lift does to it is felt
    /// on all sides.
    pub fn feels_lift_far_away(&self) -> bool {
        use Side::{FreeStream, HeldOutlet, Inlet, Outlet, SoftInlet};
        let is_free = |side: &Side| {
            matches!(
                side,
                Inlet | SoftInlet | FreeStream | Outlet | HeldOutlet { .. }
            )
        };
        let stream = &self.free_stream;
        let speed = stream.velocity.norm();
        D == 2
            && !self.bodies.is_empty()
            && self.domain.openings.is_empty()
            && self.domain.sides.iter().flatten().all(is_free)
            && speed > 0.0
            && speed < self.gas.sound_speed_at(stream.density, stream.pressure)
    }
}

impl<const D: usize> FarField<D> {
    /// That of `problem` on `cells`, which stand in `net`; none but of a plane stream slower than sound around bodies, which settles and
    /// which nothing but the stream and outlets bound.
    pub fn of(problem: &Problem<D>, cells: &Cells<D>, net: &Net<D>) -> Option<Self> {
        let bodies = problem.bodies.iter().map(|body| body.shape.bounds());
        let bodies = bodies.reduce(|a, b| Bounds::new(a.min.inf(&b.min), a.max.sup(&b.max)))?;
        let stream = problem.free_stream;
        let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
        let speed = stream.velocity.norm();
        let settles = problem.method.fixed().map(|points| points.time) == Some(Time::Settle);
        if !settles || !problem.feels_lift_far_away() {
            return None;
        }
        let centre = (bodies.min + bodies.max) * 0.5;
        let along = stream.velocity / speed;
        let faces = standing(cells).map(|(block, side, face)| FarFace {
            block,
            side,
            turn: turn(&(face.centre - centre), &along, speed / sound),
        });
        let holds_stream = |face: &FarFace<D>| {
            let side = &net.blocks[face.block].sides[face.side];
            matches!(side.beyond, Beyond::Stream(_))
        };
        Some(Self {
            faces: faces.filter(holds_stream).collect(),
            stream,
            sound,
        })
    }

    /// The stream where it is turned by `turn`: its total enthalpy and entropy are what they were, up to the square of the turn.
    fn turned(&self, turn: &Vector<D>) -> Primitive<D> {
        let State {
            density,
            velocity,
            pressure,
        } = self.stream;
        let rise = -density * (velocity.dot(turn) + 0.5 * turn.norm_squared());
        Primitive {
            density: density + rise / (self.sound * self.sound),
            velocity: (velocity + turn).into(),
            pressure: pressure + rise,
        }
    }
}

/// The velocity at `arm` from a vortex of circulation one, clockwise, in a stream `along` at `mach`:
/// `sqrt(1 - M^2) / (2 pi r (1 - M^2 sin^2))` across the arm, with the sine of its angle to the stream.
fn turn<const D: usize>(arm: &Vector<D>, along: &Vector<D>, mach: f64) -> Vector<D> {
    let across = |v: &Vector<D>| Vector::<D>::from_fn(|k, _| [v[1], -v[0]][k.min(1)]);
    let square = arm.norm_squared();
    let sine = across(along).dot(arm);
    let slimmer = (1.0 - mach * mach).sqrt();
    across(arm) * (slimmer / (std::f64::consts::TAU * (square - (mach * sine).powi(2))))
}

impl<const D: usize> FixedSimulation<D> {
    /// Turns the stream beyond the sides as the lift does that all bodies have now, `L = rho U Gamma` [Kutta, Joukowski].
    pub(super) fn turn_far_field(&mut self) {
        let Some(far) = &self.outside.far_field else {
            return;
        };
        let velocity = far.stream.velocity;
        let loads = self.loads();
        let force = |k: usize| -> f64 { loads.iter().map(|load| load.force[k]).sum() };
        let lift = (force(1) * velocity[0] - force(0) * velocity[1]) / velocity.norm();
        let now = lift / (far.stream.density * velocity.norm());
        let circulation = match self.settling.circulation {
            None if self.settling.is_near => now,
            before => {
                let before = before.unwrap_or_default();
                before + RATE * (now - before)
            }
        };
        self.settling.circulation = Some(circulation);
        for face in &far.faces {
            let side = &mut self.net.blocks[face.block].sides[face.side];
            side.beyond = Beyond::Stream(far.turned(&(face.turn * circulation)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MACH: f64 = 0.6;

    fn along() -> Vector<2> {
        Vector::<2>::new(0.8, 0.6)
    }

    fn velocity(arm: &Vector<2>) -> Vector<2> {
        turn(arm, &along(), MACH)
    }

    #[test]
    fn its_circulation_is_one_clockwise() {
        let count = 2000;
        let around = (0..count).map(|k| {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(count);
            let [tangent, arm] = [angle + 0.5 * std::f64::consts::PI, angle]
                .map(|angle| Vector::<2>::new(angle.cos(), angle.sin()));
            velocity(&(arm * 3.0)).dot(&tangent) * 3.0
        });
        let circulation = around.sum::<f64>() * std::f64::consts::TAU / f64::from(count);
        assert!((circulation + 1.0).abs() < 1e-12, "{circulation}");
        assert!(
            velocity(&-along()).dot(&Vector::<2>::new(-0.6, 0.8)) > 0.0,
            "ahead it goes up"
        );
    }

    /// `(1 - M^2) du/ds + dv/dn = 0` of small changes, and no vorticity, along and across the stream.
    #[test]
    fn it_neither_makes_gas_nor_turns_it() {
        let [s, n] = [along(), Vector::<2>::new(-0.6, 0.8)];
        let step = 1e-4;
        for arm in [[2.0, 0.3], [-0.5, 1.7], [0.4, -3.0]].map(Vector::from) {
            let slope = |way: &Vector<2>, of: &Vector<2>| {
                (velocity(&(arm + way * step)) - velocity(&(arm - way * step))).dot(of)
                    / (2.0 * step)
            };
            let made = (1.0 - MACH * MACH) * slope(&s, &s) + slope(&n, &n);
            let turned = slope(&s, &n) - slope(&n, &s);
            let size = slope(&s, &s).abs() + slope(&s, &n).abs();
            assert!(made.abs() < 1e-6 * size, "{made}");
            assert!(turned.abs() < 1e-6 * size, "{turned}");
        }
    }

    #[test]
    fn the_stream_that_is_turned_keeps_its_total_state() {
        let far = FarField {
            faces: Vec::new(),
            stream: State {
                density: 1.4,
                velocity: Vector::<2>::new(0.5, 0.2),
                pressure: 1.0,
            },
            sound: 1.0,
        };
        let kept = |size: f64| {
            let state = far.turned(&(Vector::<2>::new(0.3, -0.7) * size));
            let speed: f64 = state.velocity.iter().map(|u| u * u).sum();
            let sound = 1.4 * state.pressure / state.density;
            [
                state.pressure / state.density.powf(1.4),
                sound / 0.4 + 0.5 * speed,
            ]
        };
        let ([s0, h0], [s, h]) = (kept(0.0), kept(0.01));
        assert!((s / s0 - 1.0).abs() < 1e-4 && (h / h0 - 1.0).abs() < 1e-4);
    }
}
