//! Runs that go to the steady flow without regard to time.

use aero_solver::fixed::Settled;

use super::error::RunError;
use super::recorder::Recorder;
use super::steady::Window;
use super::swing::spread;
use super::under_way::UnderWay;
use crate::output::Summary;

/// After so many iterations a flow that has not settled will not: from one end of a thousand points to the other it takes some two
/// thousand.
const MOST: u64 = 5000;

impl<const D: usize> UnderWay<D> {
    /// Iterates until the flow has settled, or shows that it will not.
    pub(super) fn settle(&mut self, recorder: &mut dyn Recorder<D>) -> Result<Summary, RunError> {
        let bodies = self.simulation.problem().bodies.len();
        let (reason, window) = loop {
            let settled = match self.simulation.settle_step() {
                Some(Ok(settled)) => settled,
                Some(Err(failure)) => return Err(self.stop(recorder, failure.to_string())),
                None => {
                    let reason = "particles move with the gas and cannot be settled".to_owned();
                    return Err(self.stop(recorder, reason));
                }
            };
            let wish = recorder.step(&self.simulation, 1.0)?;
            if settled.is_settled || settled.iterations >= MOST {
                let last = self.swing.last().filter(|_| !settled.is_settled);
                let window = last.unwrap_or_else(|| Window::now(&self.simulation, bodies));
                break (verdict(&settled), window);
            }
            if let Some(window) = self.swing.add(&self.simulation) {
                break (in_the_mean(&settled, &window), window);
            }
            if wish.is_break() || recorder.is_checkpoint_due() {
                recorder.checkpoint(self.checkpoint())?;
            }
            if wish.is_break() {
                if let Some(window) = self.swing.last() {
                    self.tally.settle(window);
                }
                return Err(self.stop(recorder, format!("interrupted ({})", self.moment())));
            }
        };
        recorder.frame(&self.simulation)?;
        recorder.finish()?;
        self.tally.settle(window);
        Ok(self.tally.summary(&self.simulation, &reason))
    }
}

/// How the loads came to be steady though the flow swings.
fn in_the_mean(settled: &Settled, window: &Window) -> String {
    format!(
        "settled in the mean after {} iterations: mean forces no longer change, the flow swings by {:.1e} of the largest about \
         them",
        settled.iterations,
        spread(window)
    )
}

/// How the flow came to rest, or that it did not.
fn verdict(settled: &Settled) -> String {
    let Settled {
        iterations,
        residual,
        change,
        is_settled,
    } = settled;
    let word = if *is_settled {
        "settled"
    } else {
        "not settled"
    };
    format!(
        "{word} after {iterations} iterations: forces, mass and its centre change by {change:.1e} at most, \
         residual {residual:.1e}"
    )
}
