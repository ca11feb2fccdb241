//! What a manufactured solution must not be, by samples all over the domain and the run.

use aero_geometry::Vector;
use aero_solver::method::{Method, Time};
use aero_solver::problem::{AXES, Problem, Side, State, WallKind};

use super::Manufactured;
use crate::scene::SceneError;
use crate::scene::vector::side_key;

/// Places in the domain, and as many on each side, that are looked at.
const PLACES: usize = 256;

/// Times from the start to the end at each.
const TIMES: usize = 5;

/// What round-off leaves of terms that cancel, in parts of the largest.
const ROUND_OFF: f64 = 1e-10;

/// Refuses a `solution` that is no state of a gas, that its domain or its motion cannot have.
pub fn check<const D: usize>(
    solution: &Manufactured<D>,
    problem: &Problem<D>,
    end_time: f64,
) -> Result<(), SceneError> {
    check_problem(problem)?;
    let samples = Samples {
        solution,
        problem,
        end_time,
    };
    samples.are_states()?;
    if problem.method == Method::WithTheGas {
        samples.keep_mass()?;
    }
    samples.fit_sides()
}

fn fail<T>(place: impl Into<String>, message: impl Into<String>) -> Result<T, SceneError> {
    Err(SceneError::value(place, message.into()))
}

/// Refuses by name what has no sources, or no solution beside it.
fn check_problem<const D: usize>(problem: &Problem<D>) -> Result<(), SceneError> {
    if let Some(body) = problem.bodies.first() {
        return fail(
            "manufactured",
            format!("goes without bodies so far; leave out body `{}`", body.name),
        );
    }
    let settles = problem.method.fixed();
    if settles.is_some_and(|points| points.time == Time::Settle) {
        return fail(
            "manufactured",
            "is marched through time; set `scheme.time = \"accurate\"` and an `end_time`",
        );
    }
    for (axis, end, side, _) in problem.domain.each_side() {
        let holds = match side {
            Side::Periodic | Side::Symmetry => true,
            Side::Wall {
                kind,
                velocity,
                acceleration,
            } => kind == WallKind::Slip && velocity == 0.0 && acceleration == 0.0,
            _ => false,
        };
        if !holds {
            return fail(
                side_key(axis, end),
                "is no side of a manufactured solution; choose periodic, symmetry or a slip wall at rest",
            );
        }
    }
    Ok(())
}

/// Where and when a solution is looked at.
struct Samples<'a, const D: usize> {
    solution: &'a Manufactured<D>,
    problem: &'a Problem<D>,
    end_time: f64,
}

