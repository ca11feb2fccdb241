//! Where gas that has come over a step is at the wall again.

use aero_solver::frame::PanelFrame;
use aero_validation::table::{Check, Subject};

use super::NAME;
use crate::context::{CompareError, Context};
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("backward-step");
const SOURCE: &str = "measured (Armaly, Durst, Pereira & Schoenung 1983)";
/// Heights of the step behind it.
const LENGTH: f64 = 7.94;
/// Per cent.
const ALLOWED: f64 = 5.0;
/// Height of the wall behind the step, as in the scene.
const FLOOR: f64 = -1.0;
/// Nearer to the step than this the gas may turn a second time.
const CORNER: f64 = 1.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let subject = Subject::new(
        NAME,
        "step, Re 389, 16 cells to its height: reattachment / height",
        SOURCE,
    );
    let attempt = SCENE.attempt(&[], context)?;
    Ok(vec![match attempt.outcome() {
        None => subject.unmeasured(LENGTH),
        Some(outcome) => {
            let found = reattachment(&outcome.panels).unwrap_or(f64::NAN);
            subject.relative(found, LENGTH, ALLOWED)
        }
    }])
}

/// First place behind the step, beyond its corner, at which the gas stops dragging the wall back; none where it does not.
fn reattachment(panels: &PanelFrame) -> Option<f64> {
    let corners = panels.corners.max(1);
    let mut wall: Vec<[f64; 2]> = (0..panels.body.len())
        .filter_map(|n| {
            let own = &panels.points[n * corners..(n + 1) * corners];
            let middle = |axis: usize| own.iter().map(|at| at[axis]).sum::<f64>() / corners as f64;
            let is_floor = (middle(1) - FLOOR).abs() < 1e-9 && middle(0) > CORNER;
            is_floor.then(|| [middle(0), panels.friction[n][0]])
        })
        .collect();
    wall.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let pair = wall
        .windows(2)
        .find(|pair| pair[0][1] < 0.0 && pair[1][1] >= 0.0)?;
    let [[x, back], [next, on]] = [pair[0], pair[1]];
    Some(x - back * (next - x) / (on - back))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Panels of a floor, and of a lid above it, with this friction at their middles.
    fn panels(friction: impl Fn(f64) -> f64) -> PanelFrame {
        let mut panels = PanelFrame {
            corners: 2,
            ..PanelFrame::default()
        };
        // In no order along the wall.
        for k in (0..200).map(|k| k * 73 % 200) {
            let x = 0.1 * f64::from(k);
            for (height, sign) in [(FLOOR, 1.0), (1.0, -1.0)] {
                panels
                    .points
                    .extend([[x, height, 0.0], [x + 0.1, height, 0.0]]);
                panels.friction.push([sign * friction(x + 0.05), 0.0, 0.0]);
                panels.body.push(0);
            }
        }
        panels
    }

    #[test]
    fn gas_is_at_the_wall_again_where_it_drags_it_along() {
        let found = reattachment(&panels(|x| (x - 0.7) * (x - 7.94)));
        assert!((found.unwrap() - 7.94).abs() < 1e-3, "{found:?}");
        // A second bubble further on is not the first.
        let twice = reattachment(&panels(|x| {
            (x - 0.7) * (x - 7.94) * (x - 11.0) * (x - 14.0)
        }));
        assert!((twice.unwrap() - 7.94).abs() < 2e-2, "{twice:?}");
    }

    #[test]
    fn gas_that_never_leaves_the_wall_or_never_comes_back_is_told() {
        assert_eq!(reattachment(&panels(|_| 1.0)), None);
        assert_eq!(reattachment(&panels(|_| -1.0)), None);
    }
}
