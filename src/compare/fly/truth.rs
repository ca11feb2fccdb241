//! What is known of twelve bodies.

use aero_validation::exact::cone::cone_flow;
use aero_validation::exact::oblique::{Strength, oblique_shock};
use aero_validation::exact::prandtl_meyer::expand;

use super::bodies::{self, Facet};
use crate::context::CompareError;

const GAMMA: f64 = 1.4;

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// Drag of the forebody.
    Forebody,
    /// Lift.
    Lift,
    /// Force across the body.
    Normal,
}

impl Quantity {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Forebody => "drag of the forebody",
            Self::Lift => "lift",
            Self::Normal => "normal force",
        }
    }
}

/// How a body's answer is known.
#[derive(Clone, Copy, Debug)]
enum How {
    /// Taylor and Maccoll, the half angle in degrees.
    Cone(f64),
    /// A wedge between its tips, the half angle in degrees.
    Wedge(f64),
    /// A diamond, its thickness over the chord.
    Diamond(f64),
    /// A number.
    Number(f64),
}

/// A body of which something is known.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// Body and stream.
    pub label: &'static str,
    /// Stem of its file.
    pub file: &'static str,
    /// Its facets.
    pub body: fn() -> Vec<Facet>,
    /// Mach number.
    pub mach: f64,
    /// Degrees.
    pub incidence: f64,
    /// What is compared.
    pub quantity: Quantity,
    /// Where the answer comes from.
    pub source: &'static str,
    how: How,
}

const TAYLOR: &str = "Taylor & Maccoll 1933";
const CONICAL: &str =
    "finite volumes in conical coordinates (validation/examples/inclined_cone.rs)";
const FINER: &str = "rings four times finer";

/// The bodies, the cheapest first.
pub const TWELVE: [Known; 12] = [
    Known {
        label: "cone 10 deg, M 2",
        file: "cone10",
        body: || bodies::cone(10.0),
        mach: 2.0,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: TAYLOR,
        how: How::Cone(10.0),
    },
    Known {
        label: "cone 15 deg, M 3",
        file: "cone15",
        body: || bodies::cone(15.0),
        mach: 3.0,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: TAYLOR,
        how: How::Cone(15.0),
    },
    Known {
        label: "sphere, M 2",
        file: "sphere",
        body: bodies::sphere,
        mach: 2.0,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: FINER,
        how: How::Number(SPHERE2),
    },
    Known {
        label: "sphere, M 3",
        file: "sphere",
        body: bodies::sphere,
        mach: 3.0,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: FINER,
        how: How::Number(SPHERE3),
    },
    Known {
        label: "tangent ogive, M 2",
        file: "ogive",
        body: bodies::ogive,
        mach: 2.0,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: FINER,
        how: How::Number(OGIVE),
    },
    Known {
        label: "Apollo, M 2.5",
        file: "apollo",
        body: bodies::apollo,
        mach: 2.5,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: FINER,
        how: How::Number(1.329),
    },
    Known {
        label: "cone 10 deg, M 2, 5 deg",
        file: "cone10",
        body: || bodies::cone(10.0),
        mach: 2.0,
        incidence: 5.0,
        quantity: Quantity::Normal,
        source: CONICAL,
        how: How::Number(CONE10),
    },
    Known {
        label: "cone 15 deg, M 3, 5 deg",
        file: "cone15",
        body: || bodies::cone(15.0),
        mach: 3.0,
        incidence: 5.0,
        quantity: Quantity::Normal,
        source: CONICAL,
        how: How::Number(CONE15),
    },
    Known {
        label: "wedge 10 deg, M 2.5",
        file: "wedge",
        body: bodies::wedge,
        mach: 2.5,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: "oblique shock, tips by linear theory behind it",
        how: How::Wedge(10.0),
    },
    Known {
        label: "diamond wing, M 2",
        file: "diamond",
        body: bodies::diamond,
        mach: 2.0,
        incidence: 0.0,
        quantity: Quantity::Forebody,
        source: "shock and expansion; tips cost nothing in linear theory",
        how: How::Diamond(0.1),
    },
    Known {
        label: "biconvex wing, M 2, 4 deg",
        file: "biconvex",
        body: bodies::biconvex,
        mach: 2.0,
        incidence: 4.0,
        quantity: Quantity::Lift,
        source: "shock and expansion, tips by linear theory",
        how: How::Number(1.559),
    },
    Known {
        label: "plate, M 2, 4 deg",
        file: "plate",
        body: bodies::plate,
        mach: 2.0,
        incidence: 4.0,
        quantity: Quantity::Lift,
        source: "plane run at chord / 800, tips by linear theory",
        how: How::Number(4.506),
    },
];

