//! What flows near a sharp concave bend in the plane: cells that the shock there runs through hold gas of both its sides, and each part of a
//! face lets through what is on its side.
//!
//! Where cells hold what they would by a straight shock, gas on both sides of a face is the same, part by part, and nothing but the shock stands there.

use super::attached::{AttachedShock, nearness};
use super::bent::{Layout, shifted};
use super::equation_of_state::EquationOfState;
use super::hll::Jump;
use super::hollow::{Hollow, HollowFace, HollowWall};
use super::net::Block;
use super::sides::pushed;
use super::slopes::Flow;
use super::state::{Conserved, dot};

/// So far from a cell, in spacings, lie the middles of those that its slopes are drawn from, at most.
const SLOPES: f64 = 1.5;

/// A shock that stands at a bend, and what is around it.
pub struct Cleaving<'a, const D: usize> {
    shock: AttachedShock<D>,
    hollow: &'a Hollow<D>,
    /// The part of each cell that is in front of it.
    parts: Vec<f64>,
}

/// The shocks that stand at the concave bends of a block.
pub fn shocks<'a, G: EquationOfState, const D: usize>(
    gas: &G,
    block: &'a Block<D>,
    flow: Flow<'_, D>,
) -> Vec<Cleaving<'a, D>> {
    let stands = |hollow: &'a Hollow<D>| {
        let bend = &hollow.bend;
        let shock = AttachedShock::new(gas, &bend.front(flow.states), bend)?;
        let parts: Vec<f64> = (hollow.cells.iter())
            .map(|cell| cell.part(&shock.normal))
            .collect();
        Some(Cleaving {
            shock,
            hollow,
            parts,
        })
    };
    block.hollows.iter().filter_map(stands).collect()
}

