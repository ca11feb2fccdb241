//! How the gas is followed: by particles that move with it, or at points that stay where they are.

use std::fmt;

/// What carries the gas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Method {
    /// Particles that move with it, by the equations of a [`Scheme`](crate::scheme::Scheme).
    #[default]
    WithTheGas,
    /// Points that stay where they are, with cells derived from them.
    Fixed(FixedPoints),
}

impl Method {
    /// The points, where they stay.
    pub fn fixed(&self) -> Option<&FixedPoints> {
        match self {
            Self::WithTheGas => None,
            Self::Fixed(points) => Some(points),
        }
    }

    /// True where only the steady flow is wanted.
    pub fn settles(&self) -> bool {
        self.fixed()
            .is_some_and(|points| points.time == Time::Settle)
    }
}

/// How points that stay are placed and how they go through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedPoints {
    /// Whether the way to the end matters.
    pub time: Time,
    /// Where points are added.
    pub refine: Refine,
    /// Courant number of a step where it does.
    pub cfl: f64,
    /// Points that there is memory for: what asks for more is refused, a run that would add more stops. No bound where that is not known.
    pub room: Option<u64>,
}

impl Default for FixedPoints {
    fn default() -> Self {
        Self {
            time: Time::default(),
            refine: Refine::default(),
            cfl: 1.0,
            room: None,
        }
    }
}

/// Whether the flow on the way to the end matters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Time {
    /// It does: steps are bounded by what a sound wave passes.
    #[default]
    Accurate,
    /// Only the steady flow is wanted: implicit steps, as long as they go.
    Settle,
}

/// Where points are added and taken away as the flow asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refine {
    /// To this many halvings of the scene's spacing; zero for points all alike.
    Levels(u8),
    /// To so many halvings where the gas asks for them, and to others around bodies.
    Apart {
        /// Of the flow.
        flow: u8,
        /// Around thin parts of bodies.
        bodies: u8,
        /// Around bent ones: noses and edges.
        bends: u8,
    },
    /// As far as this number of points allows.
    Points(u64),
}

impl Default for Refine {
    fn default() -> Self {
        Self::Levels(0)
    }
}

impl Refine {
    /// Most halvings of the spacing that may be asked for.
    pub const DEEPEST: u8 = 10;

    /// Most halvings where a number of points is asked for, however many there may be.
    pub const DEEPEST_OF_POINTS: u8 = 6;

    /// Halvings of the scene's spacing at most.
    pub fn levels(self) -> u8 {
        self.each().into_iter().fold(0, u8::max)
    }

    /// The number of points that it may take, where one is given.
    pub fn points(self) -> Option<u64> {
        match self {
            Self::Points(points) => Some(points),
            Self::Levels(_) | Self::Apart { .. } => None,
        }
    }

    /// Halvings at most where the gas asks.
    pub fn of_flow(self) -> u8 {
        self.each()[0]
    }

    /// Halvings at most where bodies are thin.
    pub fn of_bodies(self) -> u8 {
        self.each()[1]
    }

    /// Halvings at most where they are bent.
    pub fn of_bends(self) -> u8 {
        self.each()[2]
    }

    /// Of the flow, of thin parts and of bends.
    fn each(self) -> [u8; 3] {
        match self {
            Self::Levels(levels) => [levels; 3],
            Self::Apart {
                flow,
                bodies,
                bends,
            } => [flow, bodies, bends],
            Self::Points(_) => [Self::DEEPEST_OF_POINTS; 3],
        }
    }
}

/// As a scene says it.
impl fmt::Display for Refine {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Levels(levels) => write!(formatter, "{levels}"),
            Self::Apart {
                flow,
                bodies,
                bends,
            } if bends == bodies => {
                write!(formatter, "{{ flow = {flow}, bodies = {bodies} }}")
            }
            Self::Apart {
                flow,
                bodies,
                bends,
            } => write!(
                formatter,
                "{{ flow = {flow}, bodies = {bodies}, bends = {bends} }}"
            ),
            Self::Points(points) => write!(formatter, "{{ points = {points} }}"),
        }
    }
}
