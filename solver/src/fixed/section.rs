//! The part of a plane polygon that the bodies leave to the gas: loops of stretches of the polygon's edges and of paths
//! along the walls between them.
//!
//! The paths follow the surface from where it enters the polygon to where it leaves it. Between two smooth faces they turn
//! where the faces' tangents meet, so that edges of bodies are kept sharp; a bent wall is halved once.

use aero_geometry::Vector;

use super::polytope::cross;
use super::solids::{Line, Solids};

/// Cosine of the angle between two normals of one smooth face below which it is looked at for a corner.
const ONE_FACE: f64 = 0.9;

/// Cosine above which a wall between two points is a straight line: a twelfth of a degree.
const STRAIGHT: f64 = 1.0 - 1e-6;

/// Distance in spacings from the surface at which a corner counts as found.
const ON_SURFACE: f64 = 0.02;

/// How often a path is halved in search of its corners.
const HALVINGS: u32 = 4;

/// The polygon's plane: right-handed axes in it, seen from outside; the rest of space is not looked at.
#[derive(Clone, Copy, Debug)]
pub struct Plane<const D: usize> {
    axes: [Vector<D>; 2],
}

impl<const D: usize> Plane<D> {
    /// The plane of a scene in the plane.
    pub fn flat() -> Self {
        let axis = |k: usize| Vector::from_fn(|row, _| f64::from(u8::from(row == k)));
        Self {
            axes: [axis(0), axis(1)],
        }
    }

    /// The plane across a unit vector.
    pub fn across(normal: &Vector<D>) -> Self {
        let thin = normal.iamin();
        let mut first = Vector::<D>::zeros();
        first[thin] = 1.0;
        let first = (first - normal * normal[thin]).normalize();
        Self {
            axes: [first, cross(normal, &first)],
        }
    }

    fn coordinates(&self, vector: &Vector<D>) -> [f64; 2] {
        self.axes.map(|axis| axis.dot(vector))
    }

    fn vector(&self, [u, v]: [f64; 2]) -> Vector<D> {
        self.axes[0] * u + self.axes[1] * v
    }
}

/// What a stretch of a loop runs along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// An edge of the polygon, by number, and which of the edge's stretches in the gas it is.
    Edge(usize, usize),
    /// The wall: body and smooth face.
    Wall(u32, u32),
}

/// A straight stretch of a loop.
#[derive(Clone, Copy, Debug)]
pub struct Stretch<const D: usize> {
    /// Start, from the cell's point.
    pub from: Vector<D>,
    /// End.
    pub to: Vector<D>,
    /// What it runs along.
    pub along: Along,
}

impl<const D: usize> Stretch<D> {
    /// Its middle.
    pub fn middle(&self) -> Vector<D> {
        (self.from + self.to) * 0.5
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        (self.to - self.from).norm()
    }
}

/// One piece of the gas in the polygon: a closed loop with the gas to its left.
pub type Piece<const D: usize> = Vec<Stretch<D>>;

/// A polygon to be cut.
#[derive(Clone, Copy, Debug)]
pub struct Section<'a, const D: usize> {
    /// The bodies.
    pub solids: &'a Solids<D>,
    /// The cell's point, from which all else is measured.
    pub origin: &'a Vector<D>,
    /// Where the polygon lies.
    pub plane: Plane<D>,
    /// Spacing of the points here.
    pub unit: f64,
}

/// An edge of the polygon with where it crosses the surface, as parts of its length in order.
#[derive(Clone, Debug)]
pub struct Edge<const D: usize> {
    /// Start.
    pub from: Vector<D>,
    /// End.
    pub to: Vector<D>,
    /// True where it starts in the gas.
    pub starts_in_gas: bool,
    /// Crossings, from the start.
    pub crossings: Vec<f64>,
    /// True where its stretches are numbered from its end.
    pub is_reversed: bool,
}

