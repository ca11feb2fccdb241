//! Sides that map the flow onto itself: a symmetry plane and an axis mirror it, a periodic side shifts it. What lies beyond
//! such a side is a copy of gas within ([`crate::neighbourhood::Images`]), and gas that crosses comes back as its own copy.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Vector};

use crate::particles::Particle;
use crate::problem::{Domain, Side};

/// `x' = sign x + shift` along one axis: from the gas within to its copy beyond a side, and from gas beyond the side to where
/// it belongs.
#[derive(Clone, Copy, Debug)]
pub struct Map {
    /// -1 where it mirrors, 1 where it shifts.
    pub sign: f64,
    /// Shift.
    pub shift: f64,
}

impl Map {
    /// What the lower and the upper side of an axis do; none for sides that map nothing.
    pub fn of_axis<const D: usize>(domain: &Domain<D>, axis: usize) -> [Option<Self>; 2] {
        let [low, high] = [domain.face(axis, 0), domain.face(axis, 1)];
        let map = |side: Side, plane: f64, period: f64| match side {
            side if side.is_mirror() => Some(Self {
                sign: -1.0,
                shift: 2.0 * plane,
            }),
            side if side.is_periodic() => Some(Self {
                sign: 1.0,
                shift: period,
            }),
            _ => None,
        };
        let [lower, upper] = domain.sides[axis];
        [map(lower, low, high - low), map(upper, high, low - high)]
    }

    /// Where the map takes a coordinate.
    pub fn place(&self, x: f64) -> f64 {
        self.sign * x + self.shift
    }
}

/// Brings gas that has crossed sides which map the flow onto itself back into the domain.
pub fn bring_back<const D: usize>(domain: &Domain<D>, fluid: &mut [Particle<D>]) {
    for axis in 0..D {
        let maps = Map::of_axis(domain, axis);
        if maps.iter().all(Option::is_none) {
            continue;
        }
        let [low, high] = [domain.face(axis, 0), domain.face(axis, 1)];
        fluid.par_iter_mut().for_each(|particle| {
            let x = particle.position[axis];
            // A period holds one of its ends, and a mirror both.
            let beyond = |map: &Map| x > high || (x == high && map.sign > 0.0);
            let map = match maps {
                [Some(map), _] if x < low => map,
                [_, Some(map)] if beyond(&map) => map,
                _ => return,
            };
            particle.position[axis] = map.place(x);
            if map.sign < 0.0 {
                particle.velocity[axis] = -particle.velocity[axis];
                let acceleration = &mut particle.by_pressure.acceleration;
                acceleration[axis] = -acceleration[axis];
            }
        });
    }
}

/// Maps `x' = sign x + shift` that make the whole of a body of the part that `domain` holds: mirrored across the symmetry planes
/// that halve its `extent` ([`Domain::plane_through`]). What has none is mirrored nowhere.
pub fn reflections<const D: usize>(
    domain: &Domain<D>,
    extent: Option<&Bounds<D>>,
) -> Vec<(Vector<D>, Vector<D>)> {
    let mut maps = vec![(Vector::repeat(1.0), Vector::zeros())];
    for axis in 0..D {
        let plane = extent.and_then(|extent| domain.plane_through(axis, extent));
        let Some((_, plane)) = plane else {
            continue;
        };
        let mirrored: Vec<_> = maps
            .iter()
            .map(|(sign, shift): &(Vector<D>, Vector<D>)| {
                let (mut sign, mut shift) = (*sign, *shift);
                sign[axis] = -sign[axis];
                shift[axis] = 2.0 * plane - shift[axis];
                (sign, shift)
            })
            .collect();
        maps.extend(mirrored);
    }
    maps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_through_one_plane_of_an_axis_is_half_a_body_and_through_both_a_row() {
        let domain = Domain::<3> {
            bounds: Bounds::new(Vector::repeat(-1.0), Vector::repeat(1.0)),
            sides: [
                [Side::Inlet, Side::Outlet],
                [Side::Symmetry, Side::FreeStream],
                [Side::Symmetry; 2],
            ],
            openings: Vec::new(),
        };
        let images = |low: [f64; 3], high: [f64; 3]| {
            let extent = Bounds::new(Vector::from(low), Vector::from(high));
            reflections(&domain, Some(&extent)).len()
        };
        assert_eq!(images([-0.5; 3], [0.5; 3]), 1);
        assert_eq!(images([-0.5, -1.5, -0.5], [0.5; 3]), 2);
        assert_eq!(images([-0.5, -1.5, -1.5], [0.5; 3]), 4);
        assert_eq!(images([-0.5, -0.5, -1.5], [0.5, 0.5, 1.5]), 1);
        assert_eq!(images([-0.5, -1.5, -1.5], [0.5, 0.5, 1.5]), 2);
        assert_eq!(reflections(&domain, None).len(), 1);
    }
}
