//! From the file's `[free_stream]` to the state of the undisturbed gas.

use aero_geometry::Vector;

use super::atmosphere::{Air, GAS_CONSTANT};
use super::error::SceneError;
use super::file::{FreeStreamEntry, SceneFile};
use super::liquid;
use super::number::{Positive, StreamAngle};
use super::vector::vector;
use aero_solver::gas::Gas;
use aero_solver::problem::State;

/// Specific gas constant of dry air, J/(kg K) (R* / M = 8.31446 / 0.0289652; Picard et al. 2008,
/// Metrologia 45, 149, doi 10.1088/0026-1394/45/2/004).
const AIR: f64 = 287.05;

/// The undisturbed state.
pub(super) fn state<const D: usize>(
    entry: &FreeStreamEntry,
    gas: &Gas,
) -> Result<State<D>, SceneError> {
    let (pressure, density) = at_rest(entry, gas)?;
    let sound_speed = gas.sound_speed_at(density, pressure);
    let velocity = match (entry.mach, entry.speed, &entry.velocity) {
        (Some(mach), None, None) => direction(entry)? * (mach.get() * sound_speed),
        (None, Some(speed), None) => direction(entry)? * speed.get(),
        (None, None, Some(velocity)) => {
            let angles = [
                ("direction", entry.direction.is_some()),
                ("incidence", entry.incidence.is_some()),
                ("sideslip", entry.sideslip.is_some()),
            ];
            if let Some((key, _)) = angles.into_iter().find(|(_, is_given)| *is_given) {
                return Err(SceneError::value(
                    format!("free_stream.{key}"),
                    "goes with mach or speed; velocity has a direction already, so leave one out",
                ));
            }
            vector("free_stream.velocity", velocity)?
        }
        _ => {
            return Err(SceneError::value(
                "free_stream",
                "give exactly one of mach, speed and velocity",
            ));
        }
    };
    Ok(State {
        density,
        velocity,
        pressure,
    })
}

/// A free stream whose temperature goes with the gas constant of the scene, where it says none itself.
pub(super) fn with_constant(file: &SceneFile, entry: &FreeStreamEntry) -> FreeStreamEntry {
    let mut entry = entry.clone();
    if entry.temperature.is_some() {
        entry.gas_constant = entry.gas_constant.or(file.gas.gas_constant);
    }
    entry
}

/// Specific gas constant, where there is an altitude or a temperature.
pub(super) fn gas_constant(entry: &FreeStreamEntry) -> Option<f64> {
    let of_air = entry.altitude.map(|_| GAS_CONSTANT);
    let given = entry.gas_constant.map_or(AIR, Positive::get);
    of_air.or(entry.temperature.map(|_| given))
}

/// Pressure and density: of the atmosphere, or `p` and `rho` or, of an ideal gas, `p / (R T)`.
fn at_rest(entry: &FreeStreamEntry, gas: &Gas) -> Result<(f64, f64), SceneError> {
    if let Some(liquid) = gas.liquid() {
        let given = [entry.density, entry.pressure];
        let [density, pressure] = liquid::state(liquid, "free_stream", given)?;
        return Ok((pressure, density));
    }
    if let Some(altitude) = entry.altitude {
        let others = [
            ("pressure", entry.pressure),
            ("density", entry.density),
            ("temperature", entry.temperature),
            ("gas_constant", entry.gas_constant),
        ];
        if let Some((key, _)) = others.into_iter().find(|(_, value)| value.is_some()) {
            return Err(SceneError::value(
                format!("free_stream.{key}"),
                "follows from altitude; leave one of the two out",
            ));
        }
        let air = Air::at(altitude.get());
        return Ok((air.pressure, air.density()));
    }
    let Some(pressure) = entry.pressure.map(Positive::get) else {
        return Err(SceneError::value(
            "free_stream",
            "give pressure and one of density and temperature, or altitude",
        ));
    };
    match (entry.density, entry.temperature) {
        (Some(density), None) if entry.gas_constant.is_none() => Ok((pressure, density.get())),
        (None, Some(temperature)) => {
            if let Gas::Air { air, .. } = gas {
                return Ok((pressure, air.density_at(pressure, temperature.get())));
            }
            let gas_constant = entry.gas_constant.map_or(AIR, Positive::get);
            Ok((pressure, pressure / (gas_constant * temperature.get())))
        }
        (Some(_), None) => Err(SceneError::value(
            "free_stream.gas_constant",
            "goes with temperature; leave it out, or give temperature in place of density",
        )),
        _ => Err(SceneError::value(
            "free_stream",
            "give exactly one of density and temperature",
        )),
    }
}

