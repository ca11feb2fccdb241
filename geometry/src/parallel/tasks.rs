//! Numbered tasks, and the threads that do them.

use std::sync::{Mutex, PoisonError};

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::Parallel;

/// Tasks per thread: so many that threads which are done early find more.
const PER_THREAD: usize = 8;

/// Does `work` with `items`, cut into tasks.
pub(super) fn in_tasks<P: Parallel>(items: P, work: impl Fn(P) + Sync) {
    let size = size_of_tasks(items.length(), items.least());
    numbered(items, size, &|_, part| work(part));
}

/// What `work` makes of each task, in order.
pub(super) fn made_in_tasks<P: Parallel, R: Send>(
    items: P,
    work: impl Fn(P) -> R + Sync,
) -> Vec<R> {
    let size = size_of_tasks(items.length(), items.least());
    let mut made = Vec::new();
    made.resize_with(items.length().div_ceil(size).max(1), Mutex::default);
    numbered(items, size, &|number, part| keep(&made[number], work(part)));
    taken(made)
}

/// Items in a task.
fn size_of_tasks(length: usize, least: usize) -> usize {
    let threads = rayon::current_num_threads();
    let most = if threads > 1 { PER_THREAD * threads } else { 1 };
    length.div_ceil(most).max(least).max(1)
}

/// Does `work` with the tasks and their numbers.
fn numbered<P: Parallel>(items: P, size: usize, work: &(dyn Fn(usize, P) + Sync)) {
    let mut tasks = Vec::with_capacity(items.length() / size + 1);
    let mut rest = items;
    while rest.length() > size {
        let (first, later) = rest.part_at(size);
        tasks.push(Mutex::new(Some(first)));
        rest = later;
    }
    tasks.push(Mutex::new(Some(rest)));
    each_number(tasks.len(), &|number| {
        let mut task = tasks[number].lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(part) = task.take() {
            work(number, part);
        }
    });
}

/// Calls `work` with every number below `count`, on all threads. The one loop that rayon is compiled for.
#[inline(never)]
fn each_number(count: usize, work: &(dyn Fn(usize) + Sync)) {
    if count == 1 {
        work(0);
    } else {
        (0..count).into_par_iter().for_each(work);
    }
}

/// Keeps what a task made.
fn keep<R>(place: &Mutex<Option<R>>, made: R) {
    *place.lock().unwrap_or_else(PoisonError::into_inner) = Some(made);
}

/// All that was made.
fn taken<R>(made: Vec<Mutex<Option<R>>>) -> Vec<R> {
    let mut all = Vec::with_capacity(made.len());
    for place in made {
        all.extend(place.into_inner().unwrap_or_else(PoisonError::into_inner));
    }
    all
}

/// Lists one after the other.
pub(super) fn joined<T>(mut lists: Vec<Vec<T>>) -> Vec<T> {
    if lists.len() == 1 {
        return lists.pop().unwrap_or_default();
    }
    let mut all = Vec::with_capacity(lists.iter().map(Vec::len).sum());
    for list in lists {
        all.extend(list);
    }
    all
}
