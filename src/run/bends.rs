//! Sharp convex bends of walls in a stream faster than sound, of particles, at the end of a run: a fan stands at one, which kernels smear and
//! which rings, so that pressures behind it are wrong over a number of spacings, however small these are.

use aero_geometry::{Bounds, Crease, Vector};
use aero_packer::{About, Warning};
use aero_solver::frame::PanelFrame;
use aero_solver::problem::Problem;

/// Turns that are told of, degrees: of less the fan is weak, and gas does not follow farther.
const TURNS: [f64; 2] = [10.0, 50.0];

/// Mach number of the gas on both sides, across the edge, from which on a fan stands there.
const FAST: f64 = 1.05;

/// Places along what the domain holds of an edge in space where the gas is asked.
const PLACES: usize = 9;

/// Cosine between normals of a panel and of the side of an edge that it belongs to.
const ALIKE: f64 = 0.999;

/// What there is to say of the bends of the bodies of a flow with these `panels`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, panels: &PanelFrame) -> Vec<Warning> {
    if problem.method.fixed().is_some() {
        return Vec::new();
    }
    let where_they_are = match D {
        2 => in_the_plane(problem.bodies.len(), panels),
        3 => in_space(problem, panels),
        _ => None,
    };
    let Some(where_they_are) = where_they_are else {
        return Vec::new();
    };
    let text = format!(
        "behind {where_they_are}, particles show wall pressures that are too high for six spacings and off by 5 % up to twenty, by a third where the pressure \
         falls below a fifth, however small spacings are; take points that stay (`scheme.motion = \"fixed\"`) for pressures there"
    );
    vec![Warning::new(About::Scene, text)]
}

/// The bends of so many bodies in the plane, in words.
fn in_the_plane(bodies: usize, panels: &PanelFrame) -> Option<String> {
    let bends: Vec<[f64; 3]> = (1..panels.body.len())
        .filter(|&n| (panels.body[n] as usize) < bodies)
        .filter_map(|n| bend(panels, n))
        .collect();
    let [x, y, _] = bends.first()?;
    Some(match bends.len() {
        1 => format!("the sharp convex bend at ({x:.4}, {y:.4})"),
        many => format!("{many} sharp convex bends, the first at ({x:.4}, {y:.4})"),
    })
}

/// The first edge of a body at rest in space at which a fan stands, in words.
fn in_space<const D: usize>(problem: &Problem<D>, panels: &PanelFrame) -> Option<String> {
    let domain = problem.domain.bounds;
    let stream = problem.free_stream.velocity;
    let resting = problem.bodies.iter().enumerate();
    let resting = resting.filter(|(_, body)| !body.motion.is_moving());
    let edges = resting.flat_map(|(n, body)| {
        let creases = body.shape.creases(problem.resolution.lattice(), &domain);
        let ridges = creases.into_iter().filter(|crease| crease.is_convex);
        ridges.map(move |ridge| (n as u32, ridge))
    });
    let fastest = panels.mach.iter().copied().fold(0.0, f64::max);
    let mut told = edges.filter(|(_, ridge)| is_told_of(ridge.turn().to_degrees()));
    let place = told.find_map(|(body, ridge)| {
        let crossings = ridge
            .normals
            .map(|normal| crossing(&ridge, &normal, &stream));
        if !crossings.iter().all(|part| part * fastest > FAST) {
            return None;
        }
        let sides = ridge.normals.map(|normal| side(panels, body, &normal));
        let [from, to] = part_in(&ridge.ends, &domain)?;
        let mut places = (0..PLACES)
            .map(|k| (k as f64 + 0.5) / PLACES as f64)
            .map(|part| from.lerp(&to, part));
        places.find(|place| {
            let mut sides = sides.iter().zip(crossings);
            sides.all(|(side, part)| {
                let mach = mach_beside(panels, side, place);
                mach.is_some_and(|mach| mach * part > FAST)
            })
        })
    })?;
    let place = place.iter().map(|x| format!("{x:.4}")).collect::<Vec<_>>();
    Some(format!(
        "sharp convex edges, as that at ({})",
        place.join(", ")
    ))
}

