//! Force coefficients as engineers use them: by gauge pressure unless absolute pressure is asked for, along and across the stream,
//! and along and across the body where the scene states an incidence.

use aero_geometry::Vector;

use crate::case::{Pressure, RunPlan};
use crate::output::BodyCoefficients;
use aero_solver::Flow;
use aero_solver::frame::Load;

/// What turns the loads of a run into coefficients.
#[derive(Clone, Debug)]
pub(super) struct Coefficients {
    pressure: Pressure,
    /// Along the stream and across it; none for a gas at rest.
    axes: Option<[[f64; 3]; 2]>,
    /// The scene states an incidence, and so has axes of the body.
    has_incidence: bool,
    bodies: Vec<Scales>,
}

/// Of one body.
#[derive(Clone, Copy, Debug)]
struct Scales {
    /// What the free stream's pressure presses it with.
    ambient: Load,
    /// Dynamic pressure times area.
    force: f64,
    length: f64,
}

impl Coefficients {
    /// Those of a run as `plan` has it.
    pub(super) fn new<const D: usize>(plan: &RunPlan<D>, simulation: &Flow<D>) -> Self {
        let problem = simulation.problem();
        let stream = &problem.free_stream;
        let dynamic = 0.5 * stream.density * stream.velocity.norm_squared();
        let uniform = simulation.uniform_loads();
        let scales = problem.bodies.iter().zip(uniform);
        let bodies = scales.map(|(body, uniform)| Scales {
            ambient: Load {
                force: uniform.force.map(|f| f * stream.pressure),
                moment: uniform.moment.map(|m| m * stream.pressure),
                ..Load::default()
            },
            force: dynamic * body.reference_area,
            length: body.reference_length,
        });
        Self {
            pressure: plan.output.coefficients,
            axes: stream_axes(&stream.velocity),
            has_incidence: plan.incidence.is_some(),
            bodies: bodies.collect(),
        }
    }

    /// The pressure that they are made of.
    pub(super) fn pressure(&self) -> Pressure {
        self.pressure
    }

    /// Of a body whose load by absolute pressure is `load`: the load by gauge pressure.
    pub(super) fn gauge(&self, body: usize, load: &Load) -> Load {
        let ambient = &self.bodies[body].ambient;
        let less = |a: &[f64; 3], b: &[f64; 3]| std::array::from_fn(|k| a[k] - b[k]);
        Load {
            force: less(&load.force, &ambient.force),
            moment: less(&load.moment, &ambient.moment),
            ..*load
        }
    }

    /// The coefficients of a body whose load by absolute pressure is `load`; none in a gas at rest.
    pub(super) fn of(&self, body: usize, load: &Load) -> Option<BodyCoefficients> {
        let [drag, lift] = self.axes?;
        let Scales { force, length, .. } = self.bodies[body];
        if force <= 0.0 {
            return None;
        }
        let load = match self.pressure {
            Pressure::Gauge => self.gauge(body, load),
            Pressure::Absolute => *load,
        };
        let along = |axis: &[f64; 3], vector: &[f64; 3]| -> f64 {
            axis.iter().zip(vector).map(|(a, v)| a * v).sum()
        };
        // The nose lies upstream: it rises by a turn against drag x lift.
        let nose_up: [f64; 3] = std::array::from_fn(|k| {
            let [i, j] = [(k + 1) % 3, (k + 2) % 3];
            drag[j] * lift[i] - drag[i] * lift[j]
        });
        Some(BodyCoefficients {
            cd: along(&drag, &load.force) / force,
            cl: along(&lift, &load.force) / force,
            cm: along(&nose_up, &load.moment) / (force * length),
            ca: self.has_incidence.then(|| load.force[0] / force),
            cn: self.has_incidence.then(|| load.force[1] / force),
        })
    }
}

/// Unit vectors along the stream and across it towards `+y` (towards `+z` where the stream itself
/// goes along `y` in space); none for a gas at rest.
fn stream_axes<const D: usize>(velocity: &Vector<D>) -> Option<[[f64; 3]; 2]> {
    /// Nearly along an axis, what is left of it across is round-off.
    const ALONG: f64 = 1e-6;
    let drag = velocity.try_normalize(0.0)?;
    let drag: [f64; 3] = std::array::from_fn(|k| if k < D { drag[k] } else { 0.0 });
    if D < 3 {
        return Some([drag, [-drag[1], drag[0], 0.0]]);
    }
    let across = |up: usize| {
        let mut lift = drag.map(|d| -drag[up] * d);
        lift[up] += 1.0;
        let length = lift.iter().map(|l| l * l).sum::<f64>().sqrt();
        (length > ALONG).then(|| lift.map(|l| l / length))
    };
    let lift = across(1).or_else(|| across(2))?;
    Some([drag, lift])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lift_points_up_and_across_the_stream() {
        let [drag, lift] = stream_axes(&Vector::<3>::new(2.0, 0.0, 0.0)).unwrap();
        assert_eq!(drag, [1.0, 0.0, 0.0]);
        assert_eq!(lift, [0.0, 1.0, 0.0]);
        let [_, lift] = stream_axes(&Vector::<3>::new(0.0, 1.0, 0.0)).unwrap();
        assert_eq!(lift, [0.0, 0.0, 1.0]);
        let [_, lift] = stream_axes(&Vector::<2>::new(0.0, 1.0)).unwrap();
        assert_eq!(lift, [-1.0, 0.0, 0.0]);
        assert!(stream_axes(&Vector::<2>::zeros()).is_none());
    }

    fn of_unit_body(pressure: Pressure, ambient: f64) -> Coefficients {
        Coefficients {
            pressure,
            axes: stream_axes(&Vector::<2>::new(1.0, 0.0)),
            has_incidence: true,
            bodies: vec![Scales {
                ambient: Load {
                    force: [ambient, 0.0, 0.0],
                    ..Load::default()
                },
                force: 2.0,
                length: 4.0,
            }],
        }
    }

    #[test]
    fn a_push_up_ahead_of_the_centre_raises_the_nose() {
        // Lift 1 at 3 upstream: r x F = (-3, 0) x (0, 1) = -3.
        let load = Load {
            force: [0.0, 1.0, 0.0],
            moment: [0.0, 0.0, -3.0],
            ..Load::default()
        };
        let found = of_unit_body(Pressure::Gauge, 0.0).of(0, &load).unwrap();
        assert_eq!((found.cl, found.cm, found.cn), (0.5, 3.0 / 8.0, Some(0.5)));
    }

    #[test]
    fn what_the_undisturbed_gas_presses_with_counts_where_absolute_pressure_is_asked_for() {
        let load = Load {
            force: [5.0, 0.0, 0.0],
            ..Load::default()
        };
        let cd = |pressure| of_unit_body(pressure, 3.0).of(0, &load).unwrap().cd;
        assert_eq!((cd(Pressure::Gauge), cd(Pressure::Absolute)), (1.0, 2.5));
    }
}
