//! Waves that come in through outlets that relax to a pressure: each face has its own, which changes in time by what the outlet asks for alone.
//!
//! Told from the gas in front of the face, from what flows along the side there, such a wave is off by all that is off in that: the pressure
//! at the end of a duct that widens was up to 4 % too high for good, and gas along its wall came to rest. With a life of its own it changes
//! until the pressure at its face is the one that is held.

use aero_geometry::Vector;

use super::FixedSimulation;
use super::nearby::Nearby;
use super::sides::{Beyond, Side};
use crate::sides::{Along, Held, Incoming};

/// Such an outlet, as a face sees it.
#[derive(Clone, Copy, Debug)]
pub struct Riding {
    held: Held,
    /// None before the first step: that of the gas itself.
    wave: Option<Incoming>,
}

impl Riding {
    /// A face of the outlet `held`.
    pub fn new(held: Held) -> Self {
        Self { held, wave: None }
    }

    /// The same at another pressure.
    #[must_use]
    pub fn at(self, pressure: f64) -> Self {
        Self {
            held: self.held.at(pressure),
            ..self
        }
    }

    /// What is beyond gas that reaches the face in this state, its speed out of the domain.
    pub fn beyond(&self, gas: &Along) -> Along {
        self.wave.map_or(*gas, |wave| self.held.behind(&wave, gas))
    }

    /// Lets a `step` pass, at the end of which gas reaches the face in this state.
    pub fn go_on(&mut self, gas: &Along, parting: f64, step: f64) {
        let own = self.held.own(gas).parting(parting);
        let wave = self.wave.unwrap_or(own);
        self.wave = Some(self.held.later(&wave, gas, parting, step));
    }
}

impl<const D: usize> FixedSimulation<D> {
    fn riding(&self) -> impl Iterator<Item = (&Side<D>, &Riding)> {
        let sides = self.net.blocks.iter().flat_map(|block| &block.sides);
        sides.filter_map(|side| match &side.beyond {
            Beyond::Rides(riding) => Some((side, riding)),
            _ => None,
        })
    }

    fn riding_mut(&mut self) -> impl Iterator<Item = (Vector<D>, &mut Riding)> {
        let points = &self.points;
        let sides = self.net.blocks.iter_mut();
        let sides = sides.flat_map(|block| &mut block.sides);
        sides.filter_map(|side| {
            let middle = points[side.i as usize] + Vector::from(side.way());
            match &mut side.beyond {
                Beyond::Rides(riding) => Some((middle, riding)),
                _ => None,
            }
        })
    }

    /// Lets a `step` pass for all that come in.
    pub(super) fn ride(&mut self, step: f64) {
        let Self { net, columns, .. } = self;
        for side in net.blocks.iter_mut().flat_map(|block| &mut block.sides) {
            if let Beyond::Rides(mut riding) = side.beyond {
                let i = side.i as usize;
                let slopes = &columns.slopes[i];
                let gas = side.reaching(&columns.states[i], slopes);
                riding.go_on(&gas, side.parting(slopes), step);
                side.beyond = Beyond::Rides(riding);
            }
        }
    }

    /// All that come in, in the order of the faces.
    pub(super) fn waves(&self) -> Vec<Option<Incoming>> {
        self.riding().map(|(_, riding)| riding.wave).collect()
    }

    /// Lets these come in instead.
    pub(super) fn set_waves(&mut self, waves: &[Option<Incoming>]) {
        for ((_, riding), wave) in self.riding_mut().zip(waves) {
            riding.wave = *wave;
        }
    }

    /// All that come in, each with the middle of its face.
    pub(super) fn placed_waves(&self) -> Vec<(Vector<D>, Incoming)> {
        let placed = self.riding().filter_map(|(side, riding)| {
            let middle = self.points[side.i as usize] + Vector::from(side.way());
            Some((middle, riding.wave?))
        });
        placed.collect()
    }

    /// Lets the nearest of `placed` come in through each face.
    pub(super) fn take_over_waves(&mut self, placed: &[(Vector<D>, Incoming)]) {
        let places: Vec<Vector<D>> = placed.iter().map(|(middle, _)| *middle).collect();
        let nearby = Nearby::new(&places);
        let spacing = self.problem.spacing;
        for (middle, riding) in self.riding_mut() {
            let nearest = nearby.nearest(&middle, spacing);
            riding.wave = nearest.map(|number| placed[number as usize].1);
        }
    }
}