/// The part of a line between two `ends` that lies in a box.
fn part_in<const D: usize>(ends: &[Vector<D>; 2], bounds: &Bounds<D>) -> Option<[Vector<D>; 2]> {
    let way = ends[1] - ends[0];
    let [mut first, mut last] = [0.0_f64, 1.0_f64];
    for k in 0..D {
        if way[k] == 0.0 {
            let is_between = (bounds.min[k]..=bounds.max[k]).contains(&ends[0][k]);
            if is_between {
                continue;
            }
            return None;
        }
        let [a, b] = [bounds.min[k], bounds.max[k]].map(|face| (face - ends[0][k]) / way[k]);
        (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
    }
    (first <= last).then(|| [first, last].map(|part| ends[0] + way * part))
}

/// The part of the velocity of gas that follows the stream on the side of an edge with this normal that is across the edge.
fn crossing<const D: usize>(ridge: &Crease<D>, normal: &Vector<D>, stream: &Vector<D>) -> f64 {
    let along = (ridge.ends[1] - ridge.ends[0]).normalize();
    let flow = (stream - normal * normal.dot(stream)).normalize();
    (flow - along * along.dot(&flow)).norm()
}

/// The panels of a body that face along `normal`.
fn side<const D: usize>(panels: &PanelFrame, body: u32, normal: &Vector<D>) -> Vec<usize> {
    let dot = |n: usize| (0..D).map(|k| panels.normal[n][k] * normal[k]).sum::<f64>();
    (0..panels.body.len())
        .filter(|n| panels.body[*n] == body && dot(*n) > ALIKE)
        .collect()
}

/// The Mach number on the nearest of these panels.
fn mach_beside<const D: usize>(
    panels: &PanelFrame,
    side: &[usize],
    place: &Vector<D>,
) -> Option<f64> {
    let distance = |n: usize| {
        let middle = panels.middle(n);
        (Vector::<D>::from_fn(|k, _| middle[k]) - place).norm_squared()
    };
    side.iter()
        .min_by(|a, b| distance(**a).total_cmp(&distance(**b)))
        .map(|n| panels.mach[*n])
}

fn is_told_of(turn: f64) -> bool {
    turn > TURNS[0] && turn < TURNS[1]
}

/// Where panel `n` of the plane and the one before it meet at such a bend.
fn bend(panels: &PanelFrame, n: usize) -> Option<[f64; 3]> {
    let corner = panels.points[2 * n];
    let fast = panels.mach[n - 1].min(panels.mach[n]) > FAST;
    if !fast || panels.body[n - 1] != panels.body[n] || panels.points[2 * n - 1] != corner {
        return None;
    }
    let [before, behind] = [panels.normal[n - 1], panels.normal[n]];
    let (a, b) = (panels.middle(n - 1), panels.middle(n));
    // Normals part where it is convex.
    let part: f64 = (0..2)
        .map(|k| (b[k] - a[k]) * (behind[k] - before[k]))
        .sum();
    let cosine: f64 = (0..2).map(|k| before[k] * behind[k]).sum();
    let turn = cosine.clamp(-1.0, 1.0).acos().to_degrees();
    (part > 0.0 && is_told_of(turn)).then_some(corner)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two panels that meet at the origin, the second turned by so many degrees, down where that is below zero; gas above.
    fn panels(degrees: f64, mach: [f64; 2]) -> PanelFrame {
        let (s, c) = degrees.to_radians().sin_cos();
        PanelFrame {
            corners: 2,
            points: vec![[-1.0, 0.0, 0.0], [0.0; 3], [0.0; 3], [c, s, 0.0]],
            normal: vec![[0.0, 1.0, 0.0], [-s, c, 0.0]],
            mach: mach.to_vec(),
            body: vec![0; 2],
            ..PanelFrame::default()
        }
    }

    #[test]
    fn convex_bends_in_fast_gas_are_told_and_no_others() {
        let is_told = |degrees: f64, mach| bend(&panels(degrees, mach), 1).is_some();
        assert!(is_told(-15.0, [2.0, 2.5]));
        assert!(!is_told(15.0, [2.0, 1.5]), "concave");
        assert!(!is_told(-8.0, [2.0, 2.2]) && !is_told(-90.0, [2.0, 2.0]));
        assert!(!is_told(-15.0, [0.8, 1.2]), "slow");
        let mut apart = panels(-15.0, [2.0, 2.5]);
        apart.points[2][0] = 0.1;
        assert_eq!(bend(&apart, 1), None);
    }

    #[test]
    fn edges_are_asked_where_they_lie_in_the_domain() {
        let bounds = Bounds::new(Vector::<3>::zeros(), Vector::repeat(0.4));
        let part = |from: [f64; 3], to: [f64; 3]| part_in(&[from, to].map(Vector::from), &bounds);
        let [low, high] = part([0.1, 0.2, -7.0], [0.1, 0.2, 5.0]).expect("a part");
        assert!(
            (low - Vector::<3>::new(0.1, 0.2, 0.0)).norm() < 1e-12,
            "{low}"
        );
        assert!(
            (high - Vector::<3>::new(0.1, 0.2, 0.4)).norm() < 1e-12,
            "{high}"
        );
        // In a face; slanted, from within; past a corner; beside the box.
        let along = part([0.0, 0.4, 0.3], [0.0, 0.4, -1.0]).expect("a part");
        assert!((along[1].z - 0.0).abs() < 1e-12 && (along[0].z - 0.3).abs() < 1e-12);
        let slanted = part([0.2, 0.2, 0.2], [1.2, 0.2, 0.7]).expect("a part");
        assert!((slanted[1] - Vector::<3>::new(0.4, 0.2, 0.3)).norm() < 1e-12);
        assert_eq!(part([-0.3, 0.2, 0.2], [0.2, 0.2, 0.8]), None);
        assert_eq!(part([0.1, 0.5, -7.0], [0.1, 0.5, 5.0]), None);
    }

    #[test]
    fn gas_crosses_edges_by_how_they_are_swept() {
        let (s, c) = (-15_f64).to_radians().sin_cos();
        let ridge = Crease {
            ends: [Vector::<3>::zeros(), Vector::z()],
            normals: [Vector::y(), Vector::<3>::new(-s, c, 0.0)],
            is_convex: true,
        };
        let across = |stream: [f64; 3]| {
            let stream = Vector::from(stream);
            ridge
                .normals
                .map(|normal| crossing(&ridge, &normal, &stream))
        };
        let straight = across([2.0, 0.0, 0.0]);
        assert!(straight.iter().all(|part| (part - 1.0).abs() < 1e-12));
        assert!(across([0.0, 0.0, 2.0]).iter().all(|part| *part < 1e-12));
        let [before, _] = across([1.0, 0.0, 3_f64.sqrt()]);
        assert!((before - 0.5).abs() < 1e-12, "{before}");
        // Of gas at rest nothing crosses.
        assert!(across([0.0; 3]).iter().all(|part| part.is_nan()));
    }

    #[test]
    fn the_gas_beside_an_edge_is_that_of_the_nearest_panel_of_its_side() {
        let square = |x: f64| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 0.0, 1.0]];
        let panels = PanelFrame {
            corners: 3,
            points: [square(-3.0), square(-1.0), square(-0.5), square(-0.5)].concat(),
            normal: vec![
                [0.0, 1.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.6, 0.8, 0.0],
                [0.0, 1.0, 0.0],
            ],
            mach: vec![1.0, 2.0, 3.0, 4.0],
            body: vec![0, 0, 0, 1],
            ..PanelFrame::default()
        };
        let place = Vector::<3>::zeros();
        let beside = |body, normal: [f64; 3]| {
            let side = side(&panels, body, &Vector::from(normal));
            mach_beside(&panels, &side, &place)
        };
        assert_eq!(beside(0, [0.0, 1.0, 0.0]), Some(2.0));
        assert_eq!(beside(0, [0.6, 0.8, 0.0]), Some(3.0));
        assert_eq!(beside(1, [0.6, 0.8, 0.0]), None);
    }
}
