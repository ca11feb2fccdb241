//! What a stream sees of a body.

use aero_geometry::{Bounds, Shape, Vector};

/// Pixels of the silhouette, each way.
const PIXELS: usize = 1500;

/// Half the sum of `|n| area` along the stream, which is the silhouette of a body without hollows, is believed where the pixels are this near.
const ALIKE: f64 = 0.01;

/// Round parts are cut into facets as long as this part of a body.
const FACET: f64 = 1.0 / 300.0;

/// Area of the silhouette along an axis of the part of a body in space that lies in `bounds`, which are not empty across that axis; nothing of a shape
/// that has no facets.
pub fn area_along<const D: usize>(shape: &dyn Shape<D>, bounds: &Bounds<D>, axis: usize) -> f64 {
    debug_assert_eq!(D, 3, "a silhouette is of a body in space");
    let across = [(axis + 1) % D, (axis + 2) % D];
    let size = bounds.size();
    let pixel = across.map(|k| size[k] / PIXELS as f64);
    let mut seen = vec![false; PIXELS * PIXELS];
    let mut sum = 0.0;
    let mut is_whole = true;
    shape.for_each_facet(FACET * size.max(), bounds, &mut |facet| {
        let kept = clipped(facet.to_vec(), bounds);
        is_whole &= kept == facet;
        let flat = kept
            .iter()
            .map(|corner| [0, 1].map(|k| (corner[across[k]] - bounds.min[across[k]]) / pixel[k]));
        let flat: Vec<[f64; 2]> = flat.collect();
        for pair in flat.get(1..).unwrap_or_default().windows(2) {
            let [a, b, c] = [flat[0], pair[0], pair[1]];
            let double = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            sum += 0.25 * double.abs() * pixel[0] * pixel[1];
            fill(&mut seen, [a, b, c], double);
        }
    });
    let count = seen.iter().filter(|seen| **seen).count();
    let drawn = count as f64 * pixel[0] * pixel[1];
    if is_whole && (sum - drawn).abs() < ALIKE * drawn {
        sum
    } else {
        drawn
    }
}

/// The part of a polygon that lies in a box [Sutherland & Hodgman 1974].
fn clipped<const D: usize>(mut polygon: Vec<Vector<D>>, bounds: &Bounds<D>) -> Vec<Vector<D>> {
    for axis in 0..D {
        for (sign, limit) in [(-1.0, -bounds.min[axis]), (1.0, bounds.max[axis])] {
            let beyond = |corner: &Vector<D>| sign * corner[axis] - limit;
            if polygon.iter().all(|corner| beyond(corner) <= 0.0) {
                continue;
            }
            let mut kept = Vec::with_capacity(polygon.len() + 1);
            for (n, corner) in polygon.iter().enumerate() {
                let next = &polygon[(n + 1) % polygon.len()];
                let [here, there] = [beyond(corner), beyond(next)];
                if here <= 0.0 {
                    kept.push(*corner);
                }
                if (here <= 0.0) != (there <= 0.0) {
                    kept.push(corner + (next - corner) * (here / (here - there)));
                }
            }
            polygon = kept;
        }
    }
    polygon
}

/// Marks the pixels whose middles lie in a triangle.
fn fill(seen: &mut [bool], [a, b, c]: [[f64; 2]; 3], double: f64) {
    if double == 0.0 {
        return;
    }
    let range = |k: usize| {
        let low = a[k].min(b[k]).min(c[k]).max(0.0) as usize;
        let high = a[k].max(b[k]).max(c[k]).ceil().min(PIXELS as f64) as usize;
        low..high
    };
    for y in range(1) {
        for x in range(0) {
            let p = [x as f64 + 0.5, y as f64 + 0.5];
            let side = |u: [f64; 2], v: [f64; 2]| {
                ((v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0])) / double
            };
            if side(a, b) >= 0.0 && side(b, c) >= 0.0 && side(c, a) >= 0.0 {
                seen[y * PIXELS + x] = true;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn a_block_shows_its_front() {
        let block = bodies::cuboid([1.0, 0.5, 0.25]).unwrap();
        let area = area_along(&block, &block.bounds(), 0);
        assert!((area - 0.125).abs() < 1e-9, "{area}");
    }

    #[test]
    fn what_lies_beyond_the_box_is_not_seen() {
        let cone = bodies::cone(45.0, 1.0).unwrap();
        let mut part = cone.bounds();
        part.max[0] = part.min[0] + 0.5;
        let area = area_along(&cone, &part, 0);
        let exact = 0.25 * std::f64::consts::PI;
        assert!((area / exact - 1.0).abs() < 4e-3, "{area}");
    }
}
