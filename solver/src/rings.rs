//! Flow that is the same all around an axis: particles of the meridian plane `(x, r)` stand for rings.
//!
//! The Euler equations in `(x, r)` differ from the plane ones by the hoop terms alone: the rings of a gas
//! that moves outwards grow, which adds `v / r` to the divergence of its velocity [Omang, Borve &
//! Trulsen 2006, sections 2-3]. The plane pair sums therefore serve as they are, on particles whose plane mass is
//! what their ring has per length, `m / (2 pi r)`; beyond the axis lie their mirror images, as even in `r` as
//! density and pressure are. Mass is kept by the rings to the last bit.

use std::f64::consts::TAU;

use aero_geometry::Vector;

use super::particles::{Particle, Rates};
use crate::gas::Gases;
use crate::problem::Problem;

/// A ring never counts as narrower than this many spacings, the radius of the innermost ring of the lattice: nearer
/// the axis it would swell without bound and pair with its own image.
const NARROWEST: f64 = 0.5;

/// Axis in the meridian plane along which `r` is measured, and the one about which it is.
const RADIAL: usize = 1;
const AXIAL: usize = 0;

/// How far around the axis a particle reaches; by default there is none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rings {
    /// Smallest radius that counts; none in a plane flow or in space.
    narrowest: Option<f64>,
}

impl Rings {
    /// Those of `problem`: real ones where a side of its domain is the axis.
    pub fn new<const D: usize>(problem: &Problem<D>) -> Self {
        let axisymmetric = problem.domain.is_axisymmetric();
        Self {
            narrowest: axisymmetric.then_some(NARROWEST * problem.resolution.finest()),
        }
    }

    /// Length around the axis at `position`, `2 pi r`; one without an axis.
    pub fn circumference<const D: usize>(&self, position: &Vector<D>) -> f64 {
        match self.narrowest {
            Some(narrowest) => TAU * position[RADIAL].max(narrowest),
            None => 1.0,
        }
    }

    /// The same of a surface, which has no gas to keep off the axis: however near that it is.
    pub fn surface<const D: usize>(&self, position: &Vector<D>) -> f64 {
        match self.narrowest {
            Some(_) => TAU * position[RADIAL].max(0.0),
            None => 1.0,
        }
    }

    /// Of a force per area at one place that something `towards` another makes, `pull`, what counts at the first place. Pair sums press
    /// each ghost all around its own circumference, not its gas's: where a wall widens downstream those downstream weigh more.
    pub fn pulled<const D: usize>(
        &self,
        at: &Vector<D>,
        towards: &Vector<D>,
        mut pull: Vector<D>,
    ) -> Vector<D> {
        if let Some(narrowest) = self.narrowest {
            let wider = (towards[RADIAL] - at[RADIAL]) / at[RADIAL].max(narrowest);
            pull[AXIAL] *= 1.0 - 0.5 * wider;
        }
        pull
    }

    /// True in an axisymmetric flow.
    pub fn are_real(&self) -> bool {
        self.narrowest.is_some()
    }

    /// `vector` without what cancels around the axis.
    pub fn axial<const D: usize>(&self, mut vector: Vector<D>) -> Vector<D> {
        if self.are_real() {
            vector[RADIAL] = 0.0;
        }
        vector
    }

    /// Mass per length around the axis: what the plane pair sums weigh with.
    pub fn plane_mass<const D: usize>(&self, particle: &Particle<D>) -> f64 {
        particle.mass / self.circumference(&particle.position)
    }

    /// Plane mass that the smoothing length goes by. A ring that has grown to many times its first radius, as
    /// those next to a body's wall have, is squeezed into a thin sheet; its neighbours along the sheet
    /// are as far as ever, and the kernel has to reach them.
    pub fn spanned_mass<const D: usize>(&self, particle: &Particle<D>) -> f64 {
        self.plane_mass(particle).max(particle.first_plane_mass)
    }

    /// Rate at which the ring of `particle` grows, `v / r`; zero without an axis.
    pub fn growth<const D: usize>(&self, particle: &Particle<D>) -> f64 {
        match self.narrowest {
            Some(narrowest) => particle.velocity[RADIAL] / particle.position[RADIAL].max(narrowest),
            None => 0.0,
        }
    }

    /// Adds the growth of the rings, `v / r`, to the divergence that the rates of density and energy come from.
    pub fn stretch<const D: usize>(
        &self,
        particles: &[Particle<D>],
        gases: &Gases,
        rates: &mut [Rates<D>],
    ) {
        if !self.are_real() {
            return;
        }
        for (particle, rates) in particles.iter().zip(rates) {
            let growth = self.growth(particle);
            rates.density -= particle.density * growth;
            let gas = gases.of(particle.is_second);
            let heating = gas.pressure_over_density(particle.density, particle.energy) * growth;
            rates.energy -= heating;
            rates.by_pressure.heating -= heating;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gas_near_the_axis_counts_as_far_as_the_innermost_ring_and_a_surface_as_it_is() {
        let rings = Rings {
            narrowest: Some(0.5),
        };
        let places = [[3.0, 0.1], [3.0, 2.0]].map(Vector::<2>::from);
        assert_eq!(
            places.map(|at| rings.circumference(&at)),
            [0.5, 2.0].map(|r| TAU * r)
        );
        assert_eq!(
            places.map(|at| rings.surface(&at)),
            [0.1, 2.0].map(|r| TAU * r)
        );
        assert_eq!(Rings { narrowest: None }.surface(&places[0]), 1.0);
    }
}
