//! Bodies of revolution: is a body one, and what is its meridian?

use std::f64::consts::TAU;

use aero_geometry::{Shape, Vector};

use super::round::Turned;

/// Stations along the axis where the corners of the triangles do not give fewer.
const STATIONS: usize = 300;

/// Directions around the axis in which the radius is measured; no divisor of usual facet counts.
const AROUND: usize = 23;

/// Largest part by which radii around the axis may differ: that of a tube of 16 facets.
pub(super) const ROUND: f64 = 0.02;

/// Corners nearer to the line between their neighbours than this part of the largest radius are left out.
const STRAIGHT: f64 = 2e-4;

/// A step off a station, in parts of the length, to see both sides of a face across the axis.
const ASIDE: f64 = 1e-5;

/// The meridian `(x, radius)` from nose to tail of a body whose axis is x and that is solid there; none of one that is not round.
pub fn meridian(shape: &dyn Shape<3>) -> Option<Vec<[f64; 2]>> {
    let bounds = shape.bounds();
    let (low, high) = (bounds.min[0], bounds.max[0]);
    let length = high - low;
    let reach = (1..3)
        .map(|k| bounds.max[k].abs().max(bounds.min[k].abs()))
        .fold(0.0, f64::max);
    let aside = ASIDE * length;
    let mut found: Vec<[f64; 2]> = Vec::new();
    let (places, apart) = stations(shape, low, high);
    for x in places {
        for x in [x - aside, x + aside] {
            if x <= low || x >= high {
                continue;
            }
            let radii: Vec<f64> = (0..AROUND)
                .map(|k| radius(shape, x, TAU * k as f64 / AROUND as f64, reach))
                .collect();
            let most = radii.iter().copied().fold(0.0, f64::max);
            let least = radii.iter().copied().fold(f64::INFINITY, f64::min);
            if most - least > ROUND * most + 1e-3 * ROUND * reach || !is_full(shape, x, least) {
                return None;
            }
            // The mean square keeps the section of the facets.
            let square = radii.iter().map(|r| r * r).sum::<f64>() / AROUND as f64;
            found.push([x, square.sqrt()]);
        }
    }
    let (first, last) = (*found.first()?, *found.last()?);
    let mut line = vec![[low, 0.0]];
    // A face across the axis has its radius at once.
    if first[1] > 2.0 * STRAIGHT * reach {
        line.push([low, first[1]]);
    }
    line.extend(found);
    if last[1] > 2.0 * STRAIGHT * reach {
        line.push([high, last[1]]);
    }
    line.push([high, 0.0]);
    let turned = Turned {
        line: &line,
        apart: apart + 2.0 * aside,
        reach,
    };
    turned
        .is_all_of(shape)
        .then(|| thinned(&line, STRAIGHT * reach))
}

/// Places along the axis where corners lie, or evenly spread ones where those are many; and how far a corner may be from its nearest neighbours
/// among them.
fn stations(shape: &dyn Shape<3>, low: f64, high: f64) -> (Vec<f64>, f64) {
    let facets = shape.facets(f64::INFINITY, &shape.bounds());
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

/// Distance from the axis at which the body, solid inside of it, ends: by bisection, because a ray may graze the surface.
fn radius(shape: &dyn Shape<3>, x: f64, angle: f64, reach: f64) -> f64 {
    /// Halvings: to a millionth of the first width.
    const HALVINGS: usize = 24;
    let [mut low, mut high] = [0.0, 1.5 * reach];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let point = Vector::<3>::new(x, middle * angle.cos(), middle * angle.sin());
        if shape.signed_distance(&point) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// True where the body is solid from the axis to that radius.
fn is_full(shape: &dyn Shape<3>, x: f64, radius: f64) -> bool {
    [0.0, 0.3, 0.6, 0.9].iter().all(|part| {
        let point = Vector::<3>::new(x, 0.8 * part * radius, 0.6 * part * radius);
        radius < 1e-9 || shape.signed_distance(&point) <= 1e-9
    })
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
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn a_sphere_has_its_half_circle_for_a_meridian() {
        let sphere = bodies::sphere(0.5).unwrap();
        let line = meridian(&sphere).unwrap();
        for [x, radius] in &line {
            assert!((x.hypot(*radius) - 0.5).abs() < 3e-3, "{x} {radius}");
        }
        assert!(line.len() > 20 && line.len() < 120, "{}", line.len());
    }

    #[test]
    fn a_block_is_not_round() {
        assert!(meridian(&bodies::cuboid([1.0, 0.5, 0.5]).unwrap()).is_none());
    }
}
