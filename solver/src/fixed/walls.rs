//! Faces on walls: what presses on them.

use aero_geometry::Vector;

use super::cells::{Matrix, WallFace};
use super::equation_of_state::EquationOfState;
use super::image::Image;
use super::slow::counted;
use super::state::{Conserved, Primitive, dot};
use super::stick::{Heat, Stick};
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
    /// Number of the smooth part of its owner that it lies on.
    pub facet: u32,
    /// Shape operator, 1/m.
    pub curvature: Matrix<D>,
    /// Where it is.
    pub foot: Vector<D>,
    /// How gas sticks to it, if it does.
    pub stick: Option<Stick<D>>,
    /// How what is added to the equations accelerates the gas into it.
    pub push: f64,
    /// Least Mach number that speed into it counts by, see [`super::slow`].
    pub least_mach: f64,
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
            push: 0.0,
            least_mach: 1.0,
        }
    }

    /// The state behind it, as the slopes of `cell` see it: the mirror image where gas slides along, bent as the wall is, and what holds the gas
    /// up against `push`.
    #[inline]
    pub fn beyond<G: EquationOfState>(&self, gas: &G, cell: &Primitive<D>) -> Primitive<D> {
        let mut beyond = match &self.stick {
            None => self.around_bend(gas, cell),
            Some(stick) => stick.beyond(gas, cell),
        };
        if self.push != 0.0 {
            beyond.pressure += 2.0 * self.image.distance * cell.density * self.push;
        }
        beyond
    }

    /// The mirror image of gas that slides along. Along a bent wall it presses outwards, and what has one entropy and one total enthalpy all over is
    /// the faster the nearer it is to the middle of the bend: `dp/dn = -rho u.K u`, `du/dn = K u` out of the gas
    /// [after Dadone & Grossman 1994, AIAA J. 32, 285-293]. Images alike would halve these slopes.
    fn around_bend<G: EquationOfState>(&self, gas: &G, cell: &Primitive<D>) -> Primitive<D> {
        let mut beyond = cell.mirrored(&self.image.normal);
        if self.curvature == Matrix::<D>::zeros() {
            return beyond;
        }
        let normal = Vector::from(self.image.normal);
        let velocity = Vector::from(cell.velocity);
        let slide = velocity - normal * velocity.dot(&normal);
        let rise = self.curvature * slide * (2.0 * self.image.distance);
        let fall = cell.density * slide.dot(&rise);
        let sound_square = gas.sound_square(cell.density, cell.pressure);
        beyond.pressure = lowered(cell.pressure, fall);
        beyond.density = lowered(cell.density, fall / sound_square);
        for (velocity, rise) in beyond.velocity.iter_mut().zip(rise.iter()) {
            *velocity += rise;
        }
        beyond
    }

    /// `p / rho` behind it, as the slopes of viscous gas see it: a line through what it is on the wall.
    #[inline]
    pub fn heat_beyond<G: EquationOfState>(&self, gas: &G, cell: &Primitive<D>) -> f64 {
        match self.stick.map(|stick| stick.heat) {
            Some(Heat::Temperature(temperature)) => {
                2.0 * gas.heat_at(temperature, cell.pressure) - cell.heat()
            }
            Some(Heat::Flux(_)) | None => cell.heat(),
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
    /// `p / (1 + d rho u.K u / p)` of `p`, which stays positive however far the middle is. `push` is held up the same way.
    ///
    /// What gas slower than sound still has of speed into the wall counts by its Mach number, see [`super::slow`].
    pub fn pressure<G: EquationOfState>(
        &self,
        gas: &G,
        cell: &Primitive<D>,
        slopes: &[Primitive<D>; D],
        calmness: f64,
    ) -> f64 {
        let distance = self.image.distance;
        let inner = self.image.inner(cell, slopes, calmness);
        let along = self.bend(&cell.velocity);
        let sound = gas.sound_square(inner.density, inner.pressure).sqrt();
        let turn = Turn::of(&self.image, cell, slopes, along, calmness).held(sound);
        let speed = turn.speed(dot(&inner.velocity, &self.image.normal), sound);
        let bend = cell.density * (distance * (along - self.push) + 0.5 * turn.change);
        let pressure = lowered(inner.pressure, bend);
        let mach = dot(&cell.velocity, &cell.velocity).sqrt() / sound;
        let share = counted(mach, self.least_mach);
        gas.wall_pressure(inner.density, pressure, share * speed)
    }
}

/// What is left of a `value` above zero that falls by `fall`: above zero too, however far it falls.
fn lowered(value: f64, fall: f64) -> f64 {
    if fall > 0.0 {
        value * value / (value + fall)
    } else {
        value - fall
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
    use super::super::beyond::Beyond;
    use super::super::sides::Side;
    use super::*;
    use crate::fixed::slopes::Slopes;
    use crate::gas::IdealGas;

    const AIR: IdealGas = IdealGas::new(1.4);

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

    fn wall(curvature: Matrix<2>) -> Wall<2> {
        Wall {
            i: 0,
            image: image(),
            owner: 0,
            facet: 0,
            curvature,
            foot: Vector::zeros(),
            stick: None,
            push: 0.0,
            least_mach: 1.0,
        }
    }

    /// Gas that parts at a plane, `v = 3 y`, has no speed at the plane, and its pressure is that of the cell.
    #[test]
    fn gas_that_parts_at_a_plane_presses_on_it_with_its_own_pressure() {
        let cell = cell([0.5, 0.3]);
        let mut slopes = Slopes::LEVEL;
        slopes.along[1].velocity[1] = 3.0;
        let wall = wall(Matrix::zeros());
        let pressure = wall.pressure(&AIR, &cell, &slopes.along, 1.0);
        assert!((pressure - 0.8).abs() < 1e-15, "{pressure}");
        let side = Side {
            i: 0,
            image: image(),
            aside: [0.0; 2],
            beyond: Beyond::Mirror,
        };
        let flux = side.flux(&AIR, &cell, &slopes, None);
        assert!((flux.momentum[1] + 0.8).abs() < 1e-15, "{flux:?}");
        assert_eq!((flux.mass, flux.energy), (0.0, 0.0));
    }

    /// What a sound presses with, `rho a u_n`, counts by the Mach number where there is none: `rho |u| u_n`. Faster than sound, and where
    /// sound may come, as it is.
    #[test]
    fn gas_slower_than_sound_that_is_not_turned_yet_presses_by_its_mach_number_in_a_steady_flow() {
        let steady = Wall {
            least_mach: 0.1,
            ..wall(Matrix::zeros())
        };
        let pressed = |wall: &Wall<2>, velocity| {
            wall.pressure(&AIR, &cell(velocity), &Slopes::LEVEL.along, 0.5)
        };
        let (small, sound) = (1e-5, (1.4_f64 * 0.8 / 1.2).sqrt());
        for (wall, along, counts) in [
            (steady, 0.3, 0.3),
            (steady, 0.0, 0.1 * sound),
            (wall(Matrix::zeros()), 0.3, sound),
        ] {
            let rise = pressed(&wall, [along, -small]) - 0.8;
            assert!((rise / (1.2 * counts * small) - 1.0).abs() < 1e-3, "{rise}");
        }
        let fast = [2.0, -0.1];
        assert_eq!(
            pressed(&steady, fast),
            pressed(&wall(Matrix::zeros()), fast)
        );
    }

    /// Gas that goes around the axis at `u = 2 / r` with one entropy and one total enthalpy has the state behind its wall at radius one that it would
    /// have there, up to what is of second order; in a hollow as around a bulge, and across the bend it goes on straight.
    #[test]
    fn the_image_behind_a_bend_is_that_of_gas_that_goes_around_it() {
        let vortex = |radius: f64| {
            let heat: f64 = 1.0 + 0.8 * (1.0 - 1.0 / (radius * radius));
            Primitive::<2> {
                density: heat.powf(2.5),
                velocity: [2.0 / radius, 0.0],
                pressure: heat.powf(3.5) / 1.4,
            }
        };
        for out in [1.0, -1.0] {
            let off = |distance: f64| {
                let mut curvature = Matrix::zeros();
                curvature[(0, 0)] = out;
                let mut wall = wall(curvature);
                wall.image.normal = [0.0, -out];
                wall.image.distance = distance;
                let found = wall.beyond(&AIR, &vortex(1.0 + out * distance));
                found.plus(-1.0, &vortex(1.0 - out * distance))
            };
            let [coarse, fine] = [0.02, 0.01].map(off);
            for of in [
                |off: &Primitive<2>| off.density,
                |off: &Primitive<2>| off.pressure,
                |off: &Primitive<2>| off.velocity[0],
            ] {
                let (coarse, fine) = (of(&coarse), of(&fine));
                assert!(coarse.abs() < 0.03, "{coarse}");
                assert!(fine.abs() < 0.3 * coarse.abs(), "{coarse} {fine}");
            }
            let mut across = vortex(1.0);
            across.velocity = [0.0, 0.5];
            let mut curvature = Matrix::zeros();
            curvature[(0, 0)] = out;
            let beyond = wall(curvature).beyond(&AIR, &across);
            assert_eq!(beyond.velocity, [0.0, -0.5]);
            assert_eq!(beyond.pressure, across.pressure);
        }
    }

    /// Around a bulge the pressure grows outwards, `dp/dn = rho u^2 kappa`: less on the wall than in the cell; more in a hollow.
    #[test]
    fn gas_that_follows_a_bend_presses_less_on_a_bulge_and_more_on_a_hollow() {
        let cell = cell([2.0, 0.0]);
        for bend in [1e-3, -1e-3] {
            let mut curvature = Matrix::zeros();
            curvature[(0, 0)] = bend;
            let wall = wall(curvature);
            let pressure = wall.pressure(&AIR, &cell, &Slopes::LEVEL.along, 1.0);
            let expected = 0.8 - 0.1 * 1.2 * 4.0 * bend;
            assert!((pressure - expected).abs() < 1e-6, "{pressure} {expected}");
        }
    }

    /// The neighbour on a ramp makes slopes, but the gas ahead of the shock knows nothing of it; gas that comes towards the wall does.
    #[test]
    fn gas_ahead_of_a_ramp_presses_with_its_own_pressure() {
        let mut slopes = Slopes::LEVEL;
        slopes.along[0].velocity[1] = 1.5;
        let wall = wall(Matrix::zeros());
        for speed in [0.0, 0.1] {
            let pressure = wall.pressure(&AIR, &cell([2.0, speed]), &slopes.along, 0.5);
            let expected = AIR.wall_pressure(1.2, 0.8, -speed);
            assert!((pressure - expected).abs() < 1e-14, "{pressure}");
        }
        // The acceleration 2 x 1.5 over a tenth is more than twice the speed of sound times 0.1; half of it on average.
        let most = 2.0 * (1.4_f64 * 0.8 / 1.2).sqrt() * 0.1;
        assert!(most < 0.3);
        let pressure = wall.pressure(&AIR, &cell([2.0, -0.1]), &slopes.along, 0.5);
        let expected = AIR.wall_pressure(1.2, 0.8 + 0.5 * 1.2 * most, 0.1);
        assert!((pressure - expected).abs() < 1e-14, "{pressure} {expected}");
    }

    /// What comes to the wall is the same all over a fan: where the gas has yet to turn, its pressure has yet to fall, and the speed is not
    /// drawn out. Where cells resolve it, it is.
    #[test]
    fn gas_that_turns_within_a_cell_meets_its_wall_with_its_own_speed() {
        let cell = cell([2.0, 0.3]);
        let mut slopes = Slopes::LEVEL;
        slopes.along[1].velocity[1] = 3.0;
        slopes.along[0].velocity[1] = -1.5;
        let wall = wall(Matrix::zeros());
        let resolved = wall.pressure(&AIR, &cell, &slopes.along, 1.0);
        assert!((resolved - 0.8).abs() < 1e-15, "{resolved}");
        let coarse = wall.pressure(&AIR, &cell, &slopes.along, 0.8);
        // The acceleration 2 x 1.5 over a tenth, half of it on average.
        let at_wall = 0.8 / (1.0 + 0.5 * 0.3 * 1.2 / 0.8);
        let expected = AIR.wall_pressure(1.2, at_wall, -0.3);
        assert!((coarse - expected).abs() < 1e-14, "{coarse} {expected}");
        let careful = wall.pressure(&AIR, &cell, &slopes.along, Slopes::<2>::CAREFUL);
        let expected = AIR.wall_pressure(1.2, 0.8, -0.3);
        assert!((careful - expected).abs() < 1e-14, "{careful} {expected}");
    }
}
