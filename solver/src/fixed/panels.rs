//! The surfaces themselves with the pressure on them: what the walls of cells nearby, of the same body and facing the same way, are
//! pressed with.

use aero_geometry::kernel::{QuinticSpline, SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Pencils, Vector};
use rayon::prelude::*;

use super::FixedSimulation;
use super::cells::Matrix;
use super::gas::Gas;
use super::state::dot;
use crate::frame::{Load, PanelFrame};
use crate::panels::{Panels, Pressed};
use crate::problem::Motion;
use crate::rings::Rings;
use crate::walls::rigid::Pose;

/// Part of the spacing that a panel looks about, at first.
const LOOK: f64 = 0.25;

/// So often it looks twice as far.
const FARTHER: usize = 8;

/// Part of the panels' spread of directions that counts as none.
const LEVEL: f64 = 1e-4;

/// Cosine below which walls face another way.
const ASKEW: f64 = 0.7;

impl<const D: usize> FixedSimulation<D> {
    /// The surfaces that the domain holds with the pressure on them now, bodies in scene order and wall sides after.
    pub fn panels(&self) -> PanelFrame {
        let panels = self.panels.get_or_init(|| Panels::new(&self.problem));
        let walls: Vec<_> = self.walls().collect();
        let places: Vec<Vector<D>> = walls.iter().map(|(wall, _)| wall.foot).collect();
        let look = LOOK * SMOOTHING_RATIO * SUPPORT * self.problem.spacing;
        let grid = Pencils::new(&places, look);
        let mut pressed: Vec<Pressed> = panels
            .all()
            .par_iter()
            .map(|panel| {
                let mut reach = look;
                for _ in 0..FARTHER {
                    let mut sums = [0.0; 3];
                    grid.for_each_run_near(&panel.centre, &panel.centre, reach, |run| {
                        for &n in &grid.order()[run] {
                            let (wall, pressure) = &walls[n as usize];
                            let facing = -panel.normal.dot(&Vector::from(wall.image.normal));
                            if wall.owner != panel.owner || facing < ASKEW {
                                continue;
                            }
                            let apart = (wall.foot - panel.centre).norm();
                            let kernel = QuinticSpline::<D>::value(apart, reach / SUPPORT);
                            let weight = kernel * wall.image.size;
                            sums[0] += weight;
                            sums[1] += weight * pressure;
                            sums[2] += weight * self.mach(wall.i as usize);
                        }
                    });
                    if sums[0] > 0.0 {
                        return Pressed {
                            pressure: sums[1] / sums[0],
                            mach: sums[2] / sums[0],
                        };
                    }
                    reach *= 2.0;
                }
                Pressed {
                    pressure: self.problem.free_stream.pressure,
                    mach: 0.0,
                }
            })
            .collect();
        self.balance(panels, &mut pressed);
        let still = Pose::new(&Motion::none(), 0.0);
        panels.frame(&self.problem, self.time, &pressed, |_| still)
    }

    /// Presses each body's panels more, evenly for each unit of their normals, for the force on it to be that on the walls of its
    /// cells: what interpolation and the panels' straightness have lost.
    fn balance(&self, panels: &Panels<D>, pressed: &mut [Pressed]) {
        let bodies = self.problem.bodies.len();
        let rings = Rings::new(&self.problem);
        let bounds = &self.problem.domain.bounds;
        let mut lacking = vec![Vector::<D>::zeros(); bodies];
        let mut moments = vec![Matrix::<D>::zeros(); bodies];
        let around = self.around();
        for (wall, pressure) in self.walls() {
            if let Some(lacking) = lacking.get_mut(wall.owner as usize) {
                *lacking += wall.image.area() * (pressure * around);
            }
        }
        let owned = |owner: u32| (owner as usize) < bodies;
        let shown = |centre: &Vector<D>| bounds.contains(centre);
        for (panel, pressed) in panels.all().iter().zip(&*pressed) {
            if owned(panel.owner) && shown(&panel.centre) {
                let area = panel.size * rings.circumference(&panel.centre);
                // Walls point out of the gas, panels into it.
                lacking[panel.owner as usize] += panel.normal * (pressed.pressure * area);
                moments[panel.owner as usize] += panel.normal * panel.normal.transpose() * area;
            }
        }
        let solve = |(moment, lacking): (&Matrix<D>, &Vector<D>)| {
            let stiffened = moment + Matrix::identity() * (LEVEL * moment.trace());
            let inverse = stiffened.try_inverse();
            inverse.map_or_else(Vector::zeros, |inverse| inverse * lacking)
        };
        let more: Vec<Vector<D>> = moments.iter().zip(&lacking).map(solve).collect();
        for (panel, pressed) in panels.all().iter().zip(pressed) {
            if owned(panel.owner) {
                pressed.pressure -= more[panel.owner as usize].dot(&panel.normal);
            }
        }
    }

    /// Loads of a pressure of one everywhere: on bodies, then on wall sides.
    pub fn uniform_loads(&self) -> Vec<Load> {
        let panels = self.panels.get_or_init(|| Panels::new(&self.problem));
        panels.uniform_loads(&self.problem)
    }

    fn mach(&self, cell: usize) -> f64 {
        let state = &self.states[cell];
        let sound = self.gas.sound_square(state.density, state.pressure).sqrt();
        dot(&state.velocity, &state.velocity).sqrt() / sound
    }
}
