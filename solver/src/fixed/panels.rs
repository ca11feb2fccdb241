//! The surfaces themselves with the pressure on them: each piece shows what presses the wall of the cell that it belongs to.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::FixedSimulation;
use super::cancel::cancel;
use super::equation_of_state::EquationOfState;
use super::pieces::{Nearby, Piece};
use super::state::dot;
use super::unshown::{self, Left, Shown};
use super::viscous::WallShare;
use super::wall_fit::Around;
use super::walls::Wall;
use crate::frame::{Load, PanelFrame};
use crate::panels::fit::Fit;
use crate::panels::{Heated, Panel, Panels, Pressed};
use crate::problem::{Motion, Problem};
use crate::rings::Rings;
use crate::walls::rigid::{Pose, pad};

/// A wall is larger or smaller than what of the surfaces belongs to it by this part at most, as chords are than arcs.
const UNLIKE: f64 = 0.1;

/// What of the surfaces belongs to a wall.
struct Patch<const D: usize> {
    /// Its middle, as seen along the wall's normal.
    middle: Vector<D>,
    /// The wall's area over its own, as seen along it.
    ratio: f64,
    /// How the pressure on the walls around rises there.
    fit: Fit<D>,
}

impl<const D: usize> FixedSimulation<D> {
    /// The surfaces that the domain holds with the pressure on them now, bodies in scene order and wall sides after.
    pub fn panels(&self) -> PanelFrame {
        let panels = self.laid_panels();
        let walls: Vec<(&Wall<D>, f64)> = self.walls().collect();
        let nearby = Nearby::new(&walls, &self.points, self.problem.resolution.lattice());
        let pieces: Vec<Vec<Piece<D>>> = panels
            .all()
            .par_iter()
            .map(|panel| nearby.pieces(panel))
            .collect();
        let extents = extents(&self.problem, panels, &pieces, &walls);
        let around = Around::new(&nearby, &self.problem.domain);
        let reach = unshown::REACH * self.problem.resolution.lattice();
        let beyond = beyond(&walls, &extents, reach);
        let each = walls.par_iter().zip(&extents).zip(&beyond);
        let patches: Vec<Patch<D>> = each
            .map(|(((wall, _), extent), beyond)| Patch::new(&around, wall, extent, *beyond))
            .collect();
        let mut pressed: Vec<Pressed<D>> = (panels.all().par_iter().zip(&pieces))
            .map(|(panel, pieces)| self.pressed(panel, pieces, &walls, &patches))
            .collect();
        let spread = self.show_all(panels, &pieces, &walls, &patches, &mut pressed);
        let mut heated = Vec::new();
        if self.fluid.viscous.is_some() {
            let shares: Vec<&WallShare<D>> = self.wall_shares().collect();
            for (pieces, pressed) in pieces.iter().zip(&mut pressed) {
                let (friction, heat) = rubbed(pieces, &shares, &patches);
                pressed.friction = friction;
                heated.push(heat);
            }
        }
        let still = Pose::new(&Motion::none(), 0.0);
        PanelFrame {
            spread,
            ..panels.frame(&self.problem, self.tally.time, &pressed, &heated, |_| still)
        }
    }

    /// Loads of a pressure of one everywhere: on bodies, then on wall sides.
    pub fn uniform_loads(&self) -> Vec<Load> {
        self.uniform().to_vec()
    }

    /// The same, found once.
    pub(super) fn uniform(&self) -> &[Load] {
        let find = || self.laid_panels().uniform_loads(&self.problem);
        self.shown.uniform_loads.get_or_init(find)
    }

    fn laid_panels(&self) -> &Panels<D> {
        self.shown.panels.get_or_init(|| Panels::new(&self.problem))
    }

    /// What presses a panel: the mean over its pieces of the pressure on their walls, which is spread over what belongs to a wall
    /// as the pressure around rises. Neither is any of a wall's load lost nor shown twice, see [`Patch::shown`].
    fn pressed(
        &self,
        panel: &Panel<D>,
        pieces: &[Piece<D>],
        walls: &[(&Wall<D>, f64)],
        patches: &[Patch<D>],
    ) -> Pressed<D> {
        let calm = self.problem.free_stream.pressure;
        if panel.is_covered || pieces.is_empty() {
            return Pressed::calm(calm);
        }
        let mut pressed = Pressed::calm(0.0);
        for piece in pieces {
            let (wall, pressure) = &walls[piece.wall];
            let patch = &patches[piece.wall];
            pressed.pressure += piece.part * patch.shown(*pressure, &piece.place, calm);
            pressed.mach += piece.part * self.mach(wall.i as usize);
        }
        pressed
    }

