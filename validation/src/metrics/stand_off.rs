//! Distance of a bow shock from the nose of a blunt body, along the stagnation line.
//!
//! Few particles lie on a line in space, so a tube around it is read. The shock bends back across
//! the tube; at coarse spacings that bend is a tenth of the distance, so it is fitted and taken out:
//! the particles inside the shock obey `s = s0 + a r^2 + b logit(t)`, `s` the distance from the nose,
//! `r` from the axis, `t` the share of the density jump, and `s0` is where `t` is a half on the axis.

use super::crossing::level_crossings;
use super::least_squares::{Fit, Row, robust_fit};
use super::{MetricError, positive, same_length};

/// The tube to look in and the jump to look for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StagnationLine {
    /// Stagnation point on the body.
    pub nose: [f64; 3],
    /// Direction against the stream (any length).
    pub upstream: [f64; 3],
    /// Radius of the tube, two to four spacings and well below the nose radius.
    pub radius: f64,
    /// Particle spacing of the undisturbed stream.
    pub spacing: f64,
    /// Density ahead of the shock.
    pub ahead: f64,
    /// Density behind the normal shock.
    pub behind: f64,
}

/// The shock on the stagnation line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandOff {
    /// Distance from the nose to the half-jump of the density.
    pub distance: f64,
    /// Curvature of the shock on the axis, positive where it wraps around the body.
    pub curvature: f64,
    /// Root mean square distance of the particles from the fit.
    pub rms: f64,
    /// Number of particles in the fit.
    pub particles: usize,
}

/// Shares of the density jump between which a particle counts as inside the shock.
const BAND: [f64; 2] = [0.15, 0.85];
/// Fewest particles inside the shock for a fit.
const FEWEST: usize = 6;

/// Reads the stand-off distance, in a plane or in space.
pub fn stand_off(
    positions: &[[f64; 3]],
    density: &[f64],
    line: &StagnationLine,
) -> Result<StandOff, MetricError> {
    same_length("density", density, positions.len())?;
    positive("the tube's radius", line.radius)?;
    positive("the spacing", line.spacing)?;
    positive("the density jump", line.behind - line.ahead)?;
    let length = line.upstream.iter().map(|v| v * v).sum::<f64>().sqrt();
    positive("the length of the upstream direction", length)?;
    // Distance along the line, squared distance from it, share of the jump.
    let tube: Vec<[f64; 3]> = positions
        .iter()
        .zip(density)
        .map(|(p, rho)| {
            let apart: [f64; 3] = std::array::from_fn(|a| p[a] - line.nose[a]);
            let along = (0..3)
                .map(|a| apart[a] * line.upstream[a] / length)
                .sum::<f64>();
            let off = apart.iter().map(|v| v * v).sum::<f64>() - along * along;
            let share = (rho - line.ahead) / (line.behind - line.ahead);
            [along, off.max(0.0), share]
        })
        .filter(|[along, off, _]| *along > 0.0 && *off <= line.radius * line.radius)
        .collect();
    let along: Vec<f64> = tube.iter().map(|t| t[0]).collect();
    let share: Vec<f64> = tube.iter().map(|t| t[2]).collect();
    // The outermost fall of the density through half the jump, going upstream.
    let first = level_crossings(&along, &share, 0.5, 1.5 * line.spacing)
        .into_iter()
        .rfind(|c| c.rise < -0.4)
        .ok_or(MetricError::TooFew {
            what: "falls of the density through half the jump ahead of the nose",
            found: 0,
            needed: 1,
            remedy: "widen the tube, check the densities, or run longer",
        })?;
    let inside: Vec<[f64; 3]> = tube
        .into_iter()
        .filter(|[_, _, share]| (BAND[0]..=BAND[1]).contains(share))
        .filter(|[along, _, _]| (along - first.coordinate).abs() < 4.0 * line.spacing)
        .collect();
    fit_bend(&inside, line.radius).ok_or(MetricError::TooFew {
        what: "particles inside the shock on the stagnation line",
        found: inside.len(),
        needed: FEWEST,
        remedy: "widen the tube",
    })
}