impl<const D: usize> Samples<'_, D> {
    /// Places that fill the box evenly, by additive recurrence [Roberts 2018, the generalised golden ratio], with the times.
    fn all(&self) -> impl Iterator<Item = (Vector<D>, f64)> {
        // Root of x^(D + 1) = x + 1.
        let root = (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(1.0 / (D as f64 + 1.0)));
        let bounds = &self.problem.domain.bounds;
        let (min, size) = (bounds.min, bounds.size());
        let times = (0..TIMES).map(|n| self.end_time * n as f64 / (TIMES - 1) as f64);
        let places = (0..PLACES).map(move |n| {
            Vector::from_fn(|k, _| {
                let share = (0.5 + n as f64 * root.powi(-(k as i32 + 1))).fract();
                min[k] + share * size[k]
            })
        });
        places.flat_map(move |place| times.clone().map(move |time| (place, time)))
    }

    /// Density and pressure above zero, and all that is added finite.
    fn are_states(&self) -> Result<(), SceneError> {
        for (position, time) in self.all() {
            let State {
                density,
                velocity,
                pressure,
            } = self.solution.state(&position, time);
            let of = |value: f64, key: &str| {
                fail(
                    format!("manufactured.{key}"),
                    format!("is {value} at {}", there(&position, time)),
                )
            };
            for (value, key) in [(density, "density"), (pressure, "pressure")] {
                if !(value > 0.0 && value.is_finite()) {
                    return of(value, key);
                }
            }
            if let Some(value) = velocity.iter().find(|value| !value.is_finite()) {
                return of(*value, "velocity");
            }
            let added = self.solution.terms(&position, time).added();
            let mut values = added.acceleration.iter().copied();
            if !values.all(f64::is_finite) || !(added.heating + added.density).is_finite() {
                return fail(
                    "manufactured",
                    format!("has no derivatives at {}", there(&position, time)),
                );
            }
        }
        Ok(())
    }

    /// Particles keep their mass: the solution must too.
    fn keep_mass(&self) -> Result<(), SceneError> {
        let (mut most, mut largest, mut worst) = (0.0, 0.0_f64, None);
        for (position, time) in self.all() {
            let terms = self.solution.terms(&position, time);
            let share = terms.density;
            let left = (share.unsteady + share.carried + share.pressed).abs();
            let sizes = share.unsteady.abs() + share.carried.abs() + terms.dilation;
            largest = largest.max(sizes);
            if left > most {
                most = left;
                worst = Some((position, time));
            }
        }
        match worst {
            Some((position, time)) if most > ROUND_OFF * largest => fail(
                "manufactured",
                format!(
                    "makes mass: the rate of density and the divergence of density times velocity leave {most:.3e} at {}, where their terms reach \
                     {largest:.3e}; particles keep their mass: choose density = rho0 + div grad phi and density * velocity = m0 + curl psi - grad of \
                     phi's rate, or `scheme.motion = \"fixed\"`",
                    there(&position, time)
                ),
            ),
            _ => Ok(()),
        }
    }

    /// Joined sides see the same state, and nothing goes through walls.
    fn fit_sides(&self) -> Result<(), SceneError> {
        let domain = &self.problem.domain;
        let fastest = self.all().map(|(position, time)| {
            let State {
                density,
                velocity,
                pressure,
            } = self.solution.state(&position, time);
            let sound = self.problem.gas.sound_speed_at(density, pressure);
            sound + velocity.norm()
        });
        let fastest = fastest.fold(0.0, f64::max);
        for (axis, end, side, face) in domain.each_side() {
            let place = side_key(axis, end);
            for (mut position, time) in self.all() {
                position[axis] = face;
                let state = self.solution.state(&position, time);
                if side.is_periodic() {
                    position[axis] = domain.face(axis, 1 - end);
                    let other = self.solution.state(&position, time);
                    let apart = (state.velocity - other.velocity).norm() / fastest
                        + (state.density / other.density - 1.0).abs()
                        + (state.pressure / other.pressure - 1.0).abs();
                    if apart > ROUND_OFF {
                        return fail(
                            place,
                            format!(
                                "is periodic, but the manufactured solution is another one beyond at {}; give it this period, or choose another domain",
                                there(&position, time)
                            ),
                        );
                    }
                    continue;
                }
                let speed = state.velocity[axis];
                if speed.abs() > ROUND_OFF * fastest {
                    return fail(
                        place,
                        format!(
                            "is closed, but the manufactured solution goes through it at a speed of {speed:.3e} at {}; let its velocity along {} vanish there",
                            there(&position, time),
                            AXES[axis]
                        ),
                    );
                }
                if side == Side::Symmetry && !self.is_even(&position, axis, time) {
                    return fail(
                        place,
                        format!(
                            "is a mirror, but the manufactured solution is not its own image there, at {}; let what is not the velocity along {} have \
                             no slope across it, or choose `wall`",
                            there(&position, time),
                            AXES[axis]
                        ),
                    );
                }
            }
        }
        Ok(())
    }

    /// True where the solution is the same in a mirror across `axis` at `position`, half a spacing on either side.
    fn is_even(&self, position: &Vector<D>, axis: usize, time: f64) -> bool {
        let [a, b] = [-0.5, 0.5].map(|share| {
            let mut beside = *position;
            beside[axis] += share * self.problem.resolution.lattice();
            self.solution.state(&beside, time)
        });
        let sound = self.problem.gas.sound_speed_at(a.density, a.pressure);
        let mut mirrored = b.velocity;
        mirrored[axis] = -mirrored[axis];
        let apart = (a.velocity - mirrored).norm() / (sound + a.velocity.norm())
            + (a.density / b.density - 1.0).abs()
            + (a.pressure / b.pressure - 1.0).abs();
        apart <= ROUND_OFF
    }
}

/// A place and time in words.
fn there<const D: usize>(position: &Vector<D>, time: f64) -> String {
    let place: Vec<String> = position.iter().map(|x| format!("{x:.4}")).collect();
    format!("({}) and t = {time:.4}", place.join(", "))
}
