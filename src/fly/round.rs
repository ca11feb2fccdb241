//! Is all of a body's surface that of its meridian, turned about the axis? Rays around the axis pass between thin parts and over gaps; the
//! triangles tell of all.

use aero_geometry::outline::Piece;
use aero_geometry::{Revolution, Shape, Vector};

use super::spans::ROUND;

/// Pieces of a triangle's edge, between whose ends points are looked at.
const PIECES: usize = 3;

/// What a coarse nose may be off its meridian by, in parts of the largest radius.
const UNEVEN: f64 = 2e-3;

/// A point nearer to the surface than this part of the largest radius is on it.
const ON: f64 = 1e-6;

/// A meridian, as it was found at stations along the axis.
pub(super) struct Turned<'a> {
    /// `(x, radius)` along the surface.
    pub(super) line: &'a [[f64; 2]],
    /// How far off its own place a step may stand in the line.
    pub(super) apart: f64,
    /// The largest radius of the body.
    pub(super) reach: f64,
}

impl Turned<'_> {
    /// True where no point of the triangles of `shape` lies off the line turned about the axis, on the surface, by more than facets of a round body
    /// do.
    pub(super) fn is_all_of(&self, shape: &dyn Shape<3>) -> bool {
        let pieces = self.line.windows(2).map(|pair| {
            let [a, b] = [pair[0], pair[1]].map(Vector::<2>::from);
            Piece::segment(a, b)
        });
        // What crosses itself is no body.
        let Ok(round) = Revolution::new(pieces.collect()) else {
            return false;
        };
        let facets = shape.facets(f64::INFINITY, &shape.bounds());
        let mut points = facets.iter().flat_map(points);
        points.all(|point| {
            let radius = point[1].hypot(point[2]);
            let allowed = self.apart + ROUND * radius + UNEVEN * self.reach;
            // Triangles inside of other parts are no surface.
            round.signed_distance(&point).abs() <= allowed
                || shape.signed_distance(&point) < -ON * self.reach
        })
    }
}

/// Points spread over a triangle, its corners among them.
fn points([a, b, c]: &[Vector<3>; 3]) -> impl Iterator<Item = Vector<3>> + use<> {
    let (a, along, across) = (*a, b - a, c - a);
    let part = |n: usize| n as f64 / PIECES as f64;
    (0..=PIECES)
        .flat_map(move |i| (0..=PIECES - i).map(move |j| a + along * part(i) + across * part(j)))
}

#[cfg(test)]
pub(super) mod tests {
    use std::f64::consts::TAU;

    use aero_geometry::{Mesh, Vector};

    use super::super::meridian::Meridian;

    type Facet = [Vector<3>; 3];

    /// A closed line `(x, radius)` turned about x.
    pub(in crate::fly) fn turned(line: &[[f64; 2]], around: usize) -> Vec<Facet> {
        let at = |[x, radius]: [f64; 2], k: usize| {
            let (s, c) = (TAU * (k % around) as f64 / around as f64).sin_cos();
            Vector::<3>::new(x, radius * c, radius * s)
        };
        let mut facets = Vec::new();
        for pair in line.windows(2) {
            for k in 0..around {
                let [a, b] = [at(pair[0], k), at(pair[0], k + 1)];
                let [c, d] = [at(pair[1], k + 1), at(pair[1], k)];
                facets.extend((pair[0][1] > 0.0).then_some([a, c, b]));
                facets.extend((pair[1][1] > 0.0).then_some([a, d, c]));
            }
        }
        facets
    }

    const ROCKET: [[f64; 2]; 4] = [[0.0, 0.0], [0.3, 0.05], [1.0, 0.05], [1.0, 0.0]];

    /// A plate from the axis outwards to `radius`, so thick, at an angle.
    fn fin(radius: f64, thick: f64, degrees: f64) -> Vec<Facet> {
        let plate = [
            [0.8, 0.0],
            [0.8, radius],
            [1.0, radius],
            [1.0, 0.0],
            [0.8, 0.0],
        ];
        let (s, c) = f64::to_radians(degrees).sin_cos();
        let at = |[x, y]: [f64; 2], z: f64| Vector::<3>::new(x, c * y - s * z, s * y + c * z);
        let half = 0.5 * thick;
        let mut facets = Vec::new();
        for pair in plate.windows(2) {
            let [a, b] = [at(pair[0], half), at(pair[1], half)];
            let [c, d] = [at(pair[1], -half), at(pair[0], -half)];
            facets.extend([[a, b, c], [a, c, d]]);
        }
        for (z, order) in [
            (half, [0, 2, 1]),
            (half, [0, 3, 2]),
            (-half, [0, 1, 2]),
            (-half, [0, 2, 3]),
        ] {
            facets.push(order.map(|n: usize| at(plate[n], z)));
        }
        facets
    }

    fn is_round(facets: Vec<Facet>) -> bool {
        Meridian::of(&Mesh::from_facets(facets).unwrap()).is_some()
    }

    #[test]
    fn few_facets_and_parts_inside_of_others_are_round_still() {
        for around in [16, 48] {
            assert!(is_round(turned(&ROCKET, around)), "{around}");
        }
        let core = [[0.35, 0.0], [0.4, 0.02], [0.9, 0.02], [0.9, 0.0]];
        assert!(is_round([turned(&ROCKET, 48), turned(&core, 32)].concat()));
        let shaft = [[0.5, 0.0], [0.6, 0.03], [1.4, 0.03], [1.4, 0.0]];
        assert!(is_round([turned(&ROCKET, 48), turned(&shaft, 32)].concat()));
    }

    #[test]
    fn thin_fins_between_the_rays_are_seen() {
        for degrees in [10.0, 45.0, 100.0] {
            let finned = [turned(&ROCKET, 48), fin(0.08, 0.001, degrees)].concat();
            assert!(!is_round(finned), "{degrees}");
        }
    }

    #[test]
    fn a_gap_between_a_body_and_a_ring_around_it_is_seen() {
        let ring = [
            [0.7, 0.065],
            [0.7, 0.07],
            [1.0, 0.07],
            [1.0, 0.065],
            [0.7, 0.065],
        ];
        let ringed = [turned(&ROCKET, 48), turned(&ring, 48)].concat();
        assert!(!is_round(ringed));
    }
}
