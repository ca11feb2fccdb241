//! What is flown and how: the body in place, the stream, what of the flow is computed.

use std::f64::consts::PI;
use std::path::Path;
use std::sync::Arc;

use aero_geometry::{Bounds, Placed, Shape, Vector, Watch, files};
use aero_packer::thinnest_part;

use super::attitude::Attitude;
use super::bluntness::bluntness;
use super::centre::axis;
use super::domain;
use super::error::FlyError;
use super::fineness::Fineness;
use super::flat::flat_side;
use super::likeness::{Likeness, likeness};
use super::meridian::Meridian;
use super::wishes::{Air, Wishes};
use crate::scene::atmosphere::GAS_CONSTANT;
use crate::scene::number::Name;
use crate::scene::silhouette::area_along;
use crate::scene::way::Way;

/// Ratio of specific heats of air.
pub(super) const GAMMA: f64 = 1.4;

/// Cells that a captured shock is thick, and as many before it.
const THICK: f64 = 5.0;

/// Cells behind a body before the end of the box: of fewer the outlet feels the body.
const BEHIND: f64 = 2.5;

/// What of the flow is computed.
#[derive(Clone, Debug, PartialEq)]
pub enum Extent {
    /// A plane through the axis of a body of revolution, with its meridian.
    Meridian(Meridian),
    /// Space on one side of the planes of symmetry across these axes.
    Space(Vec<usize>),
}

impl Extent {
    /// Number of dimensions that are computed.
    pub fn dimension(&self) -> usize {
        match self {
            Self::Meridian(_) => 2,
            Self::Space(_) => 3,
        }
    }
}

/// A body on its way through a stream.
#[derive(Clone, Debug)]
pub struct Flight {
    /// What was asked for.
    pub wishes: Wishes,
    /// Name of the body.
    pub name: String,
    /// How it lies.
    pub attitude: Attitude,
    /// The body in place.
    pub shape: Arc<dyn Shape<3>>,
    /// Its box.
    pub bounds: Bounds<3>,
    /// What is computed.
    pub extent: Extent,
    /// Axes across which it is its own mirror image but for so much, m.
    pub nearly: Vec<(usize, f64)>,
    /// Where it ends flat, as a half does where it was cut, if that was not said to be half of it.
    pub flat: Option<Way>,
    /// Where the middle of its volume lies, above the middle of the box and to the left of it.
    axis: [f64; 2],
    /// Its frontal area.
    front: f64,
    /// What coefficients refer to: the same, or what was given.
    pub area: f64,
    /// Its thinnest part, where it has one that is thin.
    pub thinnest: Option<f64>,
    /// What was mended in the file.
    pub repairs: Vec<String>,
    /// Box of the flow.
    region: Bounds<3>,
    /// How finely flow and body are resolved.
    pub(super) fineness: Fineness,
}

impl Flight {
    /// Reads the body and looks at it.
    ///
    /// # Errors
    /// A file that holds no solid; a stream that is too slow.
    pub fn new(wishes: Wishes) -> Result<Self, FlyError> {
        if wishes.with_the_gas && domain::is_slow(wishes.mach) {
            return Err(FlyError::Asked(format!(
                "--mach {}: particles have no box as wide as a stream so slow asks for, where points are far apart; leave out `--motion with-the-gas`",
                wishes.mach,
            )));
        }
        let name = Name::like(&files::body_name(&wishes.body.file));
        let name = name.as_str().to_owned();
        let body =
            |error: &dyn std::fmt::Display| FlyError::Body(format!("body `{name}`: {error}"));
        let watch = Watch::default();
        let soup = wishes
            .body
            .read(Path::new(""), &watch)
            .map_err(|e| body(&e))?;
        let solid = wishes.body.solid(soup, 0.0, &watch).map_err(|e| body(&e))?;
        let attitude = Attitude::new(
            solid.shape.as_ref(),
            wishes.axes,
            wishes.body.half,
            wishes.roll,
        )?;
        let is_told = wishes.body.half.is_some();
        let flat = (!is_told).then(|| flat_side(solid.shape.as_ref(), &attitude));
        let shape: Arc<dyn Shape<3>> = Arc::new(Placed::new(solid.shape, attitude.placement()?));
        let bounds = box_of(shape.as_ref());
        let (extent, nearly) = extent(shape.as_ref(), &bounds, &wishes);
        let front = match &extent {
            Extent::Meridian(line) => line.frontal_area(),
            Extent::Space(_) => area_along(shape.as_ref(), &bounds, 0),
        };
        let area = wishes.area.unwrap_or(front);
        let region = domain::around(
            &bounds,
            bluntness(shape.as_ref(), &bounds),
            wishes.mach,
            [wishes.incidence, wishes.sideslip],
        );
        let fineness = Fineness::new(&region, &bounds, extent.dimension(), &wishes);
        Ok(Self {
            fineness,
            thinnest: thinnest_part(shape.as_ref(), &bounds),
            region,
            front,
            area,
            axis: match &extent {
                Extent::Meridian(_) => [0.0; 2],
                Extent::Space(mirrors) => axis(shape.as_ref(), &bounds, mirrors),
            },
            extent,
            nearly,
            flat: flat.flatten(),
            bounds,
            shape,
            attitude,
            repairs: solid.repairs,
            name,
            wishes,
        })
    }

