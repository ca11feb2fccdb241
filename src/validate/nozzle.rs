//! The convergent-divergent nozzle against finite volumes and quasi-one-dimensional theory: Mach number
//! on the centre line, mass flow from section to section.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_validation::exact::nozzle::{BackNozzle, Section};
use aero_validation::metrics::MetricError;
use aero_validation::metrics::gradient::Cloud;
use aero_validation::metrics::interpolate::Sampler;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::{Overlay, ParticlePicture};
use aero_validation::reference::{Table, nozzle_centre_line};
use aero_validation::table::{Check, Subject};

use super::outcome::{Keep, Outcome, Source, run_keeping};
use super::{Context, Level, ValidateError};
use aero_solver::frame::{Frame, Kind};

const SCENE: Source = Source {
    name: "nozzle",
    text: include_str!("../../cases/nozzle.toml"),
};
const VOLUMES: &str = "finite volumes, second order (validation/nozzle)";
const THEORY: &str = "quasi-one-dimensional flow (NACA 1135, 1953, eq. 80)";
const GAMMA: f64 = 1.4;
/// Metres.
const INCH: f64 = 0.0254;
/// Half-height of the inlet, inches.
const INLET: f64 = 1.5955;
/// Mass flux of the free stream, kg/(s m^2): 230 412 Pa at 300 K and this Mach number.
const FLUX: f64 = 275.13;
/// Part of the nozzle that is judged, inches: the centre line of the reference bends where the
/// compression from the end of the throat's arc arrives.
const JUDGED: [f64; 2] = [-2.75, 2.5];

/// One run of the scene.
#[derive(Clone, Copy, Debug)]
struct Variant {
    /// Cells per half-height of the inlet.
    cells: u32,
    end_time: f64,
    equations: &'static str,
    extrapolation: &'static str,
    /// Largest error of the mass flow, and of the Mach number in the mean and anywhere, per cent; none
    /// where the scheme is shown for comparison.
    allowed: Option<[f64; 3]>,
    level: Level,
}

const PUBLISHED: Variant = Variant {
    cells: 30,
    end_time: 4e-3,
    equations: "conservative",
    extrapolation: "wom",
    allowed: Some([1.0, 2.0, 2.0]),
    level: Level::Full,
};

const VARIANTS: [Variant; 5] = [
    // What this resolution gives anywhere, with a margin.
    Variant {
        allowed: Some([1.0, 2.0, 5.0]),
        level: Level::Quick,
        ..PUBLISHED
    },
    PUBLISHED,
    Variant {
        extrapolation: "wm",
        ..PUBLISHED
    },
    Variant {
        cells: 60,
        ..PUBLISHED
    },
    Variant {
        equations: "paper",
        allowed: None,
        ..PUBLISHED
    },
];

/// Runs the variants and compares Mach number and mass flow.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, ValidateError> {
    let keep = Keep {
        frames: true,
        ..Keep::default()
    };
    let mut checks = Vec::new();
    for variant in VARIANTS.iter().filter(|v| v.level == context.level) {
        let outcome = run_keeping(keep, SCENE, &variant.settings(), context)?;
        let stations = stations(&outcome.history.frames).map_err(|error| SCENE.unread(error))?;
        checks.extend(variant.checks(&stations, &outcome)?);
        variant.pictures(&stations, &outcome, context)?;
    }
    Ok(checks)
}

/// A section of the nozzle, means over the frames.
#[derive(Clone, Copy, Debug, Default)]
struct Station {
    /// Place, inches from the throat.
    x: f64,
    /// Mach number on the centre line.
    centre: f64,
    /// Mach number, mean over the section.
    mean: f64,
    /// Mass flow through the half duct per metre of width, over that of the free stream.
    flow: f64,
}

impl Variant {
    fn settings(&self) -> [String; 5] {
        [
            // The particles on the centre line are few; a mean over half a hundred frames tells.
            "output.frames=100".into(),
            format!("spacing={}", INLET * INCH / f64::from(self.cells)),
            format!("end_time={:?}", self.end_time),
            format!("scheme.equations={}", self.equations),
            format!("scheme.extrapolation={}", self.extrapolation),
        ]
    }

