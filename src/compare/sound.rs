//! What open sides send back of a sound that meets them.

use aero::run::Keep;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "nothing comes back: plane simple wave (Toro 2009, section 3.1.3)";
const HELD: &str = "(1 - M) / (1 + M) of a side that holds its total state (linear acoustics)";
/// Half of the rise of the outgoing invariant, as in the scene.
const AMPLITUDE: f64 = 0.0005;
/// The sound, from crest to crest half as long as the duct.
const SHAPE: &str = "sin(4 * pi * (x - 0.5)) * exp(-((x - 0.5) / 0.2)^2)";
/// Its highest rise.
const PEAK: f64 = 0.742;
/// Largest part that may come back, and how near to theory that of a reservoir is.
const ALLOWED: f64 = 0.05;
const ALLOWED_HELD: [f64; 2] = [0.006, 0.03];

/// A side that sound leaves by, in a stream of this Mach number.
#[derive(Clone, Copy, Debug)]
pub struct Exit {
    side: Side,
    mach: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Outlet,
    Inlet,
    Reservoir,
    HeldReservoir,
    /// The one that asks nothing of the flow, which is for gas faster than sound.
    FrozenOutlet,
}

impl Side {
    fn name(self) -> &'static str {
        match self {
            Self::Outlet => "outlet",
            Self::Inlet => "inlet",
            Self::Reservoir => "reservoir that relaxes",
            Self::HeldReservoir => "reservoir",
            Self::FrozenOutlet => "outlet without a pressure",
        }
    }

    /// 1 where the sound goes with the stream, -1 against it.
    fn way(self) -> f64 {
        match self {
            Self::Outlet | Self::FrozenOutlet => 1.0,
            Self::Inlet | Self::Reservoir | Self::HeldReservoir => -1.0,
        }
    }

    fn setting(self) -> Option<&'static str> {
        match self {
            Self::Outlet | Self::Inlet => None,
            Self::Reservoir => Some("domain.sides.x_min={ reservoir = { relaxation = 0.25 } }"),
            Self::HeldReservoir => Some("domain.sides.x_min=\"reservoir\""),
            Self::FrozenOutlet => Some("domain.sides.x_max=\"outlet\""),
        }
    }
}

/// Where sound leaves and comes back.
pub const SOUND: Comparison<Exit> = Comparison {
    case: "sound",
    scene: scene!("sound"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let judged = [
            Side::Outlet,
            Side::Inlet,
            Side::Reservoir,
            Side::HeldReservoir,
        ];
        let mut variants = Vec::new();
        for side in judged.into_iter().chain([Side::FrozenOutlet]) {
            for mach in [0.1, 0.3, 0.6, 0.9] {
                let variant = Variant::new(400, Exit { side, mach });
                let variant = if mach == 0.3 { variant.both() } else { variant };
                let variants_of = [variant, variant.marched()];
                variants.extend(variants_of.map(|variant| {
                    if side == Side::FrozenOutlet {
                        variant.shown()
                    } else {
                        variant
                    }
                }));
            }
        }
        variants
    },
    label: |v| {
        format!(
            "{}, M {}, {}",
            v.own.side.name(),
            v.own.mach,
            v.scheme.laws()
        )
    },
    settings: |v, _| {
        let Exit { side, mach } = v.own;
        let way = side.way();
        let there = 0.5 / (1.0 + way * mach);
        let back = 0.4 / (1.0 - way * mach);
        let wave = format!("{AMPLITUDE} * {SHAPE}");
        let mut settings = vec![
            format!("free_stream.mach={mach}"),
            format!("end_time={:?}", there + back),
            format!(
                "initial.field.velocity=[\"{mach} + {} * {wave}\"]",
                2.0 * way
            ),
        ];
        settings.extend(side.setting().map(str::to_owned));
        settings
    },
    rows,
    pictures: |_| Ok(()),
    together: None,
};

#[allow(clippy::unnecessary_wraps)] // a comparison's rows may fail
fn rows(flow: &Flow<'_, Exit>) -> Result<Vec<Row>, CompareError> {
    let Exit { side, mach } = flow.variant.own;
    let gas = &flow.outcome.gas;
    let back = (0..gas.kind.len()).map(|i| {
        let sound = gas.velocity[i][0] / gas.mach[i];
        let sound = if sound.is_finite() { sound } else { f64::NAN };
        (gas.velocity[i][0] - mach - side.way() * 5.0 * (sound - 1.0)).abs()
    });
    let back = back.fold(0.0, f64::max) / (4.0 * AMPLITUDE * PEAK);
    let what = "part of a sound that comes back";
    Ok(vec![if side == Side::HeldReservoir {
        let theory = (1.0 - mach) / (1.0 + mach);
        Row::absolute(what, HELD, back, theory, ALLOWED_HELD)
    } else {
        Row::at_most(what, THEORY, back, ALLOWED)
    }])
}
