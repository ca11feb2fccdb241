//! Problems with the scheme, the sides and the bodies that the tests ask for.

use std::sync::Arc;

use aero_geometry::{Shape, Vector};
use aero_packer::{Ghosts, PackReport};
use nalgebra::Vector3;

use super::super::reference::{Conduction, Laws, Map, SECOND, Transport, Viscous};
use crate::gas::{self, Gas};
use crate::lattice;
use crate::problem::{Body, Motion, Problem, SecondGas, Side, Turning, WallKind};
use crate::scheme::{Extrapolation, ReturnOfShift, Scheme};

/// What a scheme is made of, as far as the tests choose it.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::struct_excessive_bools)] // switches that do not depend on each other
pub struct Setup {
    pub published: bool,
    pub mirrors: bool,
    pub shield: bool,
    pub shifting: bool,
    pub return_of_shift: ReturnOfShift,
    pub limits_viscosity: bool,
    pub limits_conduction: bool,
    pub viscous: bool,
    pub two_gases: bool,
}

/// Viscosity and conduction of viscous gas.
const VISCOUS: Viscous = Viscous {
    viscosity: 0.3,
    exponent: 0.7,
    prandtl: 0.72,
};

/// The default scheme.
pub const DEFAULT: Setup = Setup {
    published: false,
    mirrors: false,
    shield: false,
    shifting: false,
    return_of_shift: ReturnOfShift::Exchange,
    limits_viscosity: true,
    limits_conduction: true,
    viscous: false,
    two_gases: false,
};

/// The published scheme.
pub const PUBLISHED: Setup = Setup {
    published: true,
    return_of_shift: ReturnOfShift::Advection,
    ..DEFAULT
};

impl Setup {
    /// `problem` with this scheme; all sums in full.
    pub fn of<const D: usize>(self, mut problem: Problem<D>) -> Problem<D> {
        let scheme = &mut problem.scheme;
        *scheme = if self.published {
            Scheme::PAPER
        } else {
            Scheme::CONSERVATIVE
        };
        scheme.wall.extrapolation = if self.mirrors {
            Extrapolation::Wm
        } else {
            Extrapolation::Wom
        };
        scheme.transport_velocity.shield = self.shield;
        scheme.transport_velocity.shifting = self.shifting;
        scheme.transport_velocity.return_of_shift = self.return_of_shift;
        scheme.limit_viscosity(self.limits_viscosity);
        scheme.limit_conduction(self.limits_conduction);
        scheme.skip_undisturbed = false;
        if self.two_gases {
            problem.second = Some(SecondGas {
                gas: Gas::ideal(SECOND),
                fills: Arc::new(|position| (9.0 * position.sum()).sin() > 0.0),
                density: None,
            });
        }
        if self.viscous {
            *scheme = scheme.of_viscous_gas();
            let Gas::Ideal(gas) = &mut problem.gas else {
                unreachable!("these problems are of an ideal gas")
            };
            gas.transport = Some(gas::Transport {
                viscosity: gas::Viscosity::Power {
                    viscosity: VISCOUS.viscosity,
                    temperature: 1.0,
                    exponent: VISCOUS.exponent,
                },
                prandtl: VISCOUS.prandtl,
            });
        }
        problem
    }

    /// How pairs conduct heat.
    pub fn conduction(self) -> Conduction {
        match (self.published, self.limits_conduction, self.viscous) {
            (true, ..) => Conduction::ByVolume,
            (_, false, _) => Conduction::Pairwise,
            (_, _, true) => Conduction::InShocks,
            _ => Conduction::Limited,
        }
    }

    /// The laws that the reference is to sum.
    pub fn laws(self) -> Laws {
        Laws {
            published: self.published,
            limits_viscosity: self.limits_viscosity,
            conduction: self.conduction(),
            viscous: self.viscous.then_some(VISCOUS),
            transport: match (self.shifting, self.return_of_shift) {
                (true, ReturnOfShift::Exchange) => Transport::Exchange,
                (false, _) if !self.shield => Transport::None,
                _ => Transport::Advection,
            },
        }
    }
}

/// What symmetry planes and periodic sides do to the places on each axis.
pub fn maps<const D: usize>(problem: &Problem<D>) -> [Vec<Map>; D] {
    let domain = &problem.domain;
    std::array::from_fn(|axis| {
        let (low, high) = (domain.bounds.min[axis], domain.bounds.max[axis]);
        let map = |side: Side, plane: f64, period: f64| match side {
            Side::Symmetry | Side::Axis => Some((-1.0, 2.0 * plane)),
            Side::Periodic => Some((1.0, period)),
            _ => None,
        };
        let [lower, upper] = domain.sides[axis];
        let both = [map(lower, low, high - low), map(upper, high, low - high)];
        both.into_iter().flatten().collect()
    })
}

/// Distance to the nearest open side.
pub fn room<const D: usize>(problem: &Problem<D>, position: &Vector<D>) -> f64 {
    let bounds = &problem.domain.bounds;
    let open = |side| matches!(side, Side::Inlet | Side::Outlet | Side::FreeStream);
    let mut room = f64::INFINITY;
    for (axis, [low, high]) in problem.domain.sides.iter().enumerate() {
        if open(*low) {
            room = room.min(position[axis] - bounds.min[axis]);
        }
        if open(*high) {
            room = room.min(bounds.max[axis] - position[axis]);
        }
    }
    room
}

/// Lets `body` turn at `rate` about `pivot`, which moves as told.
pub fn turn<const D: usize>(
    body: &mut Body<D>,
    rate: Vector3<f64>,
    pivot: Vector<D>,
    [velocity, acceleration]: [Vector<D>; 2],
) {
    body.motion = Motion {
        velocity,
        acceleration,
        turning: Turning::Steady(rate),
        pivot,
        free: None,
    };
}

/// A slippery body at rest whose ghosts lie on the lattice of `problem`, five layers deep, as far as the domain holds
/// them.
pub fn body_on_the_lattice<const D: usize>(
    problem: &Problem<D>,
    shape: Arc<dyn Shape<D>>,
) -> Body<D> {
    let (spacing, bounds) = (problem.resolution.lattice(), &problem.domain.bounds);
    let mut ghosts = Ghosts::default();
    let cells = bounds.size().map(|size| (size / spacing).round() as i64);
    for index in lattice::points([0; D], cells.into()) {
        let position = lattice::position(&bounds.min, spacing, &index);
        let surface = shape.closest(&position);
        if surface.distance > 0.0 || surface.distance < -5.0 * spacing {
            continue;
        }
        ghosts.position.push(position);
        ghosts.normal.push(surface.normal);
        ghosts.distance.push(surface.distance);
        ghosts.volume.push(spacing.powi(D as i32));
        let layer = (-surface.distance / spacing).floor();
        ghosts.layer.push(layer as u32);
        ghosts.face.push(surface.face);
    }
    Body {
        name: "body".into(),
        shape,
        wall: WallKind::Slip,
        motion: Motion::none(),
        ghosts,
        packed_fluid: None,
        report: PackReport {
            spacing,
            ..PackReport::default()
        },
        reference_area: 1.0,
        reference_length: 1.0,
        moment_centre: Vector::zeros(),
    }
}