    fn label(&self) -> String {
        let Self {
            cells,
            equations,
            extrapolation,
            ..
        } = self;
        format!("dx R/{cells}, {equations} {extrapolation}")
    }

    fn checks(&self, stations: &[Station], outcome: &Outcome) -> Result<Vec<Check>, ValidateError> {
        let label = self.label();
        let names = [
            "mass flow, largest departure from its mean",
            "mass flow / one-dimensional",
            "Mach number on the centre line, mean departure",
            "Mach number on the centre line, largest departure",
            "Mach number at the exit, mean over the section",
            "particles in the wall",
        ]
        .map(|name| format!("{label}: {name}"));
        let row =
            |number: usize, source: &'static str| Subject::new(SCENE.name, &names[number], source);
        let judged: Vec<&Station> = stations
            .iter()
            .filter(|s| (JUDGED[0]..JUDGED[1]).contains(&s.x))
            .collect();
        let count = judged.len() as f64;
        let flow = judged.iter().map(|s| s.flow).sum::<f64>() / count;
        let unsteady = judged
            .iter()
            .map(|s| (s.flow / flow - 1.0).abs())
            .fold(0.0, f64::max);
        let table = nozzle_centre_line();
        let departures: Vec<f64> = judged
            .iter()
            .map(|s| (s.centre / reference(&table, s.x) - 1.0).abs())
            .collect();
        let mean = departures.iter().sum::<f64>() / count;
        let largest = departures.iter().copied().fold(0.0, f64::max);
        let exit = stations.last().copied().unwrap_or_default();
        let theory = BackNozzle::in_inches().mach(exit.x, Section::Planar, GAMMA)?;
        let leaked = outcome.summary.leaked as f64;
        let within = |subject: Subject<'_>, measured: f64, which: usize| match self.allowed {
            Some(allowed) => subject.absolute(measured, 0.0, allowed[which] / 100.0),
            None => subject.informs(measured, 0.0),
        };
        Ok(vec![
            within(row(0, "conservation of mass"), unsteady, 0),
            row(1, THEORY).informs(flow, 1.0),
            within(row(2, VOLUMES), mean, 1),
            within(row(3, VOLUMES), largest, 2),
            row(4, THEORY).informs(exit.mean, theory),
            match self.allowed {
                Some(_) => row(5, "no penetration").at_most(leaked, 0.0),
                None => row(5, "no penetration").informs(leaked, 0.0),
            },
        ])
    }

    /// The Mach number in the plane, along the centre line, and the mass flow.
    fn pictures(
        &self,
        stations: &[Station],
        outcome: &Outcome,
        context: &Context<'_>,
    ) -> Result<(), ValidateError> {
        let name = format!(
            "nozzle-{}-{}-{}",
            self.cells, self.equations, self.extrapolation
        );
        let title = format!("Nozzle: {}", self.label());
        let gas = &outcome.gas;
        let inches = |length: &f64| length / INCH;
        let position: Vec<[f64; 3]> = gas
            .position
            .iter()
            .map(|at| at.each_ref().map(inches))
            .collect();
        let diameter: Vec<f64> = gas
            .smoothing_length
            .iter()
            .map(|h| h / SMOOTHING_RATIO / INCH)
            .collect();
        let mut picture =
            ParticlePicture::new(&title, &position, &diameter, &gas.mach, "Mach number");
        picture.axis_labels = ["x, inches", "y, inches"];
        let shape = BackNozzle::in_inches();
        let wall = (-60..=60).map(|k| f64::from(k) / 20.0);
        picture.overlays = vec![Overlay::outline(
            wall.map(|x| [x, shape.half_height(x)]).collect(),
        )];
        picture.save(&context.out.join(format!("{name}.png")))?;

        let table = nozzle_centre_line();
        let column = |name: &str| {
            let x = table.column("x_in").unwrap_or_default();
            let y = table.column(name).unwrap_or_default();
            x.iter().zip(y).map(|(x, y)| [*x, *y]).collect::<Vec<_>>()
        };
        let centre = Panel::new(
            "x, inches",
            "Mach number on the centre line",
            vec![
                Series::new("finite volumes", Style::Line, column("M_centre")),
                Series::new("one-dimensional", Style::Dashed, column("M_q1d")),
                Series::new(
                    "particles",
                    Style::Dots,
                    stations.iter().map(|s| [s.x, s.centre]).collect(),
                ),
            ],
        );
        let mut flow = Panel::new(
            "x, inches",
            "mass flow / one-dimensional",
            vec![Series::new(
                "particles",
                Style::Dots,
                stations.iter().map(|s| [s.x, s.flow]).collect(),
            )],
        );
        flow.window = [None, Some([0.95, 1.05])];
        let curves = Curves {
            title,
            panels: vec![centre, flow],
            columns: 1,
        };
        Ok(curves.save(&context.out.join(format!("{name}-centre.png")))?)
    }
}

