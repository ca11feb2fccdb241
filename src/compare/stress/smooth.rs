//! Flows where all that is dissipated is error: two vortices that should stay as they are, a shear layer that should roll up, and waves that a
//! shock has run through.

use aero_solver::frame::Frame;
use aero_validation::metrics::order::convergence_order;
use aero_validation::reference;
use aero_validation::table::{Check, Subject};

use super::schemes::equations;
use super::trial::Trial;
use crate::context::{CompareError, Context, Level};
use crate::row::Row;
use crate::scenes::{Source, scene};
use crate::variant::Scheme;

/// Least order of convergence of the isentropic vortex: of particles, and of points.
const LEAST_ORDER: [f64; 2] = [1.5, 1.8];
/// Largest mean error of its velocity at 256 to a side, per cent of the largest.
const ERROR_AT_256: f64 = 0.12;

const VORTEX: Source = scene!("stress", "vortex");
const GRESHO: Source = scene!("stress", "gresho");
/// Cells to a unit, and the mean density error that rhoCentralFoam has there (`validation/points`), per cent.
const PEER: [(u32, f64); 3] = [(20, 2.53), (40, 1.02), (80, 1.83)];
/// Where the waves' density is known.
const WINDOW: std::ops::Range<f64> = -4.5..5.0;

/// Places in a cell that what is known is taken at.
const SAMPLES: u32 = 32;

const WAVES: Source = scene!("stress", "shu-osher");
const SHEAR: Source = scene!("stress", "kelvin-helmholtz");

/// Runs the vortices and the shear layer; there are no walls, so extrapolations play no part.
pub fn compare(context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let mut checks = Vec::new();
    for scheme in equations(context.level) {
        checks.extend(vortex(scheme, context)?);
        checks.extend(gresho(scheme, context)?);
        checks.extend(shear(scheme, context)?);
        if scheme.is_of_points() {
            checks.extend(waves(scheme, context)?);
        }
    }
    Ok(checks)
}

/// Error of the velocity over three spacings, and its order.
fn vortex(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let counts: &[u32] = match context.level {
        Level::Quick => &[32, 64],
        Level::Full => &[64, 128, 256],
    };
    let equations = scheme.laws();
    let (mut checks, mut spacings, mut errors) = (Vec::new(), Vec::new(), Vec::new());
    for &count in counts {
        let spacing = 10.0 / f64::from(count);
        let trial = Trial::new(VORTEX, scheme)
            .called(format!("{equations} N = {count}"))
            .with([format!("spacing={spacing}")]);
        checks.extend(trial.compare(context, |outcome| {
            let Some(outcome) = outcome else {
                return Ok(Vec::new());
            };
            let error = velocity_error(&outcome.gas, |r| {
                5.0 / std::f64::consts::TAU * (0.5 * (1.0 - r * r)).exp() * r
            });
            spacings.push(spacing);
            errors.push(error);
            let quantity = "mean velocity error, % of largest";
            Ok(vec![if count == 256 {
                Row::at_most(quantity, "Shu 1997", 100.0 * error, ERROR_AT_256)
            } else {
                Row::informs(quantity, "Shu 1997", 100.0 * error, 0.0)
            }])
        })?);
    }
    let quantity = format!("{equations}: order of convergence, L1 of velocity");
    let subject = Subject::new(VORTEX.name, &quantity, "second order where smooth");
    let order = convergence_order(&spacings, &errors).map_or(f64::NAN, |order| order.order);
    let least = LEAST_ORDER[usize::from(scheme.is_of_points())];
    checks.push(if scheme.is_conservative() {
        subject.at_least(order, least)
    } else {
        subject.informs(order, least)
    });
    Ok(checks)
}

fn gresho(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let trial = Trial::new(GRESHO, scheme).called(scheme.laws().to_owned());
    trial.compare(context, |outcome| {
        let Some(outcome) = outcome else {
            return Ok(Vec::new());
        };
        let gas = &outcome.gas;
        let swirl = |r: f64| (5.0 * r).min((2.0 - 5.0 * r).max(0.0));
        let error = 100.0 * velocity_error(gas, swirl);
        let near_peak = (0..gas.position.len())
            .filter(|&i| (radius(&gas.position[i]) - 0.2).abs() < 0.01)
            .map(|i| swirl_of(gas, i));
        let (sum, count) = near_peak.fold((0.0, 0_u32), |(s, n), u| (s + u, n + 1));
        let peak = sum / f64::from(count);
        let source = "exact, steady";
        Ok(vec![
            Row::informs("mean velocity error, % of largest", source, error, 0.0),
            Row::informs("mean swirl at its peak, r = 0.2", source, peak, 0.975),
        ])
    })
}

