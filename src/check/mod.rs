//! Looks at a case before it runs: what cannot work is refused with the mend, what may go wrong is told. Packs nothing and runs
//! nothing; `aero run` asks it first, `aero check` prints it.

pub(crate) mod against;
mod contact;
mod describe;
mod gaps;
mod layer;
mod periods;
mod pockets;
mod ringing;
mod shock;
mod sides;
mod sound;
mod warmth;

use aero_solver::problem::side_name;
use std::collections::BTreeSet;

use aero_geometry::Vector;
use aero_packer::{About, Warning};
use aero_solver::panels::Panels;

use crate::case::{AnyCase, Case, warnings};

/// A number for people: without what round-off leaves behind its sixth digit.
pub fn shortened(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Check {
    /// What cannot work.
    pub refusals: Vec<String>,
    /// What the user should know, that of the packing first.
    pub warnings: Vec<Warning>,
}

impl AnyCase {
    /// What cannot work and what may not.
    pub fn check(&self) -> Check {
        match self {
            Self::One(case) => check(case),
            Self::Two(case) => check(case),
            Self::Three(case) => check(case),
        }
    }

    /// The case with its warnings noted.
    ///
    /// # Errors
    /// All that cannot work, a line each.
    pub fn checked(mut self) -> Result<Self, String> {
        let found = self.check();
        if !found.refusals.is_empty() {
            return Err(found.refusals.join("\n"));
        }
        let plan_warnings = match &mut self {
            Self::One(case) => &mut case.plan.warnings,
            Self::Two(case) => &mut case.plan.warnings,
            Self::Three(case) => &mut case.plan.warnings,
        };
        *plan_warnings = Some(found.warnings);
        Ok(self)
    }
}

/// What cannot work in `case` and what may not.
pub fn check<const D: usize>(case: &Case<D>) -> Check {
    let problem = &case.problem;
    let panels = Panels::new(problem);
    let mut found = Check {
        refusals: Vec::new(),
        warnings: warnings(&problem.bodies),
    };
    sides::look(problem, &panels, &mut found);
    periods::look(problem, &panels, &mut found);
    against::look(problem, &mut found);
    sound::look(problem, &mut found);
    ringing::look(problem, &mut found);
    warmth::look(problem, &mut found);
    layer::look(problem, &mut found);
    contact::look(problem, &mut found);
    gaps::look(problem, &panels, &mut found);
    pockets::look(problem, &mut found);
    let shocks = shock::look(problem, &panels).into_iter();
    let told = shocks.map(|line| Warning::new(About::Scene, line));
    found.warnings.extend(told);
    // Many panels say the same.
    let mut said = BTreeSet::new();
    found.refusals.retain(|line| said.insert(line.clone()));
    found
}

/// A point, for people.
fn place<const D: usize>(point: &Vector<D>) -> String {
    let numbers: Vec<String> = point.iter().map(|x| format!("{x:.4}")).collect();
    format!("({})", numbers.join(", "))
}

/// What is told of a scene with these settings.
#[cfg(test)]
fn told(scene: &str, settings: &[&str]) -> Vec<String> {
    let mut scene = crate::scene::Scene::parse(scene, "scene", std::path::Path::new("")).unwrap();
    for setting in settings {
        scene.set(setting).unwrap();
    }
    let found = scene.build_any().unwrap().check();
    found.warnings.iter().map(ToString::to_string).collect()
}
