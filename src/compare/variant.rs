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
}

impl Scheme {
    /// What scenes have unless they say otherwise.
    pub const USUAL: Self = Self {
        equations: "conservative",
        extrapolation: "wom",
    };

    /// The same with ghost mirrors.
    pub const fn wm(self) -> Self {
        Self {
            extrapolation: "wm",
            ..self
        }
    }

    /// The same of the published equations.
    pub const fn paper(self) -> Self {
        Self {
            equations: "paper",
            ..self
        }
    }

    /// True for the project's own equations, whose errors are judged.
    pub fn is_conservative(self) -> bool {
        self.equations == Self::USUAL.equations
    }

    /// What it sets in a scene.
    pub fn settings(self) -> [String; 2] {
        [
            format!("scheme.equations={}", self.equations),
            format!("scheme.extrapolation={}", self.extrapolation),
        ]
    }

    /// What is said of it where all variants have the same equations.
    pub const fn brief(self) -> &'static str {
        self.extrapolation
    }
}

impl std::fmt::Display for Scheme {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
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
    pub const fn wm(self) -> Self {
        Self {
            scheme: self.scheme.wm(),
            ..self
        }
    }

    /// The same by the published equations, for comparison alone.
    pub const fn paper(self) -> Self {
        Self {
            scheme: self.scheme.paper(),
            is_judged: false,
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
