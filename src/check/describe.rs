//! What a case is, in words: the stream, what each side does, how finely each body is resolved and what it touches.

use aero_packer::thinnest_part;
use aero_solver::gas::Gas;
use aero_solver::method::Refine;
use aero_solver::panels::Panels;
use aero_solver::problem::{AXES, Opening, Problem};

use super::layer::reynolds_per_length;
use super::{shortened, side_name};
use crate::case::{AnyCase, Case, Stop};

/// Nearer than this, in spacings, is touching.
const TOUCHES: f64 = 0.5;

/// More spacings than this across are not worth a word.
const THIN: f64 = 20.0;

impl AnyCase {
    /// What the case is, a line each.
    pub fn description(&self) -> Vec<String> {
        match self {
            Self::One(case) => description(case),
            Self::Two(case) => description(case),
            Self::Three(case) => description(case),
        }
    }
}

fn description<const D: usize>(case: &Case<D>) -> Vec<String> {
    let problem = &case.problem;
    let stream = &problem.free_stream;
    let sound = problem.gas.sound_speed_at(stream.density, stream.pressure);
    let speed = stream.velocity.norm();
    let motion = if problem.method.fixed().is_some() {
        "points that stay"
    } else {
        "particles that move with the gas"
    };
    let mut lines = vec![
        match (case.plan.stop, problem.method.settles()) {
            (_, true) => format!("{motion}, until the flow is steady"),
            (Stop::Steady, _) => format!(
                "{motion}, until forces are steady or t = {:.4e}",
                case.plan.end_time
            ),
            (Stop::EndTime, _) => format!("{motion}, to t = {:.4e}", case.plan.end_time),
        },
        format!(
            "stream: Mach {:.4}, pressure {:.5e}, density {:.5e}{}, dynamic pressure {:.5e}",
            speed / sound,
            stream.pressure,
            stream.density,
            temperature(case),
            0.5 * stream.density * speed * speed
        ),
    ];
    lines.push(gas(problem));
    lines.extend(second(problem));
    if let Some(per_length) = reynolds_per_length(problem) {
        lines.push(format!(
            "Reynolds number: {per_length:.5e} to a unit of length, {:.3e} to a spacing",
            per_length * problem.resolution.lattice()
        ));
    }
    for (axis, end, side, face) in problem.domain.each_side() {
        let name = side_name(axis, end);
        lines.push(format!("side {name} at {face}: {side}"));
        let openings = problem.domain.openings.iter();
        let own = openings.filter(|opening| (opening.axis, opening.end) == (axis, end));
        lines.extend(own.map(|opening| self::opening(problem, opening)));
    }
    lines.extend(problem.source.as_ref().map(|source| source.description()));
    let panels = Panels::new(problem);
    for number in 0..problem.bodies.len() {
        lines.extend(body(problem, &panels, number));
    }
    lines
}

/// How warm the stream of an ideal gas is, where its gas constant is known.
fn temperature<const D: usize>(case: &Case<D>) -> String {
    match (&case.problem.gas, case.plan.gas_constant) {
        (Gas::Ideal(_), Some(constant)) => {
            let stream = &case.problem.free_stream;
            let kelvins = stream.pressure / (stream.density * constant);
            format!(", temperature {kelvins:.2} K")
        }
        _ => String::new(),
    }
}

/// The gas, and how warm its stream is where that is known.
fn gas<const D: usize>(problem: &Problem<D>) -> String {
    let stream = &problem.free_stream;
    match &problem.gas {
        Gas::Ideal(gas) => format!("gas: ideal, ratio of specific heats {}", gas.gamma),
        Gas::Liquid(liquid) => {
            let law = if liquid.is_linear() {
                "pressure linear in the density".into()
            } else {
                format!("Tait's equation with an exponent of {}", liquid.exponent)
            };
            format!(
                "gas: a liquid, {law}; speed of sound {} and pressure {} at a density of {}",
                liquid.sound_speed, liquid.pressure, liquid.density
            )
        }
        Gas::Air { air, .. } => {
            let [least, most] = air.range();
            format!(
                "gas: {air}, {least} to {most} K; the stream has {:.2} K",
                air.temperature(stream.density, stream.pressure)
            )
        }
    }
}

/// The second gas, where there is one.
fn second<const D: usize>(problem: &Problem<D>) -> Option<String> {
    let second = problem.second.as_ref()?;
    let gas = second.gas.ideal_gas()?;
    let density = second.density.map_or_else(String::new, |density| {
        format!(", density {density:.5e} at the start")
    });
    Some(format!(
        "second gas: ideal, ratio of specific heats {}{density}",
        gas.gamma
    ))
}

