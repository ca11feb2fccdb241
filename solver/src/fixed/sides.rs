//! Faces on the sides of the domain: what is beyond them, and what flows through.

use super::calmness::smoothness;
use super::cells::{RADIAL, SideFace};
use super::departing::{aside, braked};
use super::gas::Gas;
use super::hll::Jump;
use super::image::Image;
use super::reconstruction::rise;
use super::slopes::Slopes;
use super::state::{Conserved, Primitive, dot};
use crate::method::Time;
use crate::problem::{Problem, Side as SideKind, State};
use crate::sides::{Along, Answering, Place};
use aero_geometry::Vector;

/// What is beyond a side.
#[derive(Clone, Copy, Debug)]
pub enum Beyond<const D: usize> {
    /// Gas in this state: inlets and free streams.
    Stream(Primitive<D>),
    /// More of the same gas.
    Same,
    /// More of the same gas, as long as it leaves. Gas that came back would bring what the flow itself holds, and more of it the more
    /// it holds: a flow that settles could blow itself up.
    OneWay,
    /// The mirror image.
    Mirror,
    /// Gas that answers to the cell.
    Answers(Answering),
}

impl<const D: usize> Beyond<D> {
    /// What is beyond the `side` of `problem`, or the part of one, at `place`.
    ///
    /// # Errors
    /// Of a side that has no open faces.
    pub fn of(problem: &Problem<D>, side: SideKind, place: Place) -> Result<Self, String> {
        let stream = Primitive::of(&problem.free_stream);
        let Place { axis, end, .. } = place;
        match side {
            // The Riemann problem with the free stream lets sound out.
            SideKind::Inlet | SideKind::SoftInlet | SideKind::FreeStream => {
                Ok(Self::Stream(stream))
            }
            SideKind::Outlet => Ok(match problem.method.fixed().map(|points| points.time) {
                Some(Time::Settle) => Self::OneWay,
                _ => Self::Same,
            }),
            SideKind::Symmetry | SideKind::Axis => Ok(Self::Mirror),
            side => Answering::of(problem, side, place)
                .map(Self::Answers)
                .ok_or_else(|| {
                    format!("side {end} of axis {axis} is {side:?} and should have no open faces")
                }),
        }
    }

    /// The same beside gas whose state, of an outlet the pressure, is now this.
    #[must_use]
    pub fn at(self, given: &State<D>) -> Self {
        match self {
            Self::Stream(_) => Self::Stream(Primitive::of(given)),
            Self::Answers(answering) => Self::Answers(answering.at(given)),
            Self::Same | Self::OneWay | Self::Mirror => self,
        }
    }

    /// True where the state beyond counts in the gradients.
    pub fn is_known(&self) -> bool {
        matches!(self, Self::Stream(_) | Self::Mirror)
    }
}

/// A face on a side.
#[derive(Clone, Copy, Debug)]
pub struct Side<const D: usize> {
    /// Cell.
    pub i: u32,
    /// The cell's image beyond it.
    pub image: Image<D>,
    /// One over the distance from the axis that the gas goes around; zero where there is none.
    pub bend: f64,
    /// What is there.
    pub beyond: Beyond<D>,
}

impl<const D: usize> Side<D> {
    /// The side `face` of the cell at `point`.
    pub fn new(face: &SideFace<D>, point: &Vector<D>, beyond: Beyond<D>) -> Self {
        Self {
            i: face.i,
            image: Image::new(&face.area, point, &face.centre),
            bend: 0.0,
            beyond,
        }
    }

    /// The same of a ring at this `radius` about an axis.
    #[must_use]
    pub fn at_radius(self, radius: f64) -> Self {
        Self {
            image: self.image.at_radius(radius),
            bend: if radius > 0.0 { 1.0 / radius } else { 0.0 },
            ..self
        }
    }

    /// State at the image of `cell`, where it counts in the gradients.
    #[inline]
    pub fn known(&self, cell: &Primitive<D>) -> Option<Primitive<D>> {
        match self.beyond {
            Beyond::Stream(state) => Some(state),
            Beyond::Mirror => Some(cell.mirrored(&self.image.normal)),
            Beyond::Same | Beyond::OneWay | Beyond::Answers(_) => None,
        }
    }

