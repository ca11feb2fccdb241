//! The waves that come in through the faces of outlets, see [`super::riding`]: they go on with each step, and outlive points and runs.

use aero_geometry::Vector;

use super::FixedSimulation;
use super::beyond::Beyond;
use super::nearby::Nearby;
use super::riding::Riding;
use super::sides::Side;
use crate::sides::Incoming;

impl<const D: usize> FixedSimulation<D> {
    fn riding(&self) -> impl Iterator<Item = (&Side<D>, &Riding)> {
        let sides = self.net.blocks.iter().flat_map(|block| &block.sides);
        sides.filter_map(|side| match &side.beyond {
            Beyond::Rides(riding, _) => Some((side, riding)),
            _ => None,
        })
    }

    fn riding_mut(&mut self) -> impl Iterator<Item = (Vector<D>, &mut Riding)> {
        let points = &self.points;
        let sides = self.net.blocks.iter_mut();
        let sides = sides.flat_map(|block| &mut block.sides);
        sides.filter_map(|side| {
            let way = Vector::from(side.way());
            match &mut side.beyond {
                Beyond::Rides(riding, _) => Some((points[side.i as usize] + way, riding)),
                _ => None,
            }
        })
    }

    /// Lets a `step` pass for all that come in.
    pub(super) fn ride(&mut self, step: f64) {
        let Self { net, columns, .. } = self;
        for side in net.blocks.iter_mut().flat_map(|block| &mut block.sides) {
            if let Beyond::Rides(mut riding, drift) = side.beyond {
                let i = side.i as usize;
                let slopes = &columns.slopes[i];
                let gas = side.reaching(&columns.states[i], slopes);
                riding.go_on(&gas, side.parting(slopes), step);
                side.beyond = Beyond::Rides(riding, drift);
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
        let spacing = self.problem.resolution.lattice();
        for (middle, riding) in self.riding_mut() {
            let nearest = nearby.nearest(&middle, spacing);
            riding.wave = nearest.map(|number| placed[number as usize].1);
        }
    }
}