/// Adds to what the cells of a block gain what the faces around its concave bends let through more than the `usual` flux, face by face.
pub fn part<G: EquationOfState, const D: usize>(
    gas: &G,
    shocks: &[Cleaving<'_, D>],
    Layout { net, block, .. }: Layout<'_, D>,
    flow: Flow<'_, D>,
    cells: &mut [Conserved<D>],
    usual: &[Conserved<D>],
) {
    let start = block.cells.start;
    for cleaving in shocks {
        for seen in &cleaving.hollow.faces {
            let face = &block.faces[seen.number as usize];
            let size = net.face_shapes[face.shape as usize].size;
            let usual = &usual[seen.number as usize];
            let pair = [face.i as usize, face.j as usize];
            let Some(more) = cleaving.more(gas, seen, pair, size, flow, usual) else {
                continue;
            };
            for (i, sign) in [(face.i, -1.0), (face.j, 1.0)] {
                if let Some(cell) = cells.get_mut((i as usize).wrapping_sub(start)) {
                    *cell = cell.plus(sign, &more);
                }
            }
        }
    }
}

/// Lets the shocks say what presses on the walls of a block behind them, whose usual `pressures` are given.
pub fn press<G: EquationOfState, const D: usize>(
    gas: &G,
    shocks: &[Cleaving<'_, D>],
    block: &Block<D>,
    flow: Flow<'_, D>,
    pressures: &mut [f64],
) {
    for cleaving in shocks {
        for seen in cleaving.hollow.walls.iter().filter(|wall| wall.is_behind) {
            let wall = &block.walls[seen.number as usize];
            let face = (wall.i as usize, &wall.image.normal);
            if let Some((pressure, weight)) = cleaving.pressure(gas, seen, face, flow) {
                let usual = &mut pressures[seen.number as usize];
                *usual += weight * (pressure - *usual);
            }
        }
    }
}

/// What the cells of a block gain, and all of them, where the shocks say what presses on mirrors.
pub fn reflect<G: EquationOfState, const D: usize>(
    gas: &G,
    shocks: &[Cleaving<'_, D>],
    block: &Block<D>,
    flow: Flow<'_, D>,
    cells: &mut [Conserved<D>],
) -> Conserved<D> {
    let mut all = Conserved::ZERO;
    for cleaving in shocks {
        for seen in &cleaving.hollow.mirrors {
            let side = &block.sides[seen.number as usize];
            let i = side.i as usize;
            let normal = &side.image.normal;
            if let Some((pressure, weight)) = cleaving.pressure(gas, seen, (i, normal), flow) {
                let usual = side.flux(gas, &flow.states[i], &flow.slopes[i], None);
                let more = pushed(pressure, normal).plus(-1.0, &usual);
                let gain = Conserved::ZERO.plus(-weight * side.image.size, &more);
                let cell = &mut cells[i - block.cells.start];
                *cell = cell.plus(1.0, &gain);
                all = all.plus(1.0, &gain);
            }
        }
    }
    all
}

impl<const D: usize> Cleaving<'_, D> {
    /// What flows through a face of this `size` between two cells more than the `usual` flux.
    fn more<G: EquationOfState>(
        &self,
        gas: &G,
        seen: &HollowFace<D>,
        cells: [usize; 2],
        size: f64,
        flow: Flow<'_, D>,
        usual: &Conserved<D>,
    ) -> Option<Conserved<D>> {
        // Where all is on one side, cells know it.
        let parts = seen.cells.map(|cell| self.parts[cell as usize]);
        let is_whole = |part: f64| part <= 0.0 || part >= 1.0;
        if parts[0] == parts[1] && is_whole(parts[0]) {
            return None;
        }
        // Cells of first order are left alone.
        let near = nearness(seen.away);
        if near <= 0.0 || cells.iter().any(|&i| flow.slopes[i].calmness < 0.0) {
            return None;
        }
        let shock = &self.shock;
        let part = seen.piece.part(&shock.normal);
        let own = cells.map(|i| &flow.states[i]);
        let known = parts.map(|part| shock.mean(gas, part));
        let agreement = |k: usize| shock.agreement(own[k], &known[k]);
        let weight = near * shock.share * agreement(0).min(agreement(1));
        if weight <= 0.0 {
            return None;
        }
        let mut flux = Conserved::ZERO;
        for (there, part) in [(&shock.front, part), (&shock.rear, 1.0 - part)] {
            if part > 0.0 {
                let [left, right] = [0, 1].map(|k| shifted(own[k], &known[k], there));
                let jump = Jump::new(gas, left, right, seen.piece.normal);
                flux = flux.plus(part * size, &jump.hllc());
            }
        }
        let more = flux.plus(-1.0, usual);
        Some(Conserved::ZERO.plus(weight, &more))
    }

    /// Pressure on a wall or a mirror with this `normal`, and how far that is to be believed, where the slopes of its cell see the shock.
    fn pressure<G: EquationOfState>(
        &self,
        gas: &G,
        seen: &HollowWall,
        (i, normal): (usize, &[f64; D]),
        flow: Flow<'_, D>,
    ) -> Option<(f64, f64)> {
        let shock = &self.shock;
        let near = nearness(seen.away);
        let cell = &self.hollow.cells[seen.cell as usize];
        // Farther from the shock slopes know nothing of it.
        let reach = cell.radius + SLOPES * self.hollow.bend.unit;
        if near <= 0.0 || flow.slopes[i].calmness < 0.0 || cell.height(&shock.normal).abs() >= reach
        {
            return None;
        }
        let own = &flow.states[i];
        let known = shock.mean(gas, self.parts[seen.cell as usize]);
        let weight = near * shock.share * shock.agreement(own, &known);
        let there = if seen.is_behind {
            &shock.rear
        } else {
            &shock.front
        };
        let there = shifted(own, &known, there);
        let speed = dot(&there.velocity, normal);
        Some((
            gas.wall_pressure(there.density, there.pressure, speed),
            weight,
        ))
    }
}
