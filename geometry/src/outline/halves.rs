//! Outlines of halves of bodies, made whole; see [`crate::halves`].

use super::piece::Piece;
use super::{Chain, Ends, Outline};
use crate::error::GeometryError;
use crate::halves::ends_in;
use crate::{MirrorPlane, Vector};

impl Outline {
    /// The outline with its images in those of `planes` that it ends in, without what lies in them; none unless it is half of a body: closed, all on the
    /// side that a plane shows, with a straight piece in it.
    ///
    /// # Errors
    /// See [`Outline::new`]; an arc that ends beside a plane by rounding.
    pub fn made_whole(&self, planes: &[MirrorPlane]) -> Result<Option<Self>, GeometryError> {
        let is_closed = |chain: &Chain| chain.ends == Ends::Closed;
        if !self.chains.iter().all(is_closed) {
            return Ok(None);
        }
        let (planes, tolerance) = ends_in(&self.bounds, planes);
        planes.iter().try_fold(None, |whole, plane| {
            let half = whole.as_ref().unwrap_or(self);
            let joined = half.joined(plane, tolerance);
            joined.transpose().map(|joined| joined.or(whole))
        })
    }

    /// The same at one plane, which all of it is above.
    fn joined(&self, plane: &MirrorPlane, tolerance: f64) -> Option<Result<Self, GeometryError>> {
        let is_near = |point: &Vector<2>| plane.height(point).abs() <= tolerance;
        let is_in_plane = |piece: &Piece| {
            matches!(piece, Piece::Line(_)) && is_near(&piece.start()) && is_near(&piece.end())
        };
        if !self.pieces.iter().any(is_in_plane) {
            return None;
        }
        let snapped = |mut point: Vector<2>| {
            if is_near(&point) {
                point[plane.axis] = plane.position;
            }
            point
        };
        let mut chains = Vec::new();
        for chain in &self.chains {
            let pieces = &self.pieces[chain.pieces.clone()];
            let Some(first) = pieces.iter().position(is_in_plane) else {
                chains.push(pieces.to_vec());
                chains.push(image(pieces, plane));
                continue;
            };
            let around: Vec<Piece> = [&pieces[first..], &pieces[..first]].concat();
            for run in around.split(is_in_plane).filter(|run| !run.is_empty()) {
                let moved = run.iter().map(|piece| match piece {
                    Piece::Line(_) => Piece::segment(snapped(piece.start()), snapped(piece.end())),
                    Piece::Arc(_) => *piece,
                });
                let run: Vec<Piece> = moved.collect();
                chains.push([run.as_slice(), &image(&run, plane)].concat());
            }
        }
        Some(Self::checked(chains, false, self.stand_for))
    }
}

/// The images of a run of pieces, travelled with the solid to the left.
fn image(run: &[Piece], plane: &MirrorPlane) -> Vec<Piece> {
    let plane = (plane.axis, plane.position);
    let images = run.iter().rev().map(|piece| piece.mirrored(plane));
    images.collect()
}
