//! The aerofoil NACA 0012 in a stream a little slower than sound, whose shocks many have computed.

use aero::run::Keep;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::{Source, scene};
use super::variant::Variant;

const SCENE: Source = scene!("transonic");
const COMPUTED: &str = "AGARD Advisory Report 211, 1985";
/// Ratio of specific heats.
const GAMMA: f64 = 1.4;

/// Chords to either side of a shock that its rise is told by.
const BESIDE: f64 = 0.03;

/// A stream, the box that it is in, and what others have computed of it: the middle of what they say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stream {
    mach: f64,
    /// Degrees.
    incidence: f64,
    /// How far the sides are from the middle of the aerofoil, chords.
    sides: f64,
    lift: f64,
    drag: f64,
    /// Where the shocks above and below end the gas that is faster than sound, chords behind the nose.
    shocks: [f64; 2],
}

/// 0.352 to 0.363 of lift, 0.0222 to 0.0229 of drag; 0.62 to 0.64 and 0.33 to 0.36.
const FIRST: Stream = Stream {
    mach: 0.8,
    incidence: 1.25,
    sides: 5.0,
    lift: 0.3575,
    drag: 0.02255,
    shocks: [0.63, 0.345],
};

/// 0.36 to 0.39 of lift, 0.0576 to 0.0590 of drag.
const SECOND: Stream = Stream {
    mach: 0.85,
    incidence: 1.0,
    sides: 5.0,
    lift: 0.375,
    drag: 0.0583,
    shocks: [0.86, 0.64],
};

pub const TRANSONIC: Comparison<Stream> = Comparison {
    case: "transonic",
    scene: SCENE,
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let settled = Variant::new(200, FIRST).settled();
        let wide = Stream {
            sides: 10.0,
            ..FIRST
        };
        vec![settled.both(), settled.with(wide), settled.with(SECOND)]
    },
    label: |v| {
        let Stream { mach, sides, .. } = v.own;
        format!("M {mach}, sides {sides} chords away, dx c/{}", v.cells)
    },
    settings: |v, spacing| {
        let Stream {
            mach,
            incidence,
            sides,
            ..
        } = v.own;
        vec![
            // The finest of five halvings.
            format!("spacing={:?}", 32.0 * spacing),
            format!("free_stream.mach={mach:?}"),
            format!("free_stream.incidence={incidence:?}"),
            format!("domain.min=[{:?}, {:?}]", 0.5 - sides, -sides),
            format!("domain.max=[{:?}, {sides:?}]", 0.5 + sides),
        ]
    },
    rows,
    pictures: |_| Ok(()),
    together: None,
};

#[allow(clippy::unnecessary_wraps)] // a comparison's rows may fail
fn rows(flow: &Flow<'_, Stream>) -> Result<Vec<Row>, CompareError> {
    let body = &flow.outcome.summary.bodies["aerofoil"];
    let [lift, drag] = [body.cl_mean, body.cd_mean].map(|found| found.unwrap_or(f64::NAN));
    let stream = flow.variant.own;
    let [above, below] = [true, false].map(|is_above| shock(flow, is_above).unwrap_or(f64::NAN));
    Ok(vec![
        Row::relative("lift coefficient", COMPUTED, lift, stream.lift, 5.0),
        Row::relative("drag coefficient", COMPUTED, drag, stream.drag, 7.0),
        Row::absolute(
            "shock above, chords",
            COMPUTED,
            above,
            stream.shocks[0],
            0.02,
        ),
        Row::absolute(
            "shock below, chords",
            COMPUTED,
            below,
            stream.shocks[1],
            0.04,
        ),
        Row::at_most(
            "total pressure before the nose, of the dynamic one, off by",
            "isentropic flow",
            stagnation(flow),
            0.01,
        ),
        flow.no_leaks(),
    ])
}