impl<const D: usize> Section<'_, D> {
    /// The gas within the polygon of these edges.
    pub fn gas(&self, edges: &[Edge<D>]) -> Vec<Piece<D>> {
        let arcs = arcs(edges);
        if arcs.is_empty() {
            return Vec::new();
        }
        if edges.iter().all(|edge| edge.crossings.is_empty()) {
            return arcs;
        }
        let group = self.joined(&arcs);
        let mut pieces = Vec::new();
        for first in 0..arcs.len() {
            if group[first] != first {
                continue;
            }
            let members: Vec<usize> = (0..arcs.len()).filter(|&a| group[a] == first).collect();
            let mut piece = Piece::new();
            for (k, &member) in members.iter().enumerate() {
                let next = &arcs[members[(k + 1) % members.len()]];
                piece.extend_from_slice(&arcs[member]);
                let end = arcs[member][arcs[member].len() - 1].to;
                self.follow_wall(&end, &next[0].from, &mut piece);
            }
            pieces.push(piece);
        }
        pieces
    }

    /// To which arc, the first of them, each arc is connected through gas: those that see each other.
    fn joined(&self, arcs: &[Piece<D>]) -> Vec<usize> {
        let mut group: Vec<usize> = (0..arcs.len()).collect();
        for b in 1..arcs.len() {
            for a in 0..b {
                if group[a] == group[b] || !self.sees(&sample(&arcs[a]), &sample(&arcs[b])) {
                    continue;
                }
                let (kept, lost) = (group[a].min(group[b]), group[a].max(group[b]));
                group
                    .iter_mut()
                    .filter(|g| **g == lost)
                    .for_each(|g| *g = kept);
            }
        }
        group
    }

    /// True where no body is between two points.
    pub fn sees(&self, a: &Vector<D>, b: &Vector<D>) -> bool {
        self.solids.sees(&Line {
            from: self.origin + a,
            to: self.origin + b,
            unit: self.unit,
        })
    }

    fn follow_wall(&self, from: &Vector<D>, to: &Vector<D>, path: &mut Piece<D>) {
        if let (Some(start), Some(end)) = (self.foot(from), self.foot(to)) {
            self.follow(&start, &end, HALVINGS, path);
        }
    }

    fn foot(&self, place: &Vector<D>) -> Option<Foot<D>> {
        let (body, closest) = self.solids.closest(&(self.origin + place))?;
        Some(Foot {
            place: *place,
            normal: self.plane.coordinates(&closest.normal),
            full: closest.normal,
            face: (body, closest.face),
        })
    }

    fn follow(&self, start: &Foot<D>, end: &Foot<D>, halvings: u32, path: &mut Piece<D>) {
        let apart = end.place - start.place;
        let cosine = start.full.dot(&end.full);
        let same = start.face == end.face && cosine > ONE_FACE;
        if apart.norm() < 1e-9 * self.unit || same && cosine > STRAIGHT {
            path.push(start.stretch_to(&end.place));
            return;
        }
        if !same && let Some(corner) = self.corner(start, end) {
            path.push(start.stretch_to(&corner));
            path.push(Stretch {
                from: corner,
                ..end.stretch_to(&end.place)
            });
            return;
        }
        if halvings > 0
            && let Some(middle) = self.between(start, end)
        {
            // One halving is enough for a bend; corners take what it takes.
            let left = if same { 0 } else { halvings - 1 };
            self.follow(start, &middle, left, path);
            self.follow(&middle, end, left, path);
            return;
        }
        let middle = start.place + apart * 0.5;
        path.push(start.stretch_to(&middle));
        path.push(Stretch {
            from: middle,
            ..end.stretch_to(&end.place)
        });
    }

    /// Where the tangents of two faces meet, if that is on the surface.
    fn corner(&self, start: &Foot<D>, end: &Foot<D>) -> Option<Vector<D>> {
        const LEAST_ANGLE: f64 = 0.05;
        let (a, b) = (unit(start.normal)?, unit(end.normal)?);
        let determinant = a[0] * b[1] - a[1] * b[0];
        if determinant.abs() < LEAST_ANGLE {
            return None;
        }
        let [u, v] = self.plane.coordinates(&(end.place - start.place));
        let along = (b[0] * u + b[1] * v) / determinant;
        let corner = start.place + self.plane.vector([-a[1] * along, a[0] * along]);
        let height = self.solids.distance(&(self.origin + corner));
        (height.abs() < ON_SURFACE * self.unit).then_some(corner)
    }

    /// The surface above or below the middle of the line between two of its points.
    fn between(&self, start: &Foot<D>, end: &Foot<D>) -> Option<Foot<D>> {
        let apart = end.place - start.place;
        let middle = start.place + apart * 0.5;
        let point = self.origin + middle;
        let height = self.solids.height(&point);
        let [u, v] = self.plane.coordinates(&apart);
        // The gas is to the left of the loop, the body to its right.
        let left = self.plane.vector([-v, u]) / apart.norm();
        let way = if height > 0.0 { -left } else { left };
        let to = point + way * (apart.norm() + 0.25 * self.unit);
        let line = Line {
            from: point,
            to,
            unit: self.unit,
        };
        let ends = [height, self.solids.height(&to)];
        let found = self.solids.crossings(&line, ends);
        self.foot(&(line.at(*found.first()?) - self.origin))
    }
}

