//! From `initial.frame`, a frame of an earlier run, to a state of the gas as a function of position: a flow that a coarse
//! lattice has found soon settles on a fine one.

mod columns;
mod flow;

use std::path::Path;
use std::sync::Arc;

use aero_geometry::Vector;

use self::columns::{read, split, widest};
use self::flow::Flow;
use super::error::SceneError;
use aero_solver::problem::{Earlier, Field, Initial, Split, State};

/// Length of the sum of two directions below which they are opposed, and nothing says about what to turn.
const OPPOSED: f64 = 1e-6;

/// Logarithm of the ratio of two densities or pressures, one place in two flows, above which a shock has passed between them.
const PASSED: f64 = 0.3;

/// A flow that starts as `flow`, or beyond it by a part of the way to it from another one.
pub(super) fn initial<const D: usize>(
    flow: Turned<D>,
    trend: Option<(Turned<D>, f64)>,
) -> Initial<D> {
    let (spacing, split) = (flow.spacing, flow.split.clone());
    let state = move |position: &Vector<D>| {
        let state = flow.at(position);
        match &trend {
            Some((before, part)) => beyond(&state, &before.at(position), *part),
            None => state,
        }
    };
    Initial::Earlier(Earlier {
        field: Field(Arc::new(state)),
        spacing,
        split: split.into(),
    })
}

/// The state that follows on `now` as that did on `before`, so much further; `now` where a shock has passed between them.
fn beyond<const D: usize>(now: &State<D>, before: &State<D>, part: f64) -> State<D> {
    let steps = [now.density / before.density, now.pressure / before.pressure];
    if steps.iter().any(|step| step.ln().abs() > PASSED) {
        return *now;
    }
    State {
        density: now.density * steps[0].powf(part),
        velocity: now.velocity + (now.velocity - before.velocity) * part,
        pressure: now.pressure * steps[1].powf(part),
    }
}

/// An earlier flow, turned to the stream of now.
pub(super) struct Turned<const D: usize> {
    flow: Flow<D>,
    /// Of its lattice.
    spacing: Option<f64>,
    split: Vec<Split<D>>,
    turn: Option<Turn<D>>,
}

impl<const D: usize> Turned<D> {
    /// The flow of the frame at `path`, which the key `place` gives; where its stream was another, `streams` are that one and the one
    /// it is turned to.
    ///
    /// # Errors
    /// A file that is not the frame of a run in `D` dimensions.
    pub(super) fn new(
        place: &str,
        path: &Path,
        streams: Option<[&State<D>; 2]>,
    ) -> Result<Self, SceneError> {
        let flow = read(path)
            .and_then(|columns| Ok((Flow::<D>::new(&columns)?, widest(&columns), split(&columns))));
        let (flow, spacing, split) = flow.map_err(|fault| {
            let path = path.display();
            let message =
                format!("`{path}` {fault}; give a `frame-NNNNNN.vtp` that a run has written");
            SceneError::value(place, message)
        })?;
        Ok(Self {
            flow,
            spacing,
            split,
            turn: streams.map(|[from, to]| Turn::new(from, to)),
        })
    }

    fn at(&self, position: &Vector<D>) -> State<D> {
        let state = self.flow.at(position);
        self.turn.as_ref().map_or(state, |turn| turn.of(&state))
    }
}

/// From one stream to another: turned about the line across both, and scaled.
struct Turn<const D: usize> {
    /// Across the planes of two reflections, whose product turns the one stream into the other.
    across: [Vector<D>; 2],
    speed: f64,
    density: f64,
    pressure: f64,
}

impl<const D: usize> Turn<D> {
    fn new(from: &State<D>, to: &State<D>) -> Self {
        let ways = [from, to].map(|stream| stream.velocity.try_normalize(0.0));
        let across = match ways {
            [Some(a), Some(b)] if a != b => {
                let middle = (a + b).try_normalize(OPPOSED);
                middle.map(|middle| [a, middle])
            }
            _ => None,
        };
        let [before, now] = [from, to].map(|stream| stream.velocity.norm());
        Self {
            across: across.unwrap_or([Vector::zeros(); 2]),
            speed: if before > 0.0 { now / before } else { 1.0 },
            density: to.density / from.density,
            pressure: to.pressure / from.pressure,
        }
    }

    fn of(&self, state: &State<D>) -> State<D> {
        let mirrored = |u: Vector<D>, across: &Vector<D>| u - across * (2.0 * across.dot(&u));
        let [first, second] = &self.across;
        State {
            density: self.density * state.density,
            velocity: mirrored(mirrored(state.velocity, first), second) * self.speed,
            pressure: self.pressure * state.pressure,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flow_is_turned_and_sped_up_with_its_stream() {
        let stream = |mach: f64, degrees: f64| State {
            density: 1.4,
            velocity: Vector::<2>::new(degrees.to_radians().cos(), degrees.to_radians().sin())
                * mach,
            pressure: 1.0,
        };
        let (from, to) = (stream(2.0, 3.0), stream(3.0, 8.0));
        let turn = Turn::new(&from, &to);
        assert!((turn.of(&from).velocity - to.velocity).norm() < 1e-14);
        // What flows at ten degrees to the one flows at ten degrees to the other.
        let aside = turn.of(&stream(1.0, 13.0));
        assert!((aside.velocity - stream(1.5, 18.0).velocity).norm() < 1e-14);
        assert_eq!((aside.density, aside.pressure), (1.4, 1.0));
    }

    #[test]
    fn a_trend_goes_on_unless_a_shock_has_passed() {
        let state = |density: f64, speed: f64| State {
            density,
            velocity: Vector::<2>::new(speed, 0.0),
            pressure: density,
        };
        let on = beyond(&state(1.1, 2.0), &state(1.0, 1.5), 0.5);
        assert!((on.density - 1.1 * 1.1_f64.sqrt()).abs() < 1e-14);
        assert_eq!(on.velocity[0], 2.25);
        let now = state(2.0, 1.0);
        assert_eq!(beyond(&now, &state(1.0, 1.5), 1.0), now);
    }
}
