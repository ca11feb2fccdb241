//! What flows through faces on sides.

use super::super::tests::lattice::problem;
use super::*;
use crate::gas::IdealGas;
use crate::method::{FixedPoints, Method, Time};
use crate::problem::Side as SideKind;
use crate::sides::Place;

const GAS: IdealGas = IdealGas::new(1.4);

/// On the right of a cell about the origin.
fn side(beyond: Beyond<2>) -> Side<2> {
    side_about([0.1, 0.0], beyond)
}

/// The same about this place.
fn side_about(centre: [f64; 2], beyond: Beyond<2>) -> Side<2> {
    let face = SideFace {
        i: 0,
        axis: 0,
        end: 1,
        area: [0.5, 0.0].into(),
        centre: centre.into(),
    };
    Side::new(&face, &Vector::zeros(), beyond)
}

fn gas(velocity: [f64; 2]) -> Primitive<2> {
    Primitive {
        density: 1.3,
        velocity,
        pressure: 0.8,
    }
}

fn outlet(beyond: Beyond<2>, speed: f64) -> Conserved<2> {
    let side = side(beyond);
    side.flux(&GAS, &gas([speed, 0.4]), &Slopes::LEVEL, None)
}

#[test]
fn gas_leaves_through_a_one_way_outlet_as_through_any_and_does_not_come_back() {
    for speed in [0.3, 2.5] {
        assert_eq!(outlet(Beyond::OneWay, speed), outlet(Beyond::Same, speed));
    }
    let back = outlet(Beyond::OneWay, -0.3);
    assert_eq!((back.mass, back.momentum[1], back.energy), (0.0, 0.0, 0.0));
    assert!(back.momentum[0] > 0.0 && back.momentum[0] < 0.8);
    assert!(outlet(Beyond::Same, -0.3).mass < 0.0);
}

/// Gas that slows down on its way out leaves as it is at the side, not as it is half a cell before.
#[test]
fn gas_that_rubs_leaves_an_outlet_as_it_is_there() {
    let cell = gas([2.5, 0.4]);
    let mut slopes = Slopes::<2>::LEVEL;
    slopes.along[0].velocity = [-2.0, 0.0];
    for beyond in [Beyond::Same, Beyond::OneWay] {
        let side = side(beyond);
        let mass = |rubbed| side.flux(&GAS, &cell, &slopes, rubbed).mass;
        assert!((mass(Some(&Conserved::ZERO)) - 1.3 * 2.3).abs() < 1e-14);
    }
}

/// So does gas that leaves faster than sound; what is slower leaves as it is in its cell.
#[test]
fn gas_faster_than_sound_leaves_an_outlet_as_it_is_there() {
    let mut slopes = Slopes::<2>::LEVEL;
    slopes.along[0].density = 0.5;
    let side = side(Beyond::Same);
    for (mach, part) in [(0.9, 0.0), (1.05, 0.5), (1.1, 1.0), (2.5, 1.0)] {
        let speed = mach * (1.4_f64 * 0.8 / 1.3).sqrt();
        let cell = gas([speed, 0.4]);
        let mass = side.flux(&GAS, &cell, &slopes, None).mass;
        let density = mass / speed - 1.3;
        let expected = part * 0.5 * side.image.distance;
        assert!((density - expected).abs() < 1e-12, "{mach}: {density}");
    }
}

/// The face of a cell that a wall cuts askew lies further up than the cell, and gas there is as the slopes say.
#[test]
fn gas_reaches_the_middle_of_its_face() {
    let held = SideKind::HeldOutlet {
        pressure: 0.7,
        relaxation: 0.25,
    };
    let problem = problem([10, 10], 0.1, [[SideKind::Symmetry, held]; 2]);
    let beyond = Beyond::of(&problem, held, Place::whole(&problem.domain, 0, 1)).unwrap();
    let side = side_about([0.1, 0.05], beyond);
    let cell = gas([0.4, 0.2]);
    let mut slopes = Slopes::<2>::LEVEL;
    slopes.along[0].velocity[0] = 0.3;
    slopes.along[1].pressure = 2.0;
    let reaching = side.reaching(&cell, &slopes);
    assert!((reaching.speed - 0.43).abs() < 1e-14, "{reaching:?}");
    assert!((reaching.pressure - 0.9).abs() < 1e-14, "{reaching:?}");
    // Before the first step what comes in is the gas's own.
    let flux = side.flux(&GAS, &cell, &slopes, None);
    assert!((flux.mass - 1.3 * 0.43).abs() < 1e-14, "{flux:?}");
    assert!((flux.momentum[1] - 1.3 * 0.43 * 0.2).abs() < 1e-14);
}

