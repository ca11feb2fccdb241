//! The shock that stands at a sharp concave bend of a wall, or across the edge of one in space, where a stream that is faster than sound turns into it.
//!
//! Up to some spacings from the bend there are fewer cells between shock and wall than a captured shock is wide: the first walls behind the bend
//! would feel a shock that is not done, and the gas that goes along them would keep what it got there. But how the gas is there is known: as in front
//! on one side of a straight shock, as behind it on the other.

use super::bend::Bend;
use super::cone_field::Field;
use super::equation_of_state::EquationOfState;
use super::fan::{SONIC, SUPERSONIC, rise};
use super::oblique::{largest_turn, ratios, weak_shock};
use super::state::{Conserved, Primitive, dot};

/// Part of the largest turn that a shock at the bend may make from which on it may stand ahead of the bend.
const NEARLY: f64 = 0.95;

/// Turn below which there is nothing but rounding in a shock, radians.
const LEAST: f64 = 1e-3;

/// No shock is looked for farther than this from its bend, in spacings: in the plane, and in space, where much more lies within it.
const FARTHEST: [f64; 2] = [128.0, 64.0];

/// The same in `D` dimensions.
pub const fn farthest<const D: usize>() -> f64 {
    FARTHEST[(D > 2) as usize]
}

/// Cells farther from a shock than this, in spacings, have no say in it, nor has it in them.
pub const FELT: f64 = 7.0;

/// Up to this part of how far it is looked for a shock stands as it would if nothing but the bend were there.
const NEAR: f64 = 0.75;

/// How far the energy behind a shock of a gas whose ratio of specific heats does not change may be off for another gas, in parts of it.
const SAME: f64 = 1e-6;

/// A straight shock at a bend, or that of a cone at its tip.
#[derive(Clone, Debug)]
pub struct AttachedShock<const D: usize> {
    /// Gas behind.
    pub rear: Primitive<D>,
    /// Unit normal of the shock, to the gas in front.
    pub normal: [f64; D],
    /// Logarithm of the pressure behind over that in front.
    pub strength: f64,
    /// How much of it there is: from none of gas that is slower than sound, or whose shock stands ahead of the bend, to one.
    pub share: f64,
    /// Gas behind the shock of a cone, which is not the same everywhere.
    pub field: Option<Field<D>>,
}

/// How far gas in the state `front`, of which `across` goes across the edge, meets a bend from a wall along `before` to one along `along` without
/// knowing of it: from not at all, where it is slower than sound or its shock stands ahead of the bend, to one.
pub fn share<G: EquationOfState, const D: usize>(
    gas: &G,
    front: &Primitive<D>,
    across: &[f64; D],
    before: &[f64; D],
    along: &[f64; D],
) -> f64 {
    let sound = gas.sound_square(front.density, front.pressure);
    let gamma = sound * front.density / front.pressure;
    let towards = dot(across, before);
    if towards <= 0.0 {
        return 0.0;
    }
    let fast = rise(towards * towards / sound, SONIC, SUPERSONIC);
    let speed = dot(across, across);
    let cosine = dot(across, along) / speed.sqrt();
    let turn = cosine.clamp(-1.0, 1.0).acos();
    let largest = largest_turn(speed / sound, gamma);
    fast * (1.0 - rise(turn, NEARLY * largest, largest))
}

/// What of a velocity does not go along an edge in space, which shocks leave as it is.
pub fn across<const D: usize>(velocity: &[f64; D], edge: &[f64; D]) -> [f64; D] {
    let slide = dot(velocity, edge);
    std::array::from_fn(|k| velocity[k] - slide * edge[k])
}

/// From one near a bend to zero so far from it, in spacings, that no shock is looked for.
pub fn nearness(away: f64, farthest: f64) -> f64 {
    1.0 - rise(away, NEAR * farthest, farthest)
}

impl<const D: usize> AttachedShock<D> {
    /// The shock at `bend` of gas in the state `front` ahead of it, if one stands there.
    pub fn new<G: EquationOfState>(gas: &G, front: &Primitive<D>, bend: &Bend<D>) -> Option<Self> {
        let across = across(&front.velocity, &bend.edge);
        let share = share(gas, front, &across, &bend.before, &bend.along);
        if share <= 0.0 {
            return None;
        }
        let sound = gas.sound_square(front.density, front.pressure);
        let gamma = sound * front.density / front.pressure;
        let square = dot(&across, &across);
        let speed = square.sqrt();
        let onwards = across.map(|u| u / speed);
        let rising = dot(&bend.up, &onwards);
        let mut aside = bend.up;
        for k in 0..D {
            aside[k] -= rising * onwards[k];
        }
        let size = dot(&aside, &aside).sqrt();
        let aside = aside.map(|part| part / size);
        let turn = dot(&bend.along, &aside).atan2(dot(&bend.along, &onwards));
        if turn < LEAST {
            return None;
        }
        let elevation = weak_shock(square / sound, gamma, turn)?;
        let (sine, cosine) = elevation.sin_cos();
        let mut normal = [0.0; D];
        for k in 0..D {
            normal[k] = cosine * aside[k] - sine * onwards[k];
        }
        let [density, pressure] = ratios(square / sound * sine * sine, gamma);
        let mut rear = Primitive {
            density: density * front.density,
            velocity: front.velocity,
            pressure: pressure * front.pressure,
        };
        // Gas slows straight across the shock alone.
        for k in 0..D {
            rear.velocity[k] += speed * sine * (1.0 - 1.0 / density) * normal[k];
        }
        is_perfect(gas, gamma, front, &rear).then(|| Self {
            rear,
            normal,
            strength: pressure.ln(),
            share,
            field: None,
        })
    }

