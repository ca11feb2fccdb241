//! What is read off the double reflection: stem, triple point, wall pressure, how uniform the gas is.

use aero::run::Outcome;
use aero_validation::metrics::MetricError;
use aero_validation::metrics::crossing::level_crossings;

/// The triple point.
pub const TRIPLE: [f64; 2] = [2.733, 0.440];
/// Where the wall pressure is read.
const PLATEAU: [f64; 2] = [1.3, 1.9];
/// Density ahead of and behind the shock.
const DENSITY: [f64; 2] = [1.4, 8.0];
/// Heights between which the stem and the shock above it are straight.
const STEM: [f64; 2] = [0.1, 0.36];
const SHOCK: [f64; 2] = [0.6, 0.9];
/// The uniform gas between the shock and the reflected one, and heights of it.
const UNIFORM: [[f64; 2]; 2] = [[2.2, 2.6], [0.6, 0.9]];

/// The gas in the frame of Woodward and Colella: `x` along the ramp, which begins at a sixth.
pub struct Reflection<'a> {
    position: Vec<[f64; 3]>,
    density: &'a [f64],
    spacing: f64,
    pressure: f64,
}

/// What is read off the flow.
pub struct Measured {
    pub foot: f64,
    pub triple: [f64; 2],
    /// Largest distance of the stem from its straight line.
    pub kink: f64,
    /// Mean pressure on the wall.
    pub pressure: f64,
    /// Root mean square departure of the uniform gas from its density, over that.
    pub spots: f64,
}

/// A point in the frame of Woodward and Colella.
pub fn turned(at: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    [
        1.0 / 6.0 + at[0] * cos + at[1] * sin,
        at[1] * cos - at[0] * sin,
        0.0,
    ]
}

impl<'a> Reflection<'a> {
    pub fn new(outcome: &'a Outcome, spacing: f64) -> Self {
        let wall = &outcome.surface;
        let (mut sum, mut count) = (0.0, 0.0);
        for (i, foot) in wall.position.iter().enumerate() {
            if wall.body[i] == 0 && (PLATEAU[0]..PLATEAU[1]).contains(&turned(*foot)[0]) {
                sum += wall.pressure[i];
                count += 1.0;
            }
        }
        Self {
            position: outcome.gas.position.iter().copied().map(turned).collect(),
            density: &outcome.gas.density,
            spacing,
            pressure: sum / count,
        }
    }

    /// The foremost fall of the density through half the jump, along a strip at height `y` that leans
    /// with the shock above the triple point.
    fn front(&self, y: f64) -> Result<f64, MetricError> {
        let lean = if y > TRIPLE[1] {
            30_f64.to_radians().tan()
        } else {
            0.0
        };
        let (mut along, mut density) = (Vec::new(), Vec::new());
        for (at, value) in self.position.iter().zip(self.density) {
            if (at[1] - y).abs() < 2.0 * self.spacing && at[0] > 2.0 {
                along.push(at[0] - lean * (at[1] - y));
                density.push(*value);
            }
        }
        let level = 0.5 * (DENSITY[0] + DENSITY[1]);
        level_crossings(&along, &density, level, 1.5 * self.spacing)
            .into_iter()
            .rfind(|crossing| crossing.rise < 0.0)
            .map(|crossing| crossing.coordinate)
            .ok_or(MetricError::TooFew {
                what: "falls of the density through half the jump at one height",
                found: 0,
                needed: 1,
                remedy: "run to the end",
            })
    }

    /// Heights and places of the front between two heights.
    fn fronts(&self, [low, high]: [f64; 2]) -> Result<Vec<[f64; 2]>, MetricError> {
        const COUNT: usize = 14;
        (0..COUNT)
            .map(|k| low + (high - low) * k as f64 / (COUNT - 1) as f64)
            .map(|y| self.front(y).map(|x| [y, x]))
            .collect()
    }

    pub fn measure(&self) -> Result<Measured, MetricError> {
        let stem = self.fronts(STEM)?;
        let [a, b] = straight_line(&stem);
        let [c, d] = straight_line(&self.fronts(SHOCK)?);
        let y = (a - c) / (d - b);
        let kink = stem.iter().map(|[y, x]| (x - a - b * y).abs());
        let [x_range, y_range] = UNIFORM;
        let uniform: Vec<f64> = self
            .position
            .iter()
            .zip(self.density)
            .filter(|(at, _)| {
                (x_range[0]..x_range[1]).contains(&at[0])
                    && (y_range[0]..y_range[1]).contains(&at[1])
            })
            .map(|(_, density)| (density / DENSITY[1] - 1.0).powi(2))
            .collect();
        Ok(Measured {
            foot: self.front(0.0)?,
            triple: [c + d * y, y],
            kink: kink.fold(0.0, f64::max),
            pressure: self.pressure,
            spots: (uniform.iter().sum::<f64>() / uniform.len() as f64).sqrt(),
        })
    }
}

/// Offset and slope of the straight line `y = offset + slope x` nearest to the points.
fn straight_line(points: &[[f64; 2]]) -> [f64; 2] {
    let count = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / count;
    let middle = [mean(0), mean(1)];
    let moment = |k: usize| -> f64 {
        let arm = |p: &[f64; 2], k: usize| p[k] - middle[k];
        points.iter().map(|p| arm(p, 0) * arm(p, k)).sum()
    };
    let slope = moment(1) / moment(0);
    [middle[1] - slope * middle[0], slope]
}
