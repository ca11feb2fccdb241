//! Images of particles beyond symmetry planes and periodic sides.

use aero_geometry::{Pencils, Vector};
use rayon::prelude::*;

use crate::records::{Near, Records, State};
use crate::sides::Domain;
use crate::sides::closed::Map;

/// A copy of a record: `x' = sign * x + shift` component by component.
#[derive(Clone, Copy, Debug)]
struct Image<const D: usize> {
    source: u32,
    sign: Vector<D>,
    shift: Vector<D>,
}

/// Images of one set of particles, sorted into pencils.
#[derive(Clone, Debug)]
pub struct Images<const D: usize> {
    images: Vec<Image<D>>,
    /// Their order in space.
    pub pencils: Pencils<D>,
}

/// All copies.
#[derive(Clone, Debug, Default)]
pub struct Copies<const D: usize> {
    /// Of fluid and buffers.
    pub gas: Images<D>,
    /// Of ghosts.
    pub ghosts: Images<D>,
}

impl<const D: usize> Default for Images<D> {
    fn default() -> Self {
        Self {
            images: Vec::new(),
            pencils: Pencils::default(),
        }
    }
}

impl<const D: usize> Images<D> {
    /// Number of images.
    pub fn len(&self) -> usize {
        self.images.len()
    }

    /// Images of the particles at `positions` that lie within `reach` of a plane, and images of
    /// images where planes meet.
    pub fn rebuild(&mut self, domain: &Domain<D>, positions: &[Vector<D>], reach: f64, width: f64) {
        self.images.clear();
        for axis in 0..D {
            let maps = Map::of_axis(domain, axis);
            if maps.iter().all(Option::is_none) {
                continue;
            }
            let (low, high) = (domain.bounds.min[axis], domain.bounds.max[axis]);
            let is_near = |place: f64| [place - low < reach, high - place < reach];
            let near: Vec<_> = positions
                .par_iter()
                .enumerate()
                .filter(|(_, position)| is_near(position[axis]).contains(&true))
                .map(|(source, _)| Image::identity(source))
                .collect();
            let earlier = self.images.clone();
            for base in near.into_iter().chain(earlier) {
                let place = base.place(positions[base.source as usize])[axis];
                for (map, is_near) in maps.into_iter().zip(is_near(place)) {
                    if let (Some(map), true) = (map, is_near) {
                        self.images.push(base.mapped(axis, map));
                    }
                }
            }
        }
        let places: Vec<_> = self
            .images
            .iter()
            .map(|image| image.place(positions[image.source as usize]))
            .collect();
        self.pencils.rebuild(&places, width);
        self.images = self
            .pencils
            .order()
            .iter()
            .map(|&n| self.images[n as usize])
            .collect();
    }

    /// Copies the records of the sources, which start with one segment, to the images' segment.
    pub fn refresh(&self, records: &mut Records<D>, sources: usize, images: usize) {
        self.refresh_near(records, sources, images);
        let (sources, first) = (records.start[sources], records.start[images]);
        // Images come after their sources.
        let (state, state_images) = records.state.split_at_mut(first);
        self.images
            .par_iter()
            .zip(state_images)
            .for_each(|(image, state_image)| {
                *state_image = image.state(&state[sources + image.source as usize]);
            });
    }

    /// Copies where the sources are and how they move.
    pub fn refresh_near(&self, records: &mut Records<D>, sources: usize, images: usize) {
        let (sources, first) = (records.start[sources], records.start[images]);
        let (near, near_images) = records.near.split_at_mut(first);
        self.images
            .par_iter()
            .zip(near_images)
            .for_each(|(image, near_image)| {
                *near_image = image.near(&near[sources + image.source as usize]);
            });
    }

    /// Source of image `number` and the reflection that maps vectors to it.
    pub fn source(&self, number: usize) -> (usize, Vector<D>) {
        (
            self.images[number].source as usize,
            self.images[number].sign,
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
