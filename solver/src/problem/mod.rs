//! A flow problem: checked, in SI or stated units, with bodies packed.

use std::sync::Arc;

use aero_geometry::Vector;

mod body;
mod domain;
mod opening;
mod resolution;
mod second;
mod side;
mod source;
mod wall;

pub use body::{Body, Freedom, Motion, PackedFluid, Turning};
pub use domain::{AXES, Domain, side_name};
pub use opening::{Given, Opening};
pub use resolution::Resolution;
pub use second::SecondGas;
pub use side::Side;
pub use source::{Added, BodyForce, Source};
pub use wall::{NoSlip, Slide, WallHeat, WallKind};

use crate::gas::{Gas, Gases};
use crate::method::Method;
pub use crate::scheme::Scheme;

/// A flow problem ready to run, in `D` dimensions.
#[derive(Clone, Debug)]
pub struct Problem<const D: usize> {
    /// How finely the gas is resolved.
    pub resolution: Resolution,
    /// Equation of state.
    pub gas: Gas,
    /// A second gas, and where it is at the start.
    pub second: Option<SecondGas<D>>,
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
    /// What is added to the equations, if anything.
    pub source: Option<Arc<dyn Source<D>>>,
}

impl<const D: usize> Problem<D> {
    /// Gas that is at `free_stream` everywhere in `domain`, in particles `spacing` apart and with no body in it.
    pub fn new(gas: Gas, domain: Domain<D>, free_stream: State<D>, spacing: f64) -> Self {
        Self {
            resolution: Resolution::uniform(spacing),
            gas,
            second: None,
            method: Method::default(),
            scheme: Scheme::default(),
            domain,
            free_stream,
            initial: Initial::FreeStream,
            disorder: 0.0,
            bodies: Vec::new(),
            source: None,
        }
    }

    /// The gases, for whatever knows which of them it looks at.
    pub fn gases(&self) -> Gases {
        Gases {
            first: self.gas,
            second: self.second.as_ref().map(|second| second.gas),
        }
    }

    /// Mach number of the free stream.
    pub fn stream_mach(&self) -> f64 {
        let stream = &self.free_stream;
        let sound = self.gas.sound_speed_at(stream.density, stream.pressure);
        stream.velocity.norm() / sound
    }

    /// True where all gas that comes in has the total enthalpy of the free stream, and nothing gives it more on its way.
    pub fn has_one_enthalpy(&self) -> bool {
        let mut openings = self.domain.openings.iter();
        self.source.is_none()
            && openings.all(|opening| opening.given.is_none() || !opening.side.lets_in())
    }
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

impl<const D: usize> State<D> {
    /// Gas at rest.
    pub fn at_rest(density: f64, pressure: f64) -> Self {
        Self {
            density,
            velocity: Vector::zeros(),
            pressure,
        }
    }
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
    /// Where an earlier run came to.
    Earlier(Earlier<D>),
}

/// The flow of an earlier run.
#[derive(Clone, Debug)]
pub struct Earlier<const D: usize> {
    /// Its state.
    pub field: Field<D>,
    /// Spacing of the lattice of its points, if they stayed.
    pub spacing: Option<f64>,
    /// Points of cells that were split off that lattice. A flow that settles on the same lattice starts with cells split there.
    pub split: Arc<[Split<D>]>,
}

/// A point of a cell that was split off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split<const D: usize> {
    /// Where it is.
    pub point: Vector<D>,
    /// How often a cell of the lattice was split for it.
    pub level: u8,
}

/// A state of the gas as a function of position.
#[derive(Clone)]
pub struct Field<const D: usize>(pub Arc<dyn Fn(&Vector<D>) -> State<D> + Send + Sync>);

impl<const D: usize> std::fmt::Debug for Field<D> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Field")
    }
}
