//! The lattice on which gas starts and enters: where its rows lie. They begin at the domain's lower corner, a spacing apart, but for
//! two kinds of flow. A wall along the stream that crosses the inlet has rows in step with it, as a wall's first row lies half a
//! spacing off; between two walls they lie evenly, a little nearer or farther than a spacing, each with the mass of its share.
//! And a stream that a body parts has rows in step with its nose ([`parting`]): about a body that is its own mirror image they are, too.
//! Where two bodies part it, rows lie evenly between them and in step with both ([`apart`]).

use aero_geometry::Vector;

use super::parting::{apart, parting};
use crate::layers::BUFFER;
use crate::problem::Domain;
use crate::problem::Problem;

/// Rows this near to their place, in spacings, are in place: round-off of scenes.
const IN_STEP: f64 = 1e-6;

/// A wall leads along the stream where it is as high, in spacings, at the end of the buffer as at the side.
const LEVEL: f64 = 1e-3;

/// Places to look for a wall, to the spacing.
const PER_SPACING: f64 = 4.0;

/// Halvings of the place where a wall was found.
const HALVINGS: usize = 50;

/// The lattice of the gas.
#[derive(Clone, Copy, Debug)]
pub struct Rows<const D: usize> {
    corner: Vector<D>,
    /// Distance of the rows along each axis.
    pitch: Vector<D>,
    spacing: f64,
    /// Number of rows from the corner to the upper side.
    cells: [i64; D],
}

/// The gas between two walls on a line across the stream.
#[derive(Clone, Copy, Debug)]
struct Gap {
    ends: [f64; 2],
    /// True where a wall is at that end, or a side that rows are in step with.
    closed: [bool; 2],
}

impl<const D: usize> Rows<D> {
    /// Those of `problem`.
    pub fn new(problem: &Problem<D>) -> Self {
        let bounds = &problem.domain.bounds;
        let spacing = problem.resolution.lattice();
        let cells = bounds.size().map(|size| (size / spacing).round() as i64);
        let mut rows = Self {
            corner: bounds.min,
            pitch: Vector::repeat(spacing),
            spacing,
            cells: cells.into(),
        };
        let stream = inlet(problem);
        for axis in 0..D {
            if let Some(inlet) = stream.filter(|&(along, _)| along != axis)
                && let Some(gap) = gap(problem, inlet, axis)
                && (gap.closed[0] || gap.closed[1])
            {
                rows.fit(axis, bounds.max[axis], &gap);
            } else if let Some(nose) = parting(problem, axis) {
                if let Some(apart) = apart(problem, axis) {
                    rows.divide(axis, apart);
                    let [first, _] = apart;
                    rows.step_from(axis, bounds.max[axis], first);
                } else {
                    rows.step_from(axis, bounds.max[axis], nose);
                }
            }
        }
        rows
    }

    /// Puts the rows of an axis evenly between walls, or in step with the one that there is.
    fn fit(&mut self, axis: usize, upper: f64, gap: &Gap) {
        let [low, high] = gap.ends;
        if gap.closed == [true; 2] {
            self.divide(axis, gap.ends);
        }
        let wall = if gap.closed[0] { low } else { high };
        self.step_from(axis, upper, wall);
    }

    /// Lets a whole number of rows of an axis fit between two places.
    fn divide(&mut self, axis: usize, [low, high]: [f64; 2]) {
        let count = (high - low) / self.spacing;
        if (count - count.round()).abs() > IN_STEP * count.max(1.0) {
            self.pitch[axis] = (high - low) / count.round().max(1.0);
        }
    }

    /// Puts the rows of an axis half a pitch off `place`.
    fn step_from(&mut self, axis: usize, upper: f64, place: f64) {
        let pitch = self.pitch[axis];
        let steps = (place - self.corner[axis]) / pitch;
        let rest = steps - steps.round();
        if rest.abs() > IN_STEP * steps.abs().max(1.0) {
            self.corner[axis] = place - steps.ceil() * pitch;
        } else if pitch == self.spacing {
            return;
        }
        self.cells[axis] = ((upper - self.corner[axis]) / pitch).ceil() as i64;
    }

