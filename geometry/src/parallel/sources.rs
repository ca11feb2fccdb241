//! What can be worked on at once: slices and their chunks, vectors, ranges.

use std::ops::Range;

use super::Parallel;

/// What an iterator can be made of.
pub trait IntoParallel {
    /// The iterator.
    type Iter: Parallel;

    /// Makes it.
    fn into_par_iter(self) -> Self::Iter;
}

impl<P: Parallel> IntoParallel for P {
    type Iter = P;

    fn into_par_iter(self) -> P {
        self
    }
}

impl<'a, T: Sync> IntoParallel for &'a Vec<T> {
    type Iter = &'a [T];

    fn into_par_iter(self) -> &'a [T] {
        self
    }
}

impl<'a, T: Send> IntoParallel for &'a mut Vec<T> {
    type Iter = &'a mut [T];

    fn into_par_iter(self) -> &'a mut [T] {
        self
    }
}

/// Iterators over slices.
pub trait Slices<T> {
    /// References to the items.
    fn par_iter(&self) -> &[T];

    /// References that may change them.
    fn par_iter_mut(&mut self) -> &mut [T];

    /// Runs of `size` items; the last may be shorter.
    fn par_chunks(&self, size: usize) -> Chunks<'_, T>;

    /// The same to change.
    fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T>;

    /// Every run of `size` items.
    fn par_windows(&self, size: usize) -> Windows<'_, T>;
}

impl<T> Slices<T> for [T] {
    fn par_iter(&self) -> &[T] {
        self
    }

    fn par_iter_mut(&mut self) -> &mut [T] {
        self
    }

    fn par_chunks(&self, size: usize) -> Chunks<'_, T> {
        Chunks { items: self, size }
    }

    fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T> {
        ChunksMut { items: self, size }
    }

    fn par_windows(&self, size: usize) -> Windows<'_, T> {
        Windows { items: self, size }
    }
}

impl<'a, T: Sync> Parallel for &'a [T] {
    type Item = &'a T;
    type Serial = std::slice::Iter<'a, T>;

    fn length(&self) -> usize {
        <[T]>::len(self)
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        self.split_at(place)
    }

    fn serial(self) -> Self::Serial {
        self.iter()
    }
}

impl<'a, T: Send> Parallel for &'a mut [T] {
    type Item = &'a mut T;
    type Serial = std::slice::IterMut<'a, T>;

    fn length(&self) -> usize {
        <[T]>::len(self)
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        self.split_at_mut(place)
    }

    fn serial(self) -> Self::Serial {
        self.iter_mut()
    }
}

impl<T: Send> Parallel for Vec<T> {
    type Item = T;
    type Serial = std::vec::IntoIter<T>;

    fn length(&self) -> usize {
        Vec::len(self)
    }

    fn part_at(mut self, place: usize) -> (Self, Self) {
        let rest = self.split_off(place);
        (self, rest)
    }

    fn serial(self) -> Self::Serial {
        self.into_iter()
    }
}

/// Numbers in order.
pub struct Numbers(Range<usize>);

impl IntoParallel for Range<usize> {
    type Iter = Numbers;

    fn into_par_iter(self) -> Numbers {
        Numbers(self)
    }
}

impl Parallel for Numbers {
    type Item = usize;
    type Serial = Range<usize>;

    fn length(&self) -> usize {
        self.0.len()
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let middle = self.0.start + place;
        (Self(self.0.start..middle), Self(middle..self.0.end))
    }

    fn serial(self) -> Range<usize> {
        self.0
    }
}

/// See [`Slices::par_chunks`].
pub struct Chunks<'a, T> {
    items: &'a [T],
    size: usize,
}

impl<'a, T: Sync> Parallel for Chunks<'a, T> {
    type Item = &'a [T];
    type Serial = std::slice::Chunks<'a, T>;

    fn length(&self) -> usize {
        self.items.len().div_ceil(self.size)
    }

    fn elements(&self) -> usize {
        self.items.len()
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let size = self.size;
        let middle = (place * size).min(self.items.len());
        let (first, rest) = self.items.split_at(middle);
        let part = |items| Self { items, size };
        (part(first), part(rest))
    }

    fn serial(self) -> Self::Serial {
        self.items.chunks(self.size)
    }
}

/// See [`Slices::par_chunks_mut`].
pub struct ChunksMut<'a, T> {
    items: &'a mut [T],
    size: usize,
}

impl<'a, T: Send> Parallel for ChunksMut<'a, T> {
    type Item = &'a mut [T];
    type Serial = std::slice::ChunksMut<'a, T>;

    fn length(&self) -> usize {
        self.items.len().div_ceil(self.size)
    }

    fn elements(&self) -> usize {
        self.items.len()
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let size = self.size;
        let middle = (place * size).min(self.items.len());
        let (first, rest) = self.items.split_at_mut(middle);
        (Self { items: first, size }, Self { items: rest, size })
    }

    fn serial(self) -> Self::Serial {
        self.items.chunks_mut(self.size)
    }
}

/// See [`Slices::par_windows`].
pub struct Windows<'a, T> {
    items: &'a [T],
    size: usize,
}

impl<'a, T: Sync> Parallel for Windows<'a, T> {
    type Item = &'a [T];
    type Serial = std::slice::Windows<'a, T>;

    fn length(&self) -> usize {
        (self.items.len() + 1).saturating_sub(self.size)
    }

    fn part_at(self, place: usize) -> (Self, Self) {
        let Self { items, size } = self;
        let shared = (place + size - 1).min(items.len());
        let part = |items| Self { items, size };
        (part(&items[..shared]), part(&items[place..]))
    }

    fn serial(self) -> Self::Serial {
        self.items.windows(self.size)
    }
}
