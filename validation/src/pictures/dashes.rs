//! Lines cut into dashes.

/// Cuts a line into dashes of length `on`, `off` apart.
pub(super) fn dashes(points: &[[f64; 2]], on: f64, off: f64) -> Vec<Vec<[f64; 2]>> {
    // Distance along the line to every corner.
    let mut along = vec![0.0];
    for pair in points.windows(2) {
        let step = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        along.push(along[along.len() - 1] + step);
    }
    let total = along[along.len() - 1];
    let at = |s: f64| {
        let after = along.partition_point(|v| *v < s).clamp(1, points.len() - 1);
        let share = (s - along[after - 1]) / (along[after] - along[after - 1]).max(1e-300);
        std::array::from_fn(|a| {
            let (from, to) = (points[after - 1][a], points[after][a]);
            from + share.clamp(0.0, 1.0) * (to - from)
        })
    };
    let count = if points.len() > 1 {
        (total / (on + off)).ceil() as usize
    } else {
        0
    };
    (0..count)
        .map(|k| {
            let start = k as f64 * (on + off);
            let end = (start + on).min(total);
            let mut piece = vec![at(start)];
            let inside =
                along.partition_point(|v| *v <= start)..along.partition_point(|v| *v < end);
            piece.extend_from_slice(&points[inside]);
            piece.push(at(end));
            piece
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_cover_their_share_of_the_line() {
        let pieces = dashes(&[[0.0, 0.0], [30.0, 40.0], [30.0, 90.0]], 6.0, 4.0);
        let inked: f64 = pieces
            .iter()
            .flat_map(|p| p.windows(2))
            .map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]))
            .sum();
        assert!((inked - 60.0).abs() < 1e-6, "{inked}");
        assert_eq!(pieces.len(), 10);
    }
}
