//! The passes in lanes, of every width, against the scalar reference: random clouds of random states.

use super::agreement::compare;
use super::seam::{DEFAULT, PUBLISHED, Setup};
use super::*;

const SWITCHES: [Setup; 10] = [
    DEFAULT,
    Setup {
        mirrors: true,
        ..DEFAULT
    },
    Setup {
        limits_viscosity: false,
        ..DEFAULT
    },
    Setup {
        limits_conduction: false,
        ..DEFAULT
    },
    Setup {
        limits_viscosity: false,
        limits_conduction: false,
        ..DEFAULT
    },
    Setup {
        shifting: true,
        ..DEFAULT
    },
    Setup {
        shield: true,
        ..DEFAULT
    },
    Setup {
        shield: true,
        shifting: true,
        ..DEFAULT
    },
    PUBLISHED,
    Setup {
        shield: true,
        mirrors: true,
        ..PUBLISHED
    },
];

/// A wall that does what walls do.
const PISTON: Side = Side::Wall {
    kind: WallKind::Slip,
    velocity: 0.4,
    acceleration: 3.0,
};

const STICKY: Side = Side::Wall {
    kind: WallKind::STICKY,
    velocity: 0.0,
    acceleration: 0.0,
};

fn disordered<const D: usize>(cells: usize, sides: [[Side; 2]; D]) -> Problem<D> {
    let mut problem = cube::<D>(cells, Side::Periodic);
    problem.disorder = 0.3;
    problem.domain.sides = sides;
    problem.free_stream.velocity[0] = 0.5;
    problem
}

#[test]
fn lanes_match_the_reference_on_a_line() {
    for setup in SWITCHES {
        compare(setup, &disordered(30, [[Side::Periodic; 2]]));
        compare(setup, &disordered(30, [[PISTON, STICKY]]));
        compare(setup, &disordered(30, [[Side::Inlet, Side::Outlet]]));
    }
}

#[test]
fn lanes_match_the_reference_in_the_plane() {
    for setup in SWITCHES {
        compare(
            setup,
            &disordered(12, [[PISTON, Side::Symmetry], [STICKY, WALL]]),
        );
    }
    for setup in [DEFAULT, SWITCHES[7], SWITCHES[9]] {
        compare(
            setup,
            &disordered(16, [[Side::Inlet, Side::Outlet], [Side::Periodic; 2]]),
        );
    }
}

#[test]
fn lanes_match_the_reference_in_space() {
    let sides = [
        [PISTON, Side::Symmetry],
        [WALL, Side::Symmetry],
        [Side::Symmetry, STICKY],
    ];
    for setup in [DEFAULT, SWITCHES[1], SWITCHES[7], PUBLISHED, SWITCHES[9]] {
        compare(setup, &disordered(7, sides));
    }
}
