//! Runs that go to the steady flow without regard to time.

use super::recorder::Recorder;
use super::steady::Window;
use super::{RunError, UnderWay};
use crate::output::Summary;

impl<const D: usize> UnderWay<D> {
    /// Iterates until the flow has settled, or shows that it will not.
    pub(super) fn settle(&mut self, recorder: &mut dyn Recorder<D>) -> Result<Summary, RunError> {
        let reason = loop {
            let settling = match self.simulation.settle() {
                Ok(settling) => settling,
                Err(failure) => return Err(self.stop(recorder, failure.to_string())),
            };
            let wish = recorder.step(&self.simulation, 1.0)?;
            if let Some(end) = settling.end() {
                break end;
            }
            if wish.is_break() || recorder.is_checkpoint_due() {
                recorder.checkpoint(self.checkpoint())?;
            }
            if wish.is_break() {
                return Err(self.stop(recorder, format!("interrupted ({})", self.moment())));
            }
        };
        recorder.frame(&self.simulation)?;
        recorder.finish()?;
        let bodies = self.simulation.problem().bodies.len();
        self.tally.settle(Window::now(&self.simulation, bodies));
        Ok(self.tally.summary(&self.simulation, &reason))
    }
}
