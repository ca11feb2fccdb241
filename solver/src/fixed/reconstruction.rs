//! The states on both sides of a face, from the cells' means and slopes.

use super::limiter::{central, minmod, rising, third, wavy};
use super::real::Real;
use super::state::{Primitive, dot, scaled};

/// Part of the gap in density between both sides of a face that is left where waves rise and fall, for the fluxes to damp. All of it, as upwinding
/// of third order has, damps a wave of `k` radians a cell by `k^4 / 12`; what is left is about what that of fifth order, `k^6 / 60`, damps in
/// waves of six cells, the shortest that count.
const UPWINDING: f64 = 0.25;

/// Slopes that are off in what they say of the other cell by one over this, in parts of what they say in all, are not believed beside the line between both cells.
const NOT_BORNE_OUT: f64 = 6.0;

/// A face this part of the distance between its cells, squared, beside the line between them lies on it.
const ON_THE_LINE: f64 = 1e-20;

/// Two cells that share a face, and how much they change towards each other.
#[derive(Clone, Copy, Debug)]
pub struct Neighbours<const D: usize, R> {
    /// Means of both.
    pub means: [Primitive<D, R>; 2],
    /// Slopes of both along the line from the first to the second cell, times its length.
    pub rises: [Primitive<D, R>; 2],
    /// From zero in the strongest shocks to one elsewhere: how much of the limiter is that of central differences.
    pub smooth: R,
    /// Below zero where no slope may be used at all.
    pub order: R,
    /// Whether layers are drawn as finely as they can be: `p / rho` is straight in a cell, in place of the density, and slopes are of third order.
    pub has_layers: bool,
    /// One where slopes are differences along a line of cells that are alike, zero elsewhere; none where waves are not followed.
    pub evenness: Option<R>,
}

impl<const D: usize, R: Real> Neighbours<D, R> {
    /// States on both sides of the face, halfway between: `q_i + phi(2 rise_i - D, D) / 2` and `q_j - phi(2 rise_j - D, D) / 2`,
    /// `D = q_j - q_i`, [van Leer 1977's extrapolation with the slope beyond each cell read off its gradient]. The limiter is
    /// that of central differences, and minmod in the strongest shocks. A side whose density or pressure would not be positive takes its cell's mean.
    #[inline(always)]
    pub fn states(&self) -> [Primitive<D, R>; 2] {
        let [first, second] = &self.means;
        let [a, b] = &self.rises;
        let mut sides = self.means;
        let pressure = self.sides(first.pressure, second.pressure, a.pressure, b.pressure);
        let density = if self.has_layers {
            let [cold, hot] = self.sides(
                first.heat(),
                second.heat(),
                first.warming(a),
                second.warming(b),
            );
            [pressure[0] / cold, pressure[1] / hot]
        } else {
            let [means, rises] = [[first.density, second.density], [a.density, b.density]];
            self.closer(
                self.sides(means[0], means[1], rises[0], rises[1]),
                means,
                rises,
            )
        };
        let mut velocity = [first.velocity, second.velocity];
        for k in 0..D {
            let [u, v] = [first.velocity[k], second.velocity[k]];
            [velocity[0][k], velocity[1][k]] = self.sides(u, v, a.velocity[k], b.velocity[k]);
        }
        for side in 0..2 {
            let mean = &self.means[side];
            let least = density[side].min(pressure[side]).min(self.order);
            sides[side].density = least.select(density[side], mean.density);
            sides[side].pressure = least.select(pressure[side], mean.pressure);
            for k in 0..D {
                sides[side].velocity[k] = least.select(velocity[side][k], mean.velocity[k]);
            }
        }
        sides
    }

    /// One variable on both sides, `a` and `b` in the cells.
    #[inline(always)]
    fn sides(&self, a: R, b: R, rise: R, other_rise: R) -> [R; 2] {
        let jump = b - a;
        let mut first = self.step(rise, jump, self.has_layers);
        let mut second = self.step(other_rise, jump, self.has_layers);
        if let Some(evenness) = self.evenness {
            let bends = [(rise - jump) * 2.0, (other_rise - jump) * 2.0];
            let free = wavy(bends[0], bends[1]) * self.smooth;
            first = first + evenness * (self.fine_step(rise, jump, bends[0], free) - first);
            second =
                second + evenness * (self.fine_step(other_rise, jump, bends[1], free) - second);
        }
        [a + first * 0.5, b - second * 0.5]
    }

    /// Both `sides` of a variable whose waves the flow carries along, closer to one another where they rise and fall.
    #[inline(always)]
    fn closer(&self, sides: [R; 2], means: [R; 2], rises: [R; 2]) -> [R; 2] {
        let Some(evenness) = self.evenness else {
            return sides;
        };
        let jump = means[1] - means[0];
        let beyond = [rises[0] * 2.0 - jump, rises[1] * 2.0 - jump];
        let counted = rising(beyond, jump) * self.smooth * evenness;
        let closed = (sides[1] - sides[0]) * counted * (0.5 * (1.0 - UPWINDING));
        [sides[0] + closed, sides[1] - closed]
    }

