//! How finely the flow about a body is resolved, and the body beyond that: halvings of the lattice's spacing.

use aero_geometry::Bounds;

use super::domain;
use super::wishes::Wishes;

/// Halvings near body and shocks in space, and in a plane, of a box no wider than waves faster than sound ask for.
const IN_SPACE: u8 = 1;
const IN_A_PLANE: u8 = 2;

/// How often the spacing of the lattice is halved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fineness {
    /// Near body and shocks.
    pub flow: u8,
    /// How many of these make up for a box that is wider than waves faster than sound ask for.
    pub farther: u8,
    /// Beyond them around thin and bent parts of the body: grooves and fins that fall between cells give each run another body, and
    /// values that scatter by all of what such a part adds.
    pub closer: u8,
}

impl Fineness {
    /// Of a flow that is computed in so many dimensions, in a box of this size around the body.
    pub(super) fn new(
        region: &Bounds<3>,
        body: &Bounds<3>,
        dimension: usize,
        wishes: &Wishes,
    ) -> Self {
        let farther = of_far_box(region, body, dimension, wishes);
        let near = match (wishes.with_the_gas, dimension) {
            (true, _) => 0,
            (false, 2) => IN_A_PLANE,
            (false, _) => IN_SPACE,
        };
        Self {
            flow: near + farther,
            farther,
            closer: 0,
        }
    }
}

/// Halvings by which the far sides of a slow stream's box do not make the points near its body fewer.
fn of_far_box(region: &Bounds<3>, body: &Bounds<3>, dimension: usize, wishes: &Wishes) -> u8 {
    /// Mach number of a stream whose box is near.
    const FAST: f64 = 1.5;
    if !domain::is_slow(wishes.mach) {
        return 0;
    }
    let near = domain::around(body, 0.0, FAST, [wishes.incidence, wishes.sideslip]);
    let wider: f64 = (0..dimension)
        .map(|axis| region.size()[axis] / near.size()[axis])
        .product();
    (wider.log2() / dimension as f64).ceil().max(0.0) as u8
}
