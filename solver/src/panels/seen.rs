//! The panels as gas sees them: where they are now, their images beside them, and what of them is near.

use aero_geometry::Vector;
use aero_geometry::kernel::{QuinticSpline, SUPPORT};

use super::Panels;
use crate::Simulation;
use crate::problem::Domain;
use crate::sides::closed::Map;

/// Cosine of the angle between panels of one surface that bends; what lies beyond sharper edges is behind them.
const BENDS_ON: f64 = 0.8;

/// Largest slope to one another of panels that a surface bends between, were it an arc: one end of a step is no arc from the other.
const OFF_AN_ARC: f64 = 0.5;

/// A panel, or its image beyond a side that maps the flow, where it is now.
#[derive(Clone, Copy, Debug)]
pub struct Seen<const D: usize> {
    /// Middle.
    pub centre: Vector<D>,
    /// Unit normal into the gas.
    pub normal: Vector<D>,
    /// Area.
    pub size: f64,
    /// Axes that the image turns, -1 there.
    pub sign: Vector<D>,
    /// Number of the panel.
    pub number: u32,
    /// True of an image.
    pub is_image: bool,
}

/// A panel within reach of a particle.
#[derive(Clone, Copy, Debug)]
pub struct Met<'a, const D: usize> {
    /// The panel.
    pub seen: &'a Seen<D>,
    /// Kernel from there to the particle.
    pub kernel: f64,
    /// Area times kernel.
    pub weight: f64,
    /// The particle is in front of it.
    pub faces: bool,
}

impl<const D: usize> Seen<D> {
    /// None out of the kernel's reach.
    pub fn met(&self, place: &Vector<D>, reach: f64) -> Option<Met<'_, D>> {
        let arm = place - self.centre;
        let kernel = QuinticSpline::<D>::value(arm.norm(), reach / SUPPORT);
        (kernel > 0.0).then_some(Met {
            seen: self,
            kernel,
            weight: self.size * kernel,
            faces: arm.dot(&self.normal) > 0.0,
        })
    }

    /// True where one surface bends from here to `other`. An arc's chord leans on the normals of its ends alike.
    pub fn bends_on_to(&self, other: &Self) -> bool {
        let arm = other.centre - self.centre;
        self.normal.dot(&other.normal) > BENDS_ON
            && arm.dot(&(self.normal + other.normal)).abs() <= OFF_AN_ARC * arm.norm()
    }

    /// True where `other` is round an edge, as either is behind the other and no surface bends between them.
    pub fn is_around_an_edge_from(&self, other: &Self) -> bool {
        let arm = other.centre - self.centre;
        arm.dot(&self.normal) < 0.0 && arm.dot(&other.normal) > 0.0 && !self.bends_on_to(other)
    }
}

/// The panels where they are now, and their images beyond the sides that map the flow, as far as particles reach.
pub fn seen<const D: usize>(flow: &Simulation<D>, panels: &Panels<D>, reach: f64) -> Vec<Seen<D>> {
    let poses: Vec<_> = (0..flow.walls.body_count())
        .map(|owner| flow.walls.pose(owner, flow.clock.time))
        .collect();
    let mut seen: Vec<Seen<D>> = panels
        .all()
        .iter()
        .enumerate()
        .filter(|(_, panel)| !panel.is_covered)
        .map(|(number, panel)| {
            let pose = &poses[panel.owner as usize];
            Seen {
                centre: pose.position(&panel.centre),
                normal: pose.direction(&panel.normal),
                size: panel.size,
                sign: Vector::repeat(1.0),
                number: number as u32,
                is_image: false,
            }
        })
        .collect();
    for axis in 0..D {
        let domain: &Domain<D> = &flow.problem.domain;
        // Beyond a period the image of what is near one end is near the other.
        let ends = [0, 1].map(|end| domain.face(axis, end));
        let is_near = |place: f64| ends.iter().any(|end| (place - end).abs() < reach);
        let own = seen.len();
        for map in Map::of_axis(domain, axis).into_iter().flatten() {
            let images: Vec<_> = seen[..own]
                .iter()
                .map(|own| {
                    let mut image = *own;
                    image.is_image = true;
                    image.centre[axis] = map.place(own.centre[axis]);
                    image.normal[axis] *= map.sign;
                    image.sign[axis] *= map.sign;
                    image
                })
                .filter(|image| is_near(image.centre[axis]))
                .collect();
            seen.extend(images);
        }
    }
    seen
}