/// A point on the wall.
#[derive(Clone, Copy, Debug)]
struct Foot<const D: usize> {
    place: Vector<D>,
    /// Normal in the polygon's plane, not of unit length.
    normal: [f64; 2],
    full: Vector<D>,
    face: (u32, u32),
}

impl<const D: usize> Foot<D> {
    fn stretch_to(&self, to: &Vector<D>) -> Stretch<D> {
        Stretch {
            from: self.place,
            to: *to,
            along: Along::Wall(self.face.0, self.face.1),
        }
    }
}

fn unit([u, v]: [f64; 2]) -> Option<[f64; 2]> {
    let length = u.hypot(v);
    (length > 1e-6).then(|| [u / length, v / length])
}

/// A point of an arc away from its ends.
fn sample<const D: usize>(arc: &Piece<D>) -> Vector<D> {
    let longest = arc.iter().reduce(|best, next| {
        if next.length() > best.length() {
            next
        } else {
            best
        }
    });
    longest.map_or_else(Vector::zeros, Stretch::middle)
}

/// The connected stretches of the polygon's outline in the gas.
fn arcs<const D: usize>(edges: &[Edge<D>]) -> Vec<Piece<D>> {
    let mut arcs: Vec<Piece<D>> = Vec::new();
    let mut goes_on = false;
    for (number, edge) in edges.iter().enumerate() {
        let mut in_gas = edge.starts_in_gas;
        let mut from = edge.from;
        let stretches = edge.crossings.len() + 1;
        for k in 0..stretches {
            let to = edge
                .crossings
                .get(k)
                .map_or(edge.to, |part| edge.from + (edge.to - edge.from) * *part);
            if in_gas {
                let place = if edge.is_reversed {
                    stretches - 1 - k
                } else {
                    k
                };
                if !goes_on {
                    arcs.push(Piece::new());
                }
                let arc = arcs.len() - 1;
                arcs[arc].push(Stretch {
                    from,
                    to,
                    along: Along::Edge(number, place),
                });
            }
            goes_on = in_gas && k + 1 == stretches;
            in_gas = !in_gas;
            from = to;
        }
    }
    let begins_in_gas = edges.first().is_some_and(|edge| edge.starts_in_gas);
    if goes_on && begins_in_gas && arcs.len() > 1 {
        let first = arcs.remove(0);
        let last = arcs.len() - 1;
        arcs[last].extend(first);
    }
    arcs
}
