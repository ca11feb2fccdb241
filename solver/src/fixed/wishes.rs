//! Where the flow wants points added or taken away.

use super::FixedSimulation;
use super::equation_of_state::EquationOfState;
use super::refine::Wish;
use super::state::dot;

/// Change of the density across a face, over the smaller one, above which both cells are to be split.
const STEEP: f64 = 0.05;

/// What a change of the velocity counts, over the speed of sound: gas that comes to rest before a nose, and gas that slides past other
/// gas, change their density little.
const SPEED: f64 = 0.25;

/// Part of the stream's speed by which that of viscous gas may change from cell to cell: all of a layer gets the same cells, because where two
/// spacings meet faces are askew, and gas that passes them brings dissipation along.
const SHEAR: f64 = 0.02;

/// Change below which a cell may join those it was split from.
const FLAT: f64 = 0.01;

impl<const D: usize> FixedSimulation<D> {
    /// Largest change across a face of each cell: of the density over the smaller one, of the velocity as it counts.
    pub fn changes(&self) -> Vec<f64> {
        let sheared = self.sheared();
        let settles = self.problem.method.settles() && self.fluid.viscous.is_none();
        let mach = Some(self.problem.stream_mach()).filter(|_| settles);
        let [denser, faster] = counted(mach);
        let mut steepest = vec![0.0_f64; self.points.len()];
        for (block, rest) in self.net.blocks.iter().zip(&self.quiet.blocks) {
            if !rest.is_awake {
                continue;
            }
            for face in &block.faces {
                let cells = [face.i as usize, face.j as usize];
                let [a, b] = cells.map(|i| &self.columns.states[i]);
                let density = denser * (a.density - b.density).abs() / a.density.min(b.density);
                let sounds =
                    [a, b].map(|state| self.fluid.gas.sound_square(state.density, state.pressure));
                let apart = b.plus(-1.0, a).velocity;
                let speed = (dot(&apart, &apart) / sounds[0].max(sounds[1])).sqrt();
                let mut change = density.max(faster * speed);
                if let Some(sheared) = sheared {
                    change = change.max(sheared * dot(&apart, &apart).sqrt());
                }
                for i in cells {
                    steepest[i] = steepest[i].max(change);
                }
            }
            // A layer is as thin as cells can show at walls that gas sticks to.
            for wall in block.walls.iter().filter(|wall| wall.stick.is_some()) {
                steepest[wall.i as usize] = f64::INFINITY;
            }
        }
        steepest
    }

    /// What a change of the velocity of viscous gas in a stream counts.
    fn sheared(&self) -> Option<f64> {
        let speed = self.problem.free_stream.velocity.norm();
        (self.fluid.viscous.is_some() && speed > 0.0).then(|| STEEP / (SHEAR * speed))
    }
}

/// What changes of the density and of the velocity over the speed of sound count, where a flow settles out of a stream of this Mach number. In one
/// slower than sound pressures are of the order of `rho U^2`, and changes of the density of the order of `M^2`: they count in parts of that, those of
/// the velocity in parts of `U`. A twentieth is then a tenth of the dynamic pressure, whatever the Mach number.
fn counted(mach: Option<f64>) -> [f64; 2] {
    match mach {
        Some(mach) if mach > 0.0 && mach < 1.0 => [1.0 / (mach * mach), SPEED / mach],
        _ => [1.0, SPEED],
    }
}

/// What is to be done about each cell: shocks and expansions are split where they change by more than a twentieth from cell
/// to cell, and joined where it is by less than a hundredth; by so much more where points are `dearer`.
pub fn wishes(changes: &[f64], dearer: f64) -> Vec<Wish> {
    let wish = |&change: &f64| {
        if change > STEEP * dearer {
            Wish::Split
        } else if change < FLAT * dearer {
            Wish::Join
        } else {
            Wish::Keep
        }
    };
    changes.iter().map(wish).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without compression `d rho / rho = M^2 u du / U^2`, and the pressure coefficient changes by `2 u du / U^2`.
    #[test]
    fn changes_of_a_slow_stream_count_by_its_dynamic_pressure() {
        for mach in [0.05, 0.3, 0.9] {
            let [denser, faster] = counted(Some(mach));
            let density = mach * mach * 0.05;
            assert!((denser * density - 0.5 * 0.1).abs() < 1e-15);
            assert!((faster * 0.2 * mach - STEEP).abs() < 1e-15);
        }
        for other in [None, Some(0.0), Some(1.0), Some(3.0)] {
            assert_eq!(counted(other), [1.0, SPEED]);
        }
    }
}
