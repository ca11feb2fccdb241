//! Scenes: the file, its overrides, and the case that it means. Reads and checks; runs nothing.
//!
//! [`file::SceneFile`] lists every key, [`shapes::ShapeEntry`] every shape.
//!
//! ```
//! use aero::scene::Scene;
//!
//! let text = r#"
//! dimension = 2
//! spacing = 0.25
//! end_time = 1.0
//!
//! [free_stream]
//! mach = 2.5
//! density = 1.0
//! pressure = 0.7142857142857143
//!
//! [domain]
//! min = [-1.0, 0.0]
//! max = [3.0, 3.0]
//!
//! [domain.sides]
//! x_min = "inlet"
//! x_max = "outlet"
//! y_min = "body"
//! y_max = "free-stream"
//!
//! [[body]]
//! name = "ramp"
//! shape = { compression_corner = { angle = 20.0 } }
//! "#;
//! let mut scene = Scene::parse(text, "ramp", ".".as_ref())?;
//! scene.set("body.ramp.shape.compression_corner.angle=15")?;
//! let case = scene.build::<2>()?;
//! assert_eq!(case.problem.bodies[0].name, "ramp");
//! # Ok::<(), aero::scene::SceneError>(())
//! ```

pub(crate) mod atmosphere;
mod axis;
mod bodies;
mod body_force;
mod budget;
mod build;
mod cover;
mod domain;
mod earlier;
mod error;
mod field;
pub mod file;
mod flow;
pub mod formula;
mod freedom;
mod lines;
pub mod liquid;
pub mod manufactured;
mod method;
mod mirror;
mod motion;
pub mod number;
mod openings;
mod output;
mod overrides;
mod packed;
mod picture;
mod probe;
mod reference;
mod refine;
mod region;
mod schemes;
mod second;
pub mod shapes;
pub mod side;
mod side_tables;
pub mod side_words;
pub(crate) mod silhouette;
pub mod spin;
mod state;
mod stream;
mod surface;
mod transport;
mod two_gases;
mod vector;
mod views;
pub mod viscosity;
pub mod wall;
pub mod way;
mod words;

pub use bodies::{BodyPlan, PackWishes};
pub use error::SceneError;

use std::path::{Path, PathBuf};

use file::SceneFile;
use refine::RefineEntry;

/// A scene: read, with all single values in range, and open to overrides.
#[derive(Clone, Debug)]
pub struct Scene {
    name: String,
    folder: PathBuf,
    text: String,
    file: SceneFile,
}

impl Scene {
    /// Reads the scene at `path`; its name is the file's stem.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = std::fs::read_to_string(path).map_err(|source| SceneError::Read {
            path: path.to_owned(),
            source,
        })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::read(&path.display().to_string(), text, &name, folder)
    }

    /// Reads a scene from memory; relative paths in it start at `folder`.
    pub fn parse(text: &str, name: &str, folder: &Path) -> Result<Self, SceneError> {
        Self::read(name, text.to_owned(), name, folder)
    }

    fn read(origin: &str, text: String, name: &str, folder: &Path) -> Result<Self, SceneError> {
        let text = lines::read(&text).unwrap_or(text);
        let file = toml::from_str(&text).map_err(|source| SceneError::Parse {
            origin: origin.to_owned(),
            source: Box::new(source),
        })?;
        Ok(Self {
            name: name.to_owned(),
            folder: folder.to_owned(),
            text,
            file,
        })
    }

    /// Overrides one value: `section.key=value`. A body is addressed by name or number
    /// (`body.ramp.spacing=0.1`); a value that is not TOML is a bare string.
    ///
    /// # Errors
    /// Leaves the scene as it was if the path or the value makes no sense.
    pub fn set(&mut self, setting: &str) -> Result<(), SceneError> {
        let fail = |message: String| SceneError::Override {
            setting: setting.to_owned(),
            message,
        };
        let text = overrides::apply(&self.text, setting).map_err(fail)?;
        self.file = toml::from_str(&text)
            .map_err(|error: toml::de::Error| fail(error.message().trim_end().to_owned()))?;
        self.text = text;
        Ok(())
    }

    /// Name of the scene.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All values that a run depends on, one per line and in order, whatever the layout of the
    /// file: two scenes with the same lines make the same run.
    pub fn lines(&self) -> String {
        lines::of(&self.text)
    }

    /// The same with whole paths: what can be run from another folder.
    pub fn lines_from_anywhere(&self) -> String {
        lines::from_anywhere(&self.lines(), &self.folder)
    }

    /// True where the scene says nothing of another start than the undisturbed stream.
    pub fn starts_in_the_free_stream(&self) -> bool {
        let initial = &self.file.initial;
        let is_given = initial.riemann.is_some() || initial.field.is_some();
        !is_given && initial.frame.is_none() && self.file.manufactured.is_none()
    }

    /// Mach number, incidence and sideslip of the stream, degrees, where the scene states them.
    pub fn stream(&self) -> [Option<f64>; 3] {
        let Some(stream) = &self.file.free_stream else {
            return [None; 3];
        };
        [
            stream.mach.map(number::NonNegative::get),
            stream.incidence.map(number::StreamAngle::get),
            stream.sideslip.map(number::StreamAngle::get),
        ]
    }

    /// Minutes that points may be added for, where `scheme.refine` gives them.
    pub fn refine_minutes(&self) -> Option<f64> {
        match self.file.scheme.refine {
            Some(RefineEntry::Minutes(minutes)) => Some(minutes),
            _ => None,
        }
    }

    /// Number of space dimensions.
    pub fn dimension(&self) -> usize {
        self.file.dimension.get()
    }

    /// The values.
    pub fn file(&self) -> &SceneFile {
        &self.file
    }
}