/// The way that the gas goes.
fn direction<const D: usize>(entry: &FreeStreamEntry) -> Result<Vector<D>, SceneError> {
    let place = "free_stream.direction";
    let Some(numbers) = &entry.direction else {
        return by_angles(entry);
    };
    if entry.incidence.is_some() || entry.sideslip.is_some() {
        return Err(SceneError::value(
            place,
            "says what incidence and sideslip say; leave one of the two out",
        ));
    }
    vector::<D>(place, numbers)?
        .try_normalize(0.0)
        .ok_or_else(|| SceneError::value(place, "is zero; give the way that the gas goes"))
}

/// Along the first axis, raised by the incidence and turned aside by the sideslip:
/// `(cos a cos b, sin a cos b, sin b)`.
fn by_angles<const D: usize>(entry: &FreeStreamEntry) -> Result<Vector<D>, SceneError> {
    let given = [("incidence", entry.incidence), ("sideslip", entry.sideslip)];
    for (number, (key, angle)) in given.into_iter().enumerate() {
        if angle.is_some() && D < number + 2 {
            return Err(SceneError::value(
                format!("free_stream.{key}"),
                format!(
                    "needs {} dimensions, and the scene has {D}; leave it out",
                    number + 2
                ),
            ));
        }
    }
    let [up, aside] = given.map(|(_, angle)| angle.map_or(0.0, StreamAngle::get).to_radians());
    let way = [up.cos() * aside.cos(), up.sin() * aside.cos(), aside.sin()];
    Ok(Vector::<D>::from_fn(|k, _| way[k]))
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn stream<const D: usize>(text: &str) -> Result<State<D>, String> {
        let entry: FreeStreamEntry = toml::from_str(text).map_err(|error| error.to_string())?;
        state::<D>(&entry, &Gas::ideal(1.4)).map_err(|error| error.to_string())
    }

    #[test]
    fn mach_two_at_twelve_kilometres_comes_from_below() {
        let air =
            stream::<3>("mach = 2.0\naltitude = 12e3\nincidence = 5.0\nsideslip = -3.0").unwrap();
        assert_relative_eq!(air.pressure, 19_399.0, max_relative = 1e-4);
        assert_relative_eq!(air.velocity.norm(), 2.0 * 295.07, max_relative = 1e-4);
        let [x, y, z] = [0, 1, 2].map(|k| air.velocity[k]);
        assert_relative_eq!((y / x).atan().to_degrees(), 5.0, max_relative = 1e-12);
        assert_relative_eq!(
            (z / air.velocity.norm()).asin().to_degrees(),
            -3.0,
            max_relative = 1e-12
        );
    }

    #[test]
    fn without_angles_the_stream_goes_along_the_first_axis_to_the_bit() {
        let text = "mach = 2.5\ndensity = 1.0\npressure = 0.7142857142857143";
        let straight = stream::<2>(text).unwrap();
        let level = stream::<2>(&format!("{text}\nincidence = 0.0")).unwrap();
        assert_eq!(straight.velocity[1], 0.0);
        assert_eq!(straight, level);
    }

    #[test]
    fn what_contradicts_is_refused_with_the_mend() {
        for (text, words) in [
            ("mach = 2.0", "or altitude"),
            (
                "mach = 2.0\naltitude = 1e3\npressure = 1e5",
                "free_stream.pressure",
            ),
            (
                "mach = 2.0\naltitude = 1e3\ntemperature = 300.0",
                "follows from altitude",
            ),
            ("mach = 2.0\naltitude = 1e5", "-5000 to 86000"),
            ("mach = 2.0\naltitude = 1e3\nincidence = 90.0", "below 90"),
            (
                "mach = 2.0\naltitude = 1e3\nincidence = 2.0\ndirection = [1.0, 0.0]",
                "leave one of the two out",
            ),
            (
                "velocity = [600.0, 0.0]\naltitude = 1e3\nincidence = 2.0",
                "free_stream.incidence",
            ),
            (
                "mach = 2.0\naltitude = 1e3\nsideslip = 2.0",
                "needs 3 dimensions",
            ),
        ] {
            let error = stream::<2>(text).unwrap_err();
            assert!(error.contains(words), "{text}: {error}");
        }
    }
}
