//! The compression corner against oblique shock theory.

mod corner;
mod flow;
mod published;

use aero::run::Keep;
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant;
use corner::Corner;
use flow::Measured;

/// Its scene.
pub const SCENE: Source = scene!("wedge");
const THEORY: &str = "oblique shock theory (NACA 1135, 1953)";
const GAMMA: f64 = 1.4;
/// Largest error of density and energy at the wall behind a strong shock, per cent.
const WALL: f64 = 3.0;

type Variant = variant::Variant<Corner>;

const fn corner(mach: f64, cells: u32, end_time: f64, plateau: f64) -> Variant {
    let corner = Corner {
        mach,
        gamma: GAMMA,
        angle: 20.0,
        end_time,
        plateau,
        is_tight: true,
    };
    Variant::new(cells, corner)
}

/// A row of the published table 1, at the spacing with which the published scheme shows the published
/// angles (theirs is not given).
const fn row(mach: f64, angle: f64, gamma: f64, end_time: f64) -> Variant {
    let row = corner(mach, 32, end_time, 1.5);
    row.with(Corner {
        gamma,
        angle,
        ..row.own
    })
}

/// The compression corner.
pub const WEDGE: Comparison<Corner> = Comparison {
    case: "wedge",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants,
    label,
    settings: |v, _| {
        let corner = &v.own;
        let mut settings = vec![
            format!("gas.gamma={:?}", corner.gamma),
            format!("free_stream.mach={}", corner.mach),
            format!("free_stream.pressure={}", 1.0 / corner.gamma),
            format!(
                "body.ramp.shape.compression_corner.angle={:?}",
                corner.angle
            ),
            format!("end_time={:?}", corner.end_time),
        ];
        if !corner.is_tight {
            settings.push("scheme.constant_ghost_volume=false".into());
        }
        settings
    },
    rows,
    pictures,
    together: None,
};

fn variants() -> Vec<Variant> {
    let mild = corner(2.5, 16, 10.0, 1.0);
    let strong = corner(5.0, 32, 5.0, 1.0);
    let hypersonic = corner(10.0, 32, 4.0, 2.0);
    let mut variants = vec![
        mild.both(),
        mild.wm().both(),
        mild.paper().both(),
        mild.wm().paper(),
        mild.settled().both(),
        mild.marched(),
        strong.settled().both(),
        hypersonic.settled(),
        strong.both(),
        strong.wm(),
        strong.paper(),
        strong.wm().paper(),
        hypersonic,
        hypersonic.wm(),
        hypersonic.paper(),
        hypersonic.wm().paper(),
    ];
    // Table 1 of Villodi & Ramachandran 2024 without its third row, which is the strong one.
    let table = [
        row(5.0, 10.0, GAMMA, 5.0),
        row(5.0, 15.0, GAMMA, 5.0),
        row(5.0, 25.0, GAMMA, 5.0),
        row(2.0, 10.0, GAMMA, 10.0),
        row(5.0, 20.0, 1.3, 5.0),
    ];
    for row in table {
        variants.extend([row, row.wm(), row.paper(), row.wm().paper()]);
    }
    let leaky = Corner {
        is_tight: false,
        ..mild.own
    };
    variants.push(mild.with(leaky).both());
    variants
}

fn label(variant: &Variant) -> String {
    let Corner {
        mach, gamma, angle, ..
    } = variant.own;
    if !variant.own.is_tight {
        return format!("M {mach}, ghost volumes not constant");
    }
    let gas = if gamma == GAMMA {
        String::new()
    } else {
        format!("gamma {gamma}, ")
    };
    let (cells, scheme) = (variant.cells, variant.scheme);
    format!("M {mach}, {gas}{angle} deg, dx 1/{cells}, {scheme}")
}

