//! The surfaces themselves with the pressure on them: each piece shows what presses the wall of the cell that it belongs to.

use aero_geometry::kernel::{QuinticSpline, SMOOTHING_RATIO, SUPPORT};
use aero_geometry::{Pencils, Vector};
use rayon::prelude::*;

use super::FixedSimulation;
use super::cells::Matrix;
use super::gas::Gas;
use super::state::dot;
use super::walls::Wall;
use crate::frame::{Load, PanelFrame};
use crate::panels::fit::Fit;
use crate::panels::{Panel, Panels, Pressed};
use crate::problem::{Motion, Problem};
use crate::rings::Rings;
use crate::walls::rigid::Pose;

/// Part of the kernel's reach that a panel looks about, at first.
const LOOK: f64 = 0.25;

/// So often it looks twice as far.
const FARTHER: usize = 8;

/// Part of the panels' spread of directions that counts as none.
const LEVEL: f64 = 1e-4;

/// Cosine below which walls face another way.
const ASKEW: f64 = 0.7;

/// The same for the wall of the cell that a place belongs to, which may go round an edge.
const ROUND: f64 = 0.2;

/// Pieces of a segment that are looked at by themselves; of a triangle four.
const PIECES: usize = 4;

/// The walls of all cells, to look for those near a place.
struct Nearby<'a, const D: usize> {
    walls: Vec<(&'a Wall<D>, f64)>,
    by_foot: Pencils<D>,
    look: f64,
}

/// A piece of a panel.
#[derive(Clone, Copy, Debug)]
struct Piece<const D: usize> {
    /// Its middle.
    place: Vector<D>,
    /// Number of the wall that it belongs to.
    wall: usize,
}

impl<const D: usize> FixedSimulation<D> {
    /// The surfaces that the domain holds with the pressure on them now, bodies in scene order and wall sides after.
    pub fn panels(&self) -> PanelFrame {
        let panels = self.shown.panels.get_or_init(|| Panels::new(&self.problem));
        let nearby = Nearby::new(self);
        let pieces: Vec<Vec<Piece<D>>> = panels
            .all()
            .par_iter()
            .map(|panel| nearby.pieces(panel))
            .collect();
        let middles = nearby.middles(&self.problem, panels, &pieces);
        let mut pressed: Vec<Pressed<D>> = panels
            .all()
            .par_iter()
            .zip(&pieces)
            .map(|(panel, pieces)| nearby.pressed(self, panel, pieces, &middles))
            .collect();
        self.balance(panels, &mut pressed);
        let still = Pose::new(&Motion::none(), 0.0);
        panels.frame(&self.problem, self.tally.time, &pressed, |_| still)
    }

    /// Presses each body's panels more, evenly for each unit of their normals, for the force on it to be that on the walls of its
    /// cells: what interpolation and the panels' straightness have lost.
    fn balance(&self, panels: &Panels<D>, pressed: &mut [Pressed<D>]) {
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
        let panels = self.shown.panels.get_or_init(|| Panels::new(&self.problem));
        panels.uniform_loads(&self.problem)
    }

    fn mach(&self, cell: usize) -> f64 {
        let state = &self.columns.states[cell];
        let sound = self.gas.sound_square(state.density, state.pressure).sqrt();
        dot(&state.velocity, &state.velocity).sqrt() / sound
    }
}

impl<'a, const D: usize> Nearby<'a, D> {
    fn new(simulation: &'a FixedSimulation<D>) -> Self {
        let walls: Vec<_> = simulation.walls().collect();
        let feet: Vec<Vector<D>> = walls.iter().map(|(wall, _)| wall.foot).collect();
        let look = LOOK * SMOOTHING_RATIO * SUPPORT * simulation.problem.spacing;
        Self {
            by_foot: Pencils::new(&feet, look),
            walls,
            look,
        }
    }

    /// The pieces of a panel, each with the wall of the cell that it belongs to; none where there is none far and wide.
    fn pieces(&self, panel: &Panel<D>) -> Vec<Piece<D>> {
        let places = pieces(panel);
        let mut reach = self.look;
        for _ in 0..FARTHER {
            let found: Vec<Piece<D>> = places
                .iter()
                .filter_map(|place| {
                    let wall = self.owner(panel, place, reach)?;
                    Some(Piece {
                        place: *place,
                        wall,
                    })
                })
                .collect();
            if found.len() == places.len() {
                return found;
            }
            reach *= 2.0;
        }
        Vec::new()
    }

