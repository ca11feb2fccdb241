//! Fans in the plane against tables, and along edges in space.

use approx::assert_relative_eq;

use super::*;
use crate::gas::IdealGas;

const AIR: IdealGas = IdealGas::new(1.4);

/// A bend by `degrees`, turned by `way`, and seen in a mirror where `side` is -1.
fn bend(degrees: f64, way: f64, side: f64) -> Bend<2> {
    let towards = |angle: f64| {
        let (sine, cosine) = (way + angle).sin_cos();
        [cosine, side * sine]
    };
    Bend {
        at: [0.3, 0.2],
        edge: [0.0; 2],
        donors: vec![(0, 1.0)],
        along: towards(-degrees.to_radians()),
        before: towards(0.0),
        up: towards(FRAC_PI_2),
        unit: 0.1,
    }
}

/// A stream over such a bend.
fn fan(mach: f64, degrees: f64, way: f64, side: f64) -> Option<Fan<2>> {
    let bend = bend(degrees, way, side);
    let front = Primitive {
        density: 1.4,
        velocity: bend.before.map(|part| mach * part),
        pressure: 1.0,
    };
    Fan::new(&AIR, &front, &bend)
}

/// NACA Report 1135 (1953), table II, by the angles of Mach 2, 26.380, and Mach 3, 49.757 degrees.
#[test]
fn gas_behind_a_fan_has_the_pressure_of_the_tables() {
    for (mach, degrees, ratio) in [
        (1.5, 10.0, 0.600_003),
        (2.0, 15.0, 0.393_068),
        (3.0, 20.0, 0.159_650),
        (4.0, 10.0, 0.330_083),
    ] {
        let fan = fan(mach, degrees, 0.3, 1.0).unwrap();
        assert_relative_eq!(fan.rear.pressure, ratio, epsilon = 3e-5);
        let way = fan.rear.velocity[1].atan2(fan.rear.velocity[0]);
        assert_relative_eq!(way, 0.3 - degrees.to_radians(), epsilon = 1e-12);
    }
}

/// On each ray the gas crosses it with the speed of sound, and entropy and total enthalpy are those in front.
#[test]
fn rays_of_a_fan_are_mach_lines() {
    for (way, side) in [(0.0, 1.0), (2.0, 1.0), (2.0, -1.0)] {
        let fan = fan(2.0, 20.0, way, side).unwrap();
        let [first, last] = fan.rays;
        for part in [0.01, 0.3, 0.7, 0.99] {
            let elevation = first + part * (last - first);
            let place: [f64; 2] = std::array::from_fn(|k| {
                elevation.cos() * fan.ways.onwards[k] + elevation.sin() * fan.ways.aside[k]
            });
            assert_relative_eq!(fan.elevation(&place), elevation, epsilon = 1e-12);
            let state = fan.state(elevation);
            let across = [-place[1] * side, place[0] * side];
            let sound = AIR.sound_square(state.density, state.pressure);
            let speed = dot(&state.velocity, &across);
            assert_relative_eq!(speed * speed / sound, 1.0, epsilon = 1e-10);
            let entropy = state.pressure / (state.density / 1.4).powf(1.4);
            assert_relative_eq!(entropy, 1.0, epsilon = 1e-12);
            let square = dot(&state.velocity, &state.velocity);
            assert_relative_eq!(sound / 0.4 + 0.5 * square, 4.5, epsilon = 1e-10);
        }
        assert_eq!(fan.state(first + 1e-9), fan.front);
        assert_relative_eq!(
            fan.state(last + 1e-9).pressure,
            fan.rear.pressure,
            epsilon = 1e-6
        );
    }
}

/// A stream that comes to an edge askew: a fan of what goes across the edge; what goes along it is the same all over, and so is the
/// total enthalpy.
#[test]
fn gas_keeps_what_it_moves_along_an_edge() {
    let (flat, way) = (fan(2.0, 15.0, 0.3, 1.0).unwrap(), 0.4_f64);
    let lifted = |[x, y]: [f64; 2]| [x * way.cos(), y, x * way.sin()];
    let edge = [-way.sin(), 0.0, way.cos()];
    let unswept = bend(15.0, 0.3, 1.0);
    let bend = Bend {
        at: lifted(unswept.at),
        edge,
        donors: vec![(0, 1.0)],
        along: lifted(unswept.along),
        before: lifted(unswept.before),
        up: lifted(unswept.up),
        unit: 0.1,
    };
    let slide = 1.3;
    let swept = |[x, y]: [f64; 2]| {
        let mut velocity = lifted([x, y]);
        for k in 0..3 {
            velocity[k] += slide * edge[k];
        }
        velocity
    };
    let front = Primitive {
        density: 1.4,
        velocity: swept(flat.front.velocity),
        pressure: 1.0,
    };
    let fan = Fan::new(&AIR, &front, &bend).unwrap();
    for part in [-0.1, 0.01, 0.3, 0.7, 0.99, 1.1] {
        let [first, last] = fan.rays;
        let elevation = first + part * (last - first);
        let (state, known) = (fan.state(elevation), flat.state(elevation));
        assert_relative_eq!(state.pressure, known.pressure, epsilon = 1e-12);
        assert_relative_eq!(state.density, known.density, epsilon = 1e-12);
        assert_relative_eq!(dot(&state.velocity, &edge), slide, epsilon = 1e-12);
        let expected = swept(known.velocity);
        for k in 0..3 {
            assert_relative_eq!(state.velocity[k], expected[k], epsilon = 1e-12);
        }
        let sound = AIR.sound_square(state.density, state.pressure);
        let square = dot(&state.velocity, &state.velocity) - slide * slide;
        assert_relative_eq!(sound / 0.4 + 0.5 * square, 4.5, epsilon = 1e-10);
        assert_eq!(fan.agreement(&AIR, &state, &state), 1.0);
    }
}

