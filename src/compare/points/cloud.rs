//! Points, and which of them the kernel reaches.

use aero_geometry::kernel::SUPPORT;
use aero_geometry::{Pencils, Vector};

/// Smoothing length over spacing, of the paper (eq 6).
pub const SMOOTHING_RATIO: f64 = 1.2;

/// Points and what is near them.
#[derive(Clone, Debug)]
pub struct Cloud {
    pub points: Vec<Vector<2>>,
    pencils: Pencils<2>,
    reach: f64,
    /// Distance of neighbours, m.
    pub spacing: f64,
    /// Smoothing length, m.
    pub smoothing: f64,
}

impl Cloud {
    pub fn new(points: Vec<Vector<2>>, spacing: f64) -> Self {
        let smoothing = SMOOTHING_RATIO * spacing;
        let reach = SUPPORT * smoothing;
        Self {
            pencils: Pencils::new(&points, reach),
            points,
            reach,
            spacing,
            smoothing,
        }
    }

    /// Calls `visit` with each point in the kernel's support about `place`, and the way there.
    pub fn near(&self, place: &Vector<2>, mut visit: impl FnMut(usize, Vector<2>)) {
        let order = self.pencils.order();
        self.pencils
            .for_each_run_near(place, place, self.reach, |run| {
                for &point in &order[run] {
                    let arm = self.points[point as usize] - place;
                    if arm.norm_squared() < self.reach * self.reach {
                        visit(point as usize, arm);
                    }
                }
            });
    }
}
