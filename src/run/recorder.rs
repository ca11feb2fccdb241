//! Who looks on while a run goes, and the one that writes files.

use std::fmt;
use std::path::{Path, PathBuf};

use super::Progress;
use crate::case::Case;
use crate::output::{self, Collection, History, HistoryRow, OutputError};
use crate::solver::{Simulation, wall_sides};

/// Sees a run at its frames and steps.
pub trait Recorder<const D: usize> {
    /// A frame is due: at the start, at every frame time, at the end and after a failure.
    fn frame(&mut self, simulation: &Simulation<D>) -> Result<(), OutputError>;

    /// A step of length `dt` has been taken.
    fn step(&mut self, simulation: &Simulation<D>, dt: f64) -> Result<(), OutputError>;
}

/// Writes frames, surfaces and history into a folder.
pub struct FileRecorder<'a> {
    folder: PathBuf,
    frames: u64,
    particles: Collection,
    surfaces: Option<Collection>,
    history: History,
    history_every: u64,
    end_time: f64,
    watch: &'a mut dyn FnMut(Progress),
}

impl fmt::Debug for FileRecorder<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FileRecorder")
            .field("folder", &self.folder)
            .field("frames", &self.frames)
            .finish_non_exhaustive()
    }
}

impl<'a> FileRecorder<'a> {
    /// Starts to record `case` into `folder`, which exists; `watch` is called after every step.
    pub fn create<const D: usize>(
        folder: &Path,
        case: &Case<D>,
        watch: &'a mut dyn FnMut(Progress),
    ) -> Result<Self, OutputError> {
        let names = load_names(case);
        Ok(Self {
            folder: folder.to_owned(),
            frames: 0,
            particles: Collection::new(folder.join("run.pvd")),
            surfaces: (!names.is_empty()).then(|| Collection::new(folder.join("surface.pvd"))),
            history: History::create(&folder.join("history.csv"), &names)?,
            history_every: case.output.history_every as u64,
            end_time: case.end_time,
            watch,
        })
    }
}

impl<const D: usize> Recorder<D> for FileRecorder<'_> {
    fn frame(&mut self, simulation: &Simulation<D>) -> Result<(), OutputError> {
        let number = self.frames;
        let time = simulation.time();
        let name = format!("frame-{number:06}.vtp");
        output::write_frame(&self.folder.join(&name), &simulation.frame())?;
        self.particles.add(time, &name)?;
        if let Some(surfaces) = &mut self.surfaces {
            let name = format!("surface-{number:06}.vtp");
            output::write_surface(&self.folder.join(&name), &simulation.surface())?;
            surfaces.add(time, &name)?;
        }
        self.frames += 1;
        self.history.flush()
    }

    fn step(&mut self, simulation: &Simulation<D>, dt: f64) -> Result<(), OutputError> {
        let (step, time) = (simulation.steps(), simulation.time());
        if step.is_multiple_of(self.history_every) {
            self.history.add(HistoryRow {
                step,
                time,
                dt,
                loads: &simulation.loads(),
                totals: simulation.totals(),
            })?;
        }
        (self.watch)(Progress {
            steps: step,
            time,
            end_time: self.end_time,
            dt,
        });
        Ok(())
    }
}

/// Names of all that carries a load, in the solver's order: bodies, then wall sides.
fn load_names<const D: usize>(case: &Case<D>) -> Vec<String> {
    let bodies = case.bodies.iter().map(|body| body.name.clone());
    let walls = wall_sides(&case.domain).into_iter();
    let walls =
        walls.map(|(axis, end)| format!("{}_{}", ["x", "y", "z"][axis], ["min", "max"][end]));
    bodies.chain(walls).collect()
}