fn rows(flow: &Flow<'_, Corner>) -> Result<Vec<Row>, CompareError> {
    let corner = &flow.variant.own;
    if !corner.is_tight {
        let source = "leaks (Villodi & Ramachandran 2024, fig. 2a)";
        let quantity = "times that the wall sent gas back";
        return Ok(vec![
            Row::informs("particles in the wall", source, flow.leaked(), 0.0),
            Row::informs(quantity, source, flow.returned(), 0.0),
        ]);
    }
    let shock = corner.shock()?;
    let found = Measured::new(flow, &shock)?;
    let plateau = corner.plateau;
    let degrees = shock.angle.to_degrees();
    let pressure = shock.pressure_ratio / corner.gamma;
    // At the quick level about twice what is measured.
    let near = |quantity: &str, measured, reference, allowed: [f64; 2]| {
        Row::relative(quantity, THEORY, measured, reference, allowed)
    };
    let is_of_points = flow.variant.scheme.is_of_points();
    let mut rows = vec![
        near(
            "plateau density",
            found.plateau.density,
            shock.density_ratio,
            [0.35, plateau],
        )
        .by_points(is_of_points, [0.05, 0.1]),
        near(
            "plateau pressure",
            found.plateau.pressure,
            pressure,
            [0.15, plateau],
        )
        .by_points(is_of_points, [0.05, 0.1]),
        near(
            "plateau Mach number",
            found.plateau.mach,
            shock.mach,
            [0.15, plateau],
        )
        .by_points(is_of_points, [0.05, 0.1]),
        near(
            "half-jump shock angle, deg",
            found.line.angle.to_degrees(),
            degrees,
            [0.16, 0.5],
        ),
        near(
            "shock angle by eq. (36), deg",
            found.steepest.to_degrees(),
            degrees,
            [0.4, 1.2],
        )
        .by_points(is_of_points, [0.7, 1.5]),
    ];
    if is_of_points {
        rows.push(wall(flow, false, 1.0, 0.001));
        rows.push(wall(flow, true, shock.pressure_ratio, 0.3));
    }
    if let Some(angle) = published::angle(flow.variant).filter(|_| !is_of_points) {
        let quantity = "shock angle by eq. (36) as published, deg";
        let source = "Villodi & Ramachandran 2024, table 1, against theory";
        rows.push(Row::informs(quantity, source, angle, degrees));
    }
    if corner.mach > 2.5 {
        let [density, energy] = found.wall;
        let expected = pressure / shock.density_ratio / (corner.gamma - 1.0);
        let at_wall = near(
            "density at the wall",
            density,
            shock.density_ratio,
            [0.9, WALL],
        );
        let heat = near("energy at the wall", energy, expected, [1.5, WALL]);
        rows.push(at_wall.by_points(is_of_points, [0.1, 1.0]));
        rows.push(heat.by_points(is_of_points, [0.1, 1.0]));
    }
    if !flow.variant.scheme.is_conservative() {
        rows.extend(published::rows(flow.variant, &found, &shock));
    }
    rows.push(flow.no_leaks().always());
    Ok(rows)
}

/// The wall pressure before or behind the corner, `exact` times the stream's, where it is farthest off: the stream knows nothing of the ramp, and behind
/// the corner gas is as theory has it from the first cell on.
fn wall(flow: &Flow<'_, Corner>, is_behind: bool, exact: f64, allowed: f64) -> Row {
    let exact = exact / flow.variant.own.gamma;
    let surface = &flow.outcome.surface;
    let feet = surface.position.iter().zip(&surface.pressure);
    let there = feet.filter(|(foot, _)| (foot[0] > 0.0) == is_behind);
    let found = there.map(|(_, pressure)| *pressure);
    let off = |pressure: &f64| (pressure - exact).abs();
    let farthest = found.max_by(|a, b| off(a).total_cmp(&off(b)));
    let side = if is_behind { "behind" } else { "before" };
    let quantity = format!("wall pressure {side} the corner, farthest off");
    Row::relative(
        &quantity,
        THEORY,
        farthest.unwrap_or(f64::NAN),
        exact,
        allowed,
    )
    .always()
}

/// The density of the gas, the wall and the theoretical shock.
fn pictures(flow: &Flow<'_, Corner>) -> Result<(), CompareError> {
    let corner = &flow.variant.own;
    let mut view = flow.view(
        "Compression corner",
        &flow.outcome.gas.density,
        "density / free stream",
    );
    let wall = 3.0 * corner.angle.to_radians().tan();
    let shock = 3.0 * corner.shock()?.angle.tan();
    view.overlays = vec![
        Overlay::outline(vec![[-1.0, 0.0], [0.0, 0.0], [3.0, wall]]),
        Overlay::theory("shock, theory", vec![[0.0, 0.0], [3.0, shock]]),
    ];
    view.save()
}
