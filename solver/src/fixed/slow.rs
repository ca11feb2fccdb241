//! What gas slower than sound has too much of where it meets, in a flow that is to come to rest.
//!
//! A jump of the velocity across a face sends out sounds of the pressure `rho a (u_L - u_R) / 2`. In a steady flow there are none: pressures are of the
//! order of `rho u^2`, and what the jump makes is an error, the larger beside them the slower the gas. The jump counts by the Mach number [of the
//! normal velocity after Rieper 2011, J. Comput. Phys. 230, 5263-5287, as part of the states after Thornber et al. 2008, J. Comput. Phys. 227,
//! 4873-4894], by the stream's at least, so that gas that a bow shock has stopped is not left to itself.

use super::equation_of_state::EquationOfState;
use super::real::Real;
use super::state::{Primitive, dot};
use crate::problem::Problem;

/// Least Mach number that gas counts by in flows of `problem`: the stream's; one, of sound itself, where sounds may go to and fro as time goes on, and
/// where no stream tells how fast the gas is to be.
pub fn least_mach<const D: usize>(problem: &Problem<D>) -> f64 {
    let stream = problem.stream_mach();
    if problem.method.settles() && stream > 0.0 {
        stream.min(1.0)
    } else {
        1.0
    }
}

/// How much of a jump counts in gas of this Mach number, where it is to be at `least` so much.
#[inline(always)]
pub fn counted<R: Real>(mach: R, least: f64) -> R {
    mach.max(mach.like(least)).min(mach.like(1.0))
}

/// Lessens the jump of the speed along the unit `normal` between both sides of a face by the Mach number of the faster one.
#[inline(always)]
pub fn meeting<G: EquationOfState, R: Real, const D: usize>(
    gas: &G,
    sides: &mut [Primitive<D, R>; 2],
    normal: &[R; D],
    least: f64,
) {
    let [left, right] = &*sides;
    let square = |side: &Primitive<D, R>| {
        dot(&side.velocity, &side.velocity) / gas.sound_square(side.density, side.pressure)
    };
    let mach = square(left).max(square(right)).sqrt();
    let jump = dot(&right.velocity, normal) - dot(&left.velocity, normal);
    let less = (counted(mach, least) - 1.0) * jump * 0.5;
    for k in 0..D {
        let step = less * normal[k];
        sides[0].velocity[k] = sides[0].velocity[k] - step;
        sides[1].velocity[k] = sides[1].velocity[k] + step;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gas::IdealGas;

    const AIR: IdealGas = IdealGas::new(1.4);

    fn met(left: [f64; 2], right: [f64; 2], least: f64) -> [Primitive<2>; 2] {
        // Sound has a speed of one.
        let mut sides = [left, right].map(|velocity| Primitive {
            density: 1.4,
            velocity,
            pressure: 1.0,
        });
        meeting(&AIR, &mut sides, &[0.6, 0.8], least);
        sides
    }

    fn along(velocity: &[f64; 2]) -> f64 {
        dot(velocity, &[0.6, 0.8])
    }

    /// Along the normal the sides are apart by 0.5, of gas of Mach 0.5 at most; across it by 0.4, which stays.
    #[test]
    fn the_jump_of_the_normal_speed_counts_by_the_mach_number_of_the_faster_side() {
        let [left, right] = [[0.3, 0.4], [0.32, -0.24]];
        for (least, counts) in [(0.1, 0.5), (0.7, 0.7)] {
            let sides = met(left, right, least);
            let [a, b] = sides.map(|side| along(&side.velocity));
            assert!((b - a - counts * (0.0 - 0.5)).abs() < 1e-15, "{a} {b}");
            assert!((a + b - 0.5).abs() < 1e-15, "the mean stays");
            let across = |v: &[f64; 2]| 0.8 * v[0] - 0.6 * v[1];
            for (side, before) in sides.iter().zip([left, right]) {
                assert!((across(&side.velocity) - across(&before)).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn gas_faster_than_sound_meets_as_it_is() {
        let sides = met([1.2, 0.0], [0.2, 0.1], 0.1);
        let [a, b] = sides.map(|side| along(&side.velocity));
        assert!((a - 0.72).abs() < 1e-15 && (b - 0.2).abs() < 1e-15);
    }
}
