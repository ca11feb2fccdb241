//! Bodies of revolution: is a body one, and what is its meridian?

use std::f64::consts::TAU;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Shape, Vector};

use super::loops::{Slab, boundary};
use super::round::Turned;
use super::spans::{Facets, Spans};

/// Stations along the axis where the corners of the triangles do not give fewer.
const STATIONS: usize = 300;

/// So many of them tell of most bodies that they are not round.
const FIRST: usize = 5;

/// Corners nearer to the line between their neighbours than this part of the largest radius are left out.
const STRAIGHT: f64 = 2e-4;

/// A step off a station, in parts of the length, to see both sides of a face across the axis.
const ASIDE: f64 = 1e-5;

/// Pieces of the length by which surfaces that are not of triangles are looked at.
const PIECES: f64 = 40.0;

/// Half of the section of a body of revolution by a plane through its axis, which is x.
#[derive(Clone, Debug, PartialEq)]
pub struct Meridian {
    /// Corners `(x, radius)`, with the body to the right of the way: from the axis at the nose to the axis again; all around, the first of them not
    /// repeated, of a ring that the axis passes through.
    pub corners: Vec<[f64; 2]>,
    /// True of such a ring.
    pub is_ring: bool,
}

impl Meridian {
    /// That of a body; none of one that is not round, or in parts, or hollow inside.
    pub fn of(shape: &dyn Shape<3>) -> Option<Self> {
        let bounds = shape.bounds();
        let (low, high) = (bounds.min[0], bounds.max[0]);
        let length = high - low;
        let reach = (1..3)
            .map(|k| bounds.max[k].abs().max(bounds.min[k].abs()))
            .fold(0.0, f64::max);
        let triangles = shape.facets(length / PIECES, &bounds);
        let (places, apart) = stations(&triangles, low, high);
        let facets = Facets::new(triangles, reach);
        let aside = ASIDE * length;
        let sides = |pair: &[f64]| -> Option<[Spans; 2]> {
            Some([facets.at(pair[0] + aside)?, facets.at(pair[1] - aside)?])
        };
        let pairs: Vec<&[f64]> = places.windows(2).collect();
        for pair in pairs.iter().step_by(1 + pairs.len() / FIRST) {
            sides(pair)?;
        }
        let slabs: Vec<Option<Slab>> = pairs
            .par_iter()
            .map(|pair| {
                let spans = sides(pair)?;
                let ends = [pair[0], pair[1]];
                Some(Slab { ends, spans })
            })
            .collect();
        let slabs: Vec<Slab> = slabs.into_iter().collect::<Option<_>>()?;
        let found = Self::from_loop(boundary(&slabs)?)?.thinned(STRAIGHT * reach);
        let turned = Turned {
            line: &found.surface(),
            apart: apart + 2.0 * aside,
            reach,
        };
        turned.is_all_of(shape).then_some(found)
    }

    /// From a loop that may go along the axis, once.
    fn from_loop(mut corners: Vec<[f64; 2]>) -> Option<Self> {
        let is_on_axis = |corner: &[f64; 2]| corner[1] == 0.0;
        let count = corners.len();
        // From the axis onwards.
        let leaves =
            |k: &usize| is_on_axis(&corners[*k]) && !is_on_axis(&corners[(*k + 1) % count]);
        let mut starts = (0..count).filter(leaves);
        let Some(start) = starts.next() else {
            return corners
                .first()
                .is_some_and(|corner| !is_on_axis(corner))
                .then_some(Self {
                    corners,
                    is_ring: true,
                });
        };
        if starts.next().is_some() {
            return None;
        }
        corners.rotate_left(start);
        let end = 1 + corners[1..].iter().position(is_on_axis)?;
        corners.truncate(end + 1);
        Some(Self {
            corners,
            is_ring: false,
        })
    }

