//! First positions of the ghosts, layer by layer.

use crate::cloud::{Cloud, Lock};
use crate::contour::Corners;
use crate::level::project;
use crate::plan::Plan;
use crate::room::Side;
use crate::room_across::fits;
use crate::room_inside::has_room;
use crate::rows::RowPlan;
use crate::sheets::{BlockVolumes, Sheets};

/// Stage of the work, for those who watch.
const LAYING: &str = "laying the layers";

/// Particles of all layers in the packed part of space, each on the middle of its layer, where
/// that has room; and the volume that they leave.
pub(crate) fn seed<const D: usize>(plan: &Plan<'_, D>) -> (Cloud<D>, f64) {
    let cloud = if D == 2 {
        in_the_plane(plan)
    } else {
        in_space(plan)
    };
    let shares = cloud.position.iter().map(|point| plan.mirrors.share(point));
    let used = shares.sum::<f64>() * plan.particle_volume();
    let left = plan.layer_volumes().iter().sum::<f64>() - used;
    (cloud, left)
}

/// Equidistant along the contours.
fn in_the_plane<const D: usize>(plan: &Plan<'_, D>) -> Cloud<D> {
    let spacing = plan.options.spacing;
    let corners = Corners::new(
        plan.shape,
        &plan.mirrors,
        plan.grid,
        &plan.band,
        plan.tolerance,
    );
    let rows = RowPlan {
        spacing,
        anchor: plan.options.anchor,
    };
    let mut cloud = Cloud::default();
    let mut carry = 0.0;
    for layer in 0..plan.layers {
        plan.options.watch.show(LAYING, layer, plan.layers);
        let level = plan.level(layer);
        for contour in &corners.trace(level) {
            for s in rows.seeds(contour, &mut carry) {
                let guess = plan.mirrors.snapped(contour.point_at(s), 1e-9 * spacing);
                let point = project(plan.shape, &guess, level, plan.tolerance).unwrap_or(guess);
                let normal = plan.shape.closest(&point).normal;
                let seen = (&point, level, &normal);
                let has_room = match plan.side {
                    Side::Ghosts => has_room(plan.shape, seen, layer, spacing),
                    Side::Fluid => fits(plan.shape, seen, layer, spacing),
                };
                if has_room {
                    cloud.push(
                        point,
                        layer as u32,
                        Lock::Level(level),
                        plan.particle_volume(),
                    );
                }
            }
        }
    }
    cloud
}

/// Lattice points projected onto the level surfaces.
fn in_space<const D: usize>(plan: &Plan<'_, D>) -> Cloud<D> {
    let sheets = Sheets { plan };
    let mut cloud = Cloud::default();
    let mut carry = 0.0;
    for (layer, wanted) in BlockVolumes::of_layers(plan).iter().enumerate() {
        plan.options.watch.show(LAYING, layer, plan.layers);
        for point in sheets.seeds(layer, wanted, &mut carry) {
            let lock = Lock::Level(plan.level(layer));
            cloud.push(point, layer as u32, lock, plan.particle_volume());
        }
    }
    cloud
}