    /// Adds to what panels show what presses walls beyond that: to their pressure, and what no pressure makes to their friction, but for gas with
    /// viscosity, whose own friction that is no part of. Returns the forces that the latter adds up to, by owner.
    fn show_all(
        &self,
        panels: &Panels<D>,
        pieces: &[Vec<Piece<D>>],
        walls: &[(&Wall<D>, f64)],
        patches: &[Patch<D>],
        pressed: &mut [Pressed<D>],
    ) -> Vec<[f64; 3]> {
        let calm = self.problem.free_stream.pressure;
        let rings = Rings::new(&self.problem);
        let mut left: Vec<Left<'_, D>> = (walls.iter())
            .map(|&(wall, pressure)| Left {
                wall,
                force: wall.image.area() * (self.around() * (pressure - calm)),
            })
            .collect();
        let (mut shown, mut theirs) = (Vec::new(), Vec::new());
        let each = panels.all().iter().zip(pieces).zip(pressed);
        let bounds = &self.problem.domain.bounds;
        for ((panel, pieces), pressed) in each {
            if panel.is_covered || pieces.is_empty() || !bounds.contains(&panel.centre) {
                continue;
            }
            let area = panel.size * rings.surface(&panel.centre);
            for piece in pieces {
                let (_, pressure) = walls[piece.wall];
                let over = patches[piece.wall].shown(pressure, &piece.place, calm) - calm;
                left[piece.wall].force += panel.normal * (area * piece.part * over);
            }
            shown.push(Shown { panel, area });
            theirs.push(pressed);
        }
        let spacing = self.problem.resolution.lattice();
        cancel(&mut left, unshown::REACH * spacing);
        let rest = unshown::spread(&left, &shown, spacing, &mut theirs);
        if self.fluid.viscous.is_some() {
            return Vec::new();
        }
        let mut forces = vec![Vector::<D>::zeros(); self.uniform().len()];
        for ((Shown { panel, area }, pressed), rest) in shown.iter().zip(theirs).zip(rest) {
            pressed.friction += rest;
            forces[panel.owner as usize] += rest * *area;
        }
        forces.iter().map(|force| pad(force).into()).collect()
    }

    fn mach(&self, cell: usize) -> f64 {
        let state = &self.columns.states[cell];
        let sound = self
            .fluid
            .gas
            .sound_square(state.density, state.pressure)
            .sqrt();
        dot(&state.velocity, &state.velocity).sqrt() / sound
    }
}

/// Friction and heat on a panel: the means over its pieces.
fn rubbed<const D: usize>(
    pieces: &[Piece<D>],
    shares: &[&WallShare<D>],
    patches: &[Patch<D>],
) -> (Vector<D>, Heated) {
    let mut friction = Vector::zeros();
    let mut heated = Heated::default();
    for piece in pieces {
        let share = shares[piece.wall];
        let size = piece.part * patches[piece.wall].ratio;
        friction -= Vector::from(share.stress) * size;
        heated.flux += size * share.heat;
        heated.temperature += piece.part * share.temperature;
    }
    (friction, heated)
}

/// Sums over what belongs to a wall.
#[derive(Clone, Copy)]
struct Extent<const D: usize> {
    /// Of areas as seen along the wall's normal; of lengths in the plane.
    size: f64,
    /// Of these areas times places.
    moment: Vector<D>,
}

/// By wall. A cell ends where the domain does.
fn extents<const D: usize>(
    problem: &Problem<D>,
    panels: &Panels<D>,
    pieces: &[Vec<Piece<D>>],
    walls: &[(&Wall<D>, f64)],
) -> Vec<Extent<D>> {
    let none = Extent {
        size: 0.0,
        moment: Vector::zeros(),
    };
    let mut extents = vec![none; walls.len()];
    let bounds = &problem.domain.bounds;
    let shown = panels.all().iter().zip(pieces);
    let is_seen = |panel: &Panel<D>| !panel.is_covered && bounds.contains(&panel.centre);
    for (panel, pieces) in shown.filter(|(panel, _)| is_seen(panel)) {
        for piece in pieces {
            let extent = &mut extents[piece.wall];
            // Walls point out of the gas, panels into it.
            let normal = -Vector::from(walls[piece.wall].0.image.normal);
            let size = panel.size * piece.part * panel.normal.dot(&normal);
            extent.size += size;
            extent.moment += piece.place * size;
        }
    }
    extents
}

/// By how much each wall is larger than what belongs to it, less what walls around it are smaller by.
fn beyond<const D: usize>(
    walls: &[(&Wall<D>, f64)],
    extents: &[Extent<D>],
    reach: f64,
) -> Vec<f64> {
    let normal = |wall: &Wall<D>| Vector::from(wall.image.normal);
    let each = walls.iter().zip(extents);
    let mut left: Vec<Left<'_, D>> = each
        .map(|(&(wall, _), extent)| Left {
            wall,
            force: normal(wall) * (wall.image.share - extent.size),
        })
        .collect();
    cancel(&mut left, reach);
    let left = left.iter();
    left.map(|left| left.force.dot(&normal(left.wall)))
        .collect()
}

