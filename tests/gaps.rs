//! Ghosts of bodies, wall sides and their images in all project scenes: none twice, none closer than half a spacing.

use std::path::{Path, PathBuf};

use aero::case::{AnyCase, Case};
use aero::scene::Scene;
use aero_geometry::{Pencils, Vector};
use aero_solver::Flow;
use aero_solver::frame::Kind;

/// What is this close together, in spacings, is in one place.
const ONE_PLACE: f64 = 1e-6;

/// Least gap, in spacings; round-off aside.
const LEAST: f64 = 0.5 - 1e-6;

/// A ghost, or an image of one, in units of the finest spacing.
struct Standing {
    place: Vector<3>,
    volume: f64,
}

/// All ghosts of a case at its start and their images beyond sides that map the flow.
fn standing<const D: usize>(case: Case<D>) -> Vec<Standing> {
    let domain = case.problem.domain.clone();
    let bodies = case.problem.bodies.iter();
    let spacings = bodies.map(|body| body.report.spacing);
    let spacing = spacings.fold(case.problem.resolution.lattice(), f64::min);
    let flow = Flow::new(case.problem).expect("a flow");
    let frame = flow.frame();
    let mut all: Vec<Standing> = (0..frame.kind.len())
        .filter(|&n| frame.kind[n] == Kind::Ghost as u8)
        .map(|n| Standing {
            place: Vector::from(frame.position[n]) / spacing,
            volume: frame.volume[n],
        })
        .collect();
    for axis in 0..D {
        // A shift and its way back lead to where they began.
        let count = all.len();
        for end in [0, 1] {
            let plane = domain.face(axis, end) / spacing;
            let period = domain.bounds.size()[axis] * [1.0, -1.0][end] / spacing;
            let side = domain.sides[axis][end];
            for n in 0..count {
                let x = all[n].place[axis];
                let image = match side {
                    side if side.is_mirror() => 2.0 * plane - x,
                    side if side.is_periodic() => x + period,
                    _ => break,
                };
                let (mut place, volume) = (all[n].place, all[n].volume);
                place[axis] = image;
                all.push(Standing { place, volume });
            }
        }
    }
    all
}

/// The least gap with its place, and how many places hold more than one ghost's volume.
fn gaps(all: &[Standing]) -> (f64, [f64; 3], usize) {
    let places: Vec<Vector<3>> = all.iter().map(|ghost| ghost.place).collect();
    let pencils = Pencils::new(&places, 1.0);
    let volumes = all.iter().map(|ghost| ghost.volume);
    let fullest = volumes.fold(0.0, f64::max);
    let (mut least, mut at, mut doubled) = (f64::INFINITY, [0.0; 3], 0);
    for place in &places {
        let mut held = 0.0;
        pencils.for_each_run_near(place, place, 1.0, |run| {
            for &other in &pencils.order()[run] {
                let other = &all[other as usize];
                let gap = (other.place - place).norm();
                if gap < ONE_PLACE {
                    held += other.volume;
                } else if gap < least {
                    (least, at) = (gap, (*place).into());
                }
            }
        });
        doubled += usize::from(held > 1.5 * fullest);
    }
    (least, at, doubled)
}

fn scenes(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let all = std::fs::read_dir(folder).expect("scenes");
    let mut paths: Vec<PathBuf> = all.map(|entry| entry.expect("a scene").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    paths
}

#[test]
fn no_ghost_of_a_project_scene_stands_twice_or_within_half_a_spacing_of_another() {
    let mut bad = Vec::new();
    for path in [scenes("cases"), scenes("cases/stress")].concat() {
        let scene = Scene::load(&path).expect("a scene");
        let all = match scene.build_any().expect("a case") {
            AnyCase::One(case) => standing(*case),
            AnyCase::Two(case) => standing(*case),
            AnyCase::Three(case) => standing(*case),
        };
        if all.is_empty() {
            continue;
        }
        let (least, at, doubled) = gaps(&all);
        let name = scene.name();
        println!("{name}: smallest gap {least:.3} near {at:.1?} spacings, {doubled} doubled");
        if least < LEAST || doubled > 0 {
            bad.push(name.to_owned());
        }
    }
    assert!(bad.is_empty(), "{bad:?}");
}
