//! Where shocks are rooted in space: pieces of sharp hollows of bodies, and of edges that part the stream, and the cells around each.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::attached::farthest;
use super::bend::{Bend, Kink};
use super::cells::Cells;
use super::edge::{Kind, Piece};
use super::hulls::{Hull, hulls};
use super::net::{Block, Net};
use super::ridges::{Ridges, bounds};
use super::root::{Plan, Root, RootFace, RootWall};
use super::roots::{BEFORE, may_hold};

/// Farther from both walls than this, in spacings, no shock is looked for: it is far enough from them to be captured there.
const HIGH: f64 = 12.0;

/// Cosine between a wall and one of an edge that it is a part of, at least.
const ALIKE: f64 = 0.99;

/// Walls that are farther off that plane than this, in spacings, are no part of it.
const OFF: f64 = 0.5;

/// The faces, walls and mirrors of a block around one piece, by their numbers.
#[derive(Default)]
struct Around {
    faces: Vec<u32>,
    walls: Vec<u32>,
    mirrors: Vec<u32>,
}

impl<const D: usize> Net<D> {
    /// Finds what lies around the hollows and the tips among `ridges`.
    pub(super) fn add_crests(&mut self, cells: &Cells<D>, ridges: &Ridges<D>) {
        let places = ridges.places(farthest::<D>(), |piece| piece.kind != Kind::Ridge);
        let blocks = self.blocks.par_iter();
        let around: Vec<BTreeMap<usize, Around>> = blocks
            .map(|block| match &places.near(block, cells)[..] {
                [] => BTreeMap::new(),
                near => self.around(block, cells, &ridges.pieces, near),
            })
            .collect();
        let wanted = self.blocks.iter().zip(&around);
        let mut wanted: Vec<u32> = wanted
            .flat_map(|(block, around)| {
                let faces = around.values().flat_map(|around| &around.faces);
                let faces = faces.map(|&number| &block.faces[number as usize]);
                let walls = around.values().flat_map(|around| &around.walls);
                let walls = walls.map(|&number| block.walls[number as usize].i);
                let mirrors = around.values().flat_map(|around| &around.mirrors);
                let mirrors = mirrors.map(|&number| block.sides[number as usize].i);
                let faces = faces.flat_map(|face| [face.i, face.j]);
                faces.chain(walls).chain(mirrors)
            })
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        let hulls = hulls(self, cells, &wanted);
        let blocks = self.blocks.par_iter().zip(&around);
        let found: Vec<(Vec<Root<D>>, Vec<Kink<D>>)> = blocks
            .map(|(block, around)| {
                let (mut roots, mut kinks) = (Vec::new(), Vec::new());
                for (&number, around) in around {
                    let piece = &ridges.pieces[number];
                    for (k, bends) in piece.met().into_iter().enumerate() {
                        let crest = Crest {
                            net: self,
                            cells,
                            block,
                            piece,
                            bends,
                            hulls: &hulls,
                        };
                        let root = crest.root((2 * number + k) as u32, around);
                        kinks.extend(crest.kinks(&root));
                        roots.extend((!root.cells.is_empty()).then_some(root));
                    }
                }
                (roots, kinks)
            })
            .collect();
        for (block, (roots, kinks)) in self.blocks.iter_mut().zip(found) {
            block.roots = roots;
            block.kinks.extend(kinks);
        }
    }

