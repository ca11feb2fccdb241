//! What a scene means: its values held against one another, its bodies packed.

use std::sync::Arc;

use aero_solver::method::Method;
use aero_solver::problem::{Domain, Problem, Resolution, Source, State};
use aero_solver::scheme::Viscosity;

use super::file::SceneFile;
use super::manufactured::{self, Manufactured};
use super::number::{Disorder, StreamAngle};
use super::{BodyPlan, PackWishes, Scene, SceneError};
use super::{axis, bodies, body_force, budget, domain, flow, liquid, method, mirror, openings};
use super::{output, packed, probe, region, schemes, surface, transport, two_gases};
use crate::case::{AnyCase, Case, RunPlan, Stop};

impl Scene {
    /// The case that the scene means, in its own dimension, with all bodies packed.
    pub fn build_any(&self) -> Result<AnyCase, SceneError> {
        match self.dimension() {
            1 => self.made().map(|case| AnyCase::One(Box::new(case))),
            2 => self.made().map(|case| AnyCase::Two(Box::new(case))),
            _ => self.made().map(|case| AnyCase::Three(Box::new(case))),
        }
    }

    /// As [`Self::build_any`], for callers that know the dimension. It is compiled with this crate, not with theirs.
    pub fn build<const D: usize>(&self) -> Result<Case<D>, SceneError> {
        self.expect_dimension::<D>()?;
        let case = self.build_any()?.of();
        case.ok_or_else(|| self.other_dimension(D))
    }

    /// Refuses a stream that does not go with the sides of the domain; looks at no body.
    ///
    /// # Errors
    /// What is wrong with the stream or the domain.
    pub fn check_stream(&self) -> Result<(), SceneError> {
        match self.dimension() {
            1 => self.streamed::<1>(self.solution()?.as_ref()).map(drop),
            2 => self.streamed::<2>(self.solution()?.as_ref()).map(drop),
            _ => self.streamed::<3>(self.solution()?.as_ref()).map(drop),
        }
    }

    /// When the run ends.
    fn stop(&self) -> Stop {
        self.file.stop.map_or(Stop::EndTime, Into::into)
    }

    /// The domain, the stream in it and what carries the gas.
    fn streamed<const D: usize>(
        &self,
        solution: Option<&Manufactured<D>>,
    ) -> Result<(Domain<D>, State<D>, Method), SceneError> {
        let file = &self.file;
        let equation = transport::equation_of_state(file);
        if equation.liquid().is_some() {
            liquid::check(file)?;
        }
        let mut domain = domain::domain(file)?;
        let free_stream = flow::free_stream(file, &domain, solution)?;
        let method = method::method(&file.scheme, self.stop())?;
        openings::open(file, &mut domain, &free_stream, method)?;
        flow::check_inlets(&domain, &free_stream)?;
        flow::check_reservoir(&domain, &free_stream, &equation)?;
        transport::check_sides(&equation, &domain)?;
        axis::check(&domain, &free_stream)?;
        if solution.is_none() {
            mirror::check(&domain, &free_stream, self.starts_in_the_free_stream())?;
        }
        Ok((domain, free_stream, method))
    }

    /// The case of a scene of `D` dimensions.
    fn made<const D: usize>(&self) -> Result<Case<D>, SceneError> {
        let file = &self.file;
        let spacing = file.spacing.get();
        let solution = self.solution()?;
        let stop = self.stop();
        let (domain, free_stream, method) = self.streamed(solution.as_ref())?;
        let initial = flow::initial(file, &self.folder, &domain, &free_stream)?;
        let initial = solution.as_ref().map_or(initial, Manufactured::initial);
        let end_time = flow::end_time(file, stop, &domain, &free_stream)?;
        let gas_constant = transport::gas_constant(file);
        let gas = transport::gas(file, &free_stream)?;
        let surroundings = region::Surroundings {
            domain: &domain,
            spacing,
            stream: &free_stream,
            gas_constant,
        };
        let is_fixed = method.fixed().is_some();
        let output = output::plan(&file.output, end_time, is_fixed, &surroundings)?;
        budget::check(&domain::region(&domain, spacing), spacing, "spacing")?;
        let plans = bodies::plans(file, &domain, &self.folder, &PackWishes::default())?;
        let bodies = plans
            .into_iter()
            .map(|plan| plan.body(&domain, &free_stream, method))
            .collect::<Result<Vec<_>, _>>()?;
        packed::check(&bodies, &domain, spacing)?;
        let probes = probe::probes(&file.probe, &domain, &bodies, spacing)?;
        let problem = Problem {
            resolution: Resolution::uniform(spacing),
            gas,
            second: two_gases::second(file, &domain)?,
            method,
            scheme: schemes::scheme(file.scheme, &gas),
            domain,
            free_stream,
            initial,
            disorder: file.initial.disorder.map_or(0.0, Disorder::get),
            bodies,
            source: None,
        };
        check(&problem, gas_constant)?;
        let source = source(file, solution, &problem, end_time)?;
        let problem = Problem { source, ..problem };
        Ok(Case {
            problem,
            plan: RunPlan {
                name: self.name.clone(),
                end_time,
                stop,
                incidence: incidence(file),
                gas_constant,
                warnings: None,
                output,
                probes,
            },
        })
    }

