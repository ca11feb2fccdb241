//! Halves of bodies, which end at a mirror, made whole.
//!
//! A file of half a model has a face in the plane of symmetry or is open there, and by the rounding of its numbers it ends a little before
//! the plane or beyond it. The mirror shows the other half: that is joined to it here, and what lies in the plane is left out.

use std::collections::HashMap;

use crate::stl::Facet;
use crate::{Bounds, MirrorPlane, Vector};

/// What ends this near to a plane, in parts of a body's size, ends in it: numbers of single precision are off by a hundredth of that.
pub(crate) const ROUNDED: f64 = 1e-5;

/// Those of `planes` that a body of this extent ends in, with how near to a plane is in it; not those of an axis with one at either end, between which a
/// body is a part of a row.
pub(crate) fn ends_in<const D: usize>(
    bounds: &Bounds<D>,
    planes: &[MirrorPlane],
) -> (Vec<MirrorPlane>, f64) {
    let tolerance = ROUNDED * bounds.size().norm();
    let ends = |plane: &&MirrorPlane| {
        let heights = [bounds.min, bounds.max].map(|corner| plane.height(&corner));
        heights[0].min(heights[1]).abs() <= tolerance
    };
    let met: Vec<&MirrorPlane> = planes.iter().filter(ends).collect();
    let is_alone = |plane: &&&MirrorPlane| {
        let others = met.iter().filter(|other| other.axis == plane.axis);
        others.count() == 1
    };
    let planes = met.iter().filter(is_alone).map(|plane| **plane).collect();
    (planes, tolerance)
}

/// False where a body with these corners ends in none of `planes`: it is no half then.
pub fn may_be_half(corners: impl Iterator<Item = Vector<3>>, planes: &[MirrorPlane]) -> bool {
    around(corners).is_some_and(|bounds| !ends_in(&bounds, planes).0.is_empty())
}

/// The box around some places, if there are any.
fn around(places: impl Iterator<Item = Vector<3>>) -> Option<Bounds<3>> {
    let one = places.map(|place| (place, place));
    let all = one.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
    all.map(|(low, high)| Bounds::new(low, high))
}

/// `facets` with their images in those of `planes` that they end in, closed where they meet them; none unless they are half of a body: all on the side that
/// a plane shows, some of them in it, or open along it.
pub fn made_whole(facets: &[Facet], planes: &[MirrorPlane]) -> Option<Vec<Facet>> {
    let corners = facets.iter().flatten().copied();
    let (planes, tolerance) = ends_in(&around(corners)?, planes);
    planes.iter().fold(None, |whole, plane| {
        let half = whole.as_deref().unwrap_or(facets);
        joined(half, plane, tolerance).or(whole)
    })
}

/// The body of which `facets` are one half and the other lies beyond their highest place on an axis, or their lowest; none where nothing of them ends there in
/// a face or an opening.
pub fn whole_from_half(facets: &[Facet], axis: usize, beyond_lowest: bool) -> Option<Vec<Facet>> {
    let bounds = around(facets.iter().flatten().copied())?;
    let end = if beyond_lowest {
        bounds.min
    } else {
        bounds.max
    };
    let plane = MirrorPlane {
        axis,
        position: end[axis],
        shows_above: beyond_lowest,
    };
    made_whole(facets, &[plane])
}

/// The same at one plane, which all facets are above.
fn joined(facets: &[Facet], plane: &MirrorPlane, tolerance: f64) -> Option<Vec<Facet>> {
    let snapped = |corner: &Vector<3>| {
        let mut corner = *corner;
        if plane.height(&corner).abs() <= tolerance {
            corner[plane.axis] = plane.position;
        }
        corner
    };
    let is_in_plane = |corner: &Vector<3>| corner[plane.axis] == plane.position;
    let all = facets.iter().map(|facet| facet.each_ref().map(snapped));
    let mut half: Vec<Facet> = all.filter(|facet| !facet.iter().all(is_in_plane)).collect();
    let has_face = half.len() < facets.len();
    if !has_face && !is_open_along(&half, is_in_plane) {
        return None;
    }
    let images: Vec<Facet> = half
        .iter()
        .map(|[a, b, c]| [b, a, c].map(|corner| plane.image(*corner)))
        .collect();
    half.extend(images);
    Some(half)
}

/// True where an edge with both ends in the plane belongs to one of the `facets` alone.
fn is_open_along(facets: &[Facet], is_in_plane: impl Fn(&Vector<3>) -> bool) -> bool {
    let mut counts: HashMap<[[u64; 3]; 2], u32> = HashMap::new();
    for facet in facets {
        for n in 0..3 {
            let ends = [facet[n], facet[(n + 1) % 3]];
            if ends.iter().all(&is_in_plane) {
                let mut key = ends.map(|end| [0, 1, 2].map(|k| (end[k] + 0.0).to_bits()));
                key.sort_unstable();
                *counts.entry(key).or_default() += 1;
            }
        }
    }
    counts.values().any(|count| count % 2 == 1)
}