/// A thin one of a fast stream, whose pressure falls to a quarter within six degrees, four times as far as one of Mach 2.
#[test]
fn a_fan_is_known_as_far_as_cells_are_too_coarse_for_it() {
    let near = |mach, degrees| fan(mach, degrees, 0.0, 1.0).unwrap().near;
    assert_relative_eq!(near(1.5, 10.0), NEAREST);
    assert_relative_eq!(near(2.0, 15.0), NEAREST);
    assert_relative_eq!(near(6.0, 10.0), 1.6911 / (0.4 * 0.2139), epsilon = 0.05);
    assert_relative_eq!(near(10.0, 12.0), farthest::<2>() / FARTHER);
    let fan = fan(6.0, 10.0, 0.0, 1.0).unwrap();
    assert_eq!(fan.nearness(fan.near), 1.0);
    assert_relative_eq!(fan.nearness(fan.near * 7.0 / 6.0), 0.5, epsilon = 1e-12);
    assert_eq!(fan.nearness(FARTHER * fan.near), 0.0);
}

#[test]
fn gas_is_even_in_front_of_a_fan_and_behind_it_alone() {
    for (way, side) in [(0.3, 1.0), (2.0, -1.0)] {
        let fan = fan(2.0, 20.0, way, side).unwrap();
        let place = |elevation: f64| -> [f64; 2] {
            let (sine, cosine) = elevation.sin_cos();
            std::array::from_fn(|k| 3.0 * (cosine * fan.ways.onwards[k] + sine * fan.ways.aside[k]))
        };
        let is_even = |elevations: [f64; 2]| fan.is_even(elevations.map(place).iter());
        let [first, last] = fan.rays;
        assert!(is_even([first + 1e-6, 3.0]) && is_even([last - 1e-6, -0.4]));
        assert!(!is_even([first - 1e-6, 3.0]) && !is_even([last + 1e-6, -0.4]));
        assert!(!is_even([2.0, -0.3]) && !is_even([first - 0.1, last + 0.1]));
    }
}

#[test]
fn no_fan_stands_where_gas_is_slow_comes_from_behind_or_leaves_the_wall() {
    assert!(fan(0.9, 10.0, 0.0, 1.0).is_none());
    assert!(fan(-2.0, 10.0, 0.0, 1.0).is_none());
    assert!(fan(2.0, -10.0, 0.0, 1.0).is_none());
    assert!(fan(2.0, 50.1, 0.0, 1.0).is_none());
    let share = |mach, degrees| fan(mach, degrees, 0.0, 1.0).unwrap().share;
    assert_relative_eq!(share(1.5_f64.sqrt(), 10.0), 0.5, epsilon = 1e-12);
    assert_relative_eq!(share(2.0, 44.9), 1.0);
    assert_relative_eq!(share(2.0, 47.5), 0.5, epsilon = 1e-9);
}

#[test]
fn gas_that_is_slow_or_of_another_pressure_is_not_of_the_fan() {
    let fan = fan(2.0, 15.0, 0.0, 1.0).unwrap();
    let known = fan.rear;
    let with = |factor: f64, speed: f64| Primitive {
        pressure: known.pressure * factor,
        density: known.density * factor,
        velocity: known.velocity.map(|u| speed * u),
    };
    let agreement = |own: &Primitive<2>| fan.agreement(&AIR, own, &known);
    assert_eq!(agreement(&known), 1.0);
    assert_eq!(agreement(&with(1.5, 1.0)), 1.0);
    assert_eq!(agreement(&with(2.6, 1.0)), 0.0);
    assert_eq!(agreement(&with(1.0, 0.3)), 0.0);
    assert_eq!(agreement(&with(1.0, -1.0)), 0.0);
}
