//! Tests of the exact Riemann solution.

use super::*;
use crate::reference;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use proptest::prelude::*;

#[test]
fn the_reference_suite_is_reproduced() {
    let table = reference::riemann_suite();
    for row in 0..table.len() {
        let get = |name: &str| table.column(name).unwrap()[row];
        let left = State::new(get("rho_l"), get("u_l"), get("p_l"));
        let right = State::new(get("rho_r"), get("u_r"), get("p_r"));
        let problem = Riemann::new(left, right, get("gamma")).unwrap();
        let star = problem.star().unwrap();
        assert_relative_eq!(star.pressure, get("p_star"), max_relative = 1e-6);
        assert_abs_diff_eq!(
            star.velocity,
            get("u_star"),
            epsilon = 1e-6 * get("u_star").abs() + 1e-9
        );
        assert_relative_eq!(star.density_left, get("rho_star_l"), max_relative = 1e-6);
        assert_relative_eq!(star.density_right, get("rho_star_r"), max_relative = 1e-6);
        let edges = |wave| match wave {
            Wave::Shock(speed) => (speed, speed),
            Wave::Fan { head, tail } => (head, tail),
        };
        let (head, tail) = edges(problem.left_wave());
        assert_abs_diff_eq!(head, get("left_head"), epsilon = 1e-5);
        assert_abs_diff_eq!(tail, get("left_tail"), epsilon = 1e-5);
        let (head, tail) = edges(problem.right_wave());
        assert_abs_diff_eq!(head, get("right_head"), epsilon = 1e-5);
        assert_abs_diff_eq!(tail, get("right_tail"), epsilon = 1e-5);
    }
}

#[test]
fn gas_let_into_a_vacuum_escapes_at_its_limiting_speed() {
    let problem = Riemann::new(State::new(1.0, 0.0, 1.0), State::new(0.0, 0.0, 0.0), 1.4).unwrap();
    assert!(problem.star().is_none());
    let limit = 5.0 * 1.4_f64.sqrt();
    assert!(problem.sample(0.999 * limit).density > 0.0);
    assert_eq!(problem.sample(1.001 * limit).density, 0.0);
    assert_relative_eq!(problem.sample(-2.0).density, 1.0);
    // At the diaphragm the flow is sonic: rho = (2/(gamma+1))^(2/(gamma-1)).
    assert_relative_eq!(
        problem.sample(0.0).density,
        (2.0_f64 / 2.4).powi(5),
        max_relative = 1e-12
    );
}

#[test]
fn states_that_part_fast_enough_leave_a_vacuum_between() {
    let problem =
        Riemann::new(State::new(1.0, -20.0, 1.0), State::new(1.0, 20.0, 1.0), 1.4).unwrap();
    assert!(problem.star().is_none());
    assert_eq!(problem.sample(0.0).density, 0.0);
    assert_relative_eq!(problem.sample(30.0).velocity, 20.0);
    assert_relative_eq!(problem.sample(-30.0).velocity, -20.0);
}

#[test]
fn nonsense_states_are_refused() {
    let good = State::new(1.0, 0.0, 1.0);
    assert!(Riemann::new(State::new(-1.0, 0.0, 1.0), good, 1.4).is_err());
    assert!(Riemann::new(good, State::new(1.0, f64::NAN, 1.0), 1.4).is_err());
    assert!(Riemann::new(good, good, 1.0).is_err());
}

#[test]
fn equal_states_stay_as_they_are() {
    let state = State::new(1.3, 0.4, 2.0);
    let problem = Riemann::new(state, state, 1.4).unwrap();
    for speed in [-3.0, -0.5, 0.4, 0.5, 3.0] {
        let here = problem.sample(speed);
        assert_relative_eq!(here.density, 1.3, max_relative = 1e-12);
        assert_relative_eq!(here.velocity, 0.4, max_relative = 1e-12);
    }
}

fn flux(state: &State, gamma: f64) -> [f64; 3] {
    let total = state.density * (state.energy(gamma) + 0.5 * state.velocity * state.velocity);
    [
        state.density * state.velocity,
        state.density * state.velocity * state.velocity + state.pressure,
        (total + state.pressure) * state.velocity,
    ]
}

