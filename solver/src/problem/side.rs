//! What bounds the domain on one side, as a problem names it.

use std::fmt;

use super::WallKind;

/// What bounds the domain on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Buffer of free-stream particles that turn into fluid when they enter.
    Inlet,
    /// Inlet at less than the speed of sound that lets sound out: only the entropy, the velocity along the side and the wave that
    /// comes in are the free stream's.
    SoftInlet,
    /// Particles that cross freeze their state, drift on and are removed.
    Outlet,
    /// Outlet that holds a pressure where gas leaves slower than sound, and lets sound out.
    HeldOutlet {
        /// The pressure.
        pressure: f64,
        /// How fast it is gone back to, against the time that sound takes through the domain: `sigma` of Poinsot & Lele 1992.
        relaxation: f64,
    },
    /// Buffer of free-stream particles along a side that the flow does not disturb. Of points that stay the stream beyond it, into which waves of
    /// one faster than sound leave along Mach lines.
    FreeStream,
    /// Inlet at less than the speed of sound, from a reservoir at the free stream's stagnation state:
    /// the flow inside decides how fast the gas enters.
    Reservoir {
        /// How fast it goes back to that state after sound has left through it, as of an outlet; none where it holds it.
        relaxation: Option<f64>,
    },
    /// Mirror plane.
    Symmetry,
    /// The axis that an axisymmetric flow is the same all around.
    Axis,
    /// Joined to the opposite side.
    Periodic,
    /// Plane wall.
    Wall {
        /// Slip or no slip.
        kind: WallKind,
        /// Velocity along the axis at the start.
        velocity: f64,
        /// Constant acceleration along the axis.
        acceleration: f64,
    },
    /// Closed by a body that covers it.
    Body,
}

impl Side {
    /// Those that a word tells all of.
    pub const WORDS: [(&str, Self); 9] = [
        ("inlet", Self::Inlet),
        ("outlet", Self::Outlet),
        ("free-stream", Self::FreeStream),
        ("reservoir", Self::Reservoir { relaxation: None }),
        ("symmetry", Self::Symmetry),
        ("axis", Self::Axis),
        ("periodic", Self::Periodic),
        ("wall", Self::WALL),
        ("body", Self::Body),
    ];

    /// A wall at rest that gas slips along.
    pub const WALL: Self = Self::Wall {
        kind: WallKind::Slip,
        velocity: 0.0,
        acceleration: 0.0,
    };

    /// The one that a word names.
    pub fn named(word: &str) -> Option<Self> {
        let named = Self::WORDS.into_iter().find(|(name, _)| *name == word);
        named.map(|(_, side)| side)
    }

    /// True where the flow beyond is the mirror image of the flow within.
    pub fn is_mirror(self) -> bool {
        matches!(self, Self::Symmetry | Self::Axis)
    }

    /// True of one that is joined to the opposite side.
    pub fn is_periodic(self) -> bool {
        self == Self::Periodic
    }

    /// True of one that lets gas in or out.
    pub fn is_open(self) -> bool {
        self.lets_in() || self.lets_out()
    }

    /// How gas crosses it. Whatever asks of a new side finds it here first: nothing of it goes by default.
    const fn crossing(self) -> Crossing {
        match self {
            Self::Inlet | Self::SoftInlet | Self::Reservoir { .. } => Crossing::In,
            Self::FreeStream => Crossing::InAndOut,
            Self::Outlet | Self::HeldOutlet { .. } => Crossing::Out,
            Self::Symmetry | Self::Axis | Self::Periodic | Self::Wall { .. } | Self::Body => {
                Crossing::None
            }
        }
    }

    /// True of one that gas only leaves through.
    pub fn lets_out(self) -> bool {
        self.crossing() == Crossing::Out
    }

    /// True of one that gas enters through, in a state that is prescribed or follows from a reservoir.
    pub fn lets_in(self) -> bool {
        matches!(self.crossing(), Crossing::In | Crossing::InAndOut)
    }

    /// True of one with gas at rest beyond it.
    pub fn is_reservoir(self) -> bool {
        matches!(self, Self::Reservoir { .. })
    }

    /// True of one that holds a pressure, or a total one, and throws back what sound does to it in part.
    pub fn holds_pressure(self) -> bool {
        self.waves() == Waves::Held
    }

    /// True of one that follows the waves of one ideal gas.
    pub fn follows_waves(self) -> bool {
        self.waves() != Waves::None
    }

    /// What of waves it follows; as of [`Self::crossing`], nothing of a new side goes by default.
    const fn waves(self) -> Waves {
        match self {
            Self::Reservoir { .. } | Self::HeldOutlet { .. } => Waves::Held,
            Self::SoftInlet => Waves::Followed,
            Self::Inlet
            | Self::Outlet
            | Self::FreeStream
            | Self::Symmetry
            | Self::Axis
            | Self::Periodic
            | Self::Wall { .. }
            | Self::Body => Waves::None,
        }
    }

    /// True of one that the free stream comes in by.
    pub fn is_inlet(self) -> bool {
        matches!(self, Self::Inlet | Self::SoftInlet)
    }

    /// True of one that keeps the free stream up, whatever the flow inside does.
    pub fn keeps_free_stream(self) -> bool {
        matches!(self, Self::Inlet | Self::FreeStream)
    }

    /// True of a plane wall.
    pub fn is_wall(self) -> bool {
        matches!(self, Self::Wall { .. })
    }
}

/// How gas crosses a side.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Crossing {
    In,
    Out,
    InAndOut,
    None,
}

/// What a side follows of the waves of one ideal gas.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Waves {
    /// All of them, back to a pressure that it holds, or a total one.
    Held,
    /// Those that go out.
    Followed,
    None,
}

/// What it does to the gas, in words.
impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inlet => write!(f, "the free stream comes in"),
            Self::SoftInlet => write!(f, "the free stream comes in, and sound goes out"),
            Self::Outlet => write!(f, "gas leaves as it is"),
            Self::HeldOutlet { pressure, .. } => write!(
                f,
                "gas leaves, at a pressure of {pressure} where it is slower than sound"
            ),
            Self::FreeStream => write!(f, "the free stream goes along or across"),
            Self::Reservoir { .. } => {
                write!(f, "gas comes in from rest at the stream's total state")
            }
            Self::Symmetry => write!(f, "a mirror"),
            Self::Axis => write!(f, "the axis that the flow is the same around"),
            Self::Periodic => write!(f, "goes on at the opposite side"),
            Self::Wall { velocity, .. } if *velocity != 0.0 => {
                write!(f, "a wall that moves at {velocity}")
            }
            Self::Wall { .. } => write!(f, "a wall"),
            Self::Body => write!(f, "closed by a body"),
        }
    }
}
