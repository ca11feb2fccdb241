//! Air in equilibrium, looked up: its composition costs a search for each state, so it is searched once on a lattice of states.
//!
//! What the flow asks for are `e rho / p` and `T rho / p`, smooth functions of `ln rho` and `ln(p / rho)`. Pressure, energy and speed of
//! sound all follow from the first one and its own derivatives, so that they belong together whatever the lattice is.

use std::sync::LazyLock;

use super::Ratio;
use super::equilibrium::{Level, Mixture};
use super::mixture;
use super::spline::{Axis, Spline};

/// Densities, kg/m^3, from those at 85 km to those of a strong shock at sea level; beyond them the composition is the one at the end.
pub const DENSITIES: [f64; 2] = [1e-7, 100.0];

/// `p / rho`, J/kg: that of cold air below the range of its polynomials, and of more than any return to Earth.
const HEATS: [f64; 2] = [4.3e4, 1.5e7];

/// Nodes of the lattice.
const NODES: [usize; 2] = [101, 481];

/// Coldest gas for which compositions are found, K, and the ratio from one temperature to the next.
const COLDEST: f64 = 120.0;
const RATIO: f64 = 1.004;

/// Steps of Newton's method for `p / rho` of an energy.
const STEPS: usize = 60;

/// How exactly its logarithm is found.
const EXACT: f64 = 1e-13;

/// The lattice.
#[derive(Debug)]
pub struct Table {
    axes: [Axis; 2],
    /// `e rho / p`.
    ratio: Spline,
    /// `T rho / p` times the gas constant of cold air: one over how many moles have become of one.
    whole: Spline,
    /// Specific entropy, J/(kg K).
    entropy: Spline,
    /// About where `ln(p / rho)` is for `ln rho` and `ln e`.
    guesses: Guesses,
    /// Gas constant of cold air.
    constant: f64,
}

/// The table; made when it is first asked for.
pub static TABLE: LazyLock<Table> = LazyLock::new(Table::new);

/// `ln(p / rho)` on a lattice of `ln rho` and `ln e`.
#[derive(Debug)]
struct Guesses {
    axes: [Axis; 2],
    values: Vec<f64>,
}

impl Table {
    fn new() -> Self {
        let axes = [
            Axis::new(DENSITIES.map(f64::ln), NODES[0]),
            Axis::new(HEATS.map(f64::ln), NODES[1]),
        ];
        let mut levels = Levels::default();
        let [mut ratios, mut wholes, mut entropies] = [(); 3].map(|()| Vec::new());
        let constant = mixture::gas_constant();
        for row in 0..axes[0].count {
            let curve = Curve::new(
                axes[0].node(row).exp(),
                axes[1].end(),
                constant,
                &mut levels,
            );
            for column in 0..axes[1].count {
                let [ratio, whole, entropy] = curve.at(axes[1].node(column));
                ratios.push(ratio);
                wholes.push(whole);
                entropies.push(entropy);
            }
        }
        Self {
            axes,
            guesses: Guesses::new(axes, &ratios),
            ratio: Spline::new(axes, &ratios),
            whole: Spline::new(axes, &wholes),
            entropy: Spline::new(axes, &entropies),
            constant,
        }
    }

    /// A place on the lattice, and whether it was on it along each axis.
    fn inside(&self, density: f64, heat: f64) -> ([f64; 2], [bool; 2]) {
        let place = [density.ln(), heat.ln()];
        let clamped = [0, 1].map(|k| place[k].clamp(self.axes[k].start, self.axes[k].end()));
        (clamped, [0, 1].map(|k| clamped[k] == place[k]))
    }

    /// `e rho / p` where `p / rho` is `heat`.
    pub fn ratio(&self, density: f64, heat: f64) -> Ratio {
        let (place, is_inside) = self.inside(density, heat);
        let [value, by_density, by_heat] = self.ratio.at(place);
        Ratio {
            value,
            by_density: if is_inside[0] { by_density } else { 0.0 },
            by_heat: if is_inside[1] { by_heat } else { 0.0 },
        }
    }

    /// Temperature, K, over `p / rho`, and the relative change of that with those of density and `p / rho`.
    pub fn temperature(&self, density: f64, heat: f64) -> Ratio {
        let (place, is_inside) = self.inside(density, heat);
        let [value, by_density, by_heat] = self.whole.at(place);
        Ratio {
            value: value / self.constant,
            by_density: if is_inside[0] {
                by_density / value
            } else {
                0.0
            },
            by_heat: if is_inside[1] { by_heat / value } else { 0.0 },
        }
    }

    /// Specific entropy, J/(kg K): beyond the lattice that of gas which stays what it is at its end.
    pub fn entropy(&self, density: f64, heat: f64) -> f64 {
        let (place, _) = self.inside(density, heat);
        let [ratio, whole] = [&self.ratio, &self.whole].map(|spline| spline.at(place)[0]);
        let further = ratio * (heat.ln() - place[1]) - (density.ln() - place[0]);
        self.entropy.at(place)[0] + self.constant / whole * further
    }

