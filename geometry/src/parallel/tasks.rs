//! Numbered tasks, and the threads that do them.

use std::sync::{Mutex, PoisonError};

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::Parallel;

/// Tasks per thread: so many that threads which are done early find more.
const PER_THREAD: usize = 8;

/// What a task is given, and what it makes of that.
struct Task<P, R> {
    given: Option<P>,
    made: Option<R>,
}

/// Cuts `items` into tasks and does them; returns what `work` makes of each, in order.
pub(super) fn in_tasks<P: Parallel, R: Send>(items: P, work: impl Fn(P) -> R + Sync) -> Vec<R> {
    let threads = rayon::current_num_threads();
    let most = if threads > 1 { PER_THREAD * threads } else { 1 };
    let size = items.length().div_ceil(most).max(items.least()).max(1);
    let mut tasks = Vec::with_capacity(items.length() / size + 1);
    let task = |given| {
        Mutex::new(Task {
            given: Some(given),
            made: None,
        })
    };
    let mut rest = items;
    while rest.length() > size {
        let (first, later) = rest.part_at(size);
        tasks.push(task(first));
        rest = later;
    }
    tasks.push(task(rest));
    each_number(tasks.len(), &|number| {
        let mut task = tasks[number].lock().unwrap_or_else(PoisonError::into_inner);
        task.made = task.given.take().map(&work);
    });
    let made = |task: Mutex<Task<P, R>>| {
        let task = task.into_inner();
        task.unwrap_or_else(PoisonError::into_inner).made
    };
    tasks.into_iter().filter_map(made).collect()
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

/// Lists one after the other.
pub(super) fn joined<T>(mut lists: Vec<Vec<T>>) -> Vec<T> {
    if lists.len() == 1 {
        return lists.pop().unwrap_or_default();
    }
    let mut all = Vec::with_capacity(lists.iter().map(Vec::len).sum());
    for list in &mut lists {
        all.append(list);
    }
    all
}
