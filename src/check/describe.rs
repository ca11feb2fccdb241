//! What a case is, in words: the stream, what each side does, how finely each body is resolved and what it touches.

use aero_solver::panels::Panels;
use aero_solver::problem::Problem;

use super::layer::reynolds_per_length;
use super::side_name;
use crate::case::{AnyCase, Case};

/// Nearer than this, in spacings, is touching.
const TOUCHES: f64 = 0.5;

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
        format!("{motion}, to t = {:.4e}", case.plan.end_time),
        format!(
            "stream: Mach {:.4}, pressure {:.5e}, density {:.5e}, dynamic pressure {:.5e}",
            speed / sound,
            stream.pressure,
            stream.density,
            0.5 * stream.density * speed * speed
        ),
    ];
    if let Some(per_length) = reynolds_per_length(problem) {
        lines.push(format!(
            "Reynolds number: {per_length:.5e} to a unit of length, {:.3e} to a spacing",
            per_length * problem.spacing
        ));
    }
    for (axis, end, side, face) in problem.domain.each_side() {
        let name = side_name(axis, end);
        lines.push(format!("side {name} at {face}: {side}"));
    }
    if problem.source.is_some() {
        lines.push("sources keep the gas to a manufactured solution".into());
    }
    let panels = Panels::new(problem);
    for number in 0..problem.bodies.len() {
        lines.extend(body(problem, &panels, number));
    }
    lines
}

/// A body: its size in spacings, what its coefficients refer to, what it touches.
fn body<const D: usize>(problem: &Problem<D>, panels: &Panels<D>, number: usize) -> Vec<String> {
    let body = &problem.bodies[number];
    let extent = body.shape.bounds().intersection(&problem.domain.bounds);
    let size = extent.size() / problem.spacing;
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
        body.reference_area,
        body.reference_length,
        super::place(&body.moment_centre)
    )];
    if let Some(free) = &body.motion.free {
        let mass = match D {
            1 => "kg to a square metre",
            2 => "kg to a metre of depth",
            _ => "kg",
        };
        let axes = |held: [bool; 3]| -> String {
            let free = ["x", "y", "z"].into_iter().zip(held);
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
    let near = TOUCHES * problem.spacing;
    let mut touched = Vec::new();
    for (axis, end, side, face) in problem.domain.each_side() {
        let reach = [extent.min[axis] - face, face - extent.max[axis]][end];
        if reach < near {
            touched.push(format!("side {} ({side})", side_name(axis, end)));
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
