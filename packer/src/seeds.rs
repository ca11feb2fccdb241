//! First positions of the ghosts, layer by layer.

use crate::PackError;
use crate::cloud::{Cloud, Lock};
use crate::contour::{Contour, Corners};
use crate::grid::Grid;
use crate::level::project;
use crate::plan::Plan;
use crate::rows::RowPlan;
use crate::sheets::Sheets;

/// Volumes that agree with the contour's length to this part are taken to be equal.
const SAME_VOLUME: f64 = 0.02;

/// Ghosts of all layers in the packed part of space, each on the middle of its layer.
pub(crate) fn seed<const D: usize>(plan: &Plan<'_, D>) -> Result<Cloud<D>, PackError> {
    if D == 2 {
        Ok(in_the_plane(plan))
    } else {
        in_space(plan)
    }
}

/// Equidistant along the contours.
fn in_the_plane<const D: usize>(plan: &Plan<'_, D>) -> Cloud<D> {
    let spacing = plan.options.spacing;
    let volume = spacing.powi(D as i32);
    let corners = Corners::new(
        plan.shape,
        &plan.mirrors,
        plan.fine,
        &plan.band,
        plan.tolerance,
    );
    let rows = RowPlan {
        spacing,
        anchor: plan.options.anchor,
    };
    let mut cloud = Cloud::default();
    let mut carry = 0.0;
    for (layer, layer_volume) in plan.layer_volumes().into_iter().enumerate() {
        let level = plan.level(layer);
        let contours = corners.trace(level);
        let length: f64 = contours.iter().map(Contour::length).sum();
        let ratio = length * spacing / layer_volume.max(1e-300);
        let stretch = if (ratio - 1.0).abs() < SAME_VOLUME {
            1.0
        } else {
            ratio
        };
        for contour in &contours {
            for s in rows.seeds(contour, stretch, &mut carry) {
                let mut guess = contour.point_at(s);
                for &(axis, position) in plan.mirrors.planes() {
                    if (guess[axis] - position).abs() < 1e-9 * spacing {
                        guess[axis] = position;
                    }
                }
                let point = project(plan.shape, &guess, level, plan.tolerance).unwrap_or(guess);
                cloud.push(point, layer as u32, Lock::Level(level), volume);
            }
        }
    }
    cloud
}

/// Lattice points projected onto the level surfaces.
fn in_space<const D: usize>(plan: &Plan<'_, D>) -> Result<Cloud<D>, PackError> {
    let spacing = plan.options.spacing;
    let volume = spacing.powi(D as i32);
    let mut origin = plan.options.anchor;
    for &(axis, position) in plan.mirrors.planes() {
        let place = (position - origin[axis]) / spacing;
        let on_site = ((place - place.floor()) - 0.5).abs() < 1e-6;
        origin[axis] = if on_site {
            position - 0.5 * spacing
        } else {
            position
        };
    }
    let grid = Grid {
        origin,
        step: spacing,
    };
    let deep = -(plan.options.layers as f64) * spacing;
    let band = grid.band(plan.shape, &plan.bounds, (deep, 0.0), spacing)?;
    let sheets = Sheets {
        shape: plan.shape,
        mirrors: &plan.mirrors,
        grid,
        band: &band,
        tolerance: plan.tolerance,
    };
    let mut cloud = Cloud::default();
    let mut carry = 0.0;
    for (layer, layer_volume) in plan.layer_volumes().into_iter().enumerate() {
        let level = plan.level(layer);
        let wanted = layer_volume / volume + carry;
        let points = sheets.seeds(level, wanted);
        carry = wanted - points.iter().map(|p| sheets.weight(p)).sum::<f64>();
        for point in points {
            cloud.push(point, layer as u32, Lock::Level(level), volume);
        }
    }
    Ok(cloud)
}
