//! Gas that stands at a side of the domain.

use aero_solver::frame::{Frame, Kind};

/// Particles within so many of their spacings stand at a side.
const NEAR: f64 = 1.2;

/// The gas of `frame` at the side at `end` of `axis`, which lies at `plane`: number of each particle and the area that it takes there.
pub(super) fn beside(
    spacing: f64,
    frame: &Frame,
    (axis, end, plane): (usize, usize, f64),
) -> impl Iterator<Item = (usize, f64)> {
    let outwards = [-1.0, 1.0][end];
    (0..frame.position.len()).filter_map(move |i| {
        let own = frame.extra.spacing.get(i).copied().unwrap_or(spacing);
        let distance = outwards * (plane - frame.position[i][axis]);
        let stands_there =
            frame.kind[i] == Kind::Fluid as u8 && (0.0..=NEAR * own).contains(&distance);
        stands_there.then(|| (i, frame.volume[i] / own))
    })
}
