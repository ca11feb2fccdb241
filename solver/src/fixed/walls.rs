//! Faces on walls: what presses on them.

use aero_geometry::Vector;

use super::cells::{Matrix, WallFace};
use super::fan::Departing;
use super::gas::Gas;
use super::image::Image;
use super::state::{Conserved, Primitive, dot};
use super::stick::Stick;
use super::turn::Turn;

/// A wall of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Wall<const D: usize> {
    /// Cell.
    pub i: u32,
    /// The cell's image behind it.
    pub image: Image<D>,
    /// Number of what it belongs to: bodies first, wall sides after.
    pub owner: u32,
    /// Smooth face of the body that it belongs to.
    pub facet: u32,
    /// Shape operator, 1/m.
    pub curvature: Matrix<D>,
    /// Where it is.
    pub foot: Vector<D>,
    /// How gas sticks to it, if it does.
    pub stick: Option<Stick<D>>,
}

impl<const D: usize> Wall<D> {
    /// The wall `face` of the cell at `point`.
    pub fn new(face: &WallFace<D>, point: &Vector<D>, owner: u32) -> Self {
        Self {
            i: face.i,
            image: Image::new(&face.area, point, &face.foot),
            owner,
            facet: face.facet,
            curvature: face.curvature,
            foot: face.foot,
            stick: None,
        }
    }

    /// The state behind it, as the slopes of `cell` see it: the mirror image where gas slides along.
    #[inline]
    pub fn beyond(&self, cell: &Primitive<D>) -> Primitive<D> {
        match &self.stick {
            None => cell.mirrored(&self.image.normal),
            Some(stick) => stick.beyond(cell),
        }
    }

    /// `u.K u` along the wall; of gas that sticks to it and moves as the wall there, the mean up to the cell.
    fn bend(&self, velocity: &[f64; D]) -> f64 {
        let velocity = Vector::from(*velocity);
        let own = velocity.dot(&(self.curvature * velocity));
        match &self.stick {
            None => own,
            Some(stick) => {
                let slide = Vector::from(stick.velocity);
                let bent = self.curvature * slide;
                (own + velocity.dot(&bent) + slide.dot(&bent)) / 3.0
            }
        }
    }

    /// Pressure on the wall: that of the Riemann problem between the cell's state, drawn out to the wall, and its mirror image.
    /// `slopes` and `calmness` are the cell's.
    ///
    /// Along a bent wall the gas presses outwards, `dp/dn = rho u.K u`; from the cell's middle to the wall this makes
    /// `p / (1 + d rho u.K u / p)` of `p`, which stays positive however far the middle is.
    pub fn pressure<G: Gas>(
        &self,
        gas: &G,
        cell: &Primitive<D>,
        slopes: &[Primitive<D>; D],
        calmness: f64,
    ) -> f64 {
        let distance = self.image.distance;
        let inner = self.image.inner(cell, slopes, calmness);
        let along = self.bend(&cell.velocity);
        let turn = Turn::of(&self.image, cell, slopes, along, calmness);
        let sound = gas.sound_square(inner.density, inner.pressure).sqrt();
        let speed = turn.speed(dot(&inner.velocity, &self.image.normal), sound);
        let bend = cell.density * (distance * along + 0.5 * turn.change);
        let pressure = if bend > 0.0 {
            inner.pressure * inner.pressure / (inner.pressure + bend)
        } else {
            inner.pressure - bend
        };
        let pressure = gas.wall_pressure(inner.density, pressure, speed);
        let departing = Departing {
            along: turn.along,
            away: -turn.own,
        };
        let sound = gas.sound_square(cell.density, cell.pressure);
        let fan = turn.share * departing.share(sound);
        if fan > 0.0 {
            pressure + fan * (departing.pressure(gas, cell) - pressure)
        } else {
            pressure
        }
    }
}

