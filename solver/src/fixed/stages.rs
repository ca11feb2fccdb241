//! When a flow that settles gets more points: once it has come near to rest on those that it has, one halving of the spacing after
//! another, until it wants hardly any more.

use super::FixedSimulation;
use crate::Failure;

/// So many iterations after which it may ask in any case: on few points a flow may never come near to rest.
const PATIENCE: u64 = 400;

/// The same of viscous flows: a layer that has not grown yet asks for too few.
const PATIENCE_VISCOUS: u64 = 4000;

/// So many iterations after which a flow that began near its end asks, and asks again: by then shocks are where they will be, but for
/// little.
const SOON: u64 = 5;

/// Part of the points of split cells that is hardly any: how large the domain is around them does not matter.
const FEW: f64 = 0.02;

/// Part of all points above which a flow that began near its end starts anew.
const SOME: f64 = 0.1;

/// Adaptions after the one that makes the smallest cells: shocks move a little as they sharpen.
const AFTER: u32 = 3;

impl<const D: usize> FixedSimulation<D> {
    /// Lets the flow ask for points where it `is_near` to rest.
    pub(super) fn ask_for_points(&mut self, is_near: bool) -> Result<(), Failure> {
        let Some(ground) = &self.ground else {
            return Ok(());
        };
        let settling = &self.settling;
        let is_soon = settling.is_near && settling.counts.since == SOON;
        let patience = if self.fluid.viscous.is_some() {
            PATIENCE_VISCOUS
        } else {
            PATIENCE
        };
        let may_ask = is_near || is_soon || settling.counts.since > patience;
        if settling.has_points || !may_ask {
            return Ok(());
        }
        let most = u32::from(ground.most());
        let new = self.adapt_settling()?;
        let split: usize = self.points_per_level()[1..].iter().sum();
        let settling = &mut self.settling;
        settling.counts.adaptions += 1;
        let is_enough = new as f64 <= FEW * split as f64;
        settling.has_points = is_enough || settling.counts.adaptions >= most + AFTER;
        if new > 0 {
            settling.counts.since = 0;
            // A flow that is near its end shows what a few new points change.
            if !(settling.is_near && (new as f64) < SOME * self.points.len() as f64) {
                settling.is_near = false;
                settling.watched.clear();
                settling.counts.calm = 0;
            }
        }
        Ok(())
    }
}
