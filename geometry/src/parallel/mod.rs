//! Work on many items at once.
//!
//! The iterators are used as rayon's are, and rayon's threads do the work, but its scheduler is compiled once, for tasks of any kind, and
//! not anew for each loop in each dimension: that was two fifths of the solver's code, and of the time to compile it. Loops of few elements
//! begin on the thread that has them, and others are woken only where what is left is seen to be worth it.

mod adaptors;
mod sources;
mod tasks;
#[cfg(test)]
mod tests;

use std::mem;
use std::sync::{Mutex, PoisonError};

pub use adaptors::{Copied, Enumerate, Filter, FilterMap, FlatMap, Map, MinLen, Zip};
pub use sources::{Chunks, ChunksMut, IntoParallel, Numbers, Slices, Windows};
use tasks::in_parts;

/// What loops need.
pub mod prelude {
    pub use super::{IntoParallel, Parallel, Slices};
}

/// Items that can be parted and worked on at once. Results come in the order of the items, whatever the threads.
///
/// Closures are copied to every task: what they borrow is shared.
pub trait Parallel: Sized + Send {
    /// What each step of the iterator gives.
    type Item;
    /// The items of one task, one after the other.
    type Serial: Iterator<Item = Self::Item>;

    /// Number of items, before any filter.
    fn length(&self) -> usize;

    /// The first `place` items, and the rest.
    fn part_at(self, place: usize) -> (Self, Self);

    /// The items, one after the other.
    fn serial(self) -> Self::Serial;

    /// Number of elements in all items: those in chunks count each.
    fn elements(&self) -> usize {
        self.length()
    }

    /// The least number of items that is worth a task.
    fn least(&self) -> usize {
        1
    }

    /// Tasks of at least `least` items.
    fn with_min_len(self, least: usize) -> MinLen<Self> {
        MinLen { inner: self, least }
    }

    /// Pairs of items, as many as both have.
    fn zip<Q: IntoParallel>(self, other: Q) -> Zip<Self, Q::Iter> {
        Zip(self, other.into_par_iter())
    }

    /// Items with their numbers.
    fn enumerate(self) -> Enumerate<Self> {
        Enumerate {
            inner: self,
            first: 0,
        }
    }

    /// `change(item)` for every item.
    fn map<R, F: Fn(Self::Item) -> R + Clone + Send>(self, change: F) -> Map<Self, F> {
        Map {
            inner: self,
            change,
        }
    }

    /// The items for which `keep` holds.
    fn filter<F: Fn(&Self::Item) -> bool + Clone + Send>(self, keep: F) -> Filter<Self, F> {
        Filter { inner: self, keep }
    }

    /// What `change` makes of the items, where it makes something.
    fn filter_map<R, F: Fn(Self::Item) -> Option<R> + Clone + Send>(
        self,
        change: F,
    ) -> FilterMap<Self, F> {
        FilterMap {
            inner: self,
            change,
        }
    }

    /// Whatever `change` makes of each item, one after the other.
    fn flat_map_iter<R: IntoIterator, F: Fn(Self::Item) -> R + Clone + Send>(
        self,
        change: F,
    ) -> FlatMap<Self, F> {
        FlatMap {
            inner: self,
            change,
        }
    }

    /// Copies of items behind references.
    fn copied<'a, T: Copy + 'a>(self) -> Copied<Self>
    where
        Self: Parallel<Item = &'a T>,
    {
        Copied(self)
    }

    /// Does `work` with every item.
    fn for_each(self, work: impl Fn(Self::Item) + Sync) {
        in_parts(self, &|_, part| part.serial().for_each(&work));
    }

    /// All items in order.
    fn collect<C: FromIterator<Self::Item>>(self) -> C
    where
        Self::Item: Send,
    {
        let lists = Mutex::new(Vec::new());
        in_parts(self, &|number, part| {
            keep(&lists, number, part.serial().collect());
        });
        joined(lists).into_iter().collect()
    }

    /// The same into a vector whose room is used again. For iterators that do not filter.
    fn collect_into_vec(self, target: &mut Vec<Self::Item>)
    where
        Self::Item: Send,
    {
        target.truncate(self.length());
        let (known, more) = self.part_at(target.len());
        known
            .zip(target.as_mut_slice())
            .for_each(|(item, place)| *place = item);
        target.extend(more.serial());
    }

    /// The items folded by `merge`, which must not depend on their order, starting from `start`.
    fn reduce(
        self,
        start: impl Fn() -> Self::Item + Sync,
        merge: impl Fn(Self::Item, Self::Item) -> Self::Item + Sync,
    ) -> Self::Item
    where
        Self::Item: Send,
    {
        let all = Mutex::new(start());
        in_parts(self, &|_, part| {
            let more = part.serial().fold(start(), &merge);
            let mut all = all.lock().unwrap_or_else(PoisonError::into_inner);
            *all = merge(mem::replace(&mut *all, start()), more);
        });
        all.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Keeps the list of the part with this number.
fn keep<T>(lists: &Mutex<Vec<Vec<T>>>, number: usize, list: Vec<T>) {
    let mut lists = lists.lock().unwrap_or_else(PoisonError::into_inner);
    while lists.len() <= number {
        lists.push(Vec::new());
    }
    lists[number] = list;
}

/// Lists one after the other.
fn joined<T>(lists: Mutex<Vec<Vec<T>>>) -> Vec<T> {
    let lists = lists.into_inner().unwrap_or_else(PoisonError::into_inner);
    let length: usize = lists.iter().map(Vec::len).sum();
    let mut lists = lists.into_iter();
    let mut all = lists.next().unwrap_or_default();
    all.reserve_exact(length - all.len());
    for list in lists {
        all.extend(list);
    }
    all
}
