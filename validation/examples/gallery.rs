//! Draws one picture of every kind from exact solutions, to look at the look:
//! `cargo run --release -p aero-validation --example gallery -- out`.

use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::exact::sod_tube::ClosedTube;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::pictures::speed::{SpeedChart, SpeedPoint, SpeedSeries, peers};
use aero_validation::reference;
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out".to_owned()));
    std::fs::create_dir_all(&folder)?;
    wedge(&folder)?;
    sod(&folder)?;
    history(&folder)?;
    speed(&folder)?;
    Ok(())
}

/// The Mach 2.5, 20 degree wedge on a lattice squeezed behind a smeared shock.
fn wedge(folder: &Path) -> Result<(), Box<dyn Error>> {
    let (ramp, spacing) = (20_f64.to_radians(), 1.0 / 16.0);
    let shock = oblique_shock(2.5, ramp, 1.4, Strength::Weak)?;
    let (mut position, mut value, mut diameter) = (Vec::new(), Vec::new(), Vec::new());
    for (apart, dense) in [
        (spacing, false),
        (spacing / shock.density_ratio.sqrt(), true),
    ] {
        for i in 0..(4.0 / apart) as usize {
            for j in 0..(3.0 / apart) as usize {
                let (x, y) = ((i as f64 + 0.5) * apart - 1.0, (j as f64 + 0.5) * apart);
                let depth = x * shock.angle.sin() - y * shock.angle.cos();
                if (depth > 0.0) == dense && y > (x * ramp.tan()).max(0.0) {
                    let share = 0.5 * (1.0 + (depth / spacing).tanh());
                    position.push([x, y, 0.0]);
                    value.push(1.0 + share * (shock.density_ratio - 1.0));
                    diameter.push(apart);
                }
            }
        }
    }
    let title = "Wedge, Mach 2.5, 20°, Δx = 1/16, t = 10";
    let mut picture = ParticlePicture::new(title, &position, &diameter, &value, "density ρ/ρ₁");
    let end = [3.0, 3.0 * shock.angle.tan()];
    picture
        .overlays
        .push(Overlay::theory("theory, β = 42.89°", vec![[0.0, 0.0], end]));
    let wall = vec![[-1.0, 0.0], [0.0, 0.0], [3.0, 3.0 * ramp.tan()]];
    picture.overlays.push(Overlay::outline(wall));
    picture.save(&folder.join("wedge.png"))?;
    Ok(())
}

/// The reflecting Sod tube at t = 0.375 with made-up scatter.
fn sod(folder: &Path) -> Result<(), Box<dyn Error>> {
    let tube = ClosedTube::sod()?;
    let x: Vec<f64> = (0..500).map(|k| (f64::from(k) + 0.5) / 500.0).collect();
    let panel = |label: &str, pick: &dyn Fn(f64) -> f64| {
        let values: Vec<f64> = x
            .iter()
            .map(|x| pick(*x) + 0.01 * (200.0 * x).sin())
            .collect();
        let series = vec![
            Series::particles("particles", &x, &values),
            Series::exact([0.0, 1.0], 2000, pick),
        ];
        Panel::new("x", label, series)
    };
    let state = |x: f64| tube.at(x, 0.375).unwrap_or(tube.reflected());
    let picture = Curves {
        title: "Reflecting Sod tube, t = 0.375".to_owned(),
        panels: vec![
            panel("density ρ", &|x| state(x).density),
            panel("velocity u", &|x| state(x).velocity),
            panel("pressure p", &|x| state(x).pressure),
            panel("internal energy e", &|x| state(x).energy(1.4)),
        ],
        columns: 2,
    };
    picture.save(&folder.join("sod.png"))?;
    Ok(())
}

/// Published forces on the rotating square.
fn history(folder: &Path) -> Result<(), Box<dyn Error>> {
    let table = reference::rotating_square();
    let time = table.column("t_ms")?;
    let series = |name: &str, column: &str, style| -> Result<Series, Box<dyn Error>> {
        let values = table.column(column)?;
        let points = time.iter().zip(values).map(|(t, v)| [*t, *v]).collect();
        Ok(Series::new(name, style, points))
    };
    let panel = Panel::new(
        "time, ms",
        "force, N/m",
        vec![
            series("Fx, Eilmer", "Fx_N_per_m", Style::Line)?,
            series("Fy, Eilmer", "Fy_N_per_m", Style::Dashed)?,
        ],
    );
    Curves::single("Rotating square, Mach 5.95", panel).save(&folder.join("history.png"))?;
    Ok(())
}

/// Peers of the wedge and a made-up variant.
fn speed(folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut series = peers(&reference::wedge_peers(), "density_l1_percent")?;
    let runs = [("1/8", 2.1, 4.0), ("1/16", 14.0, 2.2), ("1/32", 110.0, 1.2)];
    let own = runs.map(|(label, cpu_seconds, error)| SpeedPoint {
        label: label.to_owned(),
        cpu_seconds,
        error,
    });
    series.insert(
        0,
        SpeedSeries {
            name: "made-up variant".to_owned(),
            peer: false,
            points: own.to_vec(),
        },
    );
    let chart = SpeedChart {
        title: "Wedge, Mach 2.5, 20°: accuracy against cost".to_owned(),
        error_label: "L1 density error, %".to_owned(),
        series,
    };
    chart.save(&folder.join("speed.svg"))?;
    chart.save(&folder.join("speed.png"))?;
    chart.save_csv(&folder.join("speed.csv"))?;
    Ok(())
}
