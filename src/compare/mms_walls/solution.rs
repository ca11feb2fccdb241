//! The manufactured solutions: those of Negi & Ramachandran 2022, appendix A, and ours, which have a gradient of the pressure, a shear and
//! a divergence at the wall.

use aero_geometry::Vector;
use num_dual::{Dual2_64, DualNum};

use super::arrangement::Form;

/// Pressure and velocity.
type Values = [Dual2_64; 3];

/// A solution, `exp(-decay t)` times a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    pub family: Family,
    pub condition: Condition,
    pub form: Form,
}

/// Whose solution it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Of the paper, equations A1 to A7.
    Published,
    /// Ours, where mistakes have no place to hide.
    Sheared,
}

/// What holds at the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// The pressure's gradient along the normal is known.
    Neumann,
    /// The velocity along the normal is the wall's.
    Slip,
    /// The velocity is the wall's.
    NoSlip,
}

impl Condition {
    pub const ALL: [Self; 3] = [Self::Neumann, Self::Slip, Self::NoSlip];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Neumann => "Neumann",
            Self::Slip => "slip",
            Self::NoSlip => "no-slip",
        }
    }
}

/// The field and its derivatives at a place, at the time zero.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// Pressure and velocity.
    pub value: [f64; 3],
    /// Their gradients.
    pub gradient: [[f64; 2]; 3],
    /// Their Laplacians.
    pub laplacian: [f64; 3],
}

impl Solution {
    /// Rate of decay, 1/s: what has shear at a wall decays, as in the paper.
    pub fn decay(self) -> f64 {
        if self.condition == Condition::NoSlip {
            10.0
        } else {
            0.0
        }
    }

    /// The field at `place` at the time zero.
    pub fn at(self, place: &Vector<2>) -> Exact {
        let along = |axis: usize| {
            let number = |k: usize| {
                let number = Dual2_64::from_re(place[k]);
                if k == axis {
                    number.derivative()
                } else {
                    number
                }
            };
            self.values(number(0), number(1))
        };
        let (x, y) = (along(0), along(1));
        Exact {
            value: x.map(|v| v.re),
            gradient: std::array::from_fn(|k| [x[k].v1, y[k].v1]),
            laplacian: std::array::from_fn(|k| x[k].v2 + y[k].v2),
        }
    }

    fn values(self, x: Dual2_64, y: Dual2_64) -> Values {
        match (self.family, self.form) {
            (Family::Sheared, form) => sheared(self.condition, form, x, y),
            (Family::Published, Form::Straight) => straight(self.condition, x, y),
            (Family::Published, form) => round(self.condition, form.radius(), x, y),
        }
    }
}

const PI: f64 = std::f64::consts::PI;

/// Equations A1, A3, A5, for a wall at y = 1.
fn straight(condition: Condition, x: Dual2_64, y: Dual2_64) -> Values {
    let s = y - 1.0;
    let (sin_x, cos_x) = (x * (2.0 * PI)).sin_cos();
    let (sin_y, cos_y) = (y * (2.0 * PI)).sin_cos();
    match condition {
        Condition::Neumann => [
            x * x + (x * (4.0 * PI)).cos(),
            s * sin_x * cos_y,
            -s * sin_y * cos_x,
        ],
        Condition::Slip => [waves(x, y), s * sin_x * cos_y + 1.0, s * s * sin_y],
        Condition::NoSlip => [waves(x, y), s * s * sin_x * cos_y, -s * s * sin_y * cos_x],
    }
}

/// Equations A2, A4, A6, A7, for walls about (1/2, 1/2).
fn round(condition: Condition, radius: f64, x: Dual2_64, y: Dual2_64) -> Values {
    let (a, b) = (x - 0.5, y - 0.5);
    let square = a * a + b * b;
    let (sin_x, cos_y) = ((x * (2.0 * PI)).sin(), (y * (2.0 * PI)).cos());
    match condition {
        Condition::Neumann => [
            angle(b * b, a * a),
            (y - 1.0) * sin_x * cos_y,
            -(y - 1.0) * (y * (2.0 * PI)).sin() * (x * (2.0 * PI)).cos(),
        ],
        Condition::Slip => [waves(x, y), b * sin_x * cos_y, -a * sin_x * cos_y],
        Condition::NoSlip => {
            let (sin, cos) = (square * (2.0 * PI)).sin_cos();
            let rise = -square + radius * radius;
            [waves(x, y), rise * sin, rise * cos]
        }
    }
}

/// `atan(b / a)` of numbers that are not negative, where `a` may be zero.
fn angle(b: Dual2_64, a: Dual2_64) -> Dual2_64 {
    if b.re < a.re {
        (b / a).atan()
    } else {
        -(a / b).atan() + 0.5 * PI
    }
}

fn waves(x: Dual2_64, y: Dual2_64) -> Dual2_64 {
    (x * (4.0 * PI)).cos() + (y * (4.0 * PI)).cos()
}

/// Speed of the wall along itself, m/s; round ones turn.
const WALL: f64 = 0.5;
/// Size of the stream function that shears, m^2/s.
const STREAM: f64 = 0.05;

/// In coordinates along and across the wall, `e` away from it:
/// pressure `C (1 + 2e + 6e^2) + 2e`; without friction velocity `S (1 + 2e + 3e^2) + 1` along and `C e (1 + e)` across; with friction that
/// of the stream function `S (1 - cos 2 pi e)(1 + sin(2 pi e)/2)`, beside the wall's. `C` and `S` are waves along the wall.
fn sheared(condition: Condition, form: Form, x: Dual2_64, y: Dual2_64) -> Values {
    let (a, b) = (x - 0.5, y - 0.5);
    let radius = (a * a + b * b).sqrt();
    let (e, normal) = match form {
        Form::Straight => (-y + 1.0, [Dual2_64::from(0.0), -Dual2_64::from(1.0)]),
        Form::Convex => (radius - form.radius(), [a / radius, b / radius]),
        Form::Concave => (-radius + form.radius(), [-a / radius, -b / radius]),
    };
    let (sin, cos) = if form == Form::Straight {
        (x * (2.0 * PI)).sin_cos()
    } else {
        let square = radius * radius;
        (a * b * 2.0 / square, (a * a - b * b) / square)
    };
    let pressure = cos * (e * 2.0 + e * e * 6.0 + 1.0) + e * 2.0;
    let (along, across) = if condition == Condition::NoSlip {
        let (sin_e, cos_e) = (e * (2.0 * PI)).sin_cos();
        let (rise, wavy) = (-cos_e + 1.0, sin_e * 0.5 + 1.0);
        let slope = (sin_e * wavy * 2.0 + rise * cos_e) * PI;
        let (wall, wave) = match form {
            Form::Straight => (Dual2_64::from(1.0) * WALL, Dual2_64::from(1.0) * (2.0 * PI)),
            _ => (radius * (WALL / form.radius()), radius.recip() * 2.0),
        };
        (
            sin * slope * STREAM + wall,
            -cos * wave * rise * wavy * STREAM,
        )
    } else {
        (
            sin * (e * 2.0 + e * e * 3.0 + 1.0) + 1.0,
            cos * e * (e + 1.0),
        )
    };
    let [m, n] = normal;
    [pressure, along * n + across * m, -along * m + across * n]
}
