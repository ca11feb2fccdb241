//! What a scene meant: the flow problem that the solver reads, and how it is run.

use std::any::Any;

use aero_geometry::{Bounds, Vector};
use aero_packer::Warning;

use crate::sample::{Lattice, Quantity, View};
use aero_solver::problem::{Body, Problem, Side};

/// A scene, checked and packed, in `D` dimensions.
#[derive(Clone, Debug)]
pub struct Case<const D: usize> {
    /// What flows where.
    pub problem: Problem<D>,
    /// How it is run.
    pub plan: RunPlan<D>,
}

/// A case of any dimension.
#[derive(Clone, Debug)]
pub enum AnyCase {
    /// A line.
    One(Box<Case<1>>),
    /// A plane.
    Two(Box<Case<2>>),
    /// Space.
    Three(Box<Case<3>>),
}

impl AnyCase {
    /// The case itself, where it has `D` dimensions.
    pub fn of<const D: usize>(self) -> Option<Case<D>> {
        let case: Box<dyn Any> = match self {
            Self::One(case) => case,
            Self::Two(case) => case,
            Self::Three(case) => case,
        };
        case.downcast().ok().map(|case| *case)
    }

    /// What was repaired in the bodies' meshes, and what the user should know about their packing,
    /// one line each.
    pub fn remarks(&self) -> Vec<String> {
        match self {
            Self::One(case) => remarks(case),
            Self::Two(case) => remarks(case),
            Self::Three(case) => remarks(case),
        }
    }
}

impl AnyCase {
    /// True where bodies at rest, domain and sides are their own mirror image across `axis` of the domain's middle: flows of streams that are
    /// mirror images of each other are so, too.
    pub fn has_mirror(&self, axis: usize) -> bool {
        match self {
            Self::One(case) => has_mirror(&case.problem, axis),
            Self::Two(case) => has_mirror(&case.problem, axis),
            Self::Three(case) => has_mirror(&case.problem, axis),
        }
    }

    /// Where along z a slice shows most of a scene in space; nothing of any other.
    pub fn slice(&self) -> Option<f64> {
        match self {
            Self::Three(case) => Some(slice(&case.problem)),
            Self::One(_) | Self::Two(_) => None,
        }
    }
}

/// Part of the domain's size by which places may be off.
const ROUND_OFF: f64 = 1e-9;

/// See [`AnyCase::has_mirror`].
fn has_mirror<const D: usize>(problem: &Problem<D>, axis: usize) -> bool {
    let Problem {
        domain,
        bodies,
        source,
        disorder,
        ..
    } = problem;
    if axis >= D {
        return false;
    }
    let [low, high] = [domain.bounds.min[axis], domain.bounds.max[axis]];
    let near = ROUND_OFF * domain.bounds.size().norm();
    let is_middle = |(across, plane): (usize, f64)| {
        across == axis && (plane - f64::midpoint(low, high)).abs() < near
    };
    let [below, above] = domain.sides[axis];
    let are_mirrored = bodies.iter().all(|body| {
        let planes = body.shape.mirror_planes();
        !body.motion.is_moving()
            && !body.wall.slides()
            && is_middle((axis, body.moment_centre[axis]))
            && planes.into_iter().any(is_middle)
    });
    let is_open = |side: Side| !matches!(side, Side::Wall { .. } | Side::Body | Side::Axis);
    below == above
        && !below.is_mirror()
        && !domain.has(|side| !is_open(side))
        && domain.openings.is_empty()
        && source.is_none()
        && *disorder == 0.0
        && are_mirrored
}

/// Beside a plane of symmetry across z; else through the middle of the bodies as far as they are in the domain, or of that.
fn slice(problem: &Problem<3>) -> f64 {
    let domain = &problem.domain;
    let [low, high] = domain.sides[2];
    if low.is_mirror() || high.is_mirror() {
        let (plane, way) = if low.is_mirror() {
            (domain.bounds.min[2], 0.5)
        } else {
            (domain.bounds.max[2], -0.5)
        };
        return plane + way * problem.resolution.lattice();
    }
    let extents = problem.bodies.iter().map(|body| {
        let shown = body.shape.bounds().intersection(&domain.bounds);
        [shown.min[2], shown.max[2]]
    });
    let extents = extents.filter(|[low, high]| low <= high);
    let around = extents.reduce(|[a, b], [low, high]| [a.min(low), b.max(high)]);
    let [low, high] = around.unwrap_or([domain.bounds.min[2], domain.bounds.max[2]]);
    0.5 * (low + high)
}

