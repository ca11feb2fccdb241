//! From the file's `[[body]]` entries to packed bodies.

use std::path::Path;

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::{Bounds, MirrorPlane, Vector, Watch};
use aero_packer::{PackOptions, Packing};

use super::axis;
use super::budget;
use super::cover::check_covered_sides;
use super::domain::{BUFFER, ghost_region, number};
use super::error::SceneError;
use super::file::{BodyEntry, SceneFile};
use super::mirror;
use super::motion::motion;
use super::number::Positive;
use super::packed;
use super::reference::{frontal_area, modelled_part};
use super::shapes::{Made, Making};
use super::surface;
use super::vector::vector;
use aero_solver::layers::GHOSTS;
use aero_solver::method::Method;
use aero_solver::problem::{AXES, Body, Domain, Motion, Side, State};

/// So many times finer than the flow's may a body's own spacing be. The gas feels ghosts through kernels of
/// its own size, so half is usual [Villodi & Ramachandran 2024, section 4.7] and more only serves corners and
/// thin parts; but layers as deep as the flow's need this many more ghosts to the power of the dimension.
const FINEST: f64 = 8.0;

/// So many times coarser: up to a smoothing length apart ghosts act as a wall, at two spacings gas leaks.
const COARSEST: f64 = SMOOTHING_RATIO;

/// How to pack the bodies of a scene.
#[derive(Clone, Debug, Default)]
pub struct PackWishes {
    /// Spacing in place of those in the scene.
    pub spacing: Option<f64>,
    /// Number of ghost layers; as many as cover the kernel's support unless given.
    pub layers: Option<usize>,
    /// Number of conforming fluid layers.
    pub fluid_layers: usize,
    /// Pack bodies all the same that lose more than two per cent of their surface.
    pub allow_loss: bool,
    /// Told how far the packing is.
    pub watch: Watch,
}
/// A body before it is packed.
#[derive(Clone, Debug)]
pub struct BodyPlan<const D: usize> {
    /// Its entry in the scene.
    entry: BodyEntry,
    made: Made<D>,
    options: PackOptions<D>,
}

/// All bodies of a scene, checked against its domain.
pub(super) fn plans<const D: usize>(
    file: &SceneFile,
    domain: &Domain<D>,
    folder: &Path,
    wishes: &PackWishes,
) -> Result<Vec<BodyPlan<D>>, SceneError> {
    let entries = &file.body;
    for (number, entry) in entries.iter().enumerate() {
        if entries[..number]
            .iter()
            .any(|other| other.name == entry.name)
        {
            return Err(SceneError::body(
                entry.name.as_str(),
                "another body has this name already; names are unique, so rename one",
            ));
        }
    }
    let plans = entries
        .iter()
        .map(|entry| {
            let name = entry.name.as_str();
            if D == 1 {
                return Err(SceneError::body(
                    name,
                    "a scene of dimension 1 holds no bodies; close its ends with walls, or set dimension = 2",
                ));
            }
            check_spacing(entry, file, wishes)?;
            let own = entry.spacing.unwrap_or(file.spacing).get();
            // Whatever it turns about.
            let motion = motion(name, entry.motion.as_ref(), Vector::zeros())?;
            let making = Making {
                folder,
                mirrors: mirrors(domain, &motion),
                axisymmetric: domain.is_axisymmetric(),
                spacing: wishes.spacing.unwrap_or(own),
                watch: &wishes.watch,
            };
            let made = entry
                .shape
                .make::<D>(entry.place.as_ref(), &making)
                .map_err(|message| SceneError::body(name, message))?;
            check_inside(name, &made.shape.bounds(), domain)?;
            mirror::check_motion(name, domain, &made.shape.bounds(), &motion)?;
            Ok(BodyPlan {
                entry: entry.clone(),
                made,
                options: options(entry, file, domain, wishes),
            })
        })
        .collect::<Result<Vec<_>, _>>()?;
    let surfaces: Vec<_> = plans.iter().map(|plan| plan.made.shape.as_ref()).collect();
    check_covered_sides(domain, &surfaces, file.spacing.get())?;
    Ok(plans)
}

/// The mirrors at the sides of a domain that what moves like this goes along.
fn mirrors<const D: usize>(domain: &Domain<D>, motion: &Motion<D>) -> Vec<MirrorPlane> {
    let sides = domain.each_side();
    let sides = sides.filter(|(axis, _, side, _)| *side == Side::Symmetry && motion.keeps(*axis));
    let planes = sides.map(|(axis, end, _, position)| MirrorPlane {
        axis,
        position,
        shows_above: end == 0,
    });
    planes.collect()
}

fn options<const D: usize>(
    entry: &BodyEntry,
    file: &SceneFile,
    domain: &Domain<D>,
    wishes: &PackWishes,
) -> PackOptions<D> {
    let own = entry.spacing.unwrap_or(file.spacing).get();
    let spacing = wishes.spacing.unwrap_or(own);
    let layers = wishes
        .layers
        .unwrap_or_else(|| covering_layers(spacing, file.spacing.get()));
    let depth = (layers as f64 + 1.0) * spacing;
    let margin = depth.max(BUFFER * spacing.max(file.spacing.get()));
    PackOptions {
        layers,
        fluid_layers: if entry.packed_fluid == Some(true) {
            wishes.fluid_layers.max(packed::LAYERS)
        } else {
            wishes.fluid_layers
        },
        allow_loss: wishes.allow_loss || entry.allow_loss == Some(true),
        region: Some(ghost_region(domain, margin)),
        mirrors: domain.sides.map(|ends| ends.map(Side::is_mirror)),
        anchor: domain.bounds.min,
        watch: wishes.watch.clone(),
        ..PackOptions::new(spacing)
    }
}

