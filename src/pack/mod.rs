//! Packs bodies for their own sake: a file of triangles, or all bodies of a scene. Writes and prints nothing.

mod report;
mod spacing;

pub use report::{BodyReport, PackFile};

use std::path::Path;

use aero_geometry::{Bounds, files};
use aero_packer::{About, PackOptions, Packing, Warning, thinnest_part};

use crate::scene::shapes::{StlEntry, Unit, made};
use crate::scene::{PackWishes, Scene, SceneError};
use aero_solver::layers;

/// A body longer than this, in metres, whose unit nobody has named is rather one in millimetres.
const LARGE: f64 = 10.0;

/// A body smaller than this, in metres, was rather not in the unit that was named.
const SMALL: f64 = 2e-3;

/// Packed bodies in `D` dimensions, and the name that their files carry.
#[derive(Clone, Debug)]
pub struct Packed<const D: usize> {
    /// Name of the body's file or the scene, without its ending.
    pub name: String,
    /// Where the spacing comes from.
    pub spacing_reason: String,
    /// Name and packing of each body.
    pub bodies: Vec<(String, Packing<D>)>,
}

/// Packed bodies of a plane or of space.
#[derive(Clone, Debug)]
pub enum AnyPacked {
    /// In a plane.
    Two(Packed<2>),
    /// In space.
    Three(Packed<3>),
}

impl AnyPacked {
    /// Name of the body's file or the scene, without its ending.
    pub fn name(&self) -> &str {
        match self {
            Self::Two(packed) => &packed.name,
            Self::Three(packed) => &packed.name,
        }
    }

    /// The report of the bodies, one by one and together.
    pub fn report(&self) -> PackFile {
        match self {
            Self::Two(packed) => PackFile::new(&packed.spacing_reason, &packed.bodies),
            Self::Three(packed) => PackFile::new(&packed.spacing_reason, &packed.bodies),
        }
    }
}

/// Packs the body in a file of triangles.
pub fn pack_mesh(entry: &StlEntry, wishes: &PackWishes) -> Result<AnyPacked, SceneError> {
    let name = files::body_name(&entry.file);
    let fail = |message: String| SceneError::body(&name, message);
    let soup = entry.read(Path::new(""), &wishes.watch);
    let soup = soup.map_err(|error| fail(error.to_string()))?;
    let layers = wishes.layers.unwrap_or(layers::GHOSTS);
    let spaced = |bounds: &Bounds<3>, thin: &dyn Fn() -> Option<f64>| match wishes.spacing {
        Some(spacing) => (spacing, "as asked for".to_owned()),
        None => spacing::pick(bounds, thin(), layers),
    };
    // A wrap follows the spacing, all else goes before it.
    let rough = if entry.wraps() {
        spaced(&files::bounds(&soup), &|| None).0
    } else {
        0.0
    };
    let solid = entry.solid(soup, rough, &wishes.watch).map_err(fail)?;
    let made = made(solid, None).map_err(fail)?;
    let bounds = made.shape.bounds();
    let thin = || thinnest_part(made.shape.as_ref(), &bounds);
    let (mut spacing, spacing_reason) = spaced(&bounds, &thin);
    if entry.wraps() {
        spacing = rough;
    }
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
        .extend(odd_size(bounds.size().max(), entry.unit));
    Ok(AnyPacked::Three(Packed {
        name: name.clone(),
        spacing_reason,
        bodies: vec![(name, packing)],
    }))
}

/// A question for whoever named no unit for a house, or one for a grain of sand.
fn odd_size(size: f64, unit: Option<Unit>) -> Option<Warning> {
    let text = match unit {
        None if size > LARGE => {
            format!(
                "the body is {size:.0} m long: if its file is in millimetres or inches, say `--unit mm` or `--unit in`"
            )
        }
        Some(Unit::Mm | Unit::In) if size < SMALL => {
            format!("the body is {size:.1e} m long: if its file is in metres, leave out `--unit`")
        }
        _ => return None,
    };
    Some(Warning::new(About::Unit, text))
}

/// Packs all bodies of a scene.
///
/// # Errors
/// A scene without bodies, and a body that cannot be packed.
pub fn pack_scene(scene: &Scene, wishes: &PackWishes) -> Result<AnyPacked, SceneError> {
    match scene.dimension() {
        2 => bodies(scene, wishes).map(AnyPacked::Two),
        3 => bodies(scene, wishes).map(AnyPacked::Three),
        _ => Err(SceneError::value(
            "dimension",
            "is 1, where there are no bodies to pack",
        )),
    }
}

fn bodies<const D: usize>(scene: &Scene, wishes: &PackWishes) -> Result<Packed<D>, SceneError> {
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
