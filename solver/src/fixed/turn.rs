//! How gas turns where it meets a wall.

use super::calmness::resolution;
use super::image::Image;
use super::limiter::minmod;
use super::state::{Primitive, dot};

/// How the gas of a cell turns into its wall or away from it, where cells are too coarse for it: behind a sharp bend.
///
/// What comes to the wall is `p + rho a u_n`. A fan leaves it as it is: as much as its gas has still to turn, `rho a u_n`, the pressure has
/// still to change. To draw out the speed to the wall, where it ends, and not the pressure, is to send a wave from the wall that is not there.
/// The cell's own acceleration into the wall, less that along the bend, tells how much the pressure changes up to the wall, in which it ends
/// as well: half of `rho d (u.grad u_n - u.K u)`.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// The cell's speed into the wall.
    own: f64,
    /// The same at the wall by the smaller of both slopes.
    least: f64,
    /// `d (u.grad u_n - u.K u)`, along the wall.
    pub change: f64,
    /// How much all this counts: from zero where the cells are fine enough to one.
    share: f64,
}

impl Turn {
    /// Of a `cell` with these `slopes` and calmness at the wall of its `image`, whose bend accelerates it by `along`.
    pub fn of<const D: usize>(
        image: &Image<D>,
        cell: &Primitive<D>,
        slopes: &[Primitive<D>; D],
        along: f64,
        calmness: f64,
    ) -> Self {
        let Image {
            normal, distance, ..
        } = image;
        let own = dot(&cell.velocity, normal);
        let (mut turn, mut rise) = (0.0, 0.0);
        for axis in 0..D {
            let slope = dot(&slopes[axis].velocity, normal);
            turn += (cell.velocity[axis] - own * normal[axis]) * slope;
            rise += 2.0 * distance * normal[axis] * slope;
        }
        let jump = -2.0 * own;
        // Cells of first order know no slopes.
        let share = if calmness < 0.0 {
            0.0
        } else {
            1.0 - resolution(calmness)
        };
        Self {
            own,
            least: own + 0.5 * minmod(2.0 * rise - jump, jump),
            change: share * distance * (turn - along),
            share,
        }
    }

    /// The same where gas is turned away from its wall: no more than what its own speed into the wall asks, `2 a u_n`. Gas that slides along its
    /// wall and meets a ramp in the next cell is not turned yet.
    pub fn held(self, sound: f64) -> Self {
        let most = -2.0 * sound * self.own.max(0.0);
        Self {
            change: self.change.max(most),
            ..self
        }
    }

    /// Speed into the wall at the wall, where that of a resolved flow is `drawn_out`.
    pub fn speed(&self, drawn_out: f64, sound: f64) -> f64 {
        let speed = drawn_out + self.share * (self.least - drawn_out);
        let rise = speed - self.own;
        let lessened = if rise * self.change > 0.0 {
            let left = 1.0 - self.change / (rise * sound);
            left.max(0.0)
        } else {
            1.0
        };
        self.own + lessened * rise
    }
}