    /// The manufactured solution of the scene; none where it gives none.
    ///
    /// # Errors
    /// A scene of another dimension.
    pub fn solution<const D: usize>(&self) -> Result<Option<Manufactured<D>>, SceneError> {
        self.expect_dimension::<D>()?;
        let entry = self.file.manufactured.as_ref();
        // Its viscosity is no stream's.
        let rest = State::<D>::at_rest(1.0, 1.0);
        let made = |entry| {
            Manufactured::new(
                entry,
                self.file.spacing.get(),
                *transport::gas(&self.file, &rest)?
                    .ideal_gas()
                    .ok_or_else(|| {
                        SceneError::value(
                            "manufactured",
                            "is a solution of an ideal gas; leave out gas.equation_of_state",
                        )
                    })?,
            )
        };
        entry.map(made).transpose()
    }

    /// The bodies of the scene, ready to be packed.
    pub fn body_plans<const D: usize>(
        &self,
        wishes: &PackWishes,
    ) -> Result<Vec<BodyPlan<D>>, SceneError> {
        self.expect_dimension::<D>()?;
        let domain = domain::domain(&self.file)?;
        bodies::plans(&self.file, &domain, &self.folder, wishes)
    }

    fn expect_dimension<const D: usize>(&self) -> Result<(), SceneError> {
        let is_same = self.dimension() == D;
        is_same.then_some(()).ok_or_else(|| self.other_dimension(D))
    }

    fn other_dimension(&self, wanted: usize) -> SceneError {
        let dimension = self.dimension();
        SceneError::value(
            "dimension",
            format!("is {dimension}, but a scene of dimension {wanted} is wanted here"),
        )
    }
}

/// Refuses what single values allow, but not all of them together.
fn check<const D: usize>(
    problem: &Problem<D>,
    gas_constant: Option<f64>,
) -> Result<(), SceneError> {
    surface::check(problem, gas_constant.is_some())?;
    surface::refuse_viscous_rings(problem)?;
    schemes::check(problem)?;
    two_gases::check(problem)?;
    let has_none = problem.scheme.viscosity == Viscosity::None && !problem.gas.is_viscous();
    if has_none && !problem.scheme.is_of_liquids() {
        return Err(SceneError::value(
            "scheme.artificial_dissipation",
            "is what shocks need of gas without viscosity of its own; give the gas one, or leave this on",
        ));
    }
    Ok(())
}

/// What the scene adds to the equations: a body force, or the sources of a manufactured solution.
fn source<const D: usize>(
    file: &SceneFile,
    solution: Option<Manufactured<D>>,
    problem: &Problem<D>,
    end_time: f64,
) -> Result<Option<Arc<dyn Source<D>>>, SceneError> {
    let force = body_force::source(file, problem)?;
    let Some(solution) = solution else {
        return Ok(force);
    };
    manufactured::check(&solution, problem, end_time)?;
    Ok(Some(Arc::new(solution)))
}

/// Degrees at which the stream meets the bodies, where the scene states them.
fn incidence(file: &SceneFile) -> Option<f64> {
    let stream = file.free_stream.as_ref()?;
    stream.incidence.map(StreamAngle::get)
}
