//! Triangles that span a rim.

use super::weld::Indexed;
use crate::Vector;
use crate::stl::Facet;

/// Rims with more corners than this are spanned ear by ear: the least area costs the cube of their
/// number.
const FEW: usize = 200;

/// The triangles that span a closed border, running along it, and their area.
pub(super) fn span(mesh: &Indexed, border: &[u32]) -> (f64, Vec<[u32; 3]>) {
    if border.len() <= FEW {
        return least_area(mesh, border);
    }
    let patch = by_ears(mesh, border);
    (patch.iter().map(|&f| mesh.area(f)).sum(), patch)
}

/// The triangles of a polygon, which need not be convex or quite plane.
pub(crate) fn triangulate(polygon: Vec<Vector<3>>) -> Vec<Facet> {
    let border: Vec<u32> = (0..polygon.len() as u32).collect();
    let mesh = Indexed {
        vertices: polygon,
        ..Indexed::default()
    };
    let (_, patch) = span(&mesh, &border);
    patch.into_iter().map(|facet| mesh.corners(facet)).collect()
}

/// The triangles of least area. [Barequet & Sharir 1995, "Filling gaps in the boundary of a
/// polyhedron", Comput. Aided Geom. Des. 12, 207]
fn least_area(mesh: &Indexed, border: &[u32]) -> (f64, Vec<[u32; 3]>) {
    let count = border.len();
    let mut least = vec![0.0; count * count];
    let mut apex = vec![0; count * count];
    for width in 2..count {
        for first in 0..count - width {
            let last = first + width;
            let mut best = (f64::INFINITY, first + 1);
            for middle in first + 1..last {
                let total = least[first * count + middle]
                    + least[middle * count + last]
                    + mesh.area([border[first], border[middle], border[last]]);
                if total < best.0 {
                    best = (total, middle);
                }
            }
            least[first * count + last] = best.0;
            apex[first * count + last] = best.1;
        }
    }
    let mut patch = Vec::with_capacity(count - 2);
    let mut open = vec![(0, count - 1)];
    while let Some((first, last)) = open.pop() {
        if last - first < 2 {
            continue;
        }
        let middle = apex[first * count + last];
        patch.push([border[first], border[middle], border[last]]);
        open.push((middle, last));
        open.push((first, middle));
    }
    (least[count - 1], patch)
}

/// Ears cut off one by one, as seen along the rim's mean normal; where there is none, the corner with
/// the smallest triangle. [Meisters 1975, "Polygons have ears", Amer. Math. Monthly 82, 648]
fn by_ears(mesh: &Indexed, border: &[u32]) -> Vec<[u32; 3]> {
    let point = |v: u32| mesh.vertices[v as usize];
    let origin = point(border[0]);
    let pairs = border.iter().zip(border.iter().cycle().skip(1));
    // Newell's normal.
    let doubled: Vector<3> = pairs
        .map(|(&a, &b)| (point(a) - origin).cross(&(point(b) - origin)))
        .sum();
    let up = doubled.try_normalize(0.0).unwrap_or_else(Vector::<3>::z);
    let turn = |a: u32, b: u32, c: u32| {
        let (u, v) = (point(b) - point(a), point(c) - point(a));
        u.cross(&v).dot(&up)
    };
    let mut left = border.to_vec();
    let mut patch = Vec::with_capacity(border.len() - 2);
    let mut from = 0;
    while left.len() > 3 {
        let count = left.len();
        let corner = |k: usize| {
            [
                left[(k + count - 1) % count],
                left[k],
                left[(k + 1) % count],
            ]
        };
        let is_ear = |k: usize| {
            let [a, b, c] = corner(k);
            let inside =
                |p: u32| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
            turn(a, b, c) > 0.0 && !left.iter().any(|&p| ![a, b, c].contains(&p) && inside(p))
        };
        let around = (0..count).map(|step| (from + step) % count);
        let smallest =
            || (0..count).min_by(|&k, &l| mesh.area(corner(k)).total_cmp(&mesh.area(corner(l))));
        let ear = around.clone().find(|&k| is_ear(k)).or_else(smallest);
        let ear = ear.unwrap_or(0);
        patch.push(corner(ear));
        left.remove(ear);
        // On with the next but one, lest all ears be slices from one corner.
        from = (ear + 1) % left.len();
    }
    patch.push([left[0], left[1], left[2]]);
    patch
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A comb with many teeth, which no fan spans.
    #[test]
    fn a_comb_of_many_corners_is_spanned_by_its_own_area() {
        let teeth = 120;
        let mut points = vec![[0.0, 0.0], [f64::from(teeth), 0.0]];
        for k in (0..teeth).rev() {
            let x = f64::from(k);
            points.extend([[x + 1.0, 3.0], [x + 0.5, 1.0]]);
        }
        points.push([0.0, 3.0]);
        let lifted = |[x, y]: [f64; 2]| Vector::<3>::new(x, y, 0.1 * x);
        let count = points.len() as u32;
        let mesh = Indexed {
            vertices: points.into_iter().map(lifted).collect(),
            ..Indexed::default()
        };
        let border: Vec<u32> = (0..count).collect();
        assert!(border.len() > FEW);
        let (area, patch) = span(&mesh, &border);
        assert_eq!(patch.len() as u32, count - 2);
        let exact = 2.0 * f64::from(teeth) * 1.01_f64.sqrt();
        assert!((area / exact - 1.0).abs() < 1e-9, "{area} {exact}");
    }
}
