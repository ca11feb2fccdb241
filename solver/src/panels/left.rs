//! What panels do not show of loads, and where it belongs.
//!
//! Panels show what gas within is pressed with, loads count the pairs that cross the wall within the sides ([`crate::walls`]). Of a surface that
//! runs on through an open side the pull between panels within and beyond is the difference where gas lies in front of the wall as ghosts lie
//! behind it; where gas is squeezed there a part of it is left, which belongs where the surface is cut. Where another solid stands on a surface,
//! or near to it, loads go by whose ghosts press, panels by how near they are; what is left of that belongs there as well. About an axis loads count each ghost
//! all around its own circumference ([`Rings::pulled`]), and what is left of that belongs to no place.

use aero_geometry::kernel::{SMOOTHING_RATIO, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use super::{Panel, Panels, Pressed, is_shown};
use crate::frame::Load;
use crate::problem::{Domain, Problem, Side};
use crate::rings::Rings;
use crate::scheme::PressureGradient;
use crate::sides::closed::reflections;
use crate::walls::rigid::{Pose, pad};

impl<const D: usize> Panels<D> {
    /// Adds to the friction of panels next to open sides and to other solids, about an axis of all, what the `loads` have over what is `pressed`; `pose` tells
    /// where bodies are. Returns the forces that it adds up to on what the domain holds; none where nothing is left.
    pub fn add_what_is_left(
        &self,
        problem: &Problem<D>,
        pose: impl Fn(usize) -> Pose<D> + Copy,
        loads: &[Load],
        pressed: &mut [Pressed<D>],
    ) -> Vec<[f64; 3]> {
        let domain = &problem.domain;
        let rings = Rings::new(problem);
        // What walls bear of differences of pressures is not what the gas is given.
        let is_given = problem.scheme.operators.pressure != PressureGradient::Difference;
        if !is_given || !(domain.has(Side::is_open) || rings.are_real() || loads.len() > 1) {
            return Vec::new();
        }
        let reach = SUPPORT * SMOOTHING_RATIO * problem.resolution.lattice();
        let poses: Vec<Pose<D>> = (0..loads.len()).map(pose).collect();
        let centres: Vec<Vector<D>> = (self.all.iter())
            .map(|panel| poses[panel.owner as usize].position(&panel.centre))
            .collect();
        let to_others = self.distances_to_others(&centres, reach);
        let nearness: Vec<f64> = (self.all.iter().zip(&centres).zip(to_others))
            .map(|((panel, centre), to_others)| {
                if !is_shown(domain, centre) || panel.is_covered {
                    0.0
                } else if rings.are_real() {
                    1.0
                } else {
                    (1.0 - depth(domain, centre).min(to_others) / reach).max(0.0)
                }
            })
            .collect();
        let mut areas = vec![0.0; loads.len()];
        for ((panel, centre), near) in self.all.iter().zip(&centres).zip(&nearness) {
            areas[panel.owner as usize] += near * panel.size * rings.surface(centre);
        }
        let shown = self.loads(problem, pressed, pose);
        let lacking: Vec<Vector<D>> = (loads.iter().zip(&shown).zip(&areas).enumerate())
            .map(|(owner, ((load, shown), area))| {
                let extent = problem.bodies.get(owner).map(|body| body.shape.bounds());
                let images = reflections(domain, extent.as_ref());
                Vector::from_fn(|k, _| {
                    // What mirror images cancel nobody knows.
                    let times: f64 = images.iter().map(|(sign, _)| sign[k]).sum();
                    if times > 0.0 && *area > 0.0 {
                        (load.force[k] - shown.force[k]) / (times * area)
                    } else {
                        0.0
                    }
                })
            })
            .collect();
        for ((panel, near), pressed) in self.all.iter().zip(&nearness).zip(pressed) {
            pressed.friction += lacking[panel.owner as usize] * *near;
        }
        let forces = lacking.iter().zip(&areas);
        forces
            .map(|(lacking, area)| pad(&(lacking * *area)).into())
            .collect()
    }
}

impl<const D: usize> Panels<D> {
    /// How far each panel, with these `centres`, is from those of others that gas is in front of, up to `reach`.
    fn distances_to_others(&self, centres: &[Vector<D>], reach: f64) -> Vec<f64> {
        let first = self.all.first().map(|panel| panel.owner);
        if self.all.iter().all(|panel| Some(panel.owner) == first) {
            return vec![reach; centres.len()];
        }
        let grid = Pencils::new(centres, reach);
        let distance = |(panel, centre): (&Panel<D>, &Vector<D>)| {
            let mut least = reach;
            grid.for_each_run_near(centre, centre, reach, |run| {
                for &n in &grid.order()[run] {
                    let other = &self.all[n as usize];
                    if other.owner != panel.owner && !other.is_covered {
                        least = least.min((centres[n as usize] - centre).norm());
                    }
                }
            });
            least
        };
        (self.all.par_iter().zip(centres)).map(distance).collect()
    }
}

/// How deep within all open sides a place lies.
fn depth<const D: usize>(domain: &Domain<D>, place: &Vector<D>) -> f64 {
    let sides = domain.each_side();
    let open = sides.filter(|&(axis, end, _, _)| domain.opens(axis, end));
    open.map(|(axis, end, _, _)| domain.depth_within(axis, end, place))
        .fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::{Placed, Placement, Shape, bodies};

    use super::*;
    use crate::Simulation;
    use crate::panels::press::pressed;
    use crate::problem::PackedFluid;
    use crate::tests::cube;
    use crate::tests::seam::body_on_the_lattice;

    const SPACING: f64 = 0.1;

    /// The flow about a body that goes out through the right side of a box, three wide; all stands on one lattice.
    fn about(shape: impl Shape<2> + 'static, at: [f64; 2], below: Side) -> Simulation<2> {
        let mut problem = cube::<2>(30, Side::FreeStream);
        problem.domain.sides[1][0] = below;
        let place = Placement::default().moved(Vector::from(at));
        let mut wider = problem.clone();
        wider.domain.bounds.max[0] = 4.0;
        let mut body = body_on_the_lattice(&wider, Arc::new(Placed::new(shape, place)));
        body.packed_fluid = Some(PackedFluid {
            position: Vec::new(),
            lattice_begins: body.starting_distance(SPACING),
        });
        problem.bodies.push(body);
        Simulation::new(problem).expect("a sound problem")
    }

    /// Edges and a side that cuts it pull it along its walls; together they are nothing, and each shows so where it is.
    #[test]
    fn gas_at_rest_presses_a_bar_that_a_side_cuts_with_its_pressure_alone() {
        let height = 0.8;
        let bar = bodies::rectangle(4.0, height, 0.0).expect("a bar");
        let flow = about(bar, [3.5, 1.5], Side::FreeStream);
        let panels = Panels::new(&flow.problem);
        let pressed = pressed(&flow, &panels);
        let shown = panels.loads(&flow.problem, &pressed, |_| Pose::at_rest());
        for load in [&flow.loads()[0], &shown[0]] {
            let off = (load.force[0] - height) / SPACING;
            assert!(off.abs() < 0.1, "{off} spacings of it: {load:?}");
        }
        for (pressed, panel) in pressed.iter().zip(&panels.all) {
            if is_shown(&flow.problem.domain, &panel.centre) && panel.owner == 0 {
                let Pressed {
                    pressure, friction, ..
                } = pressed;
                let is_at_an_edge = panel.centre[0] < 2.0;
                let most = if is_at_an_edge { 0.16 } else { 0.01 };
                assert!(friction.norm() < most, "{panel:?} {friction:?}");
                assert!((pressure - 1.0).abs() < 0.01, "{panel:?} {pressure}");
            }
        }
    }

    /// A ball about the axis, cut where it is widest: gas is pushed from ghosts that stand farther from the axis downstream than it does.
    #[test]
    fn little_is_left_of_what_presses_a_nose_about_an_axis() {
        let ball = bodies::circle(1.5).expect("a circle");
        let flow = about(ball, [3.0, 0.0], Side::Axis);
        let panels = Panels::new(&flow.problem);
        let pressed = pressed(&flow, &panels);
        let shown = panels.loads(&flow.problem, &pressed, |_| Pose::at_rest());
        let rim = std::f64::consts::TAU * 1.5 * SPACING;
        let off = (shown[0].force[0] - flow.loads()[0].force[0]) / rim;
        assert!(off.abs() < 0.1, "{off}");
    }
}
