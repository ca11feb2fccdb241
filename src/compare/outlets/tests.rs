//! Mistakes in a treatment must show, and what it is made of must be what it says.

use aero_geometry::Vector;

use super::cases::{Case, DAMPING, Suite};
use super::duct::Crowd;
use super::treatment::Mistake;
use super::treatments::ALL;
use super::verdict::echo_row;
use super::wave::Sound;

const SOUND: Sound = Sound {
    mach: 0.3,
    strength: 0.001,
    cells: 50,
};

/// The row passes, and with a mistake it fails.
fn shows(mistake: Mistake) {
    let reference = SOUND.reference();
    for treatment in ALL {
        let back = |mistake| SOUND.comes_back(&reference, treatment, mistake);
        let row = echo_row(&SOUND, treatment, back(None));
        assert!(row.pass && row.allowed_percent.is_some(), "{row:?}");
        let row = echo_row(&SOUND, treatment, back(Some(mistake)));
        assert!(!row.pass, "{mistake:?}: {row:?}");
    }
}

#[test]
fn a_wrong_sign_shows() {
    shows(Mistake::Sign);
}

#[test]
fn a_pressure_twice_as_high_shows() {
    shows(Mistake::Double);
}

#[test]
fn particles_that_stay_show() {
    shows(Mistake::Still);
}

/// Gas as it came in stays so, whatever ends the duct.
#[test]
fn a_stream_stays_as_it_is() {
    let silence = Sound {
        strength: 0.0,
        ..SOUND
    };
    let reference = vec![SOUND.mach; SOUND.cells as usize];
    for treatment in ALL {
        // In units of the sound's strength, which is none.
        let back = silence.back(1.0, treatment, None);
        let off = back.iter().zip(&reference).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) < 1e-13, "{}", treatment.name());
    }
}

/// Images stand where the walls mirror particles, over and over, and turn round across.
#[test]
fn images_are_those_of_two_walls() {
    let suite = Suite {
        case: Case::Ramp,
        damping: DAMPING,
        viscosity: 0.0,
    };
    let duct = suite.duct(1.0);
    let mut one = duct.lattice([0.0, duct.spacing]);
    one[0].position.y += 0.2 * duct.spacing;
    one[0].state[2] = 1.0;
    let crowd = Crowd::new(one.iter(), &duct);
    let states = crowd.states(&one);
    let first = Vector::<2>::new(0.0, 0.6 * duct.spacing);
    let found = crowd
        .cloud
        .points
        .iter()
        .zip(&states)
        .find(|(place, _)| (*place - one[0].position - first).norm() < 1e-12);
    assert_eq!(found.map(|(_, state)| state[2]), Some(-1.0));
    assert!(crowd.cloud.points.len() >= 7);
}

/// The same bits by one thread and by three.
#[test]
fn threads_change_nothing() {
    let by = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads").install(|| {
            let back = SOUND.back(1.0, ALL[2], None);
            back.into_iter().map(f64::to_bits).collect::<Vec<u64>>()
        })
    };
    assert_eq!(by(1), by(3));
}