/// Gas at the pressure that is held at once leaves as it is at the face, without a sound, whatever it was half a cell before.
#[test]
fn gas_leaves_through_an_outlet_held_at_once_as_it_is_there() {
    let held = SideKind::HeldOutlet {
        pressure: 0.8,
        relaxation: 0.25,
    };
    let mut problem = problem([10, 10], 0.1, [[SideKind::Symmetry, held]; 2]);
    problem.method = Method::Fixed(FixedPoints {
        time: Time::Settle,
        ..FixedPoints::default()
    });
    let beyond = Beyond::of(&problem, held, Place::whole(&problem.domain, 0, 1)).unwrap();
    assert!(matches!(beyond, Beyond::Answers(..)));
    let cell = Primitive {
        density: 1.3,
        velocity: [0.4, 0.2],
        pressure: 0.7,
    };
    let mut slopes = Slopes::<2>::LEVEL;
    slopes.along[0].velocity[0] = -0.3;
    slopes.along[0].pressure = 1.0;
    let flux = side(beyond).flux(&GAS, &cell, &slopes, None);
    assert!((flux.mass - 1.3 * 0.37).abs() < 1e-14, "{flux:?}");
    let through = 1.3 * 0.37 * 0.37 + 0.8;
    assert!((flux.momentum[0] - through).abs() < 1e-14, "{flux:?}");
}

/// What comes back in through an outlet goes along the side as the stream does, and has the stream's total enthalpy; what leaves takes its own
/// speed along.
#[test]
fn gas_that_comes_back_in_has_nothing_of_what_slides_along_the_side() {
    let held = SideKind::HeldOutlet {
        pressure: 0.8,
        relaxation: 0.25,
    };
    for time in [Time::Accurate, Time::Settle] {
        let mut problem = problem([10, 10], 0.1, [[SideKind::Symmetry, held]; 2]);
        problem.free_stream.velocity = [0.0, 0.3].into();
        problem.method = Method::Fixed(FixedPoints {
            time,
            ..FixedPoints::default()
        });
        let gamma = problem.gas.ratio_at(1.0, 1.0);
        let stream = &problem.free_stream;
        let heat = gamma / (gamma - 1.0) * stream.pressure / stream.density;
        let total = heat + 0.5 * stream.velocity.norm_squared();
        let place = Place::whole(&problem.domain, 0, 1);
        let fresh = Beyond::of(&problem, held, place).unwrap();
        let mut beyond = fresh;
        // As it comes in from rest at the pressure.
        let sound = gamma * stream.pressure / stream.density;
        let cooled = 1.0 - 0.5 * (gamma - 1.0) * 0.2 * 0.2 / sound;
        let pressure = 0.8 * cooled.powf(gamma / (gamma - 1.0));
        let density = gamma * pressure / (sound * cooled);
        let along = |speed: f64, beyond: Beyond<2>| {
            let slides = Primitive {
                density,
                velocity: [speed, 2.0],
                pressure,
            };
            side(beyond).flux(&GAS, &slides, &Slopes::LEVEL, None)
        };
        if let Beyond::Rides(riding, _) = &mut beyond {
            let own = Along {
                density,
                speed: -0.2,
                pressure,
            };
            riding.go_on(&own, 0.0, 0.01);
        }
        let back = along(-0.2, beyond);
        assert!(back.mass < 0.0);
        let [speed, enthalpy] = [back.momentum[1], back.energy].map(|flux| flux / back.mass);
        assert!((speed - 0.3).abs() < 1e-12, "{time:?} {speed}");
        assert!(
            (enthalpy / total - 1.0).abs() < 0.02,
            "{time:?} {enthalpy} {total}"
        );
        let out = along(0.2, fresh);
        assert!((out.momentum[1] / out.mass - 2.0).abs() < 1e-12);
    }
}

/// What comes out of a reservoir comes from rest, and does not go along the side as the stream does.
#[test]
fn gas_from_a_reservoir_does_not_go_along_the_side() {
    let reservoir = SideKind::Reservoir { relaxation: None };
    let mut problem = problem([10, 10], 0.1, [[SideKind::Symmetry, reservoir]; 2]);
    problem.free_stream.velocity = [0.0, 0.3].into();
    let beyond = Beyond::of(&problem, reservoir, Place::whole(&problem.domain, 0, 1)).unwrap();
    let flux = side(beyond).flux(&GAS, &gas([-0.2, 2.0]), &Slopes::LEVEL, None);
    assert!(flux.mass < 0.0, "{flux:?}");
    assert!(flux.momentum[1].abs() < 1e-14, "{flux:?}");
}