    /// What of a block lies around these pieces: of each edge the nearest one has them.
    fn around(
        &self,
        block: &Block<D>,
        cells: &Cells<D>,
        pieces: &[Piece<D>],
        near: &[usize],
    ) -> BTreeMap<usize, Around> {
        let mut found: BTreeMap<usize, Around> = BTreeMap::new();
        let mut edges: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let (low, high) = bounds(&cells.points[block.cells.clone()]);
        for &number in near {
            if pieces[number].may_hold_within(&low, &high) {
                edges.entry(pieces[number].edge).or_default().push(number);
            }
        }
        for members in edges.values() {
            let nearest = |place: &Vector<D>| {
                let mut best = (f64::INFINITY, None);
                for &number in members {
                    let (away, is_seen) = pieces[number].sees(place, farthest::<D>());
                    if away < best.0 {
                        best = (away, is_seen.then_some(number));
                    }
                }
                best.1.filter(|&number| pieces[number].may_hold(place))
            };
            for (number, face) in (0_u32..).zip(&block.faces) {
                let middle = self.seen(&cells.points, &Vector::zeros(), face);
                let shape = &self.face_shapes[face.shape as usize];
                let crosses = |piece: &usize| !pieces[*piece].walls.faces_along(shape);
                let nearest = middle.and_then(|middle| nearest(&middle)).filter(crosses);
                if let Some(piece) = nearest {
                    found.entry(piece).or_default().faces.push(number);
                }
            }
            for (number, wall) in (0_u32..).zip(&block.walls) {
                if let Some(piece) = nearest(&wall.foot) {
                    found.entry(piece).or_default().walls.push(number);
                }
            }
            for (number, side) in (0_u32..).zip(&block.sides) {
                let foot = cells.points[side.i as usize] + Vector::from(side.way());
                if side.is_mirror()
                    && let Some(piece) = nearest(&foot)
                {
                    found.entry(piece).or_default().mirrors.push(number);
                }
            }
        }
        found
    }
}

impl<const D: usize> Piece<D> {
    /// The bends at which shocks are rooted together: both of a tip, each of a hollow by itself.
    fn met(&self) -> Vec<Vec<Bend<D>>> {
        match self.kind {
            Kind::Ridge => Vec::new(),
            Kind::Hollow => self.bends.iter().map(|bend| vec![bend.clone()]).collect(),
            Kind::Tip => vec![self.bends.clone()],
        }
    }

    /// True of a place that is neither wholly ahead of the edge nor far from all its walls.
    fn may_hold(&self, place: &Vector<D>) -> bool {
        let arm = self.walls.across(&(place - Vector::from(self.walls.at)));
        let unit = self.walls.unit;
        // What lies on the other side of a tip is behind its other wall.
        let is_low = |bend: &Bend<D>| {
            arm.dot(&self.wall_of(bend)) < HIGH * unit && arm.dot(&self.over(bend)) > -unit
        };
        let mut bends = self.bends.iter();
        bends.any(|bend| may_hold(bend, &arm) && is_low(bend))
    }

    /// The same of any place in a box, or next to it.
    fn may_hold_within(&self, low: &Vector<D>, high: &Vector<D>) -> bool {
        let unit = self.walls.unit;
        let arm = 0.5 * (low + high) - Vector::from(self.walls.at);
        let half = 0.5 * (high - low).add_scalar(2.0 * unit);
        let reach = |normal: &Vector<D>| half.dot(&normal.abs());
        let mut bends = self.bends.iter();
        bends.any(|bend| {
            let [up, over] = [self.wall_of(bend), self.over(bend)];
            let before = Vector::from(bend.before);
            arm.dot(&up) - reach(&up) < HIGH * unit
                && arm.dot(&over) + reach(&over) > -unit
                && arm.dot(&before) + reach(&before) > -BEFORE * unit
        })
    }

    /// Normal of the plane that parts its sides, into that of a bend; of a hollow, which has one, of the wall behind.
    fn over(&self, bend: &Bend<D>) -> Vector<D> {
        match self.kind {
            Kind::Tip => bend.over().into(),
            Kind::Ridge | Kind::Hollow => bend.up_behind().into(),
        }
    }

    /// Normal of the wall behind a bend of it, into the gas.
    fn wall_of(&self, bend: &Bend<D>) -> Vector<D> {
        match self.kind {
            Kind::Tip => bend.up.into(),
            Kind::Ridge | Kind::Hollow => bend.up_behind().into(),
        }
    }
}

/// The bends of a piece at which shocks are rooted together, and what is around in a block.
struct Crest<'a, const D: usize> {
    net: &'a Net<D>,
    cells: &'a Cells<D>,
    block: &'a Block<D>,
    piece: &'a Piece<D>,
    bends: Vec<Bend<D>>,
    hulls: &'a HashMap<u32, Hull<D>>,
}

