//! A particle on its way to its place in a thin part.

use aero_geometry::Vector;

use super::ball::chord;
use super::sites::Site;
use crate::plan::Plan;

/// A place is brought back to the middle by this many spacings at most.
const FARTHEST: f64 = 0.5;

/// Particles off a mirror plane keep this far from it, in spacings.
const OFF_PLANE: f64 = 0.35;

/// A particle and the row in which it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seat<const D: usize> {
    /// Where it is.
    pub place: Vector<D>,
    /// Layer that it counts in.
    pub layer: u32,
    row: Site<D>,
}

impl<const D: usize> Seat<D> {
    /// On a site.
    pub fn on(site: &Site<D>) -> Self {
        Self {
            place: site.place,
            layer: site.layer,
            row: *site,
        }
    }

    /// True where a site belongs to the row on the other side.
    pub fn is_across(&self, site: &Site<D>) -> bool {
        self.row.is_across(site)
    }

    /// Moves it to `middle`, brought onto its row; mirror planes that it stands on keep it.
    pub fn move_to(&mut self, plan: &Plan<'_, D>, mut middle: Vector<D>) {
        let spacing = plan.options.spacing;
        for &(axis, position) in plan.mirrors.planes() {
            if self.place[axis] == position {
                middle[axis] = position;
            }
        }
        if !self.row.is_paired {
            middle += self.off_the_middle(plan, &middle) * self.row.normal;
        }
        for &(axis, position) in plan.mirrors.planes() {
            middle[axis] = if self.place[axis] == position {
                position
            } else {
                middle[axis].max(position + OFF_PLANE * spacing)
            };
        }
        if plan.shape.signed_distance(&middle) < 0.0 {
            self.place = middle;
        }
    }
    /// How far the middle of the chord through a place, along the normal of the row, is from it; zero where that is far.
    fn off_the_middle(&self, plan: &Plan<'_, D>, place: &Vector<D>) -> f64 {
        let spacing = plan.options.spacing;
        let longest = self.row.whole + spacing;
        let to_end = |normal: Vector<D>| chord(plan.shape, (place, &normal), longest, spacing);
        let (Some(up), Some(down)) = (to_end(-self.row.normal), to_end(self.row.normal)) else {
            return 0.0;
        };
        let off = 0.5 * (up - down);
        if off.abs() < FARTHEST * spacing {
            off
        } else {
            0.0
        }
    }
}
