//! What bodies do to a stream slower than sound far away. It goes around those with lift as around a vortex, aside of the wake of those with drag as
//! of a source, and of those with a volume as of a doublet; on the sides of any box that is felt, by `1 / r` and `1 / r^2` in the plane. Sides that
//! held the stream straight would hold the lift down, of an aerofoil at Mach 0.8 by an eighth, ten chords from it, and squeeze the stream past
//! a body as the walls of a channel do.
//!
//! Changes of the velocity, `u` along the stream and `v` across it, are small there: `(1 - M^2) du/dx + dv/dy = 0` and `du/dy = dv/dx`, so that
//! `w = u - i v / b`, `b = sqrt(1 - M^2)`, is an analytic function of `z = x + i b y` [Prandtl and Glauert], and beyond all bodies
//! `w = sum a_k / z^k`. Whatever comes in from beyond the sides is a sum of powers of `z`, and no part of `a_k = 1/(2 pi i) of the integral of
//! w z^(k - 1) dz` around the bodies: what they do is told from the gas at the sides, what the sides do is not.
//!
//! [Vortex: Thomas & Salas 1986, AIAA J. 24, 1074-1080; source and doublet: Giles & Drela 1987, AIAA J. 25, 1199-1206]

use aero_geometry::{Bounds, Vector};
use nalgebra::Complex;

use super::FixedSimulation;
use super::beyond::{Beyond, is_free};
use super::cells::{Cells, SideFace};
use super::given::standing;
use super::net::Net;
use super::poles::{Frame, Poles, left_of};
use super::state::Primitive;
use crate::problem::{Problem, Side, State};

/// Part of the way that the poles go in one iteration to those of the flow now, which swings before it settles.
const RATE: f64 = 0.05;

/// Largest change of the stream's speed by what bodies do to it, of that speed.
const MOST: f64 = 0.2;

/// The stream, and the faces that it comes and goes through.
#[derive(Clone, Debug)]
pub struct FarField<const D: usize> {
    /// Those of all sides but planes of symmetry.
    faces: Vec<FarFace<D>>,
    stream: State<D>,
    /// Its speed of sound.
    sound: f64,
    frame: Frame<D>,
    /// True where a plane of symmetry along the stream bounds the flow, with the other half beyond it.
    is_half: bool,
}

/// A face with the stream beyond it, or that the stream leaves by.
#[derive(Clone, Debug)]
struct FarFace<const D: usize> {
    /// Block of its cell.
    block: usize,
    /// Its number there.
    side: usize,
    /// Where its middle is.
    place: Complex<f64>,
    /// Along it, with the bodies on the left.
    way: Complex<f64>,
    holds_stream: bool,
}

impl<const D: usize> Problem<D> {
    /// True of a plane stream slower than sound around bodies that nothing but the stream and outlets bound: what lift does to it is felt
    /// on all sides.
    pub fn feels_lift_far_away(&self) -> bool {
        self.is_slow_around_bodies() && self.domain.sides.iter().flatten().all(is_free)
    }

    /// The same where a plane of symmetry along the stream may bound one half of all that: its axis.
    fn half_far_away(&self) -> Option<usize> {
        let sides = &self.domain.sides;
        let mut mirrors = (0..D).filter(|&axis| sides[axis].contains(&Side::Symmetry));
        let axis = mirrors.next()?;
        let is_one = sides.iter().flatten().filter(|side| !is_free(side)).count() == 1;
        let is_along = self.free_stream.velocity[axis] == 0.0;
        (is_one && is_along && self.is_slow_around_bodies()).then_some(axis)
    }

    fn is_slow_around_bodies(&self) -> bool {
        let stream = &self.free_stream;
        let speed = stream.velocity.norm();
        D == 2
            && !self.bodies.is_empty()
            && self.domain.openings.is_empty()
            && speed > 0.0
            && speed < self.gas.sound_speed_at(stream.density, stream.pressure)
    }
}

