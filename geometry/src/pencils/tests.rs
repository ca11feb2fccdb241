//! Searches against brute force, and what no set of points may do.

use super::*;

fn scattered<const D: usize>(count: usize) -> Vec<Vector<D>> {
    let mut seed = 7_u64;
    let mut next = || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / f64::from(1_u32 << 31)
    };
    (0..count).map(|_| Vector::from_fn(|_, _| next())).collect()
}

fn finds_what_brute_force_finds<const D: usize>() {
    let points = scattered::<D>(500);
    let pencils = Pencils::new(&points, 0.13);
    let radius = 0.2;
    for centre in &points[..50] {
        let mut found: Vec<u32> = Vec::new();
        pencils.for_each_run(
            &centre.add_scalar(-radius),
            &centre.add_scalar(radius),
            |run| {
                found.extend(
                    pencils.order()[run]
                        .iter()
                        .filter(|&&p| (points[p as usize] - centre).norm() < radius),
                );
            },
        );
        found.sort_unstable();
        let expected: Vec<u32> = (0..500)
            .filter(|&p| (points[p as usize] - centre).norm() < radius)
            .collect();
        assert_eq!(found, expected);
    }
}

fn near_a_box_finds_what_brute_force_finds<const D: usize>() {
    let points = scattered::<D>(500);
    let pencils = Pencils::new(&points, 0.13);
    let (reach, size) = (0.2, 0.1);
    for min in &points[..50] {
        let max = min.add_scalar(size);
        let near = |point: &Vector<D>| {
            let outside = point - point.sup(min).inf(&max);
            outside.norm() < reach
        };
        let mut found: Vec<u32> = Vec::new();
        pencils.for_each_run_near(min, &max, reach, |run| {
            found.extend(
                pencils.order()[run]
                    .iter()
                    .filter(|&&p| near(&points[p as usize])),
            );
        });
        found.sort_unstable();
        let expected: Vec<u32> = (0..500).filter(|&p| near(&points[p as usize])).collect();
        assert_eq!(found, expected);
    }
}

#[test]
fn on_a_grid_the_order_of_points_depends_on_no_others() {
    let points = scattered::<3>(600);
    let corner = Vector::repeat(-0.37);
    let mut pencils = Pencils::default();
    let mut order = |kept: &[usize]| -> Vec<usize> {
        let rank = |n: usize| kept[n] as u64;
        // Ties everywhere: all points of a column at few heights.
        let place = |n: usize| {
            points[kept[n]].map_with_location(
                |k, _, x: f64| {
                    if k == 2 { (x * 4.0).floor() } else { x }
                },
            )
        };
        pencils.rebuild_on_grid(&corner, 0.13, kept.len(), place, rank);
        pencils.order().iter().map(|&n| kept[n as usize]).collect()
    };
    let all: Vec<usize> = (0..600).collect();
    let whole = order(&all);
    let backwards: Vec<usize> = all.iter().rev().copied().collect();
    assert_eq!(order(&backwards), whole);
    let part: Vec<usize> = all
        .iter()
        .copied()
        .filter(|&n| points[n][0] > 0.5)
        .collect();
    let expected: Vec<usize> = whole.iter().copied().filter(|n| part.contains(n)).collect();
    assert_eq!(order(&part), expected);
}

#[test]
fn a_search_around_a_box_finds_what_brute_force_finds_in_every_dimension() {
    near_a_box_finds_what_brute_force_finds::<1>();
    near_a_box_finds_what_brute_force_finds::<2>();
    near_a_box_finds_what_brute_force_finds::<3>();
}

#[test]
fn a_search_finds_what_brute_force_finds_in_every_dimension() {
    finds_what_brute_force_finds::<1>();
    finds_what_brute_force_finds::<2>();
    finds_what_brute_force_finds::<3>();
}

#[test]
fn an_empty_set_has_no_runs() {
    let pencils = Pencils::<2>::new(&[], 1.0);
    pencils.for_each_run(&Vector::zeros(), &Vector::repeat(1.0), |_| {
        panic!("no run expected")
    });
}

#[test]
fn points_that_are_nowhere_do_no_harm() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut points = scattered::<3>(10);
        points.push(Vector::repeat(bad));
        assert_eq!(Pencils::new(&points, 0.1).order().len(), 11);
        assert_eq!(Pencils::<2>::new(&[Vector::repeat(bad)], 0.1).order(), [0]);
    }
}

#[test]
fn a_far_outlier_does_not_exhaust_memory() {
    let mut points = scattered::<3>(100);
    points.push(Vector::repeat(1e12));
    let pencils = Pencils::new(&points, 0.1);
    assert!(pencils.slots.start.len() < 10_000);
}
