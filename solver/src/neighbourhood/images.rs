//! Images of particles beyond symmetry planes and periodic sides.

use aero_geometry::Vector;
use aero_geometry::parallel::prelude::*;

use super::levels::{Grid, Levels};
use crate::neighbours::{Candidates, Rough};
use crate::problem::Domain;
use crate::records::{FLOW_IMAGES, FLUID, GHOST_IMAGES, GHOSTS, Near, Records, State};
use crate::sides::closed::Map;

/// A copy of a record: `x' = sign * x + shift` component by component.
#[derive(Clone, Copy, Debug)]
struct Image<const D: usize> {
    source: u32,
    sign: Vector<D>,
    shift: Vector<D>,
}

/// A segment of records that are copies: whose they are copies of, which slots they have, and how they are brought up to date.
/// Copies beyond mirrors and periods are made here; particles that another process owns would be such a segment too, received
/// instead of mapped.
#[derive(Clone, Debug)]
pub struct Images<const D: usize> {
    /// First segment of the owner, fluid or ghosts; the sources are counted from its first slot.
    owner: usize,
    /// The copies' own segment.
    segment: usize,
    copies: Vec<Image<D>>,
    /// Their order in space.
    order: Levels<D>,
}

/// All copies.
#[derive(Clone, Debug)]
pub struct Copies<const D: usize> {
    /// Of fluid and buffers.
    pub gas: Images<D>,
    /// Of ghosts.
    pub ghosts: Images<D>,
}

impl<const D: usize> Default for Copies<D> {
    fn default() -> Self {
        Self {
            gas: Images::new(FLUID, FLOW_IMAGES),
            ghosts: Images::new(GHOSTS, GHOST_IMAGES),
        }
    }
}

impl<const D: usize> Images<D> {
    fn new(owner: usize, segment: usize) -> Self {
        Self {
            owner,
            segment,
            copies: Vec::new(),
            order: Levels::default(),
        }
    }

    /// Number of images.
    pub fn len(&self) -> usize {
        self.copies.len()
    }

    /// Images of those of `sources`, places with smoothing lengths, that lie within `reach` of their smoothing length of a
    /// plane, and images of images where planes meet.
    pub fn rebuild(
        &mut self,
        domain: &Domain<D>,
        grid: &Grid<D>,
        sources: &[(Vector<D>, f64)],
        reach: impl Fn(f64) -> f64 + Sync,
    ) {
        self.copies.clear();
        for axis in 0..D {
            let maps = Map::of_axis(domain, axis);
            if maps.iter().all(Option::is_none) {
                continue;
            }
            let (low, high) = (domain.bounds.min[axis], domain.bounds.max[axis]);
            let is_near = |place: f64, reach: f64| [place - low < reach, high - place < reach];
            let near: Vec<_> = sources
                .par_iter()
                .enumerate()
                .filter(|(_, (position, h))| is_near(position[axis], reach(*h)).contains(&true))
                .map(|(source, _)| Image::identity(source))
                .collect();
            let earlier = self.copies.clone();
            for base in near.into_iter().chain(earlier) {
                let (position, h) = sources[base.source as usize];
                let place = base.place(position)[axis];
                for (map, is_near) in maps.into_iter().zip(is_near(place, reach(h))) {
                    if let (Some(map), true) = (map, is_near) {
                        self.copies.push(base.mapped(axis, map));
                    }
                }
            }
        }
        let images = &self.copies;
        let copy = |n: usize| {
            let (position, h) = sources[images[n].source as usize];
            (images[n].place(position), h)
        };
        // Sources are in order already, and so are their copies.
        self.order.rebuild(grid, images.len(), copy, |n| n as u64);
        let order = self.order.order().iter();
        self.copies = order.map(|&n| self.copies[n as usize]).collect();
    }

    /// The images as candidates for neighbours in the gas.
    pub fn candidates<'a>(
        &'a self,
        rough: &'a Rough<D>,
        records: &Records<D>,
    ) -> impl Iterator<Item = Candidates<'a, D>> {
        self.order
            .candidates(rough, records.segment(self.segment).start)
    }

    /// Copies the records of the sources.
    pub fn refresh(&self, records: &mut Records<D>) {
        self.refresh_near(records);
        let (sources, first) = (records.start[self.owner], records.start[self.segment]);
        // Images come after their sources.
        let (state, state_images) = records.state.split_at_mut(first);
        self.copies
            .par_iter()
            .zip(state_images)
            .for_each(|(image, state_image)| {
                *state_image = image.state(&state[sources + image.source as usize]);
            });
    }

    /// Copies where the sources are and how they move.
    pub fn refresh_near(&self, records: &mut Records<D>) {
        let (sources, first) = (records.start[self.owner], records.start[self.segment]);
        let (near, near_images) = records.near.split_at_mut(first);
        self.copies
            .par_iter()
            .zip(near_images)
            .for_each(|(image, near_image)| {
                *near_image = image.near(&near[sources + image.source as usize]);
            });
        if records.are_two {
            for (n, image) in self.copies.iter().enumerate() {
                records.second[first + n] = records.second[sources + image.source as usize];
            }
        }
    }

    /// Copies what flows by viscosity and conduction through the sources.
    pub fn refresh_diffusive(&self, records: &mut Records<D>) {
        let (sources, first) = (records.start[self.owner], records.start[self.segment]);
        let (own, images) = records.diffusive.split_at_mut(first);
        self.copies
            .par_iter()
            .zip(images)
            .for_each(|(image, copy)| {
                *copy = own[sources + image.source as usize].reflected(&image.sign);
            });
    }

    /// Source of image `number` and the reflection that maps vectors to it.
    pub fn source(&self, number: usize) -> (usize, Vector<D>) {
        (
            self.copies[number].source as usize,
            self.copies[number].sign,
        )
    }

    /// Number `number` of the `sources` and their images after them: which source it is, and the reflection that maps
    /// vectors to it.
    pub fn seen<'a, T>(&self, sources: &'a [T], number: usize) -> (&'a T, Vector<D>) {
        match number.checked_sub(sources.len()) {
            None => (&sources[number], Vector::repeat(1.0)),
            Some(image) => {
                let (source, sign) = self.source(image);
                (&sources[source], sign)
            }
        }
    }
}

impl<const D: usize> Image<D> {
    fn identity(slot: usize) -> Self {
        Self {
            source: slot as u32,
            sign: Vector::repeat(1.0),
            shift: Vector::zeros(),
        }
    }

    fn mapped(mut self, axis: usize, map: Map) -> Self {
        self.sign[axis] *= map.sign;
        self.shift[axis] = map.sign * self.shift[axis] + map.shift;
        self
    }

    fn place(&self, position: Vector<D>) -> Vector<D> {
        self.sign.component_mul(&position) + self.shift
    }

    fn near(&self, source: &Near<D>) -> Near<D> {
        Near {
            position: self.place(source.position),
            velocity: self.sign.component_mul(&source.velocity),
            ..*source
        }
    }

    fn state(&self, source: &State<D>) -> State<D> {
        State {
            half_gradient: self.sign.component_mul(&source.half_gradient),
            strain: source.strain.reflected(&self.sign),
            energy_slope: self.sign.component_mul(&source.energy_slope),
            stress: source.stress.reflected(&self.sign),
            ..*source
        }
    }
}
