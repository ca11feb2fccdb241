//! What flows near a sharp bend: states are drawn out to faces along the fan that stands there.
//!
//! At the bend all states of the fan meet in a point, and at any spacing the first cells hold much of it at once: no slope between them tells what is on
//! their faces. How the cells differ from the fan does: where they do not, gas on both sides of a face is that of the fan there, and nothing else disturbs it.

use aero_geometry::Vector;

use super::bend::{Bend, BentFace, BentWall, Surroundings};
use super::equation_of_state::EquationOfState;
use super::face_list::Join;
use super::fan::Fan;
use super::hll::Jump;
use super::net::{BLOCK, Block, FaceShape, Net};
use super::quiet::Rest;
use super::slopes::Flow;
use super::state::{Conserved, Primitive, dot};
use super::walls::Wall;

/// Places, in halves of a face, and weights of Gauss's quadrature of three points.
const GAUSS: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 18.0),
    (0.0, 8.0 / 18.0),
    (0.774_596_669_241_483_4, 5.0 / 18.0),
];

/// A fan that stands at a bend, and what is around it.
pub struct Standing<'a, const D: usize> {
    fan: Fan<D>,
    bend: &'a Bend<D>,
    around: &'a Surroundings<D>,
}

/// The fans that stand at the bends of a block.
pub fn fans<'a, G: EquationOfState, const D: usize>(
    gas: &G,
    block: &'a Block<D>,
    flow: Flow<'_, D>,
) -> Vec<Standing<'a, D>> {
    let each = block.bends.iter();
    let bends = each.flat_map(|around| around.bends.iter().map(move |bend| (bend, around)));
    bends
        .filter_map(|(bend, around)| {
            let fan = Fan::new(gas, &bend.front(flow.states), bend)?;
            Some(Standing { fan, bend, around })
        })
        .collect()
}

/// Where the cells of a block are, and what its faces look like.
#[derive(Clone, Copy)]
pub struct Layout<'a, const D: usize> {
    /// All faces.
    pub net: &'a Net<D>,
    /// The block.
    pub block: &'a Block<D>,
    /// The points of all cells.
    pub points: &'a [Vector<D>],
    /// Which blocks rest.
    pub rests: &'a [Rest<D>],
}

impl<const D: usize> Layout<'_, D> {
    /// True of a `face` to a cell that sleeps. No law of waves counts there: the cell would know nothing of what came through.
    pub fn is_to_sleepers(&self, face: &Join) -> bool {
        let mut cells = [face.i, face.j].into_iter();
        cells.any(|i| self.rests[i as usize / BLOCK].sleeps)
    }
}

