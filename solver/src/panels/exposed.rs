//! What of the surfaces gas may be in front of: not the foot of a post on a wall, nor the wall below it.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::Panel;
use super::cut::{halves, longest_edge};
use crate::problem::Problem;
use crate::walls::solids::Solids;

/// Pieces per edge of a panel that are looked at, in the plane and in space.
const PIECES: [usize; 2] = [32, 8];

/// What is as small a part of a panel as this is not told apart.
const UNSEEN: f64 = 1.0 / 16.0;

/// So often a panel is parted, at most.
const PARTED: usize = 6;

/// So often the place on an edge that another solid begins at is halved in on.
const HALVED: usize = 40;

/// Corners are looked at this part of the way to the middle: on the line that two solids meet in they belong to both.
const WITHIN: f64 = 1e-6;

/// Parts `panels` where the surfaces of other solids cross them, and finds which are covered.
pub fn part<const D: usize>(problem: &Problem<D>, panels: Vec<Panel<D>>) -> Vec<Panel<D>> {
    let solids = Solids::new(problem);
    if D == 1 || !solids.may_meet() {
        return panels;
    }
    let parts: Vec<Vec<Panel<D>>> = panels
        .par_iter()
        .map(|panel| parts(&solids, panel))
        .collect();
    parts.into_iter().flatten().collect()
}

/// The parts of a panel, each covered or not.
fn parts<const D: usize>(solids: &Solids<'_, D>, panel: &Panel<D>) -> Vec<Panel<D>> {
    let is_covered = |place: &Vector<D>| solids.covers(place, &panel.normal, panel.owner);
    let mut parts = Vec::new();
    let mut left = vec![(panel.corners, PARTED)];
    while let Some((corners, times)) = left.pop() {
        let middle = corners.iter().sum::<Vector<D>>() / D as f64;
        let at_corners = corners.map(|corner| is_covered(&(corner + (middle - corner) * WITHIN)));
        let places = middles(&corners);
        let covered = places.iter().filter(|place| is_covered(place)).count();
        let part = covered as f64 / places.len() as f64;
        let is_one = part <= UNSEEN || part >= 1.0 - UNSEEN;
        if times == 0 || is_one && at_corners.iter().all(|at| *at == (part > 0.5)) {
            let panel = Panel::new(corners, Some(panel.normal), panel.owner);
            parts.extend(panel.map(|new| Panel {
                is_covered: part > 0.5,
                ..new
            }));
            continue;
        }
        let odd = (0..D).find(|&n| (0..D).all(|k| k == n || at_corners[k] != at_corners[n]));
        let new = match (odd, longest_edge(&corners)) {
            (Some(odd), _) => cut_off(&corners, odd, &is_covered),
            (None, Some((a, b, _))) => halves(&corners, a, b).to_vec(),
            (None, None) => Vec::new(),
        };
        left.extend(new.into_iter().map(|new| (new, times - 1)));
    }
    parts
}

/// A panel parted where cover ends on its edges from corner `odd`, which alone is covered or alone is not.
fn cut_off<const D: usize>(
    corners: &[Vector<D>; D],
    odd: usize,
    is_covered: &impl Fn(&Vector<D>) -> bool,
) -> Vec<[Vector<D>; D]> {
    let middle = corners.iter().sum::<Vector<D>>() / D as f64;
    let covered = is_covered(&(corners[odd] + (middle - corners[odd]) * WITHIN));
    let others = (1..D).map(|k| (odd + k) % D);
    let ends: Vec<(usize, Vector<D>)> = others
        .map(|other| {
            let (mut same, mut changed) = (corners[odd], corners[other]);
            for _ in 0..HALVED {
                let middle = (same + changed) * 0.5;
                if is_covered(&middle) == covered {
                    same = middle;
                } else {
                    changed = middle;
                }
            }
            (other, (same + changed) * 0.5)
        })
        .collect();
    let mut tip = *corners;
    for (other, end) in &ends {
        tip[*other] = *end;
    }
    // What is left is a segment, or two triangles.
    let mut parts = vec![tip];
    let mut rest = *corners;
    for (other, end) in &ends {
        rest[odd] = *end;
        parts.push(rest);
        rest[*other] = *end;
    }
    parts
}

