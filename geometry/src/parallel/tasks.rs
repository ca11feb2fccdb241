//! Numbered tasks, and the threads that do them.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::Parallel;

/// Tasks per thread: so many that threads which are done early find more.
const PER_THREAD: usize = 8;

/// Seconds of work that are worth a task: to wake a thread takes nearly as long.
const WORTH: f64 = 20e-6;

/// Seconds after which the first items have shown how long the others take.
const SEEN: f64 = 0.5 * WORTH;

/// Does `work` with `items`, cut into tasks.
pub(super) fn in_tasks<P: Parallel>(items: P, work: impl Fn(P) + Sync) {
    made_in_tasks(items, work);
}

/// What `work` makes of each task, in order.
pub(super) fn made_in_tasks<P: Parallel, R: Send>(
    items: P,
    work: impl Fn(P) -> R + Sync,
) -> Vec<R> {
    // One function, however often it is called here.
    let work: &(dyn Fn(P) -> R + Sync) = &work;
    let threads = rayon::current_num_threads();
    if threads == 1 {
        return vec![work(items)];
    }
    let mut made = Vec::new();
    let Some(Rest { items, each }) = begun(items, work, &mut made) else {
        return made;
    };
    let (length, least) = (items.length(), items.least().max(1));
    let worth = (each * length as f64 / WORTH) as usize;
    let size = length.div_ceil(worth.clamp(1, PER_THREAD * threads));
    let size = size.max(least);
    let mut rest = Vec::new();
    rest.resize_with(length.div_ceil(size), Mutex::default);
    numbered(items, size, &|number, part| keep(&rest[number], work(part)));
    made.extend(taken(rest));
    made
}

/// Items that are left, and the seconds that each takes.
struct Rest<P> {
    items: P,
    each: f64,
}

/// Works on `items` until it is seen how long they take; none is left of a few, which are done before other threads have woken.
fn begun<P: Parallel, R>(items: P, work: &dyn Fn(P) -> R, made: &mut Vec<R>) -> Option<Rest<P>> {
    let start = Instant::now();
    let (mut rest, mut few, mut done) = (items, 0, 0);
    loop {
        few = (2 * few).max(rest.least()).max(1);
        if rest.length() <= few {
            made.push(work(rest));
            return None;
        }
        let (first, later) = rest.part_at(few);
        made.push(work(first));
        (rest, done) = (later, done + few);
        let seconds = start.elapsed().as_secs_f64();
        if seconds > SEEN {
            let each = seconds / done as f64;
            return Some(Rest { items: rest, each });
        }
    }
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
