//! Stagnation pressure of blunt bodies from the pressure on their walls.

use super::MetricError;
use super::least_squares::{Row, fit};

/// Pressure where the wall stands across the stream, from pressures around there.
///
/// The straight line in `sin^2 theta`, the law of modified Newtonian theory, that fits best the walls less than `cap` degrees from
/// the stagnation point: `(theta, pressure)`, theta in degrees, any unit of pressure.
///
/// # Errors
/// Fewer than two different angles within the cap.
pub fn stagnation_pressure(
    walls: impl IntoIterator<Item = (f64, f64)>,
    cap: f64,
) -> Result<f64, MetricError> {
    let rows: Vec<Row<2>> = walls
        .into_iter()
        .filter(|(angle, _)| angle.abs() < cap)
        .map(|(angle, value)| Row {
            terms: [1.0, angle.to_radians().sin().powi(2)],
            value,
        })
        .collect();
    let found = rows.len();
    fit(&rows).map(|fit| fit.x[0]).ok_or(MetricError::TooFew {
        what: "walls near the stagnation point",
        found,
        needed: 2,
        remedy: "use a smaller spacing",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_newtonian_wall_gives_its_stagnation_pressure_and_what_is_far_does_not_count() {
        let walls = (-60..=60_i32).map(|degrees| {
            let theta = f64::from(degrees);
            let law = 2.0 - 1.5 * theta.to_radians().sin().powi(2);
            (theta, if degrees.abs() < 20 { law } else { -7.0 })
        });
        let found = stagnation_pressure(walls, 20.0).unwrap();
        assert!((found - 2.0).abs() < 1e-12, "{found}");
        assert!(stagnation_pressure([(3.0, 1.0)], 20.0).is_err());
    }
}
