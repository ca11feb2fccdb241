//! The uniform stream between a ramp and its attached shock: medians of density, pressure and Mach
//! number.
//!
//! This, not the shock's angle, is where a scheme that loses conservation in the shock shows it.

use super::{MetricError, median, same_length};

/// A straight ramp in the plane, rising from `corner` at `angle` up to `end_x`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// Where the ramp starts.
    pub corner: [f64; 2],
    /// Its inclination, radians.
    pub angle: f64,
    /// Abscissa of its end.
    pub end_x: f64,
}

impl Ramp {
    /// Distance of a point from the ramp's line, positive on the gas's side.
    pub fn above(&self, p: &[f64; 3]) -> f64 {
        let (sin, cos) = self.angle.sin_cos();
        (p[1] - self.corner[1]) * cos - (p[0] - self.corner[0]) * sin
    }

    /// Distance of a point from the shock of angle `shock` radians through the corner, positive
    /// behind it.
    pub fn behind_shock(&self, p: &[f64; 3], shock: f64) -> f64 {
        let (sin, cos) = shock.sin_cos();
        (p[0] - self.corner[0]) * sin - (p[1] - self.corner[1]) * cos
    }
}

/// Particle values the plateau is read from.
#[derive(Clone, Copy, Debug)]
pub struct Stream<'a> {
    /// Positions.
    pub position: &'a [[f64; 3]],
    /// Densities.
    pub density: &'a [f64],
    /// Pressures.
    pub pressure: &'a [f64],
    /// Mach numbers.
    pub mach: &'a [f64],
}

/// Medians over the plateau.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    /// Median density.
    pub density: f64,
    /// Median pressure.
    pub pressure: f64,
    /// Median Mach number.
    pub mach: f64,
    /// Number of particles.
    pub particles: usize,
    /// Distance kept from wall and shock, in smoothing lengths.
    pub clearance: f64,
}

/// Distance from wall, shock and ramp's end that a plateau should keep, in smoothing lengths.
const CLEARANCE: f64 = 6.0;
/// Fewest particles for a median.
const FEWEST: usize = 12;

/// Medians of the particles at least six smoothing lengths off the shock of angle `shock` (radians,
/// through the corner) and off the wall.
///
/// A slender shock layer may have no such particles at a coarse spacing. The distance is then cut
/// by half smoothing lengths, down to two, until a dozen are found; the one used is returned, and
/// below about four the medians feel the shock.
pub fn plateau(
    stream: &Stream<'_>,
    ramp: &Ramp,
    shock: f64,
    smoothing_length: f64,
) -> Result<Plateau, MetricError> {
    let count = stream.position.len();
    same_length("density", stream.density, count)?;
    same_length("pressure", stream.pressure, count)?;
    same_length("mach", stream.mach, count)?;
    super::positive("the smoothing length", smoothing_length)?;
    // Distance to the nearest of wall, shock and ramp's end, in smoothing lengths.
    let depth: Vec<f64> = stream
        .position
        .iter()
        .map(|p| {
            let inside = ramp.above(p).min(ramp.behind_shock(p, shock));
            // The outflow is supersonic: only the kernel's reach, half the clearance, matters.
            inside.min(2.0 * (ramp.end_x - p[0])) / smoothing_length
        })
        .collect();
    let mut clearance = CLEARANCE;
    let mut chosen = deeper(&depth, clearance);
    while chosen.len() < FEWEST && clearance > 2.0 {
        clearance -= 0.5;
        chosen = deeper(&depth, clearance);
    }
    if chosen.len() < FEWEST {
        return Err(MetricError::TooFew {
            what: "particles between wall and shock, two smoothing lengths off both",
            found: chosen.len(),
            needed: FEWEST,
            remedy: "use a finer spacing or a longer ramp",
        });
    }
    let middle =
        |values: &[f64]| median(&mut chosen.iter().map(|&k| values[k]).collect::<Vec<_>>());
    Ok(Plateau {
        density: middle(stream.density),
        pressure: middle(stream.pressure),
        mach: middle(stream.mach),
        particles: chosen.len(),
        clearance,
    })
}

fn deeper(depth: &[f64], clearance: f64) -> Vec<usize> {
    (0..depth.len())
        .filter(|&k| depth[k] >= clearance)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::testing::{Wedge, wedge};

    fn layer(spacing: f64) -> (Vec<[f64; 3]>, Vec<f64>, Ramp) {
        let flow = Wedge {
            beta: 42.89_f64.to_radians(),
            ramp: 20_f64.to_radians(),
            ratio: 2.2,
            spacing,
            noise: 0.01,
        };
        let (positions, density) = wedge(&flow);
        let ramp = Ramp {
            corner: [0.0, 0.0],
            angle: flow.ramp,
            end_x: 3.0,
        };
        (positions, density, ramp)
    }

    #[test]
    fn the_medians_of_a_resolved_layer_are_its_values() {
        let (positions, density, ramp) = layer(1.0 / 32.0);
        let stream = Stream {
            position: &positions,
            density: &density,
            pressure: &density,
            mach: &density,
        };
        let found = plateau(&stream, &ramp, 42.89_f64.to_radians(), 1.5 / 32.0).unwrap();
        assert!((found.density / 2.2 - 1.0).abs() < 0.003, "{found:?}");
        assert_eq!(found.clearance, 6.0);
        assert!(found.particles > 100);
    }

    #[test]
    fn a_thin_layer_is_read_closer_to_its_edges_and_says_so() {
        let (positions, density, ramp) = layer(1.0 / 8.0);
        let stream = Stream {
            position: &positions,
            density: &density,
            pressure: &density,
            mach: &density,
        };
        let found = plateau(&stream, &ramp, 42.89_f64.to_radians(), 1.5 / 8.0).unwrap();
        assert!(found.clearance < 6.0 && found.particles >= 12, "{found:?}");
    }

    #[test]
    fn a_layer_of_no_particles_is_refused_with_a_remedy() {
        let ramp = layer(0.1).2;
        let stream = Stream {
            position: &[[0.0; 3]; 3],
            density: &[1.0; 3],
            pressure: &[1.0; 3],
            mach: &[1.0; 3],
        };
        let error = plateau(&stream, &ramp, 0.7, 0.1).unwrap_err();
        assert!(error.to_string().contains("finer spacing"), "{error}");
    }

    #[test]
    fn arrays_of_different_lengths_are_refused() {
        let stream = Stream {
            position: &[[0.0; 3]; 3],
            density: &[1.0; 2],
            pressure: &[1.0; 3],
            mach: &[1.0; 3],
        };
        let ramp = layer(0.1).2;
        let error = plateau(&stream, &ramp, 0.7, 0.1).unwrap_err();
        assert_eq!(error.to_string(), "density has 2 entries for 3 particles");
    }
}