/// Drag of the forebody, on the frontal area, from rings at a sphere's diameter / 333 and / 561 with two halvings more, and an ogive's / 333.
const SPHERE2: f64 = 0.8396;
const SPHERE3: f64 = 0.8708;
const OGIVE: f64 = 0.0986;

/// Normal force at five degrees on the area of the base, of flow that is the same along rays: 30, 60 and 120 cells have 0.16155, 0.16083 and 0.16082,
/// and 0.15422, 0.15447 and 0.15456. To first order in the incidence (Stone 1948) they are 0.1587 and 0.1540.
const CONE10: f64 = 0.1608;
const CONE15: f64 = 0.1546;

/// Span over chord of the wedge.
const ASPECT: f64 = 4.0;

impl Known {
    /// The answer.
    pub fn truth(&self) -> Result<f64, CompareError> {
        Ok(match self.how {
            How::Number(number) => number,
            How::Cone(degrees) => {
                cone_flow(self.mach, degrees.to_radians(), GAMMA)?.pressure_coefficient
            }
            How::Wedge(degrees) => {
                let shock = oblique_shock(self.mach, degrees.to_radians(), GAMMA, Strength::Weak)?;
                let plane = coefficient(shock.pressure_ratio, self.mach);
                // From the Mach line of each tip to the tip the gauge pressure falls to half: the mean of what is lacking is 1 / pi
                // of a triangle half as large as chord by chord over beta.
                let beta = (shock.mach * shock.mach - 1.0).sqrt();
                plane * (1.0 - 1.0 / (std::f64::consts::PI * beta * ASPECT))
            }
            How::Diamond(thickness) => {
                let slope = thickness.atan();
                let shock = oblique_shock(self.mach, slope, GAMMA, Strength::Weak)?;
                let fan = expand(shock.mach, 2.0 * slope, GAMMA)?;
                let behind = shock.pressure_ratio * fan.pressure_ratio;
                // Each half of the chord faces the stream with half the thickness on either side.
                coefficient(shock.pressure_ratio, self.mach) - coefficient(behind, self.mach)
            }
        })
    }
}

/// Pressure coefficient of a pressure over the stream's.
fn coefficient(ratio: f64, mach: f64) -> f64 {
    2.0 * (ratio - 1.0) / (GAMMA * mach * mach)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_agrees_with_thin_bodies_in_linear_theory() {
        let of = |label: &str| {
            let known = TWELVE.iter().find(|known| known.label.starts_with(label));
            known.expect(label).truth().expect("an attached shock")
        };
        // 4 t / beta on the frontal area.
        assert!((of("diamond") / (0.4 / 3_f64.sqrt()) - 1.0).abs() < 0.01);
        assert!((of("cone 10 deg") - 0.1044).abs() < 2e-4);
        assert!((of("wedge") - 0.1889).abs() < 2e-4);
        // 4 a / beta times what tips of aspect 4 leave, over a tenth.
        let linear = 4.0 * 4_f64.to_radians() / 3_f64.sqrt();
        let left = 1.0 - 1.0 / (2.0 * ASPECT * 3_f64.sqrt());
        assert!((of("biconvex") / (10.0 * linear * left) - 1.0).abs() < 0.05);
    }
}
