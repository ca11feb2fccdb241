//! Edges in which more than two triangles of an oriented surface meet: which of them belong together.
//!
//! Around the edge solid and outside take turns. The two triangles that bound one wedge of the solid
//! are a pair, so that solids that touch in an edge stay apart and each pair runs both ways along
//! it: a surface that is closed stays so in each of its connected parts.

use std::f64::consts::TAU;

use super::edges::HalfEdge;
use super::weld::Indexed;

/// Triangles lower than so many tolerances over the edge have no direction from it.
const NO_HEIGHT: f64 = 10.0;

/// A triangle seen along the edge.
struct Sheet {
    half: HalfEdge,
    /// About the edge, from the lower vertex to the higher.
    angle: f64,
    /// Distance of the third vertex from the edge.
    height: f64,
}

impl Sheet {
    /// True where, turning about the edge, the solid begins here.
    fn opens(&self) -> bool {
        !self.half.ascending
    }

    /// True where two triangles lie on each other as far as the narrower one reaches.
    fn covers(&self, other: &Self, tolerance: f64) -> bool {
        let height = self.height.min(other.height);
        let apart = 2.0 * (0.5 * (self.angle - other.angle)).sin().abs() * height;
        height > NO_HEIGHT * tolerance && apart <= 2.0 * tolerance
    }
}

/// The pairs among the triangles in an edge; none where it has not as many in one direction as in the
/// other.
pub(super) fn wedges(mesh: &Indexed, group: &[HalfEdge]) -> Vec<[HalfEdge; 2]> {
    if group.iter().map(HalfEdge::sign).sum::<i32>() != 0 {
        return Vec::new();
    }
    let sheets = in_turn(mesh, group);
    // Like brackets; a wedge that begins late in the turn ends in the next.
    let mut pairs = Vec::with_capacity(sheets.len() / 2);
    let mut paired = vec![false; sheets.len()];
    let mut open = Vec::new();
    for place in 0..2 * sheets.len() {
        let (first_turn, place) = (place < sheets.len(), place % sheets.len());
        if sheets[place].opens() {
            if first_turn {
                open.push(place);
            }
        } else if let (false, Some(begin)) = (paired[place], open.last()) {
            pairs.push([sheets[*begin].half, sheets[place].half]);
            paired[place] = true;
            open.pop();
        }
    }
    pairs
}

/// The triangles sorted about the edge. Of those that lie on each other the ones that begin the solid
/// come first: a wall between touching solids, or a sheet without thickness, is paired with itself.
fn in_turn(mesh: &Indexed, group: &[HalfEdge]) -> Vec<Sheet> {
    let [low, high] = group[0].vertices().map(|v| mesh.vertices[v as usize]);
    let along = (high - low).try_normalize(0.0).unwrap_or_default();
    let outwards = |half: &HalfEdge| {
        let apex = mesh.facets[half.facet as usize][(half.edge as usize + 2) % 3];
        let offset = mesh.vertices[apex as usize] - low;
        offset - offset.dot(&along) * along
    };
    let widest = group.iter().map(outwards);
    let zero = widest
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))
        .unwrap_or_default();
    let quarter = along.cross(&zero);
    let mut sheets: Vec<Sheet> = group
        .iter()
        .map(|half| {
            let direction = outwards(half);
            Sheet {
                half: *half,
                angle: direction.dot(&quarter).atan2(direction.dot(&zero)),
                height: direction.norm(),
            }
        })
        .collect();
    sheets.sort_by(|a, b| a.angle.total_cmp(&b.angle).then(a.half.cmp(&b.half)));
    // The turn begins between triangles that are apart.
    let covers = |a: &Sheet, b: &Sheet| a.covers(b, mesh.tolerance);
    let count = sheets.len();
    let begin = (0..count).find(|&k| !covers(&sheets[(k + count - 1) % count], &sheets[k]));
    for sheet in &mut sheets[..begin.unwrap_or(0)] {
        sheet.angle += TAU;
    }
    sheets.rotate_left(begin.unwrap_or(0));
    for stack in sheets.chunk_by_mut(covers) {
        stack.sort_by_key(|sheet| !sheet.opens());
    }
    sheets
}
