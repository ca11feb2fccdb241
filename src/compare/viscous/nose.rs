//! Heat into the nose of a hemisphere.

use aero_solver::frame::PanelFrame;
use aero_validation::exact::fay_riddell::{HotNose, Nose};
use aero_validation::exact::hot_air::HotAir;
use aero_validation::metrics::nose::at_nose;
use aero_validation::table::{Check, Subject};

use super::{GAMMA, GAS_CONSTANT, NAME};
use crate::context::{CompareError, Context};
use crate::real_gas::at_60_km;
use crate::scenes::{Source, scene};

const SCENE: Source = scene!("hemisphere-viscous");
const HOT: Source = scene!("hemisphere-viscous-hot");
/// A sphere that gas slides along: how fast it goes away from the nose.
const SMOOTH: Source = scene!("sphere-axisymmetric");
const SOURCE: &str = "Fay & Riddell 1958, eq. 63, with the velocity gradient of a slip wall";
const LEES: &str = "Lees 1956";
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
/// m/s.
const HOT_SPEEDS: [f64; 2] = [3000.0, 5000.0];
const HOT_SOURCE: &str =
    "Fay & Riddell 1958, eq. 63, Lewis number of one, with the pressure on the nose itself";
/// Per cent.
const HOT_ALLOWED: f64 = 10.0;
/// Degrees around the nose that heat and pressure are fitted over.
const CAP: f64 = 30.0;
const SMALL_CAP: f64 = 23.0;
/// Degrees from the nose at which heat is looked at as well, and around there.
const ASIDE: f64 = 45.0;
const AROUND: f64 = 3.0;
/// Per cent, by halvings of the spacing: of the heat into the nose, and of that aside over it.
const RUNS: [(u32, f64, f64); 3] = [(1, 10.0, 20.0), (2, 10.0, 12.0), (3, 4.0, 8.0)];

pub(super) fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let smooth = [
        "free_stream.mach=6.0".to_owned(),
        "spacing=0.0078125".to_owned(),
    ];
    let attempt = SMOOTH.attempt(&smooth, context)?;
    let outcome = attempt.outcome();
    let bend = outcome.and_then(|outcome| Around::new(&outcome.panels).pressure());
    let exact = bend.map_or_else(|| NOSE.heat_flux(), |bend| NOSE.heat_flux_where(bend));
    let part = NOSE.part_at(ASIDE.to_radians());
    let mut checks = Vec::new();
    let mut heats = Vec::new();
    for (refine, allowed, allowed_aside) in RUNS {
        let cells = 64 << refine;
        let label = format!("hemisphere, M 6, Re_R 1e4, 300 K, {cells} cells to the radius: heat");
        let names = [
            format!("{label} into the nose, W/m^2"),
            format!("{label} {ASIDE} degrees off the nose over that"),
        ];
        let [nose, aside] = [(&names[0], SOURCE), (&names[1], LEES)]
            .map(|(what, source)| Subject::new(NAME, what, source));
        let attempt = SCENE.attempt(&[format!("scheme.refine={refine}")], context)?;
        let found = attempt
            .outcome()
            .and_then(|outcome| Around::new(&outcome.panels).heat());
        let Some([heat, beside]) = found else {
            checks.extend([nose.unmeasured(exact), aside.unmeasured(part)]);
            continue;
        };
        heats.push(heat);
        checks.extend([
            nose.relative(heat, exact, allowed),
            aside.relative(beside / heat, part, allowed_aside),
        ]);
    }
    if let [coarse, middle, fine] = heats[..] {
        // Against the source it passes through zero, at what that is off itself.
        let what = "hemisphere, M 6: change of the heat into the nose from 256 to 512 cells over that from 128 to 256";
        let change = (fine - middle).abs() / (middle - coarse).abs();
        checks.push(Subject::new(NAME, what, "itself").at_most(change, 0.5));
    }
    for speed in HOT_SPEEDS {
        checks.push(hot(speed, context)?);
    }
    Ok(checks)
}

/// Heat into the nose in air that comes apart, at this speed.
fn hot(speed: f64, context: &Context<'_>) -> Result<Check, CompareError> {
    let nose = HotNose {
        air: HotAir::Reacting,
        radius: NOSE.radius,
        ahead: at_60_km()?,
        speed,
        wall: 1000.0,
        prandtl: 0.71,
    };
    let attempt = HOT.attempt(&[format!("free_stream.speed={speed:?}")], context)?;
    let around = attempt
        .outcome()
        .map(|outcome| Around::new(&outcome.panels));
    let found = around.and_then(|around| Some((around.heat()?[0], around.pressure()?)));
    let what = format!(
        "hemisphere, equilibrium-air, {speed} m/s at 60 km, wall 1000 K, 160 cells to the radius: heat into the nose, W/m^2"
    );
    let subject = Subject::new(NAME, &what, HOT_SOURCE);
    Ok(match found {
        Some((heat, bend)) => subject.relative(heat, nose.heat_flux_where(bend)?, HOT_ALLOWED),
        None => subject.unmeasured(f64::NAN),
    })
}

/// Panels of a sphere by their angles from the nose.
struct Around<'a> {
    panels: &'a PanelFrame,
    /// Radians.
    angles: Vec<f64>,
}

impl<'a> Around<'a> {
    fn new(panels: &'a PanelFrame) -> Self {
        let corners = panels.corners.max(1);
        let angle = |n: usize| {
            let own = &panels.points[n * corners..(n + 1) * corners];
            let sum = |axis: usize| own.iter().map(|at| at[axis]).sum::<f64>();
            sum(1).atan2(-sum(0)).abs()
        };
        let angles = (0..panels.body.len()).map(angle).collect();
        Self { panels, angles }
    }

    /// How the pressure falls off the nose, see [`Nose::heat_flux_where`].
    fn pressure(&self) -> Option<f64> {
        let reach = SMALL_CAP.to_radians();
        let nose = at_nose(&self.angles, &self.panels.pressure, reach).ok()?;
        Some(nose.bend)
    }

    /// Heat into the nose, and its mean aside.
    fn heat(&self) -> Option<[f64; 2]> {
        let into: Vec<f64> = self.panels.heat.flux.iter().map(|flux| -flux).collect();
        let nose = at_nose(&self.angles, &into, CAP.to_radians()).ok()?;
        let is_aside = |angle: f64| (angle.to_degrees() - ASIDE).abs() < AROUND;
        let pairs = self.angles.iter().zip(&into);
        let aside: Vec<f64> = pairs
            .filter(|(angle, _)| is_aside(**angle))
            .map(|(_, heat)| *heat)
            .collect();
        let mean = aside.iter().sum::<f64>() / aside.len() as f64;
        mean.is_finite().then_some([nose.value, mean])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Panels of a degree each around the nose: what they take falls as the square of the angle, and what they are pressed with twice as fast.
    #[test]
    fn heat_is_read_at_the_nose_and_aside() {
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
            let square = (from + 0.5).to_radians().powi(2);
            panels.heat.flux.push(-80.0 * (1.0 - 0.6 * square));
            panels.pressure.push(3.0 * (1.0 - 1.2 * square));
            panels.body.push(0);
        }
        let around = Around::new(&panels);
        let [heat, aside] = around.heat().unwrap();
        assert!((heat - 80.0).abs() < 1e-6, "{heat}");
        let expected = 80.0 * (1.0 - 0.6 * 45_f64.to_radians().powi(2));
        assert!((aside - expected).abs() < 0.05, "{aside} {expected}");
        assert!((around.pressure().unwrap() - 1.2).abs() < 1e-6);
    }
}
