//! Moves the fluid by its rates.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use crate::books::{Books, Extremes};
use crate::neighbourhood::calm::Calm;
use crate::neighbours::GROWTH;
use crate::particles::{Columns, Particle, Particles, Rates};
use crate::problem::Problem;
use crate::scheme::{Density, Energy, Integrator, Operators, Scheme, Volume};
use crate::time_step::Bounds;

/// Particles that a task moves at once.
const BLOCK: usize = 1024;

/// A particle whose state makes no sense, and its place.
#[derive(Clone, Copy, Debug)]
pub struct Senseless<const D: usize> {
    /// Its place among the fluid, which keeps its order within a step.
    pub place: usize,
    /// The state.
    pub particle: Particle<D>,
}

/// Predicts the state half a step ahead, keeps the fluid as it was. The predictor takes its rates now; the
/// leapfrog drifts at the velocity now, and takes the rates of the last evaluation for all else.
pub fn predict<const D: usize>(
    problem: &Problem<D>,
    ahead: f64,
    fluid: &mut Particles<D>,
    books: &mut Books,
) -> Result<(), Senseless<D>> {
    fluid.save();
    let (gases, scheme) = (problem.gases(), &problem.scheme);
    let Scheme {
        integrator,
        density,
        operators: Operators { volume, .. },
        ..
    } = *scheme;
    advance(fluid, books, |particle, saved, rates| {
        *particle = *saved;
        match integrator {
            Integrator::Leapfrog => {
                particle.position += saved.velocity * ahead;
                particle.velocity += saved.by_pressure.acceleration * ahead;
                particle.energy += saved.by_pressure.heating * ahead;
                if density == Density::Continuity {
                    // Compression heats by p / rho^2 per density.
                    let gas = gases.of(saved.is_second);
                    let heat = gas.pressure_over_density(saved.density, saved.energy);
                    particle.density += saved.by_pressure.heating * saved.density / heat * ahead;
                }
            }
            Integrator::PredictorCorrector => {
                move_on(particle, saved, rates, ahead);
                particle.energy = saved.energy + rates.energy * ahead;
                continue_density((particle, saved), rates, ahead, volume);
            }
        }
        Bounds::default()
    })?;
    Ok(())
}

/// Corrects the state: the fluid at the start of the step plus `step` times the rates of its middle. The leapfrog
/// keeps of these what its next step goes by, and returns how long that may be.
pub fn correct<const D: usize>(
    problem: &Problem<D>,
    step: f64,
    calm: Option<&Calm<D>>,
    fluid: &mut Particles<D>,
    books: &mut Books,
) -> Result<Option<f64>, Senseless<D>> {
    let (gases, scheme) = (problem.gases(), &problem.scheme);
    let Scheme {
        integrator,
        step: bound,
        density,
        operators: Operators { volume, .. },
        energy,
        ..
    } = *scheme;
    let bounds = advance(fluid, books, |particle, saved, rates| {
        let evaluated = particle.velocity;
        match integrator {
            Integrator::Leapfrog => kick_and_drift(particle, saved, rates, step),
            Integrator::PredictorCorrector => move_on(particle, saved, rates, step),
        }
        let heating = match energy {
            Energy::ByRate => rates.energy,
            Energy::Settled => settled(particle, saved, rates, &evaluated),
        };
        particle.energy = saved.energy + heating * step;
        match density {
            Density::Continuity => continue_density((particle, saved), rates, step, volume),
            // That of the middle was read off the particles there.
            Density::Summation => particle.density += rates.density * (0.5 * step),
        }
        let mut bounds = Bounds::default();
        if integrator == Integrator::Leapfrog {
            particle.by_pressure = rates.by_pressure;
            bounds = bound.bounds(&gases, particle, rates);
        }
        if let Some(calm) = calm {
            particle.is_calm = calm.holds(particle, rates);
        }
        bounds
    })?;
    Ok((integrator == Integrator::Leapfrog).then(|| bound.step(bounds, &gases.first)))
}

