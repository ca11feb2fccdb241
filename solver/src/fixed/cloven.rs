//! What flows near a sharp concave bend or a tip: cells that a shock there runs through hold gas of both its sides, and each part of a
//! face lets through what is on its side.
//!
//! Where cells hold what they would by straight shocks, gas on both sides of a face is the same, part by part, and nothing but the shocks stands there.

use super::attached::{AttachedShock, FELT, farthest, mean, nearness};
use super::bent::{Layout, shifted};
use super::cone_cells;
use super::equation_of_state::EquationOfState;
use super::hll::Jump;
use super::net::Block;
use super::outline_piece::Sector;
use super::root::{Plan, Root, RootFace, RootWall};
use super::sides::pushed;
use super::slopes::Flow;
use super::state::{Conserved, Primitive, dot};

/// So far from a cell, in spacings, lie the middles of those that its slopes are drawn from, at most.
const SLOPES: f64 = 1.5;

/// So far from the tip of a cone, in spacings, gas changes from cell to cell by more than slopes tell.
const FIELD: f64 = 32.0;

/// As many shocks stand at one place at most: those of a tip.
pub const MOST: usize = 2;

/// What is behind a shock.
pub struct Behind<const D: usize> {
    /// The shock.
    pub shock: AttachedShock<D>,
    /// How far it stands, in spacings.
    pub reach: f64,
    /// Where it is.
    sector: Sector<D>,
    /// Which of the walls that lead away from the root bounds it.
    wall: u8,
}

/// Shocks that stand at a bend or a tip, and what is around it.
pub struct Cleaving<'a, const D: usize> {
    /// Gas in front of all of them.
    pub front: Primitive<D>,
    /// At most [`MOST`].
    pub shocks: Vec<Behind<D>>,
    /// What is around the place.
    pub root: &'a Root<D>,
    /// The parts of each cell that are behind them.
    pub parts: Vec<[f64; MOST]>,
    /// Behind the shock of a cone, what each cell holds where nothing else stands there, with what its rings press outwards with.
    pub(super) field: Vec<Option<(Primitive<D>, f64)>>,
}

/// The shocks that stand at the concave bends and the tips of a block.
pub fn shocks<'a, G: EquationOfState, const D: usize>(
    gas: &G,
    block: &'a Block<D>,
    states: &[Primitive<D>],
) -> Vec<Cleaving<'a, D>> {
    let stands = |root: &'a Root<D>| {
        let front = root.bends[0].front(states);
        let shocks: Vec<Behind<D>> = (0..)
            .zip(&root.bends)
            .filter_map(|(wall, bend)| {
                let shock = if root.apex.is_some() {
                    AttachedShock::at_apex(gas, &front, bend)?
                } else {
                    AttachedShock::new(gas, &front, bend)?
                };
                let rearwards = shock.normal.map(|part| -part);
                // Walls may lie off those that meet in a tip, by rounding or as they bend: the middle of the body parts its sides.
                let over = if root.is_tip() {
                    bend.over()
                } else {
                    rearwards
                };
                let sector = Sector {
                    sides: [rearwards, over],
                };
                Some(Behind {
                    shock,
                    reach: farthest::<D>(),
                    sector,
                    wall,
                })
            })
            .collect();
        // Farther from a shock nothing knows of it, nor does it ask.
        let unit = root.bends[0].unit;
        let is_off = |behind: &Behind<D>| {
            root.is_off(&behind.shock.normal, FELT * unit)
                && (behind.shock.field.is_none() || root.is_beyond(FIELD * unit))
        };
        if shocks.iter().all(is_off) {
            return None;
        }
        let parts = |cell: &Plan<D>| {
            let mut parts = [0.0; MOST];
            for (part, behind) in parts.iter_mut().zip(&shocks) {
                *part = cell.part(&behind.sector);
            }
            parts
        };
        let parts: Vec<[f64; MOST]> = root.cells.iter().map(parts).collect();
        let field = match &shocks[0].shock {
            shock @ AttachedShock {
                field: Some(field), ..
            } => {
                let known = |(cell, parts): (&Plan<D>, &[f64; MOST])| {
                    let is_cut = parts[0] > 0.0 && parts[0] < 1.0;
                    let is_near = is_cut || cell.away() < (FIELD + 2.0) * unit;
                    (parts[0] > 0.0 && is_near)
                        .then(|| cone_cells::mean(gas, &front, shock, field, cell))
                };
                root.cells.iter().zip(&parts).map(known).collect()
            }
            _ => Vec::new(),
        };
        Some(Cleaving {
            front,
            shocks,
            root,
            parts,
            field,
        })
    };
    block.roots.iter().filter_map(stands).collect()
}

