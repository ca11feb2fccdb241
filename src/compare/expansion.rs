//! Expansion corners about points that stay, against Prandtl and Meyer: the wall pressure in the first cells behind a sharp bend.

use aero::run::{Keep, Outcome};
use aero_validation::exact::prandtl_meyer::expand;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "Prandtl-Meyer (NACA 1135, 1953)";
const TITLE: &str = "Expansion corner";
const AIR: f64 = 1.4;
/// Distances behind the corner that are judged, spacings.
const STATIONS: [f64; 4] = [5.0, 10.0, 15.0, 20.0];
/// Up to here from a station, spacings, walls count as there.
const NEAR: f64 = 1.0;

/// Behind the corner, spacings, up to where the gas turns within cells.
const FIRST: f64 = 4.0;

/// A corner in a stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    mach: f64,
    /// Degrees.
    angle: f64,
    /// Ratio of specific heats of the gas.
    gamma: f64,
    /// Where in its cell the corner lies, spacings.
    at: [f64; 2],
}

impl Corner {
    fn pressure(&self) -> Result<f64, CompareError> {
        Ok(expand(self.mach, self.angle.to_radians(), self.gamma)?.pressure_ratio)
    }
}

pub const EXPANSION: Comparison<Corner> = Comparison {
    case: "expansion",
    scene: scene!("stress", "expansion-corner"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let corner = |mach, angle, at| Corner {
            mach,
            angle,
            gamma: AIR,
            at,
        };
        let of = |gamma| Corner {
            gamma,
            ..corner(2.0, 15.0, [0.0; 2])
        };
        let published = Variant::new(20, corner(2.0, 15.0, [0.0; 2]));
        let coarse = published.settled();
        vec![
            coarse.both(),
            coarse.cells(40).both(),
            published.marched().both(),
            coarse.with(corner(1.5, 10.0, [0.0; 2])).both(),
            coarse.with(corner(2.0, 5.0, [0.0; 2])).both(),
            coarse.with(corner(2.0, 20.0, [0.0; 2])).both(),
            coarse.with(corner(2.0, 20.0, [0.0; 2])).cells(40).both(),
            coarse.with(corner(2.0, 15.0, [0.7, 0.9])).both(),
            coarse.with(of(1.2)).both(),
            coarse.with(of(5.0 / 3.0)).both(),
            coarse.with(corner(4.0, 10.0, [0.5, 0.5])).both(),
            coarse.with(corner(6.0, 10.0, [0.0; 2])).both(),
            coarse.with(corner(6.0, 10.0, [0.3, 0.4])).both(),
            coarse.with(corner(10.0, 5.0, [0.0; 2])).both(),
            coarse.with(corner(3.0, 20.0, [0.0; 2])).both(),
            coarse.with(corner(3.0, 30.0, [0.0; 2])).both(),
            coarse.with(corner(3.0, 30.0, [0.4, 0.7])).both(),
            coarse.with(corner(4.0, 15.0, [0.0; 2])).both(),
            coarse.with(corner(4.0, 15.0, [0.0; 2])).cells(40).both(),
        ]
    },
    label: |v| {
        let Corner {
            mach,
            angle,
            gamma,
            at,
        } = v.own;
        let gas = if gamma == AIR {
            String::new()
        } else {
            format!(", gamma {gamma:.3}")
        };
        let off = if at == [0.0; 2] {
            ""
        } else {
            ", off the lattice"
        };
        let (cells, scheme) = (v.cells, v.scheme.brief());
        format!("M {mach}, {angle} deg, dx 1/{cells}{gas}{off}, {scheme}")
    },
    settings: |v, spacing| {
        let Corner {
            mach,
            angle,
            gamma,
            at,
        } = v.own;
        let [x, y] = at.map(|part| part * spacing);
        vec![
            format!("gas.gamma={gamma:?}"),
            format!("free_stream.mach={mach}"),
            format!("free_stream.pressure={:?}", 1.0 / gamma),
            format!("body.corner.shape.expansion_corner.angle={angle:?}"),
            format!("body.corner.shape.expansion_corner.corner=[{x:?}, {y:?}]"),
            "domain.min=[-0.5, -0.6]".into(),
            "domain.max=[1.5, 1.0]".into(),
        ]
    },
    rows,
    pictures,
    together: None,
};

/// Distance along the wall behind the corner, in spacings, and pressure over that of the stream.
fn wall(outcome: &Outcome, spacing: f64, corner: &Corner) -> Vec<[f64; 2]> {
    let (sine, cosine) = corner.angle.to_radians().sin_cos();
    let [x, y] = corner.at.map(|part| part * spacing);
    let surface = &outcome.surface;
    let feet = surface.position.iter().zip(&surface.pressure);
    feet.map(|(foot, pressure)| {
        [
            ((foot[0] - x) * cosine - (foot[1] - y) * sine) / spacing,
            pressure * corner.gamma,
        ]
    })
    .collect()
}

fn rows(flow: &Flow<'_, Corner>) -> Result<Vec<Row>, CompareError> {
    let corner = &flow.variant.own;
    let exact = corner.pressure()?;
    let wall = wall(flow.outcome, flow.spacing, corner);
    let farthest = |from: f64, to: f64| {
        let there = wall.iter().filter(|[at, _]| (from..to).contains(at));
        let off = |pressure: &f64| (pressure - exact).abs();
        let pressures = there.map(|[_, pressure]| *pressure);
        let found = pressures.max_by(|a, b| off(a).total_cmp(&off(b)));
        found.unwrap_or(f64::NAN)
    };
    let row = |station: f64| {
        Row::relative(
            format!("wall pressure within a spacing of {station} behind the corner, farthest off"),
            THEORY,
            farthest(station - NEAR, station + NEAR),
            exact,
            2.0,
        )
    };
    let mut rows: Vec<Row> = STATIONS.map(row).into();
    let first = Row::relative(
        format!("wall pressure in the first {FIRST} spacings behind the corner, farthest off"),
        THEORY,
        farthest(0.1, FIRST),
        exact,
        3.0,
    );
    rows.push(first.always());
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Density, and the wall pressure.
fn pictures(flow: &Flow<'_, Corner>) -> Result<(), CompareError> {
    let density = &flow.outcome.gas.density;
    flow.view(TITLE, density, "density / free stream").save()?;
    let exact = flow.variant.own.pressure()?;
    let mut measured = wall(flow.outcome, flow.spacing, &flow.variant.own);
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
