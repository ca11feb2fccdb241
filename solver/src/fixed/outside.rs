//! What changes beyond the sides.

use super::cells::Cells;
use super::far_field::FarField;
use super::given::{GivenFace, given_faces};
use super::net::Net;
use super::spreading::Spreading;
use crate::problem::Problem;

/// Faces whose other side is not what it was at the start.
#[derive(Clone, Debug)]
pub struct Outside<const D: usize> {
    /// Faces that gas in a given state is beyond.
    pub given: Vec<GivenFace<D>>,
    /// The stream that lift turns, if any.
    pub far_field: Option<FarField<D>>,
    /// The side around an axis whose stream waves turn that thin out, if any.
    pub spreading: Option<Spreading<D>>,
}

impl<const D: usize> Outside<D> {
    /// What is beyond the sides of `cells`, which stand in `net`.
    pub fn of(problem: &Problem<D>, cells: &Cells<D>, net: &Net<D>) -> Self {
        Self {
            given: given_faces(problem, cells),
            far_field: FarField::of(problem, cells, net),
            spreading: Spreading::of(problem, cells),
        }
    }
}
