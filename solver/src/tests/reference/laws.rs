//! The pair laws in plain numbers. `r` is `r_i - r_j` and `u` is `u_i - u_j` throughout.

use aero_geometry::Vector;

use super::{Conduction, Laws, Point};

/// What all laws need of a pair.
pub struct Pair<const D: usize> {
    pub r: Vector<D>,
    pub u: Vector<D>,
    pub distance: f64,
    pub h: f64,
    /// `grad_i W_ij`.
    pub gradient: Vector<D>,
    /// Mean density and mean speed of sound.
    pub density: f64,
    pub sound: f64,
}

impl<const D: usize> Pair<D> {
    pub fn new(i: &Point<D>, j: &Point<D>) -> Self {
        let r = i.position - j.position;
        let distance = r.norm();
        let h = f64::midpoint(i.h, j.h);
        Self {
            r,
            u: i.velocity - j.velocity,
            distance,
            h,
            gradient: r * super::kernel::slope_over_r::<D>(distance, h),
            density: f64::midpoint(i.density, j.density),
            sound: f64::midpoint(sound(i), sound(j)),
        }
    }

    /// `r_ji . grad_i W_ij / r^2`, positive.
    fn diffusivity(&self) -> f64 {
        -self.r.dot(&self.gradient) / (self.distance * self.distance)
    }
}

pub fn sound<const D: usize>(point: &Point<D>) -> f64 {
    (point.gamma() * point.pressure / point.density).sqrt()
}

/// `mu`, negative where the pair closes [Villodi & Ramachandran 2024, eq. 13; Monaghan 1992, eq. 4.2; Frontiere, Raskin
/// & Owen 2017, section 2.4].
pub fn closing_speed<const D: usize>(
    laws: Laws,
    pair: &Pair<D>,
    i: &Point<D>,
    j: &Point<D>,
) -> f64 {
    let approach = pair.u.dot(&pair.r);
    let squared = pair.distance * pair.distance;
    if approach >= 0.0 {
        return 0.0;
    }
    if laws.published {
        return pair.h * approach / squared;
    }
    let mut closing = approach;
    if laws.limits_viscosity {
        let own = pair.r.dot(&(i.strain * pair.r));
        let other = pair.r.dot(&(j.strain * pair.r));
        if own < 0.0 && other < 0.0 {
            closing -= 2.0 * own * other / (own + other);
        }
    }
    pair.h * closing.min(0.0) / (squared + 0.01 * pair.h * pair.h)
}

/// `mu` of a pair that parts in gas that expands, zero of another: of its speed what neither strain explains, and no more than twice
/// the mean rate of expansion.
pub fn parting_speed<const D: usize>(
    laws: Laws,
    pair: &Pair<D>,
    i: &Point<D>,
    j: &Point<D>,
) -> f64 {
    let approach = pair.u.dot(&pair.r);
    let squared = pair.distance * pair.distance;
    let expansion = f64::midpoint(i.strain.trace(), j.strain.trace());
    if laws.published || !laws.limits_viscosity || approach <= 0.0 || expansion <= 0.0 {
        return 0.0;
    }
    let linear = [i, j].map(|end| pair.r.dot(&(end.strain * pair.r)));
    let left = approach - linear.into_iter().fold(0.0, f64::max);
    pair.h * left.clamp(0.0, 2.0 * expansion * squared) / (squared + 0.01 * pair.h * pair.h)
}

/// `Pi = alpha c mu - beta mu^2` of what closes, `alpha = 1`, `beta = 2`; `2 c mu` of what parts.
pub fn viscous_pressure<const D: usize>(
    laws: Laws,
    pair: &Pair<D>,
    i: &Point<D>,
    j: &Point<D>,
) -> f64 {
    let closing = closing_speed(laws, pair, i, j);
    let parting = parting_speed(laws, pair, i, j);
    pair.sound * (closing + 2.0 * parting) - 2.0 * closing * closing
}

/// What `j` gives `i` of its heat, with `kappa = 0.1`: weighed by `m_j / rho_j` as published, by `m_j / rho_ij` otherwise, where Noh's
/// flux `2 |mu| h` joins in, or is all there is.
pub fn conduction<const D: usize>(
    laws: Laws,
    pair: &Pair<D>,
    i: &Point<D>,
    j: &Point<D>,
    closing: f64,
) -> f64 {
    let difference = (j.energy - i.energy) * (1.0 - i.unlike(j));
    let spread = 2.0 * pair.h * pair.diffusivity();
    let uneven = match laws.conduction {
        Conduction::ByVolume => {
            return 0.1 * pair.sound * spread * difference * j.mass / j.density;
        }
        Conduction::Pairwise => difference,
        Conduction::Limited => {
            let [own, other] = [i, j].map(|of| -of.energy_slope.dot(&pair.r));
            difference - minmod([own, other, difference])
        }
        Conduction::InShocks => 0.0,
    };
    let artificial = 0.1 * pair.sound * uneven;
    let noh = 2.0 * closing.abs() * difference;
    (artificial + noh) * spread * j.mass / pair.density
}

/// The least of all in size where their signs agree, zero elsewhere.
fn minmod(all: [f64; 3]) -> f64 {
    if all.iter().all(|&x| x > 0.0) {
        all.into_iter().fold(f64::INFINITY, f64::min)
    } else if all.iter().all(|&x| x < 0.0) {
        all.into_iter().fold(f64::NEG_INFINITY, f64::max)
    } else {
        0.0
    }
}

/// Diffusion of density with `delta = 0.1` [Villodi & Ramachandran 2024, eqs 10-11].
pub fn diffusion<const D: usize>(pair: &Pair<D>, i: &Point<D>, j: &Point<D>) -> f64 {
    let mean = (i.density_gradient + j.density_gradient) * 0.5;
    let deviation = j.density - i.density - mean.dot(&-pair.r);
    0.1 * pair.sound * pair.h * 2.0 * deviation * pair.diffusivity() * j.mass / j.density
}

/// Weight of the gradient of concentration, `1 + 0.2 (W(r) / W(2/3 h))^4` [Monaghan 2000; Sun et al. 2017].
pub fn crowding<const D: usize>(pair: &Pair<D>) -> f64 {
    let value = |r: f64| super::kernel::value::<D>(r, pair.h);
    1.0 + 0.2 * (value(pair.distance) / value(pair.h / 1.5)).powi(4)
}
