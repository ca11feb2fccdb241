//! The biconvex aerofoil at Mach 4.04 against shock-expansion theory.

use aero::run::{Keep, Outcome};
use aero_validation::exact::shock_expansion::Biconvex;
use aero_validation::pictures::curves::{Curves, Panel, Series, Style};
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;

/// Its scene.
pub const SCENE: Source = scene!("biconvex");
const TITLE: &str = "Biconvex aerofoil, Mach 4.04";
const THEORY: &str = "shock-expansion theory (Anderson, Modern Compressible Flow, 4.15)";
/// Thickness over chord.
pub const THICKNESS: f64 = 0.1;
/// Of the stream.
pub const MACH: f64 = 4.04;
const GAMMA: f64 = 1.4;
/// Chordwise stations that are judged: the tips, thinner than the kernel, are left out.
const JUDGED: [f64; 2] = [0.1, 0.98];

/// What a mirror image leaves of lift and moment, over the drag; and what two halves may leave.
const ROUND_OFF: [f64; 2] = [1e-9; 2];
const UNBALANCED: [f64; 2] = [0.03, 0.005];

/// How much of the aerofoil is in the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Halves {
    /// The upper half, on a symmetry plane.
    Upper,
    /// The whole aerofoil.
    Both,
}

/// The aerofoil is eight spacings thick at the quick level's and the published resolution, and the layer
/// behind its shock thinner yet: the quick level allows what that gives, with a margin, not what an
/// aerofoil needs.
pub const BICONVEX: Comparison<Halves> = Comparison {
    case: "biconvex",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let published = Variant::new(80, Halves::Upper);
        vec![
            published.quick(),
            published.settled().both(),
            published.cells(160).settled(),
            published,
            published.wm(),
            published.with(Halves::Both),
            published.cells(160),
            published.cells(160).wm(),
        ]
    },
    label: |v| {
        let both = match v.own {
            Halves::Upper => "",
            Halves::Both => ", both halves",
        };
        format!("dx c/{}, {}{both}", v.cells, v.scheme.brief())
    },
    settings: |v, spacing| {
        let mut settings = vec![format!("body.aerofoil.spacing={}", 0.5 * spacing)];
        if v.own == Halves::Both {
            settings.push("domain.min=[-0.25, -0.75]".into());
            settings.push("domain.sides.y_min=free-stream".into());
        }
        settings
    },
    rows,
    pictures,
    together: None,
};

fn theory() -> Result<Biconvex, CompareError> {
    Ok(Biconvex::new(THICKNESS, MACH, GAMMA)?)
}

fn rows(flow: &Flow<'_, Halves>) -> Result<Vec<Row>, CompareError> {
    let theory = theory()?;
    let (departure, scale) = departure(flow.outcome, &theory)?;
    let body = &flow.outcome.summary.bodies["aerofoil"];
    let tip = theory.surface(0.0)?.pressure_coefficient;
    let is_of_points = flow.variant.scheme.is_of_points();
    let mut rows = vec![
        Row::absolute(
            "Cp, mean departure / mean size",
            THEORY,
            departure / scale,
            0.0,
            [0.06, 0.03],
        )
        .by_points(is_of_points, [0.02, 0.02]),
        Row::informs(
            "Cp, mean departure / Cp behind the leading edge",
            THEORY,
            departure / tip,
            0.0,
        ),
        Row::relative(
            "drag coefficient",
            THEORY,
            body.cd_mean.unwrap_or(f64::NAN),
            theory.drag_coefficient()?,
            [1.3, 5.0],
        )
        .by_points(is_of_points, [2.0, 1.0]),
    ];
    let unbalanced = match flow.variant.own {
        Halves::Upper => ROUND_OFF,
        Halves::Both => UNBALANCED,
    };
    rows.extend(flow.no_lift("aerofoil", unbalanced));
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Density with the leading shock, and the wall pressure.
fn pictures(flow: &Flow<'_, Halves>) -> Result<(), CompareError> {
    let theory = theory()?;
    let mut view = flow.view(TITLE, &flow.outcome.gas.density, "density");
    let surface = |side: f64| {
        let stations = (0..=50).map(|k| f64::from(k) / 50.0);
        Overlay::outline(stations.map(|x| [x, side * theory.height(x)]).collect())
    };
    // The shock is straight as long as the expansion from the arc has not caught up with it.
    let shock = 0.5 * theory.leading_shock().angle.tan();
    view.overlays = vec![
        surface(1.0),
        surface(-1.0),
        Overlay::theory("leading shock, theory", vec![[0.0, 0.0], [0.5, shock]]),
    ];
    view.save()?;

    let mut exact = Vec::new();
    for k in 0..=100 {
        let x = f64::from(k) / 100.0;
        exact.push([x, theory.surface(x)?.pressure_coefficient]);
    }
    let panel = Panel::new(
        "x / chord",
        "pressure coefficient",
        vec![
            Series::new("shock-expansion theory", Style::Line, exact),
            Series::new("particles", Style::Dots, wall(flow.outcome).collect()),
        ],
    );
    flow.save(Curves::single(TITLE, panel), "cp", "svg")
}

/// Place on the chord and pressure coefficient of each panel.
fn wall(outcome: &Outcome) -> impl Iterator<Item = [f64; 2]> {
    let panels = &outcome.panels;
    let each = panels.pressure_coefficient.iter().enumerate();
    each.map(|(n, cp)| [panels.middle(n)[0], *cp])
}

/// Mean size of the departure of the pressure coefficient from theory, and mean size of the
/// coefficient, over the stations judged.
pub fn departure(outcome: &Outcome, theory: &Biconvex) -> Result<(f64, f64), CompareError> {
    let (mut departure, mut scale, mut count) = (0.0, 0.0, 0.0);
    for [x, cp] in wall(outcome) {
        if (JUDGED[0]..JUDGED[1]).contains(&x) {
            let exact = theory.surface(x)?.pressure_coefficient;
            departure += (cp - exact).abs();
            scale += exact.abs();
            count += 1.0;
        }
    }
    Ok((departure / count, scale / count))
}
