//! The gas of a run between its particles or points.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_solver::frame::{Frame, Kind};
use aero_solver::problem::{Domain, Problem, Side};

use super::cloud::{Cloud, Point, reach};
use super::fit::Found;
use super::solids::Solids;

/// Density, pressure, velocity, share of the second gas.
const VALUES: usize = 6;

/// The gas of one frame.
#[derive(Debug)]
pub struct Gas<'a, const D: usize> {
    cloud: Cloud<'a, D, VALUES>,
    /// Axis, end and face of sides that mirror it.
    mirrors: Vec<(usize, usize, f64)>,
    stream: State,
}

/// What there is at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The gas; none where no gas is near.
    pub state: Option<State>,
    /// The place lies outside of bodies.
    pub is_gas: bool,
    /// How far around the place values are as good as on a straight line, and no body is.
    pub clear: f64,
}

/// The gas at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Density.
    pub density: f64,
    /// Pressure.
    pub pressure: f64,
    /// Velocity; missing axes zero.
    pub velocity: [f64; 3],
    /// How the density changes along each axis.
    pub density_gradient: [f64; 3],
    /// Share of the second gas, where there are two.
    pub second: f64,
}

impl<'a, const D: usize> Gas<'a, D> {
    /// The gas of `frame` between `solids`, which are the bodies of `problem`. Beyond sides that mirror the flow it is the image of
    /// what lies before them.
    pub fn new(frame: &Frame, problem: &Problem<D>, solids: &'a Solids<'a, D>) -> Self {
        let rows = (0..frame.kind.len()).filter(|&n| frame.kind[n] == Kind::Fluid as u8);
        let point = |n: usize| {
            let [u, v, w] = frame.velocity[n];
            let spacing = frame.extra.spacing.get(n);
            let second = frame
                .extra
                .second
                .get(n)
                .map_or(0.0, |&second| f64::from(second));
            Point {
                position: Vector::from_fn(|k, _| frame.position[n][k]),
                spacing: spacing.map_or(frame.smoothing_length[n] / SMOOTHING_RATIO, |s| *s),
                values: [frame.density[n], frame.pressure[n], u, v, w, second],
            }
        };
        let mut points: Vec<_> = rows.map(point).collect();
        add_images(&mut points, &problem.domain);
        let sides = problem.domain.each_side();
        let mirrors = sides.filter(|(_, _, side, _)| side.is_mirror());
        Self {
            cloud: Cloud::of(solids, points),
            mirrors: mirrors
                .map(|(axis, end, _, face)| (axis, end, face))
                .collect(),
            stream: State {
                density: problem.free_stream.density,
                pressure: problem.free_stream.pressure,
                velocity: std::array::from_fn(|k| {
                    problem.free_stream.velocity.get(k).copied().unwrap_or(0.0)
                }),
                density_gradient: [0.0; 3],
                second: 0.0,
            },
        }
    }

    /// Carries the gas so far on into bodies, however fine it is.
    #[must_use]
    pub fn carried_on(self, carried: f64) -> Self {
        Self {
            cloud: self.cloud.carried_on(carried),
            ..self
        }
    }

    /// The undisturbed gas.
    pub fn stream(&self) -> State {
        self.stream
    }

    /// What there is at a place.
    pub fn at(&self, place: &Vector<D>) -> Spot {
        let mut place = *place;
        let mut signs = [1.0; 3];
        for &(axis, end, face) in &self.mirrors {
            if (place[axis] < face) == (end == 0) && place[axis] != face {
                place[axis] = 2.0 * face - place[axis];
                signs[axis] = -signs[axis];
            }
        }
        let near = self.cloud.at(&place);
        let state = near.found.map(|found| {
            let mut state = state_of(&found);
            for (k, sign) in signs.into_iter().enumerate() {
                state.velocity[k] *= sign;
                state.density_gradient[k] *= sign;
            }
            state
        });
        Spot {
            state,
            is_gas: !near.is_solid,
            clear: near.clear,
        }
    }
}

fn state_of<const D: usize>(found: &Found<D, VALUES>) -> State {
    let [density, pressure, u, v, w, second] = found.values;
    // What is carried on beyond all points may end below zero.
    let positive = |value: f64, n: usize| if value > 0.0 { value } else { found.means[n] };
    let slope = &found.slopes[0];
    State {
        density: positive(density, 0),
        pressure: positive(pressure, 1),
        velocity: [u, v, w],
        density_gradient: std::array::from_fn(|k| if k < D { slope[k] } else { 0.0 }),
        second: second.clamp(0.0, 1.0),
    }
}

/// Adds what lies beyond mirrors and joined sides, as far as it counts within.
fn add_images<const D: usize>(points: &mut Vec<Point<D, VALUES>>, domain: &Domain<D>) {
    for axis in 0..D {
        let sides = domain.each_side().filter(|(along, ..)| *along == axis);
        let length = domain.bounds.size()[axis];
        let mut images = Vec::new();
        for (_, end, side, face) in sides {
            let is_near = |point: &&Point<D, VALUES>| {
                (point.position[axis] - face).abs() <= 2.0 * reach(point.spacing)
            };
            let image = |point: &Point<D, VALUES>| {
                let mut image = *point;
                if side == Side::Periodic {
                    image.position[axis] += if end == 0 { length } else { -length };
                } else {
                    image.position[axis] = 2.0 * face - image.position[axis];
                    image.values[2 + axis] = -image.values[2 + axis];
                }
                image
            };
            if side.is_mirror() || side.is_periodic() {
                images.extend(points.iter().filter(is_near).map(image));
            }
        }
        points.extend(images);
    }
}