    /// Place of point `index` of the lattice after it has drifted.
    pub fn position(&self, index: &[i64; D], drift: &Vector<D>) -> Vector<D> {
        let point = |k: usize| self.corner[k] + (index[k] as f64 + 0.5) * self.pitch[k];
        Vector::from_fn(|k, _| point(k)) + drift
    }

    /// Number of rows from the corner to the upper side of an axis.
    pub fn cells(&self, axis: usize) -> i64 {
        self.cells[axis]
    }

    /// Distance of the rows along an axis.
    pub fn pitch(&self, axis: usize) -> f64 {
        self.pitch[axis]
    }

    /// What a particle stands for, over a cube of the spacing.
    pub fn share(&self) -> f64 {
        (self.pitch / self.spacing).product()
    }

    /// The nearest that rows may lie to a wall, over half the spacing.
    pub fn nearest(&self) -> f64 {
        (self.pitch.min() / self.spacing).min(1.0)
    }
}

/// Axis and end of the side that the stream enters straight through.
fn inlet<const D: usize>(problem: &Problem<D>) -> Option<(usize, usize)> {
    let velocity = &problem.free_stream.velocity;
    let along = velocity.iamax();
    let is_straight = (0..D).all(|k| k == along || velocity[k] == 0.0);
    let end = usize::from(velocity[along] < 0.0);
    let enters = problem.domain.sides[along][end].lets_in();
    (is_straight && velocity[along] != 0.0 && enters).then_some((along, end))
}

/// The widest gap between walls along `axis` where gas enters; none where walls lean or bend there, or there is no one gap.
fn gap<const D: usize>(
    problem: &Problem<D>,
    (along, end): (usize, usize),
    axis: usize,
) -> Option<Gap> {
    let Domain { bounds, sides, .. } = &problem.domain;
    let out = [-1.0, 1.0][end] * BUFFER as f64 * problem.resolution.lattice();
    let mut found: Option<Gap> = None;
    // Along the rim of the buffer, and in space at three places across it.
    let places = if D == 3 { 3 } else { 1 };
    for place in 0..places {
        for depth in [0.0, out] {
            let mut point = (bounds.min + bounds.max) * 0.5;
            for k in (0..D).filter(|&k| k != along && k != axis) {
                let part = (f64::from(place) + 0.5) / f64::from(places);
                point[k] = bounds.min[k] + part * bounds.size()[k];
            }
            point[along] = problem.domain.face(along, end) + depth;
            let gap = widest(problem, point, axis)?;
            if let Some(first) = &found {
                let step = (0..2).map(|n| (first.ends[n] - gap.ends[n]).abs());
                if step.fold(0.0, f64::max) > LEVEL * problem.resolution.lattice() {
                    return None;
                }
            }
            found.get_or_insert(gap);
        }
    }
    let mut gap = found?;
    for n in 0..2 {
        let side = sides[axis][n];
        gap.closed[n] |= gap.ends[n] == problem.domain.face(axis, n) && !side.is_open();
    }
    Some(gap)
}

