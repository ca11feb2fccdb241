//! Outlets that hold a pressure and let sound out.
//!
//! Below the speed of sound one wave comes in through an outlet, and what it brings is up to the outlet. With it given the
//! pressure is held and sound comes back whole; here it relaxes to the pressure at the side,
//! `dR-/dt = sigma (1 - M^2) (p - p_held) / (rho L)` with `L` the length of the domain [Poinsot & Lele 1992, J. Comput. Phys. 101,
//! 104-129, eq. 40], so that waves shorter than the domain leave, and the mean pressure is held: where nothing else comes,
//! `p - p_held` falls as `exp(-sigma (1 - M^2) c t / 2 L)`. The wave has a life of its own, a face's where points stay, handed down from
//! what left before where the gas moves: told from the gas inside, from what flows along the side there, it would be off the pressure for
//! good where a duct widens, or swing about it.
//! Faster than sound nothing comes in but the shock of a pressure that the gas cannot pass.

use super::incoming::Incoming;
use super::model::Place;
use super::plenum::Plenum;
use super::waves::Along;
use crate::problem::Problem;

/// The mean of late forgets so many times faster than a wave goes back to the pressure held: vortices pass, a duct stays.
const MEMORY: f64 = 4.0;

/// An outlet that holds a pressure.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    pub(super) place: Place,
    /// The pressure.
    pressure: f64,
    /// `sigma / L`; none where nothing but the pressure counts.
    strength: Option<f64>,
    pub(super) gamma: f64,
    /// What comes back in.
    plenum: Plenum,
}

impl Held {
    /// The outlet of `problem` at `place` that holds `pressure`; `relaxation` is `sigma`, none of one that holds it at once and lets no
    /// sound out, as a flow does that goes to its steady state through states that none passes through.
    pub fn new<const D: usize>(
        problem: &Problem<D>,
        place: Place,
        pressure: f64,
        relaxation: Option<f64>,
    ) -> Self {
        let stream = &problem.free_stream;
        Self {
            place,
            pressure,
            strength: relaxation.map(|sigma| sigma / problem.domain.bounds.size()[place.axis]),
            gamma: problem.gas.ratio_at(stream.density, stream.pressure),
            plenum: Plenum::before(problem, place.axis).at(pressure),
        }
    }

    /// One that holds another pressure.
    #[must_use]
    pub fn at(self, pressure: f64) -> Self {
        Self {
            pressure,
            plenum: self.plenum.at(pressure),
            ..self
        }
    }

    /// How fast the wave that comes in changes where gas is in this state, its speed out of the domain; none faster than sound.
    fn rate(&self, gas: &Along) -> Option<f64> {
        let mach = gas.speed / gas.sound(self.gamma);
        let above = (gas.pressure - self.pressure) / gas.density;
        let strength = self.strength.unwrap_or_default();
        (mach < 1.0).then(|| strength * (1.0 - mach * mach).max(0.0) * above)
    }

    /// What is behind the shock that runs into gas in this state, faster than sound and out of the domain, from the pressure
    /// held; none of a pressure that the gas carries out with it (Rankine-Hugoniot, e.g. Toro 2009, section 3.1.3).
    pub fn shocked(&self, gas: &Along) -> Option<Along> {
        let gamma = self.gamma;
        let sound = gas.sound(gamma);
        let (mach, rise) = (gas.speed / sound, self.pressure / gas.pressure);
        let front = 1.0 + 0.5 * (gamma + 1.0) / gamma * (rise - 1.0);
        if mach < 1.0 || front <= mach * mach {
            return None;
        }
        let part = (gamma - 1.0) / (gamma + 1.0);
        let front = front.sqrt();
        Some(Along {
            density: gas.density * (rise + part) / (part * rise + 1.0),
            speed: gas.speed - 2.0 * sound / (gamma + 1.0) * (front - 1.0 / front),
            pressure: self.pressure,
        })
    }

    /// Gas slower than sound at the pressure itself, which the wave on its way out and the entropy reach it with.
    fn met(&self, gas: &Along) -> Along {
        let gamma = self.gamma;
        let rise = self.pressure / gas.pressure;
        let there = gas.sound(gamma) * rise.powf(0.5 * (gamma - 1.0) / gamma);
        Along {
            density: gas.density * rise.powf(1.0 / gamma),
            speed: gas.waves(gamma).ahead - 2.0 * there / (gamma - 1.0),
            pressure: self.pressure,
        }
    }

    /// True of one that goes back to its pressure in time.
    pub fn relaxes(&self) -> bool {
        self.strength.is_some()
    }

    /// The wave that gas in this state has of itself, its speed out of the domain.
    pub fn own(&self, gas: &Along) -> Incoming {
        Incoming::of(gas, self.gamma)
    }

