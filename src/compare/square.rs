//! The swinging square at Mach 5.95 against the published forces of the Eilmer flow solver.

mod loads;

use aero::run::Keep;
use aero_validation::metrics::window::{rms_difference, statistics};
use aero_validation::pictures::particles::Overlay;
use aero_validation::reference::rotating_square;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;
use loads::{COLUMNS, Loads};

const EILMER: &str = "Eilmer example set, digitised (doi:10.1016/j.cpc.2022.108551)";
/// Half the side and the radius of the corners, m.
const HALF: f64 = 0.01;
const CORNER: f64 = 0.001;
/// Greatest angular velocity, rad/s, and period, s.
const SWING: [f64; 2] = [2000.0, 0.002];

/// What is varied beside spacing and scheme.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Spacing of the ghosts over the stream's.
    ghosts: f64,
    end_time: f64,
    shield: bool,
}

/// At the quick level half of the period, and a margin for it.
pub const SQUARE: Comparison<Setup> = Comparison {
    case: "square",
    scene: scene!("square"),
    length: 2.0 * HALF,
    keep: Keep::Loads,
    variants,
    label: |v| {
        let shield = if v.own.shield { ", shield" } else { "" };
        let ghosts = if v.own.ghosts < 1.0 {
            ""
        } else {
            ", ghosts at dx"
        };
        format!("dx a/{}, {}{shield}{ghosts}", v.cells, v.scheme)
    },
    settings: |v, spacing| {
        vec![
            format!("body.square.spacing={}", v.own.ghosts * spacing),
            format!("end_time={:?}", v.own.end_time),
            format!("scheme.shield={}", v.own.shield),
        ]
    },
    rows,
    pictures,
    together: Some(loads::draw),
};

fn variants() -> Vec<Variant<Setup>> {
    let setup = Setup {
        ghosts: 0.5,
        end_time: 2e-3,
        shield: false,
    };
    let published = Variant::new(10, setup);
    let half = Setup {
        end_time: 1e-3,
        ..setup
    };
    // As published: ghosts as far apart as the gas, and so none in the corners.
    let coarse_ghosts = published.with(Setup {
        ghosts: 1.0,
        ..setup
    });
    let shielded = Setup {
        shield: true,
        ..setup
    };
    vec![
        published.with(half).quick(),
        published,
        published.wm(),
        published.paper(),
        coarse_ghosts.shown(),
        coarse_ghosts.wm().shown(),
        published.cells(20),
        published.cells(20).wm(),
        published.cells(20).with(shielded),
    ]
}

/// Largest departures at the quick level and the full one: forces along and across the stream, moment.
const ALLOWED: [[f64; 2]; 3] = [[0.07, 0.04], [0.04, 0.03], [0.25, 0.15]];

/// Departures of the loads: of a force over the mean force along the stream, of the moment over the
/// root mean square moment.
fn rows(flow: &Flow<'_, Setup>) -> Result<Vec<Row>, CompareError> {
    let loads = Loads::new(&flow.outcome.history);
    let table = rotating_square();
    let times = table.column("t_ms").unwrap_or_default();
    let window = loads.window();
    let of_reference = |column: &str| {
        let values = table.column(column).unwrap_or_default();
        statistics(times, values, window)
    };
    let force = of_reference(COLUMNS[0][0])?.mean;
    let moment = of_reference(COLUMNS[2][0])?.rms;
    let mut rows = Vec::new();
    for (k, [column, what]) in COLUMNS.into_iter().enumerate() {
        let reference = (times, table.column(column).unwrap_or_default());
        let rms = rms_difference(&loads.time, &loads.values[k], reference, window)?;
        let (scale, over) = match k {
            2 => (moment, "rms moment"),
            _ => (force, "mean force along it"),
        };
        let quantity = format!("{what}, rms departure / {over}");
        let allowed = ALLOWED[k];
        rows.push(Row::absolute(quantity, EILMER, rms / scale, 0.0, allowed));
    }
    let mean = statistics(&loads.time, &loads.values[0], window)?.mean;
    let quantity = "mean force along the stream, N/m";
    rows.push(Row::relative(quantity, EILMER, mean, force, [6.0, 4.0]));
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// The density around the square where it ends.
fn pictures(flow: &Flow<'_, Setup>) -> Result<(), CompareError> {
    let gas = &flow.outcome.gas;
    let mut view = flow.view(
        "Swinging square, Mach 5.95",
        &gas.density,
        "density, kg/m^3",
    );
    view.unit = 1e-3;
    view.axis_labels = ["x, mm", "y, mm"];
    view.overlays = vec![Overlay::outline(outline(gas.time))];
    view.save()
}

/// The square at `time`, in millimetres.
fn outline(time: f64) -> Vec<[f64; 2]> {
    let frequency = std::f64::consts::TAU / SWING[1];
    let (sin, cos) = (SWING[0] / frequency * (frequency * time).sin()).sin_cos();
    let middle = HALF - CORNER;
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let arc = |k: usize| {
        (0..=6).map(move |step| {
            let angle = (k as f64 + f64::from(step) / 6.0) * std::f64::consts::FRAC_PI_2;
            let (x, y) = corners[k];
            [
                x * middle + CORNER * angle.cos(),
                y * middle + CORNER * angle.sin(),
            ]
        })
    };
    let mut points: Vec<[f64; 2]> = (0..corners.len()).flat_map(arc).collect();
    points.extend(points.first().copied());
    points
        .iter()
        .map(|[x, y]| [1e3 * (x * cos - y * sin), 1e3 * (x * sin + y * cos)])
        .collect()
}
