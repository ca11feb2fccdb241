//! The variants of a comparison: which runs there are, and at which level.

use super::context::Level;

/// One run of a comparison's scene. `P` is what the case varies beside spacing and scheme.
#[derive(Clone, Copy, Debug)]
pub struct Variant<P = ()> {
    /// When it is run.
    pub levels: Levels,
    /// Spacings to the comparison's length.
    pub cells: u32,
    /// By which scheme.
    pub scheme: Scheme,
    /// False where the rows are shown for comparison alone.
    pub is_judged: bool,
    /// The case's own.
    pub own: P,
}

/// At which levels a variant is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levels {
    /// At the quick one.
    Quick,
    /// At the full one.
    Full,
    /// At either.
    Both,
}

impl Levels {
    /// True if a variant of these levels is run at `level`.
    pub fn contain(self, level: Level) -> bool {
        match self {
            Self::Quick => level == Level::Quick,
            Self::Full => level == Level::Full,
            Self::Both => true,
        }
    }
}

/// What every case can vary of the scheme: a further axis is a field here, its setting and its word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scheme {
    /// `scheme.equations`.
    pub equations: &'static str,
    /// `scheme.extrapolation`.
    pub extrapolation: &'static str,
    /// `scheme.motion`.
    pub motion: Motion,
}

/// What carries the gas, and how it goes through time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Particles.
    WithTheGas,
    /// Points that stay, marched to the end of the scene.
    Marched,
    /// Points that stay, settled.
    Settled,
}

impl Scheme {
    /// What scenes have unless they say otherwise.
    pub const USUAL: Self = Self {
        equations: "conservative",
        extrapolation: "wom",
        motion: Motion::WithTheGas,
    };

    /// The same with ghost mirrors.
    #[must_use]
    pub const fn wm(self) -> Self {
        Self {
            extrapolation: "wm",
            ..self
        }
    }

    /// The same of the published equations.
    #[must_use]
    pub const fn paper(self) -> Self {
        Self {
            equations: "paper",
            ..self
        }
    }

    /// About points that stay.
    #[must_use]
    pub const fn by_points(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    /// True where no particles move: `scheme.equations` and the like are not theirs.
    pub fn is_of_points(self) -> bool {
        self.motion != Motion::WithTheGas
    }

    /// True for the project's own equations, whose errors are judged.
    pub fn is_conservative(self) -> bool {
        self.equations == Self::USUAL.equations
    }

    /// What it sets in a scene.
    pub fn settings(self) -> Vec<String> {
        match self.motion {
            Motion::WithTheGas => vec![
                format!("scheme.equations={}", self.equations),
                format!("scheme.extrapolation={}", self.extrapolation),
            ],
            Motion::Marched => vec!["scheme.motion=fixed".into()],
            Motion::Settled => vec!["scheme.motion=fixed".into(), "stop=steady".into()],
        }
    }

    /// What is said of it where all variants have the same equations.
    pub const fn brief(self) -> &'static str {
        match self.motion {
            Motion::WithTheGas => self.extrapolation,
            Motion::Marched => "points, marched",
            Motion::Settled => "points, settled",
        }
    }
}

impl Scheme {
    /// What is said of it where extrapolations play no part.
    pub const fn laws(self) -> &'static str {
        match self.motion {
            Motion::WithTheGas => self.equations,
            Motion::Marched | Motion::Settled => self.brief(),
        }
    }
}

impl std::fmt::Display for Scheme {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.is_of_points() {
            return f.write_str(self.brief());
        }
        write!(f, "{} {}", self.equations, self.extrapolation)
    }
}

impl<P: Copy> Variant<P> {
    /// The usual scheme at the full level, judged.
    pub const fn new(cells: u32, own: P) -> Self {
        Self {
            levels: Levels::Full,
            cells,
            scheme: Scheme::USUAL,
            is_judged: true,
            own,
        }
    }

    /// The same at the quick level.
    pub const fn quick(self) -> Self {
        Self {
            levels: Levels::Quick,
            ..self
        }
    }

    /// The same at either level.
    pub const fn both(self) -> Self {
        Self {
            levels: Levels::Both,
            ..self
        }
    }

    /// The same with so many spacings to the length.
    pub const fn cells(self, cells: u32) -> Self {
        Self { cells, ..self }
    }

    /// The same with ghost mirrors.
    #[must_use]
    pub const fn wm(self) -> Self {
        Self {
            scheme: self.scheme.wm(),
            ..self
        }
    }

    /// The same by the published equations, for comparison alone.
    #[must_use]
    pub const fn paper(self) -> Self {
        Self {
            scheme: self.scheme.paper(),
            is_judged: false,
            ..self
        }
    }

    /// The same about points that stay, marched.
    pub const fn marched(self) -> Self {
        Self {
            scheme: self.scheme.by_points(Motion::Marched),
            ..self
        }
    }

    /// The same about points that stay, settled.
    pub const fn settled(self) -> Self {
        Self {
            scheme: self.scheme.by_points(Motion::Settled),
            ..self
        }
    }

    /// The same for comparison alone.
    pub const fn shown(self) -> Self {
        Self {
            is_judged: false,
            ..self
        }
    }

    /// The same with other values of what the case varies.
    pub const fn with(self, own: P) -> Self {
        Self { own, ..self }
    }
}
