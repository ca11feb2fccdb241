//! Gas presses a round wall with more than its pressure.
//!
//! Its kernels reach over the wall's horizon: more than half of a kernel about a place on a convex wall is gas, by `e`, what lies between
//! the surface and the plane that touches it there, and the force per area of an even pressure `p` is `p (1 + 2 e)`: 1 + 0.4 / R where the
//! wall bends in one direction with a radius of R spacings, twice that on a sphere; on a hollow wall it is less by as much. It is the
//! tension of a layer of gas that feels fewer neighbours along the wall than elsewhere, as that of a liquid's surface raises the pressure
//! in a drop, and it comes to nothing all around a body in gas at rest. It is no pressure.

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use foldhash::HashMap;

use super::seen::Seen;
use crate::each::each;

/// Patches to the width of the widest kernel.
const PATCHES: f64 = 16.0;

/// Panels of one patch have normals alike to a part in so many.
const TURNS: f64 = 4.0;

/// Panels to a patch from where patches take less time.
const WORTH_WHILE: usize = 2;

/// Part of a kernel between the surface and the plane that touches it at each of the `panels`, which `grid` sorts; negative where the
/// surface is hollow. The kernel of a panel is as wide as `reach` says, `widest` at most, none where no gas is; those of images count as
/// nothing. Where many panels are much smaller than a kernel, patches of them are summed.
pub fn bends<const D: usize>(
    panels: &[Seen<D>],
    grid: &Pencils<D>,
    widest: f64,
    reach: impl Fn(&Seen<D>) -> Option<f64> + Sync,
) -> Vec<f64> {
    let patches = together(panels, widest / PATCHES);
    if WORTH_WHILE * patches.len() > panels.len() {
        return over(panels, panels, grid, reach);
    }
    let centres: Vec<Vector<D>> = patches.iter().map(|patch| patch.centre).collect();
    over(panels, &patches, &Pencils::new(&centres, widest), reach)
}

/// The same over `surface`, which `grid` sorts.
fn over<const D: usize>(
    panels: &[Seen<D>],
    surface: &[Seen<D>],
    grid: &Pencils<D>,
    reach: impl Fn(&Seen<D>) -> Option<f64> + Sync,
) -> Vec<f64> {
    let bend = |at: &Seen<D>| {
        let reach = reach(at).filter(|_| !at.is_image)?;
        let mut beyond = 0.0;
        grid.for_each_run_near(&at.centre, &at.centre, reach, |run| {
            let run = grid.order()[run].iter().map(|&n| &surface[n as usize]);
            beyond += run.map(|other| between(at, other, reach)).sum::<f64>();
        });
        Some(beyond)
    };
    panels
        .par_iter()
        .map(|at| bend(at).unwrap_or(0.0))
        .collect()
}

/// The panels by patches of that width whose normals are alike: middles, mean normals and areas of what each is made of.
fn together<const D: usize>(panels: &[Seen<D>], width: f64) -> Vec<Seen<D>> {
    let mut numbers: HashMap<[[i64; D]; 2], usize> = HashMap::default();
    let mut patches: Vec<Seen<D>> = Vec::new();
    for panel in panels {
        let cell = each(|k| (panel.centre[k] / width).floor() as i64);
        let turn = each(|k| (TURNS * panel.normal[k]).round() as i64);
        let number = *numbers.entry([cell, turn]).or_insert(patches.len());
        if number == patches.len() {
            patches.push(*panel);
            patches[number].centre *= panel.size;
            patches[number].normal *= panel.size;
        } else {
            let patch = &mut patches[number];
            patch.centre += panel.centre * panel.size;
            patch.normal += panel.normal * panel.size;
            patch.size += panel.size;
        }
    }
    patches.retain(|patch| patch.size > 0.0);
    for patch in &mut patches {
        patch.centre /= patch.size;
        patch.size = patch.normal.norm();
        patch.normal /= patch.size;
    }
    patches
}

/// The part of it over `other`.
fn between<const D: usize>(at: &Seen<D>, other: &Seen<D>, reach: f64) -> f64 {
    if !at.bends_on_to(other) {
        return 0.0;
    }
    let arm: Vector<D> = other.centre - at.centre;
    let kernel = QuinticSpline::<D>::value(arm.norm(), reach / SUPPORT);
    -arm.dot(&at.normal) * at.normal.dot(&other.normal) * other.size * kernel
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cap of a sphere of radius one, in rings of panels of about that size.
    fn cap(size: f64) -> Vec<Seen<3>> {
        let rings = (std::f64::consts::PI / size).round() as usize;
        let mut panels = Vec::new();
        for ring in 0..rings / 3 {
            let [from, to] =
                [ring, ring + 1].map(|n| std::f64::consts::PI * n as f64 / rings as f64);
            let around = (std::f64::consts::TAU * (0.5 * (from + to)).sin() / size).ceil() as usize;
            for n in 0..around {
                let (theta, phi) = (
                    0.5 * (from + to),
                    std::f64::consts::TAU * (n as f64 + 0.5) / around as f64,
                );
                let normal = Vector::<3>::new(
                    theta.cos(),
                    theta.sin() * phi.cos(),
                    theta.sin() * phi.sin(),
                );
                panels.push(Seen {
                    centre: normal,
                    normal,
                    size: std::f64::consts::TAU * (from.cos() - to.cos()) / around as f64,
                    sign: Vector::repeat(1.0),
                    number: panels.len() as u32,
                    is_image: false,
                });
            }
        }
        panels
    }

    #[test]
    fn fine_panels_by_patches_bend_as_they_do_one_by_one() {
        let reach = 0.6;
        let near_the_pole = |panel: &Seen<3>| (panel.normal[0] > 0.95).then_some(reach);
        let mean = |size: f64| {
            let panels = cap(size);
            let centres: Vec<_> = panels.iter().map(|panel| panel.centre).collect();
            let grid = Pencils::new(&centres, reach);
            let patches = together(&panels, reach / PATCHES).len();
            let bends = bends(&panels, &grid, reach, near_the_pole);
            let all = over(&panels, &panels, &grid, near_the_pole);
            let apart = bends.iter().zip(&all).map(|(a, b)| (a - b).abs());
            let apart = apart.fold(0.0, f64::max);
            let judged = all.iter().filter(|&&bend| bend > 0.0);
            let mean = judged.clone().sum::<f64>() / judged.count() as f64;
            (panels.len() as f64 / patches as f64, mean, apart)
        };
        let (coarse, exact, apart) = mean(0.07);
        assert!(coarse < 1.5 && apart == 0.0, "{coarse} {apart}");
        let (fine, bend, apart) = mean(0.018);
        assert!(fine > 2.0, "{fine} panels to a patch");
        assert!((bend / exact - 1.0).abs() < 0.03, "{bend} for {exact}");
        assert!(apart < 0.03 * bend, "{apart} off {bend}");
    }
}
