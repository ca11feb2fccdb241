//! From what a scene says of its sides to the openings of the domain: parts of walls, and gas beyond sides that is not the free
//! stream.

use std::sync::Arc;

use aero_geometry::{Bounds, Vector};

use super::domain::{WHOLE, number};
use super::error::SceneError;
use super::file::SceneFile;
use super::formula::{Place, TimedFormula};
use super::side::{PartEntry, SideEntry};
use super::side_words::{GivenEntry, PatchEntry};
use super::vector::{side_key, vector};
use aero_solver::method::{Method, Time};
use aero_solver::problem::{AXES, Domain, Given, Opening, Side, State};

/// What is said of a side, and what it is said in.
struct Sides<'a, const D: usize> {
    domain: &'a Domain<D>,
    stream: &'a State<D>,
    spacing: f64,
    method: Method,
}

/// The openings of `domain`, whose sides have been read from `file` already; its outlets get the pressure at their middle.
pub(super) fn open<const D: usize>(
    file: &SceneFile,
    domain: &mut Domain<D>,
    stream: &State<D>,
    method: Method,
) -> Result<(), SceneError> {
    let sides = Sides {
        domain,
        stream,
        spacing: file.spacing.get(),
        method,
    };
    let mut openings = Vec::new();
    for (axis, end, entry) in file.domain.sides.each().filter(|(axis, ..)| *axis < D) {
        let name = side_key(axis, end);
        openings.extend(sides.of_side(&name, (axis, end), entry)?);
    }
    for opening in &openings {
        if opening.part.is_none() {
            domain.sides[opening.axis][opening.end] = opening.side;
        }
    }
    domain.openings = openings;
    Ok(())
}

fn fail<T>(place: &str, message: impl Into<String>) -> Result<T, SceneError> {
    Err(SceneError::value(place, message.into()))
}