    /// The corners along the surface, the first of a ring once more at the end.
    pub fn surface(&self) -> Vec<[f64; 2]> {
        let again = self.is_ring.then(|| self.corners[0]);
        self.corners.iter().copied().chain(again).collect()
    }

    /// Corners of what is seen of the body in a plane through the axis: of a solid one, with its mirror image.
    pub fn polygon(&self) -> Vec<[f64; 2]> {
        let lower = self
            .corners
            .iter()
            .rev()
            .filter(|[_, radius]| *radius > 0.0);
        let lower = lower.map(|[x, radius]| [*x, -radius]);
        let lower = lower.filter(|_| !self.is_ring);
        self.corners.iter().copied().chain(lower).collect()
    }

    /// Area of the body seen along the axis.
    pub fn frontal_area(&self) -> f64 {
        let radii = || self.corners.iter().map(|corner| corner[1]);
        let widest = radii().fold(0.0, f64::max);
        let least = radii().fold(widest, f64::min); // none of a solid body
        0.5 * TAU * (widest * widest - least * least)
    }

    /// Without the corners that it does not need.
    fn thinned(self, allowed: f64) -> Self {
        let line = self.surface();
        let mut corners = if self.is_ring {
            let from = line[0];
            let far = |k: &usize| (line[*k][0] - from[0]).hypot(line[*k][1] - from[1]);
            let farthest = (0..line.len()).max_by(|a, b| far(a).total_cmp(&far(b)));
            let farthest = farthest.unwrap_or_default();
            let mut corners = thinned(&line[..=farthest], allowed);
            corners.pop();
            corners.extend(thinned(&line[farthest..], allowed));
            corners
        } else {
            thinned(&line, allowed)
        };
        if self.is_ring {
            corners.pop();
        }
        Self { corners, ..self }
    }
}

/// Places along the axis where corners lie, or evenly spread ones where those are many; and how far a corner may be from its nearest neighbours
/// among them.
fn stations(facets: &[[Vector<3>; 3]], low: f64, high: f64) -> (Vec<f64>, f64) {
    let mut places: Vec<f64> = facets.iter().flatten().map(|corner| corner[0]).collect();
    places.sort_by(f64::total_cmp);
    let apart = 1e-6 * (high - low);
    places.dedup_by(|a, b| *a - *b < apart);
    if places.len() < 2 || places.len() > STATIONS {
        let part = |k: usize| k as f64 / STATIONS as f64;
        // Closer at the ends, where noses are round.
        places = (0..=STATIONS)
            .map(|k| low + (high - low) * 0.5 * (1.0 - (part(k) * 0.5 * TAU).cos()))
            .collect();
        return (places, (high - low) * 0.25 * TAU / STATIONS as f64);
    }
    (places, 0.0)
}

