//! What gas and heat do at a wall, as a scene says it of sides and bodies.

use std::fmt;

use aero_geometry::Vector;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::error::SceneError;
use super::motion::rotation;
use super::number::{Finite, Positive};
use super::spin::Rate;
use super::vector::{AXES, vector};
use aero_solver::problem::{NoSlip, Problem, Side, Slide, WallHeat, WallKind};

/// Slip or no slip, as a scene spells it.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum WallWord {
    /// The gas slides along the wall.
    #[default]
    Slip,
    /// The gas sticks to the wall.
    NoSlip,
}

/// `"slip"`, `"no-slip"`, or a table that says more of a wall that gas sticks to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodyWallEntry(pub WallTable);

/// `wall = { kind = "no-slip", .. }`
#[derive(Clone, Debug, Default, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct WallTable {
    /// Whether the gas slides along it; `slip` unless given.
    pub kind: Option<WallWord>,
    /// Temperature of the wall, K; heat goes through no wall that says neither this nor a flux.
    pub temperature: Option<Positive>,
    /// Heat that goes from the wall into the gas, W/m^2, in place of a temperature.
    pub heat_flux: Option<Finite>,
    /// Velocity of its surface along itself; none unless given.
    pub velocity: Option<Vec<Finite>>,
    /// Angular velocity of its surface, rad/s: a number in 2D, a vector in 3D; none unless given.
    pub angular_velocity: Option<Rate>,
    /// Point that its surface turns about; the moment centre unless given.
    pub pivot: Option<Vec<Finite>>,
}

/// Velocity of a plane wall: a number along its axis, or a vector.
#[derive(Clone, Debug, PartialEq)]
pub enum WallVelocity {
    /// Along the axis, into the gas or out of it.
    Across(f64),
    /// As a vector, whose part along the plane is that of the surface.
    Vector(Vec<Finite>),
}

impl<'de> Deserialize<'de> for BodyWallEntry {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(WallVisitor)
    }
}

impl<'de> Deserialize<'de> for WallVelocity {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        deserializer.deserialize_any(VelocityVisitor)
    }
}

// Both are read by hand because serde's `untagged` would lose the position of an error in the file.

struct WallVisitor;

impl<'de> Visitor<'de> for WallVisitor {
    type Value = BodyWallEntry;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("`slip`, `no-slip`, or a table `{ kind = \"no-slip\", temperature = .. }`")
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<BodyWallEntry, E> {
        let kind = match word {
            "slip" => WallWord::Slip,
            "no-slip" => WallWord::NoSlip,
            _ => return Err(E::unknown_variant(word, &["slip", "no-slip"])),
        };
        Ok(BodyWallEntry(WallTable {
            kind: Some(kind),
            ..WallTable::default()
        }))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<BodyWallEntry, A::Error> {
        WallTable::deserialize(MapAccessDeserializer::new(map)).map(BodyWallEntry)
    }
}

struct VelocityVisitor;

impl<'de> Visitor<'de> for VelocityVisitor {
    type Value = WallVelocity;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a velocity along the axis, or a list of one per axis")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<WallVelocity, E> {
        let value = Finite::try_from(value).map_err(E::custom)?;
        Ok(WallVelocity::Across(value.get()))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<WallVelocity, E> {
        Ok(WallVelocity::Across(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<WallVelocity, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(list)).map(WallVelocity::Vector)
    }
}

/// The kind of a wall, but for how its surface moves.
pub(super) fn kind(
    word: Option<WallWord>,
    temperature: Option<Positive>,
    heat_flux: Option<Finite>,
) -> Result<WallKind, &'static str> {
    let heat = match (temperature, heat_flux) {
        (None, None) => WallHeat::Adiabatic,
        (Some(temperature), None) => WallHeat::Temperature(temperature.get()),
        (None, Some(flux)) => WallHeat::Flux(flux.get()),
        (Some(_), Some(_)) => return Err("give one of temperature and heat_flux"),
    };
    match word.unwrap_or_default() {
        WallWord::NoSlip => Ok(WallKind::NoSlip(NoSlip {
            heat,
            slide: Slide::default(),
        })),
        WallWord::Slip if heat == WallHeat::Adiabatic => Ok(WallKind::Slip),
        WallWord::Slip => {
            Err("heat goes through walls that gas sticks to; add `kind = \"no-slip\"`")
        }
    }
}

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
        Side::Wall { kind, .. } => Some((side_name(axis, end), kind)),
        _ => None,
    });
    for (place, kind) in bodies.chain(sides) {
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

fn side_name(axis: usize, end: usize) -> String {
    format!("domain.sides.{}_{}", AXES[axis], ["min", "max"][end])
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
