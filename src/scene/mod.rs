//! Scenes: the file, its overrides, and the case that it means. Reads and checks; runs nothing.
//!
//! [`file::SceneFile`] lists every key, [`shapes::ShapeEntry`] every shape.
//!
//! ```
//! use aero::scene::Scene;
//!
//! let text = r#"
//! dimension = 2
//! spacing = 0.25
//! end_time = 1.0
//!
//! [free_stream]
//! mach = 2.5
//! density = 1.0
//! pressure = 0.7142857142857143
//!
//! [domain]
//! min = [-1.0, 0.0]
//! max = [3.0, 3.0]
//!
//! [domain.sides]
//! x_min = "inlet"
//! x_max = "outlet"
//! y_min = "body"
//! y_max = "free-stream"
//!
//! [[body]]
//! name = "ramp"
//! shape = { compression_corner = { angle = 20.0 } }
//! "#;
//! let mut scene = Scene::parse(text, "ramp", ".".as_ref())?;
//! scene.set("body.ramp.shape.compression_corner.angle=15")?;
//! let case = scene.build::<2>()?;
//! assert_eq!(case.problem.bodies[0].name, "ramp");
//! # Ok::<(), aero::scene::SceneError>(())
//! ```

pub(crate) mod atmosphere;
mod axis;
mod bodies;
mod body_force;
mod budget;
mod cover;
mod domain;
mod earlier;
mod error;
mod field;
pub mod file;
mod flow;
pub mod formula;
mod freedom;
mod lines;
pub mod liquid;
pub mod manufactured;
mod method;
mod mirror;
mod motion;
pub mod number;
mod openings;
mod output;
mod overrides;
mod packed;
mod picture;
mod probe;
mod reference;
mod refine;
mod region;
mod schemes;
mod second;
pub mod shapes;
pub mod side;
pub mod spin;
mod state;
mod stream;
mod surface;
mod transport;
mod two_gases;
mod vector;
mod views;
pub mod viscosity;
pub mod wall;
mod words;

pub use bodies::{BodyPlan, PackWishes};
pub use error::SceneError;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::case::{AnyCase, Case, RunPlan, Stop};
use aero_solver::method::Method;
use aero_solver::problem::{Domain, Problem, Source, State};
use aero_solver::scheme::Viscosity;
use file::SceneFile;
use manufactured::Manufactured;
use number::Disorder;
use refine::RefineEntry;

/// A scene: read, with all single values in range, and open to overrides.
#[derive(Clone, Debug)]
pub struct Scene {
    name: String,
    folder: PathBuf,
    text: String,
    file: SceneFile,
}

impl Scene {
    /// Reads the scene at `path`; its name is the file's stem.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = std::fs::read_to_string(path).map_err(|source| SceneError::Read {
            path: path.to_owned(),
            source,
        })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::read(&path.display().to_string(), text, &name, folder)
    }

    /// Reads a scene from memory; relative paths in it start at `folder`.
    pub fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, SceneError> {
        Self::read(name, text.to_owned(), name, folder)
    }

    fn read(origin: &str, text: String, name: &str, folder: &Path) -> Result<Self, SceneError> {
        let text = lines::read(&text).unwrap_or(text);
        let file = toml::from_str(&text).map_err(|source| SceneError::Parse {
            origin: origin.to_owned(),
            source: Box::new(source),
        })?;
        Ok(Self {
            name: name.to_owned(),
            folder: folder.to_owned(),
            text,
            file,
        })
    }

    /// Overrides one value: `section.key=value`. A body is addressed by name or number
    /// (`body.ramp.spacing=0.1`); a value that is not TOML is a bare string.
    ///
    /// # Errors
    /// Leaves the scene as it was if the path or the value makes no sense.
    pub fn set(&mut self, setting: &str) -> Result<(), SceneError> {
        let fail = |message: String| SceneError::Override {
            setting: setting.to_owned(),
            message,
        };
        let text = overrides::apply(&self.text, setting).map_err(fail)?;
        self.file = toml::from_str(&text)
            .map_err(|error: toml::de::Error| fail(error.message().trim_end().to_owned()))?;
        self.text = text;
        Ok(())
    }

    /// Name of the scene.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All values that a run depends on, one per line and in order, whatever the layout of the
    /// file: two scenes with the same lines make the same run.
    pub fn lines(&self) -> String {
        lines::of(&self.text)
    }

    /// The same with whole paths: what can be run from another folder.
    pub fn lines_from_anywhere(&self) -> String {
        lines::from_anywhere(&self.lines(), &self.folder)
    }

    /// True where the scene says nothing of another start than the undisturbed stream.
    pub fn starts_in_the_free_stream(&self) -> bool {
        let initial = &self.file.initial;
        let is_given = initial.riemann.is_some() || initial.field.is_some();
        !is_given && initial.frame.is_none() && self.file.manufactured.is_none()
    }

    /// Mach number, incidence and sideslip of the stream, degrees, where the scene states them.
    pub fn stream(&self) -> [Option<f64>; 3] {
        let Some(stream) = &self.file.free_stream else {
            return [None; 3];
        };
        [
            stream.mach.map(number::NonNegative::get),
            stream.incidence.map(number::StreamAngle::get),
            stream.sideslip.map(number::StreamAngle::get),
        ]
    }

    /// Minutes that points may be added for, where `scheme.refine` gives them.
    pub fn refine_minutes(&self) -> Option<f64> {
        match self.file.scheme.refine {
            Some(RefineEntry::Minutes(minutes)) => Some(minutes),
            _ => None,
        }
    }

    /// Number of space dimensions.
    pub fn dimension(&self) -> usize {
        self.file.dimension.get()
    }

    /// The values.
    pub fn file(&self) -> &SceneFile {
        &self.file
    }

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
            spacing,
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
        surface::check(&problem, gas_constant.is_some())?;
        surface::refuse_viscous_rings(&problem)?;
        schemes::check(&problem)?;
        two_gases::check(&problem)?;
        let has_none = problem.scheme.viscosity == Viscosity::None && !problem.gas.is_viscous();
        if has_none && !problem.scheme.is_of_liquids() {
            return Err(SceneError::value(
                "scheme.artificial_dissipation",
                "is what shocks need of gas without viscosity of its own; give the gas one, or leave this on",
            ));
        }
        let force = body_force::source(file, &problem)?;
        let source = match solution {
            None => force,
            Some(solution) => {
                manufactured::check(&solution, &problem, end_time)?;
                Some(Arc::new(solution) as Arc<dyn Source<D>>)
            }
        };
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
        let rest = aero_solver::problem::State {
            density: 1.0,
            velocity: aero_geometry::Vector::<D>::zeros(),
            pressure: 1.0,
        };
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

/// Degrees at which the stream meets the bodies, where the scene states them.
fn incidence(file: &SceneFile) -> Option<f64> {
    let stream = file.free_stream.as_ref()?;
    stream.incidence.map(number::StreamAngle::get)
}
