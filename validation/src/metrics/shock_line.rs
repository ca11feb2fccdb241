//! Angle of a straight shock from the half-jump: the line where the density is the mean of the
//! states ahead and behind.
//!
//! The density is scanned in strips, first upright ones, then strips across the line found so far,
//! and a straight line is fitted through the crossings with outliers left out. Unlike a fit through
//! steep-gradient particles this has no bias from the shock's thickness, which is not symmetric.

use super::crossing::{Crossing, level_crossings};
use super::least_squares::{Row, robust_fit};
use super::plateau::Ramp;
use super::{MetricError, positive, same_length};

/// Where to look for the shock and between which densities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShockSearch {
    /// Density ahead of the shock.
    pub ahead: f64,
    /// Density behind the shock (exact, or as measured).
    pub behind: f64,
    /// Least and greatest `x` looked at.
    pub x: [f64; 2],
    /// Least and greatest `y` looked at.
    pub y: [f64; 2],
    /// Particle spacing of the undisturbed stream.
    pub spacing: f64,
}

impl ShockSearch {
    /// The search above a ramp between two densities, `[ahead, behind]`, that keeps `clearance` (six
    /// smoothing lengths are customary) from its corner, from its end and from a boundary at `top`.
    pub fn above_ramp(
        ramp: &Ramp,
        top: f64,
        clearance: f64,
        densities: [f64; 2],
        spacing: f64,
    ) -> Self {
        Self {
            ahead: densities[0],
            behind: densities[1],
            x: [ramp.corner[0] + clearance, ramp.end_x - clearance],
            y: [ramp.corner[1], top - clearance],
            spacing,
        }
    }

    fn contains(&self, [x, y]: [f64; 2]) -> bool {
        x >= self.x[0] && x <= self.x[1] && y >= self.y[0] && y <= self.y[1]
    }
}

/// The fitted shock.
#[derive(Clone, Debug, PartialEq)]
pub struct ShockLine {
    /// Angle from the x axis, radians, between minus and plus a right angle.
    pub angle: f64,
    /// A point on the line.
    pub point: [f64; 2],
    /// Root mean square distance of the crossings from the line.
    pub rms: f64,
    /// Points where the density is half-way.
    pub crossings: Vec<[f64; 2]>,
}

/// Strips' width in particle spacings: wide enough for a dozen particles in the shock.
const STRIP: f64 = 3.0;
/// Half-width of the smoothing window across the shock in particle spacings.
const WINDOW: f64 = 1.5;
/// Fits with strips across the line found before; the angle has settled after two.
const PASSES: usize = 3;
/// Fewest crossings that make a line.
const FEWEST: usize = 4;

/// Fits the straight shock in a plane flow.
pub fn fit_shock_line(
    positions: &[[f64; 3]],
    density: &[f64],
    search: &ShockSearch,
) -> Result<ShockLine, MetricError> {
    same_length("density", density, positions.len())?;
    positive("the spacing", search.spacing)?;
    positive("the density jump", (search.behind - search.ahead).abs())?;
    let samples: Vec<([f64; 2], f64)> = positions
        .iter()
        .zip(density)
        .map(|(p, rho)| ([p[0], p[1]], *rho))
        .filter(|(p, _)| search.contains(*p))
        .collect();
    let middle = [
        0.5 * (search.x[0] + search.x[1]),
        0.5 * (search.y[0] + search.y[1]),
    ];
    // Upright strips: s runs along x, n along y.
    let mut line = Frame {
        origin: middle,
        angle: 0.0,
    };
    let mut crossings = line.crossings(&samples, search, f64::INFINITY);
    let mut fit = line.fit(&crossings)?;
    for _ in 0..PASSES {
        line = fit.0;
        let reach = 8.0 * search.spacing + 3.0 * fit.1;
        crossings = line.crossings(&samples, search, reach);
        fit = line.fit(&crossings)?;
    }
    let [dx, dy] = [fit.0.angle.cos(), fit.0.angle.sin()];
    Ok(ShockLine {
        angle: (dy / dx).atan(),
        point: fit.0.origin,
        rms: fit.1,
        crossings: crossings.iter().map(|c| line.to_plane(*c)).collect(),
    })
}

/// Coordinates along (`s`) and across (`n`) a line.
#[derive(Clone, Copy)]
struct Frame {
    origin: [f64; 2],
    angle: f64,
}

impl Frame {
    fn to_line(self, p: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [p[0] - self.origin[0], p[1] - self.origin[1]];
        [x * cos + y * sin, y * cos - x * sin]
    }

    fn to_plane(self, [s, n]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [
            self.origin[0] + s * cos - n * sin,
            self.origin[1] + s * sin + n * cos,
        ]
    }

