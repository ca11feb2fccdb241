//! Gas that is in a wall at the end of a run, and gas that walls had to bring back on the way.

use aero_packer::{About, Warning};
use aero_solver::Flow;
use aero_solver::problem::{Problem, Side};

/// Times that gas is brought back, for each particle that has been in the domain, which are worth a word.
const OFTEN: f64 = 0.1;

/// What there is to say of the walls of `flow` as it stands.
pub(super) fn warnings<const D: usize>(flow: &Flow<D>) -> Vec<Warning> {
    let statistics = flow.statistics();
    let all = statistics.fluid as f64 * changes(flow.problem(), flow.time());
    let lost = if flow.problem().method.fixed().is_some() {
        without_a_point(statistics.leaked)
    } else {
        lost(statistics.leaked)
    };
    let returned = returned(statistics.returned, all);
    let lines = lost.into_iter().chain(returned);
    lines.map(|text| Warning::new(About::Scene, text)).collect()
}

/// How often the stream has filled the domain by this time, its first filling included.
fn changes<const D: usize>(problem: &Problem<D>, time: f64) -> f64 {
    if !problem.domain.has(Side::lets_in) {
        return 1.0;
    }
    let size = problem.domain.bounds.size();
    let along = problem.free_stream.velocity.component_div(&size);
    1.0 + time * along.abs().max()
}

/// Of gas in a wall.
fn lost(particles: usize) -> Option<String> {
    let count = match particles {
        0 => return None,
        1 => "1 particle of gas is".to_owned(),
        many => format!("{many} particles of gas are"),
    };
    Some(format!(
        "{count} inside a body or behind a wall, and lost to the flow; use a smaller `spacing`, or try `scheme.shield = true`"
    ))
}

/// Of gas between walls, about points that stay.
fn without_a_point(pieces: usize) -> Option<String> {
    (pieces > 0).then(|| {
        format!(
            "gas between walls that no point of it is in, or beside, is left out ({pieces} pieces of cells); close the gap or pocket, or use a smaller \
             `spacing` or more of `scheme.refine`"
        )
    })
}

/// Of gas that walls brought back so many `times`, of `all` particles that there have been.
fn returned(times: u64, all: f64) -> Option<String> {
    let part = times as f64 / all.max(1.0);
    (part > OFTEN).then(|| {
        format!(
            "walls brought gas back {times} times that a step had carried into them, {:.0} times for a hundred particles that came by, and what it \
             struck them with is in no load; use a smaller `spacing`",
            100.0 * part
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gas_in_walls_is_told_and_gas_brought_back_where_that_is_much_of_it() {
        assert_eq!(lost(0), None);
        assert_eq!(without_a_point(0), None);
        assert!(without_a_point(2).unwrap().contains("(2 pieces of cells)"));
        assert!(lost(1).is_some_and(|text| text.starts_with("1 particle of gas is inside")));
        assert_eq!(returned(10, 100.0), None);
        assert_eq!(returned(0, 0.0), None);
        assert!(returned(11, 100.0).is_some_and(|text| text.contains("11 times for a hundred")));
    }
}
