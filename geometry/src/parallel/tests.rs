use std::collections::HashSet;
use std::sync::Mutex;
use std::thread::{ThreadId, current};
use std::time::{Duration, Instant};

use super::tasks::in_parts;
use super::{IntoParallel, Parallel, Slices};

/// Takes so long with an item that several threads are worth it.
fn slowly<T>(item: T) -> T {
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_micros(4) {
        std::hint::spin_loop();
    }
    item
}

/// Lengths of the parts that one thread and seven do `work` in.
fn parts_on(count: usize, least: usize, work: impl Fn(usize) -> usize + Sync) -> [Vec<usize>; 2] {
    on_threads(|| {
        let lengths = Mutex::new(Vec::new());
        let items = (0..count).into_par_iter().with_min_len(least);
        in_parts(items, &|number, part| {
            let length = part.serial().map(&work).count();
            lengths.lock().unwrap().push((number, length));
        });
        let mut lengths = lengths.into_inner().unwrap();
        lengths.sort_unstable();
        lengths.into_iter().map(|(_, length)| length).collect()
    })
}

/// Lengths of the parts that seven threads do `work` in.
fn parts_of(items: usize, work: impl Fn(usize) -> usize + Sync) -> Vec<usize> {
    let [_, seven] = parts_on(items, 1, work);
    seven
}

#[test]
fn parts_are_no_shorter_than_is_worth_one_and_one_thread_does_all_in_one() {
    let parts = parts_on(5600, 400, |n| n);
    assert_eq!(parts, [vec![5600], vec![400; 14]]);
    let [one, _] = parts_on(90, 1, slowly);
    assert_eq!(one, [90]);
}

#[test]
fn little_work_is_not_cut_for_other_threads_and_much_work_is() {
    // But where the system takes the thread away meanwhile.
    let tries = (0..20).map(|_| parts_of(100, |n| n));
    assert!(
        tries
            .into_iter()
            .any(|parts| parts == [1, 2, 4, 8, 16, 32, 37])
    );
    let short = (0..20).map(|_| parts_of(8, slowly).len());
    assert!(short.min() <= Some(5));
    // What the first have shown; and what needs no showing.
    assert!(parts_of(100, slowly).len() > 20);
    assert_eq!(parts_of(5600, |n| n), [100; 56]);
    // Slow ones behind eight that are not.
    let late = |n| if n < 8 { n } else { slowly(slowly(n)) };
    assert!(parts_of(100, late).len() > 20);
}

#[test]
fn threads_share_what_is_cut() {
    let seen: Mutex<HashSet<ThreadId>> = Mutex::default();
    parts_of(64, |n| {
        std::thread::sleep(Duration::from_millis(1));
        seen.lock().unwrap().insert(current().id());
        n
    });
    // Those of the pool of one among them.
    assert!(seen.into_inner().unwrap().len() > 2);
}

#[test]
fn many_beside_none_are_none() {
    let (many, none) = (vec![1_u8; 5000], Vec::<u8>::new());
    let pairs = || many.par_iter().zip(&none).map(|(a, b)| a + b);
    let whole = || many.par_chunks(9000).map(<[u8]>::len);
    let found = on_threads(|| {
        [
            pairs().map(usize::from).collect(),
            whole().collect::<Vec<_>>(),
        ]
    });
    assert_eq!(found, [[vec![], vec![5000]], [vec![], vec![5000]]]);
}

#[test]
fn elements_in_chunks_count_each() {
    let numbers = vec![0_u8; 1000];
    let chunks = numbers.par_chunks(64).zip(0..16).map(|(chunk, _)| chunk);
    assert_eq!([chunks.length(), chunks.elements()], [16, 1000]);
    let (first, rest) = chunks.enumerate().with_min_len(2).part_at(3);
    assert_eq!([first.elements(), rest.elements()], [192, 808]);
}

/// What `work` gives on one thread and on seven.
fn on_threads<R: Send>(work: impl Fn() -> R + Sync) -> [R; 2] {
    [1, 7].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads can be started").install(&work)
    })
}

#[test]
fn results_come_in_order_whatever_the_threads() {
    for count in [0, 1, 2, 6, 57, 1000] {
        let expected: Vec<usize> = (0..count).map(|n| 3 * n).collect();
        for found in on_threads(|| {
            (0..count)
                .into_par_iter()
                .map(|n| slowly(3 * n))
                .collect::<Vec<_>>()
        }) {
            assert_eq!(found, expected);
        }
        let odd = |n: &usize| n % 2 == 1;
        let expected: Vec<(usize, usize)> = (0..count).filter(odd).enumerate().collect();
        for found in on_threads(|| {
            let odd: Vec<usize> = expected
                .par_iter()
                .map(|&(_, n)| slowly(n))
                .filter(odd)
                .collect();
            odd.par_iter().copied().enumerate().collect::<Vec<_>>()
        }) {
            assert_eq!(found, expected);
        }
    }
}

#[test]
fn every_item_is_worked_on_once() {
    for count in [0, 1, 5, 16, 17, 999] {
        for (chunk, least) in [(1, 1), (4, 3), (16, 1), (1000, 1)] {
            let [one, seven] = on_threads(|| {
                let numbers: Vec<usize> = (0..count).collect();
                let mut seen = vec![0; count];
                seen.par_chunks_mut(chunk)
                    .zip(numbers.par_chunks(chunk))
                    .enumerate()
                    .with_min_len(least)
                    .for_each(|(number, (seen, numbers))| {
                        for (seen, n) in seen.iter_mut().zip(numbers) {
                            *slowly(&mut *seen) += n * 1000 + number;
                        }
                    });
                seen
            });
            let expected: Vec<usize> = (0..count).map(|n| n * 1000 + n / chunk).collect();
            assert_eq!(one, expected);
            assert_eq!(seven, expected);
        }
    }
}

#[test]
fn room_is_used_again_whatever_was_in_it() {
    for before in [0, 10, 100, 1000] {
        for found in on_threads(|| {
            let mut room = vec![usize::MAX; before];
            let squares = (0..100).into_par_iter().map(|n| slowly(n * n));
            squares.collect_into_vec(&mut room);
            room
        }) {
            assert_eq!(found, (0..100).map(|n| n * n).collect::<Vec<_>>());
        }
    }
}

#[test]
fn windows_overlap_where_tasks_meet() {
    let ends: Vec<usize> = (0..100).map(|n| n * n).collect();
    let expected: Vec<usize> = ends.windows(2).map(|pair| pair[1] - pair[0]).collect();
    for found in on_threads(|| {
        let steps = ends.par_windows(2).map(|pair| slowly(pair[1] - pair[0]));
        steps.collect::<Vec<_>>()
    }) {
        assert_eq!(found, expected);
    }
}

#[test]
fn the_least_and_the_most_are_found() {
    let places = |n: usize| [(n * 37 % 101) as f64; 2];
    for found in on_threads(|| {
        let all = (0..101).into_par_iter().map(|n| slowly(places(n)));
        all.reduce(
            || [f64::INFINITY, f64::NEG_INFINITY],
            |[a, b], [c, d]| [a.min(c), b.max(d)],
        )
    }) {
        assert_eq!(found, [0.0, 100.0]);
    }
}
