//! The published scheme over the corner, as it is: its shock angle as published, and the plateau that it has always had
//! here. Off theory as both are, they tell whether it is still that scheme.

use aero_validation::exact::oblique::ObliqueShock;

use super::corner::Corner;
use super::flow::Measured;
use crate::row::Row;
use crate::variant;

type Variant = variant::Variant<Corner>;

const ANGLES: &str = "Villodi & Ramachandran 2024, table 1";
const PLATEAUS: &str = "the published equations (validation/wedge)";
/// How far an angle may be off the published one, and a plateau off what it was, per cent of theory.
const ANGLE: f64 = 0.3;
const PLATEAU: f64 = 1.0;

/// Both extrapolations, `wom` and `wm`, over one corner.
struct Known {
    /// Mach number, ramp angle in degrees, gamma.
    corner: [f64; 3],
    /// Density of the plateau, per cent off theory.
    density: [f64; 2],
    /// Pressure of the plateau, per cent off theory.
    pressure: [f64; 2],
    /// Published shock angle in degrees, where there is one.
    angle: Option<[f64; 2]>,
}

const fn known(
    corner: [f64; 3],
    [density, pressure]: [[f64; 2]; 2],
    angle: Option<[f64; 2]>,
) -> Known {
    Known {
        corner,
        density,
        pressure,
        angle,
    }
}

#[rustfmt::skip] // a table
const KNOWN: [Known; 8] = [
    known([2.5, 20.0, 1.4], [[1.15, 1.14], [0.54, 0.49]], None),
    known([5.0, 10.0, 1.4], [[0.93, 0.81], [0.44, 0.35]], Some([19.20, 19.24])),
    known([5.0, 15.0, 1.4], [[3.94, 3.84], [2.51, 2.39]], Some([24.10, 24.12])),
    known([5.0, 20.0, 1.4], [[8.08, 8.06], [5.55, 5.47]], Some([29.54, 29.55])),
    known([5.0, 25.0, 1.4], [[12.71, 12.65], [9.01, 8.95]], Some([35.48, 35.49])),
    known([10.0, 20.0, 1.4], [[29.04, 28.90], [20.97, 20.92]], None),
    known([2.0, 10.0, 1.4], [[0.00, -0.02], [-0.05, -0.06]], Some([39.16, 39.19])),
    known([5.0, 20.0, 1.3], [[8.93, 8.90], [6.66, 6.59]], Some([28.55, 28.54])),
];

/// What is known of a variant's corner, and which of the extrapolations it is.
fn of(variant: &Variant) -> Option<(&'static Known, usize)> {
    let corner = &variant.own;
    let key = [corner.mach, corner.angle, corner.gamma];
    let known = KNOWN.iter().find(|known| known.corner == key)?;
    Some((known, usize::from(variant.scheme.extrapolation == "wm")))
}

/// The angle that the publication lists for this corner, degrees.
pub fn angle(variant: &Variant) -> Option<f64> {
    let (known, which) = of(variant)?;
    Some(known.angle?[which])
}

/// The rows of the published scheme beside itself.
pub fn rows(variant: &Variant, found: &Measured, shock: &ObliqueShock) -> Vec<Row> {
    let Some((known, which)) = of(variant) else {
        return Vec::new();
    };
    let off = |theory: f64, per_cent: f64| theory * per_cent / 100.0;
    let near = |quantity: &str, measured: f64, theory: f64, per_cent: f64| {
        let expected = theory + off(theory, per_cent);
        Row::absolute(quantity, PLATEAUS, measured, expected, off(theory, PLATEAU)).always()
    };
    let pressure = shock.pressure_ratio / variant.own.gamma;
    let mut rows = vec![
        near(
            "plateau density, as ever",
            found.plateau.density,
            shock.density_ratio,
            known.density[which],
        ),
        near(
            "plateau pressure, as ever",
            found.plateau.pressure,
            pressure,
            known.pressure[which],
        ),
    ];
    if let Some(angle) = known.angle {
        let theory = shock.angle.to_degrees();
        let (measured, allowed) = (found.steepest.to_degrees(), off(theory, ANGLE));
        let quantity = "shock angle by eq. (36), as published, deg";
        rows.push(Row::absolute(quantity, ANGLES, measured, angle[which], allowed).always());
    }
    rows
}
