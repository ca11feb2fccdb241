//! One evaluation by the solver beside the same by the reference, from the same random states.

use super::reference::step::{Asked, World};
use super::reference::{Matrix, Point};
use super::seam::{Setup, Solver, instructions, maps};
use super::*;
use crate::frame::Load;

/// Relative to the largest value of the cloud.
const ALLOWED: f64 = 1e-12;

/// Numbers between -1 and 1 (`xorshift64*`, Vigna 2016).
pub struct Random(u64);

impl Random {
    pub fn new() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }

    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11;
        bits as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector<const D: usize>(&mut self) -> Vector<D> {
        Vector::from_fn(|_, _| self.next())
    }
}

/// Gives all gas random states; strains and slopes about as large as the differences between neighbours.
pub fn randomise<const D: usize>(solver: &mut Solver<D>) {
    let mut random = Random::new();
    solver.set_gas(|_, point| {
        point.velocity = random.vector();
        point.density = 1.5 + 0.5 * random.next();
        point.energy = 2.5 + random.next();
        point.h = 0.145 + 0.025 * random.next();
        point.mass = point.density * 0.1_f64.powi(D as i32) * (1.0 + 0.2 * random.next());
        let strain = Matrix::<D>::from_fn(|_, _| 8.0 * random.next());
        point.strain = (strain + strain.transpose()) * 0.5;
        point.energy_slope = random.vector::<D>() * 8.0;
        point.smoothness = 0.5 + 0.5 * random.next();
    });
    solver.set_slope(&(random.vector() * 4.0));
}

/// All that is in the solver now.
pub fn world<const D: usize>(solver: &Solver<D>, problem: &Problem<D>) -> World<D> {
    World {
        gas: solver.gas(),
        buffers: solver.buffers(),
        walls: solver.ghosts(),
        maps: maps(problem),
    }
}

/// Asserts that both agree, relative to the largest of all.
pub fn agree<const N: usize>(
    what: &str,
    lanes: impl Iterator<Item = [f64; N]>,
    reference: impl Iterator<Item = [f64; N]>,
) {
    let (lanes, reference): (Vec<_>, Vec<_>) = (lanes.collect(), reference.collect());
    assert_eq!(lanes.len(), reference.len(), "{what}");
    let largest = |all: &[[f64; N]]| all.iter().flatten().fold(0.0, |a: f64, b| a.max(b.abs()));
    let scale = largest(&reference);
    for (number, (lane, expected)) in lanes.iter().zip(&reference).enumerate() {
        for (a, b) in lane.iter().zip(expected) {
            assert!(
                (a - b).abs() <= ALLOWED * scale,
                "{what} of {number} is {lane:?}, not {expected:?}; the largest is {scale}"
            );
        }
    }
}

pub fn array<const D: usize>(vector: &Vector<D>) -> [f64; 3] {
    std::array::from_fn(|k| if k < D { vector[k] } else { 0.0 })
}

pub fn matrix<const D: usize>(matrix: &Matrix<D>) -> [f64; 9] {
    let get = |k: usize| matrix.get((k / 3, k % 3)).copied();
    std::array::from_fn(|k| get(k).unwrap_or(0.0))
}

/// Compares every pass, for all instruction sets.
pub fn compare<const D: usize>(setup: Setup, problem: &Problem<D>) {
    let problem = setup.of(problem.clone());
    let asked = Asked {
        laws: setup.laws(),
        mirrors: setup.mirrors,
        shield: setup.shield,
        shifting: setup.shifting,
    };
    let room = |position: &Vector<D>| seam::room(&problem, position);
    let mut summed = None;
    let mut evaluated = None;
    for instructions in instructions() {
        let mut solver = Solver::new(problem.clone(), instructions);
        randomise(&mut solver);
        solver.list();
        if !setup.published {
            let start = world(&solver, &problem);
            solver.read_densities();
            let densities = summed.get_or_insert_with(|| start.densities());
            let gas = solver.gas();
            agree(
                "density",
                gas.iter().map(|p| [p.density]),
                densities.iter().map(|&d| [d]),
            );
            let widths = start.gas.iter().zip(&*densities).map(|(i, density)| {
                let width = 1.5 * (i.mass / density).powf(1.0 / D as f64);
                [width.min(1.03 * i.h)]
            });
            agree("smoothing length", gas.iter().map(|p| [p.h]), widths);
        }
        let start = world(&solver, &problem);
        solver.evaluate();
        let expected = evaluated.get_or_insert_with(|| start.clone().evaluate(asked, room));
        agree_on_walls(&solver, &expected.walls);
        if setup.mirrors && !expected.walls.is_empty() {
            let mirrored = solver.mirrored();
            assert!(mirrored > 0.5, "{mirrored} of the ghosts have mirrors");
        }
        let (found, renormalised) = (solver.renormalisations(), &expected.renormalised);
        let each = found.iter().map(|r| matrix(&r.matrix));
        agree(
            "renormalisation",
            each,
            renormalised.iter().map(|r| matrix(&r.matrix)),
        );
        if setup.published {
            let each = found.iter().map(|r| array(&r.density_gradient));
            let expected = renormalised.iter().map(|r| array(&r.density_gradient));
            agree("density gradient", each, expected);
        }
        if setup.shifting {
            let each = found.iter().map(|r| array(&r.concentration_gradient));
            let expected = renormalised
                .iter()
                .map(|r| array(&r.concentration_gradient));
            agree("concentration gradient", each, expected);
            let each = found.iter().map(|r| array(&r.wall_gradient));
            let expected = renormalised.iter().map(|r| array(&r.wall_gradient));
            agree("its part by walls", each, expected);
        }
        agree_on_rates(setup, &solver, &expected.rates);
        agree_on_smoothness(setup, &solver, &start.gas, expected);
        let step = reference::gas::stable_step(asked.laws, 0.5, &start.gas, &expected.rates);
        agree(
            "stable step",
            [[solver.stable_step()]].into_iter(),
            [[step]].into_iter(),
        );
        agree_on_loads(&solver, &expected.walls, &expected.on_ghosts);
    }
}

