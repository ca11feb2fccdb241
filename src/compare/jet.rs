//! A round jet from a sonic nozzle into still air at an eighth of its pressure: where its Mach disc stands, and whether air comes in to it.

use aero::run::Keep;
use aero_solver::frame::{Frame, Kind};

use super::comparison::{Comparison, Flow};
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const DISC: &str = "0.67 (p0 / p)^(1/2) (Ashkenas & Sherman 1966), experiments";
const GAMMA: f64 = 1.4;
/// As in the scene: pressure in the nozzle over that of the air, and the Mach number there.
const PRESSURE: f64 = 8.0;
const MACH: f64 = 1.008;
/// Gas nearer to the axis than this is in front of the Mach disc, or behind it.
const AXIS: f64 = 0.2;
/// Gas farther from the axis than this is air around the jet.
const AIR: f64 = 2.0;

pub const JET: Comparison = Comparison {
    case: "jet",
    scene: scene!("jet-underexpanded"),
    length: 1.0,
    keep: Keep::Frames,
    variants: || {
        let points = Variant::new(10, ()).marched();
        vec![
            points.both(),
            points.cells(20),
            points.cells(40),
            Variant::new(20, ()),
        ]
    },
    label: |v| format!("p / p1 {PRESSURE}, dx D/{}, {}", v.cells, v.scheme.laws()),
    settings: |v, _| {
        let is_of_points = v.scheme.is_of_points();
        let motion = (!is_of_points).then(|| "scheme.motion=with-the-gas".into());
        motion.into_iter().collect()
    },
    rows: |flow| Ok(rows(flow).into()),
    pictures: |flow| {
        let view = flow.view("Jet", &flow.outcome.gas.mach, "Mach number");
        view.save()
    },
    together: None,
};

fn rows(flow: &Flow<'_>) -> [Row; 4] {
    let is_of_points = flow.variant.scheme.is_of_points();
    let frames = &flow.outcome.history.frames;
    let mean =
        |of: &dyn Fn(&Frame) -> f64| frames.iter().map(of).sum::<f64>() / frames.len() as f64;
    let total = PRESSURE * (1.0 + 0.5 * (GAMMA - 1.0) * MACH * MACH).powf(GAMMA / (GAMMA - 1.0));
    let disc = mean(&disc);
    let what = "Mach disc behind the nozzle / its diameter, mean of the second half";
    let reference = 0.67 * total.sqrt();
    let disc = if is_of_points {
        Row::relative(what, DISC, disc, reference, 6.0)
    } else {
        Row::informs(what, DISC, disc, reference)
    };
    let air = Row::relative(
        "pressure of the air around it / that held, mean of the second half",
        "still air",
        mean(&air),
        1.0,
        20.0,
    );
    let fastest = Row::at_most(
        "fastest that air goes along the outlet beside the jet",
        "speed of sound",
        mean(&|frame| fastest(frame, flow.spacing)),
        1.0,
    );
    let most = frames.iter().map(|frame| most(frame, flow.spacing));
    let most = most.fold(0.0, f64::max);
    let what = "highest pressure along the outlet beside the jet / that held, in the second half";
    let most = if is_of_points {
        Row::at_most(what, "no spots", most, 1.5)
    } else {
        Row::informs(what, "no spots", most, 1.0)
    };
    [disc, air.by_points(is_of_points, 5.0), most, fastest]
}

/// Where on the axis the pressure comes back to half of that of the air, having been below it.
fn disc(frame: &Frame) -> f64 {
    let near = gas(frame).filter(|&i| frame.position[i][1].abs() < AXIS);
    let mut axis: Vec<[f64; 2]> = near
        .map(|i| [frame.position[i][0], GAMMA * frame.pressure[i]])
        .collect();
    axis.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut behind = axis.iter().skip_while(|[_, pressure]| *pressure > 0.5);
    let back = behind.find(|[_, pressure]| *pressure > 0.5);
    back.map_or(f64::NAN, |[x, _]| *x)
}

/// Mean pressure around the jet, over that of the air.
fn air(frame: &Frame) -> f64 {
    let around = gas(frame).filter(|&i| frame.position[i][1].abs() > AIR);
    let sums = around.fold((0.0, 0.0), |(sum, all), i| {
        let volume = frame.volume[i];
        (sum + volume * GAMMA * frame.pressure[i], all + volume)
    });
    sums.0 / sums.1
}

/// The highest pressure in the two rows at the outlet beside the jet, over that of the air.
fn most(frame: &Frame, spacing: f64) -> f64 {
    let pressures = beside(frame, spacing).map(|i| GAMMA * frame.pressure[i]);
    pressures.fold(0.0, f64::max)
}

/// The largest speed along the side in the same rows.
fn fastest(frame: &Frame, spacing: f64) -> f64 {
    let speeds = beside(frame, spacing).map(|i| frame.velocity[i][0].abs());
    speeds.fold(0.0, f64::max)
}

fn beside(frame: &Frame, spacing: f64) -> impl Iterator<Item = usize> {
    gas(frame).filter(move |&i| frame.position[i][1].abs() > 3.0 - 2.0 * spacing)
}

fn gas(frame: &Frame) -> impl Iterator<Item = usize> {
    (0..frame.kind.len()).filter(|&i| frame.kind[i] == Kind::Fluid as u8)
}
