//! From loose pieces to an outline: joining, orientation, and numbering of smooth faces.

use parry2d::bounding_volume::Aabb;
use parry2d::partitioning::{Bvh, BvhBuildStrategy};

use super::check;
use super::creases::Pieces;
use super::piece::{Piece, cross};
use super::{Chain, Corner, Ends, FEW_PIECES, Joint, NO_JOINT, Outline, Search, measure, symmetry};
use crate::error::GeometryError;
use crate::{Bounds, Placement, Vector};

impl Outline {
    /// An outline from chains of pieces, each closed or endless, with the solid to the left of
    /// the direction of travel. A closed chain that runs clockwise is turned round when it is the
    /// only one; beside others it is a hole.
    ///
    /// # Errors
    /// Pieces that are not finite, do not meet, cross or touch.
    pub fn new(chains: Vec<Vec<Piece>>) -> Result<Self, GeometryError> {
        Self::checked(chains, false, Pieces::Exact)
    }

    /// An outline whose joints separate faces where these are not samples of a curve.
    pub(crate) fn sampled(chains: Vec<Vec<Piece>>) -> Result<Self, GeometryError> {
        Self::checked(chains, false, Pieces::Samples)
    }

    /// The meridian of a body of revolution about `y = 0`: one chain in `y >= 0`, either closed
    /// or from the axis to the axis.
    pub(crate) fn meridian(pieces: Vec<Piece>) -> Result<Self, GeometryError> {
        let outline = Self::checked(vec![pieces], true, Pieces::Exact)?;
        if outline.bounds.min.y < -check::SAME_POINT * outline.size {
            return Err(GeometryError::Curve(
                "a meridian must not pass below the axis y = 0".into(),
            ));
        }
        Ok(outline)
    }

    /// The outline scaled, turned and moved.
    #[must_use]
    pub fn placed(&self, placement: &Placement<2>) -> Self {
        let pieces = self.pieces.iter().map(|p| p.placed(placement)).collect();
        Self::assemble(pieces, self.chains.clone(), self.stand_for)
    }

    pub(super) fn checked(
        chains: Vec<Vec<Piece>>,
        axis: bool,
        stand_for: Pieces,
    ) -> Result<Self, GeometryError> {
        let alone = chains.len() == 1;
        let mut pieces: Vec<Piece> = Vec::new();
        let mut runs = Vec::new();
        for mut chain in chains {
            let ends = check::chain(&chain, axis)?;
            if ends != Ends::Endless {
                let area = measure::signed_area(&chain);
                let size = finite_bounds(&chain).size().max();
                if area.abs() <= 1e-12 * size * size {
                    return Err(GeometryError::Curve(
                        "encloses no area; give a curve around a solid".into(),
                    ));
                }
                if area < 0.0 && alone {
                    chain = chain.iter().rev().map(Piece::reversed).collect();
                }
            }
            let first = pieces.len();
            pieces.extend(chain);
            runs.push(Chain {
                pieces: first..pieces.len(),
                ends,
                length: 0.0,
            });
        }
        if pieces.is_empty() {
            return Err(GeometryError::Curve("has no pieces".into()));
        }
        let outline = Self::assemble(pieces, runs, stand_for);
        outline.refuse_crossings()?;
        Ok(outline)
    }

    fn assemble(pieces: Vec<Piece>, chains: Vec<Chain>, stand_for: Pieces) -> Self {
        let extent = finite_bounds(&pieces);
        let size = extent.size().max();
        let mut outline = Self {
            faces: Vec::with_capacity(pieces.len()),
            ends: vec![[NO_JOINT; 2]; pieces.len()],
            joints: Vec::new(),
            corners: Vec::new(),
            mirrors: Vec::new(),
            bounds: bounds(&pieces, &chains),
            size: if size > 0.0 { size } else { 1.0 },
            search: search(&pieces),
            pieces,
            chains,
            stand_for,
        };
        for index in 0..outline.chains.len() {
            let range = outline.chains[index].pieces.clone();
            outline.chains[index].length = outline.pieces[range].iter().map(Piece::length).sum();
            outline.join(index);
        }
        outline.mirrors = symmetry::mirrors(&outline, &extent);
        outline
    }

