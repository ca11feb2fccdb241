use approx::assert_relative_eq;

use super::Air;
use super::equilibrium::{Level, Mixture};
use crate::gas::Gas;

const BOTH: [Air; 2] = [Air::ThermallyPerfect, Air::Equilibrium];

/// Density, kg/m^3, and temperature, K, of gas from a cold stream to behind a strong shock.
const STATES: [[f64; 2]; 6] = [
    [3e-4, 250.0],
    [1.2, 300.0],
    [0.1, 1400.0],
    [1e-3, 3000.0],
    [5e-3, 5800.0],
    [0.5, 4500.0],
];

/// Air at a temperature, K, and a pressure, Pa: density, energy above that at rest at no temperature, J/kg, speed of sound, m/s, by
/// Cantera 3.2 from the same polynomials, with its own search for the composition.
const TABLE: [[f64; 5]; 7] = [
    [300.0, 1e5, 1.161_195_1, 2.146_536_5e5, 347.2287],
    [1500.0, 1e5, 0.232_238_81, 1.209_588_7e6, 749.4966],
    [3000.0, 1e5, 0.113_477_58, 3.188_830_1e6, 1017.432],
    [3000.0, 1e3, 1.016_634_9e-3, 5.140_351_2e6, 1062.471],
    [6000.0, 1e4, 3.809_497_8e-3, 1.939_701e7, 1718.21],
    [10_000.0, 1e5, 1.714_425_4e-2, 4.197_232_9e7, 2667.42],
    [14_000.0, 1e6, 0.111_799_25, 5.781_177_5e7, 3278.127],
];

#[test]
fn air_in_equilibrium_is_that_of_another_code() {
    let air = Air::Equilibrium;
    for [temperature, pressure, density, energy, sound] in TABLE {
        let found = air.density_at(pressure, temperature);
        assert_relative_eq!(found, density, max_relative = 2e-4);
        assert_relative_eq!(air.energy(density, pressure), energy, max_relative = 3e-4);
        let square = air.sound_square(density, pressure);
        assert_relative_eq!(square.sqrt(), sound, max_relative = 1e-3);
        assert_relative_eq!(
            air.temperature(density, pressure),
            temperature,
            max_relative = 1e-4
        );
    }
}

/// Mole fractions at 6000 K and 10 kPa, by the same code.
#[test]
fn the_composition_is_that_of_another_code() {
    let mixture = Mixture::new(&Level::at(6000.0), 3.809_497_8e-3, None);
    let all: f64 = mixture.moles.iter().sum();
    let expected = [
        0.304_25, 1.9226e-5, 1.698e-3, 0.414_16, 0.272_85, 2.7879e-4, 3.1031e-5, 2.4792e-5,
        6.354e-3, 3.3462e-4,
    ];
    for (moles, expected) in mixture.moles.iter().zip(expected) {
        assert_relative_eq!(moles / all, expected, max_relative = 1e-3);
    }
}

#[test]
fn pressure_energy_and_density_undo_each_other() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let energy = air.energy_at(density, temperature);
            let pressure = air.pressure(density, energy);
            let near = 1e-11;
            assert_relative_eq!(air.energy(density, pressure), energy, max_relative = near);
            assert_relative_eq!(air.density(pressure, energy), density, max_relative = near);
            let found = air.temperature(density, pressure);
            assert_relative_eq!(found, temperature, max_relative = near);
            let found = air.density_at(pressure, temperature);
            assert_relative_eq!(found, density, max_relative = near);
        }
    }
}

/// `(d(1 / T) / dv)_e = (d(p / T) / de)_v`: that there is an entropy. The table has one as far as its nodes are exact and near enough.
#[test]
fn temperature_and_pressure_belong_to_one_entropy() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let energy = air.energy_at(density, temperature);
            let pressure = air.pressure(density, energy);
            let step = 1e-4;
            let cold = |part: f64| {
                let density = density / (1.0 + part);
                1.0 / air.temperature(density, air.pressure(density, energy))
            };
            let pressed = |part: f64| {
                let pressure = air.pressure(density, energy * (1.0 + part));
                pressure / air.temperature(density, pressure)
            };
            // Both over p / (T e).
            let unit = pressure / (temperature * energy);
            let left = (cold(step) - cold(-step)) / (2.0 * step) * density;
            let right = (pressed(step) - pressed(-step)) / (2.0 * step) / energy;
            assert!(
                (left - right).abs() < 2e-3 * unit,
                "{air:?} at {density}, {temperature}: {} is not {}",
                left / unit,
                right / unit
            );
        }
    }
}

