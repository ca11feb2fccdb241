//! Why a run cannot go on: finds the first particle whose state makes no sense, and what about its
//! surroundings most likely brought it there.

use aero_geometry::Vector;
use aero_geometry::kernel::SUPPORT;

use super::stages::Senseless;
use crate::Simulation;
use crate::particles::Particle;
use crate::problem::{Body, side_name};
use crate::records::GHOSTS;
use crate::scheme::Extrapolation;
use crate::walls::rigid::pad;
use crate::walls::{Contact, Met, wall_sides};

/// Mach number at which heat is a thousandth of the motion's energy, and within its errors.
const COLD: f64 = 30.0;

/// Why a run stopped before its end.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{reason} ({}{position:?}, step {step}, time {time})", at(*particle))]
pub struct Failure {
    /// What happened, the likely cause and what may help.
    pub reason: String,
    /// Number of the particle, if one is to blame.
    pub particle: Option<u64>,
    /// Where it was.
    pub position: [f64; 3],
    /// Step.
    pub step: u64,
    /// Time.
    pub time: f64,
}

impl<const D: usize> Simulation<D> {
    /// Why the run cannot go on from its last good state, where it stands again.
    pub(super) fn failure(&self, senseless: Senseless<D>) -> Failure {
        let Senseless { place, particle } = senseless;
        let reason = format!("{}; {}", symptom(&particle), self.likely_cause(place));
        Failure {
            reason,
            particle: Some(particle.id),
            position: pad(&self.fluid[place].position).into(),
            step: self.clock.steps,
            time: self.clock.time,
        }
    }

    /// Why the run cannot go on where a free body touches something.
    pub(crate) fn touched(&self, contact: &Contact<D>) -> Failure {
        let name = |number: usize| &self.problem.bodies[number].name;
        let other = match contact.met {
            Met::Body(number) => format!("body `{}`", name(number)),
            Met::Side(axis, end) => format!("the side {}", side_name(axis, end)),
        };
        Failure {
            reason: format!(
                "body `{}` touches {other}, with no room for gas between, and contact is not modelled; end the run before, give \
                 them more room, or hold the body (`motion.free.constraints`)",
                name(contact.body)
            ),
            particle: None,
            position: pad(&contact.position).into(),
            step: self.clock.steps,
            time: self.clock.time,
        }
    }

    /// The likely cause of the failure of fluid particle `number`, from its last good state, with a
    /// remedy.
    fn likely_cause(&self, number: usize) -> String {
        let particle = &self.fluid[number];
        let place = &particle.position;
        if let Some(wall) = self.wall_around(place) {
            return format!(
                "it had leaked into {wall}; try {}a finer `spacing`",
                self.other_walls(true)
            );
        }
        let [gas, ghosts] = self.neighbour_counts(number);
        if gas <= 2 * D {
            return format!(
                "it had only {gas} neighbours in the gas, which is nearly a vacuum there (density {:.1e}); try a finer `spacing`, or less of an expansion",
                particle.density
            );
        }
        if self.clock.steps < 3 {
            return "the start is too violent for the scheme; try a smaller `scheme.cfl`, a smooth start (`initial.riemann.smooth = true`) or a finer `spacing`".into();
        }
        if let Some((kind, distance)) = self.next_to(place) {
            return format!(
                "it was {distance:.1} spacings from {kind}, with {ghosts} ghosts in reach; try {}a smaller `scheme.cfl` or a finer `spacing`",
                self.other_walls(false)
            );
        }
        let gases = self.problem.gases();
        let gas = gases.of(particle.is_second);
        let sound = gas.sound_speed(particle.density, particle.energy);
        let mach = particle.velocity.norm() / sound;
        if mach > COLD {
            return format!(
                "the gas there was so cold and fast (Mach {mach:.0}) that its heat is lost in that of its motion; try a smaller `scheme.cfl` or a warmer gas"
            );
        }
        "a jump there is too steep for the spacing; try a smaller `scheme.cfl` or a finer `spacing`"
            .into()
    }