/// Where the gas on the surface that is faster than sound comes to the speed of sound, chords behind the nose.
fn shock(flow: &Flow<'_, Stream>, is_above: bool) -> Option<f64> {
    let panels = &flow.outcome.panels;
    let mach = flow.variant.own.mach;
    // Of gas that was the stream's, at the speed of sound.
    let ratio = ((1.0 + 0.5 * (GAMMA - 1.0) * mach * mach) / (0.5 * (GAMMA + 1.0)))
        .powf(GAMMA / (GAMMA - 1.0));
    let sonic = 2.0 / (GAMMA * mach * mach) * (ratio - 1.0);
    let on_side = (0..panels.area.len()).filter(|&n| (panels.middle(n)[1] > 0.0) == is_above);
    let mut wall: Vec<[f64; 2]> = on_side
        .map(|n| [panels.middle(n)[0], panels.pressure_coefficient[n]])
        .collect();
    wall.sort_by(|a, b| a[0].total_cmp(&b[0]));
    strongest_end(&wall, sonic)
}

/// Where the coefficient of the pressure on a `wall`, by places along it in order, rises most of where it rises through that of the speed of sound: between the
/// corners of its outline it goes up and down a little.
fn strongest_end(wall: &[[f64; 2]], sonic: f64) -> Option<f64> {
    let mean = |from: f64, to: f64| {
        let within = wall.iter().filter(|one| (from..to).contains(&one[0]));
        let (sum, count) = within.fold((0.0, 0.0), |(sum, count), one| (sum + one[1], count + 1.0));
        sum / count
    };
    let ends = wall.windows(2);
    let crossed = ends.filter(|pair| pair[0][1] < sonic && pair[1][1] >= sonic);
    let places = crossed.map(|pair| {
        let part = (sonic - pair[0][1]) / (pair[1][1] - pair[0][1]);
        let at = pair[0][0] + part * (pair[1][0] - pair[0][0]);
        (at, mean(at, at + BESIDE) - mean(at - BESIDE, at))
    });
    let strongest = places.max_by(|a, b| a.1.total_cmp(&b.1));
    strongest.map(|(at, _)| at)
}

/// How far the pressure that the gas half a chord before the nose would come to rest with is off the stream's, in parts of the dynamic pressure.
fn stagnation(flow: &Flow<'_, Stream>) -> f64 {
    let gas = &flow.outcome.gas;
    let mach = flow.variant.own.mach;
    let rest = |mach: f64| (1.0 + 0.5 * (GAMMA - 1.0) * mach * mach).powf(GAMMA / (GAMMA - 1.0));
    let before = |&i: &usize| {
        let [x, y, _] = gas.position[i];
        (-1.0..-0.5).contains(&x) && y.abs() < 0.5
    };
    let far = (0..gas.kind.len()).filter(before).map(|i| {
        // The stream's pressure is one over the ratio of specific heats.
        let off = GAMMA * gas.pressure[i] * rest(gas.mach[i]) - rest(mach);
        (off / (0.5 * GAMMA * mach * mach)).abs()
    });
    far.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// NACA's four-digit sections, Abbott & von Doenhoff 1959, eq. 6.2, closed at the trailing edge.
    fn half_thickness(x: f64) -> f64 {
        0.6 * (0.2969 * x.sqrt() - 0.1260 * x - 0.3516 * x * x + 0.2843 * x.powi(3)
            - 0.1036 * x.powi(4))
    }

    /// Behind the shock the pressure comes down to that of the speed of sound once more.
    #[test]
    fn a_shock_is_where_the_pressure_rises_most() {
        let wall: Vec<[f64; 2]> = (0..200)
            .map(|n| {
                let x = (f64::from(n) + 0.5) / 200.0;
                let ripple = 0.1 * (-((x - 0.41) / 0.01).powi(2)).exp();
                [x, if x < 0.35 { -0.6 } else { -0.35 - ripple }]
            })
            .collect();
        let found = strongest_end(&wall, -0.43).expect("a shock");
        assert!((found - 0.35).abs() < 0.005, "{found}");
    }

    #[test]
    fn the_scene_has_the_section() {
        for k in 0..=80 {
            let x = 0.5 * (1.0 + (std::f64::consts::PI * f64::from(k) / 80.0).cos());
            let y = half_thickness(x);
            for y in [y, -y] {
                let point = format!("[{x:.6}, {y:.6}]").replace("-0.000000", "0.000000");
                assert!(SCENE.text.contains(&point), "{point}");
            }
        }
    }
}