/// The line without corners that it does not need [Douglas & Peucker 1973].
fn thinned(line: &[[f64; 2]], allowed: f64) -> Vec<[f64; 2]> {
    let (Some(first), Some(last)) = (line.first(), line.last()) else {
        return Vec::new();
    };
    let chord = [last[0] - first[0], last[1] - first[1]];
    let length = chord[0].hypot(chord[1]);
    let off = |p: &[f64; 2]| {
        let from = [p[0] - first[0], p[1] - first[1]];
        if length > 0.0 {
            (chord[0] * from[1] - chord[1] * from[0]).abs() / length
        } else {
            from[0].hypot(from[1])
        }
    };
    let far =
        (1..line.len().saturating_sub(1)).max_by(|&a, &b| off(&line[a]).total_cmp(&off(&line[b])));
    match far {
        Some(far) if off(&line[far]) > allowed => {
            let mut thin = thinned(&line[..=far], allowed);
            thin.pop();
            thin.extend(thinned(&line[far..], allowed));
            thin
        }
        _ => vec![*first, *last],
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::{Mesh, bodies};

    use super::super::round::tests::turned;
    use super::*;

    #[test]
    fn a_sphere_has_its_half_circle_for_a_meridian() {
        let sphere = bodies::sphere(0.5).unwrap();
        let Meridian { corners, is_ring } = Meridian::of(&sphere).unwrap();
        for [x, radius] in &corners {
            assert!((x.hypot(*radius) - 0.5).abs() < 3e-3, "{x} {radius}");
        }
        assert!(!is_ring && corners.len() > 20 && corners.len() < 120);
    }

    #[test]
    fn a_block_is_not_round() {
        assert!(Meridian::of(&bodies::cuboid([1.0, 0.5, 0.5]).unwrap()).is_none());
    }

    /// Corners of the meridian of a line turned about the axis, off the line by less than facets are off the circle.
    #[track_caller]
    fn comes_back(line: &[[f64; 2]], is_ring: bool, area: f64) {
        let mesh = Mesh::from_facets(turned(line, 48)).unwrap();
        let found = Meridian::of(&mesh).unwrap_or_else(|| panic!("{line:?}"));
        let surface = found.surface();
        assert_eq!((found.is_ring, surface.len()), (is_ring, line.len()));
        // A ring's loop may begin anywhere.
        for corner in &found.corners {
            let off = |[x, r]: [f64; 2]| (x - corner[0]).hypot(r - corner[1]);
            let least = line.iter().map(|p| off(*p)).fold(1.0, f64::min);
            assert!(least < 1e-3, "{corner:?}");
        }
        let part = found.frontal_area() / area;
        assert!((part - 1.0).abs() < 3e-3, "{part}");
    }

    #[test]
    fn rings_and_hollow_bases_have_meridians() {
        let ring = [[0.0, 0.3], [0.5, 0.34], [1.0, 0.3], [0.5, 0.28], [0.0, 0.3]];
        comes_back(&ring, true, 0.5 * TAU * (0.34 * 0.34 - 0.28 * 0.28));
        let tube = [[0.0, 0.2], [0.0, 0.3], [1.0, 0.3], [1.0, 0.2], [0.0, 0.2]];
        comes_back(&tube, true, 0.5 * TAU * (0.3 * 0.3 - 0.2 * 0.2));
        let cup = [
            [0.0, 0.0],
            [0.4, 0.2],
            [1.0, 0.2],
            [1.0, 0.15],
            [0.8, 0.1],
            [0.8, 0.0],
        ];
        comes_back(&cup, false, 0.5 * TAU * 0.2 * 0.2);
        // A chamber that nothing leads to.
        let chamber = [[0.5, 0.0], [0.6, 0.0], [0.6, 0.1], [0.5, 0.1], [0.5, 0.0]];
        let hollow = [turned(&cup, 48), turned(&chamber, 48)].concat();
        assert_eq!(Meridian::of(&Mesh::from_facets(hollow).unwrap()), None);
    }

    /// By more than facets make it so: 2 %.
    #[test]
    fn what_is_squashed_is_not_round() {
        let squashed = |part: f64| {
            let mut facets = turned(&[[0.0, 0.0], [0.4, 0.2], [1.0, 0.2], [1.0, 0.0]], 48);
            for corner in facets.iter_mut().flatten() {
                corner[2] *= part;
            }
            Meridian::of(&Mesh::from_facets(facets).unwrap()).is_some()
        };
        assert!(squashed(0.99) && !squashed(0.97));
    }

    #[test]
    fn the_image_of_a_solid_body_is_seen_and_none_of_a_ring() {
        let corners = vec![[0.0, 0.0], [1.0, 0.5], [1.0, 0.0]];
        let solid = Meridian {
            corners: corners.clone(),
            is_ring: false,
        };
        assert_eq!(solid.polygon()[3..], [[1.0, -0.5]]);
        let ring = Meridian {
            corners: corners.iter().map(|[x, r]| [*x, r + 1.0]).collect(),
            is_ring: true,
        };
        assert_eq!(ring.polygon(), ring.corners);
    }
}
