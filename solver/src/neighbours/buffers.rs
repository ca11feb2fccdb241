//! Lists laid out flat: all entries one after the other, and where in them the clusters' begin.

use aero_geometry::parallel::prelude::*;

use super::Cluster;

/// Runs that are listed at once before their entries are laid out.
const WAVE: usize = 64;

/// Neighbour lists of all clusters.
#[derive(Clone, Debug, Default)]
pub struct Lists {
    /// Slots of neighbours, cluster after cluster.
    pub(super) entries: Vec<u32>,
    /// Clusters in order.
    pub(super) clusters: Vec<Cluster>,
    /// First cluster of each run, and the end.
    pub(super) runs: Vec<usize>,
    pub(super) lanes: usize,
    /// Room for a wave of runs before they are laid out.
    wave: Vec<Chunk>,
}

/// Neighbour lists of a run before they are laid out, with ranges in entries of its own.
#[derive(Clone, Debug, Default)]
pub(super) struct Chunk {
    pub(super) entries: Vec<u32>,
    pub(super) clusters: Vec<Cluster>,
}

impl Lists {
    /// Lays out `count` runs that `list(number, room)` writes into rooms of old.
    pub(super) fn assemble(&mut self, count: usize, list: impl Fn(usize, &mut Chunk) + Sync) {
        self.clusters.clear();
        self.runs.clear();
        self.runs.push(0);
        let mut end = 0;
        for first in (0..count).step_by(WAVE) {
            self.wave
                .resize_with((count - first).min(WAVE), Chunk::default);
            self.wave
                .par_iter_mut()
                .enumerate()
                .for_each(|(k, chunk)| list(first + k, chunk));
            end = self.lay_out(end);
        }
        self.entries.truncate(end);
    }

    /// Entries that there was room for before they were laid out: what was looked at.
    #[cfg(test)]
    pub fn room(&self) -> usize {
        let rooms = self.wave.iter().map(|chunk| chunk.entries.capacity());
        rooms.sum()
    }

    /// Appends the wave to what ends at `start`; returns where it ends now.
    fn lay_out(&mut self, start: usize) -> usize {
        let mut end = start;
        for chunk in &self.wave {
            let moved = |range: &std::ops::Range<usize>| range.start + end..range.end + end;
            self.clusters
                .extend(chunk.clusters.iter().map(|cluster| Cluster {
                    gas: moved(&cluster.gas),
                    wall: moved(&cluster.wall),
                    ..cluster.clone()
                }));
            self.runs.push(self.clusters.len());
            end += chunk.entries.len();
        }
        // What was there before is room for what comes.
        if self.entries.len() < end {
            self.entries.resize(end, 0);
        }
        let mut room = &mut self.entries[start..end];
        let mut copies = Vec::with_capacity(self.wave.len());
        for chunk in &self.wave {
            let (place, rest) = room.split_at_mut(chunk.entries.len());
            copies.push((place, &chunk.entries));
            room = rest;
        }
        copies
            .into_par_iter()
            .for_each(|(place, entries)| place.copy_from_slice(entries));
        end
    }
}