fn conserved(state: &State, gamma: f64) -> [f64; 3] {
    [
        state.density,
        state.density * state.velocity,
        state.density * (state.energy(gamma) + 0.5 * state.velocity * state.velocity),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// What has flowed in through the ends is what the profile has gained.
    #[test]
    fn the_profile_conserves_mass_momentum_and_energy(
        rho_l in 0.1_f64..10.0, u_l in -2.0_f64..2.0, p_l in 0.1_f64..20.0,
        rho_r in 0.1_f64..10.0, u_r in -2.0_f64..2.0, p_r in 0.1_f64..20.0,
        gamma in 1.2_f64..1.67,
    ) {
        let (left, right) = (State::new(rho_l, u_l, p_l), State::new(rho_r, u_r, p_r));
        let problem = Riemann::new(left, right, gamma).unwrap();
        let reach = 1.1 * [left, right].iter().map(|s| s.velocity.abs()).fold(0.0, f64::max)
            + 60.0;
        let cells = 120_000;
        let width = 2.0 * reach / f64::from(cells);
        let mut total = [0.0; 3];
        for k in 0..cells {
            let state = problem.sample(-reach + (f64::from(k) + 0.5) * width);
            for (sum, value) in total.iter_mut().zip(conserved(&state, gamma)) {
                *sum += value * width;
            }
        }
        let (ql, qr) = (conserved(&left, gamma), conserved(&right, gamma));
        let (fl, fr) = (flux(&left, gamma), flux(&right, gamma));
        let size = ql[2] + qr[2] + fl[2].abs() + fr[2].abs();
        for k in 0..3 {
            let expected = reach * (ql[k] + qr[k]) + fl[k] - fr[k];
            prop_assert!((total[k] - expected).abs() < 2e-3 * size, "{} {} {}", k, total[k], expected);
        }
    }

    /// The same of a gas on either side.
    #[test]
    fn two_gases_conserve_mass_momentum_and_energy(
        rho_l in 0.1_f64..10.0, u_l in -2.0_f64..2.0, p_l in 0.1_f64..20.0,
        rho_r in 0.1_f64..10.0, u_r in -2.0_f64..2.0, p_r in 0.1_f64..20.0,
        left_gamma in 1.1_f64..1.67, right_gamma in 1.1_f64..1.67,
    ) {
        let (left, right) = (State::new(rho_l, u_l, p_l), State::new(rho_r, u_r, p_r));
        let problem = Riemann::of_two_gases(left, right, [left_gamma, right_gamma]).unwrap();
        prop_assume!(problem.star().is_some());
        let contact = problem.star().unwrap().velocity;
        let (cells, reach) = (120_000, 60.0);
        let width = 2.0 * reach / f64::from(cells);
        let mut total = [0.0; 3];
        for k in 0..cells {
            let speed = -reach + (f64::from(k) + 0.5) * width;
            let gamma = if speed < contact { left_gamma } else { right_gamma };
            for (sum, value) in total.iter_mut().zip(conserved(&problem.sample(speed), gamma)) {
                *sum += value * width;
            }
        }
        let (ql, qr) = (conserved(&left, left_gamma), conserved(&right, right_gamma));
        let (fl, fr) = (flux(&left, left_gamma), flux(&right, right_gamma));
        let size = ql[2] + qr[2] + fl[2].abs() + fr[2].abs();
        for k in 0..3 {
            let expected = reach * (ql[k] + qr[k]) + fl[k] - fr[k];
            prop_assert!((total[k] - expected).abs() < 2e-3 * size, "{} {} {}", k, total[k], expected);
        }
    }

    #[test]
    fn mirrored_problems_have_mirrored_solutions(
        rho in 0.1_f64..10.0, u in -2.0_f64..2.0, p in 0.1_f64..20.0, speed in -3.0_f64..3.0,
    ) {
        let (left, right) = (State::new(rho, u, p), State::new(1.0, 0.0, 1.0));
        let problem = Riemann::new(left, right, 1.4).unwrap();
        let mirrored = Riemann::new(mirror(&right), mirror(&left), 1.4).unwrap();
        let (a, b) = (problem.sample(speed), mirrored.sample(-speed));
        let near_contact = problem.star().is_some_and(|s| (s.velocity - speed).abs() < 1e-9);
        prop_assume!(!near_contact);
        prop_assert!((a.pressure - b.pressure).abs() < 1e-9 * a.pressure);
        prop_assert!((a.velocity + b.velocity).abs() < 1e-9);
    }
}
