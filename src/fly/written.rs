//! The scene that says how a body is flown.

use std::fmt::Write as _;
use std::path::Path;

use super::domain;
use super::error::FlyError;
use super::flight::{Extent, Flight};
use super::wishes::Air;
use crate::scene::shapes::{StlEntry, Unit};

impl Flight {
    /// The scene at `spacing`, from the flow of an earlier `frame` if one is given.
    ///
    /// # Errors
    /// A body's file that has no absolute path.
    pub fn scene(&self, spacing: f64, frame: Option<&Path>) -> Result<String, FlyError> {
        let mut text = String::new();
        let w = &self.wishes;
        let region = self.region();
        let list = |numbers: &[f64]| format!("{numbers:?}");
        let (min, max) = if self.dimension() == 2 {
            let bounds = domain::whole(&domain::plane(&region), spacing);
            (list(bounds.min.as_slice()), list(bounds.max.as_slice()))
        } else {
            let bounds = domain::whole(&region, spacing);
            (list(bounds.min.as_slice()), list(bounds.max.as_slice()))
        };
        let mut say = |line: &str| {
            text.push_str(line);
            text.push('\n');
        };
        say(&format!("title = \"{} at Mach {}\"", self.name, w.mach));
        say(&format!(
            "dimension = {}\nspacing = {spacing:?}",
            self.dimension()
        ));
        say("stop = \"steady\"\n");
        if !w.with_the_gas {
            say(&format!(
                "[scheme]\nmotion = \"fixed\"\nrefine = {}\n",
                self.refine()
            ));
        }
        say(&format!("[free_stream]\nmach = {:?}", w.mach));
        match w.air {
            Air::Altitude(height) => say(&format!("altitude = {height:?}")),
            Air::State(pressure, temperature) => {
                say(&format!(
                    "pressure = {pressure:?}\ntemperature = {temperature:?}"
                ));
            }
        }
        if self.dimension() == 3 {
            say(&format!(
                "incidence = {:?}\nsideslip = {:?}",
                w.incidence, w.sideslip
            ));
        }
        say(&format!(
            "\n[domain]\nmin = {min}\nmax = {max}\n\n[domain.sides]"
        ));
        say(if self.is_slow() {
            "x_min = \"free-stream\"\nx_max = \"free-stream\""
        } else {
            "x_min = \"inlet\"\nx_max = \"outlet\""
        });
        match &self.extent {
            Extent::Meridian(_) => say("y_min = \"axis\"\ny_max = \"free-stream\""),
            Extent::Space(mirrors) => {
                for (axis, letter) in [(1, "y"), (2, "z")] {
                    let low = if mirrors.contains(&axis) {
                        "symmetry"
                    } else {
                        "free-stream"
                    };
                    say(&format!(
                        "{letter}_min = \"{low}\"\n{letter}_max = \"free-stream\""
                    ));
                }
            }
        }
        if let Some(frame) = frame {
            say(&format!("\n[initial]\nframe = {}", quoted(frame)));
        }
        say(&format!("\n[[body]]\nname = \"{}\"", self.name));
        say(&self.scene_shape()?);
        let [up, left] = self.centre_across();
        let centre = &[self.centre(), up, left][..self.dimension()];
        say(&format!(
            "reference_area = {:?}\nreference_length = {:?}\nmoment_centre = {centre:?}",
            self.area,
            self.reference_length()
        ));
        say("\n[output]\nframes = 1\ncompress = true");
        Ok(text)
    }

    /// The `shape` and `place` of the body.
    fn scene_shape(&self) -> Result<String, FlyError> {
        match &self.extent {
            Extent::Meridian(line) => {
                let mut text = "shape = { polygon = { points = [".to_owned();
                for [x, y] in line.polygon() {
                    // Writing to a string cannot fail.
                    let _ = write!(text, "[{x:?}, {y:?}], ");
                }
                text.push_str("] } }");
                Ok(text)
            }
            Extent::Space(_) => {
                let file = std::path::absolute(&self.wishes.body.file)
                    .map_err(|error| FlyError::Body(error.to_string()))?;
                Ok(format!(
                    "shape = {{ stl = {{ file = {}{} }} }}\nplace = {}",
                    quoted(&file),
                    keys(&self.wishes.body),
                    self.attitude.scene_place()
                ))
            }
        }
    }
}

/// The keys of a body's file beside its path, each after a comma.
fn keys(body: &StlEntry) -> String {
    let unit = body.unit.map(|unit| match unit {
        Unit::M => "unit = \"m\"".to_owned(),
        Unit::Mm => "unit = \"mm\"".into(),
        Unit::In => "unit = \"in\"".into(),
    });
    let half = body.half.map(|way| format!("half = \"{way}\""));
    let fill = body.fill.map(|fill| format!("fill = {fill}"));
    let thicken = body.thicken.map(|t| format!("thicken = {:?}", t.get()));
    let all = [unit, half, fill, thicken].into_iter().flatten();
    all.fold(String::new(), |keys, key| keys + ", " + &key)
}

/// A path as a scene has it.
fn quoted(path: &Path) -> toml::Value {
    toml::Value::String(path.display().to_string())
}
