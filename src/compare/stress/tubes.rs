//! The flows in tubes, and what is known of them.

use aero_validation::exact::accelerating_piston::AcceleratingPiston;
use aero_validation::exact::noh::Noh;
use aero_validation::exact::piston::Piston;
use aero_validation::exact::riemann::Riemann;
use aero_validation::exact::{ExactError, State};
use aero_validation::reference;

use aero::case::Case;
use aero_solver::problem;
use aero_solver::problem::{Initial, Side};

use crate::scenes::{Source, scene};

/// Gas along a line at the end time.
pub type Profile = Box<dyn Fn(f64) -> State>;

/// One flow along a line.
pub struct Tube {
    /// The scene.
    pub scene: Source,
    /// What is set on top of it, and how the row calls that.
    pub setting: &'static [&'static str],
    /// Where the answer holds.
    pub window: [f64; 2],
    /// The answer.
    pub exact: fn(&Case<1>) -> Result<Profile, ExactError>,
    /// Where it comes from.
    pub theory: &'static str,
}

const UNIT: [f64; 2] = [0.0, 1.0];
const TORO: &str = "exact Riemann solution (Toro 2009)";
const COURANT: &str = "Courant & Friedrichs 1948, chapter III";

const fn riemann_tube(scene: Source) -> Tube {
    Tube {
        scene,
        setting: &[],
        window: UNIT,
        exact: riemann,
        theory: TORO,
    }
}

const fn piston_tube(setting: &'static [&'static str]) -> Tube {
    Tube {
        scene: scene!("stress", "piston"),
        setting,
        window: UNIT,
        exact: piston,
        theory: COURANT,
    }
}

const fn accelerating_tube(setting: &'static [&'static str], window: [f64; 2]) -> Tube {
    Tube {
        scene: scene!("stress", "piston-accelerating"),
        setting,
        window,
        exact: accelerating_piston,
        theory: COURANT,
    }
}

/// Sod's tube in the plane's stead: the whole of it before its waves reach the ends.
pub const SOD: Tube = Tube {
    scene: scene!("sod-1d"),
    setting: &["end_time=0.15", "initial.riemann.smooth=false"],
    window: UNIT,
    exact: riemann,
    theory: TORO,
};

/// Noh's planar implosion.
pub const NOH: Tube = Tube {
    scene: scene!("stress", "noh-1"),
    setting: &[],
    window: UNIT,
    exact: noh,
    theory: "Noh 1987",
};

/// Toro's third test.
pub const TORO_3: Tube = riemann_tube(scene!("stress", "toro-3"));

/// All of them.
pub const TUBES: [Tube; 18] = [
    riemann_tube(scene!("stress", "toro-1")),
    riemann_tube(scene!("stress", "toro-2")),
    TORO_3,
    riemann_tube(scene!("stress", "toro-4")),
    riemann_tube(scene!("stress", "toro-5")),
    Tube {
        window: [0.0, 9.0],
        ..riemann_tube(scene!("stress", "le-blanc"))
    },
    Tube {
        exact: vacuum,
        ..riemann_tube(scene!("stress", "vacuum"))
    },
    NOH,
    Tube {
        scene: scene!("stress", "reflection"),
        setting: &[],
        window: UNIT,
        exact: reflection,
        theory: "normal shock relations",
    },
    Tube {
        scene: scene!("stress", "blast"),
        setting: &[],
        window: UNIT,
        exact: |_| Ok(table(reference::blast())),
        theory: "finite volumes, 800 cells",
    },
    Tube {
        scene: scene!("stress", "shu-osher"),
        setting: &[],
        window: [-4.5, 5.0],
        exact: |_| Ok(table(reference::shu_osher())),
        theory: "finite volumes, 800 cells",
    },
    piston_tube(&[]),
    piston_tube(&["domain.sides.x_min.wall.velocity=5", "end_time=0.12"]),
    piston_tube(&["domain.sides.x_min.wall.velocity=-1", "end_time=0.6"]),
    piston_tube(&["domain.sides.x_min.wall.velocity=-4", "end_time=0.25"]),
    piston_tube(&["domain.sides.x_min.wall.velocity=-10", "end_time=0.1"]),
    accelerating_tube(&[], [0.18, 1.0]),
    accelerating_tube(&["domain.sides.x_min.wall.acceleration=-1"], [-0.18, 1.0]),
];

