//! Finds the thin parts of the bodies before a run, and makes the views of their ghosts.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Pencils, Shape, Vector};

use super::across::{Across, Foot, across, across_end, beneath, foot_on, is_edge};
use super::numbers::Numbers;
use super::{FaceSet, Faces, Sight, ThinBody};
use crate::neighbourhood::reach::LAYERS;
use crate::problem::{Body, Problem};

/// Reflections by which a thin part is continued at most: as deep as the layers where it is a twelfth of a spacing thick, as slender tips
/// are; what is thinner than a third for long is refused or warned of by the packer.
const REFLECTIONS: usize = 64;

/// A ghost of the face in which a thin part ends is at most this far, in spacings, from one between its faces: the diagonal of a
/// part three spacings thick.
const BESIDE: f64 = 2.5;

/// A ghost as one face sees it, or its image in the body's continuation.
#[derive(Clone, Copy, Debug)]
pub struct View<const D: usize> {
    /// Number of the body.
    pub body: usize,
    /// Number of the ghost in its body.
    pub ghost: usize,
    /// Where it is at time zero.
    pub position: Vector<D>,
    /// Normal of the face that sees it.
    pub normal: Vector<D>,
    /// Depth below that face.
    pub depth: f64,
    /// True for an image beyond the opposite face.
    pub continues: bool,
    /// From where it is seen.
    pub sight: Sight,
}

/// What the thin parts of the bodies need.
#[derive(Clone, Debug)]
pub struct ThinParts<const D: usize> {
    /// Their faces.
    pub faces: Faces<D>,
    /// The views.
    pub views: Vec<View<D>>,
    /// For each body: faces from which a ghost itself is not seen, as its view is.
    pub hidden: Vec<Vec<FaceSet>>,
}

/// The thin parts of the bodies of `problem`; none where no body has any.
pub fn thin_parts<const D: usize>(problem: &Problem<D>) -> Option<ThinParts<D>> {
    let mut parts = ThinParts {
        faces: Faces {
            bodies: Vec::new(),
            opposite: Vec::new(),
            mirrored: std::array::from_fn(|_| Vec::new()),
            spacing: problem.resolution.lattice(),
        },
        views: Vec::new(),
        hidden: Vec::new(),
    };
    for (number, body) in problem.bodies.iter().enumerate() {
        parts.hidden.push(vec![0; body.ghosts.position.len()]);
        let crossings = crossings(body, problem.resolution.lattice());
        let (numbers, pairs) =
            Numbers::new(body.shape.as_ref(), &crossings, parts.faces.opposite.len());
        if pairs.is_empty() {
            continue;
        }
        let count = parts.faces.opposite.len() + numbers.len();
        parts.faces.opposite.resize(count, 0);
        for [a, b] in pairs {
            parts.faces.opposite[a as usize] |= 1 << b;
            parts.faces.opposite[b as usize] |= 1 << a;
        }
        parts.faces.mirror(problem, body, &crossings, &numbers);
        parts.faces.bodies.push(ThinBody {
            number,
            shape: body.shape.clone(),
            bounds: Bounds::new(
                Vector::repeat(f64::INFINITY),
                Vector::repeat(f64::NEG_INFINITY),
            ),
            numbers,
        });
        let ends = ends(body, &crossings, problem.resolution.lattice());
        parts.look_at(problem, body, &[crossings, ends].concat());
    }
    (!parts.faces.bodies.is_empty()).then_some(parts)
}

/// Every ghost of a thin part with the faces on both sides of it.
fn crossings<const D: usize>(body: &Body<D>, spacing: f64) -> Vec<Across<D>> {
    let ghosts = &body.ghosts;
    let limit = LAYERS * spacing;
    (0..ghosts.position.len())
        .into_par_iter()
        .filter_map(|g| {
            let ghost = (g, ghosts.position[g], ghosts.normal[g], -ghosts.distance[g]);
            across(&body.shape, ghost, limit, spacing)
        })
        .collect()
}

