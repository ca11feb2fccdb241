//! A run that writes frames, history, checkpoints and summary into a folder.

use std::ops::ControlFlow;

use super::checkpoint;
use super::claim::Claim;
use super::destination::Destination;
use super::error::RunError;
use super::progress::Progress;
use super::recorder::FileRecorder;
use super::stopwatch::Stopwatch;
use super::under_way::UnderWay;
use crate::case::{AnyCase, Case};
use crate::output::{self, CheckpointError, Summary};

/// Runs a case of any dimension to its end on the current thread pool, with frames, history,
/// checkpoints and summary in a folder.
///
/// `stopwatch` was started where the cost of the run begins, packing included; `watch` is called
/// after every step, and may ask the run to stop there. Whoever calls this function need not compile
/// the solver once more.
///
/// # Errors
/// A run that fails leaves its last good frame and its summary in the folder all the same.
pub fn run_any(
    case: AnyCase,
    destination: Destination<'_>,
    stopwatch: Stopwatch,
    watch: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    match case {
        AnyCase::One(case) => run(*case, destination, stopwatch, watch),
        AnyCase::Two(case) => run(*case, destination, stopwatch, watch),
        AnyCase::Three(case) => run(*case, destination, stopwatch, watch),
    }
}

fn run<const D: usize>(
    case: Case<D>,
    destination: Destination<'_>,
    stopwatch: Stopwatch,
    watch: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let Destination { folder, scene, .. } = destination;
    output::make_folder(folder)?;
    let _claim = Claim::new(&destination)?;
    let earlier = if destination.resume {
        checkpoint::read(folder, scene, case.plan.end_time)?
    } else {
        None
    };
    // No later end brings it any further.
    let has_settled = case.problem.method.settles();
    let result = if let Some((written, checkpoint)) = earlier {
        output::reopen_checkpoint(folder)?;
        Claim::note(&destination)?;
        let mut recorder = FileRecorder::resume(folder, &case, scene, written, watch)?;
        let under_way = UnderWay::resume(case, checkpoint, stopwatch);
        let mut under_way = under_way.map_err(|reason| CheckpointError::new(folder, reason))?;
        under_way.finish(&mut recorder)
    } else {
        let mut recorder = FileRecorder::create(folder, &case, scene, watch)?;
        recorder.skips_next = destination.skips_start;
        Claim::note(&destination)?;
        UnderWay::start(case, &mut recorder, stopwatch)?.finish(&mut recorder)
    };
    let summary = match &result {
        Ok(summary) => summary,
        Err(RunError::Stopped { summary, .. }) => summary.as_ref(),
        Err(_) => return result,
    };
    output::write_json(&folder.join("summary.json"), summary)?;
    if result.is_ok() {
        if has_settled {
            output::remove_checkpoints(folder)?;
        } else {
            output::close_checkpoint(folder)?;
        }
    }
    result
}
