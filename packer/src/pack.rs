//! The packing, from the body to the report.

use std::time::Instant;

use aero_geometry::{Shape, Vector};
use rayon::prelude::*;

use crate::cloud::Cloud;
use crate::mirror::flip;
use crate::plan::Plan;
use crate::quality::report;
use crate::seeds::seed;
use crate::{Ghosts, PackError, PackOptions, Packing};

/// Packs ghosts into `shape` and, if asked, conforming fluid around it.
pub fn pack<const D: usize>(
    shape: &dyn Shape<D>,
    options: &PackOptions<D>,
) -> Result<Packing<D>, PackError> {
    let start = Instant::now();
    options.check()?;
    let plan = Plan::new(shape, options)?;
    let cloud = seed(&plan)?;
    let ghosts = finished(&plan, &cloud);
    if ghosts.position.is_empty() {
        return Err(PackError::Empty);
    }
    let mut report = report(&plan, &ghosts);
    report.wall_seconds = start.elapsed().as_secs_f64();
    Ok(Packing {
        ghosts,
        fluid: Ghosts::default(),
        report,
    })
}

/// Particles with normals, distances and mirror images, clipped to the region.
fn finished<const D: usize>(plan: &Plan<'_, D>, cloud: &Cloud<D>) -> Ghosts<D> {
    let surface: Vec<_> = cloud
        .position
        .par_iter()
        .map(|point| plan.shape.closest(point))
        .collect();
    let mut all = Ghosts::default();
    let mut add = |n: usize, position: Vector<D>, flips: u32| {
        if !plan.keeps(&position) {
            return;
        }
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
    };
    for n in 0..cloud.len() {
        let position = cloud.position[n];
        add(n, position, 0);
        plan.mirrors
            .images(&position, |flips, image| add(n, image, flips));
    }
    all
}
