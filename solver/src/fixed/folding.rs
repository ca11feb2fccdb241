//! Faces in their order, those between the same two cells as one.

use super::cells::{RADIAL, SideFace, WallFace, WallOwner};

/// Sorts the walls and adds up those of one smooth face in one cell. Their foot is the middle of their sizes, which are lengths in the plane of rings, as
/// those grow with the radius.
pub fn folded_walls<const D: usize>(
    mut walls: Vec<WallFace<D>>,
    about_axis: bool,
) -> Vec<WallFace<D>> {
    let size = |wall: &WallFace<D>| {
        let radius = if about_axis {
            wall.foot[RADIAL % D].max(f64::MIN_POSITIVE)
        } else {
            1.0
        };
        wall.area.norm() / radius
    };
    let key = |wall: &WallFace<D>| match wall.owner {
        WallOwner::Body(body) => (wall.i, body, wall.facet),
        WallOwner::Side { axis, end } => (wall.i, u32::MAX, u32::from(2 * axis + end)),
    };
    walls.sort_by_key(key);
    let mut kept: Vec<WallFace<D>> = Vec::with_capacity(walls.len());
    for wall in walls {
        match kept.last_mut() {
            Some(known) if key(known) == key(&wall) => {
                let (a, b) = (size(known), size(&wall));
                known.foot += (wall.foot - known.foot) * (b / (a + b));
                known.area += wall.area;
            }
            _ => kept.push(wall),
        }
    }
    kept.retain(|wall| wall.area.norm() > 0.0);
    kept
}

/// Sorts the faces on sides.
pub fn folded_sides<const D: usize>(mut sides: Vec<SideFace<D>>) -> Vec<SideFace<D>> {
    sides.sort_by_key(|side| (side.i, side.axis, side.end));
    sides
}
