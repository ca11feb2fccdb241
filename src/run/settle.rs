//! Runs that go to the steady flow without regard to time.

use aero_solver::Flow;
use aero_solver::fixed::Settled;
use aero_solver::frame::Frame;
use aero_solver::problem::{Problem, Side};

use super::error::RunError;
use super::recorder::Recorder;
use super::steady::Window;
use super::swing::spread;
use super::under_way::UnderWay;
use crate::output::Summary;

/// After so many iterations a flow that has not settled will not: from one end of a thousand points to the other it takes some two
/// thousand.
const MOST: u64 = 5000;

/// The same of viscous gas: layers grow slowly.
const MOST_VISCOUS: u64 = 20_000;

/// Total enthalpy over the stream's above which a state is none that a steady flow comes to: there it is that of the stream everywhere, and
/// what a coarse lattice makes of it is off by parts of it.
const SENSELESS: f64 = 3.0;

impl<const D: usize> UnderWay<D> {
    /// Iterates until the flow has settled, or shows that it will not.
    pub(super) fn settle(&mut self, recorder: &mut dyn Recorder<D>) -> Result<Summary, RunError> {
        let problem = self.simulation.problem();
        let bodies = problem.bodies.len();
        let most = if problem.gas.is_viscous() {
            MOST_VISCOUS
        } else {
            MOST
        };
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
            if settled.is_settled || settled.iterations >= most {
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
        if let Some(reason) = senseless(&self.simulation) {
            return Err(self.stop(recorder, reason));
        }
        recorder.frame(&self.simulation)?;
        recorder.finish()?;
        self.tally.settle(window);
        Ok(self.tally.summary(&self.simulation, &reason))
    }
}

/// What is wrong with a flow that has come to rest with more energy in a point than a stream brings; none where nothing is, or where energy
/// comes from elsewhere.
fn senseless<const D: usize>(flow: &Flow<D>) -> Option<String> {
    let problem = flow.problem();
    if !problem.has_one_enthalpy() || !problem.domain.has(Side::lets_in) {
        return None;
    }
    let (most, place) = hottest(&flow.frame())?;
    let part = most / of_stream(problem);
    (part.is_nan() || part > SENSELESS).then(|| {
        format!(
            "the flow came to rest in a state that makes no sense: the total enthalpy at ({:.4}, {:.4}, {:.4}) is {part:.1e} times \
             that of the stream; use another `spacing`",
            place[0], place[1], place[2]
        )
    })
}

/// The largest total enthalpy of a point, `e + p / rho + u^2 / 2`, and where that is.
fn hottest(frame: &Frame) -> Option<(f64, [f64; 3])> {
    let total = |n: usize| {
        let square: f64 = frame.velocity[n].iter().map(|u| u * u).sum();
        frame.energy[n] + frame.pressure[n] / frame.density[n] + 0.5 * square
    };
    let each = (0..frame.position.len()).map(|n| (total(n), frame.position[n]));
    each.max_by(|a, b| a.0.total_cmp(&b.0))
}

/// Total enthalpy of the free stream.
fn of_stream<const D: usize>(problem: &Problem<D>) -> f64 {
    let stream = &problem.free_stream;
    let energy = problem.gas.energy(stream.density, stream.pressure);
    energy + stream.pressure / stream.density + 0.5 * stream.velocity.norm_squared()
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Bounds, Vector};
    use aero_solver::gas::Gas;
    use aero_solver::method::{FixedPoints, Method};
    use aero_solver::problem::{Domain, Field, Initial, State};

    use super::*;

    /// Gas at rest at this pressure, in a tube whose stream has a total enthalpy of 4.5.
    fn tube(sides: [Side; 2], pressure: f64) -> Flow<1> {
        let state = |speed: f64, pressure: f64| State {
            density: 1.4,
            velocity: Vector::<1>::new(speed),
            pressure,
        };
        let bounds = Bounds::new(Vector::zeros(), Vector::repeat(1.0));
        let domain = Domain::new(bounds, [sides]);
        let flow = Flow::new(Problem {
            method: Method::Fixed(FixedPoints::default()),
            initial: Initial::Field(Field(Arc::new(move |_| state(0.0, pressure)))),
            ..Problem::new(Gas::ideal(1.4), domain, state(2.0, 1.0), 0.1)
        });
        flow.expect("a tube")
    }

    /// `e + p / rho = 3.5 p / rho`: 2.8 and 3.3 times that of the stream.
    #[test]
    fn a_flow_at_rest_with_more_energy_than_its_stream_brings_makes_no_sense() {
        let open = [Side::Inlet, Side::Outlet];
        assert_eq!(senseless(&tube(open, 5.0)), None);
        let told = senseless(&tube(open, 6.0)).expect("a reason");
        for words in ["makes no sense", "3.3e0 times", "`spacing`"] {
            assert!(told.contains(words), "{told}");
        }
        // What is closed in had its energy from the start.
        assert_eq!(senseless(&tube([Side::Symmetry; 2], 6.0)), None);
    }

    #[test]
    fn the_hottest_point_is_found_even_if_its_state_is_no_number() {
        let mut frame = Frame {
            position: vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
            velocity: vec![[3.0, 4.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0]],
            density: vec![1.0, 2.0, 1.0],
            pressure: vec![1.0, 40.0, 1.0],
            energy: vec![2.5, 50.0, 2.5],
            ..Frame::default()
        };
        assert_eq!(hottest(&frame), Some((70.0, [1.0, 0.0, 0.0])));
        frame.density[2] = f64::NAN;
        assert!(hottest(&frame).is_some_and(|(most, place)| most.is_nan() && place[0] == 2.0));
    }
}