    /// Flux through a unit area, out of the domain; `slopes` are the cell's, `rubbed` is what viscosity and heat conduction give it per volume.
    pub fn flux<G: Gas>(
        &self,
        gas: &G,
        cell: &Primitive<D>,
        slopes: &Slopes<D>,
        rubbed: Option<&Conserved<D>>,
    ) -> Conserved<D> {
        let normal = self.image.normal;
        let cell = &match (&self.beyond, rubbed) {
            (Beyond::Same | Beyond::OneWay, Some(_)) => self.drawn_out(cell, slopes),
            _ => *cell,
        };
        let other = match &self.beyond {
            Beyond::Stream(state) => *state,
            Beyond::Same => *cell,
            Beyond::OneWay => {
                let speed = dot(&cell.velocity, &normal);
                if speed < 0.0 {
                    return pushed(
                        gas.wall_pressure(cell.density, cell.pressure, speed),
                        &normal,
                    );
                }
                *cell
            }
            Beyond::Mirror => {
                // The mean of a cell moves away from the plane that gas parts at; at the plane itself it does not.
                let inner = self.image.inner(cell, &slopes.along, slopes.calmness);
                let speed = dot(&inner.velocity, &normal);
                let pressure = gas.wall_pressure(inner.density, inner.pressure, speed);
                return pushed(pressure, &normal);
            }
            Beyond::Answers(answering) => {
                let inside = along(cell, &normal);
                let growth = cell.velocity[RADIAL.min(D - 1)] * self.bend;
                let mut aside = aside(gas, cell, slopes, &normal, growth);
                if let Some(rubbed) = rubbed {
                    aside += braked(gas, cell, rubbed, &normal);
                }
                let outside = answering.beyond(&inside, self.image.distance, aside);
                let mut velocity = normal.map(|n| outside.speed * n);
                if !answering.is_straight() {
                    velocity = cell.velocity;
                    for (u, n) in velocity.iter_mut().zip(&normal) {
                        *u += (outside.speed - inside.speed) * n;
                    }
                }
                Primitive {
                    density: outside.density,
                    velocity,
                    pressure: outside.pressure,
                }
            }
        };
        Jump::new(gas, *cell, other, normal).hllc()
    }

    /// The state of `cell` at the side itself, where gas leaves as it is; the cell's own where that is none, or in shocks. A layer along a wall
    /// changes all the way up to the side: were it to leave as it is half a cell before, that half would be missing in all that balances there.
    fn drawn_out(&self, cell: &Primitive<D>, slopes: &Slopes<D>) -> Primitive<D> {
        let share = smoothness(slopes.calmness);
        let way = self.image.normal.map(|n| share * self.image.distance * n);
        let drawn = cell.plus(1.0, &rise(&slopes.along, &way));
        let leaves = dot(&drawn.velocity, &self.image.normal) > 0.0;
        if drawn.makes_sense() && leaves {
            drawn
        } else {
            *cell
        }
    }
}

/// Flux through a face that nothing passes.
fn pushed<const D: usize>(pressure: f64, normal: &[f64; D]) -> Conserved<D> {
    Conserved {
        mass: 0.0,
        momentum: normal.map(|n| pressure * n),
        energy: 0.0,
    }
}

/// What of `state` moves along `normal`.
fn along<const D: usize>(state: &Primitive<D>, normal: &[f64; D]) -> Along {
    Along {
        density: state.density,
        speed: dot(&state.velocity, normal),
        pressure: state.pressure,
    }
}

#[cfg(test)]
mod tests {
    use super::super::gas::IdealGas;
    use super::super::tests::lattice::problem;
    use super::*;

    const GAS: IdealGas = IdealGas { gamma: 1.4 };

    /// On the right of a cell about the origin.
    fn side(beyond: Beyond<2>) -> Side<2> {
        let face = SideFace {
            i: 0,
            axis: 0,
            end: 1,
            area: [0.5, 0.0].into(),
            centre: [0.1, 0.0].into(),
        };
        Side::new(&face, &Vector::zeros(), beyond)
    }

    fn outlet(beyond: Beyond<2>, speed: f64) -> Conserved<2> {
        let side = side(beyond);
        let cell = Primitive {
            density: 1.3,
            velocity: [speed, 0.4],
            pressure: 0.8,
        };
        side.flux(&GAS, &cell, &Slopes::LEVEL, None)
    }

    #[test]
    fn gas_leaves_through_a_one_way_outlet_as_through_any_and_does_not_come_back() {
        for speed in [0.3, 2.5] {
            assert_eq!(outlet(Beyond::OneWay, speed), outlet(Beyond::Same, speed));
        }
        let back = outlet(Beyond::OneWay, -0.3);
        assert_eq!((back.mass, back.momentum[1], back.energy), (0.0, 0.0, 0.0));
        assert!(back.momentum[0] > 0.0 && back.momentum[0] < 0.8);
        assert!(outlet(Beyond::Same, -0.3).mass < 0.0);
    }

