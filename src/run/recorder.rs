//! Who looks on while a run goes, and the one that writes files.

use aero_solver::problem::side_name;
use std::fmt;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use aero_geometry::Bounds;

use super::checkpoint::{Checkpoint, Written};
use super::coefficients::Coefficients;
use super::lately::{self, Lately};
use super::probes::Probes;
use super::progress::Progress;
use super::views::Views;
use crate::case::{Case, RunPlan};
use crate::output::{
    self, Background, BodyMotion, Collection, Drafts, History, HistoryRow, Mirrors, OutputError,
    Reference,
};
use aero_solver::frame::Kind;
use aero_solver::{Flow, wall_sides};

/// Sees a run at its frames and steps.
pub(super) trait Recorder<const D: usize> {
    /// A frame is due: at the start, at every frame time, at the end and after a failure.
    fn frame(&mut self, simulation: &Flow<D>) -> Result<(), OutputError>;

    /// A step of length `dt` has been taken; a break asks the run to stop here.
    fn step(&mut self, simulation: &Flow<D>, dt: f64) -> Result<ControlFlow<()>, OutputError>;

    /// True when the run should be remembered, after a step without a frame; after one with a
    /// frame it always is.
    fn is_checkpoint_due(&self) -> bool {
        false
    }

    /// The run as it stands.
    fn checkpoint(&mut self, _run: Checkpoint<'_, D>) -> Result<(), OutputError> {
        Ok(())
    }

    /// Nothing more comes: whatever is still on its way must be on disk.
    fn finish(&mut self) -> Result<(), OutputError> {
        Ok(())
    }
}

/// Writes frames, surfaces, history and checkpoints into a folder; all but the history while the solver
/// goes on.
pub(super) struct FileRecorder<'a, const D: usize> {
    folder: PathBuf,
    written: Written,
    particles: Collection,
    surfaces: Option<Collection>,
    cells: Option<Collection>,
    views: Views<D>,
    probes: Probes<D>,
    reference: Reference,
    background: Background,
    drafts: Drafts,
    region: Option<Bounds<D>>,
    is_compressed: bool,
    has_ghosts: bool,
    /// Leave the next frame out.
    pub(super) skips_next: bool,
    mirrors: Mirrors,
    history: History,
    plan: RunPlan<D>,
    coefficients: Option<Coefficients>,
    lately: Lately,
    /// Of the first body, as of the last row of the history.
    latest: Option<lately::Coefficients>,
    history_every: u64,
    checkpoint_every: Duration,
    last_checkpoint: Instant,
    /// The scene, for its checkpoints.
    scene: String,
    end_time: f64,
    watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
}

impl<const D: usize> fmt::Debug for FileRecorder<'_, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FileRecorder")
            .field("folder", &self.folder)
            .field("written", &self.written)
            .finish_non_exhaustive()
    }
}