    /// One crossing `[s, n]` per strip across this line, within `reach` of it.
    fn crossings(
        self,
        samples: &[([f64; 2], f64)],
        search: &ShockSearch,
        reach: f64,
    ) -> Vec<[f64; 2]> {
        let width = STRIP * search.spacing;
        let mut strips: std::collections::BTreeMap<i64, Vec<([f64; 2], f64)>> =
            std::collections::BTreeMap::new();
        for (p, rho) in samples {
            let here = self.to_line(*p);
            if here[1].abs() <= reach {
                let strip = (here[0] / width).floor() as i64;
                strips.entry(strip).or_default().push((here, *rho));
            }
        }
        let level = 0.5 * (search.ahead + search.behind);
        let jump = (search.behind - search.ahead).abs();
        let mut found = Vec::new();
        for (strip, members) in strips {
            let s = (strip as f64 + 0.5) * width;
            let n: Vec<f64> = members.iter().map(|m| m.0[1]).collect();
            let rho: Vec<f64> = members.iter().map(|m| m.1).collect();
            let best = level_crossings(&n, &rho, level, WINDOW * search.spacing)
                .into_iter()
                // A strip cut off by the window's edge shows only part of the jump.
                .filter(|c| c.rise.abs() > 0.5 * jump)
                .filter(|c| search.contains(self.to_plane([s, c.coordinate])))
                .max_by(|a, b| preference(a, reach).total_cmp(&preference(b, reach)));
            if let Some(crossing) = best {
                found.push([s, crossing.coordinate]);
            }
        }
        found
    }

    /// Straight line through crossings in this frame, as a frame of its own, and the residual.
    fn fit(self, crossings: &[[f64; 2]]) -> Result<(Self, f64), MetricError> {
        let rows: Vec<Row<2>> = crossings
            .iter()
            .map(|c| Row {
                terms: [1.0, c[0]],
                value: c[1],
            })
            .collect();
        let fit = robust_fit(&rows)
            .filter(|f| f.kept >= FEWEST)
            .ok_or(MetricError::TooFew {
                what: "strips that show the shock",
                found: crossings.len(),
                needed: FEWEST,
                remedy: "widen the search or use a finer spacing",
            })?;
        let [offset, slope] = fit.x;
        let lean = slope.atan();
        let frame = Self {
            origin: self.to_plane([0.0, offset]),
            angle: self.angle + lean,
        };
        Ok((frame, fit.rms * lean.cos()))
    }
}

/// The steepest crossing in the first scan, the one nearest the line afterwards.
fn preference(crossing: &Crossing, reach: f64) -> f64 {
    if reach.is_finite() {
        -crossing.coordinate.abs()
    } else {
        crossing.rise.abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::testing::{Wedge, wedge};

    fn search(flow: &Wedge) -> ShockSearch {
        let ramp = Ramp {
            corner: [0.0, 0.0],
            angle: flow.ramp,
            end_x: 3.0,
        };
        ShockSearch::above_ramp(
            &ramp,
            3.0,
            9.0 * flow.spacing,
            [1.0, flow.ratio],
            flow.spacing,
        )
    }

    #[test]
    fn the_angle_of_a_thick_noisy_shock_is_found_to_a_tenth_of_a_degree() {
        for (mach, beta, ramp, ratio) in [
            ("2.5", 42.890_f64, 20_f64, 2.2002),
            ("5", 29.801, 20.0, 3.3154),
            ("5", 19.376, 10.0, 2.1299),
        ] {
            let flow = Wedge {
                beta: beta.to_radians(),
                ramp: ramp.to_radians(),
                ratio,
                spacing: 1.0 / 16.0,
                noise: 0.03,
            };
            let (positions, density) = wedge(&flow);
            let line = fit_shock_line(&positions, &density, &search(&flow)).unwrap();
            let error = line.angle.to_degrees() - beta;
            assert!(error.abs() < 0.15, "Mach {mach}: {error} deg");
            assert!(line.rms < 0.2 * flow.spacing, "Mach {mach}: {}", line.rms);
        }
    }

    #[test]
    fn spots_and_lost_particles_do_not_move_the_line() {
        let flow = Wedge {
            beta: 0.7,
            ramp: 0.35,
            ratio: 2.2,
            spacing: 1.0 / 16.0,
            noise: 0.02,
        };
        let (mut positions, mut density) = wedge(&flow);
        for k in (0..density.len()).step_by(97) {
            density[k] *= 3.0;
        }
        positions[3] = [f64::NAN; 3];
        let line = fit_shock_line(&positions, &density, &search(&flow)).unwrap();
        assert!((line.angle - 0.7).abs() < 0.01, "{}", line.angle);
    }

    #[test]
    fn a_uniform_stream_shows_no_shock() {
        let flow = Wedge {
            beta: 0.7,
            ramp: 0.35,
            ratio: 2.2,
            spacing: 0.1,
            noise: 0.0,
        };
        let (positions, _) = wedge(&flow);
        let density = vec![1.0; positions.len()];
        let error = fit_shock_line(&positions, &density, &search(&flow)).unwrap_err();
        assert!(
            error.to_string().starts_with("strips that show the shock"),
            "{error}"
        );
    }
}
