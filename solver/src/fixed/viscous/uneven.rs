//! What gas that changes along a face carries through it beyond what the gas at its middle would.
//!
//! The mean of a product over a face is the product of the means and what its factors vary together. Sheared gas takes its momentum through
//! faces askew to a layer that way, `len^2 / 12 rho u'^2` of it, as much as the friction on the wall once cells are as large as
//! `sqrt(nu / u')`; where all faces are as long it cancels but for the layer's bend, along a wall that cuts cells it does not.

use super::super::calmness::smoothness;
use super::super::net::FaceShape;
use super::super::slopes::Slopes;
use super::super::state::{Conserved, Primitive, dot};
use super::Viscous;

/// Flux through a face between two cells, from the first to the second, of what their states vary along it: none in shocks.
pub fn uneven<const D: usize>(
    viscous: &Viscous,
    states: [&Primitive<D>; 2],
    slopes: [&Slopes<D>; 2],
    shape: &FaceShape<D>,
) -> Conserved<D> {
    let calm = smoothness(slopes[0].calmness.min(slopes[1].calmness));
    let mut sum = Conserved::ZERO;
    if calm <= 0.0 {
        return sum;
    }
    let mut middle = Primitive::ZERO.plus(0.5, states[0]).plus(0.5, states[1]);
    let mut along = [Primitive::ZERO; D];
    for (axis, along) in along.iter_mut().enumerate() {
        for cell in slopes {
            *along = along.plus(0.5, &cell.along[axis]);
        }
        middle = middle.plus(shape.skew[axis], along);
    }
    // About an axis the weight holds the length in the plane of rings.
    let face = shape.weight * dot(&shape.apart, &shape.apart).sqrt();
    let square = if D == 3 { face } else { face * face };
    for way in ways(&shape.area.map(|a| a / shape.size)) {
        if way == [0.0; D] {
            continue;
        }
        let mut change = Primitive::ZERO;
        for axis in 0..D {
            change = change.plus(way[axis], &along[axis]);
        }
        let more = together(viscous, &middle, &change, &shape.area);
        sum = sum.plus(calm * square / 12.0, &more);
    }
    sum
}

/// Ways along a face across the unit `normal`, the sum of whose products is that of a basis: the one that there is in the plane, in space the
/// axes without what they have of the normal.
fn ways<const D: usize>(normal: &[f64; D]) -> [[f64; D]; D] {
    let mut ways = [[0.0; D]; D];
    if D == 2 {
        ways[0][0] = -normal[1];
        ways[0][1] = normal[0];
        return ways;
    }
    for (k, way) in ways.iter_mut().enumerate() {
        for axis in 0..D {
            let own = if axis == k { 1.0 } else { 0.0 };
            way[axis] = own - normal[k] * normal[axis];
        }
    }
    ways
}

/// Second derivative of the flux of a state that goes on by `change`, halved: of `rho u`, `rho u u` and `(rho h + rho u^2 / 2) u`.
fn together<const D: usize>(
    viscous: &Viscous,
    state: &Primitive<D>,
    change: &Primitive<D>,
    area: &[f64; D],
) -> Conserved<D> {
    let through = dot(&state.velocity, area);
    let more = dot(&change.velocity, area);
    let mass = change.density * more;
    let mut momentum = [0.0; D];
    for k in 0..D {
        momentum[k] = state.velocity[k] * mass
            + change.velocity[k] * (state.density * more + through * change.density);
    }
    let along = dot(&state.velocity, &change.velocity);
    let kinetic = 0.5 * dot(&state.velocity, &state.velocity) * mass
        + along * (state.density * more + through * change.density)
        + 0.5 * state.density * through * dot(&change.velocity, &change.velocity);
    Conserved {
        mass,
        momentum,
        energy: viscous.enthalpy_change(state, change) * more + kinetic,
    }
}
