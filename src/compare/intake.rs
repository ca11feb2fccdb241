//! A supersonic intake that a pressure at the end of its duct keeps started, puts a normal shock into, or unstarts, against the theory of shocks
//! and quasi-one-dimensional flow.

mod measures;

use aero::run::Keep;
use aero_solver::frame::Frame;
use aero_validation::exact::intake::{Held, Intake, Unstarted};
use aero_validation::pictures::particles::Overlay;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;
use measures::{GAMMA, MACH, captured, mach_in, place, pressure_in, recovery};

const SHOCKS: &str = "oblique shocks (NACA 1135, 1953, eqs 128-142)";
const THEORY: &str = "quasi-one-dimensional flow (NACA 1135, 1953, eqs 80, 99)";
const BOW: &str = "a normal shock on the ramp (NACA 1135, 1953, eqs 43-45, 99)";
/// As in the scene: angle of the ramp, degrees, and area of the end over the throat's.
const TURN: f64 = 7.0;
const WIDENING: f64 = 1.35;
const PASSES: &str = "mass that passes the cowl / that meets it";
const TOTAL: &str = "total pressure at the end / stream's";
/// Where the end of the duct is looked at.
const END: [f64; 2] = [6.0, 6.4];
/// Length of the duct, and where it begins to widen and has done so.
const LENGTH: f64 = 4.7;
const WIDENS: [f64; 2] = [3.4, 5.9];
/// Largest part of what meets the cowl that passes it where there is spill.
const SPILT: f64 = 0.98;

/// What is held at the end of the duct, over the stream's pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Regime {
    /// Too little for a shock inside.
    Fast(f64),
    /// A shock stands inside.
    Shocked(f64),
    /// So much, until the shock has left the throat upstream, then what held it inside before.
    Surged(f64, f64),
}