    /// Gas behind it at a place as seen from its bend.
    pub fn rear_at(&self, place: &[f64; D]) -> Primitive<D> {
        let field = self.field.as_ref();
        field.map_or(self.rear, |field| field.at(place))
    }

    /// How far gas in the state `own` may be taken for what is `known` of it: not where its pressure is off by what the whole shock changes,
    /// and wholly up to half of that.
    pub fn agreement(&self, own: &Primitive<D>, known: &Primitive<D>) -> f64 {
        let off = (own.pressure / known.pressure).ln().abs();
        if dot(&own.velocity, &known.velocity) > 0.0 {
            1.0 - rise(off / self.strength, 0.5, 1.0)
        } else {
            0.0
        }
    }
}

/// True of gas whose heat capacity is behind a shock what it is in front of it.
pub fn is_perfect<G: EquationOfState, const D: usize>(
    gas: &G,
    gamma: f64,
    front: &Primitive<D>,
    rear: &Primitive<D>,
) -> bool {
    let energy = rear.pressure / (gamma - 1.0);
    let ground =
        gas.internal_energy(front.density, front.pressure) - front.pressure / (gamma - 1.0);
    let other =
        gas.internal_energy(rear.density, rear.pressure) - ground * (rear.density / front.density);
    (other - energy).abs() <= SAME * energy
}

/// The mean of a cell of which these parts are behind shocks, in those states, and the others in `front`.
pub fn mean<G: EquationOfState, const D: usize>(
    gas: &G,
    front: &Primitive<D>,
    behind: &[(f64, &Primitive<D>)],
) -> Primitive<D> {
    let ahead = behind.iter().fold(1.0, |ahead, (part, _)| ahead - part);
    let whole = behind.iter().find(|(part, _)| *part >= 1.0);
    match whole {
        Some((_, rear)) => **rear,
        None if ahead >= 1.0 => *front,
        None => {
            let front = Conserved::ZERO.plus(ahead, &front.conserved(gas));
            let add = |sum: Conserved<D>, (part, rear): &(f64, &Primitive<D>)| {
                sum.plus(*part, &rear.conserved(gas))
            };
            behind.iter().fold(front, add).primitive(gas)
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::gas::{Air, IdealGas};

    const AIR: IdealGas = IdealGas::new(1.4);

    fn bend(degrees: f64) -> Bend<2> {
        Bend::ramp(degrees, 1.0)
    }

    /// A stream at this Mach number and temperature, in kelvins of air.
    fn front(mach: f64, temperature: f64) -> Primitive<2> {
        let heat = 287.0 * temperature;
        Primitive {
            density: 1.0,
            velocity: [mach * (1.4 * heat).sqrt(), 0.0],
            pressure: heat,
        }
    }

    /// NACA Report 1135 (1953), eqs 93, 94 and 150: 42.89 degrees, 2.2002 and 3.2109 at Mach 2.5 and 20 degrees.
    #[test]
    fn gas_behind_the_shock_goes_along_its_wall() {
        let front = front(2.5, 220.0);
        let shock = AttachedShock::new(&AIR, &front, &bend(20.0)).unwrap();
        let elevation = f64::to_radians(42.89);
        assert_relative_eq!(shock.normal[0], -elevation.sin(), epsilon = 1e-5);
        assert_relative_eq!(shock.normal[1], elevation.cos(), epsilon = 1e-5);
        assert_relative_eq!(shock.rear.density, 2.200_16, epsilon = 1e-5);
        assert_relative_eq!(
            shock.rear.pressure / front.pressure,
            3.210_91,
            epsilon = 1e-5
        );
        let [u, v] = shock.rear.velocity;
        assert_relative_eq!(v / u, f64::to_radians(20.0).tan(), epsilon = 1e-9);
        // What passes the shock is the same on both sides, straight across it.
        let fluxes = [&front, &shock.rear].map(|state| {
            let energy = state.conserved(&AIR).energy;
            state.flux(energy, dot(&state.velocity, &shock.normal), &shock.normal)
        });
        assert_relative_eq!(fluxes[0].mass, fluxes[1].mass, max_relative = 1e-12);
        assert_relative_eq!(fluxes[0].energy, fluxes[1].energy, max_relative = 1e-12);
        for k in 0..2 {
            assert_relative_eq!(
                fluxes[0].momentum[k],
                fluxes[1].momentum[k],
                max_relative = 1e-9
            );
        }
        assert_eq!(shock.share, 1.0);
        assert!(AttachedShock::new(&AIR, &front, &bend(-5.0)).is_none());
    }

    #[test]
    fn gas_that_is_as_on_the_other_side_is_not_taken_for_what_stands_here() {
        let front = &front(3.0, 220.0);
        let shock = AttachedShock::new(&AIR, front, &bend(15.0)).unwrap();
        let rear = &shock.rear;
        assert_eq!(shock.agreement(rear, rear), 1.0);
        assert_eq!(shock.agreement(front, rear), 0.0);
        let mixed = mean(&AIR, front, &[(0.7, rear)]);
        assert!(shock.agreement(&mixed, rear) > 0.5);
        let back = rear.mirrored(&[1.0, 0.0]);
        assert_eq!(shock.agreement(&back, rear), 0.0);
    }

    /// Air whose molecules begin to swing behind the shock is denser there than by the ratio of specific heats ahead.
    #[test]
    fn no_shock_is_known_of_gas_whose_heat_capacity_changes_in_it() {
        let air = Air::Equilibrium;
        assert!(AttachedShock::new(&air, &front(8.0, 300.0), &bend(30.0)).is_none());
        assert!(AttachedShock::new(&AIR, &front(8.0, 300.0), &bend(30.0)).is_some());
    }
}