    /// The same body and box in a stream of another Mach number, incidence and sideslip.
    #[must_use]
    pub fn in_stream(&self, [mach, incidence, sideslip]: [f64; 3]) -> Self {
        let mut other = self.clone();
        let wishes = &mut other.wishes;
        (wishes.mach, wishes.incidence, wishes.sideslip) = (mach, incidence, sideslip);
        other
    }

    /// Number of dimensions that are computed.
    pub fn dimension(&self) -> usize {
        self.extent.dimension()
    }

    /// True of a stream in which what the body does is felt on all sides of it.
    pub fn is_slow(&self) -> bool {
        domain::is_slow(self.wishes.mach)
    }

    /// Axes across which the flow is its own mirror image and half of it is left out.
    pub fn mirrors(&self) -> &[usize] {
        match &self.extent {
            Extent::Meridian(_) => &[],
            Extent::Space(mirrors) => mirrors,
        }
    }

    /// Length of the body.
    pub fn length(&self) -> f64 {
        self.bounds.size()[0]
    }

    /// Radius of a disc as large as the body's front.
    pub fn front_radius(&self) -> f64 {
        (self.front / PI).sqrt()
    }

    /// Reference length.
    pub fn reference_length(&self) -> f64 {
        self.wishes.length.unwrap_or_else(|| self.length())
    }

    /// Moment centre, behind the nose.
    pub fn centre(&self) -> f64 {
        let given = self.wishes.centre.map(|centre| centre.behind);
        given.unwrap_or_else(|| 0.5 * self.length())
    }

    /// The same above the middle of the box, and to the left of it: on the axis of the volume, which the tips of fins do not shift.
    pub fn centre_across(&self) -> [f64; 2] {
        self.wishes
            .centre
            .and_then(|centre| centre.across)
            .unwrap_or(self.axis)
    }

    /// Where moments are about, in words.
    pub fn centre_words(&self) -> String {
        let behind = format!("moments about {:.4} m behind the nose", self.centre());
        let [up, left] = self.centre_across();
        if [up, left] == [0.0; 2] {
            return behind;
        }
        format!("{behind}, {up:.4} m above the middle of the box and {left:.4} m to the left of it")
    }

    /// The part of the box that is computed.
    pub fn region(&self) -> Bounds<3> {
        let mut region = domain::part(&self.region, self.mirrors());
        if self.dimension() == 2 {
            (region.min[1], region.min[2], region.max[2]) = (0.0, 0.0, 0.0);
        }
        region
    }

    /// The part of that which pictures of the flow show: about the body, where sides are far from it.
    pub fn shown(&self) -> Bounds<3> {
        /// Of the body's longest edge.
        const AROUND: f64 = 0.75;
        let mut shown = self.region();
        if self.is_slow() {
            let around = Vector::<3>::repeat(AROUND * self.bounds.size().max());
            shown.min = shown.min.sup(&(self.bounds.min - around));
            shown.max = shown.max.inf(&(self.bounds.max + around));
        }
        shown
    }

    /// Gives shocks ahead of the body room for their thickness at a spacing at which the box is that many cells, and the gas behind it a few
    /// of these.
    pub fn widen(&mut self, cells: f64) {
        let spacing = self.spacing_of(cells);
        self.region.min[0] -= THICK * spacing / f64::from(1_u32 << self.halvings());
        let least = self.bounds.max[0] + BEHIND * spacing;
        self.region.max[0] = self.region.max[0].max(least);
    }

