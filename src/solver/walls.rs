//! Ghosts of bodies and wall sides: where they are and what state they show the gas.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::{Pencils, Vector};
use pulp::Arch;
use rayon::prelude::*;

use super::curvature::shape_operator;
use super::faces::{Faces, Sight, ThinParts, View, thin_parts};
use super::lattice;
use super::neighbours::{Candidates, GROWTH, Lists, Seeker};
use super::pairs::extrapolation::{Consistency, Interpolated, interpolate};
use super::particle::Ghost;
use super::records::{GHOSTS, Matrix, Near, Records, State, Symmetric};
use super::rigid::Pose;
use super::side_walls;
use crate::case::{Case, Equations, Extrapolation, Motion, Side, WallKind};

/// All ghosts, and what their bodies do.
#[derive(Clone, Debug)]
pub struct Walls<const D: usize> {
    /// Ghosts in the order of `pencils`, then their views in the order of `view_pencils`.
    pub ghosts: Vec<Ghost<D>>,
    /// Order of the ghosts in space.
    pub pencils: Pencils<D>,
    /// Order of the views in space.
    pub view_pencils: Pencils<D>,
    /// Ghosts whose mirror was short of neighbours at the last evaluation.
    pub mirror_fallbacks: usize,
    /// Bodies in scene order, then wall sides.
    bodies: Vec<(Motion<D>, WallKind)>,
    extrapolation: Extrapolation,
    equations: Equations,
    constant_volume: bool,
    gamma: f64,
    width: f64,
    faces: Option<Faces<D>>,
    found: Vec<Option<Interpolated<D>>>,
    mirrored: Vec<Option<Interpolated<D>>>,
}

/// Neighbours of the ghosts.
#[derive(Clone, Debug, Default)]
pub struct WallLists {
    /// Around each ghost; the gas only.
    pub near: Lists,
    /// Around each mirror point; the gas only.
    pub mirror: Lists,
}

impl<const D: usize> Walls<D> {
    /// The ghosts of all bodies and wall sides of `case`; `width` is that of a pencil.
    pub fn new(case: &Case<D>, width: f64) -> Self {
        let mut bodies: Vec<_> = case
            .bodies
            .iter()
            .map(|b| (b.motion.clone(), b.wall))
            .collect();
        let sides = side_walls::side_walls(&case.domain, case.spacing);
        bodies.extend(sides.iter().map(|side| (side.motion.clone(), side.kind)));
        let follows_the_bend = case.scheme.equations == Equations::Conservative;
        let mut ghosts = Vec::new();
        for (number, body) in case.bodies.iter().enumerate() {
            for (g, &position) in body.ghosts.position.iter().enumerate() {
                let depth = -body.ghosts.distance[g];
                let mut ghost = blank(case, position, body.ghosts.normal[g], depth);
                ghost.volume = body.ghosts.volume[g] * modelled_share(case, &position);
                ghost.reference_mass = ghost.density * ghost.volume;
                ghost.body = number as u32;
                ghost.layer = body.ghosts.layer[g];
                let reached = body.shape.signed_distance(&ghost.mirror());
                ghost.has_mirror = (reached - depth).abs() < 0.1 * depth;
                ghosts.push(ghost);
            }
            if follows_the_bend {
                let first = ghosts.len() - body.ghosts.position.len();
                ghosts[first..].par_iter_mut().for_each(|ghost| {
                    ghost.origin_curvature =
                        shape_operator(&body.shape, &ghost.position, case.spacing);
                });
            }
        }
        let inside_a_body = |position: &Vector<D>| {
            case.bodies
                .iter()
                .any(|body| body.shape.signed_distance(position) < 0.0)
        };
        for (number, side) in sides.iter().enumerate() {
            for point in &side.ghosts {
                if inside_a_body(&point.position) {
                    continue;
                }
                let mut ghost = blank(case, point.position, point.normal, point.depth);
                ghost.body = (case.bodies.len() + number) as u32;
                ghost.layer = point.layer;
                ghosts.push(ghost);
            }
        }
        let thin = case.scheme.surface_tags.then(|| thin_parts(case)).flatten();
        if let Some(ThinParts { views, hidden, .. }) = &thin {
            let originals = ghosts.clone();
            let mut first = 0;
            for (number, hidden) in hidden.iter().enumerate() {
                for (ghost, &faces) in ghosts[first..].iter_mut().zip(hidden) {
                    ghost.sight.hidden = faces;
                }
                let views = views.par_iter().filter(|view| view.body == number);
                let seen =
                    views.map(|view| seen_by_face(case, &originals[first + view.ghost], view));
                ghosts.par_extend(seen);
                first += hidden.len();
            }
        }
        let mut walls = Self {
            ghosts,
            pencils: Pencils::default(),
            view_pencils: Pencils::default(),
            mirror_fallbacks: 0,
            bodies,
            extrapolation: case.scheme.extrapolation,
            equations: case.scheme.equations,
            constant_volume: case.scheme.constant_ghost_volume,
            gamma: case.gamma,
            width,
            faces: thin.map(|thin| thin.faces),
            found: Vec::new(),
            mirrored: Vec::new(),
        };
        walls.move_to(0.0);
        walls.sort();
        walls
    }

