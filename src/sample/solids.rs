//! Bodies as they lie between the points of the gas.

use std::fmt;

use aero_geometry::{Shape, Vector};
use aero_solver::Pose;
use aero_solver::problem::Body;

/// The nearest surface, from a place near it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<const D: usize> {
    /// Number of the body.
    pub body: usize,
    /// Signed distance, negative in the body.
    pub distance: f64,
    /// Out of the body, in its own axes.
    pub normal: Vector<D>,
}

/// Distance and normal at a place, if that is within a reach.
type Near<'a, const D: usize> =
    Box<dyn Fn(&Vector<D>, f64) -> Option<(f64, Vector<D>)> + Sync + 'a>;

/// Bodies at one time.
pub struct Solids<'a, const D: usize>(Vec<Near<'a, D>>);

impl<const D: usize> fmt::Debug for Solids<'_, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Solids({})", self.0.len())
    }
}

impl<'a, const D: usize> Solids<'a, D> {
    /// No bodies.
    pub fn none() -> Self {
        Self(Vec::new())
    }

    /// Bodies where their `pose` has them, by their numbers.
    pub fn new(bodies: &'a [Body<D>], pose: impl Fn(usize) -> Pose<D>) -> Self {
        let near = |(number, body): (usize, &'a Body<D>)| -> Near<'a, D> {
            let (bounds, pose) = (body.shape.bounds(), pose(number));
            let is_moving = body.motion.is_moving();
            Box::new(move |place, reach| {
                let origin = if is_moving {
                    pose.origin(place)
                } else {
                    *place
                };
                bounds.grown(reach).contains(&origin).then(|| {
                    let closest = body.shape.closest(&origin);
                    (closest.distance, closest.normal)
                })
            })
        };
        Self(bodies.iter().enumerate().map(near).collect())
    }

    /// The section of a body in space by `z = 0`, or the body itself.
    pub fn section(shape: &'a dyn Shape<3>) -> Self {
        let bounds = shape.bounds();
        Self(vec![Box::new(move |place, reach| {
            let full = Vector::<3>::from_fn(|k, _| if k < D { place[k] } else { 0.0 });
            bounds.grown(reach).contains(&full).then(|| {
                let closest = shape.closest(&full);
                (closest.distance, Vector::from_fn(|k, _| closest.normal[k]))
            })
        })])
    }

    /// The nearest surface within `reach` of a place, or around it.
    pub fn contact(&self, place: &Vector<D>, reach: f64) -> Option<Contact<D>> {
        let near = self.0.iter().enumerate().filter_map(|(body, near)| {
            let (distance, normal) = near(place, reach)?;
            (distance < reach).then_some(Contact {
                body,
                distance,
                normal,
            })
        });
        near.min_by(|a, b| a.distance.total_cmp(&b.distance))
    }

    /// True in a body.
    pub fn hold(&self, place: &Vector<D>) -> bool {
        let contact = self.contact(place, 0.0);
        contact.is_some_and(|contact| contact.distance < 0.0)
    }

    /// True where a body stands between two places, each with the surface that it is near; of a place in a body, where the other
    /// is not on its side.
    pub(super) fn hides(
        &self,
        (place, own): (&Vector<D>, Option<&Contact<D>>),
        (there, other): (&Vector<D>, Option<&Contact<D>>),
    ) -> bool {
        /// Cosine of the least angle between the normals of two faces that a part between them may hide.
        const TURNED: f64 = 0.5;
        let (Some(own), Some(other)) = (own, other) else {
            return false;
        };
        let turned = own.normal.dot(&other.normal);
        if own.distance < 0.0 {
            return own.body == other.body && turned < 0.0;
        }
        (own.body != other.body || turned < TURNED) && self.cross(place, there)
    }

    /// True where the way from one place to another leads through a body.
    fn cross(&self, from: &Vector<D>, to: &Vector<D>) -> bool {
        /// Steps, and depths that are none, in lengths of the way.
        const STEP: f64 = 0.02;
        const NONE: f64 = 1e-3;
        let way = to - from;
        let length = way.norm();
        let mut part = 0.0;
        while part < 1.0 {
            let contact = self.contact(&(from + way * part), length);
            let distance = contact.map_or(length, |contact| contact.distance);
            if distance < -NONE * length {
                return true;
            }
            part += (distance / length).max(STEP);
        }
        false
    }
}
