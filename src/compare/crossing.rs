//! Shocks of two wedges that cross: what is ahead of them, what is behind, and the walls before they come there again.

use aero::run::Keep;
use aero_solver::frame::Kind;
use aero_validation::exact::crossing::{Crossing, crossing};
use aero_validation::metrics::median;

use super::comparison::{Comparison, Flow};
use super::context::CompareError;
use super::row::Row;
use super::scenes::scene;
use super::variant::Variant;

const THEORY: &str = "oblique shocks (Anderson, Modern Compressible Flow, 4.8), exact";
/// As in the scene: Mach number, degrees by which the lower and the upper wall turn, and the height at which each of them begins to.
const MACH: f64 = 3.0;
const TURNS: [f64; 2] = [10.0, 16.0];
const HEIGHTS: [f64; 2] = [0.0, 1.0];
const GAMMA: f64 = 1.4;
/// So far from shocks, in spacings, gas and walls are looked at: of points, and of particles, whose shocks are as wide as their kernels.
const CLEAR: [f64; 2] = [4.0, 8.0];
/// The same behind both shocks, where there is little room beside the slip line.
const CLEAR_BEHIND: [f64; 2] = [2.0, 3.0];

pub const CROSSING: Comparison = Comparison {
    case: "crossing",
    scene: scene!("crossing"),
    length: 1.0,
    keep: Keep::End,
    variants: || {
        let points = Variant::new(50, ()).settled();
        vec![
            points.both(),
            points.cells(100),
            points.cells(200),
            // At 1/50 there is less room behind the crossing than their shocks are wide.
            Variant::new(100, ()),
        ]
    },
    label: |v| format!("dx 1/{}, {}", v.cells, v.scheme.laws()),
    settings: |v, _| {
        let is_of_points = v.scheme.is_of_points();
        let motion = (!is_of_points).then(|| "scheme.motion=with-the-gas".into());
        motion.into_iter().collect()
    },
    rows,
    pictures: |flow| {
        let view = flow.view("Crossing shocks", &flow.outcome.gas.pressure, "pressure");
        view.save()
    },
    together: None,
};

/// Where gas is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Region {
    Stream,
    /// Between the shocks and the lower or the upper wall.
    Once(usize),
    /// Behind both shocks, below or above the slip line.
    Twice(usize),
}

/// The shocks as lines.
struct Lines {
    /// Where they cross.
    at: [f64; 2],
    /// Directions of the four shocks, as tangents: those of the walls, and what is behind the crossing.
    first: [f64; 2],
    second: [f64; 2],
    slip: f64,
}

impl Lines {
    fn new(theory: &Crossing) -> Self {
        let first = [theory.first[0].angle.tan(), -theory.first[1].angle.tan()];
        let x = (HEIGHTS[1] - HEIGHTS[0]) / (first[0] - first[1]);
        Self {
            at: [x, HEIGHTS[0] + first[0] * x],
            first,
            second: theory.beyond().map(f64::tan),
            slip: theory.direction.tan(),
        }
    }

    fn region(&self, [x, y]: [f64; 2]) -> Region {
        let height = |tangent: f64| self.at[1] + tangent * (x - self.at[0]);
        let lines = if x < self.at[0] {
            self.first
        } else {
            self.second
        };
        if y < height(lines[0]) {
            Region::Once(0)
        } else if y > height(lines[1]) {
            Region::Once(1)
        } else if x < self.at[0] {
            Region::Stream
        } else {
            Region::Twice(usize::from(y > height(self.slip)))
        }
    }

    /// How far a place is from the nearest shock or the slip line.
    fn away(&self, place: [f64; 2]) -> f64 {
        let ahead = self.first.map(|tangent| [-1.0, -tangent]);
        let behind = [self.second[0], self.second[1], self.slip].map(|tangent| [1.0, tangent]);
        let arm = [0, 1].map(|k| place[k] - self.at[k]);
        let from = |way: &[f64; 2]| {
            let part = (arm[0] * way[0] + arm[1] * way[1]) / way[0].hypot(way[1]).powi(2);
            let nearest = way.map(|along| part.max(0.0) * along);
            (arm[0] - nearest[0]).hypot(arm[1] - nearest[1])
        };
        let all = ahead.iter().chain(&behind);
        all.map(from).fold(f64::INFINITY, f64::min)
    }
}