    /// Moves these sides of the box, axis and end, away from the body: half as far again.
    pub fn give_room(&mut self, sides: &[(usize, usize)]) {
        for axis in 0..3 {
            for end in 0..2 {
                // What is left out beyond a plane of symmetry is as large as what is computed.
                let is_image = end == 0 && self.mirrors().contains(&axis);
                let own = if is_image { (axis, 1) } else { (axis, end) };
                if sides.contains(&own) {
                    domain::move_away(&mut self.region, &self.bounds, (axis, end));
                }
            }
        }
    }

    /// A spacing at which the box is that many cells.
    pub fn spacing_of(&self, cells: f64) -> f64 {
        let size = self.region().size();
        let dimension = self.dimension();
        let room: f64 = (0..dimension).map(|k| size[k]).product();
        (room / cells).powf(1.0 / dimension as f64)
    }

    /// Dynamic pressure of the stream, Pa.
    pub fn dynamic_pressure(&self) -> f64 {
        let ([pressure, _], mach) = (self.wishes.air.at_rest(), self.wishes.mach);
        0.5 * GAMMA * pressure * mach * mach
    }

    /// The stream, in words: what is not asked for is air at sea level.
    pub fn stream_words(&self) -> String {
        let place = match self.wishes.air {
            Air::Altitude(height) => format!(", {height} m above the sea"),
            Air::State(..) => String::new(),
        };
        let [pressure, temperature] = self.wishes.air.at_rest();
        let mach = self.wishes.mach;
        let speed = mach * (GAMMA * GAS_CONSTANT * temperature).sqrt();
        let dynamic = self.dynamic_pressure();
        format!(
            "Mach {mach}{place}: {pressure:.5e} Pa, {temperature:.2} K, {speed:.1} m/s, dynamic pressure {dynamic:.4e} Pa"
        )
    }

    /// What is computed, in words.
    pub fn extent_words(&self) -> &'static str {
        match &self.extent {
            Extent::Meridian(_) => {
                "a body of revolution in a stream along its axis: a plane through the axis is computed"
            }
            Extent::Space(mirrors) => match mirrors[..] {
                [] => "the whole of the flow is computed",
                [_] => "body and stream are their own mirror image: half of the flow is computed",
                _ => {
                    "body and stream are their own mirror images twice: a quarter of the flow is computed"
                }
            },
        }
    }
}

/// Box of the triangles.
fn box_of(shape: &dyn Shape<3>) -> Bounds<3> {
    let mut bounds: Bounds<3> = Bounds::new(
        Vector::repeat(f64::INFINITY),
        Vector::repeat(f64::NEG_INFINITY),
    );
    for corner in shape
        .facets(f64::INFINITY, &shape.bounds())
        .iter()
        .flatten()
    {
        bounds.min = bounds.min.inf(corner);
        bounds.max = bounds.max.sup(corner);
    }
    if bounds.is_empty() {
        shape.bounds()
    } else {
        bounds
    }
}

/// What is computed, and across which axes half of it would be left out if the body were not off its mirror image by so much.
fn extent(
    shape: &dyn Shape<3>,
    bounds: &Bounds<3>,
    wishes: &Wishes,
) -> (Extent, Vec<(usize, f64)>) {
    // Moments about a point off the axis are not the same around it.
    let is_off =
        (wishes.centre.and_then(|centre| centre.across)).is_some_and(|across| across != [0.0; 2]);
    let level = wishes.incidence == 0.0 && wishes.sideslip == 0.0 && !is_off;
    if level && let Some(line) = Meridian::of(shape) {
        return (Extent::Meridian(line), Vec::new());
    }
    let (mut mirrors, mut nearly) = (Vec::new(), Vec::new());
    for (axis, is_along) in [(1, wishes.incidence == 0.0), (2, wishes.sideslip == 0.0)] {
        if !is_along {
            continue;
        }
        match likeness(shape, bounds, axis) {
            Likeness::Same => mirrors.push(axis),
            Likeness::Near(off) => nearly.push((axis, off)),
            Likeness::Other => {}
        }
    }
    (Extent::Space(mirrors), nearly)
}
