//! What is read off the flow over the corner: plateau, shock angle two ways, the gas at the wall.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_solver::frame::Frame;
use aero_validation::exact::oblique::ObliqueShock;
use aero_validation::metrics::MetricError;
use aero_validation::metrics::gradient::{Cloud, gradient};
use aero_validation::metrics::gradient_angle::{SHARE, gradient_angle};
use aero_validation::metrics::plateau::{Plateau, Ramp, Stream, plateau};
use aero_validation::metrics::shock_line::{ShockLine, ShockSearch, fit_shock_line};

use super::corner::Corner;
use crate::comparison::Flow;

/// Distance from corner, wall and shock at which the flow is read, in smoothing lengths.
const CLEARANCE: f64 = 6.0;

/// What is read off the flow.
pub struct Measured {
    pub plateau: Plateau,
    /// The shock where the density passes half its jump.
    pub line: ShockLine,
    /// Shock angle by the steepest gradients, radians.
    pub steepest: f64,
    /// Mean density and energy of the gas next to the wall.
    pub wall: [f64; 2],
}

impl Measured {
    pub fn new(flow: &Flow<'_, Corner>, shock: &ObliqueShock) -> Result<Self, MetricError> {
        let gas = &flow.outcome.gas;
        let ramp = Ramp {
            corner: [0.0, 0.0],
            angle: flow.variant.own.angle.to_radians(),
            end_x: 3.0,
        };
        let stream = Stream {
            position: &gas.position,
            density: &gas.density,
            pressure: &gas.pressure,
            mach: &gas.mach,
        };
        // Behind the shock the particles are closer and the kernels narrower.
        let h = SMOOTHING_RATIO * flow.spacing;
        let h_behind = h / shock.density_ratio.sqrt();
        let search = ShockSearch::above_ramp(
            &ramp,
            3.0,
            CLEARANCE * h,
            [1.0, shock.density_ratio],
            flow.spacing,
        );
        let volume: Vec<f64> = gas
            .smoothing_length
            .iter()
            .map(|h| (h / SMOOTHING_RATIO).powi(2))
            .collect();
        let cloud = Cloud {
            position: &gas.position,
            volume: &volume,
            smoothing_length: &gas.smoothing_length,
            dimension: 2,
        };
        let gradients = gradient(&cloud, &gas.density)?;
        Ok(Self {
            plateau: plateau(&stream, &ramp, shock.angle, h_behind)?,
            wall: next_to_the_wall(gas, &ramp, flow.spacing),
            line: fit_shock_line(&gas.position, &gas.density, &search)?,
            steepest: gradient_angle(&gas.position, &gradients, SHARE)?.angle,
        })
    }
}

/// Mean density and energy of what lies within a spacing of the middle of the ramp, where errors that
/// were made at its corner stay.
fn next_to_the_wall(gas: &Frame, ramp: &Ramp, spacing: f64) -> [f64; 2] {
    let (sin, cos) = ramp.angle.sin_cos();
    let length = (ramp.end_x - ramp.corner[0]) / cos;
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    for (n, position) in gas.position.iter().enumerate() {
        let (x, y) = (position[0] - ramp.corner[0], position[1] - ramp.corner[1]);
        let (along, above) = (x * cos + y * sin, y * cos - x * sin);
        if above < spacing && (0.5 * length..0.75 * length).contains(&along) {
            sums[0] += gas.density[n];
            sums[1] += gas.energy[n];
            count += 1.0;
        }
    }
    sums.map(|sum| sum / count)
}
