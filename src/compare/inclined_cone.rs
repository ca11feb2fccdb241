//! Cones at a small incidence, halves of them in space about points that stay: slope of the normal force and centre of pressure.

use std::f64::consts::PI;

use aero::run::Keep;
use aero_validation::exact::cone::cone_flow;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "first order in the incidence (Stone 1948)";
/// A force along the normals of a cone acts here: its moments about the tip are those of rings of equal slope.
const NORMALS: &str = "2 / (3 cos^2 theta), pressure along the generators constant";
const AXIAL: &str =
    "pressure at no incidence (Taylor & Maccoll 1933); an incidence changes it in second order";
const GAMMA: f64 = 1.4;
/// Degrees.
const INCIDENCE: f64 = 2.0;
/// Largest errors: of the slope and, by halvings of the spacing, of the axial force, per cent, and of the centre of pressure, lengths.
const SLOPE: f64 = 3.0;
const AXIAL_FORCE: [f64; 3] = [6.0, 3.0, 1.25];
const CENTRE: f64 = 0.02;

/// A cone and its stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Degrees.
    half_angle: f64,
    mach: f64,
    /// Slope of the normal force's coefficient on the base area, to a radian.
    slope: f64,
    /// How often the spacing is halved.
    halvings: u32,
}

impl Cone {
    const fn new(half_angle: f64, mach: f64, slope: f64) -> Self {
        Self {
            half_angle,
            mach,
            slope,
            halvings: 2,
        }
    }
}

const CONES: [Cone; 4] = [
    Cone::new(10.0, 2.0, 1.819),
    Cone::new(10.0, 3.0, 1.820),
    Cone::new(15.0, 3.0, 1.765),
    Cone::new(20.0, 3.0, 1.686),
];

pub const INCLINED_CONE: Comparison<Cone> = Comparison {
    case: "cone-incidence",
    scene: scene!("cone-incidence"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let coarse = Cone {
            halvings: 1,
            ..CONES[0]
        };
        let mut all = vec![Variant::new(20, coarse).settled().quick()];
        all.extend(CONES.map(|cone| Variant::new(25, cone).settled()));
        all
    },
    label: |v| {
        let Cone {
            half_angle, mach, ..
        } = v.own;
        format!("{half_angle} deg, M {mach}, dx 1/{}", v.cells)
    },
    settings: |v, _| {
        let Cone {
            half_angle,
            mach,
            halvings,
            ..
        } = v.own;
        let base = PI * half_angle.to_radians().tan().powi(2);
        vec![
            format!("body.cone.shape.cone.half_angle={half_angle:?}"),
            format!("body.cone.reference_area={base:?}"),
            format!("free_stream.mach={mach:?}"),
            format!("free_stream.incidence={INCIDENCE:?}"),
            format!("scheme.refine={halvings}"),
        ]
    },
    rows,
    pictures,
    together: None,
};

fn rows(flow: &Flow<'_, Cone>) -> Result<Vec<Row>, CompareError> {
    let cone = flow.variant.own;
    let body = &flow.outcome.summary.bodies["cone"];
    let normal = body.cn_mean.unwrap_or(f64::NAN);
    let about_tip = body.cm_mean.unwrap_or(f64::NAN);
    let axial = body.ca_mean.unwrap_or(f64::NAN);
    let cosine = cone.half_angle.to_radians().cos();
    let exact = cone_flow(cone.mach, cone.half_angle.to_radians(), GAMMA)?;
    Ok(vec![
        Row::relative(
            "slope of the normal force, to a radian",
            THEORY,
            normal / INCIDENCE.to_radians(),
            cone.slope,
            SLOPE,
        ),
        Row::absolute(
            "centre of pressure, lengths from the tip",
            NORMALS,
            -about_tip / normal,
            2.0 / (3.0 * cosine * cosine),
            CENTRE,
        ),
        Row::relative(
            "axial force on the base area",
            AXIAL,
            axial,
            exact.pressure_coefficient,
            AXIAL_FORCE[cone.halvings as usize],
        ),
        flow.no_leaks(),
    ])
}

/// The pressure in the plane of symmetry.
fn pictures(flow: &Flow<'_, Cone>) -> Result<(), CompareError> {
    let pressure = &flow.outcome.gas.pressure;
    let view = flow.view("Cone at an incidence of 2 degrees", pressure, "pressure");
    view.beside_symmetry(flow.spacing).save()
}
