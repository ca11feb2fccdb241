//! What a run spends its time on: passes of a step, whole steps, packing and frames, per particle.
//!
//! `cargo bench -p aero-benches`, or `cargo bench -p aero-benches -- 2D` for a part of it. Times are wall times: on a busy
//! machine they mean little.
//! `AERO_VECTORS=avx2` or `plain` measures the narrower instruction sets.

use std::time::Duration;

use aero::output::write_frame;
use aero_benches::stirred;
use aero_geometry::bodies::{circle, sphere};
use aero_packer::{PackOptions, pack};
use aero_solver::{Pass, Simulation};
use criterion::{BenchmarkId, Criterion, Throughput};

/// Passes and steps on one thread and on two.
fn steps<const D: usize>(criterion: &mut Criterion, cells: usize) {
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("threads are to be had");
        let start = || Simulation::new(stirred::<D>(cells)).expect("the case is sound");
        let mut simulation = pool.install(start);
        let particles = simulation.frame().position.len();
        let listed = simulation.listed_pairs() as f64 / particles as f64;
        let mut group = criterion.benchmark_group(format!(
            "{D}D, {particles} particles, {listed:.0} pairs listed each"
        ));
        group.throughput(Throughput::Elements(particles as u64));
        for pass in Pass::ALL {
            let id = BenchmarkId::new(format!("{pass:?}"), threads);
            group.bench_function(id, |bencher| {
                pool.install(|| bencher.iter(|| simulation.pass(pass)));
            });
        }
        group.bench_function(BenchmarkId::new("step", threads), |bencher| {
            pool.install(|| bencher.iter(|| simulation.step(f64::INFINITY)));
        });
        group.finish();
    }
}

fn packing(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("packing, per ghost");
    let circle = circle(1.0).expect("a circle");
    let sphere = sphere(1.0).expect("a sphere");
    let (fine, coarse) = (PackOptions::new(0.01), PackOptions::new(0.1));
    let ghosts = pack(&circle, &fine).map_or(0, |packed| packed.report.ghosts);
    group.throughput(Throughput::Elements(ghosts as u64));
    group.bench_function("circle", |bencher| bencher.iter(|| pack(&circle, &fine)));
    let ghosts = pack(&sphere, &coarse).map_or(0, |packed| packed.report.ghosts);
    group.throughput(Throughput::Elements(ghosts as u64));
    group.bench_function("sphere", |bencher| bencher.iter(|| pack(&sphere, &coarse)));
    group.finish();
}

fn frames(criterion: &mut Criterion) {
    let simulation = Simulation::new(stirred::<2>(200)).expect("the case is sound");
    let folder = tempfile::tempdir().expect("a folder for what is measured");
    let path = folder.path().join("frame.vtp");
    let mut group = criterion.benchmark_group("frame, per particle");
    group.throughput(Throughput::Elements(40_000));
    group.bench_function("write", |bencher| {
        bencher.iter(|| write_frame(&path, simulation.frame(), &[], None, false));
    });
    group.finish();
}

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    steps::<2>(&mut criterion, 200);
    steps::<3>(&mut criterion, 30);
    packing(&mut criterion);
    frames(&mut criterion);
    criterion.final_summary();
}
