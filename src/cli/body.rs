//! What commands that fly a body from its file share: how it lies, the air, what coefficients refer to.

use std::path::Path;

use aero::fly::{Air, Axes, Centre, Wishes};
use aero::scene::number::{Altitude, StreamAngle};
use clap::Args;

use super::mesh::MeshArgs;
use super::numbers::positive;

/// A body in a stream, but for its speed.
#[derive(Args, Clone, Debug, Default, PartialEq)]
pub struct BodyArgs {
    #[command(flatten)]
    mesh: MeshArgs,
    /// Turn of the body about its length, degrees; none unless given
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, value_parser = angle)]
    roll: Option<f64>,
    /// Height in the standard atmosphere: 12km, 12000 or 40kft; sea level unless given
    #[arg(long, value_name = "H", allow_hyphen_values = true, value_parser = height, conflicts_with_all = ["pressure", "temperature"])]
    altitude: Option<f64>,
    /// Pressure of the stream, Pa, with a temperature
    #[arg(long, value_name = "PA", requires = "temperature", value_parser = positive)]
    pressure: Option<f64>,
    /// Temperature of the stream, K, with a pressure
    #[arg(long, value_name = "K", requires = "pressure", value_parser = positive)]
    temperature: Option<f64>,
    /// Directions of the file out of the nose and up, such as -x,+z; as the body looks unless given
    #[arg(long, value_name = "NOSE[,UP]", allow_hyphen_values = true)]
    axis: Option<Axes>,
    /// Reference area, m2; the frontal area unless given
    #[arg(long, value_name = "M2", value_parser = positive)]
    area: Option<f64>,
    /// Reference length, m; the body's length unless given
    #[arg(long, value_name = "M", value_parser = positive)]
    length: Option<f64>,
    /// Point of the moments, m behind the nose, above the middle of the body's box and to the left of it; half the length and the middle of the volume
    /// unless given
    #[arg(long, value_name = "X[,Y,Z]", allow_hyphen_values = true)]
    centre: Option<Centre>,
    /// Time that it may take; 10 unless this or a spacing is given
    #[arg(long, value_name = "N", value_parser = positive)]
    pub minutes: Option<f64>,
    /// The finest spacing, m, near body and shocks: the same results on any machine
    #[arg(long, value_name = "M", value_parser = positive)]
    pub spacing: Option<f64>,
}

impl BodyArgs {
    /// The flight of `body` at a Mach number, an incidence and a sideslip.
    pub fn wishes(&self, body: &Path, [mach, incidence, sideslip]: [f64; 3]) -> Wishes {
        Wishes {
            body: self.mesh.entry(body),
            axes: self.axis,
            roll: self.roll.unwrap_or(0.0),
            mach,
            incidence,
            sideslip,
            air: match (self.pressure, self.temperature) {
                (Some(pressure), Some(temperature)) => Air::State(pressure, temperature),
                _ => Air::Altitude(self.altitude.unwrap_or(0.0)),
            },
            with_the_gas: false,
            area: self.area,
            length: self.length,
            centre: self.centre,
        }
    }
}

/// An angle in degrees.
pub fn angle(text: &str) -> Result<f64, String> {
    let angle: f64 = text.parse().map_err(|_| "is no number of degrees")?;
    if angle.abs() <= 360.0 {
        Ok(angle)
    } else {
        Err("is no angle in degrees, which is -360 to 360".into())
    }
}

/// An angle of the stream, in degrees.
pub fn stream_angle(text: &str) -> Result<f64, String> {
    let angle: f64 = text.parse().map_err(|_| "is no number of degrees")?;
    StreamAngle::try_from(angle).map(StreamAngle::get)
}

/// A Mach number.
pub fn mach(text: &str) -> Result<f64, String> {
    positive(text).map_err(|_| "is no Mach number, which is above zero".into())
}

/// True of a file of triangles.
pub fn is_body(path: &Path) -> bool {
    let name = path.to_string_lossy().to_lowercase();
    let name = name.strip_suffix(".gz").unwrap_or(&name);
    [".stl", ".obj", ".ply"]
        .iter()
        .any(|end| name.ends_with(end))
}

/// A height in m, typed in m, km or thousands of feet.
fn height(text: &str) -> Result<f64, String> {
    let units = [
        ("kft", 304.8),
        ("km", 1e3),
        ("ft", 0.3048),
        ("m", 1.0),
        ("", 1.0),
    ];
    let read = units.into_iter().find_map(|(unit, metres)| {
        let number = text.trim().strip_suffix(unit)?.trim();
        Some(number.parse::<f64>().ok()? * metres)
    });
    let height = read.ok_or("is no height; write 12km, 12000 or 40kft")?;
    Altitude::try_from(height).map(Altitude::get)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_read_in_the_units_of_aviation() {
        for (text, metres) in [
            ("12km", 12e3),
            ("12000", 12e3),
            ("12000m", 12e3),
            ("40kft", 12_192.0),
            ("1000 ft", 304.8),
        ] {
            assert!((height(text).unwrap() - metres).abs() < 1e-9, "{text}");
        }
        for (text, words) in [("high", "no height"), ("nan", "86000"), ("300km", "86000")] {
            let refused = height(text).unwrap_err();
            assert!(refused.contains(words), "{refused}");
        }
    }

    #[test]
    fn what_no_stream_has_is_refused() {
        assert_eq!(stream_angle("-5"), Ok(-5.0));
        for text in ["100", "-90", "nan", "up"] {
            assert!(
                stream_angle(text).unwrap_err().contains("degrees"),
                "{text}"
            );
        }
        for text in ["-2", "0", "nan", "inf"] {
            assert!(mach(text).is_err(), "{text}");
        }
    }

    #[test]
    fn bodies_are_known_by_their_names() {
        for name in ["a.stl", "b.STL.gz", "c/d.obj", "e.ply"] {
            assert!(is_body(Path::new(name)), "{name}");
        }
        assert!(!is_body(Path::new("stl.toml")));
    }
}
