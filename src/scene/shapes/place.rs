//! Where a body stands.

use aero_geometry::Placement;
use serde::Deserialize;

use super::super::number::{Finite, Positive};
use super::super::spin::Rotation;
use super::super::vector::vector;

/// `place`: scaled about the origin, then turned about it, then shifted.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaceEntry {
    /// Factor on all lengths.
    pub scale: Option<Positive>,
    /// Turn: degrees in 2D, axis and degrees in 3D.
    pub rotate: Option<Rotation>,
    /// Shift.
    pub translate: Option<Vec<Finite>>,
}

/// Where a plane body stands.
pub(super) fn place_in_plane(place: Option<&PlaceEntry>) -> Result<Placement<2>, String> {
    let Some(place) = place else {
        return Ok(Placement::default());
    };
    let mut placement = scaled(place)?;
    match &place.rotate {
        None => {}
        Some(Rotation::Plane(degrees)) => placement = placement.rotated(degrees.to_radians()),
        Some(Rotation::Axis { .. }) => {
            return Err("`place.rotate` is a number of degrees in dimension 2".into());
        }
    }
    moved(placement, place)
}

/// Where a body in space stands.
pub(super) fn place_in_space(place: Option<&PlaceEntry>) -> Result<Placement<3>, String> {
    let Some(place) = place else {
        return Ok(Placement::default());
    };
    let mut placement = scaled(place)?;
    match &place.rotate {
        None => {}
        Some(Rotation::Axis { axis, angle }) => {
            let axis = vector("place.rotate.axis", axis).map_err(|error| error.to_string())?;
            placement = placement
                .rotated_about(&axis, angle.to_radians())
                .map_err(|error| error.to_string())?;
        }
        Some(Rotation::Plane(_)) => {
            return Err(
                "`place.rotate` is `{ axis = [..], angle = degrees }` in dimension 3".into(),
            );
        }
    }
    moved(placement, place)
}

fn scaled<const D: usize>(place: &PlaceEntry) -> Result<Placement<D>, String> {
    match place.scale {
        None => Ok(Placement::default()),
        Some(factor) => Placement::default()
            .scaled(factor.get())
            .map_err(|error| error.to_string()),
    }
}

fn moved<const D: usize>(
    placement: Placement<D>,
    place: &PlaceEntry,
) -> Result<Placement<D>, String> {
    match &place.translate {
        None => Ok(placement),
        Some(numbers) => vector("place.translate", numbers)
            .map(|offset| placement.moved(offset))
            .map_err(|error| error.to_string()),
    }
}
