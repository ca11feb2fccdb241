//! Conforming fluid around bodies at the start: where it may be asked for.

use aero_geometry::Vector;
use aero_packer::Packing;

use super::error::SceneError;

use aero_solver::problem::{Body, Domain, PackedFluid, Side, side_name};

/// Conforming layers around a body that asks for packed fluid; the packer leads over from there
/// into the lattice.
pub(super) const LAYERS: usize = 3;

/// Packed particles nearer than this, in spacings, to a side that is not open would feel what is
/// beyond it.
const NEAR: f64 = 0.75;

/// The same for a side that is a mirror plane of the body, about which the packing is symmetric
/// too: only a particle on it, which its own image would double, does harm.
const NEAR_MIRROR: f64 = 0.25;

/// The fluid of a packing, if it has any.
pub(super) fn fluid<const D: usize>(packing: &Packing<D>) -> Option<PackedFluid<D>> {
    Some(PackedFluid {
        position: packing.fluid.position.clone(),
        lattice_begins: packing.lattice_begins?,
    })
}

/// Refuses packed fluid that another body or a closed side would cut.
pub(super) fn check<const D: usize>(
    bodies: &[Body<D>],
    domain: &Domain<D>,
    spacing: f64,
) -> Result<(), SceneError> {
    for (number, body) in bodies.iter().enumerate() {
        let Some(packed) = &body.packed_fluid else {
            continue;
        };
        let refuse = |met: String| {
            let message = format!("its packed fluid would {met}, or leave `packed_fluid` off");
            Err(SceneError::body(&body.name, message))
        };
        let grown = domain.bounds.grown(spacing);
        let inside: Vec<&Vector<D>> = packed
            .position
            .iter()
            .filter(|p| grown.contains(p))
            .collect();
        if let Some(side) = side_met(&inside, body, domain, spacing) {
            return refuse(format!(
                "meet the side `{side}`, for which it is not laid; move the body or the side"
            ));
        }
        for (_, other) in bodies.iter().enumerate().filter(|&(n, _)| n != number) {
            let least = other.starting_distance(spacing);
            let reach = other.shape.bounds().grown(least);
            let near = |p: &&Vector<D>| reach.contains(p) && other.shape.signed_distance(p) < least;
            if inside.iter().any(near) {
                let name = &other.name;
                return refuse(format!("reach into that of body `{name}`; move them apart"));
            }
        }
    }
    Ok(())
}

/// The first side, other than an open one or one that bodies close, that particles come near to.
fn side_met<const D: usize>(
    particles: &[&Vector<D>],
    body: &Body<D>,
    domain: &Domain<D>,
    spacing: f64,
) -> Option<String> {
    let planes = body.shape.mirror_planes();
    for axis in 0..D {
        for end in 0..2 {
            let side = domain.sides[axis][end];
            let open = [Side::Inlet, Side::Outlet, Side::FreeStream, Side::Body];
            let at = [domain.bounds.min[axis], domain.bounds.max[axis]][end];
            let near = if planes.contains(&(axis, at)) {
                NEAR_MIRROR
            } else {
                NEAR
            };
            let met = |p: &&Vector<D>| (p[axis] - at).abs() < near * spacing;
            if !open.contains(&side) && particles.iter().any(met) {
                return Some(side_name(axis, end));
            }
        }
    }
    None
}
