//! Packs bodies for their own sake: an STL file, or all bodies of a scene. Writes what came of it;
//! prints nothing.

mod picture;
mod report;
mod spacing;

pub use report::{BodyReport, PackFile};

use std::path::{Path, PathBuf};

use aero_packer::{About, Ghosts, PackOptions, Packing, Warning, thinnest_part};

use crate::output::{self, OutputError};
use crate::scene::shapes::{ShapeEntry, StlEntry, Unit};
use crate::scene::{LAYERS, PackWishes, Scene, SceneError};

/// A body longer than this, in metres, whose unit nobody has named is rather one in millimetres.
const LARGE: f64 = 10.0;

/// A body smaller than this, in metres, was rather not in the unit that was named.
const SMALL: f64 = 2e-3;

/// Packed bodies and the name that their files carry.
#[derive(Clone, Debug)]
pub struct Packed<const D: usize> {
    /// Name of the STL file or the scene, without its ending.
    pub name: String,
    /// Where the spacing comes from.
    pub spacing_reason: String,
    /// Name and packing of each body.
    pub bodies: Vec<(String, Packing<D>)>,
}

/// Packs the body in an STL file.
pub fn pack_mesh(
    path: &Path,
    unit: Option<Unit>,
    wishes: &PackWishes,
) -> Result<Packed<3>, SceneError> {
    let name = path.file_stem().unwrap_or_default();
    let name = name.to_string_lossy().into_owned();
    let fail = |message: String| SceneError::body(&name, message);
    let entry = ShapeEntry::Stl(StlEntry {
        file: path.to_owned(),
        unit,
    });
    let made = entry
        .make::<3>(None, Path::new(""), false, &wishes.watch)
        .map_err(fail)?;
    let bounds = made.shape.bounds();
    let layers = wishes.layers.unwrap_or(LAYERS);
    let (spacing, spacing_reason) = match wishes.spacing {
        Some(spacing) => (spacing, "as asked for".to_owned()),
        None => {
            let thin = thinnest_part(made.shape.as_ref(), &bounds);
            spacing::pick(&bounds, thin, layers)
        }
    };
    let options = PackOptions {
        layers,
        fluid_layers: wishes.fluid_layers,
        allow_loss: wishes.allow_loss,
        watch: wishes.watch.clone(),
        ..PackOptions::new(spacing)
    };
    let mut packing = made.pack(&options).map_err(fail)?;
    packing
        .report
        .warnings
        .extend(odd_size(bounds.size().max(), unit));
    Ok(Packed {
        name: name.clone(),
        spacing_reason,
        bodies: vec![(name, packing)],
    })
}

/// A question for whoever named no unit for a house, or one for a grain of sand.
fn odd_size(size: f64, unit: Option<Unit>) -> Option<Warning> {
    let text = match unit {
        None if size > LARGE => {
            format!("the body is {size:.0} m long: if its file is in millimetres, say `--unit mm`")
        }
        Some(Unit::Mm | Unit::In) if size < SMALL => {
            format!("the body is {size:.1e} m long: if its file is in metres, leave out `--unit`")
        }
        _ => return None,
    };
    Some(Warning::new(About::Unit, text))
}

/// Packs all bodies of a scene.
pub fn pack_scene<const D: usize>(
    scene: &Scene,
    wishes: &PackWishes,
) -> Result<Packed<D>, SceneError> {
    let plans = scene.body_plans::<D>(wishes)?;
    if plans.is_empty() {
        return Err(SceneError::value(
            "body",
            "the scene has no bodies to pack; add a [[body]]",
        ));
    }
    let bodies = plans
        .iter()
        .map(|plan| Ok((plan.name().to_owned(), plan.pack()?)))
        .collect::<Result<Vec<_>, SceneError>>()?;
    let reason = if wishes.spacing.is_some() {
        "as asked for"
    } else {
        "as the scene says"
    };
    Ok(Packed {
        name: scene.name().to_owned(),
        spacing_reason: reason.to_owned(),
        bodies,
    })
}

impl<const D: usize> Packed<D> {
    /// The report of the bodies, one by one and together.
    pub fn report(&self) -> PackFile {
        PackFile::new(&self.spacing_reason, &self.bodies)
    }

    /// Writes ghosts, conforming fluid if there is any, report and pictures into `folder`; returns
    /// the files.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, OutputError> {
        output::make_folder(folder)?;
        let file = |ending: &str| folder.join(format!("{}-{ending}", self.name));
        let mut files = vec![file("ghosts.vtp")];
        let ghosts: Vec<&Ghosts<D>> = self.bodies.iter().map(|(_, p)| &p.ghosts).collect();
        output::write_ghosts(&files[0], &ghosts)?;
        let fluid: Vec<&Ghosts<D>> = self.bodies.iter().map(|(_, p)| &p.fluid).collect();
        if fluid.iter().any(|fluid| !fluid.position.is_empty()) {
            files.push(file("fluid.vtp"));
            output::write_ghosts(&files[1], &fluid)?;
        }
        files.push(file("pack.json"));
        output::write_json(&files[files.len() - 1], &self.report())?;
        files.extend(picture::draw(&self.bodies, &folder.join(&self.name))?);
        Ok(files)
    }
}
