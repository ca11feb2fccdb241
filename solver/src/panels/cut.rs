//! Segments and triangles cut by planes across the axes, and halved until they are short.

use aero_geometry::Vector;

/// The parts of `pieces` with `sign (x_axis - plane) <= 0` [Sutherland & Hodgman 1974].
pub fn clipped<const D: usize>(
    pieces: &[[Vector<D>; D]],
    axis: usize,
    plane: f64,
    sign: f64,
) -> Vec<[Vector<D>; D]> {
    let beyond = |point: &Vector<D>| sign * (point[axis] - plane);
    let mut parts = Vec::with_capacity(pieces.len());
    for piece in pieces {
        let mut left: Vec<Vector<D>> = Vec::with_capacity(D + 1);
        for (n, a) in piece.iter().enumerate() {
            let from = beyond(a);
            if from <= 0.0 {
                left.push(*a);
            }
            // A segment does not close.
            if n + 1 == D && D < 3 {
                break;
            }
            let b = &piece[(n + 1) % D];
            let to = beyond(b);
            if from * to < 0.0 {
                left.push(a + (b - a) * (from / (from - to)));
            }
        }
        for last in D..=left.len() {
            parts.push(std::array::from_fn(|n| match n {
                0 => left[0],
                n => left[last - D + n],
            }));
        }
    }
    parts
}

/// Hands out `pieces`, halved across their longest edge until none is longer than `longest`.
pub fn halved<const D: usize>(
    pieces: Vec<[Vector<D>; D]>,
    longest: f64,
    take: &mut impl FnMut([Vector<D>; D]),
) {
    let mut left = pieces;
    while let Some(piece) = left.pop() {
        match longest_edge(&piece).filter(|(.., length)| *length > longest) {
            Some((a, b, _)) => left.extend(halves(&piece, a, b)),
            None => take(piece),
        }
    }
}

/// A piece halved across its edge from corner `a` to corner `b`.
pub fn halves<const D: usize>(piece: &[Vector<D>; D], a: usize, b: usize) -> [[Vector<D>; D]; 2] {
    let middle = (piece[a] + piece[b]) * 0.5;
    [a, b].map(|end| {
        let mut half = *piece;
        half[end] = middle;
        half
    })
}

/// The ends and the length of the longest edge; none of a point.
pub fn longest_edge<const D: usize>(corners: &[Vector<D>; D]) -> Option<(usize, usize, f64)> {
    let edges = (0..D).flat_map(|a| (a + 1..D).map(move |b| (a, b)));
    let long = edges.map(|(a, b)| (a, b, (corners[a] - corners[b]).norm()));
    long.max_by(|x, y| x.2.total_cmp(&y.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area([a, b, c]: &[Vector<3>; 3]) -> f64 {
        0.5 * (b - a).cross(&(c - a)).norm()
    }

    #[test]
    fn the_parts_of_a_triangle_on_both_sides_of_a_plane_make_it_up() {
        let triangle = [
            Vector::<3>::new(0.0, 0.0, 0.0),
            Vector::<3>::new(2.0, 0.3, 0.0),
            Vector::<3>::new(0.5, 1.7, 0.4),
        ];
        for plane in [-0.1, 0.2, 0.5, 1.3, 2.5] {
            let parts = [1.0, -1.0].map(|sign| clipped(&[triangle], 0, plane, sign));
            let sum: f64 = parts.iter().flatten().map(area).sum();
            assert!((sum - area(&triangle)).abs() < 1e-14, "{plane}: {sum}");
            assert!(parts[0].iter().flatten().all(|p| p[0] <= plane + 1e-15));
        }
    }

    #[test]
    fn halves_are_short_and_cover_as_much() {
        let needle = [
            Vector::<3>::new(0.0, 0.0, 0.0),
            Vector::<3>::new(10.0, 0.0, 0.0),
            Vector::<3>::new(10.0, 0.05, 0.0),
        ];
        let (mut sum, mut count) = (0.0, 0);
        halved(vec![needle], 0.3, &mut |piece| {
            sum += area(&piece);
            count += 1;
            assert!((piece[0] - piece[1]).norm() <= 0.3);
        });
        assert!((sum - area(&needle)).abs() < 1e-12 && count > 33);
        let mut segments = 0;
        let segment = [Vector::<2>::zeros(), Vector::<2>::new(1.0, 0.0)];
        halved(vec![segment], 0.3, &mut |_| segments += 1);
        assert_eq!(segments, 4);
    }
}