fn shear(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let trial = Trial::new(SHEAR, scheme).called(scheme.laws().to_owned());
    trial.compare(context, |outcome| {
        let growth = outcome.map(|o| mode(&o.gas) / MODE_AT_START);
        let quantity = "amplitude of the mode over its start";
        let row = growth.map(|growth| Row::informs(quantity, "it must grow", growth, 1.0));
        Ok(Vec::from_iter(row))
    })
}

/// The density of the waves, against the peer's at equal spacings.
fn waves(scheme: Scheme, context: &Context<'_>) -> Result<Vec<Check>, CompareError> {
    let table = reference::shu_osher();
    let mut checks = Vec::new();
    for (count, peer) in PEER {
        let trial = Trial::new(WAVES, scheme)
            .called(format!("{} N = {count}", scheme.laws()))
            .with([format!("spacing={}", 1.0 / f64::from(count))]);
        checks.extend(trial.compare(context, |outcome| {
            let Some(outcome) = outcome else {
                return Ok(Vec::new());
            };
            let gas = &outcome.gas;
            let places = gas.position.iter().zip(&gas.density);
            let mut sums = [0.0; 2];
            for (place, density) in places.filter(|(place, _)| WINDOW.contains(&place[0])) {
                // Cells hold means.
                let known = (0..SAMPLES).map(|k| {
                    let off = (f64::from(k) + 0.5) / f64::from(SAMPLES) - 0.5;
                    let at = place[0] + off / f64::from(count);
                    table.interpolate("x", "rho", at).unwrap_or(f64::NAN)
                });
                let known = known.sum::<f64>() / f64::from(SAMPLES);
                sums[0] += (density - known).abs();
                sums[1] += known;
            }
            let quantity = "mean density error, %";
            let error = 100.0 * sums[0] / sums[1];
            Ok(vec![Row::at_most(quantity, "rhoCentralFoam", error, peer)])
        })?);
    }
    Ok(checks)
}

/// Amplitude of the seeded mode at the start by the sum of [`mode`]: 0.01, all over the height,
/// weighted by the layers' `exp(-4 pi |y - 1/4|)`.
const MODE_AT_START: f64 = 0.01;

/// Amplitude of the mode `sin(4 pi x)` of the vertical velocity at the layers [`McNally`, Lyra &
/// Passy 2012, eqs 10-13].
fn mode(gas: &Frame) -> f64 {
    let wave = 4.0 * std::f64::consts::PI;
    let (mut sine, mut cosine, mut weight) = (0.0, 0.0, 0.0);
    for (p, u) in gas.position.iter().zip(&gas.velocity) {
        let fade = if p[1] < 0.5 { p[1] - 0.25 } else { 0.75 - p[1] };
        let share = (-wave * fade.abs()).exp();
        sine += share * u[1] * (wave * p[0]).sin();
        cosine += share * u[1] * (wave * p[0]).cos();
        weight += share;
    }
    2.0 * (sine / weight).hypot(cosine / weight)
}

/// Mean of `|u - u_exact|` over the largest speed, for a swirl about the origin.
fn velocity_error(gas: &Frame, swirl: impl Fn(f64) -> f64) -> f64 {
    let largest = (0..1000)
        .map(|k| swirl(f64::from(k) * 0.005))
        .fold(0.0, f64::max);
    let sum: f64 = gas
        .position
        .iter()
        .zip(&gas.velocity)
        .map(|(p, u)| {
            let r = radius(p);
            let share = swirl(r) / r;
            (u[0] + share * p[1]).hypot(u[1] - share * p[0])
        })
        .sum();
    sum / gas.position.len() as f64 / largest
}

fn swirl_of(gas: &Frame, i: usize) -> f64 {
    let (p, u) = (&gas.position[i], &gas.velocity[i]);
    (p[0] * u[1] - p[1] * u[0]) / radius(p)
}

fn radius(position: &[f64; 3]) -> f64 {
    position[0].hypot(position[1])
}