fn remarks<const D: usize>(case: &Case<D>) -> Vec<String> {
    let repaired = |body: &Body<D>| {
        let remark = |line: &String| format!("body `{}`: {line}", body.name);
        body.report.repairs.iter().map(remark).collect::<Vec<_>>()
    };
    let bodies = &case.problem.bodies;
    let noted = case.plan.warnings.clone();
    let warnings = noted.unwrap_or_else(|| warnings(bodies)).into_iter();
    let repairs = bodies.iter().flat_map(repaired);
    repairs
        .chain(warnings.map(|warning| format!("warning: {warning}")))
        .collect()
}

/// What the user should know about the bodies.
pub fn warnings<const D: usize>(bodies: &[Body<D>]) -> Vec<Warning> {
    let of_body = |body: &Body<D>| {
        let warnings = body.report.warnings.iter();
        warnings
            .map(|warning| warning.of(&body.name))
            .collect::<Vec<_>>()
    };
    bodies.iter().flat_map(of_body).collect()
}

/// How a problem is run.
#[derive(Clone, Debug, PartialEq)]
pub struct RunPlan<const D: usize> {
    /// Name of the scene.
    pub name: String,
    /// Time at which the run ends.
    pub end_time: f64,
    /// Whether it may end before.
    pub stop: Stop,
    /// Degrees at which the stream meets the axes of the bodies, where the scene states them.
    pub incidence: Option<f64>,
    /// Specific gas constant, where the scene states or implies it.
    pub gas_constant: Option<f64>,
    /// What the user should know, where the case has been checked.
    pub warnings: Option<Vec<Warning>>,
    /// When to write what.
    pub output: OutputPlan<D>,
    /// Where values of the gas are recorded.
    pub probes: Vec<Probe<D>>,
}

/// When a run ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// At its end time.
    EndTime,
    /// As soon as the flow is steady, at its end time at the latest.
    Steady,
}

/// The pressure that force coefficients are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pressure {
    /// Less that of the free stream.
    #[default]
    Gauge,
    /// As it is.
    Absolute,
}

/// When to write what.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputPlan<const D: usize> {
    /// Time between frames; the first and the last state are always written.
    pub frame_interval: f64,
    /// What frames show; everything if none.
    pub region: Option<Bounds<D>>,
    /// What is written beside.
    pub extras: Extras,
    /// Planes `(axis, place)` that what is written is mirrored at.
    pub mirrors: Vec<(usize, f64)>,
    /// The gas on a lattice is written, too.
    pub field: Option<FieldPlan<D>>,
    /// A plane of the flow is drawn, too.
    pub picture: Option<PicturePlan>,
    /// Files are compressed.
    pub is_compressed: bool,
    /// The pressure that coefficients are made of.
    pub coefficients: Pressure,
    /// Steps between rows of the history.
    pub history_every: usize,
    /// Longest wall time between checkpoints, s.
    pub checkpoint_seconds: f64,
}

/// What frames have beside the gas, where it is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extras {
    /// The cells about points that stay.
    pub cells: bool,
    /// Ghosts and buffers.
    pub ghosts: bool,
    /// The gradient of the density.
    pub gradients: bool,
}

/// The gas on a lattice, beside every frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldPlan<const D: usize> {
    /// Its points.
    pub lattice: Lattice<D>,
}

/// A plane of the flow, drawn beside every frame; of a flow on a line a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct PicturePlan {
    /// What it shows.
    pub quantity: Quantity,
    /// Values at the ends of the colours; those of each picture if none.
    pub range: Option<[f64; 2]>,
    /// Where.
    pub stretch: Stretch,
}

/// What a picture shows.
#[derive(Clone, Debug, PartialEq)]
pub enum Stretch {
    /// A line, from and to.
    Line([f64; 2]),
    /// Pixels of a plane.
    Plane(View),
}

/// Where values of the gas are recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe<const D: usize> {
    /// Name, unique among probes.
    pub name: String,
    /// Where it is.
    pub reach: Reach<D>,
}

/// Where a probe is.
#[derive(Clone, Debug, PartialEq)]
pub enum Reach<const D: usize> {
    /// At a point.
    Point(Vector<D>),
    /// Along a line, from its first end to its second, at so many points.
    Line([Vector<D>; 2], usize),
    /// Through a section across that axis, at the middles of its parts.
    Section(usize, Lattice<D>),
}

impl<const D: usize> Reach<D> {
    /// All its places.
    pub fn places(&self) -> Vec<Vector<D>> {
        match self {
            Self::Point(point) => vec![*point],
            Self::Line([from, to], points) => {
                let part = |n: usize| n as f64 / (points - 1) as f64;
                (0..*points).map(|n| from + (to - from) * part(n)).collect()
            }
            Self::Section(_, lattice) => (0..lattice.count()).map(|n| lattice.place(n)).collect(),
        }
    }
}
