//! How often a flight halves the spacing of its lattice, and where.

use aero_solver::method::Refine;

use super::estimate::Costs;
use super::flight::Flight;

/// Halvings around bent parts of the body beyond those around thin ones in slow streams. What these draw at noses and edges makes up for what they press
/// elsewhere, and the whole drag is what is not made up for; cells along lines are few.
const MORE_OF_BENDS: u8 = 2;

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