/// The widest stretch outside of all bodies on the line through `point` along `axis`.
fn widest<const D: usize>(problem: &Problem<D>, point: Vector<D>, axis: usize) -> Option<Gap> {
    let bounds = &problem.domain.bounds;
    let is_solid = |x: f64| {
        let mut place = point;
        place[axis] = x;
        problem.bodies.iter().any(|body| {
            body.shape.bounds().contains(&place) && body.shape.signed_distance(&place) < 0.0
        })
    };
    let wall = |mut gas: f64, mut solid: f64| {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (gas + solid);
            *(if is_solid(middle) {
                &mut solid
            } else {
                &mut gas
            }) = middle;
        }
        gas
    };
    let count = (PER_SPACING * bounds.size()[axis] / problem.resolution.lattice()).ceil();
    let place = |n: f64| bounds.min[axis] + (n + 0.5) / count * bounds.size()[axis];
    let mut gaps: Vec<Gap> = Vec::new();
    let mut open: Option<Gap> = None;
    for n in 0..count as usize {
        let (before, here) = (place(n as f64 - 1.0), place(n as f64));
        match (is_solid(here), &mut open) {
            (false, None) => {
                let at_side = n == 0 && !is_solid(bounds.min[axis]);
                let low = if at_side {
                    bounds.min[axis]
                } else {
                    wall(here, before.max(bounds.min[axis]))
                };
                open = Some(Gap {
                    ends: [low, bounds.max[axis]],
                    closed: [!at_side, false],
                });
            }
            (true, Some(gap)) => {
                gap.ends[1] = wall(before, here);
                gap.closed[1] = true;
                gaps.extend(open.take());
            }
            _ => {}
        }
    }
    if let Some(mut gap) = open {
        if is_solid(bounds.max[axis]) {
            gap.ends[1] = wall(place(count - 1.0), bounds.max[axis]);
            gap.closed[1] = true;
        }
        gaps.push(gap);
    }
    let width = |gap: &Gap| gap.ends[1] - gap.ends[0];
    gaps.into_iter()
        .max_by(|a, b| width(a).total_cmp(&width(b)))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed, Placement, Shape, bodies};

    use super::*;
    use crate::problem::Side;

    fn tunnel(walls: &[(f64, f64)]) -> Problem<2> {
        let mut problem = crate::tests::cube::<2>(20, Side::FreeStream);
        problem.free_stream.velocity[0] = 2.0;
        problem.domain.sides[0] = [Side::Inlet, Side::Outlet];
        for &(from, to) in walls {
            let block = bodies::rectangle(20.0, to - from, 0.0).expect("a block");
            let place = Placement::default().moved(Vector::<2>::new(0.0, 0.5 * (from + to)));
            let shape: Arc<dyn Shape<2>> = Arc::new(Placed::new(block, place));
            problem.bodies.push(crate::tests::slip_body(shape));
        }
        problem
    }

    #[test]
    fn rows_lie_half_a_spacing_off_a_wall_that_crosses_the_inlet() {
        for height in [0.0, 0.02, 0.05, 0.09] {
            let rows = Rows::new(&tunnel(&[(-3.0, height)]));
            let above = (0..3)
                .map(|n| rows.position(&[0, n], &Vector::zeros())[1] - height)
                .find(|y| *y > 0.0)
                .expect("a row above");
            assert!((above - 0.05).abs() < 1e-9, "{height}: {above}");
            assert_eq!(rows.share(), 1.0);
        }
    }

    #[test]
    fn rows_between_two_walls_are_even_and_have_the_mass_of_all() {
        let rows = Rows::new(&tunnel(&[(-3.0, 0.33), (1.58, 4.0)]));
        // 12.5 spacings of 0.1 make 13 rows, or 12.
        let pitch = rows.pitch(1);
        assert!(((1.25 / pitch).round() - 1.25 / pitch).abs() < 1e-9);
        let inside = (0..20)
            .map(|n| rows.position(&[0, n], &Vector::zeros())[1])
            .filter(|y| 0.33 < *y && *y < 1.58);
        let inside: Vec<f64> = inside.collect();
        assert!((inside[0] - 0.33 - 0.5 * pitch).abs() < 1e-9);
        assert!((inside.len() as f64 * rows.share() * 0.1 - 1.25).abs() < 1e-9);
    }

    #[test]
    fn without_walls_rows_begin_at_the_corner() {
        let rows = Rows::new(&tunnel(&[]));
        let first = rows.position(&[0, 0], &Vector::zeros());
        assert_eq!(first, Vector::<2>::repeat(0.05));
    }
}
