//! What walls do: the state that their ghosts show, the shield, the forces on them.

use aero_geometry::Vector;
use nalgebra::{DMatrix, DVector, Vector3};

use super::laws::{Pair, viscous_pressure};
use super::{Heat, Laws, Matrix, Point, Wall, in_reach, kernel};

/// Gas as it is seen from a point: `centroid` is where the interpolation looked, relative to the point.
pub struct Seen<const D: usize> {
    pub velocity: Vector<D>,
    pub strain: Matrix<D>,
    pub pressure: f64,
    pub energy: f64,
    pub h: f64,
    pub centroid: Vector<D>,
}

/// `sum f_j W_j / sum W_j` [Villodi & Ramachandran 2024, eq. 24]; none where no gas is in reach.
pub fn shepard<const D: usize>(place: &Vector<D>, h: f64, gas: &[Point<D>]) -> Option<Seen<D>> {
    let gas = &in_reach(place, h, gas);
    let weights: Vec<f64> = gas.iter().map(|j| weight(place, h, j)).collect();
    let total: f64 = weights.iter().sum();
    (total > 0.0).then(|| seen(place, gas, &weights, total))
}

fn weight<const D: usize>(place: &Vector<D>, h: f64, j: &Point<D>) -> f64 {
    kernel::value::<D>((place - j.position).norm(), f64::midpoint(h, j.h))
}

fn seen<const D: usize>(
    place: &Vector<D>,
    gas: &[Point<D>],
    weights: &[f64],
    total: f64,
) -> Seen<D> {
    let mut seen = Seen {
        velocity: Vector::zeros(),
        strain: Matrix::zeros(),
        pressure: 0.0,
        energy: 0.0,
        h: 0.0,
        centroid: Vector::zeros(),
    };
    for (j, weight) in gas.iter().zip(weights) {
        let share = weight / total;
        seen.velocity += j.velocity * share;
        seen.strain += j.strain * share;
        seen.pressure += j.pressure * share;
        seen.energy += j.energy * share;
        seen.h += j.h * share;
        seen.centroid += (j.position - place) * share;
    }
    seen
}

/// The fit that is exact for linear fields [eq. 25; Liu & Liu 2006]: with the moments `M = sum w_j (1, d_j) (x) (1, d_j)`,
/// `w_j = V_j W_j`, and `M (a, b) = (1, 0)`, the weights are `w_j (a + b.d_j)`. None with less than 0.3 of a full
/// neighbourhood, with an ill-conditioned matrix, or where it gives what no gas is: pressures of no more than the `least`. The strain is Shepard's.
pub fn linear_fit<const D: usize>(
    place: &Vector<D>,
    h: f64,
    gas: &[Point<D>],
    least: f64,
) -> Option<Seen<D>> {
    let gas = &in_reach(place, h, gas);
    let weights: Vec<f64> = gas.iter().map(|j| j.volume * weight(place, h, j)).collect();
    let total: f64 = weights.iter().sum();
    if total < 0.3 {
        return None;
    }
    let spread: f64 = gas
        .iter()
        .zip(&weights)
        .map(|(j, w)| w * (j.position - place).norm_squared())
        .sum();
    // Lengths in which the mean second moment is one.
    let length = (spread / (D as f64 * total)).sqrt();
    let basis = |j: &Point<D>| {
        let arm = (j.position - place) / length;
        DVector::from_fn(D + 1, |k, _| if k == 0 { 1.0 } else { arm[k - 1] })
    };
    let mut moments = DMatrix::<f64>::zeros(D + 1, D + 1);
    for (j, w) in gas.iter().zip(&weights) {
        moments += basis(j) * basis(j).transpose() * (w / total);
    }
    let inverse = moments.clone().try_inverse()?;
    // The condition is that of the matrix filled up with ones to three axes.
    let norm = |matrix: &DMatrix<f64>| (matrix.norm_squared() + (3 - D) as f64).sqrt();
    if 1.0 / (norm(&moments) * norm(&inverse)) < 1e-3 {
        return None;
    }
    let coefficients = inverse.column(0).into_owned();
    let corrected: Vec<f64> = gas
        .iter()
        .zip(&weights)
        .map(|(j, w)| w / total * coefficients.dot(&basis(j)))
        .collect();
    let fit = Seen {
        strain: seen(place, gas, &weights, total).strain,
        centroid: Vector::zeros(),
        ..seen(place, gas, &corrected, 1.0)
    };
    (fit.pressure > least && fit.energy > 0.0 && fit.h > 0.0).then_some(fit)
}