    /// True where any body moves.
    pub fn are_moving(&self) -> bool {
        self.bodies.iter().any(|(motion, _)| motion.is_moving())
    }

    /// Number of bodies and wall sides.
    pub fn body_count(&self) -> usize {
        self.bodies.len()
    }

    /// Pose of body `number` at `time`.
    pub fn pose(&self, number: usize, time: f64) -> Pose<D> {
        Pose::new(&self.bodies[number].0, time)
    }

    /// Moves all ghosts to where they are at `time`.
    pub fn move_to(&mut self, time: f64) {
        let poses: Vec<_> = self
            .bodies
            .iter()
            .map(|(motion, _)| Pose::new(motion, time))
            .collect();
        for ghost in &mut self.ghosts {
            let pose = &poses[ghost.body as usize];
            ghost.position = pose.position(&ghost.origin);
            ghost.normal = pose.direction(&ghost.origin_normal);
            // The wall moves as its surface does, not as the ghost below it.
            let foot = ghost.foot();
            ghost.wall_velocity = pose.velocity(&foot);
            ghost.wall_acceleration = pose.acceleration(&foot);
            ghost.curvature = pose.tensor(&ghost.origin_curvature);
            ghost.coriolis = pose.coriolis(&ghost.normal);
        }
    }

    /// Sorts the ghosts in space; needed after they have moved.
    pub fn sort(&mut self) {
        let (ghosts, views) = self.ghosts.split_at(self.own_count());
        let mut all = sorted(ghosts, &mut self.pencils, self.width);
        all.extend(sorted(views, &mut self.view_pencils, self.width));
        self.ghosts = all;
    }

    /// Number of ghosts without their views.
    pub fn own_count(&self) -> usize {
        self.ghosts.partition_point(|ghost| !ghost.sight.is_view())
    }

    /// The ghosts without their views.
    pub fn own(&self) -> &[Ghost<D>] {
        &self.ghosts[..self.own_count()]
    }

    /// The faces of thin parts; none where there are no such parts.
    pub fn faces(&self) -> Option<&Faces<D>> {
        self.faces.as_ref()
    }

