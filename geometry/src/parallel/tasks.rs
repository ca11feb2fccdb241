//! Parts of items, and the threads that do them.

use std::time::Instant;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::Parallel;

/// Parts per thread: so many that threads which are done early find more.
const PER_THREAD: usize = 8;

/// Loops of more elements than this are worth other threads, and these are woken at once.
const FEW: usize = 2048;

/// Seconds of work that are worth other threads: to wake one takes nearly as long.
const WORTH: f64 = 40e-6;

/// Seconds after which items have shown how long those behind them take.
const SEEN: f64 = 10e-6;

/// Seconds that a part takes at least.
const PART: f64 = 2.5e-6;

/// Does `work` with the parts of `items` and their numbers. It is compiled anew for each loop: what knows nothing of the items stands below.
pub(super) fn in_parts<P: Parallel>(items: P, work: &(dyn Fn(usize, P) + Sync)) {
    let mut cuts = Cuts::new(items.elements(), items.length(), items.least());
    let (mut rest, mut number) = (items, 0);
    let mut shared: Vec<Task<'_>> = Vec::new();
    loop {
        let left = rest.length();
        let size = cuts.next(left);
        let (part, later) = rest.part_at(size);
        let task = move || work(number, part);
        if cuts.are_shared() {
            shared.push(Box::new(task));
        } else {
            task();
        }
        if size == left {
            break;
        }
        rest = later;
        number += 1;
    }
    share(shared);
}

/// Work on one part.
type Task<'a> = Box<dyn FnOnce() + Send + 'a>;

/// Does the tasks on all threads. The one loop that rayon is compiled for.
fn share(tasks: Vec<Task<'_>>) {
    if !tasks.is_empty() {
        tasks.into_par_iter().for_each(|task| task());
    }
}

/// Where a loop is cut: work begins on the thread that has it, until what is left is seen to be worth other threads, which it may never be. Gas
/// at rest comes before gas that costs something, so what the last few took is asked again and again.
struct Cuts {
    start: Instant,
    /// Seconds until the last part was begun.
    before: f64,
    /// Items of the last part.
    few: usize,
    /// The least number of items that is worth a part.
    least: usize,
    threads: usize,
    /// Items of each part, once other threads share them.
    shared: Option<usize>,
}

impl Cuts {
    fn new(elements: usize, length: usize, least: usize) -> Self {
        let threads = rayon::current_num_threads();
        let mut cuts = Self {
            start: Instant::now(),
            before: 0.0,
            few: 0,
            least: least.max(1),
            threads,
            shared: None,
        };
        if threads > 1 && elements > FEW && length > 1 {
            cuts.share(length, usize::MAX);
        }
        cuts
    }

    /// True of parts that go to other threads.
    fn are_shared(&self) -> bool {
        self.shared.is_some()
    }

    /// Items of the next part, of so many that are left.
    fn next(&mut self, left: usize) -> usize {
        if self.threads == 1 {
            return left;
        }
        if self.shared.is_none() {
            self.look(left);
        }
        self.shared.unwrap_or(self.few).min(left)
    }

    /// Looks how long the last part took.
    fn look(&mut self, left: usize) {
        if self.few == 0 {
            self.few = self.least;
            return;
        }
        let now = self.start.elapsed().as_secs_f64();
        let each = (now - self.before) / self.few as f64;
        if now > SEEN && each * left as f64 > WORTH {
            self.share(left, (each * left as f64 / PART) as usize);
        } else {
            self.few = ((SEEN / each) as usize).clamp(self.least, 2 * self.few);
            self.before = now;
        }
    }

    /// The rest goes to all threads, in `most` parts at most.
    fn share(&mut self, left: usize, most: usize) {
        let parts = most.clamp(1, PER_THREAD * self.threads);
        self.shared = Some(left.div_ceil(parts).max(self.least));
    }
}