/// A part of a side, or what is given beyond it: where it is and, at its middle and at the start, its state.
fn opening<const D: usize>(problem: &Problem<D>, opening: &Opening<D>) -> String {
    let extent = opening.part.as_ref().unwrap_or(&problem.domain.bounds);
    let mut middle = (extent.min + extent.max) / 2.0;
    middle[opening.axis] = problem.domain.face(opening.axis, opening.end);
    let text = opening.part.as_ref().map_or("  beyond it".into(), |part| {
        let [from, to] = [&part.min, &part.max].map(super::place);
        format!("  a patch from {from} to {to}")
    });
    let Some(state) = opening.given.as_ref().map(|given| given.at(&middle, 0.0)) else {
        return format!("{text}: {}", opening.side);
    };
    let inside = if opening.side.lets_in() {
        format!(
            "gas of density {:.5e}, pressure {:.5e} and velocity {}",
            state.density,
            state.pressure,
            super::place(&state.velocity)
        )
    } else {
        format!("a pressure of {:.5e}", state.pressure)
    };
    let middle = super::place(&middle);
    format!("{text}, at its middle {middle} and t = 0: {inside}")
}

/// A body: its size in spacings, what its coefficients refer to, what it touches.
fn body<const D: usize>(problem: &Problem<D>, panels: &Panels<D>, number: usize) -> Vec<String> {
    let body = &problem.bodies[number];
    let extent = body.shape.bounds().intersection(&problem.domain.bounds);
    let size = extent.size() / problem.resolution.lattice();
    let across: Vec<String> = size.iter().map(|n| format!("{n:.1}")).collect();
    let mut lines = vec![format!(
        "body `{}`: {} spacings, {} ghosts, {} panels; area {}, length {}, moments about {}",
        body.name,
        across.join(" x "),
        body.ghosts.position.len(),
        panels
            .all()
            .iter()
            .filter(|panel| panel.owner as usize == number)
            .count(),
        shortened(body.reference_area),
        shortened(body.reference_length),
        super::place(&body.moment_centre)
    )];
    let thin = thinnest_part(body.shape.as_ref(), &problem.domain.bounds);
    if let Some(thin) = thin.filter(|thin| *thin < THIN * problem.resolution.lattice()) {
        let spacings = thin / problem.resolution.lattice();
        let refine = problem.method.fixed().map(|points| points.refine);
        let finest = match refine {
            Some(Refine::Points(_)) | None => 0,
            Some(refine) => refine.levels(),
        };
        let finely = match finest {
            0 => String::new(),
            most => format!(", {:.1} of the finest", spacings * f64::from(1_u32 << most)),
        };
        lines.push(format!(
            "  its thinnest part, {thin:.3e}, is {spacings:.1} spacings across{finely}"
        ));
    }
    if let Some(free) = &body.motion.free {
        let mass = match D {
            1 => "kg to a square metre",
            2 => "kg to a metre of depth",
            _ => "kg",
        };
        let axes = |held: [bool; 3]| -> String {
            let free = AXES.into_iter().zip(held);
            let free: Vec<_> = free
                .filter(|(_, held)| !held)
                .map(|(axis, _)| axis)
                .collect();
            if free.is_empty() {
                "nothing".into()
            } else {
                free.join(", ")
            }
        };
        lines.push(format!(
            "  moved by the gas: {} {mass}, along {}, about {} through {}",
            free.mass,
            axes(free.is_held),
            axes(free.keeps_turn),
            super::place(&body.motion.pivot)
        ));
    }
    let near = TOUCHES * problem.resolution.lattice();
    let mut touched = Vec::new();
    for (axis, end, side, face) in problem.domain.each_side() {
        let reach = [extent.min[axis] - face, face - extent.max[axis]][end];
        if reach < near {
            let whole = body.shape.bounds();
            let halved = problem.domain.plane_through(axis, &whole);
            let what = match halved {
                Some((at, _)) if at == end => {
                    ", which makes it whole: area and forces are those of the whole"
                }
                _ => "",
            };
            touched.push(format!("side {} ({side}{what})", side_name(axis, end)));
        }
    }
    for (other, body) in problem.bodies.iter().enumerate() {
        let meets = other != number
            && panels.all().iter().any(|panel| {
                panel.owner as usize == number
                    && body.shape.bounds().grown(near).contains(&panel.centre)
                    && body.shape.signed_distance(&panel.centre) < near
            });
        if meets {
            touched.push(format!("body `{}`", body.name));
        }
    }
    if !touched.is_empty() {
        lines.push(format!("  touches {}", touched.join(", ")));
    }
    lines
}
