//! From the file's `[[probe]]` entries to where values of the gas are recorded.

use aero_geometry::Bounds;
use aero_solver::Pose;
use aero_solver::problem::{AXES, Body, Domain};
use serde::Deserialize;

use super::error::SceneError;
use super::number::{Count, Finite, Name, Positive};
use super::region::within;
use super::vector::vector;
use crate::case::{Probe, Reach};
use crate::sample::{Lattice, Solids};

/// Points of a line unless given.
const POINTS: usize = 201;

/// Points of a section to a spacing of the gas, unless given.
const FINER: f64 = 0.5;

/// `[[probe]]`: where values of the gas are recorded.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProbeEntry {
    /// Name, unique among probes.
    pub name: Name,
    /// Where.
    pub at: ProbeShape,
}

/// Where a probe is.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ProbeShape {
    /// A point: its state beside every row of the history.
    Point(Vec<Finite>),
    /// A line: the state along it beside every frame.
    Line(LineEntry),
    /// A section across an axis: what flows through it, and means over it, beside every row of the history.
    Section(SectionEntry),
}

/// `line`: a straight one.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LineEntry {
    /// Its beginning.
    pub from: Vec<Finite>,
    /// Its end.
    pub to: Vec<Finite>,
    /// Number of points, both ends among them; 201 unless given.
    pub points: Option<Count>,
}

/// `section`: a rectangle across an axis, in the plane a segment, about an axis the ring that a segment sweeps.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionEntry {
    /// Lowest corner.
    pub min: Vec<Finite>,
    /// Highest corner, the same along the axis that the section lies across.
    pub max: Vec<Finite>,
    /// About how far apart the points are that sums go over; half the scene's spacing unless given.
    pub spacing: Option<Positive>,
}

/// The probes of a scene whose gas is `spacing` apart.
pub(super) fn probes<const D: usize>(
    entries: &[ProbeEntry],
    domain: &Domain<D>,
    bodies: &[Body<D>],
    spacing: f64,
) -> Result<Vec<Probe<D>>, SceneError> {
    let mut probes: Vec<Probe<D>> = Vec::new();
    for entry in entries {
        let name = entry.name.as_str();
        let fail = |message: String| Err(SceneError::value(format!("probe.{name}"), message));
        if probes.iter().any(|probe| probe.name == name) {
            return fail(
                "another probe has this name already; names are unique, so rename one".into(),
            );
        }
        let place = |key: &str| format!("probe.{name}.at.{key}");
        let reach = match &entry.at {
            ProbeShape::Point(point) => {
                let point = vector(&place("point"), point)?;
                within(&place("point"), Bounds::new(point, point), domain)?;
                Reach::Point(point)
            }
            ProbeShape::Line(line) => {
                let from = vector(&place("line.from"), &line.from)?;
                let to = vector(&place("line.to"), &line.to)?;
                for (key, end) in [("line.from", from), ("line.to", to)] {
                    within(&place(key), Bounds::new(end, end), domain)?;
                }
                let points = line.points.map_or(POINTS, Count::get);
                if from == to || points < 2 {
                    return fail(
                        "has a line without length; give two ends and two points or more".into(),
                    );
                }
                Reach::Line([from, to], points)
            }
            ProbeShape::Section(section) => {
                let bounds = Bounds::new(
                    vector(&place("section.min"), &section.min)?,
                    vector(&place("section.max"), &section.max)?,
                );
                within(&place("section"), bounds, domain)?;
                let apart = section.spacing.map_or(FINER * spacing, Positive::get);
                match across(&bounds) {
                    Some(axis) => Reach::Section(axis, Lattice::middles(&bounds, apart)),
                    None => return fail(flat(D)),
                }
            }
        };
        check_in_gas(name, &reach, bodies)?;
        probes.push(Probe {
            name: name.to_owned(),
            reach,
        });
    }
    Ok(probes)
}

/// The one axis along which a section has no width.
fn across<const D: usize>(bounds: &Bounds<D>) -> Option<usize> {
    let size = bounds.size();
    let flat: Vec<usize> = (0..D).filter(|&k| size[k] == 0.0).collect();
    let is_box = (0..D).all(|k| size[k] >= 0.0) && D > 1;
    match flat[..] {
        [axis] if is_box => Some(axis),
        _ => None,
    }
}

fn flat(dimension: usize) -> String {
    if dimension == 1 {
        return "is a section, but on a line every point is one; take a `point`".into();
    }
    let axes = AXES[..dimension].join(", ");
    format!(
        "is no section; `min` and `max` must be the same along one axis of {axes}, and `max` above `min` along the others"
    )
}

/// Refuses a probe that is in bodies all over.
fn check_in_gas<const D: usize>(
    name: &str,
    reach: &Reach<D>,
    bodies: &[Body<D>],
) -> Result<(), SceneError> {
    let solids = Solids::new(bodies, |number| Pose::new(&bodies[number].motion, 0.0));
    let places = reach.places();
    if places.iter().any(|place| !solids.hold(place)) {
        return Ok(());
    }
    let place = places[0];
    let mut mend = String::from("move it out");
    let mut body = "";
    for candidate in bodies {
        let closest = candidate.shape.closest(&place);
        if closest.distance < 0.0 {
            body = &candidate.name;
            let point: Vec<String> = closest.point.iter().map(|x| format!("{x:.4}")).collect();
            mend = format!(
                "{mend}: the surface is {:.3e} away, at ({})",
                -closest.distance,
                point.join(", ")
            );
        }
    }
    Err(SceneError::value(
        format!("probe.{name}"),
        format!("lies in body `{body}`, where there is no gas; {mend}"),
    ))
}
