//! How finely the flow about a body is resolved, and the body beyond that: halvings of the lattice's spacing.

use aero_geometry::Bounds;
use aero_solver::method::Refine;

use super::domain;
use super::estimate::Costs;
use super::flight::Flight;
use super::wishes::Wishes;

/// Halvings near body and shocks in space, and in a plane, of a box no wider than waves faster than sound ask for.
const IN_SPACE: u8 = 1;
const IN_A_PLANE: u8 = 2;

/// Halvings around bent parts of the body beyond those around thin ones in slow streams. What these draw at noses and edges makes up for what they press
/// elsewhere, and the whole drag is what is not made up for; cells along lines are few.
const MORE_OF_BENDS: u8 = 2;

/// How often the spacing of the lattice is halved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fineness {
    /// Near body and shocks.
    flow: u8,
    /// How many of these make up for a box that is wider than waves faster than sound ask for.
    farther: u8,
    /// Beyond them around thin and bent parts of the body: grooves and fins that fall between cells give each run another body, and
    /// values that scatter by all of what such a part adds.
    closer: u8,
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

impl Flight {
    /// Halvings of the spacing near body and shocks.
    pub fn halvings(&self) -> u8 {
        self.fineness.flow
    }

    /// The same in a box no wider than waves faster than sound ask for.
    pub fn near_halvings(&self) -> u8 {
        self.fineness.flow - self.fineness.farther
    }

    /// Halvings around thin and bent parts of the body.
    pub fn body_halvings(&self) -> u8 {
        self.fineness.flow + self.fineness.closer
    }

    /// Where points are added.
    pub fn refine(&self) -> Refine {
        Refine::Apart {
            flow: self.halvings(),
            bodies: self.body_halvings(),
            bends: self.body_halvings() + self.more_of_bends(),
        }
    }

    fn more_of_bends(&self) -> u8 {
        if self.is_slow() { MORE_OF_BENDS } else { 0 }
    }

    /// Most halvings around thin parts.
    fn most_halvings(&self) -> u8 {
        (Refine::DEEPEST_OF_POINTS + self.fineness.farther)
            .min(Refine::DEEPEST - self.more_of_bends())
    }

    /// One more halving around the body, if there may be.
    pub fn come_closer(&mut self) -> bool {
        let may = !self.wishes.with_the_gas && self.body_halvings() < self.most_halvings();
        self.fineness.closer += u8::from(may);
        may
    }

    /// One less.
    pub fn stand_back(&mut self) {
        self.fineness.closer = self.fineness.closer.saturating_sub(1);
    }

    /// As many more halvings as let the coarsest run of a family down to `finest` be no finer than `look` away from body and shocks.
    pub fn deepen(&mut self, finest: f64, look: f64) {
        if self.wishes.with_the_gas {
            return;
        }
        let coarser = Costs::new(self.dimension(), false).coarsest();
        let first = |halvings: u8| finest * coarser * f64::from(1_u32 << halvings);
        while self.halvings() < self.most_halvings() && first(self.halvings() + 1) <= look {
            self.fineness.flow += 1;
        }
    }
}
