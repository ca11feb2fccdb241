//! A flow problem: checked, in SI or stated units, with bodies packed.

use std::sync::Arc;

use aero_geometry::Vector;

pub use super::sides::{Domain, Side};
pub use super::walls::{Body, Motion, PackedFluid, Turning, WallKind};

use crate::gas::Gas;
use crate::method::Method;

/// A flow problem ready to run, in `D` dimensions.
#[derive(Clone, Debug)]
pub struct Problem<const D: usize> {
    /// Particle spacing `dx` of the undisturbed lattice.
    pub spacing: f64,
    /// Equation of state.
    pub gas: Gas,
    /// What carries the gas.
    pub method: Method,
    /// Equations and boundary treatment of particles.
    pub scheme: Scheme,
    /// Box of the flow and what bounds it.
    pub domain: Domain<D>,
    /// Undisturbed state: inlets, free-stream sides, reference of all coefficients.
    pub free_stream: State<D>,
    /// State at the start.
    pub initial: Initial<D>,
    /// Random displacement of the starting lattice inside the domain, as a fraction of the
    /// spacing; zero for a perfect lattice.
    pub disorder: f64,
    /// Bodies in the flow.
    pub bodies: Vec<Body<D>>,
}

/// Density, velocity and pressure at a point.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct State<const D: usize> {
    /// Density.
    pub density: f64,
    /// Velocity.
    pub velocity: Vector<D>,
    /// Pressure.
    pub pressure: f64,
}

/// State of the gas at the start.
#[derive(Clone, Debug)]
pub enum Initial<const D: usize> {
    /// The free stream everywhere.
    FreeStream,
    /// Two states on either side of a plane `x = position`.
    Riemann {
        /// State at `x < position`.
        left: State<D>,
        /// State at `x > position`.
        right: State<D>,
        /// Position of the diaphragm on the first axis.
        position: f64,
        /// Smooth density and pressure over a few spacings (Villodi & Ramachandran, eq. 38).
        smooth: bool,
    },
    /// Any state as a function of position.
    Field(Field<D>),
}

/// A state of the gas as a function of position.
#[derive(Clone)]
pub struct Field<const D: usize>(pub Arc<dyn Fn(&Vector<D>) -> State<D> + Send + Sync>);

impl<const D: usize> std::fmt::Debug for Field<D> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Field")
    }
}

/// The set of equations that advances the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equations {
    /// The scheme of the paper, equations (5)-(17) and (19)-(23), misprints corrected.
    Paper,
    /// Its conservative successor: pairwise conduction, density read off the particles.
    Conservative,
}

/// How ghosts get the state of the gas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extrapolation {
    /// Without ghost mirrors: Shepard interpolation at the ghost.
    Wom,
    /// With ghost mirrors: first-order consistent interpolation at the mirror point.
    Wm,
}

/// In what numbers the arithmetic of a pair of particles is done; all else is `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// In `f64`.
    Double,
    /// In `f32`: faster, with noise of about a part in a million.
    Mixed,
}

/// Equations and boundary treatment.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::struct_excessive_bools)] // switches that do not depend on each other
pub struct Scheme {
    /// Set of equations.
    pub equations: Equations,
    /// How ghosts get their state.
    pub extrapolation: Extrapolation,
    /// Penetration shield through the transport velocity.
    pub shield: bool,
    /// Particles are shifted towards even spacing through the transport velocity.
    pub shifting: bool,
    /// Ghost volumes stay constant; false only to show what happens otherwise.
    pub constant_ghost_volume: bool,
    /// The artificial viscosity leaves flow alone that varies linearly; conservative scheme only.
    pub limited_viscosity: bool,
    /// Spare what varies smoothly the artificial conduction; of the conservative scheme only.
    pub limited_conduction: bool,
    /// Gas on one side of a thin part feels neither gas nor ghosts of the other side.
    pub surface_tags: bool,
    /// The undisturbed free stream is moved on without pair sums.
    pub skip_undisturbed: bool,
    /// In what numbers pairs are computed.
    pub precision: Precision,
    /// Courant number `C_CFL` [Villodi & Ramachandran 2024, eq. 33; 0.5 in section 3.4].
    pub cfl: f64,
}

impl Default for Scheme {
    /// What a scene gets that names nothing.
    fn default() -> Self {
        Self {
            equations: Equations::Conservative,
            extrapolation: Extrapolation::Wom,
            shield: false,
            shifting: false,
            constant_ghost_volume: true,
            limited_viscosity: true,
            limited_conduction: true,
            surface_tags: true,
            skip_undisturbed: true,
            precision: Precision::Double,
            cfl: 0.5,
        }
    }
}
