//! Sides that map the flow onto itself: a symmetry plane and an axis mirror it, a periodic side shifts it. What lies beyond
//! such a side is a copy of gas within ([`crate::neighbourhood::Images`]), and gas that crosses comes back as its own copy.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Vector};

use crate::frame::Totals;
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

/// Brings gas that has crossed sides which map the flow onto itself back into the domain; returns what mirrors have given it.
pub fn bring_back<const D: usize>(domain: &Domain<D>, fluid: &mut [Particle<D>]) -> Totals {
    let mut received = Totals::default();
    for axis in 0..D {
        let maps = Map::of_axis(domain, axis);
        if maps.iter().all(Option::is_none) {
            continue;
        }
        let [low, high] = [domain.face(axis, 0), domain.face(axis, 1)];
        let bring_back = |particle: &mut Particle<D>| {
            let x = particle.position[axis];
            // A period holds one of its ends, and a mirror both.
            let beyond = |map: &Map| x > high || (x == high && map.sign > 0.0);
            let map = match maps {
                [Some(map), _] if x < low => map,
                [_, Some(map)] if beyond(&map) => map,
                _ => return None,
            };
            particle.position[axis] = map.place(x);
            (map.sign < 0.0).then(|| {
                particle.velocity[axis] = -particle.velocity[axis];
                let acceleration = &mut particle.by_pressure.acceleration;
                acceleration[axis] = -acceleration[axis];
                2.0 * particle.mass * particle.velocity[axis]
            })
        };
        let impulses: Vec<f64> = fluid.par_iter_mut().filter_map(bring_back).collect();
        received.momentum[axis] = impulses.into_iter().sum();
    }
    received
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
    use crate::particles::{ByPressure, Spared};

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

    /// Gas that a mirror turns round has its momentum from it; what goes on at the other side of a period keeps its own.
    #[test]
    fn what_mirrors_give_the_gas_is_what_it_has_more() {
        let domain = Domain::<2> {
            bounds: Bounds::new(Vector::zeros(), Vector::repeat(1.0)),
            sides: [[Side::Periodic; 2], [Side::Symmetry; 2]],
            openings: Vec::new(),
        };
        let at = |place: [f64; 2], velocity: [f64; 2]| Particle {
            position: place.into(),
            velocity: velocity.into(),
            density: 1.0,
            energy: 1.0,
            smoothing_length: 0.1,
            mass: 0.5,
            first_plane_mass: 0.5,
            by_pressure: ByPressure::default(),
            spared: Spared::unknown(),
            is_second: false,
            is_calm: false,
            id: 0,
        };
        let mut fluid = [
            at([0.5, -0.01], [1.0, -0.3]),
            at([1.01, 0.5], [2.0, 0.1]),
            at([0.2, 1.02], [1.0, 0.7]),
            at([0.2, 0.7], [1.0, 0.2]),
        ];
        let momentum = |fluid: &[Particle<2>]| -> Vector<2> {
            fluid.iter().map(|one| one.velocity * one.mass).sum()
        };
        let before = momentum(&fluid);
        let received = bring_back(&domain, &mut fluid).momentum;
        let more = momentum(&fluid) - before;
        assert!((more[1] + 0.4).abs() < 1e-15, "{more}");
        assert!((received[1] - more[1]).abs() < 1e-15, "{received:?}");
        assert_eq!((received[0], received[2]), (0.0, 0.0));
        let places = fluid.map(|one| one.position);
        assert!(places.iter().all(|place| domain.bounds.contains(place)));
    }
}