    /// The middle of what belongs to each wall.
    fn middles(
        &self,
        problem: &Problem<D>,
        panels: &Panels<D>,
        pieces: &[Vec<Piece<D>>],
    ) -> Vec<Vector<D>> {
        let mut sums = vec![(0.0, Vector::<D>::zeros()); self.walls.len()];
        let bounds = &problem.domain.bounds;
        for (panel, pieces) in panels.all().iter().zip(pieces) {
            // A cell ends where the domain does.
            if bounds.contains(&panel.centre) {
                for piece in pieces {
                    let size = panel.size / pieces.len() as f64;
                    sums[piece.wall].0 += size;
                    sums[piece.wall].1 += piece.place * size;
                }
            }
        }
        let both = sums.iter().zip(&self.walls);
        both.map(
            |(&(size, moment), (wall, _))| {
                if size > 0.0 { moment / size } else { wall.foot }
            },
        )
        .collect()
    }

    /// What presses a panel: the mean over its pieces of the pressure on their walls, which is spread over what belongs to a wall
    /// as the pressure around rises. Neither is any of a wall's load lost nor shown twice.
    fn pressed(
        &self,
        simulation: &FixedSimulation<D>,
        panel: &Panel<D>,
        pieces: &[Piece<D>],
        middles: &[Vector<D>],
    ) -> Pressed<D> {
        let mut pressed = Pressed {
            pressure: simulation.problem.free_stream.pressure,
            friction: Vector::zeros(),
            mach: 0.0,
        };
        if pieces.is_empty() {
            return pressed;
        }
        pressed.pressure = 0.0;
        let fit = self.fit(panel, self.look);
        for piece in pieces {
            let (wall, pressure) = &self.walls[piece.wall];
            let rise = fit.slope().dot(&(piece.place - middles[piece.wall]));
            let part = 1.0 / pieces.len() as f64;
            pressed.pressure += part * fit.bounded(*pressure, pressure + rise);
            pressed.mach += part * simulation.mach(wall.i as usize);
        }
        pressed
    }

    /// How the pressure on the walls around rises.
    fn fit(&self, panel: &Panel<D>, reach: f64) -> Fit<D> {
        let mut fit = Fit::new();
        let centre = &panel.centre;
        self.by_foot
            .for_each_run_near(centre, centre, reach, |run| {
                for &n in &self.by_foot.order()[run] {
                    let (wall, pressure) = &self.walls[n as usize];
                    let arm = wall.foot - centre;
                    let kernel = QuinticSpline::<D>::value(arm.norm(), reach / SUPPORT);
                    if kernel > 0.0 && facing(wall, panel) > ASKEW {
                        fit.add(kernel * wall.image.size, &arm, *pressure);
                    }
                }
            });
        fit
    }

    /// Number of the wall that a place on a panel belongs to: that with the nearest foot.
    fn owner(&self, panel: &Panel<D>, place: &Vector<D>, reach: f64) -> Option<usize> {
        let mut best: Option<(f64, f64, usize)> = None;
        self.by_foot.for_each_run_near(place, place, reach, |run| {
            for &n in &self.by_foot.order()[run] {
                let wall = self.walls[n as usize].0;
                let facing = facing(wall, panel);
                let apart = (wall.foot - place).norm_squared();
                let is_nearer = best.is_none_or(|(least, most, _)| {
                    apart < least || apart == least && facing > most
                });
                if facing > ROUND && apart <= reach * reach && is_nearer {
                    best = Some((apart, facing, n as usize));
                }
            }
        });
        best.map(|(.., n)| n)
    }
}

/// Cosine between the directions that a wall and a panel look in; below any where they are not of the same body.
fn facing<const D: usize>(wall: &Wall<D>, panel: &Panel<D>) -> f64 {
    if wall.owner == panel.owner {
        -panel.normal.dot(&Vector::from(wall.image.normal))
    } else {
        f64::NEG_INFINITY
    }
}

/// The middles of a panel's pieces, all of one size.
fn pieces<const D: usize>(panel: &Panel<D>) -> Vec<Vector<D>> {
    let corners = &panel.corners;
    match D {
        1 => vec![panel.centre],
        2 => {
            let part = |n: usize| (n as f64 + 0.5) / PIECES as f64;
            let along = corners[1] - corners[0];
            (0..PIECES).map(|n| corners[0] + along * part(n)).collect()
        }
        _ => {
            let towards = |corner: &Vector<D>| (panel.centre + corner) * 0.5;
            let mut middles: Vec<_> = corners.iter().map(towards).collect();
            middles.push(panel.centre);
            middles
        }
    }
}
