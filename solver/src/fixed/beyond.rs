//! What is beyond the sides of the domain.

use super::riding::Riding;
use super::state::Primitive;
use crate::method::Time;
use crate::problem::{Problem, Side as SideKind, State};
use crate::sides::{Answering, Place};

/// What is beyond a side.
#[derive(Clone, Copy, Debug)]
pub enum Beyond<const D: usize> {
    /// Gas in this state: inlets and free streams.
    Stream(Primitive<D>),
    /// A stream in this state that is slower than sound, in a flow that settles: what comes in has its entropy and total enthalpy.
    Total(Primitive<D>),
    /// More of the same gas.
    Same,
    /// More of the same gas, as long as it leaves. Gas that came back would bring what the flow itself holds, and more of it the more
    /// it holds: a flow that settles could blow itself up.
    OneWay,
    /// The mirror image.
    Mirror,
    /// Gas that answers to the cell, and moves along the side at this velocity.
    Answers(Answering, [f64; D]),
    /// Gas that a wave comes from which changes in time, and that moves along the side at this velocity.
    Rides(Riding, [f64; D]),
}

impl<const D: usize> Beyond<D> {
    /// What is beyond the `side` of `problem`, or the part of one, at `place`.
    ///
    /// # Errors
    /// Of a side that has no open faces.
    pub fn of(problem: &Problem<D>, side: SideKind, place: Place) -> Result<Self, String> {
        let stream = Primitive::of(&problem.free_stream);
        let Place { axis, end, .. } = place;
        match side {
            SideKind::FreeStream
                if problem.method.settles() && problem.stream_mach() < 1.0 && has_room(problem) =>
            {
                Ok(Self::Total(stream))
            }
            // The Riemann problem with the free stream lets sound out.
            SideKind::Inlet | SideKind::SoftInlet | SideKind::FreeStream => {
                Ok(Self::Stream(stream))
            }
            SideKind::Outlet => Ok(match problem.method.fixed().map(|points| points.time) {
                Some(Time::Settle) => Self::OneWay,
                _ => Self::Same,
            }),
            SideKind::Symmetry | SideKind::Axis => Ok(Self::Mirror),
            side => Answering::of(problem, side, place)
                .map(|answering| {
                    let mut drift = [0.0; D];
                    if answering.drifts() {
                        drift = stream.velocity;
                        drift[axis] = 0.0;
                    }
                    match answering {
                        Answering::Held(held) if held.relaxes() => {
                            Self::Rides(Riding::new(held), drift)
                        }
                        _ => Self::Answers(answering, drift),
                    }
                })
                .ok_or_else(|| {
                    format!("side {end} of axis {axis} is {side:?} and should have no open faces")
                }),
        }
    }

    /// The same beside gas whose state, of an outlet the pressure, is now this.
    #[must_use]
    pub fn at(self, given: &State<D>) -> Self {
        match self {
            Self::Stream(_) | Self::Total(_) => self.with_stream(Primitive::of(given)),
            Self::Answers(answering, drift) => Self::Answers(answering.at(given), drift),
            Self::Rides(riding, drift) => Self::Rides(riding.at(given.pressure), drift),
            Self::Same | Self::OneWay | Self::Mirror => self,
        }
    }

    /// The same where that is another stream.
    #[must_use]
    pub fn with_stream(self, stream: Primitive<D>) -> Self {
        match self {
            Self::Stream(_) => Self::Stream(stream),
            Self::Total(_) => Self::Total(stream),
            other => other,
        }
    }

    /// True where the state beyond counts in the gradients.
    pub fn is_known(&self) -> bool {
        matches!(self, Self::Stream(_) | Self::Total(_) | Self::Mirror)
    }
}

/// True where the stream can go around bodies, aside of its way. In a duct the side keeps its speed instead: with its total state alone, what
/// bodies cost would slow all of it.
fn has_room<const D: usize>(problem: &Problem<D>) -> bool {
    let (sides, along) = (&problem.domain.sides, problem.free_stream.velocity.iamax());
    (0..D).any(|axis| axis != along && sides[axis].iter().any(is_free))
}

/// True of a side that gas goes through as the stream does.
pub(super) fn is_free(side: &SideKind) -> bool {
    side.is_open() && !side.is_reservoir()
}
