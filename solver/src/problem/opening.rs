//! What open sides have beyond them where that is not the free stream, and sides that are made of parts.

use std::sync::Arc;

use aero_geometry::{Bounds, Vector};

use super::State;
use super::side::Side;

/// A part of a side that is another one than the rest; or, of a whole side, the state of the gas beyond it.
#[derive(Clone, Debug)]
pub struct Opening<const D: usize> {
    /// Axis across the side.
    pub axis: usize,
    /// 0 for the lower side, 1 for the upper one.
    pub end: usize,
    /// The box that the part lies in, whatever that says of the axis across it; none of a whole side.
    pub part: Option<Bounds<D>>,
    /// What it is.
    pub side: Side,
    /// State of the gas beyond it, of an outlet its pressure; none where that is the free stream, or what `side` says.
    pub given: Option<Given<D>>,
}

impl<const D: usize> Opening<D> {
    /// True of a place that the part lies in front of, or behind; of any place where it is no part.
    pub fn faces(&self, place: &Vector<D>) -> bool {
        self.part.as_ref().is_none_or(|part| {
            let mut others = (0..D).filter(|&k| k != self.axis);
            others.all(|k| part.min[k] <= place[k] && place[k] < part.max[k])
        })
    }

    /// Distance of `place` from it, where the side's face is at `plane`; zero beyond it.
    pub fn distance(&self, place: &Vector<D>, plane: f64) -> f64 {
        let depth = [place[self.axis] - plane, plane - place[self.axis]][self.end].max(0.0);
        let Some(part) = &self.part else {
            return depth;
        };
        let mut square = depth * depth;
        for k in (0..D).filter(|&k| k != self.axis) {
            let aside = (part.min[k] - place[k]).max(place[k] - part.max[k]);
            square += aside.max(0.0).powi(2);
        }
        square.sqrt()
    }
}

/// The state of the gas there and then.
type Law<const D: usize> = dyn Fn(&Vector<D>, f64) -> State<D> + Send + Sync;

/// A state of the gas as a function of position and time.
#[derive(Clone)]
pub struct Given<const D: usize>(pub Arc<Law<D>>);

impl<const D: usize> Given<D> {
    /// The state there and then.
    pub fn at(&self, position: &Vector<D>, time: f64) -> State<D> {
        self.0(position, time)
    }
}

impl<const D: usize> std::fmt::Debug for Given<D> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Given")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_faced_between_its_edges_and_is_as_far_as_its_rim() {
        let opening = Opening {
            axis: 0,
            end: 1,
            part: Some(Bounds::new(
                Vector::<2>::new(1.0, 0.2),
                Vector::<2>::new(1.0, 0.5),
            )),
            side: Side::Outlet,
            given: None,
        };
        let at = |x: f64, y: f64| Vector::<2>::new(x, y);
        assert!(opening.faces(&at(0.3, 0.2)) && opening.faces(&at(1.4, 0.49)));
        assert!(!opening.faces(&at(0.3, 0.5)) && !opening.faces(&at(0.3, 0.1)));
        assert_eq!(opening.distance(&at(0.7, 0.3), 1.0), 1.0 - 0.7);
        assert!((opening.distance(&at(0.7, 0.9), 1.0) - 0.5).abs() < 1e-15);
        assert_eq!(opening.distance(&at(1.2, 0.3), 1.0), 0.0);
    }
}
