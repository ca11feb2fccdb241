//! What cells look like: polygons, or the polygons that bound polyhedra, for pictures.

use aero_geometry::Vector;

use super::build::Builder;
use super::cloud::Cloud;
use super::merge::given;
use super::plot::Plot;
use super::polytope::Polytope;
use super::whole::Whole;

/// What a cell looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline<const D: usize> {
    /// Its number; a cell may consist of several pieces.
    pub cell: u32,
    /// The polygon that it is, in the plane; in space those that bound it; on a line its ends.
    pub rings: Vec<Vec<Vector<D>>>,
}

impl<const D: usize> Outline<D> {
    fn move_by(&mut self, shift: &Vector<D>) {
        let places = self.rings.iter_mut().flatten();
        places.for_each(|place| *place += shift);
    }
}

/// The outlines of all cells, for pictures.
pub fn outlines<const D: usize>(plot: &Plot<'_, D>, cloud: &Cloud<D>) -> Vec<Outline<D>> {
    let builder = Builder::new(*plot, cloud).keeping_rings();
    let positions = cloud.positions();
    let cut = builder.cut_cells(&positions);
    let nodes = builder.nodes(&cut);
    let targets = given(&nodes, &cut);
    let mut outlines = Vec::with_capacity(cloud.places.len());
    for number in (0..cloud.places.len()).filter(|&number| builder.is_plain(number)) {
        let [low, high] = builder.block(number);
        let cell = Polytope::block(&low, &high);
        let whole = Whole {
            cell: &cell,
            point: &positions[number],
            unit: cloud.places[number].spacing,
            about_axis: false,
            keeps_rings: true,
        };
        let mut outline = Outline {
            cell: number as u32,
            rings: whole.uncut().rings,
        };
        outline.move_by(&positions[number]);
        outlines.push(outline);
    }
    for (cell, targets) in cut.into_iter().zip(&targets.of_parts) {
        for (part, target) in cell.parts.into_iter().zip(targets) {
            let mut outline = Outline {
                cell: target.map_or(cell.number, |target| target.cell),
                rings: part.rings,
            };
            outline.move_by(&positions[cell.number as usize]);
            outlines.push(outline);
        }
    }
    outlines
}
