//! Particles come, go and change places with all that belongs to them.

use std::collections::HashSet;

use super::*;
use crate::vectors::Arch;

/// A stream that enters on the left and leaves on the right past a wall.
fn stream(scheme: Scheme) -> Problem<2> {
    let mut problem = cube::<2>(24, Side::Symmetry);
    problem.domain.sides = [[Side::Inlet, Side::Outlet], [WALL, Side::FreeStream]];
    problem.scheme = scheme;
    problem.free_stream.velocity = Vector::<2>::new(1.5, 0.0);
    let stream = problem.free_stream;
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<2>| State {
        pressure: if (position - Vector::<2>::new(1.6, 0.4)).norm() < 0.25 {
            1.5
        } else {
            1.0
        },
        ..stream
    })));
    problem
}

#[test]
fn rates_stay_with_their_particles() {
    let mut simulation = start(cube::<2>(10, Side::Periodic));
    let fluid = &mut simulation.fluid;
    let columns = fluid.columns();
    for (particle, rates) in columns.state.iter().zip(columns.rates) {
        rates.density = particle.id as f64;
    }
    let mut newcomer = fluid[7];
    newcomer.id = 1_000_000;
    fluid.remove([0, 3, 50, 98, 99].into_iter());
    fluid.add(newcomer);
    assert_eq!(fluid.len(), 96);
    assert_eq!(fluid.rates().len(), 96);
    for (particle, rates) in fluid.iter().zip(fluid.rates()).take(95) {
        assert_eq!(rates.density, particle.id as f64);
    }
    assert_eq!(fluid.rates()[95].density, 0.0);
    let order: Vec<u32> = (0..96).rev().collect();
    fluid.permute(&order);
    assert_eq!(fluid[0].id, 1_000_000);
}

#[test]
fn no_two_particles_ever_share_a_number() {
    let mut simulation = start(stream(Scheme::CONSERVATIVE));
    let mut seen: HashSet<u64> = HashSet::new();
    let mut before: HashSet<u64> = HashSet::new();
    for _ in 0..80 {
        advance(&mut simulation, 1);
        let buffered = simulation.buffers.particles().iter();
        let numbers = simulation.fluid.iter().chain(buffered.map(|o| &o.particle));
        let numbers: Vec<u64> = numbers.map(|p| p.id).collect();
        let now: HashSet<u64> = numbers.iter().copied().collect();
        assert_eq!(now.len(), numbers.len());
        // Nor does anyone come back.
        assert!(now.iter().all(|id| before.contains(id) || seen.insert(*id)));
        before = now;
    }
}

#[test]
fn whom_a_particle_shares_a_cluster_with_changes_no_bit() {
    for scheme in [Scheme::CONSERVATIVE, Scheme::PAPER] {
        let problem = stream(scheme);
        let mut wide = start(problem.clone());
        advance(&mut wide, 12);
        let mut alone = Simulation::resume(problem, wide.memory()).expect("the same problem");
        let arch = wide.around.arch;
        alone.around.arch = Arch::new(pulp::Arch::Scalar, wide.problem.scheme.precision);
        alone.prepare();
        alone.around.arch = arch;
        wide.prepare();
        wide.evaluate_start();
        alone.evaluate_start();
        let calm = wide.fluid.iter().filter(|p| p.is_calm).count();
        assert!(calm > 10, "{calm} particles are calm");
        let bits = |simulation: &Simulation<2>| -> Vec<[u64; 6]> {
            let fluid = &simulation.fluid;
            let numbers = fluid.iter().zip(fluid.rates()).map(|(p, r)| {
                let [x, y] = r.acceleration.into();
                let numbers = [p.density, p.smoothing_length, r.density, r.energy, x, y];
                numbers.map(f64::to_bits)
            });
            numbers.collect()
        };
        assert_eq!(bits(&wide), bits(&alone));
    }
}

#[test]
fn the_widest_particle_of_all_leaves_the_search_of_others_alone() {
    let listed = |wide: usize| {
        let mut simulation = start(cube::<2>(40, Side::Symmetry));
        let count = simulation.fluid.len();
        for particle in &mut simulation.fluid[count - wide..] {
            particle.smoothing_length *= 8.0;
        }
        simulation.prepare();
        simulation.around.lists.room() as f64
    };
    // Room for what is looked at before it is known to be too far.
    let (none, one) = (listed(0), listed(1));
    assert!(one < 4.0 * none, "{one} after {none}");
}