/// The gas as the ghost sees it, and how far along the normal: at the mirror point where that is asked for and works, else about
/// itself; none where no gas is in reach.
pub fn look<const D: usize>(
    wall: &Wall<D>,
    gas: &[Point<D>],
    mirrors: bool,
    least: f64,
) -> Option<(Seen<D>, f64)> {
    let Point { position, h, .. } = wall.point;
    let mirror = position + wall.normal * (2.0 * wall.depth);
    let mirrored = (mirrors && wall.has_mirror)
        .then(|| linear_fit(&mirror, h, gas, least))
        .flatten();
    mirrored.map(|seen| (seen, 2.0 * wall.depth)).or_else(|| {
        let seen = shepard(&position, h, gas)?;
        let height = seen.centroid.dot(&wall.normal);
        Some((seen, height))
    })
}

/// The ghost with the velocity and strain that the wall makes of what is seen at a height over the ghost: below a wall that gas slides along what goes across it is turned round as it is
/// seen, or, where it `grows` off the wall, as it is at the mirror point.
pub fn mirrored<const D: usize>(
    wall: &Wall<D>,
    seen: &Seen<D>,
    height: f64,
    grows: bool,
) -> Point<D> {
    let n = wall.normal;
    let relative = seen.velocity - wall.surface_velocity;
    if wall.slips {
        let mirror = Matrix::<D>::identity() - n * n.transpose() * 2.0;
        // Along a normal that turns, velocities beyond the wall go on as the gas's do.
        let bent = wall.curvature * (relative - n * relative.dot(&n));
        let across = relative.dot(&n);
        let above = height - wall.depth;
        let own = n.dot(&(seen.strain * n));
        let line = across / above.max(0.1 * wall.point.h);
        let slope = if own > 0.0 && line > 0.0 {
            own.min(line)
        } else if own < 0.0 && line < 0.0 {
            own.max(line)
        } else {
            0.0
        };
        let mirrored = if grows {
            across + slope * (wall.depth - above)
        } else {
            across
        };
        return Point {
            velocity: seen.velocity - n * (across + mirrored),
            strain: mirror * seen.strain * mirror.transpose()
                - n * bent.transpose()
                - bent * n.transpose(),
            ..wall.point
        };
    }
    // A straight line through the wall's velocity at the wall.
    let above = (height - wall.depth).max(0.1 * wall.point.h);
    let surface = wall.surface_velocity + wall.slide;
    Point {
        velocity: surface - (relative - wall.slide) * (wall.depth / above),
        strain: seen.strain,
        ..wall.point
    }
}

/// That of gas that follows the wall: of the wall, of Coriolis and of the bend. The pressure rises by `dp/dn = -rho n.a`.
pub fn normal_acceleration<const D: usize>(wall: &Wall<D>, seen: &Seen<D>) -> f64 {
    let n = wall.normal;
    let relative = seen.velocity - wall.surface_velocity;
    let slide = if wall.slips {
        relative - n * relative.dot(&n)
    } else {
        Vector::zeros()
    };
    let full = |v: &Vector<D>| Vector3::from_fn(|k, _| if k < D { v[k] } else { 0.0 });
    let coriolis = wall.spin.cross(&full(&slide)) * 2.0;
    wall.surface_acceleration.dot(&n) + coriolis.dot(&full(&n))
        - slide.dot(&(wall.curvature * slide))
}

/// Share of the second gas about the ghost.
fn share<const D: usize>(wall: &Wall<D>, gas: &[Point<D>]) -> Option<f64> {
    let Point { position, h, .. } = wall.point;
    let gas = wall.point.near(gas);
    let weigh = |j: &Point<D>| j.volume * weight(&position, h, j);
    let total: f64 = gas.iter().map(weigh).sum();
    let second: f64 = gas.iter().map(|j| j.second * weigh(j)).sum();
    (total > 0.0).then(|| second / total)
}

/// A pressure over the least there is that rises, or falls and stays above it.
pub fn continued(pressure: f64, rise: f64) -> f64 {
    let part = rise / pressure;
    if rise >= 0.0 {
        pressure * (1.0 + part + 0.5 * part * part)
    } else {
        pressure * part.max(-20.0).exp()
    }
}