/// The two states of the scene, brought together.
fn riemann(case: &Case<1>) -> Result<Profile, ExactError> {
    let Initial::Riemann {
        left,
        right,
        position,
        ..
    } = &case.problem.initial
    else {
        return nothing("the start of a tube without two states");
    };
    let (position, time) = (*position, case.plan.end_time);
    let riemann = Riemann::new(gas(left), gas(right), gamma(case))?;
    Ok(Box::new(move |x| riemann.sample((x - position) / time)))
}

/// Ratio of specific heats of the scene's gas.
pub(super) fn gamma(case: &Case<1>) -> f64 {
    let stream = &case.problem.free_stream;
    case.problem.gas.ratio_at(stream.density, stream.pressure)
}

/// The scene's gas on the left of 0.5, nothing on the right.
fn vacuum(case: &Case<1>) -> Result<Profile, ExactError> {
    let time = case.plan.end_time;
    let riemann = Riemann::new(
        State::new(1.0, 0.0, 1.0),
        State::new(0.0, 0.0, 0.0),
        gamma(case),
    )?;
    Ok(Box::new(move |x| riemann.sample((x - 0.5) / time)))
}

fn noh(case: &Case<1>) -> Result<Profile, ExactError> {
    let (noh, time) = (Noh::new(1, gamma(case))?, case.plan.end_time);
    Ok(Box::new(move |x| noh.at(x, time)))
}

/// A stream that a wall stops is a piston at the stream's speed, seen from the piston.
fn reflection(case: &Case<1>) -> Result<Profile, ExactError> {
    let stream = &case.problem.free_stream;
    let (speed, time) = (-stream.velocity[0], case.plan.end_time);
    let piston = Piston::new(speed, stream.density, stream.pressure, gamma(case))?;
    Ok(Box::new(move |x| {
        let state = piston.at(x + speed * time, time);
        State::new(state.density, state.velocity - speed, state.pressure)
    }))
}

fn piston(case: &Case<1>) -> Result<Profile, ExactError> {
    let Side::Wall { velocity, .. } = case.problem.domain.sides[0][0] else {
        return nothing("the speed of a piston that is no wall");
    };
    let (gas, time) = (&case.problem.free_stream, case.plan.end_time);
    let piston = Piston::new(velocity, gas.density, gas.pressure, gamma(case))?;
    Ok(Box::new(move |x| piston.at(x, time)))
}

fn accelerating_piston(case: &Case<1>) -> Result<Profile, ExactError> {
    let Side::Wall { acceleration, .. } = case.problem.domain.sides[0][0] else {
        return nothing("the acceleration of a piston that is no wall");
    };
    let (gas, time) = (&case.problem.free_stream, case.plan.end_time);
    let piston = AcceleratingPiston::new(acceleration, gas.density, gas.pressure, gamma(case))?;
    piston.at(1.0, time)?;
    let nowhere = State::new(f64::NAN, f64::NAN, f64::NAN);
    Ok(Box::new(move |x| piston.at(x, time).unwrap_or(nowhere)))
}

/// A profile of reference figures.
fn table(table: reference::Table) -> Profile {
    Box::new(move |x| {
        let value = |name: &str| table.interpolate("x", name, x).unwrap_or(f64::NAN);
        State::new(value("rho"), value("u"), value("p"))
    })
}

fn gas(state: &problem::State<1>) -> State {
    State::new(state.density, state.velocity[0], state.pressure)
}

fn nothing(what: &'static str) -> Result<Profile, ExactError> {
    Err(ExactError::OutOfRange {
        what,
        value: f64::NAN,
        range: "the scenes of this suite",
    })
}
