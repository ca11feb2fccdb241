//! What walls are pressed with beyond what the patches of the surface that belong to them show, which the surface around shows instead: forces
//! are the integrals of what is shown.
//!
//! Cells end where planes half way between points do, surfaces where their facets do: beside an edge, at a sliver of a side or at the tip of a
//! cone the wall of a cell may be much larger than what of the surface lies nearest to its point, and that of the next cell as much smaller.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};
use nalgebra::SMatrix;

use super::walls::Wall;
use crate::panels::{Panel, Pressed};

/// What a wall is pressed with is shown no farther than this from its foot, in spacings of the lattice, which panels are as long as.
pub const REACH: f64 = 2.0;

/// Cosine below which panels face another way than a wall.
const ASKEW: f64 = 0.2;

/// Passes that find how a force is shown best: panels that face nearly alike show little of what is along them, and are not asked for more.
const PASSES: usize = 16;

/// So much of its own pressure every panel keeps: near a vacuum there may be more to take away than there is.
const KEPT: f64 = 0.1;

/// A panel in the domain and what it counts for.
pub struct Shown<'a, const D: usize> {
    /// It.
    pub panel: &'a Panel<D>,
    /// Area of all that it stands for.
    pub area: f64,
}

/// A wall and what its patch leaves.
pub struct Left<'a, const D: usize> {
    /// It.
    pub wall: &'a Wall<D>,
    /// Force over that of the stream's pressure, less what its patch shows of that.
    pub force: Vector<D>,
}

/// Adds what is `left` of each wall to the pressures of the panels around it that face as it does, in gas of this `spacing`. Returns the force
/// per area that these do not show of it: what is along them, and what they keep.
pub fn spread<const D: usize>(
    left: &[Left<'_, D>],
    shown: &[Shown<'_, D>],
    spacing: f64,
    pressed: &mut [&mut Pressed<D>],
) -> Vec<Vector<D>> {
    let reach = REACH * spacing;
    let centres: Vec<Vector<D>> = shown.iter().map(|shown| shown.panel.centre).collect();
    let feet: Vec<Vector<D>> = left.iter().map(|left| left.wall.foot).collect();
    let [by_centre, by_foot] = [&centres, &feet].map(|at| Pencils::new(at, reach));
    let share = |left: &Left<'_, D>| {
        let mut sums = SMatrix::<f64, D, D>::zeros();
        let mut weights = 0.0;
        by_centre.for_each_run_near(&left.wall.foot, &left.wall.foot, reach, |run| {
            for &n in &by_centre.order()[run] {
                let Shown { panel, area } = &shown[n as usize];
                let weight = left.weight(panel, reach) * area;
                sums += panel.normal * panel.normal.transpose() * weight;
                weights += weight;
            }
        });
        if weights <= 0.0 {
            return [Vector::zeros(); 2];
        }
        let mut share = Vector::<D>::zeros();
        for _ in 0..PASSES {
            share += (left.force - sums * share) / weights;
        }
        [share, (left.force - sums * share) / weights]
    };
    let shares: Vec<[Vector<D>; 2]> = left.par_iter().map(share).collect();
    let more = |shown: &Shown<'_, D>| {
        let (mut sum, mut rest) = (0.0, Vector::zeros());
        let panel = shown.panel;
        by_foot.for_each_run_near(&panel.centre, &panel.centre, reach, |run| {
            for &n in &by_foot.order()[run] {
                // Panels look into the gas, which presses them the other way.
                let [share, unshown] = &shares[n as usize];
                let weight = left[n as usize].weight(panel, reach);
                sum -= weight * share.dot(&panel.normal);
                rest += unshown * weight;
            }
        });
        (sum, rest)
    };
    let more: Vec<(f64, Vector<D>)> = shown.par_iter().map(more).collect();
    let each = pressed.iter_mut().zip(shown).zip(more);
    each.map(|((pressed, shown), (more, rest))| {
        let taken = more.max((KEPT - 1.0) * pressed.pressure);
        pressed.pressure += taken;
        rest + shown.panel.normal * (taken - more)
    })
    .collect()
}