    /// A step of third order: limited, and as it is where the gas is `free` to bend, over the crests and troughs of waves.
    #[inline(always)]
    fn fine_step(&self, rise: R, jump: R, bend: R, free: R) -> R {
        let limited = self.step(rise, jump, true);
        limited + free * (jump + bend * (1.0 / 3.0) - limited)
    }

    #[inline(always)]
    fn step(&self, rise: R, jump: R, is_fine: bool) -> R {
        let beyond = rise * 2.0 - jump;
        let careful = minmod(beyond, jump);
        let mean = if is_fine {
            third(beyond, jump)
        } else {
            central(beyond, jump)
        };
        careful + self.smooth * (mean - careful)
    }
}

/// From halfway between two cells to the middle of their face.
pub struct Aside<'a, const D: usize, R> {
    /// How the gas changes in both cells.
    slopes: &'a [[Primitive<D, R>; D]; 2],
    /// To there.
    skew: &'a [R; D],
    /// Distance of the cells over the length of `skew`, squared.
    part: R,
    /// Whether the mean of both cells' slopes counts, whatever they are; the smaller one otherwise, and as far as the difference of both cells bears it out.
    is_mean: bool,
}

impl<'a, const D: usize, R: Real> Aside<'a, D, R> {
    /// That by `skew` of a face whose cells are so far `apart`.
    #[inline(always)]
    pub fn new(
        slopes: &'a [[Primitive<D, R>; D]; 2],
        apart: &[R; D],
        skew: &'a [R; D],
        is_mean: bool,
    ) -> Self {
        let away = dot(apart, apart);
        Self {
            slopes,
            skew,
            part: away / (dot(skew, skew) + away * ON_THE_LINE),
            is_mean,
        }
    }

    /// Moves the states on both `sides` of the face that `cells` look at to its middle, both alike, so that they stay as far apart as they are: linear states flow
    /// through every face as they should, askew ones too. Not in shocks, nor where density or pressure would not be positive.
    #[inline(always)]
    pub fn moved(
        &self,
        mut sides: [Primitive<D, R>; 2],
        cells: &Neighbours<D, R>,
        smooth: R,
    ) -> [Primitive<D, R>; 2] {
        let ways = [
            rise(&self.slopes[0], self.skew),
            rise(&self.slopes[1], self.skew),
        ];
        let [(a, b), (rise_a, rise_b)] = [(&ways[0], &ways[1]), (&cells.rises[0], &cells.rises[1])];
        let [first, second] = &cells.means;
        let zero = smooth.like(0.0);
        let density = smooth
            * self.way(
                [a.density, b.density],
                [rise_a.density, rise_b.density],
                second.density - first.density,
            );
        let pressure = smooth
            * self.way(
                [a.pressure, b.pressure],
                [rise_a.pressure, rise_b.pressure],
                second.pressure - first.pressure,
            );
        let least = (sides[0].density.min(sides[1].density) + density)
            .min(sides[0].pressure.min(sides[1].pressure) + pressure);
        let density = least.select(density, zero);
        let pressure = least.select(pressure, zero);
        for side in &mut sides {
            side.density = side.density + density;
            side.pressure = side.pressure + pressure;
        }
        for k in 0..D {
            let more = smooth
                * self.way(
                    [a.velocity[k], b.velocity[k]],
                    [rise_a.velocity[k], rise_b.velocity[k]],
                    second.velocity[k] - first.velocity[k],
                );
            let more = least.select(more, zero);
            for side in &mut sides {
                side.velocity[k] = side.velocity[k] + more;
            }
        }
        sides
    }

    /// What of `ways` to the middle of the face counts, given what slopes say that a variable `rises` by to the other cell, and the `jump` to there. Slopes that
    /// see a shock beside the face say what is not there.
    #[inline(always)]
    fn way(&self, ways: [R; 2], rises: [R; 2], jump: R) -> R {
        if self.is_mean {
            return (ways[0] + ways[1]) * 0.5;
        }
        let borne_out = |way: R, rise: R| {
            let off = (rise - jump).max(jump - rise) * NOT_BORNE_OUT;
            let size = (way * way * self.part + rise * rise).sqrt() + off.like(f64::MIN_POSITIVE);
            (off.like(1.0) - off / size).max(off.like(0.0))
        };
        let [a, b] = ways;
        minmod(a * borne_out(a, rises[0]), b * borne_out(b, rises[1]))
    }
}

/// `slopes . apart` for every variable.
#[inline(always)]
pub fn rise<R: Real, const D: usize>(
    slopes: &[Primitive<D, R>; D],
    apart: &[R; D],
) -> Primitive<D, R> {
    let first = &slopes[0];
    let mut rise = Primitive {
        density: first.density * apart[0],
        velocity: scaled(&first.velocity, apart[0]),
        pressure: first.pressure * apart[0],
    };
    for axis in 1..D {
        let slope = &slopes[axis];
        rise.density = rise.density + slope.density * apart[axis];
        rise.pressure = rise.pressure + slope.pressure * apart[axis];
        for k in 0..D {
            rise.velocity[k] = rise.velocity[k] + slope.velocity[k] * apart[axis];
        }
    }
    rise
}