/// The ghosts of the faces in which thin parts end, rims and tips cut off, with the faces on both sides of them. They have none
/// opposite to their own face, but the gas beside them is parted all the same.
fn ends<const D: usize>(body: &Body<D>, crossings: &[Across<D>], spacing: f64) -> Vec<Across<D>> {
    let ghosts = &body.ghosts;
    let mut is_between = vec![false; ghosts.position.len()];
    for crossing in crossings {
        is_between[crossing.ghost] = true;
    }
    let places: Vec<Vector<D>> = crossings.iter().map(|c| ghosts.position[c.ghost]).collect();
    let reach = BESIDE * spacing;
    let pencils = Pencils::new(&places, reach);
    (0..ghosts.position.len())
        .into_par_iter()
        .filter(|&g| !is_between[g])
        .filter_map(|g| {
            let place = &ghosts.position[g];
            let mut nearest: Option<(f64, usize)> = None;
            pencils.for_each_run_near(place, place, reach, |run| {
                for &n in &pencils.order()[run] {
                    let found = ((places[n as usize] - place).norm(), n as usize);
                    if found.0 < reach && nearest.is_none_or(|least| found < least) {
                        nearest = Some(found);
                    }
                }
            });
            let beside = &crossings[nearest?.1];
            let ghost = (g, *place, beside.near.normal);
            across_end(&body.shape, ghost, LAYERS * spacing, spacing)
        })
        .collect()
}

impl<const D: usize> ThinParts<D> {
    /// Makes the views of the ghosts of the last body in the list.
    fn look_at(&mut self, problem: &Problem<D>, body: &Body<D>, crossings: &[Across<D>]) {
        let (number, set) = {
            let thin = &self.faces.bodies[self.faces.bodies.len() - 1];
            (thin.number, |foot: &Foot<D>| {
                thin.numbers.set(foot.face, &foot.normal)
            })
        };
        let mut views = Vec::new();
        let mut bounds = self.faces.bodies[self.faces.bodies.len() - 1].bounds;
        for crossing in crossings.iter().filter(|crossing| crossing.has_foot) {
            let (near, far) = (&crossing.near, &crossing.far);
            let sides = [set(near), set(far)];
            if self.faces.opposite(sides[0]) & sides[1] == 0 {
                continue;
            }
            let position = body.ghosts.position[crossing.ghost];
            bounds.min = bounds.min.inf(&position);
            bounds.max = bounds.max.sup(&position);
            let view = |foot: &Foot<D>, position: Vector<D>, only, continues| View {
                body: number,
                ghost: crossing.ghost,
                position,
                normal: foot.normal,
                depth: foot.depth(&position),
                continues,
                sight: Sight { only, hidden: 0 },
            };
            if crossing.is_own {
                let only = self.faces.beside(sides[0], sides[1]);
                self.hidden[number][crossing.ghost] = only;
                views.push(view(far, position, only, false));
            }
            for (from, own, beyond) in [(near, sides[0], far), (far, sides[1], near)] {
                for image in unfolded(
                    &position,
                    from,
                    beyond,
                    LAYERS * problem.resolution.at(&position),
                ) {
                    let seen = beneath(body.shape.as_ref(), &image, problem.resolution.at(&image));
                    let there = self.faces.bodies[self.faces.bodies.len() - 1]
                        .numbers
                        .set(seen.face, &seen.normal);
                    let is_hidden = self.faces.opposite(own) & there != 0
                        && seen.distance > 0.0
                        && !is_edge(&body.shape, &seen, problem.resolution.at(&image));
                    if is_hidden && is_free(problem, number, &image) {
                        let foot =
                            foot_on(&body.shape, &image, from, problem.resolution.at(&image));
                        let only = self.faces.beside(there, own);
                        views.push(view(foot.as_ref().unwrap_or(from), image, only, true));
                    }
                }
            }
        }
        self.views.extend(views);
        let last = self.faces.bodies.len() - 1;
        self.faces.bodies[last].bounds = bounds;
    }
}

