//! What cells look like: boxes of the lattice, polygons, polygons that bound polyhedra, for pictures.

use std::sync::Arc;

use aero_geometry::Vector;

use super::FixedSimulation;
use super::build::Builder;
use super::cloud::Cloud;
use super::ground::{Ground, plot};
use super::merge::given;
use super::plot::Plot;
use crate::frame::{CellFrame, CellPiece, Look};
use crate::walls::rigid::pad;

impl<const D: usize> FixedSimulation<D> {
    /// What the cells look like now, in the order of a frame of all points, in the plane or in space; of none on a line. Made anew
    /// where points have come or gone.
    pub fn cells(&self) -> Arc<CellFrame> {
        let frame = self
            .shown
            .outlines
            .get_or_init(|| Arc::new(self.cells_anew()));
        Arc::clone(frame)
    }

    fn cells_anew(&self) -> CellFrame {
        if D == 1 {
            return CellFrame::default();
        }
        let of = |ground: &Ground<D>| {
            let plot = plot(&self.problem, &ground.solids, ground.cloud.corner);
            outlines(&plot, &ground.cloud)
        };
        match &self.ground {
            Some(ground) => of(ground),
            // It was made once before, so that it can be.
            None => {
                Ground::new(&self.problem).map_or_else(|_| CellFrame::default(), |it| of(&it.0))
            }
        }
    }
}

/// The outlines of all cells; pieces of cells that nobody owns are left out.
fn outlines<const D: usize>(plot: &Plot<'_, D>, cloud: &Cloud<D>) -> CellFrame {
    let builder = Builder::new(*plot, cloud).keeping_rings();
    let positions = cloud.positions();
    let cut = builder.cut_cells(&positions);
    let targets = given(&builder.nodes(&cut), &cut);
    let at =
        |number: usize, place: &Vector<D>| -> [f64; 3] { pad(&(positions[number] + place)).into() };
    let plain = (0..positions.len()).filter(|&number| builder.is_plain(number));
    let mut pieces: Vec<CellPiece> = plain
        .map(|number| CellPiece {
            cell: number as u32,
            look: Look::Block(builder.block(number).map(|corner| at(number, &corner))),
        })
        .collect();
    for (cell, targets) in cut.iter().zip(&targets.of_parts) {
        for (part, target) in cell.parts.iter().zip(targets) {
            let Some(target) = target else {
                continue;
            };
            let number = cell.number as usize;
            let rings = part.rings.iter();
            let rings = rings.map(|ring| ring.iter().map(|place| at(number, place)).collect());
            pieces.push(CellPiece {
                cell: target.cell,
                look: Look::Rings(rings.collect()),
            });
        }
    }
    pieces.sort_by_key(|piece| piece.cell);
    CellFrame {
        dimension: D,
        pieces,
    }
}