/// Number of layers at `spacing` that are as deep as [`GHOSTS`] of the flow's.
fn covering_layers(spacing: f64, flow: f64) -> usize {
    let finer = (flow / spacing).max(1.0);
    // Ratios such as 0.3 / 0.1 are whole numbers but for round-off.
    (GHOSTS as f64 * finer - 1e-6).ceil() as usize
}

/// Ghosts must close the wall for particles as large as the flow's, without many layers that none of them
/// feels; packed fluid is part of the flow, whose particles are all of one size.
fn check_spacing(
    entry: &BodyEntry,
    file: &SceneFile,
    wishes: &PackWishes,
) -> Result<(), SceneError> {
    let name = entry.name.as_str();
    let flow = file.spacing.get();
    let own = entry.spacing.unwrap_or(file.spacing).get();
    let wrong = |message| Err(SceneError::value(format!("body.{name}.spacing"), message));
    if own > COARSEST * flow {
        return wrong(format!(
            "is {}, {} times as coarse as the scene's {}: gas would leak between the ghosts; set at \
             most {} or leave it out",
            number(own),
            number(own / flow),
            number(flow),
            number(COARSEST * flow),
        ));
    }
    // Whoever says how many layers there are knows their number.
    let packed = wishes.spacing.unwrap_or(own);
    if packed * FINEST * (1.0 + 1e-9) < flow && wishes.layers.is_none() {
        return wrong(format!(
            "is {}, {} times as fine as the scene's {}, and {} layers of ghosts would lie where the \
             gas feels {GHOSTS}; set at least {}, or refine the scene's as well",
            number(packed),
            number(flow / packed),
            number(flow),
            covering_layers(packed, flow),
            number(flow / FINEST),
        ));
    }
    if entry.packed_fluid != Some(true) || own == flow {
        return Ok(());
    }
    Err(SceneError::body(
        name,
        format!(
            "packed_fluid goes with the scene's own spacing, {flow}, but the body's is {own}; leave one \
             of the two out"
        ),
    ))
}

fn check_inside<const D: usize>(
    name: &str,
    bounds: &Bounds<D>,
    domain: &Domain<D>,
) -> Result<(), SceneError> {
    if !bounds.intersection(&domain.bounds).is_empty() {
        return Ok(());
    }
    Err(SceneError::body(
        name,
        format!(
            "lies outside the domain: it spans {}, the domain {}; move it with place.translate",
            span(bounds),
            span(&domain.bounds)
        ),
    ))
}

impl<const D: usize> BodyPlan<D> {
    /// Name of the body.
    pub fn name(&self) -> &str {
        self.entry.name.as_str()
    }

    /// Packs the body; the report tells of its mesh too.
    pub fn pack(&self) -> Result<Packing<D>, SceneError> {
        let bounds = self.made.shape.bounds();
        let bounds = match &self.options.region {
            Some(region) => bounds.intersection(region),
            None => bounds,
        };
        let PackOptions {
            spacing, layers, ..
        } = self.options;
        let place = format!("body.{}.spacing", self.name());
        budget::check_ghosts(&bounds, spacing, layers, &place)?;
        self.made
            .pack(&self.options)
            .map_err(|message| SceneError::body(self.name(), message))
    }

    /// The body of the case, packed.
    pub(super) fn body(
        self,
        domain: &Domain<D>,
        free_stream: &State<D>,
        method: Method,
    ) -> Result<Body<D>, SceneError> {
        // Points that stay ask the shape itself: nobody feels ghosts.
        let packing = match method {
            Method::WithTheGas => self.pack()?,
            Method::Fixed(_) => Packing::default(),
        };
        let entry = &self.entry;
        let name = self.name();
        let part = modelled_part(&self.made.shape.bounds(), domain);
        let size = part.size();
        let moment_centre = match &entry.moment_centre {
            Some(point) => vector(&format!("body.{name}.moment_centre"), point)?,
            None => (part.min + part.max) / 2.0,
        };
        let motion = motion(name, entry.motion.as_ref(), moment_centre)?;
        axis::check_motion(name, domain, &motion)?;
        let area = entry.reference_area.map(Positive::get);
        let length = entry.reference_length.map(Positive::get);
        Ok(Body {
            name: name.to_owned(),
            shape: self.made.shape.clone(),
            wall: surface::of_body(name, entry.wall.as_ref(), &moment_centre)?,
            motion,
            packed_fluid: packed::fluid(&packing),
            ghosts: packing.ghosts,
            report: packing.report,
            reference_area: area.unwrap_or_else(|| {
                frontal_area(
                    self.made.shape.as_ref(),
                    &part,
                    &free_stream.velocity,
                    domain,
                )
            }),
            reference_length: length.unwrap_or_else(|| size.max()),
            moment_centre,
        })
    }
}

/// A box, for people: `-1 to 3 in x, 0 to 3 in y`.
fn span<const D: usize>(bounds: &Bounds<D>) -> String {
    (0..D)
        .map(|k| format!("{} to {} in {}", bounds.min[k], bounds.max[k], AXES[k]))
        .collect::<Vec<_>>()
        .join(", ")
}
