//! Refusing curves that bound no solid: broken, degenerate or self-crossing ones.

use super::piece::Piece;
use super::{Ends, Outline, crossing};
use crate::error::GeometryError;
use crate::{Bounds, Vector};

/// Ends that lie this close, relative to the outline's size, are one point.
pub(super) const SAME_POINT: f64 = 1e-9;

/// Checks that the pieces of one chain are sound and meet, and says how the chain ends.
pub(super) fn chain(pieces: &[Piece], axis: bool) -> Result<Ends, GeometryError> {
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else {
        return Err(GeometryError::Curve("has a chain without pieces".into()));
    };
    let mut size = 0.0_f64;
    for (index, piece) in pieces.iter().enumerate() {
        sound(index, piece)?;
        if piece.length().is_finite() {
            size = size.max(piece.bounds().size().max());
        }
    }
    let tolerance = SAME_POINT * if size > 0.0 { size } else { 1.0 };
    for (index, pair) in pieces.windows(2).enumerate() {
        let (end, start) = (pair[0].end(), pair[1].start());
        let gap = (end - start).norm();
        // Between two points at infinity the gap is not a number.
        if gap.is_nan() || gap > tolerance {
            return Err(GeometryError::Curve(format!(
                "piece {index} ends at ({}, {}) but piece {} starts at ({}, {})",
                end.x,
                end.y,
                index + 1,
                start.x,
                start.y
            )));
        }
    }
    let (start, end) = (first.start(), last.end());
    let infinite = |p: &Vector<2>| p.iter().any(|x| x.is_infinite());
    if infinite(&start) && infinite(&end) {
        Ok(Ends::Endless)
    } else if (end - start).norm() <= tolerance {
        Ok(Ends::Closed)
    } else if axis && start.y.abs() <= tolerance && end.y.abs() <= tolerance {
        Ok(Ends::Axis)
    } else {
        Err(GeometryError::Curve(format!(
            "is open: it starts at ({}, {}) and ends at ({}, {}); close it",
            start.x, start.y, end.x, end.y
        )))
    }
}

fn sound(index: usize, piece: &Piece) -> Result<(), GeometryError> {
    let good = match piece {
        Piece::Line(line) => {
            line.origin().iter().all(|x| x.is_finite())
                && line.direction().iter().all(|x| x.is_finite())
        }
        Piece::Arc(arc) => {
            arc.center().iter().all(|x| x.is_finite())
                && arc.radius() > 0.0
                && arc.start_angle().is_finite()
        }
    };
    if good && piece.length() > 0.0 {
        return Ok(());
    }
    Err(GeometryError::Curve(format!(
        "piece {index} has no length or is not finite: {piece:?}"
    )))
}

impl Outline {
    /// Refuses an outline two of whose pieces meet elsewhere than in their joint.
    pub(super) fn refuse_crossings(&self) -> Result<(), GeometryError> {
        let tolerance = SAME_POINT * self.size;
        let count = self.pieces.len();
        for a in 0..count {
            let bounds = self.pieces[a].bounds().grown(tolerance);
            let near: Vec<usize> = match &self.search {
                Some(search) if self.pieces[a].length().is_finite() => {
                    let Bounds { min, max } = bounds;
                    let aabb = parry2d::bounding_volume::Aabb::new(
                        parry2d::math::Vector::new(min.x, min.y),
                        parry2d::math::Vector::new(max.x, max.y),
                    );
                    let mut near: Vec<usize> = search
                        .tree
                        .intersect_aabb(&aabb)
                        .map(|index| index as usize)
                        .filter(|&index| index > a)
                        .collect();
                    near.sort_unstable();
                    near
                }
                Some(_) => (0..count).filter(|&b| b != a).collect(),
                None => (a + 1..count).collect(),
            };
            for b in near {
                self.refuse_crossing([a, b], tolerance)?;
            }
        }
        Ok(())
    }

    fn refuse_crossing(&self, [a, b]: [usize; 2], tolerance: f64) -> Result<(), GeometryError> {
        let shared: Vec<Vector<2>> = self.ends[a]
            .iter()
            .filter(|joint| self.ends[b].contains(joint))
            .filter_map(|&joint| self.joints.get(joint as usize))
            .map(|joint| joint.point)
            .collect();
        match crossing::meeting(&self.pieces[a], &self.pieces[b], &shared, tolerance) {
            None => Ok(()),
            Some(point) => Err(GeometryError::Curve(format!(
                "crosses or touches itself near ({:.6}, {:.6}), where pieces {} and {} meet",
                point.x,
                point.y,
                a.min(b) + 1,
                a.max(b) + 1
            ))),
        }
    }
}
