//! What is read off the flow around the cylinder: shock, wall pressure, total enthalpy.

use aero_validation::metrics::MetricError;
use aero_validation::metrics::crossing::level_crossings;
use aero_validation::metrics::invariants::total_enthalpy;
use aero_validation::metrics::stagnation::stagnation_pressure;
use aero_validation::metrics::stand_off::{StagnationLine, stand_off};
use aero_validation::reference::{Table, cylinder_shock, cylinder_wall};

use aero::run::Outcome;

pub const MACH: f64 = 10.0;
pub const GAMMA: f64 = 1.4;
/// Heights at which the shock is looked for, in radii.
const HEIGHTS: [f64; 9] = [0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8];
/// End of the nose's share of the wall, in degrees from the stagnation point; the flank, a wedge of
/// 14.04 degrees, follows.
const NOSE_END: f64 = 75.96;
/// The wall pressure is extrapolated to the stagnation point from this many degrees around it.
const CAP: f64 = 20.0;
/// Distance from the shock at which the flow is behind it, in spacings.
const CLEARANCE: f64 = 4.0;

/// What is read off the flow.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Distance of shock and nose, radii.
    pub stand_off: f64,
    /// Stagnation pressure, over the free stream's.
    pub stagnation: f64,
    /// Largest distance from the reference shock along the stream, radii.
    pub shape: f64,
    /// Mean departure of the wall pressure on the nose, over the stagnation pressure.
    pub wall: f64,
    /// Median departure of the total enthalpy between shock and wall, over the free stream's.
    pub enthalpy: f64,
}

impl Measured {
    pub fn new(outcome: &Outcome, spacing: f64) -> Result<Self, MetricError> {
        let gas = &outcome.gas;
        let behind = density_ratio();
        let line = StagnationLine {
            nose: [-1.0, 0.0, 0.0],
            upstream: [-1.0, 0.0, 0.0],
            radius: 4.0 * spacing,
            spacing,
            ahead: 1.0,
            behind,
        };
        let is_of_points = outcome.summary.motion == "fixed";
        let shock = if is_of_points {
            on_the_axis(outcome, spacing, 0.5 * (1.0 + behind))?
        } else {
            stand_off(&gas.position, &gas.density, &line)?.distance
        };
        let ahead = ahead_of_shock(outcome);
        Ok(Self {
            stand_off: shock,
            stagnation: stagnation(outcome)?,
            shape: shape(outcome, &ahead, spacing, 0.5 * (1.0 + behind))?,
            wall: wall(outcome),
            enthalpy: enthalpy(outcome, &ahead, spacing)?,
        })
    }
}

/// Density behind a normal shock, over the one ahead (NACA 1135, 1953, eq. 94).
fn density_ratio() -> f64 {
    let square = MACH * MACH;
    (GAMMA + 1.0) * square / ((GAMMA - 1.0) * square + 2.0)
}

/// Distance of each particle from the reference shock, positive upstream along the stream; outside
/// the table's heights the end rows' shock.
fn ahead_of_shock(outcome: &Outcome) -> Vec<f64> {
    let table = cylinder_shock();
    let shock = |y: f64| table.interpolate("y", "x_upstream_FV", y);
    outcome
        .gas
        .position
        .iter()
        .map(|at| shock(at[1]).map_or(f64::NAN, |x| -at[0] - x))
        .collect()
}

/// Largest distance between the half-jump of the density and the reference shock.
fn shape(outcome: &Outcome, ahead: &[f64], spacing: f64, level: f64) -> Result<f64, MetricError> {
    let gas = &outcome.gas;
    let mut largest = 0.0_f64;
    for height in HEIGHTS {
        let strip: Vec<usize> = (0..ahead.len())
            .filter(|&i| (gas.position[i][1] - height).abs() < 2.0 * spacing)
            .collect();
        let along: Vec<f64> = strip.iter().map(|&i| ahead[i]).collect();
        let density: Vec<f64> = strip.iter().map(|&i| gas.density[i]).collect();
        let shock = level_crossings(&along, &density, level, 1.5 * spacing)
            .into_iter()
            .rfind(|crossing| crossing.rise < 0.0)
            .ok_or(MetricError::TooFew {
                what: "falls of the density through half the jump at one height",
                found: 0,
                needed: 1,
                remedy: "run longer",
            })?;
        largest = largest.max(shock.coordinate.abs());
    }
    Ok(largest)
}

