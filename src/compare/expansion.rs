//! The expansion corner at Mach 2 and 15 degrees about points that stay, against Prandtl and Meyer: the wall pressure a few cells behind a
//! sharp bend.

use aero::run::{Keep, Outcome};
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "Prandtl-Meyer (NACA 1135, 1953)";
const TITLE: &str = "Expansion corner, Mach 2, 15 degrees";
const MACH: f64 = 2.0;
const ANGLE: f64 = 15.0;
const GAMMA: f64 = 1.4;
/// Distances behind the corner that are judged, spacings.
const STATIONS: [f64; 4] = [5.0, 10.0, 15.0, 20.0];
/// Up to here from a station, spacings, walls count as there.
const NEAR: f64 = 1.0;

pub const EXPANSION: Comparison = Comparison {
    case: "expansion",
    scene: scene!("stress", "expansion-corner"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let coarse = Variant::new(20, ()).settled();
        vec![
            coarse.both(),
            coarse.cells(40).both(),
            Variant::new(20, ()).marched().both(),
        ]
    },
    label: |v| format!("dx 1/{}, {}", v.cells, v.scheme.brief()),
    settings: |_, _| {
        vec![
            format!("free_stream.mach={MACH}"),
            format!("body.corner.shape.expansion_corner.angle={ANGLE}"),
            "domain.min=[-0.5, -0.6]".into(),
            "domain.max=[1.5, 1.0]".into(),
        ]
    },
    rows,
    pictures,
    together: None,
};

/// Distance along the wall behind the corner, in spacings, and pressure over that of the stream.
fn wall(outcome: &Outcome, spacing: f64) -> Vec<[f64; 2]> {
    let (sine, cosine) = ANGLE.to_radians().sin_cos();
    let surface = &outcome.surface;
    let feet = surface.position.iter().zip(&surface.pressure);
    feet.map(|(foot, pressure)| {
        [
            (foot[0] * cosine - foot[1] * sine) / spacing,
            pressure * GAMMA,
        ]
    })
    .collect()
}

#[allow(clippy::unnecessary_wraps)] // what a comparison asks for
fn rows(flow: &Flow<'_>) -> Result<Vec<Row>, CompareError> {
    let exact = expand(MACH, ANGLE.to_radians(), GAMMA)?.pressure_ratio;
    let wall = wall(flow.outcome, flow.spacing);
    let row = |station: f64| {
        let near = wall.iter().filter(|[at, _]| (at - station).abs() < NEAR);
        let farthest = near
            .map(|[_, pressure]| *pressure)
            .max_by(|a, b| (a - exact).abs().total_cmp(&(b - exact).abs()));
        Row::relative(
            format!("wall pressure within a spacing of {station} behind the corner, farthest off"),
            THEORY,
            farthest.unwrap_or(f64::NAN),
            exact,
            2.0,
        )
    };
    Ok(STATIONS.map(row).into())
}

/// Density, and the wall pressure.
fn pictures(flow: &Flow<'_>) -> Result<(), CompareError> {
    let density = &flow.outcome.gas.density;
    flow.view(TITLE, density, "density / free stream").save()?;
    let exact = expand(MACH, ANGLE.to_radians(), GAMMA)?.pressure_ratio;
    let mut measured = wall(flow.outcome, flow.spacing);
    measured.retain(|[at, _]| (-10.0..40.0).contains(at));
    let steps = vec![[-10.0, 1.0], [0.0, 1.0], [0.0, exact], [40.0, exact]];
    let panel = Panel::new(
        "spacings behind the corner",
        "wall pressure / free stream",
        vec![
            Series::new("Prandtl and Meyer", Style::Line, steps),
            Series::new("points", Style::Dots, measured),
        ],
    );
    flow.save(Curves::single(TITLE, panel), "wall", "svg")
}
