//! How the gas is followed: by particles that move with it, or at points that stay where they are.

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
}

impl Default for FixedPoints {
    fn default() -> Self {
        Self {
            time: Time::default(),
            refine: Refine::default(),
            cfl: 0.8,
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
    /// To so many halvings where the gas asks for them, and to others around thin and bent parts of bodies.
    Apart {
        /// Of the flow.
        flow: u8,
        /// Of bodies.
        bodies: u8,
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
    /// Most halvings of the spacing, however many points there may be.
    pub const DEEPEST: u8 = 6;

    /// Halvings of the scene's spacing at most.
    pub fn levels(self) -> u8 {
        self.of_flow().max(self.of_bodies())
    }

    /// Halvings at most where the gas asks.
    pub fn of_flow(self) -> u8 {
        match self {
            Self::Levels(levels) | Self::Apart { flow: levels, .. } => levels,
            Self::Points(_) => Self::DEEPEST,
        }
    }

    /// Halvings at most where bodies ask.
    pub fn of_bodies(self) -> u8 {
        match self {
            Self::Levels(levels) | Self::Apart { bodies: levels, .. } => levels,
            Self::Points(_) => Self::DEEPEST,
        }
    }
}