impl<const D: usize> Patch<D> {
    fn new(around: &Around<'_, D>, wall: &Wall<D>, extent: &Extent<D>, beyond: f64) -> Self {
        let middle = if extent.size > 0.0 {
            extent.moment / extent.size
        } else {
            wall.foot
        };
        let ratio = 1.0 + beyond / extent.size;
        Self {
            middle,
            ratio: if (ratio - 1.0).abs() < UNLIKE {
                ratio
            } else {
                1.0
            },
            fit: around.fit(wall, &middle),
        }
    }

    /// What a place on it shows, where the pressure on the wall is `pressure`: what that has over the stream's, `calm`, which is of no force on
    /// all of a body, on the wall's area. It is made more or less by no larger a part of itself than the area is: beside a pressure far below
    /// the stream's, what areas are off by would be all that there is to see.
    fn shown(&self, pressure: f64, place: &Vector<D>, calm: f64) -> f64 {
        let pressure = self.pressure(pressure, place);
        pressure + (self.ratio - 1.0) * (pressure - calm).max(-pressure.abs())
    }

    /// Pressure at a place on it, where that on the wall is `pressure`.
    fn pressure(&self, pressure: f64, place: &Vector<D>) -> f64 {
        let rise = self.fit.slope().dot(&(place - self.middle));
        self.fit.bounded(pressure, pressure + rise)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use aero_geometry::bodies;

    use super::*;
    use crate::fixed::tests::flows::stream;

    /// The walls of a flow, each with the length of what of the surface belongs to it over its own.
    fn ratios(flow: &FixedSimulation<2>) -> Vec<(&Wall<2>, f64)> {
        let walls: Vec<(&Wall<2>, f64)> = flow.walls().collect();
        let nearby = Nearby::new(&walls, &flow.points, flow.problem.resolution.lattice());
        let panels = Panels::new(&flow.problem);
        let pieces: Vec<Vec<Piece<2>>> = (panels.all().iter())
            .map(|panel| nearby.pieces(panel))
            .collect();
        let extents = extents(&flow.problem, &panels, &pieces, &walls);
        let each = walls.iter().zip(&extents);
        each.map(|((wall, _), extent)| (*wall, wall.image.share / extent.size))
            .collect()
    }

    /// The last column of cells is 1.4 spacings wide, so that what belongs to its wall lies up to 1.3 spacings from its foot.
    #[test]
    fn walls_have_as_much_of_the_surface_as_they_are_long() {
        let corner = bodies::expansion_corner(0.0, 45.0).unwrap();
        let bounds = [[-0.5, -1.6], [1.2, 1.0]];
        let problem = stream(2.0, bounds, 1.0 / 32.0, vec![Arc::new(corner)]);
        let flow = FixedSimulation::new(problem).unwrap();
        for (wall, ratio) in ratios(&flow) {
            let is_off = (ratio - 1.0).abs() > 1e-6;
            assert!(!is_off || wall.foot[0] < 0.1, "{ratio} at {}", wall.foot);
        }
    }

    /// Behind its tip a wedge is so thin that the nearest point to places on one of its sides may lie beyond the other.
    #[test]
    fn walls_on_both_sides_of_a_thin_wedge_have_as_much_of_it_as_they_are_long() {
        let points = [[0.0, 0.0], [2.0, 0.28], [2.0, 0.42]];
        let wedge = bodies::polygon(&points.map(Vector::from)).unwrap();
        let problem = stream(
            2.0,
            [[-0.5, -1.0], [1.0, 1.0]],
            1.0 / 32.0,
            vec![Arc::new(wedge)],
        );
        let flow = FixedSimulation::new(problem).unwrap();
        for (wall, ratio) in ratios(&flow) {
            let is_off = (ratio - 1.0).abs() > 1e-3;
            assert!(!is_off || wall.foot[0] < 0.05, "{ratio} at {}", wall.foot);
        }
    }

    /// Of walls that are off by a twentieth.
    #[test]
    fn what_areas_are_off_by_does_not_show_beside_a_low_pressure() {
        let patch = Patch::<2> {
            middle: Vector::zeros(),
            ratio: 1.05,
            fit: Fit::new(),
        };
        let shown = |pressure: f64| patch.shown(pressure, &Vector::zeros(), 1.0);
        for (pressure, expected) in [(3.0, 3.1), (1.0, 1.0), (0.8, 0.79), (0.01, 0.0095)] {
            assert!((shown(pressure) - expected).abs() < 1e-12, "{pressure}");
        }
    }
}