/// Moves each particle of the fluid by its state at the start of the step and its rates; returns the tightest of
/// the bounds that `stage` finds.
fn advance<const D: usize>(
    fluid: &mut Particles<D>,
    books: &mut Books,
    stage: impl Fn(&mut Particle<D>, &Particle<D>, &Rates<D>) -> Bounds + Sync,
) -> Result<Bounds, Senseless<D>> {
    let Columns {
        state,
        saved,
        rates,
        ..
    } = fluid.columns();
    let (extremes, bounds) = state
        .par_chunks_mut(BLOCK)
        .zip(saved.par_chunks(BLOCK))
        .zip(rates.par_chunks(BLOCK))
        .map(|((fluid, saved), rates)| {
            let (mut extremes, mut bounds) = Default::default();
            for ((particle, saved), rates) in fluid.iter_mut().zip(saved).zip(rates) {
                bounds = Bounds::tighter(bounds, stage(particle, saved, rates));
                Extremes::meet(&mut extremes, particle);
            }
            (extremes, bounds)
        })
        .reduce(Default::default, |(a, b), (c, d)| {
            (a.merge(c), b.tighter(d))
        });
    if !extremes.make_sense()
        && let Some(place) = state.iter().position(|particle| !particle.makes_sense())
    {
        let particle = state[place];
        return Err(Senseless { place, particle });
    }
    books.extremes = books.extremes.merge(extremes);
    Ok(bounds)
}

/// Keeps of an evaluation before any step what the step goes by.
pub fn remember_rates<const D: usize>(fluid: &mut Particles<D>) {
    let Columns { state, rates, .. } = fluid.columns();
    state
        .par_iter_mut()
        .zip(rates)
        .for_each(|(particle, rates)| particle.by_pressure = rates.by_pressure);
}

/// Moves `particle` from where it was at the start of the step by `ahead` times its rates.
fn move_on<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    ahead: f64,
) {
    // The velocity that moves the particle is the one at which the rates were evaluated.
    particle.position = saved.position + (particle.velocity + rates.shift) * ahead;
    let acceleration = rates.acceleration + rates.wall_acceleration;
    particle.velocity = saved.velocity + acceleration * ahead;
}

/// The leapfrog's kick at the middle of the step, and its drift to the end.
fn kick_and_drift<const D: usize>(
    particle: &mut Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    step: f64,
) {
    let acceleration = rates.acceleration + rates.wall_acceleration;
    particle.velocity = saved.velocity + acceleration * step;
    let mean = (saved.velocity + particle.velocity) * 0.5;
    particle.position = saved.position + (mean + rates.shift) * step;
}

/// Rate of energy that settles the total.
///
/// Forces are paid for at the velocity `v` that they were `evaluated` at; the kinetic energy
/// changes by their work at the mean of the velocities before and after. The difference
/// is heat: `-dt a.((u0 + u1) / 2 - v)`, the same in every frame
/// of reference, which settles the total energy to round-off.
fn settled<const D: usize>(
    particle: &Particle<D>,
    saved: &Particle<D>,
    rates: &Rates<D>,
    evaluated: &Vector<D>,
) -> f64 {
    let acceleration = rates.acceleration + rates.wall_acceleration;
    let mean = (saved.velocity + particle.velocity) * 0.5;
    rates.energy - acceleration.dot(&(mean - evaluated))
}

/// Density and smoothing length by the equation of continuity [Villodi & Ramachandran 2024, eqs 10 and 17], at the stage whose
/// density gave the rate. Where volumes are none of the density's, lengths stay.
fn continue_density<const D: usize>(
    (particle, saved): (&mut Particle<D>, &Particle<D>),
    rates: &Rates<D>,
    ahead: f64,
    volume: Volume,
) {
    if volume == Volume::OfDensity {
        let growth = -rates.density / (D as f64 * particle.density);
        particle.smoothing_length = saved.smoothing_length
            + (particle.smoothing_length * growth * ahead)
                .min((GROWTH - 1.0) * saved.smoothing_length);
    }
    particle.density = saved.density + rates.density * ahead;
}
