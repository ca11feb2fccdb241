//! What is read off the gas in and before an intake.

use aero_solver::frame::{Frame, Kind};
use aero_validation::exact::isentropic;

pub const GAMMA: f64 = 1.4;
/// Of the stream, whose density and speed of sound are 1.
pub const MACH: f64 = 2.5;
/// Bands of equal height between floor and cowl, each with its own shock, and the length over which a band's mean is taken.
const BANDS: usize = 6;
const STRIP: f64 = 0.1;
/// Where a shock is looked for.
const DUCT: [f64; 2] = [2.9, 6.5];

/// The floor of the duct, and of the ramp before it.
fn floor(x: f64) -> f64 {
    let corners = [
        [0.0, 0.0],
        [3.0834, 0.3786],
        [3.4, 0.3786],
        [5.9, 0.16111],
        [6.5, 0.16111],
    ];
    let piece = corners.windows(2).find(|piece| x <= piece[1][0]);
    piece.map_or(corners[4][1], |piece| {
        let part = (x - piece[0][0]) / (piece[1][0] - piece[0][0]);
        piece[0][1] + part.max(0.0) * (piece[1][1] - piece[0][1])
    })
}

/// Mean of `value` with a weight, over the gas of a box.
fn mean(
    gas: &Frame,
    [x, y]: [[f64; 2]; 2],
    weight: impl Fn(usize) -> f64,
    value: impl Fn(usize) -> f64,
) -> f64 {
    let inside = |i: &usize| {
        let at = gas.position[*i];
        let is_in = |at: f64, ends: [f64; 2]| (ends[0]..ends[1]).contains(&at);
        gas.kind[*i] == Kind::Fluid as u8 && is_in(at[0], x) && is_in(at[1], y)
    };
    let sums = (0..gas.kind.len())
        .filter(inside)
        .fold((0.0, 0.0), |(sum, all), i| {
            (sum + weight(i) * value(i), all + weight(i))
        });
    sums.0 / sums.1
}

/// Mean Mach number of a box.
pub fn mach_in(gas: &Frame, region: [[f64; 2]; 2]) -> f64 {
    mean(gas, region, |i| gas.volume[i], |i| gas.mach[i])
}

/// Mean pressure of a box over the stream's.
pub fn pressure_in(gas: &Frame, region: [[f64; 2]; 2]) -> f64 {
    GAMMA * mean(gas, region, |i| gas.volume[i], |i| gas.pressure[i])
}

/// Mean over the mass of the total pressure in a part of the duct over the stream's.
pub fn recovery(gas: &Frame, x: [f64; 2]) -> f64 {
    let flow = |i: usize| gas.volume[i] * gas.density[i] * gas.velocity[i][0];
    let total = |i: usize| gas.pressure[i] * isentropic::pressure_ratio(gas.mach[i], GAMMA);
    GAMMA * mean(gas, [x, [0.0, 1.0]], flow, total) / isentropic::pressure_ratio(MACH, GAMMA)
}

/// Mass that flows through the end of the duct over that which meets the cowl, a unit high.
pub fn captured(gas: &Frame) -> f64 {
    let (x, y) = ([6.0, 6.4], [0.0, 1.0]);
    let flux = mean(
        gas,
        [x, y],
        |i| gas.volume[i],
        |i| gas.density[i] * gas.velocity[i][0],
    );
    flux * (1.0 - floor(6.2)) / MACH
}

/// Where the Mach number falls through one in the duct, mean over bands of the height; not a number where a band has no such place.
pub fn place(gas: &Frame) -> f64 {
    let strips = ((DUCT[1] - DUCT[0]) / STRIP) as usize;
    let mut sums = vec![vec![(0.0, 0.0); strips]; BANDS];
    for i in (0..gas.kind.len()).filter(|&i| gas.kind[i] == Kind::Fluid as u8) {
        let [x, y, _] = gas.position[i];
        let strip = (x - DUCT[0]) / STRIP;
        if (0.0..strips as f64).contains(&strip) && y < 1.0 {
            let band = (y - floor(x)) / (1.0 - floor(x)) * BANDS as f64;
            let sum = &mut sums[(band.max(0.0) as usize).min(BANDS - 1)][strip as usize];
            sum.0 += gas.volume[i] * gas.mach[i];
            sum.1 += gas.volume[i];
        }
    }
    let places = sums.iter().map(|band| {
        let means: Vec<f64> = band.iter().map(|(sum, volume)| sum / volume).collect();
        let shock = means.windows(2).position(|m| m[0] > 1.0 && m[1] <= 1.0);
        shock.map_or(f64::NAN, |n| {
            let part = (means[n] - 1.0) / (means[n] - means[n + 1]);
            DUCT[0] + (n as f64 + 0.5 + part) * STRIP
        })
    });
    places.sum::<f64>() / BANDS as f64
}