/// `c^2 = (dp / drho)_s`, and `de = p / rho^2 drho` where entropy is constant.
#[test]
fn sound_is_what_the_pressure_rises_by_along_an_isentrope() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let energy = air.energy_at(density, temperature);
            let pressure = air.pressure(density, energy);
            let step = 1e-4;
            let along = |part: f64| {
                let pressure = pressure * (1.0 + part);
                let density = air.isentropic_density(density, pressure / (1.0 + part), pressure);
                [pressure, density, air.energy(density, pressure)]
            };
            let [low, high] = [along(-step), along(step)];
            let square = (high[0] - low[0]) / (high[1] - low[1]);
            let found = air.sound_square(density, pressure);
            assert_relative_eq!(found, square, max_relative = 1e-5);
            let work = (high[2] - low[2]) / (high[1] - low[1]) * density * density;
            assert_relative_eq!(work, pressure, max_relative = 1e-5);
        }
    }
}

/// It is constant along isentropes, and grows by `dh / T` with heat at a pressure.
#[test]
fn entropy_belongs_to_temperature_and_sound() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let pressure = air.pressure(density, air.energy_at(density, temperature));
            let capacity = air.gas_constant();
            let start = air.entropy(density, pressure);
            for there in [0.05 * pressure, 3.0 * pressure] {
                let along = air.entropy(air.isentropic_density(density, pressure, there), there);
                assert!((along - start).abs() < 2e-3 * capacity, "{air:?} {density}");
            }
            let enthalpy = |density: f64| air.energy(density, pressure) + pressure / density;
            let [thin, dense] = [0.999 * density, 1.001 * density];
            let rise = air.entropy(thin, pressure) - air.entropy(dense, pressure);
            let heat = enthalpy(thin) - enthalpy(dense);
            assert_relative_eq!(rise * temperature, heat, max_relative = 1e-3);
        }
    }
}

/// Far along it and back.
#[test]
fn an_isentrope_leads_back() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let pressure = air.pressure(density, air.energy_at(density, temperature));
            let there = air.isentropic_density(density, pressure, 0.02 * pressure);
            let back = air.isentropic_density(there, 0.02 * pressure, pressure);
            assert_relative_eq!(back, density, max_relative = 1e-5);
        }
    }
}

#[test]
fn the_pressure_changes_as_its_derivatives_say() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let energy = air.energy_at(density, temperature);
            let pressure = air.pressure(density, energy);
            for [by_density, by_energy] in [[1.0, 0.0], [0.0, 1.0], [1.0, 2.0]] {
                let pressed = |step: f64| {
                    let dense = density * (1.0 + step * by_density);
                    air.pressure(dense, density * energy * (1.0 + step * by_energy) / dense)
                };
                let step = 1e-5;
                let slope = (pressed(step) - pressed(-step)) / (2.0 * step);
                let change = [by_density * density, by_energy * density * energy];
                let told = air.pressure_change(density, pressure, change);
                assert!((told - slope).abs() < 1e-5 * pressure, "{told} {slope}");
            }
        }
    }
}

/// Mass, momentum and energy go through the shock that stops gas at a wall unchanged; weak ones are sound, from both sides.
#[test]
fn gas_that_meets_a_wall_is_stopped_by_a_shock() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let energy = air.energy_at(density, temperature);
            let pressure = air.pressure(density, energy);
            let sound = air.sound_square(density, pressure).sqrt();
            for mach in [2e-3, 0.3, 5.0] {
                let speed = mach * sound;
                let wall = air.wall_pressure(density, pressure, speed);
                // In the frame of the shock gas comes in at u + W and leaves at W.
                let front = (wall - pressure) / (density * speed) - speed;
                let behind = density * (speed + front) / front;
                let total = |density: f64, pressure: f64, speed: f64| {
                    air.energy(density, pressure) + pressure / density + 0.5 * speed * speed
                };
                let off = total(density, pressure, speed + front) - total(behind, wall, front);
                assert!(off.abs() < 1e-6 * speed * sound, "{off} at Mach {mach}");
            }
            for speed in [1e-4 * sound, -1e-4 * sound] {
                let wall = air.wall_pressure(density, pressure, speed);
                let rise = (wall - pressure) / (density * sound * speed);
                assert_relative_eq!(rise, 1.0, max_relative = 2e-4);
            }
        }
    }
}

/// `du = dp / (rho c)` through an expansion: half and half is the whole, and gas that leaves fast enough leaves nothing.
#[test]
fn gas_that_leaves_a_wall_expands_along_its_isentrope() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let pressure = air.pressure(density, air.energy_at(density, temperature));
            let sound = air.sound_square(density, pressure).sqrt();
            let once = air.wall_pressure(density, pressure, -sound);
            let half = air.wall_pressure(density, pressure, -0.5 * sound);
            let between = air.isentropic_density(density, pressure, half);
            let twice = air.wall_pressure(between, half, -0.5 * sound);
            assert_relative_eq!(once, twice, max_relative = 1e-4);
            assert!(air.wall_pressure(density, pressure, -60.0 * sound) < 1e-6 * pressure);
        }
    }
}