    /// What else walls may do, each with a comma behind it, as far as the scheme does not do it yet; whether they may shield themselves.
    fn other_walls(&self, with_shield: bool) -> String {
        let scheme = &self.problem.scheme;
        let mut others = String::new();
        if scheme.wall.extrapolation == Extrapolation::Wom {
            others += "`scheme.extrapolation = \"wm\"`, ";
        }
        if with_shield && !scheme.transport_velocity.shield {
            others += "`scheme.shield = true`, ";
        }
        others
    }

    /// Neighbours of fluid particle `number` within the support: in the gas, and ghosts.
    fn neighbour_counts(&self, number: usize) -> [usize; 2] {
        let near = &self.around.records.near;
        let lists = &self.around.lists;
        let Some(cluster) = lists.cluster_of(number) else {
            return [0; 2];
        };
        let own = &near[number];
        let walls = self.around.records.segment(GHOSTS).start;
        let mut counts = [0; 2];
        for &j in &lists.all().entries[cluster.gas.start..cluster.wall.end] {
            let j = j as usize;
            let reach = SUPPORT * (own.half_h + near[j].half_h);
            if j != number && (own.position - near[j].position).norm() < reach {
                counts[usize::from(j >= walls)] += 1;
            }
        }
        counts
    }

    /// The body or wall side that `position` is inside of, in words.
    fn wall_around(&self, position: &Vector<D>) -> Option<String> {
        if let Some(body) = self.body_around(position) {
            return Some(format!("body `{}`", body.name));
        }
        self.side_depths(position)
            .find(|(_, depth)| *depth > 0.0)
            .map(|(side, _)| wall_name(side))
    }

    /// The body that `position` is inside of now.
    pub(crate) fn body_around(&self, position: &Vector<D>) -> Option<&Body<D>> {
        let bodies = self.problem.bodies.iter().enumerate();
        let found = bodies.into_iter().find(|(number, body)| {
            let origin = self.walls.pose(*number, self.clock.time).origin(position);
            body.shape.bounds().contains(&origin) && body.shape.signed_distance(&origin) < 0.0
        });
        found.map(|(_, body)| body)
    }

    /// The nearest body or wall within the support, in words, and its distance in spacings.
    fn next_to(&self, position: &Vector<D>) -> Option<(String, f64)> {
        let bodies = self
            .problem
            .bodies
            .iter()
            .enumerate()
            .map(|(number, body)| {
                let origin = self.walls.pose(number, self.clock.time).origin(position);
                let distance = body.shape.signed_distance(&origin);
                (format!("body `{}`", body.name), distance)
            });
        let sides = self
            .side_depths(position)
            .map(|(side, depth)| (wall_name(side), -depth));
        bodies
            .chain(sides)
            .map(|(name, distance)| (name, distance / self.problem.resolution.at(position)))
            .filter(|(_, distance)| *distance < SUPPORT)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Axis and end of each wall side, and how far `position` is behind it now; negative in front.
    pub(crate) fn side_depths(
        &self,
        position: &Vector<D>,
    ) -> impl Iterator<Item = ((usize, usize), f64)> {
        let sides = wall_sides(&self.problem.domain).into_iter();
        sides.enumerate().map(move |(number, (axis, end))| {
            let pose = self
                .walls
                .pose(self.problem.bodies.len() + number, self.clock.time);
            let origin = pose.origin(position)[axis];
            let face = self.problem.domain.face(axis, end);
            let depth = if end == 0 {
                face - origin
            } else {
                origin - face
            };
            ((axis, end), depth)
        })
    }
}

/// What stands before a place.
fn at(particle: Option<u64>) -> String {
    particle.map_or_else(|| "at ".into(), |id| format!("particle {id} at "))
}

fn wall_name((axis, end): (usize, usize)) -> String {
    format!("the wall {}", side_name(axis, end))
}

fn symptom<const D: usize>(particle: &Particle<D>) -> String {
    if particle.energy <= 0.0 {
        format!("internal energy fell to {:.3e}", particle.energy)
    } else if particle.density <= 0.0 {
        format!("density fell to {:.3e}", particle.density)
    } else {
        "the state is no longer finite".into()
    }
}