/// Middles of the equal pieces of a segment or a triangle.
fn middles<const D: usize>(corners: &[Vector<D>; D]) -> Vec<Vector<D>> {
    let pieces = PIECES[usize::from(D > 2)];
    let step = 1.0 / pieces as f64;
    let u = (corners[1] - corners[0]) * step;
    if D == 2 {
        return (0..pieces)
            .map(|i| corners[0] + u * (i as f64 + 0.5))
            .collect();
    }
    let v = (corners[D - 1] - corners[0]) * step;
    let third = 1.0 / 3.0;
    let mut all = Vec::new();
    for i in 0..pieces {
        for j in 0..pieces - i {
            let at = |a: f64, b: f64| corners[0] + u * (i as f64 + a) + v * (j as f64 + b);
            all.push(at(third, third));
            if i + j + 1 < pieces {
                all.push(at(2.0 * third, 2.0 * third));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed, Placement, Shape, bodies};

    use super::super::Panels;
    use super::*;
    use crate::problem::Side;
    use crate::tests::{WALL, cube, slip_body};

    /// What the domain holds of the panels of `owner` with normals along `way`: areas in front of gas, and covered.
    fn areas<const D: usize>(problem: &Problem<D>, owner: u32, way: [f64; D]) -> [f64; 2] {
        let way = Vector::from(way);
        let panels = Panels::new(problem);
        let own = (panels.all().iter())
            .filter(|panel| problem.domain.bounds.contains(&panel.centre))
            .filter(|panel| panel.owner == owner && panel.normal.dot(&way) > 0.999);
        own.fold([0.0; 2], |mut areas, panel| {
            areas[usize::from(panel.is_covered)] += panel.size;
            areas
        })
    }

    /// Blocks of these widths and heights with the middles of their lower sides at these places, in a box 3 m wide with walls.
    fn with_blocks(blocks: &[([f64; 2], [f64; 2])]) -> Problem<2> {
        let mut problem = cube::<2>(30, WALL);
        for ([width, height], [x, low]) in blocks {
            let block = bodies::rectangle(*width, *height, 0.0).expect("a block");
            let place = Placement::default().moved(Vector::<2>::new(*x, low + 0.5 * height));
            let placed: Arc<dyn Shape<2>> = Arc::new(Placed::new(block, place));
            problem.bodies.push(slip_body(placed));
        }
        problem
    }

    fn assert_areas(found: [f64; 2], expected: [f64; 2], slack: f64) {
        let off = (0..2).map(|k| (found[k] - expected[k]).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < slack, "{found:?} in place of {expected:?}");
    }

    #[test]
    fn a_block_on_a_wall_covers_what_it_stands_on_and_no_more() {
        let problem = with_blocks(&[([0.433, 0.377], [1.217, 0.0])]);
        assert_areas(areas(&problem, 0, [0.0, -1.0]), [0.0, 0.433], 1e-9);
        assert_areas(areas(&problem, 0, [0.0, 1.0]), [0.433, 0.0], 1e-9);
        assert_areas(areas(&problem, 0, [1.0, 0.0]), [0.377, 0.0], 1e-9);
        // The floor comes after the body and the sides across x.
        assert_areas(areas(&problem, 3, [0.0, 1.0]), [3.0 - 0.433, 0.433], 1e-9);
    }

    /// Of which cells would be slivers.
    #[test]
    fn no_gas_fits_into_a_gap_of_a_fifth_of_a_spacing() {
        for (low, shown) in [(0.02, 0.0), (0.04, 0.433)] {
            let problem = with_blocks(&[([0.433, 0.377], [1.217, low])]);
            let covered = 0.433 - shown;
            assert_areas(areas(&problem, 0, [0.0, -1.0]), [shown, covered], 1e-9);
        }
    }

    #[test]
    fn where_blocks_are_flush_their_surface_is_the_first_ones() {
        let problem = with_blocks(&[([0.433, 0.4], [1.217, 1.0]), ([1.0, 0.4], [1.5, 1.0])]);
        assert_areas(areas(&problem, 0, [0.0, 1.0]), [0.433, 0.0], 1e-9);
        assert_areas(areas(&problem, 1, [0.0, 1.0]), [1.0 - 0.433, 0.433], 1e-6);
        // The first one's sides lie in the other.
        for side in [-1.0, 1.0] {
            let shown = areas(&problem, 0, [side, 0.0])[0];
            assert!(shown.abs() < 1e-6, "{shown}");
        }
    }

    /// Of which nothing is on the lattice, nor along the edges of the plate's panels.
    #[test]
    fn a_post_through_a_plate_covers_its_own_section_of_it() {
        let mut problem = cube::<3>(20, Side::FreeStream);
        let plate = bodies::cuboid([1.33, 1.27, 0.31]).expect("a plate");
        let post = bodies::cuboid([0.413, 0.377, 1.0]).expect("a post");
        let at = Placement::default().moved(Vector::<3>::new(1.013, 0.987, 1.021));
        let up = Vector::<3>::new(0.0, 0.0, 1.0);
        let turned = Placement::default()
            .rotated_about(&up, 0.4)
            .expect("a turn");
        let beside = turned.moved(Vector::<3>::new(1.1, 1.0, 1.0));
        problem.bodies = vec![
            slip_body(Arc::new(Placed::new(plate, at))),
            slip_body(Arc::new(Placed::new(post, beside))),
        ];
        let (all, section) = (1.33 * 1.27, 0.413 * 0.377);
        for way in [1.0, -1.0] {
            let [shown, _] = areas(&problem, 0, [0.0, 0.0, way]);
            assert!((shown - (all - section)).abs() < 1e-2 * section, "{shown}");
        }
        let side = (0.4_f64.sin(), 0.4_f64.cos());
        let [shown, _] = areas(&problem, 1, [-side.0, side.1, 0.0]);
        let expected = 0.413 * (1.0 - 0.31);
        assert!((shown - expected).abs() < 1e-6, "{shown} {expected}");
    }
}
