//! Compares runs with theory: ties the application to the independent `validation` crate.
//!
//! One file per case, which declares a `Comparison`, scene, variants, rows and pictures, or a
//! `Suite` of what shares no such frame. Exact solutions and metrics are not here.

mod aerofoil;
mod apollo;
pub mod biconvex;
mod bump;
mod comparison;
pub mod cone;
mod context;
mod crossing;
pub mod cylinder;
mod diamond;
pub mod double_mach;
mod duct;
mod edge;
mod expansion;
mod faceted_cone;
mod fly;
mod free;
mod inclined_cone;
mod intake;
mod jet;
mod limits;
mod mms;
mod mms_walls;
mod nozzle;
mod outlets;
mod points;
mod polar;
mod profiles;
mod program;
mod real_gas;
mod report;
mod ridge;
mod row;
pub mod scenes;
pub mod sod;
mod sound;
pub mod sphere;
mod square;
mod stability;
mod step;
mod stress;
mod suite;
mod supersonic_vortex;
mod surface;
mod transonic;
mod two_gases;
mod variant;
mod view;
mod viscous;
mod weakly_compressible;
pub mod wedge;
mod wings;

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use aero::nearest::nearest;
use aero_validation::table::Check;

use comparison::Compare;
pub use context::{CompareError, Context, Level};
use limits::Limits;
pub use variant::{Motion, Scheme};

/// A case by the name that is typed, and what it compares.
type Case = (&'static str, &'static [&'static dyn Compare]);

/// The cases that run where none is named, in this order.
static CASES: [Case; 35] = [
    ("wedge", &[&wedge::WEDGE]),
    ("sod", &[&sod::SOD]),
    ("cylinder", &[&cylinder::CYLINDER]),
    ("nozzle", &[&nozzle::NOZZLE]),
    ("nozzle-back-pressure", &[&nozzle::BACK_PRESSURE]),
    ("duct", &[&duct::DUCT]),
    ("bump", &[&bump::BUMP]),
    ("intake", &[&intake::INTAKE]),
    ("jet", &[&jet::JET]),
    ("sound", &[&sound::SOUND]),
    ("mms", &[&mms::MANUFACTURED]),
    ("mms-walls", &[&mms_walls::WALLS]),
    ("outlets", &[&outlets::OUTLETS]),
    (
        "viscous",
        &[&viscous::SHEAR, &viscous::LAYERS, &viscous::NOSES],
    ),
    (
        "weakly-compressible",
        &[&weakly_compressible::WEAKLY_COMPRESSIBLE],
    ),
    ("real-gas", &[&real_gas::REAL_GAS]),
    ("two-gases", &[&two_gases::TWO_GASES]),
    ("step", &[&step::FORWARD_STEP]),
    ("double-mach", &[&double_mach::DOUBLE_MACH]),
    ("biconvex", &[&biconvex::BICONVEX]),
    ("diamond", &[&diamond::DIAMOND, &wings::WINGS]),
    ("crossing", &[&crossing::CROSSING]),
    ("aerofoil", &[&aerofoil::AEROFOIL]),
    ("transonic", &[&transonic::TRANSONIC]),
    (
        "supersonic-vortex",
        &[&supersonic_vortex::SUPERSONIC_VORTEX],
    ),
    ("square", &[&square::SQUARE]),
    ("cone", &[&cone::CONE]),
    ("cone-faceted", &[&faceted_cone::FACETED_CONE]),
    ("cone-incidence", &[&inclined_cone::INCLINED_CONE]),
    (
        "expansion",
        &[&expansion::EXPANSION, &edge::EDGES, &ridge::RIDGES],
    ),
    ("free", &[&free::FREE_BODIES]),
    ("sphere", &[&sphere::SPHERE, &sphere::RINGS]),
    ("apollo", &[&apollo::QUARTER, &apollo::RINGS]),
    ("polar", &[&polar::POLAR]),
    ("fly", &[&fly::FLIGHTS]),
];

/// Cases that run only where they are named: parts of others, and what shows where the method ends, some of whose rows fail.
static ON_REQUEST: [Case; 11] = [
    (
        "stress",
        &[
            &stress::TUBES,
            &stress::BALLS,
            &stress::SMOOTH,
            &stress::BODIES,
            &stress::SLABS,
            &stress::FINS,
        ],
    ),
    ("viscous-shear", &[&viscous::SHEAR]),
    ("viscous-layers", &[&viscous::LAYERS]),
    ("viscous-noses", &[&viscous::NOSES]),
    ("stress-tubes", &[&stress::TUBES]),
    ("stress-balls", &[&stress::BALLS]),
    ("stress-smooth", &[&stress::SMOOTH]),
    ("stress-bodies", &[&stress::BODIES]),
    ("stress-slabs", &[&stress::SLABS]),
    ("stress-fins", &[&stress::FINS]),
    ("stability", &[&stability::STABILITY]),
];

/// Runs the named cases, all but those on request where none is named, and returns their rows; the page
/// `report.md` about them grows with every comparison. Short ones run side by side, as many as there are threads: each is too small for
/// all of them. A run that stops is a row that fails.
///
/// # Errors
/// A name that is not a case, before anything runs; a scene of the project that is wrong; files that
/// cannot be written.
pub fn compare(names: &[String], context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let all = || CASES.iter().chain(&ON_REQUEST);
    if let Some(name) = names.iter().find(|name| all().all(|case| case.0 != **name)) {
        let known: Vec<&str> = all().map(|(name, _)| *name).collect();
        return Err(CompareError::Unknown {
            name: name.clone(),
            hint: nearest(name, &known),
            known: known.join(", "),
        });
    }
    let chosen: Vec<&dyn Compare> = all()
        .enumerate()
        .filter(|(number, (name, _))| {
            let is_usual = names.is_empty() && *number < CASES.len();
            is_usual || names.iter().any(|asked| asked == name)
        })
        .flat_map(|(_, (_, comparisons))| comparisons.iter().copied())
        .collect();
    // What is set on top of the runs may change every row.
    let is_held = context.level == Level::Quick && context.settings.is_empty();
    let limits = if is_held {
        Limits::of_the_quick_level()?
    } else {
        Limits::default()
    };
    let rows = Mutex::new(vec![Vec::new(); chosen.len()]);
    let run = |number: usize| {
        let mut checks = chosen[number].compare(context)?;
        for check in &mut checks {
            context.name(check);
            limits.hold(check);
        }
        let mut rows = rows.lock().unwrap_or_else(PoisonError::into_inner);
        rows[number] = checks;
        report::write(&rows.concat(), context.level, context.out).map_err(|source| {
            CompareError::Report {
                path: context.out.join(report::NAME),
                source,
            }
        })
    };
    let (beside, after): (Vec<usize>, Vec<usize>) = (0..chosen.len())
        .partition(|&k| context.level == Level::Quick && !chosen[k].wants_all_threads());
    let side_by_side = beside.into_par_iter().with_max_len(1);
    side_by_side.try_for_each(run)?;
    after.into_iter().try_for_each(run)?;
    let mut checks = rows
        .into_inner()
        .unwrap_or_else(PoisonError::into_inner)
        .concat();
    if names.is_empty() {
        checks.extend(limits.unanswered(&checks));
    }
    Ok(checks)
}
