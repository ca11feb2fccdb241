//! What viscosity and heat conduction take through walls and sides.

use super::super::beyond::Beyond;
use super::super::image::Image;
use super::super::net::Net;
use super::super::sides::Side;
use super::super::state::{Conserved, Primitive, dot};
use super::super::stick::{Heat, Stick};
use super::super::walls::Wall;
use super::{Gradient, Rubbing, around, radius, width};

/// Least distance of a cell from its wall, in widths of the cell: at an edge its point may lie beyond the plane of a wall that it holds a part of.
const LEAST_DISTANCE: f64 = 0.1;

/// What a wall does to the gas per area, beside its pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallShare<const D: usize> {
    /// Force on the gas.
    pub stress: [f64; D],
    /// Heat into the gas.
    pub heat: f64,
    /// Work on the gas.
    work: f64,
    /// Temperature of the gas at the wall.
    pub temperature: f64,
}

impl<const D: usize> WallShare<D> {
    /// Nothing.
    pub const NONE: Self = Self {
        stress: [0.0; D],
        heat: 0.0,
        work: 0.0,
        temperature: 0.0,
    };

    /// What the gas gains per time.
    pub fn gain(&self, wall: &Wall<D>) -> Conserved<D> {
        let size = wall.image.size;
        Conserved {
            mass: 0.0,
            momentum: self.stress.map(|stress| stress * size),
            energy: (self.heat + self.work) * size,
        }
    }
}

/// Distance of a cell of this width from its image's plane.
pub fn distance<const D: usize>(image: &Image<D>, width: f64) -> f64 {
    image.distance.max(LEAST_DISTANCE * width)
}

impl<const D: usize> Rubbing<'_, D> {
    /// What a wall does to its cell.
    pub(super) fn of_wall(
        &self,
        net: &Net<D>,
        wall: &Wall<D>,
        cell: &Primitive<D>,
        gradient: &Gradient<D>,
    ) -> WallShare<D> {
        let i = wall.i as usize;
        let distance = distance(&wall.image, width(net, i));
        match &wall.stick {
            Some(stick) => self.stuck(stick, &wall.image, cell, distance),
            None => WallShare {
                stress: self.drawn(i, &wall.image, cell, gradient, distance),
                temperature: self
                    .viscous
                    .temperature(self.viscous.measure(cell), cell.pressure),
                ..WallShare::NONE
            },
        }
    }

    /// The stress of gas that sticks, of a profile that is linear up to the wall beside what moves as the wall does, and the heat: of the enthalpy that the gas would have at
    /// the wall if none went through, `h + Pr u^2 / 2`.
    fn stuck(
        &self,
        stick: &Stick<D>,
        image: &Image<D>,
        cell: &Primitive<D>,
        distance: f64,
    ) -> WallShare<D> {
        let mut slide = stick.beside;
        for k in 0..D {
            slide[k] -= cell.velocity[k];
        }
        let across = dot(&slide, &image.normal);
        for k in 0..D {
            slide[k] -= across * image.normal[k];
        }
        let level = self.viscous.measure(cell);
        let recovered = level + self.viscous.recovered(dot(&slide, &slide));
        let at_wall = match stick.heat {
            Heat::Temperature(temperature) => self.viscous.measure_at(temperature, cell.pressure),
            Heat::Flux(_) => recovered,
        };
        let viscosity = self
            .viscous
            .viscosity_at(0.5 * (level + at_wall), cell.pressure);
        let conductivity = self.viscous.conductivity(viscosity);
        let stress = slide.map(|slide| viscosity * slide / distance);
        let (heat, at_wall) = match stick.heat {
            Heat::Temperature(_) => (conductivity * (at_wall - recovered) / distance, at_wall),
            Heat::Flux(heat) => (heat, recovered + heat * distance / conductivity),
        };
        WallShare {
            stress,
            heat,
            work: dot(&stick.velocity, &stress),
            temperature: self.viscous.temperature(at_wall, cell.pressure),
        }
    }

    /// The stress across a plane that gas slides along: that of gas which is drawn out or pressed together there.
    fn drawn(
        &self,
        i: usize,
        image: &Image<D>,
        cell: &Primitive<D>,
        gradient: &Gradient<D>,
        distance: f64,
    ) -> [f64; D] {
        let normal = &image.normal;
        let slope = -dot(&cell.velocity, normal) / distance;
        let mut own = 0.0;
        for axis in 0..D {
            own += normal[axis] * dot(&gradient.velocity[axis], normal);
        }
        let mut divergence = gradient.divergence() - own + slope;
        if self.is_axisymmetric {
            divergence += around(&cell.velocity, radius(&self.points[i]));
        }
        let stress = self.viscosities[i] * (2.0 * slope - 2.0 / 3.0 * divergence);
        normal.map(|n| n * stress)
    }

    /// What a cell gains through a side: nothing changes across one that gas leaves by; where the gas beyond is known, all that the cell's
    /// slopes say.
    pub(super) fn of_side(
        &self,
        net: &Net<D>,
        side: &Side<D>,
        cell: &Primitive<D>,
        gradient: &Gradient<D>,
    ) -> Conserved<D> {
        let i = side.i as usize;
        let image = &side.image;
        let area = image.normal.map(|n| n * image.size);
        if let Beyond::Mirror = side.beyond {
            let distance = distance(image, width(net, i));
            let stress = self.drawn(i, image, cell, gradient, distance);
            return Conserved {
                mass: 0.0,
                momentum: stress.map(|stress| stress * image.size),
                energy: 0.0,
            };
        }
        let gradient = match side.beyond {
            Beyond::Stream(_) | Beyond::Total(_) => *gradient,
            _ => gradient.along(&image.normal, &[0.0; D], 0.0),
        };
        let mut divergence = gradient.divergence();
        if self.is_axisymmetric {
            divergence += around(&cell.velocity, radius(&self.points[i]));
        }
        let viscosity = self.viscosities[i];
        let stress = gradient.stress(viscosity, divergence, &area);
        let conducted = self.viscous.conductivity(viscosity) * dot(&gradient.heat, &area);
        Conserved {
            mass: 0.0,
            momentum: stress,
            energy: dot(&cell.velocity, &stress) + conducted,
        }
    }
}