/// What ghosts show.
pub fn agree_on_walls<const D: usize>(solver: &Solver<D>, expected: &[reference::Wall<D>]) {
    let ghosts = solver.ghosts();
    let numbers = |wall: &reference::Wall<D>| {
        let point = &wall.point;
        [
            point.pressure,
            wall.surface_pressure,
            point.energy,
            point.density,
        ]
    };
    agree(
        "ghosts' state",
        ghosts.iter().map(numbers),
        expected.iter().map(numbers),
    );
    let velocity = |wall: &reference::Wall<D>| array(&wall.point.velocity);
    agree(
        "ghosts' velocity",
        ghosts.iter().map(velocity),
        expected.iter().map(velocity),
    );
    let strain = |wall: &reference::Wall<D>| matrix(&wall.point.strain);
    agree(
        "ghosts' strain",
        ghosts.iter().map(strain),
        expected.iter().map(strain),
    );
    let slope = |wall: &reference::Wall<D>| array(&wall.point.density_gradient);
    agree(
        "slope of the density at walls",
        ghosts.iter().map(slope),
        expected.iter().map(slope),
    );
}

fn agree_on_rates<const D: usize>(
    setup: Setup,
    solver: &Solver<D>,
    expected: &[reference::Rate<D>],
) {
    type Rate<const D: usize> = reference::Rate<D>;
    let rates = solver.rates();
    let both = |what: &str, get: &dyn Fn(&Rate<D>) -> [f64; 3]| {
        agree(what, rates.iter().map(get), expected.iter().map(get));
    };
    both("shift", &|r| array(&r.shift));
    both("acceleration", &|r| array(&r.acceleration));
    both("acceleration by walls", &|r| array(&r.wall_acceleration));
    both("acceleration by pressure", &|r| {
        array(&r.acceleration_by_pressure)
    });
    both("rate of density", &|r| [r.density, 0.0, 0.0]);
    both("rate of energy", &|r| [r.energy, 0.0, 0.0]);
    both("heating by pressure", &|r| {
        [r.heating_by_pressure, 0.0, 0.0]
    });
    if is_limited(setup) || setup.viscous {
        both("energy gradient", &|r| array(&r.energy_gradient));
    }
    let gradient = |r: &Rate<D>| matrix(&r.velocity_gradient);
    agree(
        "velocity gradient",
        rates.iter().map(gradient),
        expected.iter().map(gradient),
    );
}

/// True where conduction leaves alone what varies linearly.
fn is_limited(setup: Setup) -> bool {
    setup.conduction() == reference::Conduction::Limited
}

/// What the next step's dissipation will go by.
fn agree_on_smoothness<const D: usize>(
    setup: Setup,
    solver: &Solver<D>,
    before: &[Point<D>],
    expected: &reference::step::Evaluation<D>,
) {
    let gas = solver.gas();
    let limits = !setup.published && setup.limits_viscosity || is_limited(setup);
    if limits || setup.shifting {
        let each = expected.smoothness.iter().map(|&s| [s]);
        agree("smoothness", gas.iter().map(|p| [p.smoothness]), each);
    }
    let both = || expected.smoothness.iter().zip(&expected.rates).zip(before);
    let strains = both().map(|((spared, rate), before)| {
        let gradient = rate.velocity_gradient;
        let strain = (gradient + gradient.transpose()) * (0.5 * spared);
        matrix(&if !setup.published && setup.limits_viscosity {
            strain
        } else {
            before.strain
        })
    });
    agree(
        "spared strain",
        gas.iter().map(|p| matrix(&p.strain)),
        strains,
    );
    let slopes = both().map(|((spared, rate), before)| {
        array(&if is_limited(setup) {
            rate.energy_gradient * *spared
        } else {
            before.energy_slope
        })
    });
    agree(
        "spared slope",
        gas.iter().map(|p| array(&p.energy_slope)),
        slopes,
    );
}

/// Sums of what the gas does to the ghosts of each body, the moments about the origin.
pub fn agree_on_loads<const D: usize>(
    solver: &Solver<D>,
    walls: &[reference::Wall<D>],
    on_ghosts: &[reference::step::OnGhost<D>],
) {
    let loads = solver.loads();
    let mut sums = vec![Load::default(); loads.len()];
    for (wall, on_ghost) in walls.iter().zip(on_ghosts) {
        let place = array(&wall.point.position);
        let (force, friction) = (array(&on_ghost.force), array(&on_ghost.friction));
        let sum = &mut sums[wall.body];
        for k in 0..3 {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            sum.force[k] += force[k];
            sum.moment[k] += place[l] * force[m] - place[m] * force[l];
            sum.friction[k] += friction[k];
        }
        sum.heat -= on_ghost.heat;
    }
    let both = |what: &str, get: &dyn Fn(&Load) -> [f64; 3]| {
        agree(what, loads.iter().map(get), sums.iter().map(get));
    };
    both("force", &|load| load.force);
    both("moment", &|load| load.moment);
    both("friction", &|load| load.friction);
    both("heat", &|load| [load.heat, 0.0, 0.0]);
}