impl<'a, const D: usize> FileRecorder<'a, D> {
    /// Starts to record `case`, which is what `scene` means, into `folder`, which exists; `watch`
    /// is called after every step.
    ///
    /// # Errors
    /// When the folder takes no files. Frames and a checkpoint of an earlier run are gone afterwards.
    pub(super) fn create(
        folder: &Path,
        case: &Case<D>,
        scene: &str,
        watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, OutputError> {
        output::remove_checkpoints(folder)?;
        output::remove_frames(folder)?;
        let names = load_names(case);
        let bodies = case.problem.bodies.len();
        let free: Vec<String> = (case.problem.bodies.iter())
            .filter(|body| body.motion.free.is_some())
            .map(|body| body.name.clone())
            .collect();
        let history = History::create(&folder.join("history.csv"), &names, bodies, &free)?;
        let probes = Probes::new(folder, &case.plan.probes, &reference(case), None)?;
        Ok(Self::new((folder, case, scene), history, probes, watch))
    }

    /// Goes on recording after what has been `written`.
    pub(super) fn resume(
        folder: &Path,
        case: &Case<D>,
        scene: &str,
        written: Written,
        watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, OutputError> {
        let counts = [load_names(case).len(), case.problem.bodies.len()];
        let history = History::resume(&folder.join("history.csv"), counts, written.history)?;
        let bytes = Some(written.probes);
        let probes = Probes::new(folder, &case.plan.probes, &reference(case), bytes)?;
        let mut recorder = Self::new((folder, case, scene), history, probes, watch);
        for (number, &time) in written.times.iter().enumerate() {
            recorder.particles.note(time, &frame_name(number));
            if let Some(surfaces) = &mut recorder.surfaces {
                surfaces.note(time, &surface_name(number));
            }
            if let Some(cells) = &mut recorder.cells {
                cells.note(time, &cells_name(number));
            }
            recorder.views.note(number, time);
        }
        recorder.written = written;
        Ok(recorder)
    }

    fn new(
        (folder, case, scene): (&Path, &Case<D>, &str),
        history: History,
        probes: Probes<D>,
        watch: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Self {
        let plan = &case.plan.output;
        let has_surfaces = !load_names(case).is_empty();
        Self {
            folder: folder.to_owned(),
            written: Written::default(),
            particles: Collection::new(folder.join("run.pvd")),
            surfaces: has_surfaces.then(|| Collection::new(folder.join("surface.pvd"))),
            cells: plan
                .extras
                .cells
                .then(|| Collection::new(folder.join("cells.pvd"))),
            probes,
            views: Views::new(folder, &case.plan, reference(case)),
            reference: reference(case),
            background: Background::default(),
            drafts: Drafts::new(folder),
            region: case.plan.output.region,
            is_compressed: case.plan.output.is_compressed,
            has_ghosts: case.plan.output.extras.ghosts,
            skips_next: false,
            mirrors: Mirrors(case.plan.output.mirrors.clone()),
            history,
            plan: case.plan.clone(),
            coefficients: None,
            lately: Lately::default(),
            latest: None,
            history_every: case.plan.output.history_every as u64,
            checkpoint_every: Duration::from_secs_f64(case.plan.output.checkpoint_seconds),
            last_checkpoint: Instant::now(),
            scene: scene.to_owned(),
            end_time: case.plan.end_time,
            watch,
        }
    }
}

impl<const D: usize> Recorder<D> for FileRecorder<'_, D> {
    fn frame(&mut self, simulation: &Flow<D>) -> Result<(), OutputError> {
        if std::mem::take(&mut self.skips_next) {
            return Ok(());
        }
        let number = self.written.times.len();
        let time = shown_time(simulation);
        let surface = self.surfaces.as_mut().map(|surfaces| {
            surfaces.note(time, &surface_name(number));
            let path = self.folder.join(surface_name(number));
            (path, simulation.panels(), surfaces.clone())
        });
        let cells = self.cells.as_mut().and_then(|collection| {
            collection.note(time, &cells_name(number));
            let path = self.folder.join(cells_name(number));
            Some((path, simulation.cells()?, collection.clone()))
        });
        // As large as all particles: made once the panels, which take room to find, are there.
        let region = self.region.as_ref();
        let frame = region.map_or_else(|| simulation.frame(), |r| simulation.frame_within(r));
        let path = self.folder.join(frame_name(number));
        self.particles.note(time, &frame_name(number));
        let particles = self.particles.clone();
        let reference = self.reference.clone();
        self.written.times.push(time);
        let is_compressed = self.is_compressed;
        let mirrors = self.mirrors.clone();
        let ghosts = self.has_ghosts.then(|| {
            let path = self.folder.join(ghosts_name(number));
            (path, frame.chosen(|kind| kind != Kind::Fluid as u8))
        });
        let mut frame = frame.only(|kind| kind == Kind::Fluid as u8);
        let gradients = self.views.gradients(simulation, &frame);
        let mut views = self.views.take(simulation, number, time);
        views.extend(self.probes.lines(&self.folder, simulation, number));
        self.background.hand(move || {
            if let Some((path, ghosts)) = ghosts {
                output::write_frame(&path, ghosts, &[], Some(&reference), is_compressed)?;
            }
            let mut cells = cells;
            mirrors.apply(&mut frame, cells.as_mut().map(|(_, cells, _)| cells));
            if let Some((path, mut surface, surfaces)) = surface {
                mirrors.surface(&mut surface);
                output::write_surface(&path, &surface, &reference, is_compressed)?;
                surfaces.write()?;
            }
            if let Some((path, cells, collection)) = cells {
                output::write_cells(&path, &cells, &frame, &reference, is_compressed)?;
                collection.write()?;
            }
            output::write_frame(&path, frame, &gradients, Some(&reference), is_compressed)?;
            particles.write()?;
            views.into_iter().try_for_each(|write| write())
        })?;
        self.probes.flush()?;
        self.history.flush()
    }

    fn step(&mut self, simulation: &Flow<D>, dt: f64) -> Result<ControlFlow<()>, OutputError> {
        self.background.check()?;
        let (step, time) = (simulation.steps(), simulation.time());
        if step.is_multiple_of(self.history_every) {
            let plan = &self.plan;
            let scales = self
                .coefficients
                .get_or_insert_with(|| Coefficients::new(plan, simulation));
            let loads = simulation.loads();
            let bodies = loads.iter().take(simulation.problem().bodies.len());
            let coefficients: Vec<_> = bodies.enumerate().map(|(n, l)| scales.of(n, l)).collect();
            let first = coefficients.first().copied().flatten();
            self.latest = first.map(|first| self.lately.add(first.cd, first.cl));
            let numbers = 0..simulation.problem().bodies.len();
            let motions: Vec<_> = numbers
                .filter_map(|number| BodyMotion::of(simulation, number))
                .collect();
            self.history.add(HistoryRow {
                step,
                time,
                dt,
                loads: &loads,
                totals: simulation.totals(),
                coefficients: &coefficients,
                motions: &motions,
            })?;
            self.probes.add(simulation)?;
        }
        Ok((self.watch)(Progress {
            steps: step,
            time,
            end_time: self.end_time,
            dt,
            settles: simulation.problem().method.settles(),
            coefficients: self.latest,
        }))
    }

    fn is_checkpoint_due(&self) -> bool {
        self.last_checkpoint.elapsed() >= self.checkpoint_every
    }

    fn checkpoint(&mut self, run: Checkpoint<'_, D>) -> Result<(), OutputError> {
        self.history.flush()?;
        self.probes.flush()?;
        self.written.history = self.history.bytes();
        self.written.probes = self.probes.bytes();
        let content = (&self.scene, &self.written, run);
        let draft = self.drafts.draft(&content)?;
        self.background.hand(move || draft.finish())?;
        self.last_checkpoint = Instant::now();
        Ok(())
    }

    fn finish(&mut self) -> Result<(), OutputError> {
        self.background.finish()
    }
}

fn frame_name(number: usize) -> String {
    format!("frame-{number:06}.vtp")
}

fn ghosts_name(number: usize) -> String {
    format!("ghosts-{number:06}.vtp")
}

fn surface_name(number: usize) -> String {
    format!("surface-{number:06}.vtp")
}

fn cells_name(number: usize) -> String {
    format!("cells-{number:06}.vtu")
}

/// What a frame is said to show: a time, or the iteration of a flow that settles, which goes through no time.
fn shown_time<const D: usize>(simulation: &Flow<D>) -> f64 {
    if simulation.problem().method.settles() {
        simulation.steps() as f64
    } else {
        simulation.time()
    }
}

/// What the run of a case is measured by.
fn reference<const D: usize>(case: &Case<D>) -> Reference {
    let problem = &case.problem;
    let stream = &problem.free_stream;
    Reference {
        pressure: stream.pressure,
        density: stream.density,
        velocity: std::array::from_fn(|k| stream.velocity.get(k).copied().unwrap_or(0.0)),
        gases: problem.gases(),
        gas_constant: case.plan.gas_constant,
        spacing: problem.resolution.lattice(),
        bodies: problem
            .bodies
            .iter()
            .map(|body| [body.reference_area, body.reference_length])
            .collect(),
    }
}

/// Names of all that carries a load, in the solver's order: bodies, then wall sides.
fn load_names<const D: usize>(case: &Case<D>) -> Vec<String> {
    let bodies = case.problem.bodies.iter().map(|body| body.name.clone());
    let walls = wall_sides(&case.problem.domain).into_iter();
    let walls = walls.map(|(axis, end)| side_name(axis, end));
    bodies.chain(walls).collect()
}
