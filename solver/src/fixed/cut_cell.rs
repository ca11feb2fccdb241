//! A cell that was cut out of its neighbours and the bodies.

use super::part::Part;
use super::voronoi::Link;

/// A cell that was cut out.
#[derive(Clone, Debug)]
pub struct CutCell<const D: usize> {
    /// Its number.
    pub number: u32,
    /// Its neighbours.
    pub links: Vec<Link<D>>,
    /// Its pieces, its own first.
    pub parts: Vec<Part<D>>,
    /// Points farther from its own than this have no say in it.
    pub reach: f64,
}