/// Pressures from one that holds no shock inside to one that drives it out.
pub const INTAKE: Comparison<Regime> = Comparison {
    case: "intake",
    scene: scene!("intake"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let [fast, shocked] = [Regime::Fast(4.0), Regime::Shocked(9.361)];
        let surged = Regime::Surged(13.0, 9.361);
        let quick = Variant::new(16, fast).quick();
        let mut variants = vec![
            quick.settled(),
            quick.settled().with(shocked),
            quick.marched().with(surged),
        ];
        for cells in [20, 40] {
            let full = Variant::new(cells, fast);
            variants.extend([fast, shocked].map(|regime| full.settled().with(regime)));
            variants.push(full.marched().with(surged));
        }
        // The shock stands in the fan of the corner where the duct begins to widen, which theory knows nothing of; just behind the throat.
        let coarse = Variant::new(20, fast).settled();
        variants.push(coarse.with(Regime::Shocked(10.3)).shown());
        variants.push(coarse.with(Regime::Shocked(11.0)));
        let particles = Variant::new(20, fast).wm().shown();
        variants.extend([particles, particles.with(shocked)]);
        variants
    },
    label: |v| {
        let what = match v.own {
            Regime::Fast(held) | Regime::Shocked(held) => format!("p / p1 {held}"),
            Regime::Surged(most, held) => format!("p / p1 {most}, then {held}"),
        };
        format!("{what}, dx 1/{}, {}", v.cells, v.scheme.laws())
    },
    settings: |v, _| {
        let held = match v.own {
            Regime::Fast(held) | Regime::Shocked(held) => format!("{held}"),
            Regime::Surged(most, held) => format!("if(t < 5, {most}, {held})"),
        };
        let pressure = format!("if(y < 1, {held}, 1) / {GAMMA}");
        // The shock of particles swings for longer.
        let (motion, end) = if v.scheme.is_of_points() {
            ("fixed", 20.0)
        } else {
            ("with-the-gas", 45.0)
        };
        vec![
            format!(
                "domain.sides.x_max={{ outlet = {{ pressure = \"{pressure}\", relaxation = 4.0 }} }}"
            ),
            format!("scheme.motion={motion}"),
            format!("end_time={end:?}"),
        ]
    },
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_, Regime>) -> Result<Vec<Row>, CompareError> {
    let gas = &flow.outcome.gas;
    let intake = Intake::new(MACH, TURN.to_radians(), WIDENING, GAMMA)?;
    let whole = Row::absolute(PASSES, "no spill", captured(gas), 1.0, 0.01);
    let mut rows = match flow.variant.own {
        Regime::Fast(_) => fast(gas, &intake).to_vec(),
        Regime::Shocked(pressure) => shocked(gas, intake.held(pressure)?).to_vec(),
        Regime::Surged(_, pressure) => {
            return Ok(unstarted(gas, intake.unstarted(pressure)?).to_vec());
        }
    };
    rows.insert(0, whole);
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Rows of a flow without a shock inside.
fn fast(gas: &Frame, intake: &Intake) -> [Row; 4] {
    let throat = [[3.1, 3.4], [0.4, 1.0]];
    let ramp = pressure_in(gas, [[1.2, 1.7], [0.24, 0.5]]);
    let once = intake.ramp.pressure_ratio;
    let twice = once * intake.cowl.pressure_ratio;
    let pressure = pressure_in(gas, throat);
    let (mach, total) = (mach_in(gas, throat), recovery(gas, throat[0]));
    let exact = |what, value, reference, allowed: [f64; 2]| {
        Row::relative(what, SHOCKS, value, reference, allowed)
    };
    [
        exact("pressure on the ramp / stream's", ramp, once, [0.04, 1.0]),
        exact(
            "pressure in the throat / stream's",
            pressure,
            twice,
            [1.0, 2.0],
        ),
        exact(
            "Mach number in the throat",
            mach,
            intake.cowl.mach,
            [1.0, 1.0],
        ),
        exact(
            "total pressure in the throat / stream's",
            total,
            intake.recovery(),
            [1.0, 1.0],
        ),
    ]
}

/// Rows of a flow with a shock inside.
fn shocked(gas: &Frame, held: Held) -> [Row; 2] {
    let [from, to] = WIDENS;
    let part = (held.area_ratio - 1.0) / (WIDENING - 1.0);
    let theory = from + part * (to - from);
    [
        Row::absolute(
            "normal shock behind the foot / length of the duct, mean over the height",
            THEORY,
            place(gas) / LENGTH,
            theory / LENGTH,
            0.02,
        ),
        Row::relative(TOTAL, THEORY, recovery(gas, END), held.recovery, 1.0),
    ]
}

/// Rows of a flow with a shock ahead of the cowl.
fn unstarted(gas: &Frame, theory: Unstarted) -> [Row; 4] {
    let captured = captured(gas);
    let ahead = mach_in(gas, [[1.6, 1.75], [0.4, 0.95]]);
    [
        Row::at_most(
            "Mach number ahead of the lip",
            "unstarted: a bow shock",
            ahead,
            1.0,
        ),
        Row::at_most(
            "spill: mass that passes the cowl / that meets it",
            "unstarted",
            captured,
            SPILT,
        ),
        Row::absolute(PASSES, BOW, captured, theory.captured, 0.08),
        Row::relative(TOTAL, BOW, recovery(gas, END), theory.recovery, [0.7, 1.0]),
    ]
}

/// The Mach number.
fn pictures(flow: &Flow<'_, Regime>) -> Result<(), CompareError> {
    let mut view = flow.view("Intake", &flow.outcome.gas.mach, "Mach number");
    let ramp = [
        [-0.5, 0.0],
        [0.0, 0.0],
        [3.0834, 0.3786],
        [3.4, 0.3786],
        [5.9, 0.16111],
        [6.5, 0.16111],
    ];
    let cowl = [[6.5, 1.0], [1.7951, 1.0], [6.5, 1.32897]];
    view.overlays = vec![
        Overlay::outline(ramp.to_vec()),
        Overlay::outline(cowl.to_vec()),
    ];
    view.save()
}