/// Adds to what the cells of a block gain what the faces around its concave bends and tips let through more than the `fluxes` so far, face by face, and to these.
pub fn part<G: EquationOfState, const D: usize>(
    gas: &G,
    shocks: &[Cleaving<'_, D>],
    layout: Layout<'_, D>,
    flow: Flow<'_, D>,
    cells: &mut [Conserved<D>],
    fluxes: &mut [Conserved<D>],
) {
    let Layout { net, block, .. } = layout;
    let start = block.cells.start;
    for cleaving in shocks {
        for seen in &cleaving.root.faces {
            let face = &block.faces[seen.number as usize];
            if layout.is_to_sleepers(face) {
                continue;
            }
            let size = net.face_shapes[face.shape as usize].size;
            let flux = &mut fluxes[seen.number as usize];
            let pair = [face.i as usize, face.j as usize];
            let Some(more) = cleaving.more(gas, seen, pair, size, flow, flux) else {
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

/// Lets the shocks say what presses on the walls of a block behind them, whose usual `pressures` are given.
pub fn press<G: EquationOfState, const D: usize>(
    gas: &G,
    shocks: &[Cleaving<'_, D>],
    block: &Block<D>,
    flow: Flow<'_, D>,
    pressures: &mut [f64],
) {
    for cleaving in shocks {
        for seen in cleaving
            .root
            .walls
            .iter()
            .filter(|wall| wall.behind.is_some())
        {
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
        for seen in &cleaving.root.mirrors {
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
    /// What a cell holds where nothing but the shocks stands there.
    fn known<G: EquationOfState>(&self, gas: &G, cell: u32) -> Primitive<D> {
        let parts = self.parts[cell as usize];
        if let Some(Some((known, _))) = self.field.get(cell as usize) {
            return *known;
        }
        if parts[0] >= 1.0 {
            return self.shocks[0]
                .shock
                .rear_at(&self.root.cells[cell as usize].point);
        }
        let mut behind = [(0.0, &self.front); MOST];
        for ((one, part), other) in behind.iter_mut().zip(parts).zip(&self.shocks) {
            *one = (part, &other.shock.rear);
        }
        mean(gas, &self.front, &behind)
    }

    /// What flows through a face of this `size` between two cells more than the `usual` flux.
    fn more<G: EquationOfState>(
        &self,
        gas: &G,
        seen: &RootFace,
        cells: [usize; 2],
        size: f64,
        flow: Flow<'_, D>,
        usual: &Conserved<D>,
    ) -> Option<Conserved<D>> {
        // Where all is on one side, cells know it.
        let parts = seen.cells.map(|cell| self.parts[cell as usize]);
        let is_whole = |part: &f64| *part <= 0.0 || *part >= 1.0;
        let is_cut = parts[0] != parts[1] || !parts[0].iter().all(is_whole);
        if !is_cut && (parts[0][0] <= 0.0 || !self.is_in_field(seen.away)) {
            return None;
        }
        // Cells of first order are left alone.
        if cells.iter().any(|&i| flow.slopes[i].calmness < 0.0) {
            return None;
        }
        let own = cells.map(|i| &flow.states[i]);
        let known = seen.cells.map(|cell| self.known(gas, cell));
        let mut weight = 1.0_f64;
        for (number, Behind { shock, reach, .. }) in self.shocks.iter().enumerate() {
            if parts.iter().any(|part| part[number] > 0.0) {
                let near = nearness(seen.away, *reach);
                let agreement = |k: usize| {
                    let field = shock.field.as_ref().filter(|_| !is_cut);
                    let in_field = field.map(|field| field.agreement(own[k], &known[k], seen.away));
                    shock.agreement(own[k], &known[k]) * in_field.unwrap_or(1.0)
                };
                weight = weight.min(near * shock.share * agreement(0).min(agreement(1)));
            }
        }
        if weight <= 0.0 {
            return None;
        }
        let first = &self.root.cells[seen.cells[0] as usize];
        let piece = &first.pieces[seen.facet as usize];
        let (mut flux, mut ahead) = (Conserved::ZERO, 1.0);
        let mut let_through = |there: &Primitive<D>, part: f64| {
            if part > 0.0 {
                let [left, right] = [0, 1].map(|k| shifted(own[k], &known[k], there));
                let jump = Jump::new(gas, left, right, piece.normal);
                flux = flux.plus(part * size, &jump.hllc());
            }
        };
        for Behind { shock, sector, .. } in &self.shocks {
            if let Some(field) = &shock.field {
                cone_cells::along(&self.front, shock, field, piece, &mut let_through);
                ahead = 0.0;
                continue;
            }
            let part = piece.part(sector, &first.from());
            let_through(&shock.rear, part);
            ahead -= part;
        }
        let_through(&self.front, ahead);
        let more = flux.plus(-1.0, usual);
        Some(Conserved::ZERO.plus(weight, &more))
    }

    /// True so far from the tip of a cone, in spacings, that gas behind its shock is not the same everywhere.
    pub(super) fn is_in_field(&self, away: f64) -> bool {
        away < FIELD
            && self
                .shocks
                .iter()
                .any(|behind| behind.shock.field.is_some())
    }

    /// Pressure on a wall or a mirror with this `normal`, and how far that is to be believed, where the slopes of its cell see the shock.
    fn pressure<G: EquationOfState>(
        &self,
        gas: &G,
        seen: &RootWall,
        (i, normal): (usize, &[f64; D]),
        flow: Flow<'_, D>,
    ) -> Option<(f64, f64)> {
        // That before a bend is in front of the one shock there.
        let bounds = |behind: &&Behind<D>| seen.behind.is_none_or(|wall| wall == behind.wall);
        let Behind { shock, reach, .. } = self.shocks.iter().find(bounds)?;
        let near = nearness(seen.away, *reach);
        let cell = &self.root.cells[seen.cell as usize];
        // Farther from the shock slopes know nothing of it.
        let reach = cell.radius + SLOPES * self.root.bends[0].unit;
        let is_far = cell.height(&shock.normal).abs() >= reach && !self.is_in_field(seen.away);
        if near <= 0.0 || flow.slopes[i].calmness < 0.0 || is_far {
            return None;
        }
        let own = &flow.states[i];
        let known = self.known(gas, seen.cell);
        let mut weight = near * shock.share * shock.agreement(own, &known);
        if let Some(field) = &shock.field
            && self.parts[seen.cell as usize][0] >= 1.0
        {
            weight *= field.agreement(own, &known, seen.away);
        }
        let there = match seen.behind {
            Some(_) => &shock.rear,
            None => &self.front,
        };
        let there = shifted(own, &known, there);
        let speed = dot(&there.velocity, normal);
        Some((
            gas.wall_pressure(there.density, there.pressure, speed),
            weight,
        ))
    }
}