/// Fits `s = s0 + a r^2 + b logit(t)`; without the bend if the particles cannot tell it.
fn fit_bend(inside: &[[f64; 3]], radius: f64) -> Option<StandOff> {
    if inside.len() < FEWEST {
        return None;
    }
    let logit = |share: f64| (share / (1.0 - share)).ln();
    let bent: Vec<Row<3>> = inside
        .iter()
        .map(|[s, off, share]| Row {
            terms: [1.0, logit(*share), off / (radius * radius)],
            value: *s,
        })
        .collect();
    if let Some(Fit { x, rms, kept }) = robust_fit(&bent).filter(|_| inside.len() >= 2 * FEWEST) {
        return Some(StandOff {
            distance: x[0],
            curvature: -2.0 * x[2] / (radius * radius),
            rms,
            particles: kept,
        });
    }
    let straight: Vec<Row<2>> = bent
        .iter()
        .map(|row| Row {
            terms: [row.terms[0], row.terms[1]],
            value: row.value,
        })
        .collect();
    robust_fit(&straight).map(|fit| StandOff {
        distance: fit.x[0],
        curvature: 0.0,
        rms: fit.rms,
        particles: fit.kept,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::billig::{BowShock, Nose};
    use crate::metrics::testing::Scatter;

    /// A smeared bow shock ahead of a unit sphere (or cylinder) at the origin, stream along +x.
    fn bow_shock(spacing: f64, shock: &BowShock, dimension: usize) -> (Vec<[f64; 3]>, Vec<f64>) {
        let mut scatter = Scatter::new(5);
        let half = (0.6 / spacing) as i32;
        let depth = if dimension == 3 { half } else { 0 };
        let (mut positions, mut density) = (Vec::new(), Vec::new());
        for i in 0..(1.2 / spacing) as i32 {
            for j in -half..=half {
                for k in -depth..=depth {
                    let mut near = |v: i32| spacing * (f64::from(v) + 0.25 * scatter.next());
                    let mut p = [-near(i) - 0.7, near(j), near(k)];
                    if dimension == 2 {
                        p[2] = 0.0;
                    }
                    let r = p[1].hypot(p[2]);
                    if p[0].hypot(r) < 1.0 {
                        continue;
                    }
                    let inside = (shock.x(r) + p[0]) / (0.9 * spacing);
                    let share = 0.5 * (1.0 + inside.tanh());
                    positions.push(p);
                    density.push(1.0 + 2.857 * share * (1.0 + 0.02 * scatter.next()));
                }
            }
        }
        (positions, density)
    }

    fn line(spacing: f64) -> StagnationLine {
        StagnationLine {
            nose: [-1.0, 0.0, 0.0],
            upstream: [-2.0, 0.0, 0.0],
            radius: 3.0 * spacing,
            spacing,
            ahead: 1.0,
            behind: 3.857,
        }
    }

    #[test]
    fn the_stand_off_of_a_sphere_is_found_on_coarse_particles() {
        let shock = BowShock::new(Nose::Sphere, 3.0).unwrap();
        for spacing in [0.1, 0.05, 0.03] {
            let (positions, density) = bow_shock(spacing, &shock, 3);
            let found = stand_off(&positions, &density, &line(spacing)).unwrap();
            let error = (found.distance - shock.stand_off) / spacing;
            assert!(error.abs() < 0.12, "{spacing}: {found:?}, {error} spacings");
            assert!((found.curvature - 0.69).abs() < 0.4, "{found:?}");
        }
    }

    #[test]
    fn the_stand_off_of_a_cylinder_is_found_in_the_plane() {
        let shock = BowShock::new(Nose::Cylinder, 10.0).unwrap();
        let (positions, density) = bow_shock(0.025, &shock, 2);
        let found = stand_off(&positions, &density, &line(0.025)).unwrap();
        let error = found.distance - shock.stand_off;
        assert!(error.abs() < 0.004, "{found:?}");
    }

    #[test]
    fn a_stream_without_a_shock_is_refused() {
        let shock = BowShock::new(Nose::Sphere, 3.0).unwrap();
        let (positions, _) = bow_shock(0.1, &shock, 3);
        let uniform = vec![1.0; positions.len()];
        let error = stand_off(&positions, &uniform, &line(0.1)).unwrap_err();
        assert!(
            error.to_string().starts_with("falls of the density"),
            "{error}"
        );
    }
}
