//! What gas and heat do at a wall.

use aero_geometry::Vector;
use nalgebra::Vector3;

use crate::walls::rigid::pad;

/// Condition on the velocity at a wall, and on the heat where the gas sticks to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WallKind {
    /// The gas slides along the wall, and no heat goes through it.
    Slip,
    /// The gas sticks to the wall.
    NoSlip(NoSlip),
}

/// A wall that gas sticks to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NoSlip {
    /// What heat does there.
    pub heat: WallHeat,
    /// How its surface moves along itself, beside what the wall moves as a whole.
    pub slide: Slide,
}

/// What heat does at a wall that gas sticks to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum WallHeat {
    /// None goes through it.
    #[default]
    Adiabatic,
    /// The wall has this temperature, K.
    Temperature(f64),
    /// So much goes from the wall into the gas, W/m^2.
    Flux(f64),
}

/// Velocity of a surface along itself, `v + w x (x - x_0)`; missing axes are zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slide {
    /// `v`.
    pub velocity: [f64; 3],
    /// `w`, rad/s; along the third axis in the plane.
    pub turning: [f64; 3],
    /// `x_0`.
    pub pivot: [f64; 3],
}

impl WallKind {
    /// A wall at rest that gas sticks to and no heat goes through.
    pub const STICKY: Self = Self::NoSlip(NoSlip {
        heat: WallHeat::Adiabatic,
        slide: Slide {
            velocity: [0.0; 3],
            turning: [0.0; 3],
            pivot: [0.0; 3],
        },
    });

    /// True where its surface moves along itself.
    pub fn slides(&self) -> bool {
        matches!(self, Self::NoSlip(wall) if !wall.slide.is_none())
    }

    /// True where heat goes through it.
    pub fn conducts(&self) -> bool {
        matches!(self, Self::NoSlip(wall) if wall.heat != WallHeat::Adiabatic)
    }

    /// True where gas sticks to it.
    pub const fn sticks(&self) -> bool {
        matches!(self, Self::NoSlip(_))
    }
}

impl Slide {
    /// True of a surface at rest.
    pub fn is_none(&self) -> bool {
        self.velocity == [0.0; 3] && self.turning == [0.0; 3]
    }

    /// Velocity of the surface at a place.
    pub fn at<const D: usize>(&self, place: &Vector<D>) -> Vector<D> {
        let arm = pad(place) - Vector3::from(self.pivot);
        let velocity = Vector3::from(self.velocity) + Vector3::from(self.turning).cross(&arm);
        Vector::from_fn(|k, _| velocity[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_surface_that_turns_moves_counter_clockwise() {
        let slide = Slide {
            velocity: [0.5, 0.0, 0.0],
            turning: [0.0, 0.0, 2.0],
            pivot: [1.0, 1.0, 0.0],
        };
        assert_eq!(
            slide.at(&Vector::<2>::new(1.0, 2.0)),
            Vector::<2>::new(-1.5, 0.0)
        );
        assert!(Slide::default().is_none() && !slide.is_none());
    }
}
