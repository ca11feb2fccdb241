//! The cases that are charted, each with the error that tells most about it.

use aero_validation::exact::cone::cone_flow;
use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::exact::shock_expansion::Biconvex;
use aero_validation::exact::sod_tube::ClosedTube;
use aero_validation::pictures::speed::peers;
use aero_validation::reference::wedge_peers;

use super::{Study, pysph, unread};
use aero::run::Outcome;
use aero_compare::{CompareError, biconvex, cone, cylinder, double_mach, sod, sphere, wedge};

const GAMMA: f64 = 1.4;

pub(super) fn all() -> [Study; 7] {
    [
        Study {
            scene: wedge::SCENE,
            title: "Compression corner, Mach 2.5, 20°: accuracy against cost",
            error: "density error, mean over the flow / mean density, %",
            unit: "1",
            cells: [&[8, 12, 16, 24], &[32, 48]],
            shifted: false,
            // The gas crosses the box in 1.6.
            settles_in: Some(2.5),
            settings: |cells| vec![format!("spacing={}", 1.0 / f64::from(cells))],
            measure: wedge_density,
            peers: |series, costs| {
                let mut lines = peers(&wedge_peers(), "density_l1_percent").unwrap_or_default();
                lines.extend(pysph::line(series, costs));
                lines
            },
        },
        Study {
            scene: sod::SCENE,
            title: "Reflecting shock tube, ten particles across: accuracy against cost",
            error: "density error, mean over the particles",
            unit: "1",
            cells: [&[100, 200, 300, 400], &[500, 800]],
            shifted: false,
            settles_in: None,
            settings: |cells| {
                let spacing = 1.0 / f64::from(cells);
                vec![
                    format!("spacing={spacing}"),
                    format!("domain.max=[1.0, {:?}]", 10.0 * spacing),
                ]
            },
            measure: |outcome, _| sod::density_error(outcome, &ClosedTube::sod()?),
            peers: |_, _| Vec::new(),
        },
        Study {
            scene: cylinder::SCENE,
            title: "Cylinder, Mach 10: accuracy against cost",
            error: "nose pressure, mean departure / stagnation pressure, %",
            unit: "R",
            cells: [&[10, 14, 20, 28], &[40, 56]],
            shifted: false,
            // The stream passes ten radii, by which the nose has long settled.
            settles_in: Some(1.0),
            settings: |cells| vec![format!("spacing={}", 1.0 / f64::from(cells))],
            measure: |outcome, _| Ok(100.0 * cylinder::wall_departure(outcome)),
            peers: |_, _| Vec::new(),
        },
        Study {
            scene: biconvex::SCENE,
            title: "Biconvex aerofoil, Mach 4.04: accuracy against cost",
            error: "pressure coefficient, mean departure / mean size, %",
            unit: "c",
            cells: [&[40, 56, 80, 112], &[160]],
            shifted: false,
            // It passes two chords.
            settles_in: Some(0.5),
            settings: |cells| {
                let spacing = 1.0 / f64::from(cells);
                vec![
                    format!("spacing={spacing}"),
                    format!("body.aerofoil.spacing={}", 0.5 * spacing),
                ]
            },
            measure: |outcome, _| {
                let theory = Biconvex::new(biconvex::THICKNESS, biconvex::MACH, GAMMA)?;
                let (departure, scale) = biconvex::departure(outcome, &theory)?;
                Ok(100.0 * departure / scale)
            },
            peers: |_, _| Vec::new(),
        },
        Study {
            scene: cone::SCENE,
            title: "Cone of 20°, Mach 3, about its axis: accuracy against cost",
            error: "surface pressure, mean departure / theory, %",
            unit: "1",
            cells: [&[25, 35, 50, 70], &[100, 140]],
            shifted: true,
            // It crosses the box one and a half times.
            settles_in: Some(0.75),
            settings: |cells| vec![format!("spacing={}", 1.0 / f64::from(cells))],
            measure: cone_pressure,
            peers: |_, _| Vec::new(),
        },
        sphere_in_space(),
        double_mach_reflection(),
    ]
}

fn sphere_in_space() -> Study {
    Study {
        scene: sphere::SCENE,
        title: "Sphere, Mach 3, a quarter in space: accuracy against cost",
        error: "nose pressure, departure / stagnation pressure, %",
        unit: "R",
        cells: [&[6, 8, 12], &[16, 20]],
        shifted: false,
        // It crosses the box one and a half times.
        settles_in: Some(1.5),
        settings: |cells| vec![format!("spacing={}", 1.0 / f64::from(cells))],
        measure: |outcome, _| Ok(100.0 * sphere::nose_departure(outcome)?),
        peers: |_, _| Vec::new(),
    }
}

fn double_mach_reflection() -> Study {
    Study {
        scene: double_mach::SCENE,
        title: "Double Mach reflection: accuracy against cost",
        error: "places of stem and triple point, mean distance",
        unit: "1",
        cells: [&[20, 28, 40], &[56, 80]],
        shifted: false,
        settles_in: None,
        settings: |cells| vec![format!("spacing={}", 1.0 / f64::from(cells))],
        measure: double_mach::displacement,
        peers: |_, _| Vec::new(),
    }
}

/// Departure of the density from oblique shock theory, over the area of the flow, as the peers have it:
/// per cent of the mean density.
fn wedge_density(outcome: &Outcome, _: u32) -> Result<f64, CompareError> {
    /// Mach number and angle of the scene, which the peers have too.
    const FLOW: (f64, f64) = (2.5, 20.0);
    let shock = oblique_shock(FLOW.0, FLOW.1.to_radians(), GAMMA, Strength::Weak)?;
    let gas = &outcome.gas;
    let (mut departure, mut scale) = (0.0, 0.0);
    for ((place, density), volume) in gas.position.iter().zip(&gas.density).zip(&gas.volume) {
        let behind = place[0] > 0.0 && place[1] < place[0] * shock.angle.tan();
        let exact = if behind { shock.density_ratio } else { 1.0 };
        departure += (density - exact).abs() * volume;
        scale += exact * volume;
    }
    if scale == 0.0 {
        return Err(unread("gas particles"));
    }
    Ok(100.0 * departure / scale)
}

/// Mean departure of the surface pressure from Taylor and Maccoll, per cent.
fn cone_pressure(outcome: &Outcome, _: u32) -> Result<f64, CompareError> {
    let theory = cone_flow(cone::MACH, cone::HALF_ANGLE.to_radians(), GAMMA)?;
    let departures: Vec<f64> = cone::surface_pressures(outcome)
        .map(|pressure| (GAMMA * pressure / theory.pressure_ratio - 1.0).abs())
        .collect();
    if departures.is_empty() {
        return Err(unread("points of the surface"));
    }
    Ok(100.0 * departures.iter().sum::<f64>() / departures.len() as f64)
}
