//! Heat into the nose of a hemisphere.

use aero_solver::frame::PanelFrame;
use aero_validation::exact::fay_riddell::Nose;
use aero_validation::table::{Check, Subject};

use super::{GAMMA, GAS_CONSTANT, NAME};
use crate::compare::context::{CompareError, Context};
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
/// Degrees around the nose that are read: over them the heat falls by a few parts in a hundred, its mean by one.
const CAP: f64 = 10.0;
/// Per cent.
const ALLOWED: f64 = 10.0;

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for (cells, refine, is_judged) in [(256, 2, false), (512, 3, true)] {
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

/// Mean heat into the wall around the nose; cut cells scatter it by a tenth from panel to panel.
fn heat(panels: &PanelFrame) -> f64 {
    let corners = panels.corners.max(1);
    let around = (0..panels.body.len()).filter(|&n| {
        let own = &panels.points[n * corners..(n + 1) * corners];
        let middle = |axis: usize| own.iter().map(|at| at[axis]).sum::<f64>();
        middle(1).atan2(-middle(0)).abs().to_degrees() < CAP
    });
    let (heat, area) = around.fold((0.0, 0.0), |(heat, area), n| {
        let own = panels.area[n];
        (heat - panels.heat_flux[n] * own, area + own)
    });
    heat / area
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Panels of a degree each around the nose, as large as their rings: the inner five take 80, the outer five 100, all others give heat.
    #[test]
    fn heat_is_the_mean_over_the_rings_around_the_nose() {
        let mut panels = PanelFrame {
            corners: 2,
            ..PanelFrame::default()
        };
        for k in 0..90 {
            let at = |degrees: f64| {
                let (sin, cos) = degrees.to_radians().sin_cos();
                [-0.1 * cos, 0.1 * sin, 0.0]
            };
            let from = f64::from(k);
            panels.points.extend([at(from), at(from + 1.0)]);
            panels.area.push((from + 0.5).to_radians().sin());
            let taken = if k < 5 { 80.0 } else { 100.0 };
            panels.heat_flux.push(if k < 10 { -taken } else { 1e6 });
            panels.body.push(0);
        }
        // The inner half of the degrees has a quarter of the area.
        assert!((heat(&panels) - 95.0).abs() < 0.05, "{}", heat(&panels));
    }
}
