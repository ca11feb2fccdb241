//! Heat into the nose of a hemisphere.

use aero_solver::frame::PanelFrame;
use aero_validation::exact::fay_riddell::Nose;
use aero_validation::table::{Check, Subject};

use super::{GAMMA, GAS_CONSTANT, NAME};
use crate::compare::context::{CompareError, Context};
use crate::compare::profiles::median;
use crate::compare::scenes::{Source, scene};

const SCENE: Source = scene!("hemisphere-viscous");
const SOURCE: &str = "Fay & Riddell 1958, eq. 63";
/// As in the scene.
const NOSE: Nose = Nose {
    radius: 0.1,
    mach: 6.0,
    temperature: 220.0,
    pressure: 50.969,
    wall: 300.0,
    gas_constant: GAS_CONSTANT,
    gamma: GAMMA,
    prandtl: 0.72,
};
/// Degrees around the nose that are read; heat falls there by less than a part in a hundred.
const CAP: f64 = 6.0;
/// Per cent.
const ALLOWED: f64 = 10.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for (cells, refine, is_judged) in [(256, 4, false), (512, 5, true)] {
        let what = format!(
            "hemisphere, M 6, Re_R 1e4, 300 K, {cells} cells to the radius: heat into the nose, W/m^2"
        );
        let subject = Subject::new(NAME, &what, SOURCE);
        let attempt = SCENE.attempt(&[format!("scheme.refine={refine}")], context)?;
        let exact = NOSE.heat_flux();
        checks.push(match attempt.outcome() {
            None => subject.unmeasured(exact),
            Some(outcome) if is_judged => subject.relative(heat(&outcome.panels), exact, ALLOWED),
            Some(outcome) => subject.informs(heat(&outcome.panels), exact),
        });
    }
    Ok(checks)
}

/// Heat into the wall around the nose: the middle value of the panels there.
fn heat(panels: &PanelFrame) -> f64 {
    let corners = panels.corners.max(1);
    let around = (0..panels.body.len()).filter(|&n| {
        let own = &panels.points[n * corners..(n + 1) * corners];
        let middle = |axis: usize| own.iter().map(|at| at[axis]).sum::<f64>();
        middle(1).atan2(-middle(0)).abs().to_degrees() < CAP
    });
    median(around.map(|n| -panels.heat_flux[n]))
}
