//! Expansion corners against Prandtl and Meyer: the wall pressure in the first cells behind a sharp bend.

use aero::run::Keep;
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
            published.both(),
            published.wm().both(),
            published.cells(40).both(),
            published.with(corner(1.5, 10.0, [0.0; 2])).both(),
            published.with(of(5.0 / 3.0)).shown().both(),
            published.with(corner(3.0, 20.0, [0.0; 2])).shown().both(),
            published.with(corner(6.0, 10.0, [0.3, 0.4])).shown().both(),
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

/// Distance along the wall behind the corner, in spacings, and pressure over that of the stream: in cells, or on panels that particles press.
fn wall(flow: &Flow<'_, Corner>) -> Vec<[f64; 2]> {
    let corner = &flow.variant.own;
    let (sine, cosine) = corner.angle.to_radians().sin_cos();
    let [x, y] = corner.at.map(|part| part * flow.spacing);
    let (surface, panels) = (&flow.outcome.surface, &flow.outcome.panels);
    let there = |(foot, pressure): ([f64; 3], &f64)| {
        let along = (foot[0] - x) * cosine - (foot[1] - y) * sine;
        [along / flow.spacing, pressure * corner.gamma]
    };
    if flow.variant.scheme.is_of_points() {
        let feet = surface.position.iter().copied();
        feet.zip(&surface.pressure).map(there).collect()
    } else {
        let middles = (0..panels.pressure.len()).map(|n| panels.middle(n));
        middles.zip(&panels.pressure).map(there).collect()
    }
}

fn rows(flow: &Flow<'_, Corner>) -> Result<Vec<Row>, CompareError> {
    let exact = flow.variant.own.pressure()?;
    let wall = wall(flow);
    let farthest = |from: f64, to: f64| {
        let there = wall.iter().filter(|[at, _]| (from..to).contains(at));
        let off = |pressure: &f64| (pressure - exact).abs();
        let pressures = there.map(|[_, pressure]| *pressure);
        let found = pressures.max_by(|a, b| off(a).total_cmp(&off(b)));
        found.unwrap_or(f64::NAN)
    };
    let mean = |from: f64, to: f64| {
        let there = wall.iter().filter(|[at, _]| (from..to).contains(at));
        let (sum, count) = there.fold((0.0, 0.0), |(sum, count), [_, p]| (sum + p, count + 1.0));
        sum / count
    };
    let of_points = flow.variant.scheme.is_of_points();
    let row = |station: f64| {
        let [from, to] = [station - NEAR, station + NEAR];
        let (kind, found, allowed) = if of_points {
            ("farthest off", farthest(from, to), 2.0)
        } else if station == STATIONS[0] {
            ("mean", mean(from, to), 12.0)
        } else {
            ("mean", mean(from, to), 6.0)
        };
        Row::relative(
            format!("wall pressure within a spacing of {station} behind the corner, {kind}"),
            THEORY,
            found,
            exact,
            allowed,
        )
    };
    let mut rows: Vec<Row> = STATIONS.map(row).into();
    let first =
        format!("wall pressure in the first {FIRST} spacings behind the corner, farthest off");
    let at_first = farthest(0.1, FIRST);
    rows.push(if of_points {
        Row::relative(first, THEORY, at_first, exact, 3.0).always()
    } else {
        Row::informs(first, THEORY, at_first, exact)
    });
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Density, and the wall pressure.
fn pictures(flow: &Flow<'_, Corner>) -> Result<(), CompareError> {
    let density = &flow.outcome.gas.density;
    flow.view(TITLE, density, "density / free stream").save()?;
    let exact = flow.variant.own.pressure()?;
    let mut measured = wall(flow);
    measured.retain(|[at, _]| (-10.0..40.0).contains(at));
    let steps = vec![[-10.0, 1.0], [0.0, 1.0], [0.0, exact], [40.0, exact]];
    let panel = Panel::new(
        "spacings behind the corner",
        "wall pressure / free stream",
        vec![
            Series::new("Prandtl and Meyer", Style::Line, steps),
            Series::new("measured", Style::Dots, measured),
        ],
    );
    flow.save(Curves::single(TITLE, panel), "wall", "svg")
}
