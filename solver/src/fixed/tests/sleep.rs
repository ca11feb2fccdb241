//! The undisturbed stream, which costs next to nothing.

use std::collections::BTreeSet;
use std::sync::Arc;

use aero_geometry::{Vector, bodies};

use super::flows::stream;
use super::jumps::around;
use super::lattice::{field, problem};
use super::tubes::{flow, march, state};
use super::{Scene, domain};
use crate::fixed::FixedSimulation;
use crate::fixed::net::{BLOCK, Near, one_of};
use crate::method::{FixedPoints, Method};
use crate::problem::Side;

/// A flow that sleeps where nothing happens is the flow that does not.
#[test]
fn the_undisturbed_stream_is_left_out_and_nothing_changes() {
    let run = |skips: bool| {
        let mut problem = problem(
            [256, 32],
            1.0 / 32.0,
            [[Side::Inlet, Side::Outlet], [Side::FreeStream; 2]],
        );
        problem.scheme.skip_undisturbed = skips;
        problem.free_stream = state(1.0, [3.0, 0.0], 1.0 / 1.4);
        problem.initial = field(|x: &Vector<2>| {
            let far = ((x[0] - 6.0).powi(2) + (x[1] - 0.5).powi(2)) / 0.01;
            let hump = if far < 1.0 { (1.0 - far).powi(2) } else { 0.0 };
            state(1.0, [3.0, 0.0], 1.0 / 1.4 + hump)
        });
        let mut flow = flow(problem);
        march(&mut flow, 0.1);
        flow
    };
    let (part, full) = (run(true), run(false));
    let updates = [&part, &full].map(|flow| flow.statistics().particle_updates as f64);
    assert!(updates[0] < 0.3 * updates[1], "{updates:?}");
    let [part, full] = [part, full].map(|flow| flow.frame().density);
    let differences = part.iter().zip(&full).map(|(a, b)| (a - b).abs());
    assert!(differences.fold(0.0, f64::max) < 1e-8);
}

/// Updates of cells behind a ramp of twenty degrees at Mach 2.5 in a box from `start` to `top`, settled and marched for a while.
fn updates(start: f64, top: f64) -> [f64; 2] {
    [true, false].map(|settles| {
        let ramp = Arc::new(bodies::compression_corner(0.0, 20.0).unwrap());
        let mut problem = stream(2.5, [[start, 0.0], [3.0, top]], 1.0 / 16.0, vec![ramp]);
        problem.domain.sides[1] = [Side::Body, Side::FreeStream];
        if !settles {
            problem.method = Method::Fixed(FixedPoints::default());
        }
        let mut flow = FixedSimulation::<2>::new(problem).unwrap();
        if settles {
            let settled = flow.settle(600).unwrap();
            assert!(settled.is_settled);
            flow.statistics().particle_updates as f64 / settled.iterations as f64
        } else {
            march(&mut flow, 1.5);
            flow.statistics().particle_updates as f64
        }
    })
}

/// Cells that nothing comes to are not computed, however many: in a box twice as large a twentieth more are at most.
#[test]
fn a_box_twice_as_large_costs_hardly_more() {
    let usual = updates(-1.0, 4.0);
    for [start, top] in [[-5.0, 4.0], [-1.0, 8.0]] {
        for (more, usual) in updates(start, top).into_iter().zip(usual) {
            println!("{start} {top}: {}", more / usual);
            assert!(more < 1.05 * usual, "{start} {top}: {}", more / usual);
        }
    }
}

/// What wakes a block are the cells at most two faces away from it: not fewer, and not all of the blocks that these are of.
#[test]
fn a_block_is_near_to_what_lies_two_faces_away() {
    let scene = Scene::new(domain([-1.0, -1.0], [1.0, 1.0]), Vec::new(), 0.0625);
    let levels = around(&scene, Vector::<2>::new(-0.1, 0.05), 2, 1);
    let cells = scene.made_with(&levels).cells;
    let mut problem = problem::<2>([32; 2], 0.0625, [[Side::FreeStream; 2]; 2]);
    problem.domain = domain([-1.0, -1.0], [1.0, 1.0]);
    let net = FixedSimulation::on(cells, problem).unwrap().net;
    let faces = || net.blocks.iter().flat_map(|block| &block.faces);
    let mut beside = vec![BTreeSet::new(); net.len()];
    for face in faces() {
        beside[face.i as usize].insert(face.j as usize);
        beside[face.j as usize].insert(face.i as usize);
    }
    assert!(net.blocks.len() > 8);
    for block in &net.blocks {
        let next: BTreeSet<usize> = block
            .cells
            .clone()
            .flat_map(|i| beside[i].clone())
            .collect();
        let after = next.iter().flat_map(|&i| beside[i].clone());
        let mut expected: BTreeSet<usize> = after.chain(next.iter().copied()).collect();
        expected.retain(|i| !block.cells.contains(i));
        let near = |near: &Near| {
            let first = near.block as usize * BLOCK;
            let cells = near.cells;
            (0..BLOCK)
                .filter(move |&k| cells & one_of(k) != 0)
                .map(move |k| first + k)
        };
        let found: BTreeSet<usize> = block.nearby.iter().flat_map(near).collect();
        assert_eq!(found, expected);
    }
}