/// Stand-off where points stay: a shock of one or two cells is too thin to be fitted, and stands still in the row next to the axis.
fn on_the_axis(outcome: &Outcome, spacing: f64, level: f64) -> Result<f64, MetricError> {
    let gas = &outcome.gas;
    let row = gas.position.iter().zip(&gas.density);
    let mut row: Vec<[f64; 2]> = row
        .filter(|(place, _)| place[0] < -1.0 && place[1].abs() < spacing)
        .map(|(place, density)| [place[0], *density])
        .collect();
    row.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let crossing = row
        .windows(2)
        .find(|pair| pair[0][1] < level && level <= pair[1][1]);
    let [[x, low], [next, high]] = *crossing.ok_or(MetricError::TooFew {
        what: "rises of the density through half the jump on the axis",
        found: 0,
        needed: 1,
        remedy: "run longer",
    })?
    else {
        return Ok(f64::NAN);
    };
    Ok(-1.0 - (x + (level - low) / (high - low) * (next - x)))
}

/// Angle of a point of the wall from the stagnation point, degrees.
pub fn angle(foot: &[f64; 3]) -> f64 {
    foot[1].atan2(-foot[0]).to_degrees()
}

/// Wall pressure over the free stream's, at the stagnation point.
fn stagnation(outcome: &Outcome) -> Result<f64, MetricError> {
    let wall = &outcome.surface;
    let walls = wall.position.iter().zip(&wall.pressure);
    stagnation_pressure(
        walls.map(|(foot, pressure)| (angle(foot), pressure * GAMMA)),
        CAP,
    )
}

/// Mean size of the departure of the wall pressure from the reference, over the stagnation
/// pressure of the reference.
pub fn wall(outcome: &Outcome) -> f64 {
    let table = cylinder_wall();
    let reference = |angle: f64| table.interpolate("angle_deg", "p_pinf", angle);
    let stagnation = reference(0.0).unwrap_or(f64::NAN);
    let wall = &outcome.surface;
    let departures: Vec<f64> = wall
        .position
        .iter()
        .zip(&wall.pressure)
        .map(|(foot, pressure)| (angle(foot), pressure * GAMMA))
        .filter(|(angle, _)| (0.0..NOSE_END).contains(angle))
        .map(|(angle, pressure)| {
            (pressure - reference(angle).unwrap_or(f64::NAN)).abs() / stagnation
        })
        .collect();
    departures.iter().sum::<f64>() / departures.len() as f64
}

/// Median size of the departure of the total enthalpy over the nose, between shock and wall. Inside
/// a shock some spacings thick it is not constant: heat conduction and viscosity differ.
fn enthalpy(outcome: &Outcome, ahead: &[f64], spacing: f64) -> Result<f64, MetricError> {
    let gas = &outcome.gas;
    let shoulder = NOSE_END.to_radians();
    let chosen: Vec<usize> = (0..ahead.len())
        .filter(|&i| ahead[i] < -CLEARANCE * spacing)
        .filter(|&i| gas.position[i][0] < -shoulder.cos())
        .collect();
    let pick = |values: &[f64]| -> Vec<f64> { chosen.iter().map(|&i| values[i]).collect() };
    let velocity: Vec<[f64; 3]> = chosen.iter().map(|&i| gas.velocity[i]).collect();
    // Density and speed of sound of the stream are 1.
    let stream = 1.0 / (GAMMA - 1.0) + 0.5 * MACH * MACH;
    let (density, pressure) = (pick(&gas.density), pick(&gas.pressure));
    Ok(total_enthalpy(&velocity, &density, &pressure, stream, GAMMA)?.median)
}

/// Points of the nose and of the flank behind it.
pub fn nose() -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = (0..=40)
        .map(|k| (NOSE_END * f64::from(k) / 40.0).to_radians())
        .map(|angle| [-angle.cos(), angle.sin()])
        .collect();
    let flank = (90.0 - NOSE_END).to_radians().tan();
    if let Some([x, y]) = points.last().copied() {
        points.push([0.25, y + (0.25 - x) * flank]);
    }
    points
}

/// Wall pressure by finite volumes: angle, share of the stagnation pressure.
pub fn volumes_wall() -> Vec<[f64; 2]> {
    let table: Table = cylinder_wall();
    let column = |name: &str| table.column(name).unwrap_or_default().to_vec();
    let pressures = column("p_p02");
    column("angle_deg")
        .into_iter()
        .zip(pressures)
        .map(|(angle, pressure)| [angle, pressure])
        .collect()
}
