//! What the surfaces of bodies and sides are to the gas, and what they cannot be.

use aero_geometry::Vector;

use super::error::SceneError;
use super::liquid;
use super::motion::rotation;
use super::number::Finite;
use super::vector::{side_key, vector};
use super::wall::{BodyWallEntry, kind};
use aero_solver::problem::{Problem, Side, Slide, WallHeat, WallKind};

/// The wall of body `name`, whose surface turns about its moment centre unless the scene says otherwise.
pub(super) fn of_body<const D: usize>(
    name: &str,
    entry: Option<&BodyWallEntry>,
    moment_centre: &Vector<D>,
) -> Result<WallKind, SceneError> {
    let Some(BodyWallEntry(entry)) = entry else {
        return Ok(WallKind::Slip);
    };
    let place = |key: &str| format!("body.{name}.wall.{key}");
    let found = kind(entry.kind, entry.temperature, entry.heat_flux);
    let mut found =
        found.map_err(|message| SceneError::value(format!("body.{name}.wall"), message))?;
    let mut slide = Slide::default();
    if let Some(velocity) = &entry.velocity {
        slide.velocity = padded(&vector::<D>(&place("velocity"), velocity)?);
    }
    match (&entry.angular_velocity, &entry.pivot) {
        (Some(rate), pivot) => {
            slide.turning = rotation::<D>(&place("angular_velocity"), rate)?.into();
            slide.pivot = match pivot {
                Some(pivot) => padded(&vector::<D>(&place("pivot"), pivot)?),
                None => padded(moment_centre),
            };
        }
        (None, Some(_)) => {
            return Err(SceneError::value(
                place("pivot"),
                "is what the surface turns about; add angular_velocity, or leave it out",
            ));
        }
        (None, None) => {}
    }
    set_slide(&mut found, slide)
        .map_err(|message| SceneError::value(format!("body.{name}.wall"), message))?;
    Ok(found)
}

/// Makes the surface of a wall move along itself.
fn set_slide(kind: &mut WallKind, slide: Slide) -> Result<(), &'static str> {
    match kind {
        WallKind::NoSlip(wall) => wall.slide = slide,
        WallKind::Slip if slide.is_none() => {}
        WallKind::Slip => {
            return Err(
                "gas that slides along a wall does not feel how its surface moves; add `kind = \"no-slip\"`",
            );
        }
    }
    Ok(())
}

/// Parts the velocity of the wall `side`, `name` on an axis, into that across and that along it.
pub(super) fn set_velocity<const D: usize>(
    side: &mut Side,
    name: &str,
    axis: usize,
    numbers: &[Finite],
) -> Result<(), SceneError> {
    let place = format!("{name}.wall.velocity");
    let mut along = vector::<D>(&place, numbers)?;
    let Side::Wall { kind, velocity, .. } = side else {
        return Ok(());
    };
    *velocity = along[axis];
    along[axis] = 0.0;
    let slide = Slide {
        velocity: padded(&along),
        ..Slide::default()
    };
    set_slide(kind, slide).map_err(|message| SceneError::value(place, message))
}

fn padded<const D: usize>(vector: &Vector<D>) -> [f64; 3] {
    std::array::from_fn(|k| if k < D { vector[k] } else { 0.0 })
}

/// Refuses walls that gas without viscosity would stick to, and temperatures of walls where none are known.
pub(super) fn check<const D: usize>(
    problem: &Problem<D>,
    knows_temperature: bool,
) -> Result<(), SceneError> {
    let bodies = problem.bodies.iter();
    let bodies = bodies.map(|body| (format!("body.{}.wall", body.name), body.wall));
    let sides = problem.domain.each_side();
    let sides = sides.filter_map(|(axis, end, side, _)| match side {
        Side::Wall { kind, .. } => Some((side_key(axis, end), kind)),
        _ => None,
    });
    for (place, kind) in bodies.chain(sides) {
        if problem.gas.liquid().is_some() {
            liquid::check_wall(&place, kind)?;
        }
        let WallKind::NoSlip(wall) = kind else {
            continue;
        };
        if !problem.gas.is_viscous() {
            return Err(SceneError::value(
                place,
                "is `no-slip`, but gas without viscosity slides along every wall; add `viscosity` to [gas], \
                 `{ sutherland = {} }` of air, or use `slip`",
            ));
        }
        if matches!(wall.heat, WallHeat::Temperature(_)) && !knows_temperature {
            return Err(SceneError::value(
                format!("{place}.temperature"),
                "needs temperatures in K, which are not known; give `gas.gas_constant` (287.05 J/(kg K) of air), or \
                 free_stream.temperature",
            ));
        }
    }
    Ok(())
}

/// Refuses viscosity of particles about an axis, where they have no law for it.
pub(super) fn refuse_viscous_rings<const D: usize>(problem: &Problem<D>) -> Result<(), SceneError> {
    let has_axis = problem.domain.has(|side| side == Side::Axis);
    if problem.gas.is_viscous() && has_axis && problem.method.fixed().is_none() {
        return Err(SceneError::value(
            "gas.viscosity",
            "is felt about an axis by points that stay where they are alone; add `motion = \"fixed\"` to [scheme], or leave it out",
        ));
    }
    Ok(())
}