/// Adds to what the cells of a block gain what the faces around its bends let through more than the `fluxes` so far, face by face, and to these.
pub fn turn<G: EquationOfState, const D: usize>(
    gas: &G,
    fans: &[Standing<'_, D>],
    layout: Layout<'_, D>,
    flow: Flow<'_, D>,
    cells: &mut [Conserved<D>],
    fluxes: &mut [Conserved<D>],
) {
    let Layout {
        net, block, points, ..
    } = layout;
    let start = block.cells.start;
    for standing in fans {
        for &number in &standing.around.faces {
            let face = &block.faces[number as usize];
            if layout.is_to_sleepers(face) {
                continue;
            }
            let shape = &net.face_shapes[face.shape as usize];
            let bent = standing.bend.face(points, face, shape);
            let flux = &mut fluxes[number as usize];
            let Some(more) = standing.more(gas, &bent, (face, shape), flow, flux) else {
                continue;
            };
            *flux = flux.plus(1.0, &more);
            for (i, sign) in [(face.i, -1.0), (face.j, 1.0)] {
                if let Some(cell) = cells.get_mut((i as usize).wrapping_sub(start)) {
                    *cell = cell.plus(sign, &more);
                }
            }
        }
    }
}

/// Lets the fans say what presses on the walls of a block, whose usual `pressures` are given.
pub fn press<G: EquationOfState, const D: usize>(
    gas: &G,
    fans: &[Standing<'_, D>],
    Layout { block, points, .. }: Layout<'_, D>,
    flow: Flow<'_, D>,
    pressures: &mut [f64],
) {
    for Standing { fan, bend, around } in fans {
        for &number in &around.walls {
            let wall = &block.walls[number as usize];
            let pressure = &mut pressures[number as usize];
            let bent = bend.wall(&points[wall.i as usize], &wall.foot);
            *pressure = bent.pressure(gas, fan, wall, flow, *pressure);
        }
    }
}

/// So far from a cell, in spacings, lie the middles of those that its slopes are drawn from, at most.
const SLOPES: f64 = 1.5;

/// Most places on a face.
const MOST: usize = GAUSS.len() * GAUSS.len();

/// Places on a face, in halves of it each way, and what of it each stands for; where the second half is nothing, along the first alone.
fn quadrature<const D: usize>(
    middle: &[f64; D],
    [first, second]: &[[f64; D]; 2],
) -> ([[f64; D]; MOST], [f64; MOST], usize) {
    let rows: &[(f64, f64)] = if second.iter().all(|part| *part == 0.0) {
        &[(0.0, 1.0)]
    } else {
        &GAUSS
    };
    let (mut places, mut parts, mut count) = ([*middle; MOST], [0.0; MOST], 0);
    for (b, row) in rows {
        for (a, part) in GAUSS {
            for k in 0..D {
                places[count][k] += a * first[k] + b * second[k];
            }
            parts[count] = part * row;
            count += 1;
        }
    }
    (places, parts, count)
}

impl<const D: usize> Standing<'_, D> {
    /// What flows through a face more than the `usual` flux.
    fn more<G: EquationOfState>(
        &self,
        gas: &G,
        bent: &BentFace<D>,
        (face, shape): (&Join, &FaceShape<D>),
        flow: Flow<'_, D>,
        usual: &Conserved<D>,
    ) -> Option<Conserved<D>> {
        let fan = &self.fan;
        let near = fan.nearness(bent.away);
        // Cells of first order are left alone.
        let cells = [face.i as usize, face.j as usize];
        if near <= 0.0 || cells.iter().any(|&i| flow.slopes[i].calmness < 0.0) {
            return None;
        }
        let (places, parts, count) = quadrature(&bent.middle, &self.bend.halves(shape));
        let places = &places[..count];
        if fan.is_even(bent.points.iter().chain(places)) {
            return None;
        }
        let own = cells.map(|i| &flow.states[i]);
        let known = bent.points.map(|point| fan.state(fan.elevation(&point)));
        let agreement = |k: usize| fan.agreement(gas, own[k], &known[k]);
        let weight = near * fan.share * agreement(0).min(agreement(1));
        if weight <= 0.0 {
            return None;
        }
        let normal = shape.area.map(|part| part / shape.size);
        let mut flux = Conserved::ZERO;
        for (place, part) in places.iter().zip(parts) {
            let there = fan.state(fan.elevation(place));
            let [left, right] = [0, 1].map(|k| shifted(own[k], &known[k], &there));
            let jump = Jump::new(gas, left, right, normal);
            flux = flux.plus(part * shape.size, &jump.hllc());
        }
        let more = flux.plus(-1.0, usual);
        Some(Conserved::ZERO.plus(weight, &more))
    }
}

impl<const D: usize> BentWall<D> {
    /// Pressure on the wall, where it would be `usual` elsewhere.
    fn pressure<G: EquationOfState>(
        &self,
        gas: &G,
        fan: &Fan<D>,
        wall: &Wall<D>,
        flow: Flow<'_, D>,
        usual: f64,
    ) -> f64 {
        let i = wall.i as usize;
        let near = fan.nearness(self.away);
        let places = [self.point, self.middle];
        // In space gas keeps its slopes that is so far ahead of the fan that the cells behind it, which they are drawn from, know nothing of it either.
        let farther = || places.map(|place| fan.onwards_from(&place, SLOPES * self.unit));
        let is_ahead = D == 3 && fan.is_behind(farther().iter());
        if near <= 0.0 || flow.slopes[i].calmness < 0.0 || is_ahead {
            return usual;
        }
        let own = &flow.states[i];
        let [from, to] = places.map(|place| fan.state(fan.elevation(&place)));
        let weight = near * fan.share * fan.agreement(gas, own, &from);
        let there = shifted(own, &from, &to);
        let speed = dot(&there.velocity, &wall.image.normal);
        let pressure = gas.wall_pressure(there.density, there.pressure, speed);
        usual + weight * (pressure - usual)
    }
}

/// A state that is `own` where the fan has `from`, seen where it has `to`: as far from the fan as there. Where density or pressure fall, in
/// proportion, so that something is left.
pub fn shifted<const D: usize>(
    own: &Primitive<D>,
    from: &Primitive<D>,
    to: &Primitive<D>,
) -> Primitive<D> {
    let moved = |own: f64, from: f64, to: f64| {
        if to > from {
            own + (to - from)
        } else {
            own * (to / from)
        }
    };
    let mut velocity = own.velocity;
    for k in 0..D {
        velocity[k] += to.velocity[k] - from.velocity[k];
    }
    Primitive {
        density: moved(own.density, from.density, to.density),
        velocity,
        pressure: moved(own.pressure, from.pressure, to.pressure),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(density: f64, velocity: [f64; 2], pressure: f64) -> Primitive<2> {
        Primitive {
            density,
            velocity,
            pressure,
        }
    }

    /// Two cells that are as the fan has them agree on what is on their face; two that are off by the same in velocity do as well.
    #[test]
    fn cells_of_the_fan_meet_on_their_face_without_a_jump() {
        let known = [state(1.0, [2.0, 0.0], 0.7), state(0.4, [2.4, -0.6], 0.2)];
        let there = state(0.6, [2.3, -0.3], 0.35);
        for own in known {
            let seen = shifted(&own, &own, &there);
            assert!((seen.density - there.density).abs() < 1e-15);
            assert!((seen.velocity[0] - there.velocity[0]).abs() < 1e-15);
            assert!((seen.velocity[1] - there.velocity[1]).abs() < 1e-15);
            assert!((seen.pressure - there.pressure).abs() < 1e-15);
        }
        let seen = known.map(|known| {
            let own = known.plus(1.0, &state(0.0, [0.1, 0.2], 0.0));
            shifted(&own, &known, &there).velocity
        });
        for k in 0..2 {
            assert!((seen[0][k] - seen[1][k]).abs() < 1e-15);
        }
    }

    /// Whatever a cell holds, something is left of it where the fan is thinner, and no more of its departure is seen where the fan is
    /// denser: the departure of a thin cell, times what it grows by in dense gas, would keep the flow from coming to rest.
    #[test]
    fn departures_from_the_fan_neither_grow_nor_leave_nothing() {
        let (dense, thin) = (state(1.0, [2.0, 0.0], 0.7), state(0.1, [2.4, -0.6], 0.03));
        let seen = shifted(&state(0.05, [2.0, 0.0], 0.01), &dense, &thin);
        assert!(seen.density > 0.0 && seen.pressure > 0.0, "{seen:?}");
        let more = state(0.13, [2.4, -0.6], 0.05);
        let seen = shifted(&more, &thin, &dense);
        assert!((seen.density - dense.density - 0.03).abs() < 1e-15);
        assert!((seen.pressure - dense.pressure - 0.02).abs() < 1e-15);
    }
}
