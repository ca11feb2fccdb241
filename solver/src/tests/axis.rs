//! Round bodies: ghosts on the axis, to which the surface all around is as near, show the gas on every side the same.

use aero_geometry::{Mesh, Placed, Placement, bodies};

use super::seam::body_on_the_lattice;
use super::*;

/// Cells of the box across the cone: its axis is in the middle of one, or between them.
const ACROSS: [usize; 2] = [21, 22];

/// A cone, round or of so many facets, in a stream along its axis, its ghosts on the gas's lattice, which is its own mirror image
/// about the axis.
fn cone(across: usize, facets: Option<usize>) -> Problem<3> {
    let mut problem = cube::<3>(across, Side::Periodic);
    let cone = bodies::cone(15.0, 1.2).expect("a cone");
    let middle = 0.5 * problem.domain.bounds.max;
    let place = Placement::default().moved(Vector::<3>::new(0.43, middle[1], middle[2]));
    let shape: Arc<dyn Shape<3>> = if let Some(facets) = facets {
        let mesh = Mesh::from_facets(cone.tessellate(facets)).expect("a mesh");
        Arc::new(Placed::new(mesh, place))
    } else {
        Arc::new(Placed::new(cone, place))
    };
    let body = body_on_the_lattice(&problem, shape);
    problem.bodies.push(body);
    problem.free_stream.velocity = Vector::<3>::new(2.0, 0.0, 0.0);
    problem
}

#[test]
fn a_stream_along_a_cone_does_not_press_it_aside() {
    for (across, facets) in ACROSS.into_iter().flat_map(|a| [(a, None), (a, Some(24))]) {
        let mut simulation = start(cone(across, facets));
        advance(&mut simulation, 1);
        let force = simulation.loads()[0].force;
        let aside = force[1].hypot(force[2]);
        assert!(
            force[0] > 0.1 && aside < 1e-4 * force[0],
            "{across} {facets:?}: {force:?}"
        );
    }
}

#[test]
fn a_ghost_on_the_axis_of_a_cone_shows_what_is_all_around() {
    for facets in [None, Some(24), Some(25)] {
        let simulation = start(cone(ACROSS[0], facets));
        let middle = 0.5 * simulation.problem.domain.bounds.max;
        let mut shown: Vec<(f64, usize, Vector<3>)> = Vec::new();
        for ghost in &simulation.walls.ghosts {
            let (place, bend) = (ghost.position, ghost.origin.curvature);
            let aside = (place[1] - middle[1]).hypot(place[2] - middle[2]);
            if ghost.sight.is_view() || aside > 1e-9 || ghost.normal[0] > 0.0 {
                continue;
            }
            // The surface bends along itself.
            let across = (bend * ghost.normal).norm();
            assert!(across <= 0.1 * bend.norm(), "{facets:?}: {bend}");
            let known = shown.iter().position(|(x, ..)| *x == place[0]);
            let at = known.unwrap_or_else(|| {
                shown.push((place[0], 0, Vector::zeros()));
                shown.len() - 1
            });
            shown[at].1 += 1;
            shown[at].2 += ghost.normal;
        }
        assert!(shown.len() > 4, "{shown:?}");
        for (x, count, normal) in shown {
            let aside = normal[1].hypot(normal[2]);
            assert!(
                count >= facets.unwrap_or(16) && aside < 1e-6,
                "{facets:?} at {x}: {count}, {normal:?}"
            );
        }
    }
}