    /// The wave that comes in a `step` later at a face that gas in this state reaches, its speed out of the domain, parting along the
    /// side at this rate. It changes by what the outlet asks for of the gas at the face; by what another entropy makes of the speed of
    /// sound at the same pressure; and by the speed that a vortex brings with it, at the same pressure too: `-u du/dn = u div_t v` of
    /// what that is beside its mean of late, that of the flow as a whole. Gas faster than sound has its own.
    pub fn later(&self, wave: &Incoming, gas: &Along, parting: f64, step: f64) -> Incoming {
        let own = self.own(gas).parting(parting);
        let sound = gas.sound(self.gamma);
        let there = wave.meeting(gas, self.gamma);
        let Some(there) = there.filter(|_| gas.speed < sound) else {
            return own;
        };
        let rate = self.rate(&Along {
            speed: there.speed.max(0.0),
            ..there
        });
        let turning = there.speed.max(0.0) * (parting - wave.parting);
        let share = (step * MEMORY * self.strength.unwrap_or_default() * sound).min(1.0);
        let warmer = (own.entropy - wave.entropy) * sound / (self.gamma * (self.gamma - 1.0));
        Incoming {
            back: wave.back + step * (rate.unwrap_or_default() + turning) - warmer,
            parting: wave.parting + share * (parting - wave.parting),
            ..own
        }
    }

    /// What is beyond a face that gas in this state reaches, its speed out of the domain, with this wave coming in.
    pub fn behind(&self, wave: &Incoming, gas: &Along) -> Along {
        self.forced(gas)
            .or_else(|| wave.meeting(gas, self.gamma))
            .unwrap_or(*gas)
    }

    /// What is beyond such a face where the pressure is held at once.
    pub fn beyond(&self, gas: &Along) -> Along {
        self.forced(gas).unwrap_or_else(|| self.met(gas))
    }

    /// Gas that comes back in against the wave `ahead` on its way out, its speed out of the domain.
    pub fn returning(&self, ahead: f64) -> Along {
        self.plenum.entering(-ahead).turned()
    }