impl<const D: usize> FarField<D> {
    /// That of `problem` on `cells`, which stand in `net`; none but of a plane stream slower than sound around bodies, which settles and
    /// which nothing but the stream, outlets and a plane of symmetry along it bound.
    pub fn of(problem: &Problem<D>, cells: &Cells<D>, net: &Net<D>) -> Option<Self> {
        let bodies = problem.bodies.iter().map(|body| body.shape.bounds());
        let bodies = bodies.reduce(|a, b| Bounds::new(a.min.inf(&b.min), a.max.sup(&b.max)))?;
        let stream = problem.free_stream;
        let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
        let speed = stream.velocity.norm();
        let half = problem.half_far_away();
        let is_asked = problem.feels_lift_far_away() || half.is_some();
        if !problem.method.settles() || !is_asked {
            return None;
        }
        let mut centre = (bodies.min + bodies.max) * 0.5;
        if let Some(axis) = half {
            let domain = &problem.domain;
            let end = usize::from(domain.sides[axis][1] == Side::Symmetry);
            centre[axis] = [domain.bounds.min, domain.bounds.max][end][axis];
        }
        let frame = Frame::new(stream.velocity / speed, speed / sound);
        let far = |(block, side, face): (usize, usize, &SideFace<D>)| {
            let beyond = &net.blocks[block].sides[side].beyond;
            FarFace {
                block,
                side,
                place: frame.plane(&(face.centre - centre)),
                way: frame.plane(&left_of(&face.area)),
                holds_stream: matches!(beyond, Beyond::Stream(_) | Beyond::Total(_)),
            }
        };
        let is_mirror = |face: &SideFace<D>| {
            problem.domain.sides[usize::from(face.axis)][usize::from(face.end)] == Side::Symmetry
        };
        let faces = standing(cells).filter(|(.., face)| !is_mirror(face));
        Some(Self {
            faces: faces.map(far).collect(),
            stream,
            sound,
            frame,
            is_half: half.is_some(),
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

    /// These `poles`, or as much of them as changes the speed at no face that holds the stream by more than [`MOST`]: what is told by theory of small changes, of
    /// gas that it changes much, grows from one iteration to the next until nothing is left of the stream.
    fn held(&self, poles: Poles) -> Poles {
        let faces = self.faces.iter().filter(|face| face.holds_stream);
        let changes = faces.map(|face| self.frame.velocity(poles.turn(face.place)).norm());
        let largest = changes.fold(0.0, f64::max) / self.stream.velocity.norm();
        let [along, across] = poles.doublet;
        let sum = poles.circulation + poles.source + along + across;
        if !(sum.is_finite() && largest.is_finite()) {
            Poles::default()
        } else if largest > MOST {
            Poles::default().towards(poles, MOST / largest)
        } else {
            poles
        }
    }

    /// The source and the doublet that gas at the sides tells of, with what it is at each face. In wakes the pressure knows how fast the stream is
    /// beside them, and it changes by `-rho U u`.
    fn told(&self, at: impl Fn(&FarFace<D>) -> Primitive<D>) -> (f64, [f64; 2]) {
        let speed = self.stream.velocity.norm();
        let (mut first, mut second) = (Complex::default(), Complex::default());
        for face in &self.faces {
            let gas = at(face);
            let along = (self.stream.pressure - gas.pressure) / (self.stream.density * speed);
            let part = self.frame.change(along, &gas.velocity.into()) * face.way;
            first += part;
            second += part * face.place;
        }
        // Around one half, and its mirror image the other way.
        let whole = |half: Complex<f64>| {
            let all = if self.is_half {
                half - half.conj()
            } else {
                half
            };
            all / Complex::new(0.0, std::f64::consts::TAU)
        };
        let doublet = whole(second);
        (
            std::f64::consts::TAU * whole(first).re,
            [doublet.re, doublet.im],
        )
    }
}

impl<const D: usize> FixedSimulation<D> {
    /// Turns the stream beyond the sides as the bodies ask that are there now, with the lift that all of them have, `L = rho U Gamma` [Kutta,
    /// Joukowski].
    pub(super) fn turn_far_field(&mut self) {
        let Some(far) = &self.outside.far_field else {
            return;
        };
        let velocity = far.stream.velocity;
        let loads = self.loads();
        let force = |k: usize| -> f64 { loads.iter().map(|load| load.force[k]).sum() };
        let lift = (force(1) * velocity[0] - force(0) * velocity[1]) / velocity.norm();
        let (source, doublet) = far.told(|face| {
            let side = &self.net.blocks[face.block].sides[face.side];
            let i = side.i as usize;
            side.reached(&self.columns.states[i], &self.columns.slopes[i])
        });
        let now = Poles {
            circulation: if far.is_half {
                0.0
            } else {
                lift / (far.stream.density * velocity.norm())
            },
            source,
            doublet,
        };
        let poles = match self.settling.poles {
            None if self.settling.is_near => now,
            before => before.unwrap_or_default().towards(now, RATE),
        };
        let poles = far.held(poles);
        self.settling.poles = Some(poles);
        for face in far.faces.iter().filter(|face| face.holds_stream) {
            let side = &mut self.net.blocks[face.block].sides[face.side];
            let turn = far.frame.velocity(poles.turn(face.place));
            side.beyond = side.beyond.with_stream(far.turned(&turn));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box about the middle, of faces of a tenth, in a stream at Mach 0.6.
    fn far(is_half: bool) -> FarField<2> {
        let stream = State {
            density: 1.4,
            velocity: if is_half {
                Vector::<2>::new(0.6, 0.0)
            } else {
                Vector::<2>::new(0.48, 0.36)
            },
            pressure: 1.0,
        };
        let frame = Frame::new(stream.velocity / 0.6, 0.6);
        let mut faces = Vec::new();
        for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            for k in 0..100 {
                let mut arm = Vector::<2>::zeros();
                let mut area = Vector::<2>::zeros();
                area[axis] = [-0.1, 0.1][end];
                arm[axis] = 50.0 * area[axis];
                arm[1 - axis] = 0.1 * (f64::from(k) + 0.5) - 5.0;
                if is_half && (arm[1] < 0.0) {
                    continue;
                }
                faces.push(FarFace {
                    block: 0,
                    side: 0,
                    place: frame.plane(&arm),
                    way: frame.plane(&left_of(&area)),
                    holds_stream: true,
                });
            }
        }
        FarField {
            faces,
            stream,
            sound: 1.0,
            frame,
            is_half,
        }
    }

    #[test]
    fn bodies_change_no_more_of_the_stream_at_the_sides_than_theory_knows() {
        let far = far(false);
        let poles = |size: f64| Poles {
            circulation: 0.3 * size,
            source: 0.1 * size,
            doublet: [0.2 * size, -0.4 * size],
        };
        assert_eq!(far.held(poles(1.0)), poles(1.0));
        let held = far.held(poles(1e3));
        let part = held.source / 100.0;
        assert!((held.doublet[1] / (-400.0 * part) - 1.0).abs() < 1e-12);
        let largest = |poles: &Poles| {
            let changes = far.faces.iter().map(|face| poles.turn(face.place));
            let speeds = changes.map(|change| far.frame.velocity(change).norm());
            speeds.fold(0.0, f64::max) / 0.6
        };
        assert!((largest(&held) - MOST).abs() < 1e-12);
        assert_eq!(far.held(poles(f64::NAN)), Poles::default());
    }

    #[test]
    fn the_stream_that_is_turned_keeps_its_total_state() {
        let far = far(false);
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

    /// Gas at the sides, as small changes of a stream: those that `poles` make and what comes in from beyond the sides, even, sheared and curved.
    #[test]
    fn what_bodies_do_is_told_from_gas_at_the_sides_and_what_sides_do_is_not() {
        for is_half in [false, true] {
            let far = far(is_half);
            let across = if is_half { 0.0 } else { 1e-6 };
            let poles = Poles {
                circulation: 4.0 * across,
                source: 2e-6,
                doublet: [3e-6, -5.0 * across],
            };
            let incoming = [(1e-6, 3.0), (2e-7, -2.0), (1e-7, 1.0)]
                .map(|(size, turn)| Complex::new(size, turn * size * across * 1e6));
            let (source, doublet) = far.told(|face| {
                let even = incoming[0] + face.place * (incoming[1] + face.place * incoming[2]);
                far.turned(&far.frame.velocity(poles.turn(face.place) + even))
            });
            assert!((source / poles.source - 1.0).abs() < 1e-3, "{source}");
            for (told, is) in doublet.iter().zip(poles.doublet) {
                assert!((told - is).abs() < 1e-8, "{told} {is}");
            }
        }
    }
}
