//! Two gases beside each other: tubes of air and helium, a shock that an inclined interface refracts, a bubble that a shock runs over.

mod bubble;
mod refraction;
mod tube;

use aero_solver::frame::Frame;

use super::suite::Suite;
use super::variant::Levels;

const NAME: &str = "two-gases";

/// Air, and helium with 28 per cent air by mass, where the shock of Mach 1.22 comes from and where it goes.
mod bubble_gas {
    use aero_validation::exact::State;

    pub const GAMMAS: [f64; 2] = [1.4, 1.648];
    pub const MACH: f64 = 1.22;
    pub const AIR: State = State::new(1.2048, 0.0, 101_325.0);
    pub const HELIUM: State = State::new(0.2191, 0.0, 101_325.0);
}

/// All of them.
pub const TWO_GASES: Suite = Suite::of(&[
    (Levels::Both, tube::compare),
    (Levels::Both, refraction::compare),
    (Levels::Both, bubble::compare),
]);

/// Places of the second gas, or of the first, in the rows of particles that `is_near` finds.
fn places(gas: &Frame, is_second: bool, is_near: impl Fn(&[f64; 3]) -> bool) -> Vec<usize> {
    (0..gas.position.len())
        .filter(|&i| (gas.extra.second[i] == 1) == is_second && is_near(&gas.position[i]))
        .collect()
}
