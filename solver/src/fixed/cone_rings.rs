//! What rings about the tip of a cone press outwards with.

use super::attached::nearness;
use super::bent::Layout;
use super::cells::RADIAL;
use super::cloven::{Behind, Cleaving};
use super::slopes::Flow;
use super::state::Conserved;

/// Adds to what the cells of a block gain what rings about the tip of a cone press outwards with more than by what their cells hold.
pub fn press_rings<const D: usize>(
    shocks: &[Cleaving<'_, D>],
    Layout { net, block, .. }: Layout<'_, D>,
    flow: Flow<'_, D>,
    cells: &mut [Conserved<D>],
) {
    for cleaving in shocks {
        let [Behind { shock, reach, .. }] = &cleaving.shocks[..] else {
            continue;
        };
        let Some(field) = &shock.field else {
            continue;
        };
        let unit = cleaving.root.bends[0].unit;
        let cells_of = cleaving.root.cells.iter().zip(&cleaving.parts);
        for ((plan, parts), known) in cells_of.zip(&cleaving.field) {
            let away = plan.away() / unit;
            let i = plan.cell as usize;
            let is_held = parts[0] > 0.0 && (parts[0] < 1.0 || cleaving.is_in_field(away));
            let Some(cell) = cells
                .get_mut(i.wrapping_sub(block.cells.start))
                .filter(|_| is_held)
            else {
                continue;
            };
            let Some((known, pressed)) = known else {
                continue;
            };
            let own = &flow.states[i];
            let mut weight = nearness(away, *reach) * shock.share * shock.agreement(own, known);
            if parts[0] >= 1.0 {
                weight *= field.agreement(own, known, away);
            }
            if flow.slopes[i].calmness >= 0.0 {
                cell.momentum[RADIAL] += weight * (pressed - known.pressure) * net.cell(i).hoop;
            }
        }
    }
}