    /// Makes the joints, corners and face numbers of one chain.
    fn join(&mut self, chain: usize) {
        let Chain { pieces, ends, .. } = self.chains[chain].clone();
        let (first, last) = (pieces.start, pieces.end - 1);
        let mut turns = vec![None; pieces.len()];
        let mut joints = Vec::new();
        for index in pieces.clone() {
            let before = match ends {
                _ if index > first => index - 1,
                Ends::Closed => last,
                Ends::Axis | Ends::Endless => continue,
            };
            let joint = Joint::between(&self.pieces, [before, index]);
            self.ends[before][1] = self.joints.len() as u32;
            self.ends[index][0] = self.joints.len() as u32;
            self.joints.push(joint);
            turns[index - first] = Some(joint.turn);
            joints.push(joint);
        }
        let lengths: Vec<f64> = self.pieces[pieces.clone()]
            .iter()
            .map(Piece::length)
            .collect();
        let creased = self.stand_for.creases(&turns, &lengths);
        for joint in joints {
            if creased[joint.pieces[1] - first] {
                self.corners.push(Corner {
                    point: joint.point,
                    pieces: joint.pieces,
                    interior_angle: std::f64::consts::PI - joint.turn,
                    bisector: joint.bisector,
                });
            }
        }
        if ends == Ends::Axis {
            self.join_axis(first, last);
        }
        let start = self.faces.iter().max().map_or(0, |&face| face + 1);
        let mut face = start;
        for (place, &crease) in creased.iter().enumerate() {
            if crease && place > 0 {
                face += 1;
            }
            self.faces.push(face);
        }
        if !creased[0] && face > start {
            // The last face runs on through the first piece.
            for number in &mut self.faces[pieces] {
                if *number == face {
                    *number = start;
                }
            }
        }
    }

    /// Joints on the axis, where a meridian meets its mirror image.
    fn join_axis(&mut self, first: usize, last: usize) {
        let after = self.pieces[first].tangent(self.pieces[first].range()[0]);
        let before = self.pieces[last].tangent(self.pieces[last].range()[1]);
        let mirrored = |t: &Vector<2>| Vector::<2>::new(-t.x, t.y);
        self.ends[first][0] = self.joints.len() as u32;
        self.ends[last][1] = self.joints.len() as u32 + 1;
        self.joints.extend([
            Joint::new(
                self.pieces[first].start(),
                &mirrored(&after),
                &after,
                [first, first],
            ),
            Joint::new(
                self.pieces[last].end(),
                &before,
                &mirrored(&before),
                [last, last],
            ),
        ]);
    }
}

/// The box around the finite points of all pieces; empty where there are none.
fn finite_bounds(pieces: &[Piece]) -> Bounds<2> {
    let mut all = Bounds::new(
        Vector::<2>::repeat(f64::INFINITY),
        Vector::<2>::repeat(f64::NEG_INFINITY),
    );
    for piece in pieces {
        let bounds = piece.bounds();
        let ends = [piece.start(), piece.end(), bounds.min, bounds.max];
        for point in ends.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
            all.min = all.min.inf(point);
            all.max = all.max.sup(point);
        }
    }
    if all.is_empty() {
        let origin = match pieces.first() {
            Some(Piece::Line(line)) => line.origin(),
            _ => Vector::<2>::zeros(),
        };
        return Bounds::new(origin, origin);
    }
    all
}

/// The box around the solid: infinite where an endless chain's solid is.
fn bounds(pieces: &[Piece], chains: &[Chain]) -> Bounds<2> {
    let mut all = finite_bounds(pieces);
    for chain in chains.iter().filter(|c| c.ends == Ends::Endless) {
        // At infinity the solid fills the sector counter-clockwise from where the chain leaves
        // to where it comes from.
        let last = &pieces[chain.pieces.end - 1];
        let first = &pieces[chain.pieces.start];
        let leaving = last.tangent(0.0);
        let coming = -first.tangent(0.0);
        let opening = angle_between(&leaving, &coming);
        for axis in 0..2 {
            for sign in [-1.0, 1.0] {
                let mut direction = Vector::<2>::zeros();
                direction[axis] = sign;
                let reached = angle_between(&leaving, &direction) <= opening
                    || leaving.dot(&direction) > 1e-12
                    || coming.dot(&direction) > 1e-12;
                if reached && sign < 0.0 {
                    all.min[axis] = f64::NEG_INFINITY;
                } else if reached {
                    all.max[axis] = f64::INFINITY;
                }
            }
        }
    }
    all
}

/// Angle from `a` counter-clockwise to `b`, in `0..2 pi`.
fn angle_between(a: &Vector<2>, b: &Vector<2>) -> f64 {
    cross(a, b)
        .atan2(a.dot(b))
        .rem_euclid(std::f64::consts::TAU)
}

fn search(pieces: &[Piece]) -> Option<Search> {
    if pieces.len() <= FEW_PIECES {
        return None;
    }
    let boxes = pieces.iter().map(|piece| {
        let Bounds { min, max } = piece.bounds();
        Aabb::new(
            parry2d::math::Vector::new(min.x, min.y),
            parry2d::math::Vector::new(max.x, max.y),
        )
    });
    let (finite, endless): (Vec<_>, Vec<_>) = boxes
        .enumerate()
        .partition(|&(index, _)| pieces[index].length().is_finite());
    Some(Search {
        tree: Bvh::from_iter(BvhBuildStrategy::Binned, finite),
        endless: endless.into_iter().map(|(index, _)| index as u32).collect(),
    })
}