impl<const D: usize> Crest<'_, D> {
    fn root(&self, number: u32, around: &Around) -> Root<D> {
        let mut root = Root {
            number,
            bends: self.bends.clone(),
            apex: None,
            cells: Vec::new(),
            whereabouts: ([0.0; D], 0.0),
            faces: Vec::new(),
            walls: Vec::new(),
            mirrors: Vec::new(),
        };
        let mut numbers: HashMap<u32, Option<u32>> = HashMap::new();
        let mut place = |i: u32, all: &mut Vec<Plan<D>>| {
            *numbers.entry(i).or_insert_with(|| {
                let plan = self.plan(i)?;
                all.push(plan);
                Some((all.len() - 1) as u32)
            })
        };
        let at = Vector::from(self.piece.walls.at);
        let away = |there: &Vector<D>| {
            self.piece.walls.across(&(there - at)).norm() / self.piece.walls.unit
        };
        for &number in &around.faces {
            let face = &self.block.faces[number as usize];
            let [Some(first), Some(second)] = [face.i, face.j].map(|i| place(i, &mut root.cells))
            else {
                continue;
            };
            let middle = self.net.seen(&self.cells.points, &Vector::zeros(), face);
            let facet = self.hulls[&face.i].facet(face.j);
            let (Some(middle), Some(facet)) = (middle, facet) else {
                continue;
            };
            root.faces.push(RootFace {
                number,
                cells: [first, second],
                facet,
                away: away(&middle),
            });
        }
        let mut beside = |i: u32, number: u32, foot: &Vector<D>, normal: &[f64; D]| {
            let is_behind = |bend: &Bend<D>| self.lies_in(&self.piece.wall_of(bend), foot, normal);
            let behind = self.bends.iter().position(is_behind);
            let is_ahead = || {
                let up = Vector::from(self.bends[0].up);
                self.piece.kind == Kind::Hollow && self.lies_in(&up, foot, normal)
            };
            // Others are no part of the edge's.
            if behind.is_none() && !is_ahead() {
                return None;
            }
            Some(RootWall {
                number,
                cell: place(i, &mut root.cells)?,
                away: away(foot),
                behind: behind.map(|number| number as u8),
            })
        };
        let walls = around
            .walls
            .iter()
            .map(|&number| (number, &self.block.walls[number as usize]));
        let walls = walls
            .filter_map(|(number, wall)| beside(wall.i, number, &wall.foot, &wall.image.normal));
        root.walls = walls.collect();
        let mirrors = around
            .mirrors
            .iter()
            .map(|&number| (number, &self.block.sides[number as usize]));
        let mirrors = mirrors.filter_map(|(number, side)| {
            let foot = self.cells.points[side.i as usize] + Vector::from(side.way());
            beside(side.i, number, &foot, &side.image.normal)
        });
        root.mirrors = mirrors.collect();
        root.located()
    }

    /// True of a wall with this `normal`, out of its cell, that lies in the plane through the edge with the normal `up`.
    fn lies_in(&self, up: &Vector<D>, foot: &Vector<D>, normal: &[f64; D]) -> bool {
        let Bend { at, unit, .. } = &self.piece.walls;
        let off = (foot - Vector::from(*at)).dot(up).abs();
        -Vector::from(*normal).dot(up) > ALIKE && off < OFF * unit
    }

    /// A cell as seen from the piece, if it is known what it looks like.
    fn plan(&self, i: u32) -> Option<Plan<D>> {
        let hull = self.hulls.get(&i)?;
        let point = (self.cells.points[i as usize] - Vector::from(self.piece.walls.at)).into();
        Some(Plan {
            cell: i,
            point,
            radius: hull.solid.radius,
            volume: hull.solid.volume,
            pieces: Arc::clone(&hull.solid.pieces),
        })
    }

    /// The walls of `root` ahead of a hollow in the cells that hold it.
    fn kinks(&self, root: &Root<D>) -> Vec<Kink<D>> {
        let bend = &self.bends[0];
        let most = bend
            .donors
            .iter()
            .reduce(|a, b| if b.1 > a.1 { b } else { a });
        let Some((donor, _)) = most.filter(|_| self.piece.kind == Kind::Hollow) else {
            return Vec::new();
        };
        let holds_both = |wall: &&RootWall| {
            let mut others = root.walls.iter().chain(&root.mirrors);
            wall.behind.is_none()
                && others.any(|other| other.cell == wall.cell && other.behind.is_some())
        };
        let ahead = root.walls.iter().filter(holds_both);
        ahead
            .map(|wall| Kink {
                wall: wall.number as usize,
                donor: *donor,
                pressed: None,
                before: bend.before,
                edge: bend.edge,
                along: Some(bend.along),
            })
            .collect()
    }
}
