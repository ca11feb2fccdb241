//! How the gas changes about a cell: least squares over its neighbours, and how strong the shocks are that it is in.

use super::equation_of_state::EquationOfState;
use super::net::{Block, Net};
use super::slopes::Slopes;
use super::state::{Primitive, dot};
use super::viscous::{Viscous, add_reaches};

/// Ratio of the densities of neighbours below which the thinner one is the edge of a vacuum: no shock compresses gas so much.
const THIN: f64 = 0.03;

/// What a block's sweep over its faces gives for each cell.
struct Sums<const D: usize> {
    slopes: Slopes<D>,
    /// Sum of wave speed times area.
    reach: f64,
    sound: f64,
}

/// Slopes of the cells of `block`, `grad q = M^-1 sum_j w d (q_j - q_i)`, with `w` the area of a face over its length `d`, so that slivers
/// count as little as they are; images behind walls and known sides count as neighbours. Exact for linear states; of viscous gas for linear
/// temperatures in place of densities, whose profile through a layer at a cold wall is far from straight.
///
/// Returns the least of `V / L` over the cells, `L` the sum of `(|u.n| + a) A` over all faces, and of what viscosity adds to it.
pub fn slopes<G: EquationOfState, const D: usize>(
    gas: &G,
    net: &Net<D>,
    block: &Block<D>,
    states: &[Primitive<D>],
    viscous: Option<(&Viscous, &[f64])>,
    results: &mut [Slopes<D>],
) -> f64 {
    let start = block.cells.start;
    let mut sums: Vec<Sums<D>> = block
        .cells
        .clone()
        .map(|i| Sums {
            slopes: Slopes::LEVEL,
            reach: 0.0,
            sound: gas
                .sound_square(states[i].density, states[i].pressure)
                .sqrt(),
        })
        .collect();
    for face in &block.faces {
        let shape = &net.face_shapes[face.shape as usize];
        let (i, j) = (face.i as usize, face.j as usize);
        let (first, second) = (&states[i], &states[j]);
        let rise = second.plus(-1.0, first);
        let warming = viscous.map(|_| second.heat() - first.heat());
        let weight = shape.apart.map(|d| d * shape.weight);
        let ratio = calmness(first, second);
        for (number, state) in [(i, first), (j, second)] {
            if let Some(sums) = sums.get_mut(number.wrapping_sub(start)) {
                sums.add(&in_heat(rise, warming, state), &weight);
                sums.slopes.calmness = sums.slopes.calmness.min(ratio);
                sums.reach += dot(&state.velocity, &shape.area).abs() + sums.sound * shape.size;
            }
        }
    }
    for wall in &block.walls {
        let cell = &states[wall.i as usize];
        let rise = wall.beyond(gas, cell).plus(-1.0, cell);
        let warming = viscous.map(|_| wall.heat_beyond(gas, cell) - cell.heat());
        let sums = &mut sums[wall.i as usize - start];
        sums.add(&in_heat(rise, warming, cell), &wall.image.weight());
        sums.meet(cell, &wall.image);
    }
    for side in &block.sides {
        let cell = &states[side.i as usize];
        let sums = &mut sums[side.i as usize - start];
        if let Some(image) = side.known(gas, cell) {
            let warming = viscous.map(|_| image.heat() - cell.heat());
            let rise = image.plus(-1.0, cell);
            sums.add(&in_heat(rise, warming, cell), &side.image.weight());
        }
        sums.meet(cell, &side.image);
    }
    if let Some((viscous, viscosities)) = viscous {
        add_reaches(viscous, net, block, states, viscosities, |i, reach| {
            sums[i - start].reach += reach;
        });
    }
    let mut least = f64::INFINITY;
    for ((sums, i), result) in sums.iter().zip(block.cells.clone()).zip(results) {
        let shape = net.cell(i);
        least = least.min(shape.volume / sums.reach);
        let mut along = [Primitive::ZERO; D];
        for a in 0..D {
            for b in 0..D {
                along[a] = along[a].plus(shape.inverse[(a, b)], &sums.slopes.along[b]);
            }
        }
        *result = Slopes {
            along,
            calmness: sums.slopes.calmness,
        };
    }
    least
}

/// The `rise` from the cell of a `state` to a neighbour, whose `p / rho` is more by `warming` where that is what is to be straight: the
/// density's is what goes with it.
#[inline(always)]
fn in_heat<const D: usize>(
    rise: Primitive<D>,
    warming: Option<f64>,
    state: &Primitive<D>,
) -> Primitive<D> {
    let Some(warming) = warming else {
        return rise;
    };
    Primitive {
        density: (rise.pressure - state.density * warming) / state.heat(),
        ..rise
    }
}

/// Ratio of the pressures of neighbours, the lower one over the higher; [`Slopes::CAREFUL`] at the edge of a vacuum, which slopes would draw more gas
/// out of than there is.
#[inline(always)]
fn calmness<const D: usize>(first: &Primitive<D>, second: &Primitive<D>) -> f64 {
    let ratio = first.pressure.min(second.pressure) / first.pressure.max(second.pressure);
    let is_edge = || first.density.min(second.density) < THIN * first.density.max(second.density);
    if ratio < THIN && is_edge() {
        Slopes::<D>::CAREFUL
    } else {
        ratio
    }
}

impl<const D: usize> Sums<D> {
    #[inline(always)]
    fn add(&mut self, rise: &Primitive<D>, weight: &[f64; D]) {
        for (along, weight) in self.slopes.along.iter_mut().zip(weight) {
            *along = along.plus(*weight, rise);
        }
    }

    fn meet(&mut self, cell: &Primitive<D>, image: &super::image::Image<D>) {
        let speed = dot(&cell.velocity, &image.normal).abs();
        self.reach += (speed + self.sound) * image.size;
    }
}
