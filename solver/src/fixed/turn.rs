//! Gas that turns into its wall or away from it within a cell.

use super::calmness::resolution;
use super::image::Image;
use super::limiter::minmod;
use super::state::{Primitive, dot};

/// How the gas of a cell turns into its wall or away from it, where cells are too coarse for it: behind a sharp bend.
///
/// What comes to the wall is `p + rho a u_n`. A fan leaves it as it is: as much as its gas has still to turn, `rho a u_n`, the pressure has
/// still to change. To draw out the speed to the wall, where it ends, and not the pressure, is to send a wave from the wall that is not there.
/// The cell's own acceleration into the wall, less that along the bend, tells how much the pressure changes up to the wall, in which it ends
/// as well: half of `rho d (u.grad u_n - u.K u)`. Gas that is faster than sound turns away in a steady fan, see [`super::fan`].
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// The cell's speed into the wall.
    pub own: f64,
    /// The same at the wall by the smaller of both slopes.
    least: f64,
    /// `d (u.grad u_n - u.K u)`, along the wall.
    pub change: f64,
    /// Speed along the wall in the direction in which the gas turns.
    pub along: f64,
    /// How much all this counts: from zero where the cells are fine enough to one.
    pub share: f64,
}

impl Turn {
    /// That of the gas in a `cell` beside its wall's `image`, which the bend of the wall accelerates by `along`.
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
        let slope: [f64; D] = std::array::from_fn(|k| dot(&slopes[k].velocity, normal));
        let out = dot(&slope, normal);
        let (mut turn, mut square) = (0.0, 0.0);
        for axis in 0..D {
            let aside = slope[axis] - out * normal[axis];
            turn += cell.velocity[axis] * aside;
            square += aside * aside;
        }
        let rise = 2.0 * distance * out;
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
            along: if square > 0.0 {
                turn / square.sqrt()
            } else {
                0.0
            },
            share,
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
