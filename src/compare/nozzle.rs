//! The convergent-divergent nozzle against finite volumes and quasi-one-dimensional theory: Mach number
//! on the centre line, mass flow from section to section.

mod back_pressure;
mod stations;

use aero::run::Keep;
use aero_validation::exact::nozzle::{BackNozzle, Section};
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::Overlay;
use aero_validation::reference::{Table, nozzle_centre_line};

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;
pub use back_pressure::BACK_PRESSURE;
use stations::{INCH, INLET, Station, stations};

const VOLUMES: &str = "finite volumes, second order (validation/nozzle)";
const THEORY: &str = "quasi-one-dimensional flow (NACA 1135, 1953, eq. 80)";
const GAMMA: f64 = 1.4;
/// Part of the nozzle that is judged, inches: the centre line of the reference bends where the
/// compression from the end of the throat's arc arrives.
const JUDGED: [f64; 2] = [-2.75, 2.5];

/// How gas enters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Entry {
    /// From a reservoir, as the scene says: along the tube, with the reservoir's stagnation state.
    #[default]
    Reservoir,
    /// As the finite volumes let it in: with the wave that the stream in the tube brings.
    Stream,
}

/// Time in which a flow into which no reservoir presses gas has come to rest, seconds.
const RESTED: f64 = 0.01;

/// The quick level runs the published resolution too; what is allowed anywhere is what it gives, with a
/// margin.
pub const NOZZLE: Comparison<Entry> = Comparison {
    case: "nozzle",
    scene: scene!("nozzle"),
    length: INLET * INCH,
    keep: Keep::Frames,
    variants: || {
        let published = Variant::new(30, Entry::Reservoir);
        vec![
            published.quick(),
            published.settled().both(),
            published.with(Entry::Stream).marched(),
            published,
            published.wm(),
            published.cells(60),
            published.paper(),
        ]
    },
    label: |v| match v.own {
        Entry::Reservoir => format!("dx R/{}, {}", v.cells, v.scheme),
        Entry::Stream => format!("dx R/{}, {}, let in by the stream", v.cells, v.scheme),
    },
    // The particles on the centre line are few; a mean over half a hundred frames tells.
    settings: |v, _| {
        let mut settings = vec!["output.frames=100".into()];
        if v.own == Entry::Stream {
            settings.push("domain.sides.x_min=\"inlet\"".into());
            settings.push(format!("end_time={}", 2.0 * RESTED));
        }
        settings
    },
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_, Entry>) -> Result<Vec<Row>, CompareError> {
    let stations = stations(&flow.outcome.history.frames)?;
    let judged: Vec<&Station> = stations
        .iter()
        .filter(|s| (JUDGED[0]..JUDGED[1]).contains(&s.x))
        .collect();
    let count = judged.len() as f64;
    let mass_flow = judged.iter().map(|s| s.flow).sum::<f64>() / count;
    let unsteady = judged.iter().map(|s| (s.flow / mass_flow - 1.0).abs());
    let table = nozzle_centre_line();
    let departures: Vec<f64> = judged
        .iter()
        .map(|s| (s.centre / reference(&table, s.x) - 1.0).abs())
        .collect();
    let mean = departures.iter().sum::<f64>() / count;
    let largest = departures.iter().copied().fold(0.0, f64::max);
    draw_lines(flow, &stations)?;
    // A hundredth where gas enters as it does for the finite volumes.
    let allowed = match flow.variant.own {
        Entry::Reservoir => [[0.02; 2], [0.05, 0.02]],
        Entry::Stream => [[0.01; 2]; 2],
    };
    let exit = stations.last().copied().unwrap_or_default();
    let theory = BackNozzle::in_inches().mach(exit.x, Section::Planar, GAMMA)?;
    Ok(vec![
        Row::absolute(
            "mass flow, largest departure from its mean",
            "conservation of mass",
            unsteady.fold(0.0, f64::max),
            0.0,
            0.01,
        ),
        Row::informs("mass flow / one-dimensional", THEORY, mass_flow, 1.0),
        Row::absolute(
            "Mach number on the centre line, mean departure",
            VOLUMES,
            mean,
            0.0,
            allowed[0],
        ),
        Row::absolute(
            "Mach number on the centre line, largest departure",
            VOLUMES,
            largest,
            0.0,
            allowed[1],
        ),
        Row::informs(
            "Mach number at the exit, mean over the section",
            THEORY,
            exit.mean,
            theory,
        ),
        flow.no_leaks(),
    ])
}

/// The Mach number in the plane.
fn pictures(flow: &Flow<'_, Entry>) -> Result<(), CompareError> {
    let mut view = flow.view("Nozzle", &flow.outcome.gas.mach, "Mach number");
    view.unit = INCH;
    view.axis_labels = ["x, inches", "y, inches"];
    let shape = BackNozzle::in_inches();
    let wall = (-60..=60).map(|k| f64::from(k) / 20.0);
    let wall = wall.map(|x| [x, shape.half_height(x)]).collect();
    view.overlays = vec![Overlay::outline(wall)];
    view.save()
}

/// The Mach number along the centre line, and the mass flow.
fn draw_lines(flow: &Flow<'_, Entry>, stations: &[Station]) -> Result<(), CompareError> {
    let along = |value: fn(&Station) -> f64| stations.iter().map(|s| [s.x, value(s)]).collect();
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
            Series::new("particles", Style::Dots, along(|s| s.centre)),
        ],
    );
    let mut through = Panel::new(
        "x, inches",
        "mass flow / one-dimensional",
        vec![Series::new("particles", Style::Dots, along(|s| s.flow))],
    );
    through.window = [None, Some([0.95, 1.05])];
    let curves = Curves {
        title: "Nozzle".into(),
        panels: vec![centre, through],
        columns: 1,
    };
    flow.save(curves, "centre", "png")
}

fn reference(table: &Table, x: f64) -> f64 {
    table.interpolate("x_in", "M_centre", x).unwrap_or(f64::NAN)
}