/// What the ghost shows of the gas [Villodi & Ramachandran 2024, eqs 24-30], and the pressure at the wall. A ghost that sees no
/// gas goes on as it was. `mirrors` asks for the fit at the mirror point, `keeps_entropy` for a pressure that rises
/// along the normal as an isentrope.
pub fn show<const D: usize>(
    wall: &Wall<D>,
    gas: &[Point<D>],
    mirrors: bool,
    laws: Laws,
) -> Wall<D> {
    let keeps_entropy = !laws.published && wall.heat == Heat::Kept;
    let Some((seen, height)) = look(wall, gas, mirrors, 0.0) else {
        return *wall;
    };
    let mut shown = mirrored(wall, &seen, height, !laws.published);
    shown.second = share(wall, gas).unwrap_or(shown.second);
    let gamma = shown.gamma();
    let slope = seen.pressure / ((gamma - 1.0) * seen.energy) * normal_acceleration(wall, &seen);
    shown.pressure = continued(seen.pressure, slope * height);
    // A straight line through the wall's energy at the wall, or of the flux's slope.
    shown.energy = match (wall.heat, laws.viscous) {
        (Heat::Passes { energy }, _) => {
            let above = (height - wall.depth).max(0.1 * shown.h);
            let beyond = energy - (seen.energy - energy) * (wall.depth / above);
            beyond.max(0.1 * energy.min(seen.energy))
        }
        (Heat::Flows(flux), Some(viscous)) => {
            let beyond = seen.energy - height * viscous.slope(flux, seen.energy);
            beyond.max(0.1 * seen.energy)
        }
        _ => seen.energy,
    };
    let surface_pressure = continued(seen.pressure, slope * (height - wall.depth));
    // Where pressure varies across the layer at the wall, so does the density.
    let mut surface_energy = seen.energy;
    if keeps_entropy {
        shown.energy *= (shown.pressure / seen.pressure).powf((gamma - 1.0) / gamma);
        surface_energy *= (surface_pressure / seen.pressure).powf((gamma - 1.0) / gamma);
    }
    shown.density_gradient = Vector::zeros();
    if !laws.published {
        let fall = seen.pressure / seen.energy - surface_pressure / surface_energy;
        let above = (height - wall.depth).max(0.1 * shown.h);
        shown.density_gradient = wall.normal * (fall / ((gamma - 1.0) * above));
    }
    shown.density = shown.pressure / ((gamma - 1.0) * shown.energy);
    shown.mass = shown.density * shown.volume;
    Wall {
        point: shown,
        surface_pressure,
        ..*wall
    }
}

/// `-2 (1 - s / s_nom) (n.u_rel) n` of gas that heads for a ghost nearer than its own spacing, `n` and the wall's velocity being
/// means with the ghosts' weights [Villodi & Ramachandran 2024, eq. 32].
pub fn shield<const D: usize>(i: &Point<D>, walls: &[Wall<D>]) -> Vector<D> {
    let (mut total, mut nearest) = (0.0, f64::INFINITY);
    let [mut normal, mut velocity] = [Vector::<D>::zeros(); 2];
    for wall in walls {
        let weight = wall.point.volume * weight(&i.position, i.h, &wall.point);
        if weight > 0.0 {
            normal += wall.normal * weight;
            velocity += wall.surface_velocity * weight;
            total += weight;
            nearest = nearest.min((i.position - wall.point.position).norm());
        }
    }
    let spacing = i.volume.powf(1.0 / D as f64);
    if total == 0.0 || normal.norm() == 0.0 || nearest >= spacing {
        return Vector::zeros();
    }
    let normal = normal.normalize();
    let speed = normal.dot(&(i.velocity - velocity / total));
    normal * (-2.0 * (1.0 - nearest / spacing) * speed.min(0.0))
}

/// Force on a ghost: minus what it gives the momentum of all gas.
pub fn force<const D: usize>(laws: Laws, ghost: &Point<D>, gas: &[Point<D>]) -> Vector<D> {
    let mut force = Vector::zeros();
    for i in gas {
        let pair = Pair::new(i, ghost);
        let stress = i.renormalisation * i.pressure + ghost.renormalisation * ghost.pressure;
        let push = stress * pair.gradient * (-ghost.volume / i.density);
        let viscous = viscous_pressure(laws, &pair, i, ghost) * ghost.mass / pair.density;
        force -= (push + pair.gradient * viscous) * i.mass;
    }
    force
}