    /// `v / r` of a ring parts the gas as much as a rise of the velocity across a plane stream.
    #[test]
    fn rings_that_grow_answer_as_gas_that_widens() {
        let held = SideKind::HeldOutlet {
            pressure: 0.7,
            relaxation: 0.25,
        };
        let problem = problem([10, 10], 0.1, [[SideKind::Symmetry, held]; 2]);
        let beyond = Beyond::of(&problem, held, Place::whole(&problem.domain, 0, 1)).unwrap();
        let side = side(beyond);
        let cell = Primitive {
            density: 1.3,
            velocity: [0.4, 0.2],
            pressure: 0.8,
        };
        let mut widening = Slopes::LEVEL;
        widening.along[1].velocity[1] = 0.2 / 0.5;
        let plane = side.flux(&GAS, &cell, &widening, None);
        let level = side.flux(&GAS, &cell, &Slopes::LEVEL, None);
        let rings = side.at_radius(0.5);
        assert_eq!(rings.flux(&GAS, &cell, &Slopes::LEVEL, None), plane);
        assert!(plane.mass < level.mass - 1e-3);
    }

    /// `dR/dx = -(F - q / (rho c)) / (u - c)` of a wave at rest: gas that friction brakes leaves slower, and heat draws it out.
    #[test]
    fn what_friction_and_heat_do_to_the_wave_is_taken_off_it() {
        let cell = Primitive {
            density: 1.4,
            velocity: [0.5, 0.2],
            pressure: 1.0,
        };
        let rubbed = |momentum: [f64; 2], heat: f64| Conserved {
            mass: 0.0,
            momentum,
            energy: heat + dot(&cell.velocity, &momentum),
        };
        let normal = [1.0, 0.0];
        let taken = |momentum, heat| braked(&GAS, &cell, &rubbed(momentum, heat), &normal);
        assert!((taken([-0.7, 0.3], 0.0) - 0.5).abs() < 1e-14);
        assert!((taken([0.0, 0.0], 0.7) - 0.4 * 0.7 / 1.4).abs() < 1e-14);
    }

    /// Gas that slows down on its way out leaves as it is at the side, not as it is half a cell before.
    #[test]
    fn gas_that_rubs_leaves_an_outlet_as_it_is_there() {
        let cell = Primitive {
            density: 1.3,
            velocity: [2.5, 0.4],
            pressure: 0.8,
        };
        let mut slopes = Slopes::<2>::LEVEL;
        slopes.along[0].velocity = [-2.0, 0.0];
        for beyond in [Beyond::Same, Beyond::OneWay] {
            let side = side(beyond);
            let mass = |rubbed| side.flux(&GAS, &cell, &slopes, rubbed).mass;
            assert_eq!(mass(None), 1.3 * 2.5);
            assert!((mass(Some(&Conserved::ZERO)) - 1.3 * 2.3).abs() < 1e-14);
        }
    }

    /// At Mach 0.5 the wave that comes in rises by `sigma (1 - M^2) (p - p_held) / (rho L) t` on its way, `t = d / (c - u)` across half
    /// a cell, `d` wide [Poinsot & Lele 1992, eq. 40]; half of it is speed, and as much of pressure, over `rho c`, is lost.
    #[test]
    fn gas_leaves_faster_by_as_much_as_its_pressure_is_above_the_one_held() {
        let above = 1e-3 / 1.4;
        let outlet = SideKind::HeldOutlet {
            pressure: 1.0 / 1.4 - above,
            relaxation: 0.25,
        };
        let problem = problem([10], 0.1, [[SideKind::Symmetry, outlet]]);
        let side = Side {
            i: 0,
            image: Image {
                normal: [1.0],
                size: 1.0,
                share: 1.0,
                distance: 0.05,
            },
            bend: 0.0,
            beyond: Beyond::of(&problem, outlet, Place::whole(&problem.domain, 0, 1)).unwrap(),
        };
        let cell = Primitive {
            density: 1.0,
            velocity: [0.5],
            pressure: 1.0 / 1.4,
        };
        let flux = side.flux(&GAS, &cell, &Slopes::LEVEL, None);
        let change = 0.25 * (1.0 - 0.25) * above * 0.05 / 0.5;
        // With du = change / 2 and dp = drho = -du: drho u + du, and dp + 2 u du + u^2 drho.
        let more = (flux.mass - 0.5) / (0.25 * change);
        assert!((more - 1.0).abs() < 1e-3, "{more}");
        let less = (flux.momentum[0] - 1.0 / 1.4 - 0.25) / (-0.125 * change);
        assert!((less - 1.0).abs() < 1e-3, "{less}");
    }
}