fn reference(table: &Table, x: f64) -> f64 {
    table.interpolate("x_in", "M_centre", x).unwrap_or(f64::NAN)
}

/// Sections an eighth of an inch apart, means over the frames.
fn stations(frames: &[Frame]) -> Result<Vec<Station>, MetricError> {
    let mut stations: Vec<Station> = (-23..=23)
        .map(|k| Station {
            x: f64::from(k) / 8.0,
            ..Station::default()
        })
        .collect();
    let share = 1.0 / frames.len() as f64;
    for frame in frames {
        add_sections(&mut stations, frame, share)?;
    }
    Ok(stations)
}

/// Adds `share` of one frame's values to the stations.
fn add_sections(stations: &mut [Station], frame: &Frame, share: f64) -> Result<(), MetricError> {
    /// Points across a section.
    const ACROSS: usize = 40;
    /// Points of the centre line, which is a few rows of particles wide: in steady flow a row keeps its
    /// own noise for ever. Inches; the Mach number varies by less than 0.3 per cent over it.
    const CORE: usize = 5;
    const CORE_HEIGHT: f64 = 0.1;
    let mut position = Vec::new();
    let (mut h, mut mach, mut flux) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..frame.kind.len() {
        if frame.kind[i] == Kind::Ghost as u8 {
            continue;
        }
        // With its image, so that the centre line lies inside.
        let [x, y, z] = frame.position[i];
        for y in [y, -y] {
            position.push([x, y, z]);
            h.push(frame.smoothing_length[i]);
            mach.push(frame.mach[i]);
            flux.push(frame.density[i] * frame.velocity[i][0] / FLUX);
        }
    }
    let volume: Vec<f64> = h.iter().map(|h| (h / SMOOTHING_RATIO).powi(2)).collect();
    let cloud = Cloud {
        position: &position,
        volume: &volume,
        smoothing_length: &h,
        dimension: 2,
    };
    let mach = Sampler::new(cloud, &mach)?;
    let flux = Sampler::new(cloud, &flux)?;
    let shape = BackNozzle::in_inches();
    for station in stations {
        let at = |y: f64| [station.x * INCH, y * INCH, 0.0];
        for k in 0..CORE {
            let y = (k as f64 + 0.5) / CORE as f64 * CORE_HEIGHT;
            let weight = share / CORE as f64;
            station.centre += weight * mach.at(&at(y)).unwrap_or(f64::NAN);
        }
        let height = shape.half_height(station.x);
        for k in 0..ACROSS {
            let y = (k as f64 + 0.5) / ACROSS as f64 * height;
            let weight = share / ACROSS as f64;
            station.mean += weight * mach.at(&at(y)).unwrap_or(f64::NAN);
            station.flow += weight * flux.at(&at(y)).unwrap_or(f64::NAN) * height / INLET;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_free_stream_is_the_one_that_chokes_the_throat() {
        /// As in the scene.
        const MACH: f64 = 0.29615;
        let mach = BackNozzle::in_inches().mach(-3.0, Section::Planar, GAMMA);
        assert!((mach.unwrap() - MACH).abs() < 1e-5);
        let sound = (GAMMA * 287.05 * 300.0_f64).sqrt();
        let flux = 230_412.0 / (287.05 * 300.0) * MACH * sound;
        assert!((flux / FLUX - 1.0).abs() < 1e-4, "{flux}");
    }
}