    /// Lists the gas around each ghost and, with mirrors, around each mirror point.
    pub fn build_lists(
        &self,
        arch: Arch,
        sets: &[Candidates<'_, D>],
        half_step: f64,
        lists: &mut WallLists,
    ) {
        let ghosts = &self.ghosts;
        let count = ghosts.len();
        let gas: Vec<_> = sets.iter().filter(|set| !set.is_wall()).copied().collect();
        lists
            .near
            .build(arch, count, |g| seeker(&ghosts[g]), &gas, half_step, None);
        if self.extrapolation == Extrapolation::Wm {
            let seeker = |g: usize| mirror_seeker(&ghosts[g]);
            lists
                .mirror
                .build(arch, count, seeker, &gas, half_step, None);
        }
    }

    /// Gives every ghost the state of the gas nearby, mirrored at the wall [Villodi &
    /// Ramachandran 2024, section 3.4]. A ghost without gas in reach keeps its last state.
    pub fn extrapolate(&mut self, arch: Arch, lists: &WallLists, records: &Records<D>) {
        let ghosts = &self.ghosts;
        self.found.resize(ghosts.len(), None);
        interpolate(
            arch,
            &lists.near,
            |g| seeker(&ghosts[g]),
            records,
            Consistency::Shepard,
            &mut self.found,
        );
        self.mirrored.clear();
        self.mirrored.resize(ghosts.len(), None);
        if self.extrapolation == Extrapolation::Wm {
            interpolate(
                arch,
                &lists.mirror,
                |g| mirror_seeker(&ghosts[g]),
                records,
                Consistency::FirstOrder,
                &mut self.mirrored,
            );
        }
        let (bodies, equations, gamma) = (&self.bodies, self.equations, self.gamma);
        let constant_volume = self.constant_volume;
        self.ghosts
            .par_iter_mut()
            .zip(&self.found)
            .zip(&self.mirrored)
            .for_each(|((ghost, found), mirrored)| {
                let mirrored = mirrored.filter(|_| ghost.has_mirror);
                let Some(gas) = mirrored.or(*found) else {
                    return;
                };
                let arm = match mirrored {
                    Some(_) => 2.0 * ghost.depth,
                    None => gas.centroid.dot(&ghost.normal),
                };
                let kind = bodies[ghost.body as usize].1;
                show(ghost, &gas, arm, kind, equations, gamma);
                if !constant_volume {
                    ghost.volume = ghost.reference_mass / ghost.density;
                }
            });
        self.mirror_fallbacks = match self.extrapolation {
            Extrapolation::Wom => 0,
            Extrapolation::Wm => self
                .ghosts
                .iter()
                .zip(&self.mirrored)
                .zip(&self.found)
                .filter(|((ghost, mirrored), found)| {
                    found.is_some() && !(mirrored.is_some() && ghost.has_mirror)
                })
                .count(),
        };
    }

    /// Lets each ghost's smoothing length follow that of the gas nearby; once per step.
    pub fn update_smoothing_lengths(&mut self) {
        for ((ghost, found), mirrored) in
            self.ghosts.iter_mut().zip(&self.found).zip(&self.mirrored)
        {
            if let Some(gas) = mirrored.filter(|_| ghost.has_mirror).or(*found) {
                ghost.smoothing_length = gas.smoothing_length.min(GROWTH * ghost.smoothing_length);
            }
        }
    }

    /// Writes the ghosts' records. Ghosts partition space evenly: their renormalisation is that
    /// of a lattice, which the gas at rest has too.
    pub fn fill(&self, records: &mut Records<D>) {
        let slots = records.segment(GHOSTS);
        let even = even_renormalisation();
        let (near, state) = (
            &mut records.near[slots.clone()],
            &mut records.state[slots.clone()],
        );
        near.par_iter_mut()
            .zip(state)
            .zip(&self.ghosts)
            .for_each(|((near, state), ghost)| {
                *near = Near {
                    position: ghost.position,
                    half_h: 0.5 * ghost.smoothing_length,
                    volume: ghost.volume,
                    mass: ghost.density * ghost.volume,
                    half_density: 0.5 * ghost.density,
                    velocity: ghost.velocity,
                };
                *state = State::new(ghost.pressure, ghost.density, ghost.energy, self.gamma);
                state.strain = Symmetric::new(&ghost.strain);
                state.renormalise(&even, &Vector::zeros(), ghost.volume);
            });
    }
}

/// The ghosts in the order of `pencils`, which are made anew.
fn sorted<const D: usize>(
    ghosts: &[Ghost<D>],
    pencils: &mut Pencils<D>,
    width: f64,
) -> Vec<Ghost<D>> {
    let positions: Vec<_> = ghosts.iter().map(|ghost| ghost.position).collect();
    pencils.rebuild(&positions, width);
    let order = pencils.order().iter();
    order.map(|&g| ghosts[g as usize]).collect()
}

/// Renormalisation matrix of ghosts.
pub fn even_renormalisation<const D: usize>() -> Matrix<D> {
    Matrix::identity() * lattice::renormalisation::<D>(SMOOTHING_RATIO)
}

fn seeker<const D: usize>(ghost: &Ghost<D>) -> Seeker<D> {
    Seeker {
        position: ghost.position,
        half_h: 0.5 * ghost.smoothing_length,
        velocity: ghost.wall_velocity,
    }
}

fn mirror_seeker<const D: usize>(ghost: &Ghost<D>) -> Seeker<D> {
    Seeker {
        position: ghost.mirror(),
        ..seeker(ghost)
    }
}

/// A ghost in the free stream's state.
fn blank<const D: usize>(
    case: &Case<D>,
    position: Vector<D>,
    normal: Vector<D>,
    depth: f64,
) -> Ghost<D> {
    let gas = &case.free_stream;
    let h = SMOOTHING_RATIO * case.spacing;
    let volume = case.spacing.powi(D as i32);
    Ghost {
        position,
        normal,
        origin: position,
        origin_normal: normal,
        depth,
        volume,
        reference_mass: gas.density * volume,
        has_mirror: true,
        body: 0,
        layer: 0,
        sight: Sight::default(),
        wall_velocity: Vector::zeros(),
        wall_acceleration: Vector::zeros(),
        origin_curvature: Matrix::zeros(),
        curvature: Matrix::zeros(),
        coriolis: Vector::zeros(),
        velocity: Vector::zeros(),
        strain: Matrix::zeros(),
        pressure: gas.pressure,
        wall_pressure: gas.pressure,
        energy: gas.pressure / ((case.gamma - 1.0) * gas.density),
        density: gas.density,
        smoothing_length: h,
    }
}

/// The part of a ghost that belongs to the modelled side of all symmetry planes: one half of it for each plane that it
/// lies on. Its images, at the same place, are the rest.
fn modelled_share<const D: usize>(case: &Case<D>, position: &Vector<D>) -> f64 {
    let bounds = &case.domain.bounds;
    let on = |side: Side, place: f64, plane: f64| {
        side.is_mirror() && (place - plane).abs() < 1e-9 * case.spacing
    };
    let planes = (0..D).flat_map(|k| {
        let [low, high] = case.domain.sides[k];
        let place = position[k];
        [
            on(low, place, bounds.min[k]),
            on(high, place, bounds.max[k]),
        ]
    });
    0.5_f64.powi(planes.filter(|&is_on| is_on).count() as i32)
}

/// `ghost` as another face sees it.
fn seen_by_face<const D: usize>(case: &Case<D>, ghost: &Ghost<D>, view: &View<D>) -> Ghost<D> {
    let body = &case.bodies[view.body];
    let mut seen = blank(case, view.position, view.normal, view.depth);
    seen.volume = ghost.volume;
    seen.reference_mass = ghost.reference_mass;
    seen.body = ghost.body;
    // Only what lies in the body counts as its wall layer.
    seen.layer = ((view.depth / body.report.spacing) as u32).max(u32::from(view.continues));
    seen.sight = view.sight;
    let reached = body.shape.signed_distance(&seen.mirror());
    seen.has_mirror = (reached - view.depth).abs() < 0.1 * view.depth;
    if case.scheme.equations == Equations::Conservative {
        let above = seen.foot() + view.normal * (0.1 * case.spacing);
        seen.origin_curvature = shape_operator(&body.shape, &above, case.spacing);
    }
    seen
}

/// Mirrors the state of the gas at the wall. `arm` is the distance along the normal from the
/// ghost to where the gas was read.
fn show<const D: usize>(
    ghost: &mut Ghost<D>,
    gas: &Interpolated<D>,
    arm: f64,
    kind: WallKind,
    equations: Equations,
    gamma: f64,
) {
    let wall = ghost.wall_velocity;
    ghost.velocity = match kind {
        // Eqs 26-28 with the normal into the gas: the normal component relative to the wall
        // turns round, or all of the relative velocity.
        WallKind::Slip => {
            gas.velocity - ghost.normal * (2.0 * (gas.velocity - wall).dot(&ghost.normal))
        }
        WallKind::NoSlip => wall * 2.0 - gas.velocity,
    };
    // Beyond a slip wall the flow is the mirror image; beyond the other kind it is none, and the viscosity
    // there stays whole.
    ghost.strain = match kind {
        WallKind::Slip => {
            let mirror = Matrix::identity() - ghost.normal * ghost.normal.transpose() * 2.0;
            mirror * gas.strain * mirror
        }
        WallKind::NoSlip => Matrix::zeros(),
    };
    // Eqs 29-30: dp/dn = -rho a.n, so a wall that accelerates into the gas raises the pressure; gas
    // that slides along a bent wall is accelerated by its bend, and by the turn of a turning one.
    let slide = gas.velocity - wall;
    let slide = slide - ghost.normal * slide.dot(&ghost.normal);
    let density = gas.pressure / ((gamma - 1.0) * gas.energy);
    let slope = density
        * (ghost.wall_acceleration.dot(&ghost.normal) + ghost.coriolis.dot(&slide)
            - slide.dot(&(ghost.curvature * slide)));
    ghost.pressure = continued(gas.pressure, arm * slope);
    ghost.wall_pressure = continued(gas.pressure, (arm - ghost.depth) * slope);
    ghost.energy = gas.energy;
    if equations == Equations::Conservative && slope != 0.0 {
        // Pressure varies across the layer at the wall, entropy hardly [Dadone & Grossman 1994].
        ghost.energy *= (ghost.pressure / gas.pressure).powf((gamma - 1.0) / gamma);
    }
    ghost.density = ghost.pressure / ((gamma - 1.0) * ghost.energy);
}

/// A pressure that rises by `rise` to first order, and stays positive where it falls.
fn continued(pressure: f64, rise: f64) -> f64 {
    if rise < 0.0 {
        pressure * pressure / (pressure - rise)
    } else {
        pressure + rise
    }
}