impl<const D: usize> Left<'_, D> {
    /// How much of it a panel shows.
    fn weight(&self, panel: &Panel<D>, reach: f64) -> f64 {
        let facing = -panel.normal.dot(&Vector::from(self.wall.image.normal));
        if panel.owner != self.wall.owner || facing < ASKEW {
            return 0.0;
        }
        let away = (panel.centre - self.wall.foot).norm();
        facing * QuinticSpline::<D>::value(away, reach / SUPPORT)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placement, Shape, bodies};

    use super::*;
    use crate::fixed::FixedSimulation;
    use crate::fixed::tests::flows::stream;
    use crate::panels::{Panels, shown_forces};

    /// The flow around blocks of these widths and heights in these places, turned all together, that has just begun.
    fn begun(mach: f64, blocks: &[([f64; 2], [f64; 2])], turn: f64) -> FixedSimulation<2> {
        let block = |([width, height], at): &([f64; 2], [f64; 2])| -> Arc<dyn Shape<2>> {
            let block = bodies::rectangle(*width, *height, 0.0).expect("a block");
            let (sin, cos) = turn.sin_cos();
            let at = Vector::from([at[0] * cos - at[1] * sin, at[0] * sin + at[1] * cos]);
            Arc::new(block.placed(&Placement::default().rotated(turn).moved(at)))
        };
        let blocks = blocks.iter().map(block).collect();
        let problem = stream(mach, [[-1.0, -1.0], [1.0, 1.0]], 1.0 / 16.0, blocks);
        let mut flow = FixedSimulation::new(problem).expect("a flow");
        for _ in 0..16 {
            flow.step(1.0).expect("a step");
        }
        flow
    }

    /// Cells at the corners of a block that is turned, or around a plate thinner than they are, hold much more or less of its faces than lies nearest
    /// to their points.
    #[test]
    fn a_block_shows_all_that_it_is_pressed_with_whatever_its_corners_cut() {
        for (mach, height, turn, slack) in [
            (1.2, 0.4, 0.0, 1e-9),
            (1.2, 0.4, 0.3, 1e-9),
            (1.2, 0.4, 0.785, 1e-9),
            (1.2, 0.02, 0.3, 1e-9),
            // Behind it there is hardly any gas yet.
            (2.0, 0.4, 0.3, 1e-3),
        ] {
            let flow = begun(mach, &[([0.7, height], [0.0; 2])], turn);
            let force = flow.loads()[0].force;
            let shown = shown_forces(&flow.problem, &flow.panels())[0];
            for k in 0..2 {
                let off = (shown[k] - force[k]) / force[0];
                assert!(
                    off.abs() < slack,
                    "{height}, turned by {turn}: {force:?} {shown:?}"
                );
            }
        }
    }

    /// The lower face of a thin plate lies within reach of a wall of its upper one.
    #[test]
    fn panels_that_face_another_way_show_nothing_of_a_wall() {
        let flow = begun(1.2, &[([0.7, 0.02], [0.0; 2])], 0.0);
        let panels = Panels::new(&flow.problem);
        let (wall, _) = (flow.walls())
            .find(|(wall, _)| wall.image.normal[1] < -0.9)
            .expect("a wall below gas");
        let force = Vector::zeros();
        let left = Left { wall, force };
        let reach = REACH / 16.0;
        let near = (panels.all().iter()).filter(|panel| (panel.centre - wall.foot).norm() < reach);
        let (mut seen, mut unseen) = (0, 0);
        for panel in near {
            let weight = left.weight(panel, reach);
            assert_eq!(weight > 0.0, panel.normal[1] > 0.9, "{panel:?}");
            seen += usize::from(weight > 0.0);
            unseen += usize::from(weight == 0.0);
        }
        assert!(seen > 1 && unseen > 1, "{seen} {unseen}");
    }

    /// What is along a face no pressure on it shows, and what panels keep of their pressure is missing.
    #[test]
    fn what_no_pressure_shows_is_left_over() {
        let flow = begun(1.2, &[([0.7, 0.4], [0.0; 2])], 0.0);
        let panels = Panels::new(&flow.problem);
        let (wall, _) = (flow.walls())
            .find(|(wall, _)| wall.image.normal[1] < -0.9 && wall.foot[0].abs() < 0.1)
            .expect("a wall below gas");
        let shown: Vec<Shown<'_, 2>> = (panels.all().iter())
            .map(|panel| Shown {
                panel,
                area: panel.size,
            })
            .collect();
        for force in [[1e-3, 0.0], [1e-3, 2e-3], [-2e-3, 100.0]] {
            let force = Vector::from(force);
            let mut pressed = vec![Pressed::calm(1.0); shown.len()];
            let rest = spread(
                &[Left { wall, force }],
                &shown,
                1.0 / 16.0,
                &mut pressed.iter_mut().collect::<Vec<_>>(),
            );
            let mut along = 0.0;
            let mut all = Vector::<2>::zeros();
            for ((Shown { panel, area }, pressed), rest) in shown.iter().zip(&pressed).zip(&rest) {
                all += (rest - panel.normal * (pressed.pressure - 1.0)) * *area;
                along += rest[0] * area;
            }
            assert!((along - force[0]).abs() < 1e-12, "{along} {force:?}");
            assert!(
                (all - force).norm() < 1e-9 * force.norm(),
                "{all:?} {force:?}"
            );
        }
    }

    #[test]
    fn every_panel_keeps_a_tenth_of_its_pressure() {
        let flow = begun(1.2, &[([0.7, 0.4], [0.0; 2])], 0.0);
        let panels = Panels::new(&flow.problem);
        let walls = flow.walls().map(|(wall, _)| wall);
        let left: Vec<Left<'_, 2>> = walls
            .map(|wall| Left {
                wall,
                force: -wall.image.area() * 100.0,
            })
            .collect();
        let shown: Vec<Shown<'_, 2>> = (panels.all().iter())
            .map(|panel| Shown {
                panel,
                area: panel.size,
            })
            .collect();
        let mut pressed = vec![Pressed::calm(1.0); shown.len()];
        spread(
            &left,
            &shown,
            1.0 / 16.0,
            &mut pressed.iter_mut().collect::<Vec<_>>(),
        );
        let least = pressed.iter().map(|pressed| pressed.pressure);
        let least = least.fold(f64::INFINITY, f64::min);
        assert!((least - 0.1).abs() < 1e-12, "{least}");
    }

    #[test]
    fn where_one_block_stands_on_another_both_show_the_pressure_of_the_stream() {
        let flow = begun(
            1.2,
            &[([1.2, 0.4], [0.0; 2]), ([0.4, 0.4], [0.0, 0.4])],
            0.0,
        );
        let panels = flow.panels();
        let mut covered = 0;
        for (ends, pressure) in panels.points.chunks(2).zip(&panels.pressure) {
            let [x, y] = [0, 1].map(|k| 0.5 * (ends[0][k] + ends[1][k]));
            if (y - 0.2).abs() < 1e-6 && x.abs() < 0.16 {
                assert!((pressure * 1.4 - 1.0).abs() < 1e-12, "{pressure} at {x}");
                covered += 1;
            }
        }
        assert!(covered > 5, "{covered}");
    }
}
