//! One evaluation from beginning to end, by the passes of the reference.

use aero_geometry::Vector;

use super::gas::{Renormalised, density, drift, rate, renormalise, smoothness};
use super::wall::{force, shield, show};
use super::{Laws, Map, Point, Rate, Viscous, Wall, diffusion, images};

/// All that there is at one time.
#[derive(Clone, Debug)]
pub struct World<const D: usize> {
    /// Gas that moves by the equations.
    pub gas: Vec<Point<D>>,
    pub buffers: Vec<Point<D>>,
    pub walls: Vec<Wall<D>>,
    /// What planes and periodic sides do.
    pub maps: [Vec<Map>; D],
}

/// What is asked of the evaluation beside the laws.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    pub laws: Laws,
    pub mirrors: bool,
    pub shield: bool,
    pub shifting: bool,
}

/// What an evaluation finds.
pub struct Evaluation<const D: usize> {
    pub walls: Vec<Wall<D>>,
    pub renormalised: Vec<Renormalised<D>>,
    pub rates: Vec<Rate<D>>,
    pub smoothness: Vec<f64>,
    /// What the gas does to the ghosts.
    pub on_ghosts: Vec<OnGhost<D>>,
}

/// What the gas does to a ghost.
#[derive(Clone, Copy, Debug)]
pub struct OnGhost<const D: usize> {
    pub force: Vector<D>,
    /// What of it viscosity makes.
    pub friction: Vector<D>,
    /// Heat that goes into it.
    pub heat: f64,
}

impl<const D: usize> World<D> {
    /// Gas, buffers and images of both.
    pub fn all_gas(&self) -> Vec<Point<D>> {
        let mut all = [self.gas.as_slice(), &self.buffers].concat();
        all.extend(images(&self.maps, &all));
        all
    }

    /// Ghosts and their images.
    pub fn all_ghosts(&self) -> Vec<Point<D>> {
        let mut all: Vec<_> = self.walls.iter().map(|wall| wall.point).collect();
        all.extend(images(&self.maps, &all));
        all
    }

    /// Ghosts and their images as the shield asks of them: with normal and velocity of the wall.
    fn all_walls(&self) -> Vec<Wall<D>> {
        let as_points = |wall: &Wall<D>| Point {
            velocity: wall.surface_velocity,
            shift: wall.normal,
            ..wall.point
        };
        let points: Vec<_> = self.walls.iter().map(as_points).collect();
        let reflected = images(&self.maps, &points);
        // One block of images per combination of maps, each in the order of its sources.
        let sources = self.walls.iter().cycle();
        let each = reflected
            .into_iter()
            .zip(sources)
            .map(|(point, wall)| Wall {
                normal: point.shift,
                surface_velocity: point.velocity,
                point,
                ..*wall
            });
        self.walls.iter().copied().chain(each).collect()
    }

    /// The densities that are read off the particles.
    pub fn densities(&self) -> Vec<f64> {
        let (gas, ghosts) = (self.all_gas(), self.all_ghosts());
        let each = self
            .gas
            .iter()
            .map(|i| density(i, &i.near(&gas), &i.near(&ghosts)));
        each.collect()
    }

    /// Adds what viscosity and conduction do, from the gradients in `rates`. Gas in buffers has those of an even stream.
    fn diffuse(
        &self,
        viscous: Viscous,
        room: &impl Fn(&Vector<D>) -> f64,
        rates: &mut [Rate<D>],
        on_ghosts: &mut [OnGhost<D>],
    ) {
        let mut world = self.clone();
        for (i, rate) in world.gas.iter_mut().zip(&*rates) {
            i.strain = rate.velocity_gradient;
            i.energy_slope = rate.energy_gradient;
        }
        for open in &mut world.buffers {
            open.strain.fill(0.0);
            open.energy_slope.fill(0.0);
        }
        let gas = world.all_gas();
        for wall in &mut world.walls {
            wall.point = diffusion::with_gradients(viscous, wall, &wall.point.near(&gas));
        }
        let ghosts = world.all_ghosts();
        for (i, rate) in world.gas.iter().zip(rates) {
            diffusion::add(viscous, i, &i.near(&gas), &i.near(&ghosts), rate);
        }
        for (wall, on_ghost) in world.walls.iter().zip(on_ghosts) {
            let pressing = pressing(wall, &gas, room);
            on_ghost.friction = diffusion::friction(viscous, &wall.point, &pressing);
            on_ghost.force += on_ghost.friction;
            on_ghost.heat = diffusion::heat(viscous, &wall.point, &pressing);
        }
    }

    /// Ghosts, renormalisation, shifts, rates and forces. `room` is the distance from the nearest open side.
    pub fn evaluate(mut self, asked: Asked, room: impl Fn(&Vector<D>) -> f64) -> Evaluation<D> {
        let Asked { laws, .. } = asked;
        let gas = self.all_gas();
        for wall in &mut self.walls {
            *wall = show(wall, &gas, asked.mirrors, laws);
        }
        let ghosts = self.all_ghosts();
        let walls = self.all_walls();
        let renormalised: Vec<_> = self
            .gas
            .iter()
            .map(|i| renormalise(i, &i.near(&gas), &i.near(&ghosts)))
            .collect();
        for (i, renormalised) in self.gas.iter_mut().zip(&renormalised) {
            i.renormalisation = renormalised.matrix;
            if laws.published {
                i.density_gradient = renormalised.density_gradient;
            }
            if asked.shifting && room(&i.position) >= 3.0 * i.h {
                i.shift = drift(i, renormalised);
            }
            if asked.shield {
                i.shift += shield(i, &walls);
            }
        }
        let gas = self.all_gas();
        let each = self.gas.iter();
        let each = each.map(|i| rate(laws, i, &i.near(&gas), &i.near(&ghosts)));
        let mut rates: Vec<_> = each.collect();
        let pressed = self.walls.iter().map(|wall| OnGhost {
            force: force(laws, &wall.point, &pressing(wall, &gas, &room)),
            friction: Vector::zeros(),
            heat: 0.0,
        });
        let mut on_ghosts: Vec<_> = pressed.collect();
        if let Some(viscous) = laws.viscous {
            self.diffuse(viscous, &room, &mut rates, &mut on_ghosts);
        }
        let both = self.gas.iter().zip(&rates);
        Evaluation {
            smoothness: both.map(|(i, rate)| smoothness(i, rate, 0.0)).collect(),
            on_ghosts,
            walls: self.walls,
            renormalised,
            rates,
        }
    }
}

/// The gas in reach whose line to a ghost goes through the wall within open sides.
fn pressing<const D: usize>(
    wall: &Wall<D>,
    gas: &[Point<D>],
    room: &impl Fn(&Vector<D>) -> f64,
) -> Vec<Point<D>> {
    let presses = |gas: &&Point<D>| {
        let line = gas.position - wall.point.position;
        let across = line.dot(&wall.normal);
        let share = wall.depth / across.max(wall.depth);
        room(&(wall.point.position + line * share)) >= 0.0
    };
    let near = wall.point.near(gas);
    near.iter().filter(presses).copied().collect()
}