    /// `p / rho` of a density and a specific internal energy: Newton's method, between bounds, from what is known of states nearby.
    pub fn heat(&self, density: f64, energy: f64) -> f64 {
        let (place, _) = self.inside(density, HEATS[0]);
        let wanted = energy.ln();
        let [mut low, mut high] = [self.axes[1].start, self.axes[1].end()];
        let mut found = self.guesses.at([place[0], wanted]).clamp(low, high);
        // At an end of the lattice the last ratio goes on.
        let mut ratio = 1.0;
        for _ in 0..STEPS {
            let [value, _, by_heat] = self.ratio.at([place[0], found]);
            ratio = value;
            let off = found + value.ln() - wanted;
            if off > 0.0 {
                high = found;
            } else {
                low = found;
            }
            let mut next = found - off / (1.0 + by_heat / value);
            if next < low || next > high {
                next = 0.5 * (low + high);
            }
            let step = next - found;
            found = next;
            if step.abs() < EXACT {
                break;
            }
        }
        energy / ratio
    }
}

impl Guesses {
    /// By straight lines between the nodes of a lattice of `e rho / p`.
    fn new(axes: [Axis; 2], ratios: &[f64]) -> Self {
        let columns = axes[1].count;
        let logarithm = |k: usize| axes[1].node(k % columns) + ratios[k].ln();
        let ends = (0..ratios.len())
            .map(logarithm)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], w| {
                [low.min(w), high.max(w)]
            });
        let axis = Axis::new(ends, columns);
        let mut values = Vec::with_capacity(ratios.len());
        for row in 0..axes[0].count {
            let mut before = 0;
            for wanted in (0..columns).map(|k| axis.node(k)) {
                while before + 2 < columns && logarithm(row * columns + before + 1) < wanted {
                    before += 1;
                }
                let [low, high] = [0, 1].map(|k| logarithm(row * columns + before + k));
                let part = (wanted - low) / (high - low);
                values.push(axes[1].node(before) + part * axes[1].step);
            }
        }
        Self {
            axes: [axes[0], axis],
            values,
        }
    }

    fn at(&self, place: [f64; 2]) -> f64 {
        let (row, s) = self.axes[0].cell(place[0]);
        let (column, t) = self.axes[1].cell(place[1]);
        let line = |row: usize| {
            let start = row * self.axes[1].count + column;
            self.values[start] + t * (self.values[start + 1] - self.values[start])
        };
        let first = line(row);
        first + s * (line(row + 1) - first)
    }
}

/// What the species hold at each of the temperatures, found when it is first asked for.
#[derive(Default)]
struct Levels(Vec<(f64, Level)>);

impl Levels {
    fn get(&mut self, number: usize) -> (f64, Level) {
        while self.0.len() <= number {
            let temperature = COLDEST * RATIO.powi(self.0.len() as i32);
            self.0.push((temperature, Level::at(temperature)));
        }
        self.0[number]
    }
}

/// Gas of one density from cold to hot: `ln(p / rho)`, `e rho / p`, how much is whole, and entropy.
struct Curve(Vec<[f64; 4]>);

impl Curve {
    /// Up to beyond `last`.
    fn new(density: f64, last: f64, constant: f64, levels: &mut Levels) -> Self {
        let mut points: Vec<[f64; 4]> = Vec::new();
        let mut before: Option<Mixture> = None;
        let mut shift = 0.0;
        // Two points more, for the cubic between the last ones.
        while points.len() < 3 || points[points.len() - 3][0] < last {
            let (temperature, level) = levels.get(points.len());
            let found = Mixture::new(&level, density, before.as_ref());
            if points.is_empty() {
                // Energy counts from the gas at rest at no temperature, with the heat capacity that it has when cold.
                let (warmer, level) = levels.get(1);
                let next = Mixture::new(&level, density, None);
                let capacity = (next.energy - found.energy) / (warmer - temperature);
                shift = capacity * temperature - found.energy;
            }
            points.push([
                found.heat.ln(),
                (found.energy + shift) / found.heat,
                constant * temperature / found.heat,
                found.entropy,
            ]);
            before = Some(found);
        }
        Self(points)
    }

    /// The cubic through the four points around `place` [Lagrange].
    fn at(&self, place: f64) -> [f64; 3] {
        let points = &self.0;
        let after = points.partition_point(|point| point[0] < place);
        let start = after.saturating_sub(2).min(points.len() - 4);
        let four = &points[start..start + 4];
        let mut sums = [0.0; 3];
        for (k, [own, ratio, whole, entropy]) in four.iter().enumerate() {
            let others = four.iter().enumerate().filter(|(l, _)| *l != k);
            let weight: f64 = others
                .map(|(_, [other, ..])| (place - other) / (own - other))
                .product();
            sums[0] += weight * ratio;
            sums[1] += weight * whole;
            sums[2] += weight * entropy;
        }
        sums
    }
}
