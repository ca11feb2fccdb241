//! Where the shocks stand: bow shock, Mach stem, the reflection on the step.

use aero_solver::frame::Frame;
use aero_validation::metrics::MetricError;
use aero_validation::metrics::crossing::{Crossing, level_crossings};

/// Face and top of the step.
pub const STEP: [f64; 2] = [0.6, 0.2];
/// Half the jump of the density lies at 3.4 where the bow shock is normal and at 2.8 near the upper
/// wall, where it is most oblique.
const HALF_JUMP: f64 = 3.1;

/// The gas in which shocks are looked for.
pub struct Shocks<'a> {
    pub gas: &'a Frame,
    pub spacing: f64,
}

impl Shocks<'_> {
    /// The first rise of the density to half the jump, along a strip at height `y`.
    pub fn bow_shock(&self, y: f64) -> Result<f64, MetricError> {
        let strip = self.strip(y, [0.0, 1.2]);
        first_rise(&self.crossings(&strip, HALF_JUMP), "the bow shock")
    }

    /// Height at which the bow shock, a parabola through its positions below, reaches the stem.
    pub fn triple_point(&self, stem: f64) -> Result<f64, MetricError> {
        let heights = [0.7, 0.8, 0.9];
        let mut x = [0.0; 3];
        for (x, y) in x.iter_mut().zip(heights) {
            *x = self.bow_shock(y)?;
        }
        // Newton's divided differences of y over x.
        let first = 0.1 / (x[1] - x[0]);
        let second = (0.1 / (x[2] - x[1]) - first) / (x[2] - x[0]);
        Ok(heights[0] + (stem - x[0]) * (first + second * (stem - x[1])))
    }

    /// Half the jump of the density across the reflection on the top of the step.
    pub fn foot(&self) -> Result<f64, MetricError> {
        let strip = self.strip(STEP[1], [1.3, 2.1]);
        let ahead: Vec<f64> = strip.iter().filter(|s| s[0] < 1.5).map(|s| s[1]).collect();
        let ahead = ahead.iter().sum::<f64>() / ahead.len() as f64;
        let behind = strip.iter().map(|s| s[1]).fold(0.0, f64::max);
        let crossings = self.crossings(&strip, 0.5 * (ahead + behind));
        first_rise(&crossings, "the reflection on the step")
    }

    /// Position and density of the gas within two spacings of a height.
    fn strip(&self, y: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        self.gas
            .position
            .iter()
            .zip(&self.gas.density)
            .filter(|(at, _)| (at[1] - y).abs() < 2.0 * self.spacing)
            .filter(|(at, _)| (from..to).contains(&at[0]))
            .map(|(at, density)| [at[0], *density])
            .collect()
    }

    fn crossings(&self, strip: &[[f64; 2]], level: f64) -> Vec<Crossing> {
        let x: Vec<f64> = strip.iter().map(|s| s[0]).collect();
        let density: Vec<f64> = strip.iter().map(|s| s[1]).collect();
        level_crossings(&x, &density, level, 1.5 * self.spacing)
    }
}

fn first_rise(crossings: &[Crossing], what: &'static str) -> Result<f64, MetricError> {
    crossings
        .iter()
        .find(|crossing| crossing.rise > 0.0)
        .map(|crossing| crossing.coordinate)
        .ok_or(MetricError::TooFew {
            what,
            found: 0,
            needed: 1,
            remedy: "run longer or refine",
        })
}
