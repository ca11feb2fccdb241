//! What a stream sees of a body.

use aero_geometry::{Bounds, Shape};

/// Pixels of the silhouette, each way.
const PIXELS: usize = 1500;

/// Half the sum of `|n| area` along the stream, which is the silhouette of a body without hollows, is believed where the pixels are this near.
const ALIKE: f64 = 0.01;

/// Area of the silhouette along x of a body that fills `bounds`.
pub fn frontal_area(shape: &dyn Shape<3>, bounds: &Bounds<3>) -> f64 {
    area_along(shape, bounds, 0)
}

/// The same along an axis.
pub fn area_along(shape: &dyn Shape<3>, bounds: &Bounds<3>, axis: usize) -> f64 {
    let across = [(axis + 1) % 3, (axis + 2) % 3];
    let facets = shape.facets(f64::INFINITY, bounds);
    let size = bounds.size();
    let pixel = across.map(|k| size[k] / PIXELS as f64);
    let mut seen = vec![false; PIXELS * PIXELS];
    let mut sum = 0.0;
    for facet in &facets {
        let [a, b, c] = [0, 1, 2]
            .map(|n| [0, 1].map(|k| (facet[n][across[k]] - bounds.min[across[k]]) / pixel[k]));
        let double = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        sum += 0.25 * double.abs() * pixel[0] * pixel[1];
        fill(&mut seen, [a, b, c], double);
    }
    let count = seen.iter().filter(|seen| **seen).count();
    let drawn = count as f64 * pixel[0] * pixel[1];
    if (sum - drawn).abs() < ALIKE * drawn {
        sum
    } else {
        drawn
    }
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
        let area = frontal_area(&block, &block.bounds());
        assert!((area - 0.125).abs() < 1e-9, "{area}");
    }
}