impl<const D: usize> Sides<'_, D> {
    fn of_side(
        &self,
        name: &str,
        (axis, end): (usize, usize),
        entry: &SideEntry,
    ) -> Result<Vec<Opening<D>>, SceneError> {
        let mut all: Vec<Opening<D>> = Vec::new();
        if let Some(given) = &entry.given {
            all.push(self.opening(name, (axis, end), None, (entry.side, Some(given)))?);
        }
        if !entry.parts.is_empty() {
            self.holds_parts(name, (axis, end), entry.side)?;
        }
        for PartEntry { patch, side, given } in &entry.parts {
            let part = self.patch(name, (axis, end), patch)?;
            if side.is_mirror() && self.method == Method::WithTheGas {
                return fail(
                    name,
                    "has a mirror for a part, beside which particles would lack what mirrors and walls show them; \
                     set `scheme.motion = \"fixed\"`, or make the wall a body of its own",
                );
            }
            let own = (*side, given.as_ref());
            let opening = self.opening(name, (axis, end), Some(part), own)?;
            if all.iter().any(|other| overlaps(other, &opening)) {
                return fail(name, "has two patches that overlap; move one of them");
            }
            all.push(opening);
        }
        Ok(all)
    }

    /// Refuses walls that cannot have other parts.
    fn holds_parts(
        &self,
        name: &str,
        (axis, _): (usize, usize),
        wall: Side,
    ) -> Result<(), SceneError> {
        if D == 1 {
            return fail(
                name,
                "is a point in one dimension and has no parts; say what it is alone",
            );
        }
        let is_moving = matches!(wall, Side::Wall { velocity, acceleration, .. } if velocity != 0.0 || acceleration != 0.0);
        if is_moving {
            return fail(
                name,
                "is a wall that moves, in which a patch cannot stay open; let it rest",
            );
        }
        if self.domain.is_axisymmetric() && axis > 0 && self.method == Method::WithTheGas {
            return fail(
                name,
                "lies around the axis, where particles that come in through a patch would grow lighter on their way; \
                 set `scheme.motion = \"fixed\"`, or put the patch on x_min or x_max",
            );
        }
        Ok(())
    }

    /// The box of a part, on the side and in step with the lattice.
    fn patch(
        &self,
        name: &str,
        (axis, end): (usize, usize),
        patch: &PatchEntry,
    ) -> Result<Bounds<D>, SceneError> {
        let min: Vector<D> = vector(&format!("{name}, patch.min"), &patch.min)?;
        let max: Vector<D> = vector(&format!("{name}, patch.max"), &patch.max)?;
        let (bounds, spacing) = (&self.domain.bounds, self.spacing);
        let face = self.domain.face(axis, end);
        for (corner, at) in [("min", min[axis]), ("max", max[axis])] {
            if (at - face).abs() > WHOLE * spacing {
                return fail(
                    name,
                    format!(
                        "lies at {} = {face}, but patch.{corner} at {at}; give {face} there",
                        AXES[axis]
                    ),
                );
            }
        }
        for k in (0..D).filter(|&k| k != axis) {
            let letter = AXES[k];
            if max[k] <= min[k] {
                return fail(
                    name,
                    format!(
                        "has a patch from {letter} = {} to {}, which is nothing; max must exceed min",
                        min[k], max[k]
                    ),
                );
            }
            let slack = WHOLE * spacing;
            if min[k] < bounds.min[k] - slack || max[k] > bounds.max[k] + slack {
                return fail(
                    name,
                    format!(
                        "has a patch from {letter} = {} to {}, but the side goes from {} to {}; keep it inside",
                        min[k], max[k], bounds.min[k], bounds.max[k]
                    ),
                );
            }
            for edge in [min[k], max[k]] {
                let steps = (edge - bounds.min[k]) / spacing;
                if (steps - steps.round()).abs() > WHOLE * steps.abs().max(1.0) {
                    return fail(
                        name,
                        format!(
                            "has a patch with an edge at {letter} = {edge}, {steps:.3} spacings from the domain's corner; \
                             take a whole number: {} or {}",
                            number(bounds.min[k] + steps.floor() * spacing),
                            number(bounds.min[k] + steps.ceil() * spacing),
                        ),
                    );
                }
            }
        }
        Ok(Bounds::new(min, max))
    }

    fn opening(
        &self,
        name: &str,
        (axis, end): (usize, usize),
        part: Option<Bounds<D>>,
        (side, entry): (Side, Option<&GivenEntry>),
    ) -> Result<Opening<D>, SceneError> {
        let mut opening = Opening {
            axis,
            end,
            part,
            side,
            given: None,
        };
        let Some(entry) = entry else {
            self.enters(name, &opening, self.stream)?;
            return Ok(opening);
        };
        let velocity = velocity::<D>(name, entry)?;
        self.can_carry(name, &opening, entry, &velocity)?;
        let (density, pressure) = (entry.density.clone(), entry.pressure.clone());
        let (stream, spacing) = (*self.stream, self.spacing);
        let given = Given(Arc::new(move |position: &Vector<D>, time| {
            let place = Place {
                position: std::array::from_fn(|k| position.get(k).copied().unwrap_or(0.0)),
                time,
                spacing,
            };
            let value = |formula: &Option<TimedFormula>, usual: f64| {
                formula.as_ref().map_or(usual, |formula| formula.at(&place))
            };
            State {
                density: value(&density, stream.density),
                velocity: Vector::from_fn(|k, _| {
                    velocity.get(k).map_or(stream.velocity[k], |u| u.at(&place))
                }),
                pressure: value(&pressure, stream.pressure),
            }
        }));
        let first = given.at(&self.middle(&opening), 0.0);
        let is_gas = |value: f64| value.is_finite() && value > 0.0;
        for (key, value) in [("density", first.density), ("pressure", first.pressure)] {
            if !is_gas(value) {
                return fail(
                    name,
                    format!(
                        "has a {key} of {value} at its middle and t = 0, which no gas has; mend the formula"
                    ),
                );
            }
        }
        self.enters(name, &opening, &first)?;
        if let Side::HeldOutlet { pressure, .. } = &mut opening.side {
            *pressure = first.pressure;
        }
        opening.given = Some(given);
        Ok(opening)
    }

    /// Refuses an inlet that gas would leave by at the start.
    fn enters(&self, name: &str, opening: &Opening<D>, first: &State<D>) -> Result<(), SceneError> {
        let inward = [1.0, -1.0][opening.end] * first.velocity[opening.axis];
        // One that is given may start at rest.
        let may_rest = !std::ptr::eq(first, self.stream);
        if !opening.side.is_inlet() || inward > 0.0 || (inward == 0.0 && may_rest) {
            return Ok(());
        }
        let letter = AXES[opening.axis];
        fail(
            name,
            format!(
                "is an inlet whose gas moves at {} along {letter} and does not come in; give it a velocity into the domain",
                first.velocity[opening.axis]
            ),
        )
    }

    /// Refuses what the motion of the scene cannot have beyond a side.
    fn can_carry(
        &self,
        name: &str,
        opening: &Opening<D>,
        entry: &GivenEntry,
        velocity: &[TimedFormula],
    ) -> Result<(), SceneError> {
        let scalars = [&entry.density, &entry.pressure];
        let scalars = || scalars.into_iter().flatten();
        let mut all = scalars().chain(velocity);
        if let Some(points) = self.method.fixed() {
            if points.time == Time::Settle && all.any(TimedFormula::knows_time) {
                return fail(
                    name,
                    "changes with `t`, and this flow settles without; leave `t` out, or set `scheme.time = \"accurate\"`",
                );
            }
            return Ok(());
        }
        let by_points = "; take `t` alone, or set `scheme.motion = \"fixed\"`";
        if velocity.iter().any(TimedFormula::knows_place) {
            return fail(
                name,
                format!(
                    "has a velocity that changes from place to place, but particles come in on a lattice that moves as one{by_points}"
                ),
            );
        }
        if opening.side == Side::SoftInlet && scalars().any(TimedFormula::knows_place) {
            return fail(
                name,
                format!(
                    "lets sound out and has a state that changes from place to place, but particles come in as one{by_points}"
                ),
            );
        }
        let is_aside = |(k, formula): (usize, &TimedFormula)| {
            k != opening.axis && formula.number() != Some(0.0)
        };
        if opening.part.is_some() && velocity.iter().enumerate().any(is_aside) {
            return fail(
                name,
                "has a patch with a velocity along the side, whose lattice of particles would leave it; \
                 let the gas come straight in, or set `scheme.motion = \"fixed\"`",
            );
        }
        Ok(())
    }

    fn middle(&self, opening: &Opening<D>) -> Vector<D> {
        let bounds = opening.part.as_ref().unwrap_or(&self.domain.bounds);
        let mut middle = (bounds.min + bounds.max) * 0.5;
        middle[opening.axis] = self.domain.face(opening.axis, opening.end);
        middle
    }
}

/// The formulas of the velocity; none where that is the free stream's.
fn velocity<const D: usize>(
    name: &str,
    entry: &GivenEntry,
) -> Result<Vec<TimedFormula>, SceneError> {
    match &entry.velocity {
        None => Ok(Vec::new()),
        Some(formulas) if formulas.len() == D => Ok(formulas.clone()),
        Some(formulas) => fail(
            name,
            format!(
                "has a velocity of {} formulas, but the scene has dimension {D}; give {D}",
                formulas.len()
            ),
        ),
    }
}

/// True of two parts of one side that share more than a rim.
fn overlaps<const D: usize>(one: &Opening<D>, other: &Opening<D>) -> bool {
    let (Some(a), Some(b)) = (&one.part, &other.part) else {
        return false;
    };
    let mut others = (0..D).filter(|&k| k != one.axis);
    others.all(|k| a.min[k] < b.max[k] && b.min[k] < a.max[k])
}
