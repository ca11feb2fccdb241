//! A closed surface around triangles that nothing else makes a solid of. Closed parts and shells with a
//! few holes are solid where they wind around a point; what is thinner than the spacing, panels without
//! thickness first of all, is made as thick as that; and what no gas can reach is solid too.

mod contour;
mod field;
mod grid;

use contour::{Vertices, contour};
use field::Field;
use grid::Nodes;

use super::Mesh;
use crate::Watch;
use crate::error::{GeometryError, positive};
use crate::stl::Soup;

/// Grid cells per spacing: a panel as thick as a spacing has a node in it wherever it lies.
const FINENESS: f64 = 2.0;

impl Mesh {
    /// The surface around the triangles of `soup`, however they hang together, that resolves what
    /// particles at `spacing` (metres) can see of them. It takes time and memory by the number of cells
    /// of half the spacing in the box around them, about a byte each.
    ///
    /// # Errors
    /// A spacing that is not above zero, too fine for memory or so coarse that nothing is left.
    pub fn wrapped(soup: &Soup, spacing: f64, watch: &Watch) -> Result<Self, GeometryError> {
        let spacing = positive("wrap", "spacing", spacing)?;
        watch.begin("sorting parts");
        let mut repairs = Vec::new();
        let field = Field::new(soup, spacing, &mut repairs)?;
        watch.begin("wrapping");
        let nodes = Nodes::new(&field, spacing / FINENESS)?;
        let voids = nodes.voids();
        if voids > 0 {
            let volume = voids as f64 * (spacing / FINENESS).powi(3);
            repairs.push(format!(
                "filled voids without a way in, {volume:.3e} in volume"
            ));
        }
        // Sharp edges may fold the surface in a cell with several sheets; rounded ones never do.
        let sharp = contour(&field, &nodes, Vertices::Sharp);
        let made = Self::from_facets_watched(sharp, watch).or_else(|_| {
            Self::from_facets_watched(contour(&field, &nodes, Vertices::Round), watch)
        });
        let mut mesh = made?;
        mesh.names = soup.solids.iter().map(|(name, _)| name.clone()).collect();
        repairs.push(format!(
            "wrapped {} triangles in {} at a spacing of {spacing:.3e}",
            soup.facets.len(),
            mesh.facet_count()
        ));
        mesh.repairs = repairs;
        Ok(mesh)
    }
}