/// What a wall at this pressure gives the gas per time: momentum alone.
#[inline]
pub fn push<const D: usize>(image: &Image<D>, pressure: f64) -> Conserved<D> {
    Conserved {
        mass: 0.0,
        momentum: image.normal.map(|n| -pressure * image.size * n),
        energy: 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::super::gas::IdealGas;
    use super::super::sides::{Beyond, Side};
    use super::*;
    use crate::fixed::slopes::Slopes;

    const AIR: IdealGas = IdealGas { gamma: 1.4 };

    /// Below a cell at a tenth above it.
    fn image() -> Image<2> {
        Image {
            normal: [0.0, -1.0],
            size: 0.2,
            share: 0.2,
            distance: 0.1,
        }
    }

    fn cell(velocity: [f64; 2]) -> Primitive<2> {
        Primitive {
            density: 1.2,
            velocity,
            pressure: 0.8,
        }
    }

    /// Gas that parts at a plane, `v = 3 y`, has no speed at the plane, and its pressure is that of the cell.
    #[test]
    fn gas_that_parts_at_a_plane_presses_on_it_with_its_own_pressure() {
        let cell = cell([0.5, 0.3]);
        let mut slopes = Slopes::LEVEL;
        slopes.along[1].velocity[1] = 3.0;
        let wall = Wall {
            i: 0,
            image: image(),
            owner: 0,
            facet: 0,
            curvature: Matrix::zeros(),
            foot: Vector::zeros(),
            stick: None,
        };
        let pressure = wall.pressure(&AIR, &cell, &slopes.along, 1.0);
        assert!((pressure - 0.8).abs() < 1e-15, "{pressure}");
        let side = Side {
            i: 0,
            image: image(),
            beyond: Beyond::Mirror,
        };
        let flux = side.flux(&AIR, &cell, &slopes, None);
        assert!((flux.momentum[1] + 0.8).abs() < 1e-15, "{flux:?}");
        assert_eq!((flux.mass, flux.energy), (0.0, 0.0));
    }

    /// Around a bulge the pressure grows outwards, `dp/dn = rho u^2 kappa`: less on the wall than in the cell; more in a hollow.
    #[test]
    fn gas_that_follows_a_bend_presses_less_on_a_bulge_and_more_on_a_hollow() {
        let cell = cell([2.0, 0.0]);
        for bend in [1e-3, -1e-3] {
            let mut curvature = Matrix::zeros();
            curvature[(0, 0)] = bend;
            let wall = Wall {
                i: 0,
                image: image(),
                owner: 0,
                facet: 0,
                curvature,
                foot: Vector::zeros(),
                stick: None,
            };
            let pressure = wall.pressure(&AIR, &cell, &Slopes::LEVEL.along, 1.0);
            let expected = 0.8 - 0.1 * 1.2 * 4.0 * bend;
            assert!((pressure - expected).abs() < 1e-6, "{pressure} {expected}");
        }
    }

    fn wall() -> Wall<2> {
        Wall {
            i: 0,
            image: image(),
            owner: 0,
            facet: 0,
            curvature: Matrix::zeros(),
            foot: Vector::zeros(),
            stick: None,
        }
    }

    /// What comes to the wall is the same all over a fan: where the gas has yet to turn, its pressure has yet to fall, and the speed is not
    /// drawn out. Where cells resolve it, it is.
    #[test]
    fn gas_that_turns_within_a_cell_meets_its_wall_with_its_own_speed() {
        let cell = cell([0.8, 0.3]);
        let mut slopes = Slopes::LEVEL;
        slopes.along[1].velocity[1] = 3.0;
        slopes.along[0].velocity[1] = -3.75;
        let wall = wall();
        let resolved = wall.pressure(&AIR, &cell, &slopes.along, 1.0);
        assert!((resolved - 0.8).abs() < 1e-15, "{resolved}");
        let coarse = wall.pressure(&AIR, &cell, &slopes.along, 0.8);
        // The acceleration 0.8 x 3.75 over a tenth, half of it on average.
        let at_wall = 0.8 / (1.0 + 0.5 * 0.3 * 1.2 / 0.8);
        let expected = AIR.wall_pressure(1.2, at_wall, -0.3);
        assert!((coarse - expected).abs() < 1e-14, "{coarse} {expected}");
        let careful = wall.pressure(&AIR, &cell, &slopes.along, Slopes::<2>::CAREFUL);
        let expected = AIR.wall_pressure(1.2, 0.8, -0.3);
        assert!((careful - expected).abs() < 1e-14, "{careful} {expected}");
    }

    /// Faster than sound it turns in a steady fan, however much of that the cell holds.
    #[test]
    fn gas_that_is_faster_than_sound_meets_its_wall_at_the_end_of_a_fan() {
        let cell = cell([2.0, 0.3]);
        let mut slopes = Slopes::LEVEL;
        slopes.along[0].velocity[1] = -1.5;
        let coarse = wall().pressure(&AIR, &cell, &slopes.along, 0.8);
        let fan = Departing {
            along: 2.0,
            away: 0.3,
        };
        let expected = fan.pressure(&AIR, &cell);
        assert!((coarse - expected).abs() < 1e-14, "{coarse} {expected}");
        let unsteady = AIR.wall_pressure(1.2, 0.8, -0.3);
        assert!(expected < 0.99 * unsteady, "{expected} {unsteady}");
    }
}
