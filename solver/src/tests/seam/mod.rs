//! The one place where the comparisons with the scalar reference touch the solver: problems, states in and
//! out, passes. Everything else in [`super::reference`] and its tests is written in its plain [`Point`]s.

pub mod problems;

use aero_geometry::Vector;
use nalgebra::Vector3;

use super::reference::{GAMMA, Heat, Point, Rate, SECOND, Wall};
use crate::Simulation;
use crate::evaluation::{Moment, evaluate, read_densities};
use crate::fill::fill_ghosts;
use crate::frame::{Load, Totals};
use crate::iterative_shifting::move_apart;
use crate::pairs::renormalisation::{Renormalisation, even_renormalisation};
use crate::particles::Particle;
use crate::problem::{Problem, Side, WallHeat, WallKind};
use crate::rings::Rings;
use crate::scheme::Precision;
use crate::step::prepare;
use crate::vectors::{Arch, avx2};
use crate::walls::loads::received;
use crate::walls::{Ghost, wall_sides};

pub use problems::{DEFAULT, PUBLISHED, Setup, body_on_the_lattice, maps, room, turn};

/// The narrowest instruction set of this processor, and the widest that unit tests are compiled for.
pub fn instructions() -> [pulp::Arch; 2] {
    [pulp::Arch::Scalar, avx2().unwrap_or_default()]
}

/// A simulation whose passes are called one by one.
pub struct Solver<const D: usize>(pub Simulation<D>);

impl<const D: usize> Solver<D> {
    /// Sets up `problem`, to be computed in `f64` with these instructions.
    pub fn new(problem: Problem<D>, instructions: pulp::Arch) -> Self {
        let mut simulation = Simulation::new(problem).expect("the problem is sound");
        simulation.around.arch = Arch::new(instructions, Precision::Double);
        Self(simulation)
    }

    /// The gas in the order of the solver's results.
    pub fn gas(&self) -> Vec<Point<D>> {
        let simulation = &self.0;
        let point = |particle| point_of(simulation, particle);
        simulation.fluid.iter().map(point).collect()
    }

    /// The gas in the buffers of open sides.
    pub fn buffers(&self) -> Vec<Point<D>> {
        let simulation = &self.0;
        let open = simulation.buffers.particles().iter();
        open.map(|open| Point {
            renormalisation: open.renormalisation,
            density_gradient: open.gradient,
            ..point_of(simulation, &open.particle)
        })
        .collect()
    }

    /// The ghosts in the order of the solver's, views left out.
    pub fn ghosts(&self) -> Vec<Wall<D>> {
        let simulation = &self.0;
        let bodies = &simulation.problem.bodies;
        let kinds = self.kinds();
        let wall = |ghost: &Ghost<D>| {
            let body = bodies.get(ghost.body as usize);
            Wall {
                point: Point {
                    position: ghost.position,
                    velocity: ghost.shown.velocity,
                    density: ghost.shown.density,
                    energy: ghost.shown.energy,
                    pressure: ghost.shown.pressure,
                    h: ghost.shown.smoothing_length,
                    mass: ghost.shown.density * ghost.volume,
                    volume: ghost.volume,
                    strain: ghost.shown.strain,
                    energy_slope: Vector::zeros(),
                    smoothness: 1.0,
                    renormalisation: even_renormalisation(),
                    density_gradient: ghost.shown.density_gradient,
                    shift: Vector::zeros(),
                    second: ghost.shown.second,
                },
                normal: ghost.normal,
                depth: ghost.depth,
                surface_velocity: ghost.wall.velocity,
                surface_acceleration: ghost.wall.acceleration,
                surface_pressure: ghost.shown.wall_pressure,
                spin: body.map_or(Vector3::zeros(), |body| {
                    body.motion.turning.rate(simulation.time())
                }),
                curvature: ghost.wall.curvature,
                slips: !kinds[ghost.body as usize].sticks(),
                slide: ghost.wall.slide,
                heat: heat_of(kinds[ghost.body as usize]),
                has_mirror: ghost.has_mirror,
                body: ghost.body as usize,
            }
        };
        simulation.walls.own().iter().map(wall).collect()
    }

    /// What each body and wall side is to the gas.
    fn kinds(&self) -> Vec<WallKind> {
        let problem = &self.0.problem;
        let bodies = problem.bodies.iter().map(|body| body.wall);
        let sides = wall_sides(&problem.domain).into_iter();
        let sides = sides.map(|(axis, end)| match problem.domain.sides[axis][end] {
            Side::Wall { kind, .. } => kind,
            _ => unreachable!("only wall sides are listed"),
        });
        bodies.chain(sides).collect()
    }

    /// Gives the gas new states: number by number what `change` makes of the old one. Rings remember the plane mass that they
    /// began with.
    pub fn set_gas(&mut self, mut change: impl FnMut(usize, &mut Point<D>)) {
        for (number, mut point) in self.gas().into_iter().enumerate() {
            change(number, &mut point);
            let rings = Rings::new(&self.0.problem);
            let circumference = rings.circumference(&point.position);
            let particle = &mut self.0.fluid[number];
            particle.position = point.position;
            particle.velocity = point.velocity;
            particle.density = point.density;
            particle.energy = point.energy;
            particle.smoothing_length = point.h;
            particle.mass = point.mass * circumference;
            if !rings.are_real() {
                particle.first_plane_mass = point.mass;
            }
            particle.spared.strain = point.strain;
            particle.spared.energy_slope = point.energy_slope;
            particle.spared.smoothness = point.smoothness;
        }
    }