fn rows(flow: &Flow<'_>) -> Result<Vec<Row>, CompareError> {
    let theory = crossing(MACH, TURNS.map(f64::to_radians), GAMMA)?;
    let lines = Lines::new(&theory);
    let is_of_points = flow.variant.scheme.is_of_points();
    let [clear, clear_behind] =
        [CLEAR, CLEAR_BEHIND].map(|clear| flow.spacing * clear[usize::from(!is_of_points)]);
    let gas = &flow.outcome.gas;
    let place = |i: usize| [gas.position[i][0], gas.position[i][1]];
    let inside = |region: Region, clear: f64| -> Vec<usize> {
        let is_seen = |&i: &usize| {
            gas.kind[i] == Kind::Fluid as u8
                && lines.region(place(i)) == region
                && lines.away(place(i)) > clear
        };
        (0..gas.kind.len()).filter(is_seen).collect()
    };
    let mut rows = Vec::new();
    for (k, name) in ["lower", "upper"].into_iter().enumerate() {
        let once = theory.first[k].pressure_ratio;
        let gas_off = inside(Region::Once(k), clear).into_iter();
        let gas_off = gas_off.map(|i| (GAMMA * gas.pressure[i] / once - 1.0).abs());
        let what = format!("pressure between the shocks and the {name} wall, farthest off");
        let farthest = gas_off.fold(0.0, f64::max);
        rows.push(if is_of_points {
            Row::at_most(what, THEORY, farthest, 0.01)
        } else {
            Row::informs(what, THEORY, farthest, 0.0)
        });
        let wall = wall(flow, &lines, k, clear) / once;
        let what = format!("pressure on the {name} wall, mean of what is ahead of the shock");
        rows.push(Row::relative(what, THEORY, wall, 1.0, 1.0).by_points(is_of_points, 0.1));
    }
    for (k, name) in ["below", "above"].into_iter().enumerate() {
        let seen = inside(Region::Twice(k), clear_behind);
        let of = |value: &dyn Fn(usize) -> f64| {
            let mut values: Vec<f64> = seen.iter().map(|&i| value(i)).collect();
            median(&mut values)
        };
        let pressure = of(&|i| GAMMA * gas.pressure[i]);
        let density = of(&|i| gas.density[i]);
        let way = of(&|i| gas.velocity[i][1].atan2(gas.velocity[i][0]).to_degrees());
        let named = |what: &str| format!("{what} {name} the slip line");
        let exact =
            |what: &str, value, exact| Row::relative(named(what), THEORY, value, exact, 1.0);
        rows.push(exact("pressure", pressure, theory.pressure_ratio));
        rows.push(exact("density", density, theory.density_ratios[k]));
        let direction = theory.direction.to_degrees();
        rows.push(Row::absolute(
            named("direction of the gas, deg,"),
            THEORY,
            way,
            direction,
            0.3,
        ));
    }
    rows.push(flow.no_leaks());
    Ok(rows)
}

/// Mean pressure on a wall from its corner up to what is so `clear` of the shocks, over the stream's.
fn wall(flow: &Flow<'_>, lines: &Lines, k: usize, clear: f64) -> f64 {
    let panels = &flow.outcome.panels;
    let (mut sum, mut all) = (0.0, 0.0);
    for n in 0..panels.area.len() {
        let [x, y, _] = panels.middle(n);
        // The corner is where the shock begins.
        let is_ahead = x < lines.at[0] || lines.away([x, y]) > clear;
        if panels.body[n] as usize == k && x > 0.0 && is_ahead {
            sum += panels.area[n] * GAMMA * panels.pressure[n];
            all += panels.area[n];
        }
    }
    sum / all
}
