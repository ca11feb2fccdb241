//! The boundary of a region that is known by its spans at stations: one loop of corners.

use super::spans::Spans;

/// Where the region goes from one station to the next: spans behind the first, and before the second.
pub(super) struct Slab {
    /// Stations.
    pub(super) ends: [f64; 2],
    /// As many at either.
    pub(super) spans: [Spans; 2],
}

type Edge = [[f64; 2]; 2];

/// The corners of the boundary of a region that slabs in the order of their stations make up, with the region to the right of the way; none of a
/// region that is in parts, or has holes, or touches itself.
pub(super) fn boundary(slabs: &[Slab]) -> Option<Vec<[f64; 2]>> {
    let mut edges: Vec<Edge> = Vec::new();
    for Slab { ends, spans } in slabs {
        if spans[0].len() != spans[1].len() {
            return None;
        }
        for (a, b) in spans[0].iter().zip(&spans[1]) {
            edges.push([[ends[0], a[1]], [ends[1], b[1]]]);
            edges.push([[ends[1], b[0]], [ends[0], a[0]]]);
        }
    }
    let none = Spans::new();
    for station in 0..=slabs.len() {
        let before = station.checked_sub(1).map(|k| &slabs[k]);
        let behind = slabs.get(station);
        let x = behind.map_or_else(
            || before.map(|slab| slab.ends[1]),
            |slab| Some(slab.ends[0]),
        )?;
        across(
            x,
            before.map_or(&none, |slab| &slab.spans[1]),
            behind.map_or(&none, |slab| &slab.spans[0]),
            &mut edges,
        );
    }
    chained(edges)
}

/// Adds what of the station at `x` is boundary: where the region is on one side of it alone.
fn across(x: f64, before: &Spans, behind: &Spans, edges: &mut Vec<Edge>) {
    let mut radii: Vec<f64> = before.iter().chain(behind).flatten().copied().collect();
    radii.sort_by(f64::total_cmp);
    radii.dedup();
    for pair in radii.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        let holds = |spans: &Spans| spans.iter().any(|[a, b]| *a < middle && middle < *b);
        let [low, high] = [[x, pair[0]], [x, pair[1]]];
        match (holds(before), holds(behind)) {
            (true, false) => edges.push([high, low]),
            (false, true) => edges.push([low, high]),
            _ => {}
        }
    }
}

/// The loop that edges make, if all of them make one.
fn chained(mut edges: Vec<Edge>) -> Option<Vec<[f64; 2]>> {
    let order = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    edges.sort_by(|a, b| order(&a[0], &b[0]));
    let first = edges.first()?[0];
    let mut corners = vec![first];
    let mut at = edges[0][1];
    while order(&at, &first).is_ne() {
        corners.push(at);
        // Where it touches itself the same way is taken again and again.
        if corners.len() > edges.len() {
            return None;
        }
        let next = edges.binary_search_by(|edge| order(&edge[0], &at)).ok()?;
        at = edges[next][1];
    }
    (corners.len() == edges.len()).then_some(corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slab(ends: [f64; 2], before: &[[f64; 2]], behind: &[[f64; 2]]) -> Slab {
        Slab {
            ends,
            spans: [before.to_vec(), behind.to_vec()],
        }
    }

    #[test]
    fn a_cup_has_one_boundary() {
        let cup = [
            slab([0.0, 1.0], &[[0.0, 1.0]], &[[0.0, 1.0]]),
            slab([1.0, 2.0], &[[0.5, 1.0]], &[[0.75, 1.0]]),
        ];
        let corners = boundary(&cup).expect("a boundary");
        let expected = [
            [0.0, 0.0],
            [0.0, 1.0],
            [1.0, 1.0],
            [2.0, 1.0],
            [2.0, 0.75],
            [1.0, 0.5],
            [1.0, 0.0],
        ];
        assert_eq!(corners, expected);
    }

    #[test]
    fn parts_and_holes_have_more_than_one() {
        let two = [slab(
            [0.0, 1.0],
            &[[0.0, 0.4], [0.5, 1.0]],
            &[[0.0, 0.4], [0.5, 1.0]],
        )];
        assert_eq!(boundary(&two), None);
        let full = [[0.0, 1.0]];
        let open = [[0.0, 0.4], [0.5, 1.0]];
        let hole = [
            slab([0.0, 1.0], &full, &full),
            slab([1.0, 2.0], &open, &open),
            slab([2.0, 3.0], &full, &full),
        ];
        assert_eq!(boundary(&hole), None);
        let [low, high] = [[[0.2, 0.6]], [[0.6, 1.0]]];
        let touching = [slab([0.0, 1.0], &low, &low), slab([1.0, 2.0], &high, &high)];
        assert_eq!(boundary(&touching), None);
        // A span that ends between stations is not known.
        assert_eq!(boundary(&[slab([0.0, 1.0], &full, &open)]), None);
    }
}
