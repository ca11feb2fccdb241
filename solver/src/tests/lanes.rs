//! The passes in lanes, of every width, against the scalar reference: random clouds of random states.

use super::agreement::compare;
use super::seam::{DEFAULT, PUBLISHED, Setup};
use super::*;
use crate::problem::{NoSlip, Slide, WallHeat};
use crate::scheme::ReturnOfShift;

const SWITCHES: [Setup; 15] = [
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
    Setup {
        shifting: true,
        return_of_shift: ReturnOfShift::Advection,
        ..DEFAULT
    },
    Setup {
        shifting: true,
        ..PUBLISHED
    },
    Setup {
        shifting: true,
        return_of_shift: ReturnOfShift::Exchange,
        ..PUBLISHED
    },
    Setup {
        two_gases: true,
        ..DEFAULT
    },
    Setup {
        two_gases: true,
        mirrors: true,
        limits_conduction: false,
        ..DEFAULT
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

/// A wall that gas sticks to and that does this to heat; its surface moves along itself.
fn sticky(heat: WallHeat) -> Side {
    Side::Wall {
        kind: WallKind::NoSlip(NoSlip {
            heat,
            slide: Slide {
                velocity: [0.0, 0.7, 0.2],
                ..Slide::default()
            },
        }),
        velocity: 0.3,
        acceleration: 0.0,
    }
}

/// The schemes with viscous gas, whose own conduction leaves the artificial one to shocks in the first two.
fn viscous() -> [Setup; 4] {
    [DEFAULT, SWITCHES[1], SWITCHES[4], PUBLISHED].map(|setup| Setup {
        viscous: true,
        ..setup
    })
}

#[test]
fn lanes_match_the_reference_with_viscous_gas() {
    let warm = sticky(WallHeat::Temperature(1.3));
    let heated = sticky(WallHeat::Flux(0.8));
    for setup in viscous() {
        compare(setup, &disordered(30, [[warm, heated]]));
        compare(setup, &disordered(30, [[Side::Inlet, Side::Outlet]]));
        let sides = [[warm, Side::Symmetry], [heated, WALL]];
        compare(setup, &disordered(12, sides));
        let sides = [[Side::Inlet, Side::Outlet], [STICKY, WALL]];
        compare(setup, &disordered(16, sides));
    }
    let sides = [
        [warm, Side::Symmetry],
        [WALL, STICKY],
        [Side::Symmetry, heated],
    ];
    for setup in viscous() {
        compare(setup, &disordered(6, sides));
    }
}

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
    for setup in SWITCHES {
        compare(setup, &disordered(6, sides));
    }
}