/// Images of `point`, a point between two faces, that continue the body beyond the far one as `from` sees it, down to
/// `deepest`: reflected in the far face, then in the near face's image, and so on, which leaves the particles as
/// evenly spaced as they are inside.
fn unfolded<const D: usize>(
    point: &Vector<D>,
    from: &Foot<D>,
    beyond: &Foot<D>,
    deepest: f64,
) -> Vec<Vector<D>> {
    let (mut before, mut mirror) = (*from, *beyond);
    let mut image = *point;
    let mut images = Vec::new();
    for _ in 0..REFLECTIONS {
        image = mirror.reflected(&image);
        let depth = from.depth(&image);
        if depth > deepest || depth <= 0.0 {
            break;
        }
        images.push(image);
        (before, mirror) = (mirror, before.reflected_in(&mirror));
    }
    images
}

/// True where neither another body nor a wall side is.
fn is_free<const D: usize>(problem: &Problem<D>, body: usize, position: &Vector<D>) -> bool {
    let bounds = &problem.domain.bounds;
    let behind_a_wall = (0..D).any(|k| {
        let [low, high] = problem.domain.sides[k];
        (low.is_wall() && position[k] < bounds.min[k])
            || (high.is_wall() && position[k] > bounds.max[k])
    });
    let mut others = problem
        .bodies
        .iter()
        .enumerate()
        .filter(|(n, _)| *n != body);
    !behind_a_wall && !others.any(|(_, other)| other.shape.signed_distance(position) < 0.0)
}

impl<const D: usize> Faces<D> {
    /// Finds the mirror images of the faces of a body, whose bits are the last ones.
    fn mirror(
        &mut self,
        problem: &Problem<D>,
        body: &Body<D>,
        crossings: &[Across<D>],
        numbers: &Numbers<D>,
    ) {
        let lift = 0.5 * problem.resolution.lattice();
        for axis in 0..D {
            let images = &mut self.mirrored[axis];
            images.resize(self.opposite.len(), 0);
            let [low, high] = problem.domain.sides[axis];
            let plane = match (low.is_mirror(), high.is_mirror()) {
                (true, _) => problem.domain.bounds.min[axis],
                (_, true) => problem.domain.bounds.max[axis],
                _ => continue,
            };
            for foot in crossings.iter().flat_map(|c| [&c.near, &c.far]) {
                let own = numbers.set(foot.face, &foot.normal);
                let bit = own.trailing_zeros() as usize;
                if own.count_ones() != 1 || images[bit] != 0 {
                    continue;
                }
                let mut place = foot.point + foot.normal * lift;
                place[axis] = 2.0 * plane - place[axis];
                let seen = body.shape.closest(&place);
                if (seen.distance - lift).abs() < 0.1 * lift {
                    images[bit] = numbers.set(seen.face, &seen.normal);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between faces a tenth of a spacing apart, as at a slender tip, images lie that far from one another down to the deepest layer.
    #[test]
    fn the_thinnest_part_is_continued_through_all_layers() {
        let foot = |height: f64, normal: f64| Foot {
            point: Vector::<2>::new(0.0, height),
            normal: Vector::<2>::new(0.0, normal),
            face: 0,
        };
        let (near, far) = (foot(0.05, 1.0), foot(-0.05, -1.0));
        let images = unfolded(&Vector::<2>::new(0.3, 0.0), &near, &far, LAYERS);
        for (n, image) in images.iter().enumerate() {
            let expected = Vector::<2>::new(0.3, -0.1 * (n + 1) as f64);
            assert!((image - expected).norm() < 1e-12, "{n}: {image}");
        }
        assert!(images.len() as f64 > LAYERS / 0.1 - 1.5, "{}", images.len());
    }
}