/// Cold air is an ideal gas with a ratio of specific heats of 1.4013, below the range of the polynomials to the last digit.
#[test]
fn cold_air_is_an_ideal_gas() {
    for (air, near) in [(Air::ThermallyPerfect, 1e-12), (Air::Equilibrium, 1e-6)] {
        for temperature in [60.0, 150.0, 199.0] {
            let density = 0.01;
            let energy = air.energy_at(density, temperature);
            assert_relative_eq!(energy / temperature, 715.2332, max_relative = 1e-4);
            let pressure = air.pressure(density, energy);
            assert_relative_eq!(
                pressure,
                density * air.gas_constant() * temperature,
                max_relative = near
            );
            let gamma = air.sound_square(density, pressure) * density / pressure;
            assert_relative_eq!(gamma, 1.0 + 287.0606 / 715.2332, max_relative = 1e-5);
        }
    }
}

/// `c_v = (de / dT)_v` and `c_p = (dh / dT)_p`, on both sides of where polynomials begin and end.
#[test]
fn heat_capacities_are_slopes() {
    for air in BOTH {
        for temperature in [150.0, 199.99, 200.01, 700.0, 2500.0, 5999.0, 6001.0, 9000.0] {
            let density = 2e-3;
            let energy = air.energy_at(density, temperature);
            let step = 1e-4 * temperature;
            let [low, high] = [temperature - step, temperature + step];
            let rise = air.energy_at(density, high) - air.energy_at(density, low);
            let found = air.heat_capacity_at_volume(density, energy);
            assert_relative_eq!(found, rise / (2.0 * step), max_relative = 2e-3);
            let pressure = air.pressure(density, energy);
            let enthalpy = |temperature| {
                let density = air.density_at(pressure, temperature);
                air.energy(density, pressure) + pressure / density
            };
            let rise = enthalpy(high) - enthalpy(low);
            let found = air.heat_capacity(density, energy);
            assert_relative_eq!(found, rise / (2.0 * step), max_relative = 2e-3);
        }
    }
}

/// Enthalpy and its changes, by differences; the `p / rho` that belongs to one.
#[test]
fn enthalpy_changes_as_its_derivatives_say() {
    for air in BOTH {
        for [density, temperature] in STATES {
            let pressure = air.pressure(density, air.energy_at(density, temperature));
            let enthalpy =
                |density: f64, pressure: f64| air.energy(density, pressure) * density + pressure;
            for [by_density, by_pressure] in [[1.0, 0.0], [0.0, 1.0], [1.0, -2.0]] {
                let step = 1e-5;
                let at = |part: f64| {
                    let dense = density * (1.0 + part * by_density);
                    enthalpy(dense, pressure * (1.0 + part * by_pressure))
                };
                let slope = (at(step) - at(-step)) / (2.0 * step);
                let change = [by_density * density, by_pressure * pressure];
                let [whole, told] = air.enthalpy_change(density, pressure, change);
                assert_relative_eq!(whole, at(0.0), max_relative = 1e-12);
                assert!((told - slope).abs() < 1e-5 * whole, "{told} {slope}");
            }
            let found = air.heat_of_enthalpy(pressure, enthalpy(density, pressure) / density);
            assert_relative_eq!(found, pressure / density, max_relative = 1e-10);
            let gas = Gas::Air {
                air,
                transport: None,
            };
            let held = gas.energy_at(pressure, temperature);
            assert_relative_eq!(held, air.energy(density, pressure), max_relative = 1e-10);
            let [thin, dense] = [1.0 - 1e-4, 1.0 + 1e-4].map(|part| part * density);
            let rise = |value: &dyn Fn(f64) -> f64| value(thin) - value(dense);
            let ratio = rise(&|density| enthalpy(density, pressure) / density)
                / rise(&|density| air.energy(density, pressure));
            let told = air.enthalpy_by_energy(density, air.energy(density, pressure));
            assert_relative_eq!(told, ratio, max_relative = 1e-4);
        }
    }
}

/// What is no state of a gas stays so, and nothing panics.
#[test]
fn nonsense_stays_nonsense() {
    for air in BOTH {
        assert!(air.pressure(1.0, -1e5) < 0.0);
        assert!(air.pressure(1.0, f64::NAN).is_nan());
        let energy = air.energy(1.0, -1e5);
        assert!(energy.is_nan() || energy <= 0.0);
    }
}
