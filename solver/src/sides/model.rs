//! Where an open side is, and what a model of it is.

use std::fmt::Debug;

use aero_geometry::Vector;

use super::particle::OpenParticle;
use crate::particles::Particle;
use crate::problem::{Domain, Opening, Problem, State};

/// Where an open side is: a face of the domain, or a part of one.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Axis across the face.
    pub axis: usize,
    /// 0 for the lower face, 1 for the upper one.
    pub end: usize,
    /// Coordinate of the face.
    pub face: f64,
    /// Where a part of it begins and ends along each axis.
    pub part: Option<[[f64; 2]; 3]>,
}

impl Place {
    /// The whole side at `end` of `axis`.
    pub fn whole<const D: usize>(domain: &Domain<D>, axis: usize, end: usize) -> Self {
        Self {
            axis,
            end,
            face: domain.face(axis, end),
            part: None,
        }
    }

    /// Where `opening` is.
    pub fn of<const D: usize>(domain: &Domain<D>, opening: &Opening<D>) -> Self {
        let ends = |k: usize| match &opening.part {
            Some(part) if k < D && k != opening.axis => [part.min[k], part.max[k]],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        };
        Self {
            part: opening.part.map(|_| std::array::from_fn(ends)),
            ..Self::whole(domain, opening.axis, opening.end)
        }
    }

    /// True of a position that it lies in front of, or behind.
    pub fn faces<const D: usize>(&self, position: &Vector<D>) -> bool {
        self.part.is_none_or(|ends| {
            let mut ends = ends.iter().zip(position);
            ends.all(|([low, high], x)| low <= x && x < high)
        })
    }

    /// Its middle.
    pub fn middle<const D: usize>(&self, domain: &Domain<D>) -> Vector<D> {
        let bounds = &domain.bounds;
        Vector::from_fn(|k, _| {
            if k == self.axis {
                return self.face;
            }
            let whole = [bounds.min[k], bounds.max[k]];
            let [low, high] = self.part.map_or(whole, |ends| ends[k]);
            0.5 * (low + high)
        })
    }

    /// How far `position` is beyond the face; negative in front of it.
    pub fn depth<const D: usize>(&self, position: &Vector<D>) -> f64 {
        if self.end == 0 {
            self.face - position[self.axis]
        } else {
            position[self.axis] - self.face
        }
    }

    /// True beyond the face. The lower face belongs to the domain, the upper one does not, so that neighbouring cells of the
    /// lattice never claim the same point.
    pub fn is_beyond(&self, depth: f64) -> bool {
        if self.end == 0 {
            depth > 0.0
        } else {
            depth >= 0.0
        }
    }

    /// Direction into the domain along the axis.
    pub fn inward(&self) -> f64 {
        if self.end == 0 { 1.0 } else { -1.0 }
    }
}

/// How gas crosses an open side: a published model. All but the first have an answer that fits a side that asks nothing of
/// the flow inside.
pub trait OpenModel<const D: usize>: Debug + Send + Sync {
    /// State of the gas that enters at first; none through a side that gas only leaves by.
    fn inflow(&self, problem: &Problem<D>) -> Option<State<D>>;

    /// State in which gas enters from now on, after a step from one time to another that left the flow inside as `fluid`, and in
    /// which it entered in state `before`; none where it stays as it was, and for a model that never answers.
    fn answer(
        &self,
        _problem: &Problem<D>,
        _fluid: &[Particle<D>],
        _before: &State<D>,
        _times: [f64; 2],
    ) -> Option<State<D>> {
        None
    }

    /// True where [`Self::answer`] may ever change the state.
    fn answers(&self) -> bool {
        false
    }

    /// State of the gas that enters at `position` of the buffer at `time`, where that of the stream as a whole is
    /// `stream`: a profile in space and time.
    fn profile(&self, stream: &State<D>, _position: &Vector<D>, _time: f64) -> State<D> {
        *stream
    }

    /// What becomes, in a step from one time to another, of the particles of the buffer that have left the domain here, `gone`, in the order in which
    /// the buffer keeps them; they have drifted on already. `fluid` is the flow inside; where they have left in this very step, `older` are those that
    /// left before.
    fn go_on(
        &self,
        _problem: &Problem<D>,
        _fluid: &[Particle<D>],
        _gone: &mut [OpenParticle<D>],
        _older: &[OpenParticle<D>],
        _times: [f64; 2],
    ) {
    }

    /// True where [`Self::go_on`] may do anything.
    fn goes_on(&self) -> bool {
        false
    }

    /// The state in which gas comes back in at each of some `places` at the outer end of the buffer, where it does and nothing is there yet; `gone` is
    /// what has left the domain here.
    fn come_back(
        &self,
        _problem: &Problem<D>,
        _gone: &[OpenParticle<D>],
        places: &[Vector<D>],
        _now: f64,
    ) -> Vec<Option<State<D>>> {
        vec![None; places.len()]
    }
}