    /// What is beyond gas that no wave decides on. What comes back in comes from gas at rest across the side at the pressure, as hot as the free
    /// stream's; gas faster than sound leaves as it is, unless a shock comes in.
    fn forced(&self, gas: &Along) -> Option<Along> {
        if gas.speed < 0.0 {
            return Some(self.returning(gas.waves(self.gamma).ahead));
        }
        let is_fast = gas.speed >= gas.sound(self.gamma);
        self.shocked(gas).or_else(|| is_fast.then_some(*gas))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Side;
    use crate::tests::cube;
    use approx::assert_relative_eq;

    const GAMMA: f64 = 1.4;
    /// Of the domain.
    const LENGTH: f64 = 0.8;

    fn outlet(pressure: f64) -> Held {
        let place = Place {
            axis: 0,
            end: 1,
            face: 1.0,
            part: None,
        };
        Held::new(&cube::<1>(8, Side::Outlet), place, pressure, Some(0.25))
    }

    fn gas(mach: f64) -> Along {
        Along {
            density: 1.0,
            speed: mach,
            pressure: 1.0 / GAMMA,
        }
    }

    /// What stands at a face after so many steps of a quarter each.
    fn after(outlet: &Held, steps: usize, inside: impl Fn(usize) -> Along) -> Along {
        let mut wave = Incoming::of(&inside(0), GAMMA);
        for step in 1..=steps {
            wave = outlet.later(&wave, &inside(step), 0.0, 0.25);
        }
        outlet.behind(&wave, &inside(steps))
    }

    #[test]
    fn gas_at_the_pressure_is_left_alone() {
        let inside = gas(0.5);
        let beyond = after(&outlet(inside.pressure), 9, |_| inside);
        assert_relative_eq!(beyond.pressure, inside.pressure, epsilon = 1e-14);
        assert_relative_eq!(beyond.speed, inside.speed, epsilon = 1e-14);
    }

    /// `d(p - p_held)/dt = -sigma (1 - M^2) c (p - p_held) / 2 L` where the wave on its way out does not change.
    #[test]
    fn gas_above_the_pressure_is_drawn_out_until_it_is_there() {
        let held = 0.999 / GAMMA;
        let outlet = outlet(held);
        let soon = after(&outlet, 4, |_| gas(0.5));
        let part = (soon.pressure - held) / (1e-3 / GAMMA);
        let rate = 0.25 * 0.75 / (2.0 * LENGTH);
        let expected = (1.0 - 0.25 * rate).powi(4);
        assert!((part - expected).abs() < 1e-4, "{part} {expected}");
        assert!(soon.speed > 0.5);
        let late = after(&outlet, 400, |_| gas(0.5));
        assert_relative_eq!(late.pressure, held, max_relative = 1e-6);
    }

    /// Hot gas that is carried out at the pressure brings no sound with it.
    #[test]
    fn another_entropy_changes_no_pressure() {
        let inside = |step: usize| Along {
            density: 1.0 - 4e-4 * step as f64,
            ..gas(0.5)
        };
        let beyond = after(&outlet(1.0 / GAMMA), 500, inside);
        assert_relative_eq!(beyond.pressure, 1.0 / GAMMA, max_relative = 1e-3);
        assert_relative_eq!(beyond.density, 0.8, max_relative = 1e-3);
        assert_relative_eq!(beyond.speed, 0.5, max_relative = 2e-3);
    }

    /// A vortex that passes brings a speed of its own and no sound; gas that parts evenly, as where a duct widens, nothing.
    #[test]
    fn a_vortex_leaves_at_the_pressure_and_a_duct_ends_at_it() {
        let outlet = outlet(1.0 / GAMMA);
        let (step, swings) = (0.002, 0.8);
        let mut wave = outlet.own(&gas(0.5)).parting(0.0);
        let (mut least, mut most) = (1.0_f64, 1.0_f64);
        for n in 1..1000 {
            // u' = 0.05 sin(w t), and div_t v = -du'/dn = (du'/dt) / u where it drifts out with the gas.
            let time = step * f64::from(n);
            let swing = 0.05 * (std::f64::consts::TAU * swings * time).sin();
            let rate = 0.05
                * std::f64::consts::TAU
                * swings
                * (std::f64::consts::TAU * swings * time).cos();
            let inside = gas(0.5 + swing);
            wave = outlet.later(&wave, &inside, rate / 0.5, step);
            let pressure = outlet.behind(&wave, &inside).pressure * GAMMA;
            (least, most) = (least.min(pressure), most.max(pressure));
        }
        // All of it back would be 0.05 rho c u', 7 % of the pressure.
        assert!(most - least < 0.03, "{least} {most}");
        let mut wave = outlet.own(&gas(0.5)).parting(0.3);
        wave.back += 0.01;
        for _ in 0..20_000 {
            wave = outlet.later(&wave, &gas(0.5), 0.3, 0.01);
        }
        let there = outlet.behind(&wave, &gas(0.5)).pressure;
        assert_relative_eq!(there, 1.0 / GAMMA, max_relative = 1e-6);
    }

    #[test]
    fn gas_faster_than_sound_leaves_unless_a_shock_comes_in() {
        let inside = gas(2.0);
        // Behind a normal shock at Mach 2: 4.5 (NACA 1135, 1953, eq. 93).
        let weak = after(&outlet(4.4 / GAMMA), 1, |_| inside);
        assert_eq!(weak, inside);
        let beyond = after(&outlet(5.0 / GAMMA), 1, |_| inside);
        // It moves in, and mass, momentum and energy go through it unchanged.
        let jump = beyond.density - inside.density;
        let flux = |gas: &Along| gas.density * gas.speed;
        let front = (flux(&beyond) - flux(&inside)) / jump;
        assert!(front < 0.0, "{front}");
        let through = |gas: &Along| {
            let speed = gas.speed - front;
            let enthalpy = GAMMA / (GAMMA - 1.0) * gas.pressure / gas.density;
            [
                gas.pressure + gas.density * speed * speed,
                enthalpy + 0.5 * speed * speed,
            ]
        };
        for (a, b) in through(&inside).into_iter().zip(through(&beyond)) {
            assert_relative_eq!(a, b, epsilon = 1e-12);
        }
    }

    #[test]
    fn what_comes_back_comes_from_rest() {
        let beyond = after(&outlet(1.2 / GAMMA), 1, |_| gas(-0.2));
        let rise = (1.2 / GAMMA / beyond.pressure).powf((GAMMA - 1.0) / GAMMA);
        let mach = -beyond.speed / beyond.sound(GAMMA);
        assert_relative_eq!(rise, 1.0 + 0.2 * mach * mach, epsilon = 1e-12);
    }

    /// The pressure held, the wave that goes out and the entropy make the state, and gas faster than sound takes none of it.
    #[test]
    fn a_pressure_held_at_once_is_that_beyond_the_side() {
        let outlet = Held {
            strength: None,
            ..outlet(0.9 / GAMMA)
        };
        let inside = gas(0.5);
        let beyond = outlet.beyond(&inside);
        let [before, after] = [inside, beyond].map(|gas| gas.waves(GAMMA));
        assert_relative_eq!(beyond.pressure, 0.9 / GAMMA, epsilon = 1e-14);
        assert_relative_eq!(after.ahead, before.ahead, epsilon = 1e-13);
        assert_relative_eq!(after.entropy, before.entropy, epsilon = 1e-13);
        assert!(beyond.speed > inside.speed);
        assert_eq!(outlet.beyond(&gas(2.0)), gas(2.0));
    }
}
