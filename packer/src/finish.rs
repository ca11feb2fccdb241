//! From the packed part of space to all particles: mirror images, normals, the region's clip.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use crate::Ghosts;
use crate::cloud::{Cloud, Lock};
use crate::mirror::flip;
use crate::plan::Plan;

/// All particles of a cloud and their images, outside the region too.
#[derive(Clone, Debug, Default)]
pub(crate) struct Finished<const D: usize> {
    /// The particles.
    pub all: Ghosts<D>,
    /// True for those in parts too thin for their layer.
    pub thin: Vec<bool>,
}

impl<const D: usize> Finished<D> {
    /// Adds distances, normals and images.
    pub fn new(plan: &Plan<'_, D>, cloud: &Cloud<D>) -> Self {
        let surface: Vec<_> = cloud
            .position
            .par_iter()
            .map(|point| plan.shape.closest(point))
            .collect();
        let mut finished = Self::default();
        for n in 0..cloud.len() {
            let mut add = |flips: u32, position: Vector<D>| {
                let all = &mut finished.all;
                all.position.push(position);
                all.normal.push(flip(&surface[n].normal, flips));
                all.distance.push(surface[n].distance);
                all.volume.push(cloud.volume[n]);
                all.layer.push(cloud.layer[n]);
                // An image may lie on another smooth part of the surface than its original.
                let face = if flips == 0 {
                    surface[n].face
                } else {
                    plan.shape.closest(&position).face
                };
                all.face.push(face);
                finished
                    .thin
                    .push(matches!(cloud.lock[n], Lock::Thin | Lock::Row));
            };
            add(0, cloud.position[n]);
            plan.mirrors.images(&cloud.position[n], add);
        }
        finished
    }

    /// Numbers of the particles inside the region.
    pub fn kept(&self, plan: &Plan<'_, D>) -> Vec<usize> {
        (0..self.all.position.len())
            .filter(|&n| plan.keeps(&self.all.position[n]))
            .collect()
    }

    /// Some of the particles.
    pub fn only(&self, numbers: &[usize]) -> Ghosts<D> {
        let all = &self.all;
        Ghosts {
            position: numbers.iter().map(|&n| all.position[n]).collect(),
            normal: numbers.iter().map(|&n| all.normal[n]).collect(),
            distance: numbers.iter().map(|&n| all.distance[n]).collect(),
            volume: numbers.iter().map(|&n| all.volume[n]).collect(),
            layer: numbers.iter().map(|&n| all.layer[n]).collect(),
            face: numbers.iter().map(|&n| all.face[n]).collect(),
        }
    }
}
