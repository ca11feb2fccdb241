//! From `output.picture` to a plane of pixels.

use aero_geometry::{Bounds, Vector};
use aero_solver::problem::Domain;
use nalgebra::Vector3;
use serde::Deserialize;

use super::error::SceneError;
use super::number::{Count, Finite};
use super::region::{RegionEntry, Surroundings, mirrored, region, within};
use super::vector::vector;
use super::words::QuantityWord;
use crate::case::{PicturePlan, Stretch};
use crate::sample::{Quantity, View};

const PLACE: &str = "output.picture";

/// Pixels across unless given, and the most that are high.
const COLUMNS: usize = 900;
const ROWS: f64 = 1200.0;

/// `output.picture`: a plane of the flow, coloured.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PictureEntry {
    /// What colours show; `mach` unless given.
    pub quantity: Option<QuantityWord>,
    /// Values at the ends of the colours; those of each picture unless given.
    pub range: Option<[Finite; 2]>,
    /// The box that is shown; the domain unless given.
    pub region: Option<RegionEntry>,
    /// Normal of the plane, in space; that of a symmetry side, or the third axis, unless given.
    pub normal: Option<Vec<Finite>>,
    /// How far along its normal the plane lies from the origin; at the symmetry side, or in the middle of the box, unless given.
    pub offset: Option<Finite>,
    /// Pixels across; 900 unless given.
    pub width: Option<Count>,
}

/// What is drawn of a scene, its images at `mirrors` included.
pub(super) fn picture<const D: usize>(
    entry: &PictureEntry,
    scene: &Surroundings<'_, D>,
    mirrors: &[(usize, f64)],
) -> Result<PicturePlan, SceneError> {
    let domain = scene.domain;
    let fail = |key: &str, message: &str| Err(SceneError::value(format!("{PLACE}{key}"), message));
    let quantity: Quantity = entry.quantity.map_or(Quantity::Mach, Into::into);
    if quantity == Quantity::Temperature && scene.gas_constant.is_none() {
        return fail(
            ".quantity",
            "the temperature follows from no gas constant; give `free_stream.temperature` or `altitude`, or show `pressure`",
        );
    }
    if quantity == Quantity::PressureCoefficient && scene.stream.velocity == Vector::<D>::zeros() {
        return fail(
            ".quantity",
            "gas at rest has no dynamic pressure; show `pressure`",
        );
    }
    let range = entry.range.map(|ends| ends.map(Finite::get));
    if range.is_some_and(|[low, high]| low >= high) {
        return fail(".range", "is empty; give the lower end first");
    }
    let shown = match &entry.region {
        Some(entry) => within("output.picture.region", region(PLACE, entry)?, domain)?,
        None => domain.bounds,
    };
    let shown = mirrored(shown, mirrors);
    if D < 3 && (entry.normal.is_some() || entry.offset.is_some()) {
        return fail(
            "",
            "a flow in a plane has no other; leave `normal` and `offset` out",
        );
    }
    let stretch = match D {
        1 => Stretch::Line([shown.min[0], shown.max[0]]),
        _ => Stretch::Plane(view(entry, domain, &shown)?),
    };
    Ok(PicturePlan {
        quantity,
        range,
        stretch,
    })
}

/// The plane, and the part of it in `shown`.
fn view<const D: usize>(
    entry: &PictureEntry,
    domain: &Domain<D>,
    shown: &Bounds<D>,
) -> Result<View, SceneError> {
    let columns = entry.width.map_or(COLUMNS, Count::get);
    let pad = |v: &Vector<D>| Vector3::from_fn(|k, _| if k < D { v[k] } else { 0.0 });
    let [low, high] = [pad(&shown.min), pad(&shown.max)];
    if D == 2 {
        let window = [[low[0], high[0]], [low[1], high[1]]];
        return Ok(sized(
            Vector3::zeros(),
            [Vector3::x(), Vector3::y()],
            window,
            columns,
        ));
    }
    let mut mirrors = domain
        .each_side()
        .filter(|(_, _, side, _)| side.is_mirror());
    let mirror = mirrors.next().filter(|_| entry.normal.is_none());
    let normal = match (&entry.normal, mirror) {
        (Some(numbers), _) => pad(&vector::<D>("output.picture.normal", numbers)?),
        (None, Some((axis, ..))) => Vector3::ith(axis, 1.0),
        (None, None) => Vector3::z(),
    };
    let Some(normal) = normal.try_normalize(0.0) else {
        return Err(SceneError::value(
            "output.picture.normal",
            "points nowhere; give a vector of any length but zero",
        ));
    };
    let middle = mirror.map_or(0.5 * normal.dot(&(low + high)), |(.., face)| face);
    let offset = entry.offset.map_or(middle, Finite::get);
    let axes = across(&normal);
    let corners = cut([low, high], &normal, offset);
    if corners.len() < 3 {
        let reach: Vec<f64> = (0..8)
            .map(|n| normal.dot(&corner([low, high], n)))
            .collect();
        let ends = reach
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
                [a.min(*x), b.max(*x)]
            });
        return Err(SceneError::value(
            "output.picture.offset",
            format!(
                "{offset} along ({}, {}, {}) misses what is shown; give one between {} and {}",
                normal[0], normal[1], normal[2], ends[0], ends[1]
            ),
        ));
    }
    let window = axes.map(|axis| {
        let places = corners.iter().map(|corner| axis.dot(corner));
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
            [a.min(x), b.max(x)]
        })
    });
    Ok(sized(normal * offset, axes, window, columns))
}

/// Unit vectors to the right and upwards in the plane across `normal`: along the axes where it is one of them.
fn across(normal: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let away = normal.iamax();
    let right = if away == 0 {
        Vector3::y()
    } else {
        Vector3::x()
    };
    let right = (right - normal * normal.dot(&right)).normalize();
    let up = normal.cross(&right);
    // Upwards is towards `y`, or `z` where that is the normal.
    let most = up.iamax();
    [right, if up[most] < 0.0 { -up } else { up }]
}

fn corner(ends: [Vector3<f64>; 2], number: usize) -> Vector3<f64> {
    Vector3::from_fn(|k, _| ends[number >> k & 1][k])
}

/// Where a plane cuts the edges of a box.
fn cut(ends: [Vector3<f64>; 2], normal: &Vector3<f64>, offset: f64) -> Vec<Vector3<f64>> {
    let edges = (0..8).flat_map(|n| (0..3).map(move |k| (n, n | 1 << k)));
    let cuts = edges.filter(|(a, b)| a != b).filter_map(|(a, b)| {
        let [a, b] = [a, b].map(|n| corner(ends, n));
        let [low, high] = [a, b].map(|p| normal.dot(&p) - offset);
        // An edge in the plane is met at the ends of others.
        (low * high <= 0.0 && low != high).then(|| a + (b - a) * (low / (low - high)))
    });
    cuts.collect()
}

fn sized(
    origin: Vector3<f64>,
    axes: [Vector3<f64>; 2],
    window: [[f64; 2]; 2],
    columns: usize,
) -> View {
    let [wide, high] = window.map(|[a, b]| b - a);
    let columns = (columns as f64).min((ROWS * wide / high).max(2.0));
    View {
        origin: origin.into(),
        axes: axes.map(Into::into),
        window,
        size: [
            columns as usize,
            (columns * high / wide).round().max(2.0) as usize,
        ],
    }
}
