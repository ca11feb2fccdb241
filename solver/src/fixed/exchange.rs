//! What the cells of a block gain: through faces, walls and sides, and by rings that press outwards.

use aero_geometry::Vector;

use super::bent::{Layout, fans, press, turn};
use super::cloven::{self, Cleaving};
use super::cone_rings::press_rings;
use super::drawing::Drawing;
use super::energy::EnergyFlux;
use super::equation_of_state::EquationOfState;
use super::fluxes::{Passed, Through};
use super::gains::Gains;
use super::kink::hold;
use super::net::{Block, Net};
use super::quiet::Rest;
use super::slopes::{Flow, Slopes};
use super::state::Conserved;
use super::viscous::{Rubbing, WallShare};
use super::walls::push;
use crate::vectors::dispatch;

/// Sums up the faces of `block`; pressures on its walls go to `pressures`.
pub struct Exchange<'a, G, const D: usize> {
    /// The gas.
    pub gas: &'a G,
    /// All faces.
    pub net: &'a Net<D>,
    /// The points of all cells.
    pub points: &'a [Vector<D>],
    /// Which blocks rest.
    pub rests: &'a [Rest<D>],
    /// How energy goes through them.
    pub energy: EnergyFlux,
    /// Least Mach number that gas counts by where it meets, see [`super::slow`].
    pub least_mach: f64,
    /// How states are drawn out to the faces.
    pub drawing: Drawing,
    /// Those to sum up.
    pub block: &'a Block<D>,
    /// The flow.
    pub flow: Flow<'a, D>,
    /// Shocks that stand at bends and tips.
    pub shocks: &'a [Cleaving<'a, D>],
    /// Pressure on each wall of the block.
    pub pressures: &'a mut [f64],
    /// Of viscous gas.
    pub rubbing: Option<Rubbing<'a, D>>,
    /// What each wall of the block does to viscous gas.
    pub shares: &'a mut [WallShare<D>],
}

impl<'a, G, const D: usize> Exchange<'a, G, D> {
    /// The same of another gas.
    pub fn of<H>(self, gas: &'a H) -> Exchange<'a, H, D> {
        Exchange {
            gas,
            net: self.net,
            points: self.points,
            rests: self.rests,
            energy: self.energy,
            least_mach: self.least_mach,
            drawing: self.drawing,
            block: self.block,
            flow: self.flow,
            shocks: self.shocks,
            pressures: self.pressures,
            rubbing: self.rubbing,
            shares: self.shares,
        }
    }
}

impl<G: EquationOfState, const D: usize> Exchange<'_, G, D> {
    /// What the cells gain.
    pub fn gains(self, arch: pulp::Arch) -> Gains<D> {
        let Self {
            gas,
            net,
            points,
            rests,
            block,
            flow,
            shocks,
            pressures,
            rubbing,
            shares,
            ..
        } = self;
        let start = block.cells.start;
        // Gas that rubs sticks to walls: no fan stands at their bends.
        let fans = rubbing.is_none().then(|| fans(gas, block, flow));
        let fans = fans.unwrap_or_default();
        let Passed {
            mut cells,
            mut fluxes,
        } = dispatch(
            arch,
            Through {
                gas,
                net,
                energy: self.energy,
                least_mach: self.least_mach,
                block,
                flow,
                drawing: self.drawing,
                keeps_fluxes: !fans.is_empty() || !shocks.is_empty(),
            },
        );
        let layout = Layout {
            net,
            block,
            points,
            rests,
        };
        turn(gas, &fans, layout, flow, &mut cells, &mut fluxes);
        cloven::part(gas, shocks, layout, flow, &mut cells, &mut fluxes);
        let rubbed = rubbing.map(|rubbing| {
            let mut gains = Gains::nothing(cells.len());
            rubbing.add(net, block, flow, &mut gains, shares);
            gains
        });
        let mut boundary = Conserved::ZERO;
        for (wall, pressure) in block.walls.iter().zip(pressures.iter_mut()) {
            let i = wall.i as usize;
            let Slopes { along, calmness } = &flow.slopes[i];
            *pressure = wall.pressure(gas, &flow.states[i], along, *calmness);
        }
        press(gas, &fans, layout, flow, pressures);
        cloven::press(gas, shocks, block, flow, pressures);
        if rubbed.is_none() {
            hold(gas, block, flow, pressures);
        }
        for (wall, pressure) in block.walls.iter().zip(pressures) {
            let i = wall.i as usize;
            let gain = push(&wall.image, *pressure);
            boundary = boundary.plus(1.0, &gain);
            cells[i - start] = cells[i - start].plus(1.0, &gain);
        }
        for side in &block.sides {
            let i = side.i as usize;
            let own = rubbed.as_ref().map(|gains| {
                Conserved::ZERO.plus(1.0 / net.cell(i).volume, &gains.cells[i - start])
            });
            let flux = side.flux(gas, &flow.states[i], &flow.slopes[i], own.as_ref());
            boundary = boundary.plus(-side.image.size, &flux);
            cells[i - start] = cells[i - start].plus(-side.image.size, &flux);
        }
        boundary = boundary.plus(1.0, &cloven::reflect(gas, shocks, block, flow, &mut cells));
        // Rings press outwards on the gas that goes around with them.
        if D > 1 {
            for (cell, i) in cells.iter_mut().zip(block.cells.clone()) {
                cell.momentum[1] += flow.states[i].pressure * net.cell(i).hoop;
            }
            press_rings(shocks, layout, flow, &mut cells);
        }
        let mut gains = Gains { cells, boundary };
        if let Some(rubbed) = rubbed {
            gains.boundary = gains.boundary.plus(1.0, &rubbed.boundary);
            for (cell, more) in gains.cells.iter_mut().zip(&rubbed.cells) {
                *cell = cell.plus(1.0, more);
            }
        }
        gains
    }
}