    /// Sorts all particles and lists their neighbours.
    pub fn list(&mut self) {
        let Simulation {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = &mut self.0;
        prepare(problem, (clock.time, 0.0), fluid, buffers, walls, around);
    }

    /// Lets the density vary across the layers at all walls by this slope.
    pub fn set_slope(&mut self, slope: &Vector<D>) {
        for ghost in &mut self.0.walls.ghosts {
            ghost.shown.density_gradient = *slope;
        }
    }

    /// Reads the density off the particles.
    pub fn read_densities(&mut self) {
        let Simulation {
            problem,
            fluid,
            walls,
            around,
            ..
        } = &mut self.0;
        fill_ghosts(walls, around);
        read_densities(problem, fluid, around);
    }

    /// Extrapolates, renormalises, shifts and sums the rates.
    pub fn evaluate(&mut self) {
        let Simulation {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = &mut self.0;
        let moment = Moment {
            start: clock.time,
            ahead: 0.0,
        };
        evaluate(problem, moment, fluid, buffers, walls, around);
    }

    /// Moves the particles apart once; false where they stand evenly.
    pub fn move_apart(&mut self) -> bool {
        let Simulation {
            problem,
            clock,
            fluid,
            buffers,
            walls,
            around,
            ..
        } = &mut self.0;
        move_apart(problem, clock.time, fluid, buffers, walls, around)
    }

    /// Part of the ghosts that have mirrors.
    pub fn mirrored(&self) -> f64 {
        let ghosts = self.0.walls.own();
        let mirrored = ghosts.iter().filter(|ghost| ghost.has_mirror);
        mirrored.count() as f64 / ghosts.len() as f64
    }

    /// The renormalisation matrices, density gradients, and gradients of concentration by all and by walls.
    pub fn renormalisations(&self) -> Vec<Renormalisation<D>> {
        self.0.fluid.renormalisations().to_vec()
    }

    /// The rates of the last evaluation.
    pub fn rates(&self) -> Vec<Rate<D>> {
        let rates = self.0.fluid.rates().iter();
        rates
            .map(|rates| Rate {
                acceleration: rates.acceleration + rates.wall_acceleration,
                wall_acceleration: rates.wall_acceleration,
                density: rates.density,
                energy: rates.energy,
                acceleration_by_pressure: rates.by_pressure.acceleration,
                heating_by_pressure: rates.by_pressure.heating,
                velocity_gradient: rates.velocity_gradient,
                energy_gradient: rates.energy_gradient,
                shift: rates.shift,
            })
            .collect()
    }

    /// What the gas does to each body and wall side.
    pub fn loads(&self) -> Vec<Load> {
        self.0.loads()
    }

    /// What walls and sides give the fluid in a step of this length.
    pub fn received(&self, step: f64) -> Totals {
        let simulation = &self.0;
        received(
            &simulation.problem,
            step,
            &simulation.fluid,
            &simulation.walls,
            &simulation.around,
        )
    }

    /// The stable step at the rates of the last evaluation.
    pub fn stable_step(&self) -> f64 {
        let Simulation { problem, fluid, .. } = &self.0;
        let bound = problem.scheme.step;
        bound.time_step(&problem.gases(), fluid, fluid.rates())
    }

    /// Takes one step; returns its length.
    pub fn step(&mut self) -> f64 {
        self.0.step(f64::INFINITY).expect("the flow is tame")
    }

    /// The number that a particle keeps for life, in the order of [`Self::gas`].
    pub fn ids(&self) -> Vec<u64> {
        self.0.fluid.iter().map(|particle| particle.id).collect()
    }
}

/// What heat does at a wall, in energies of gas whose gas constant is one.
fn heat_of(kind: WallKind) -> Heat {
    let WallKind::NoSlip(wall) = kind else {
        return Heat::Kept;
    };
    match wall.heat {
        WallHeat::Adiabatic => Heat::Kept,
        WallHeat::Temperature(temperature) => Heat::Passes {
            energy: temperature / (GAMMA - 1.0),
        },
        WallHeat::Flux(flux) => Heat::Flows(flux),
    }
}

fn point_of<const D: usize>(simulation: &Simulation<D>, particle: &Particle<D>) -> Point<D> {
    let mass = Rings::new(&simulation.problem).plane_mass(particle);
    let (gamma, second) = if particle.is_second {
        (SECOND, 1.0)
    } else {
        (GAMMA, 0.0)
    };
    Point {
        position: particle.position,
        velocity: particle.velocity,
        density: particle.density,
        energy: particle.energy,
        pressure: (gamma - 1.0) * particle.density * particle.energy,
        h: particle.smoothing_length,
        mass,
        volume: mass / particle.density,
        strain: particle.spared.strain,
        energy_slope: particle.spared.energy_slope,
        smoothness: particle.spared.smoothness,
        renormalisation: nalgebra::SMatrix::identity(),
        density_gradient: Vector::zeros(),
        shift: Vector::zeros(),
        second,
    }
}
