//! A duct between slip walls: what is asked of a flow, and images of particles beyond the walls.

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;

use super::particle::Particle;
use crate::points::cloud::{Cloud, SMOOTHING_RATIO};

/// Density, kg/m^3.
pub const DENSITY: f64 = 1.0;
/// Layers of particles in the buffers of both sides.
pub const LAYERS: usize = 6;
/// Sound crosses a spacing in so many steps [Negi et al. 2020, eq 29].
const STEPS: f64 = 4.0;

/// A duct and the gas in it.
#[derive(Clone, Copy, Debug)]
pub struct Duct {
    /// m.
    pub length: f64,
    /// Rows of particles from wall to wall.
    pub rows: usize,
    /// m.
    pub spacing: f64,
    /// Speed of sound, m/s.
    pub sound: f64,
    /// Speed of the stream, m/s, which waves are told from.
    pub stream: f64,
    /// Of the damping of pressure [eq 3].
    pub damping: f64,
    /// Kinematic, m^2/s.
    pub viscosity: f64,
    /// Velocity of the gas that comes in, m/s, at a place and time, given the stream's speed.
    pub inflow: fn(&Vector<2>, f64, f64) -> [f64; 2],
}

impl Duct {
    pub fn step(&self) -> f64 {
        self.spacing / (STEPS * (self.stream + self.sound))
    }

    /// `alpha h c / 8`, m^2/s [eq 3].
    pub fn diffusion(&self) -> f64 {
        self.damping * SMOOTHING_RATIO * self.spacing * self.sound / 8.0
    }

    /// Distance of the walls, m.
    pub fn width(&self) -> f64 {
        self.rows as f64 * self.spacing
    }

    /// Depth of the buffers, m.
    pub fn depth(&self) -> f64 {
        LAYERS as f64 * self.spacing
    }

    /// How far a particle hears, m.
    pub fn reach(&self) -> f64 {
        SUPPORT * SMOOTHING_RATIO * self.spacing
    }

    /// Velocity of the gas that comes in at a place and time, m/s.
    pub fn entering(&self, place: &Vector<2>, time: f64) -> [f64; 2] {
        (self.inflow)(place, time, self.stream)
    }

    /// Particles on a lattice over a part of the duct, as fast along it as the gas that comes in first.
    pub fn lattice(&self, [from, to]: [f64; 2]) -> Vec<Particle> {
        let columns = ((to - from) / self.spacing).round() as usize;
        let at = |column: usize, row: usize| {
            let [x, y] = [column, row].map(|k| (k as f64 + 0.5) * self.spacing);
            let place = Vector::<2>::new(from + x, y - 0.5 * self.width());
            let [u, _] = self.entering(&Vector::<2>::zeros(), 0.0);
            Particle::new(place, [0.0, u, 0.0])
        };
        let column = |column| (0..self.rows).map(move |row| at(column, row));
        (0..columns).flat_map(column).collect()
    }
}

/// Particles and their images beyond the walls, as points that can be read.
#[derive(Clone, Debug)]
pub struct Crowd {
    pub cloud: Cloud,
    /// The particle that a point shows, and 1, or -1 where it moves the other way across the duct.
    shows: Vec<(u32, f64)>,
}

impl Crowd {
    /// Of particles in this order, which come first.
    pub fn new<'a>(particles: impl Iterator<Item = &'a Particle>, duct: &Duct) -> Self {
        let mut points: Vec<Vector<2>> = particles.map(|particle| particle.position).collect();
        let count = points.len();
        let mut shows: Vec<(u32, f64)> = (0..count).map(|i| (i as u32, 1.0)).collect();
        let (width, reach) = (duct.width(), duct.reach());
        let folds = (reach / width).ceil() as i32;
        for fold in (-folds..=folds).filter(|fold| *fold != 0) {
            let way = if fold % 2 == 0 { 1.0 } else { -1.0 };
            for i in 0..count {
                let place = points[i];
                let beyond = f64::from(fold) * width + way * place.y;
                if beyond.abs() < 0.5 * width + reach {
                    points.push(Vector::<2>::new(place.x, beyond));
                    shows.push((i as u32, way));
                }
            }
        }
        Self {
            cloud: Cloud::new(points, duct.spacing),
            shows,
        }
    }

    /// The particle that a point shows.
    pub fn owner(&self, point: usize) -> usize {
        self.shows[point].0 as usize
    }

    /// The state of a point, given the particles.
    pub fn state(&self, point: usize, particles: &[Particle]) -> [f64; 3] {
        let (i, way) = self.shows[point];
        let [p, u, v] = particles[i as usize].state;
        [p, u, way * v]
    }

    /// The states of all points, given the particles.
    pub fn states(&self, particles: &[Particle]) -> Vec<[f64; 3]> {
        let state = |point| self.state(point, particles);
        (0..self.shows.len()).map(state).collect()
    }
}
