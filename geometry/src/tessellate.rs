//! Triangles from exact bodies, for files and for comparison.

use std::f64::consts::{PI, TAU};

use crate::outline::{Ends, Piece};
use crate::stl::Facet;
use crate::{Bounds, Revolution, Shape, Vector};

/// No arc is cut into pieces that turn more than this (radians; 4 degrees), however short it is:
/// normals blended from the triangles are then within a degree of the arc's.
const COARSEST_TURN: f64 = PI / 45.0;

impl Revolution {
    /// Closed triangulation, outward normals, with `around` facets around the axis (at least 3)
    /// and along the meridian pieces about as long as those on the widest circle.
    pub fn tessellate(&self, around: usize) -> Vec<Facet> {
        let around = around.max(3);
        let meridian = self.meridian();
        let widest = meridian
            .pieces()
            .iter()
            .fold(0.0_f64, |r, piece| r.max(piece.bounds().max.y));
        let spacing = TAU * widest / around as f64;
        let mut profile = Vec::new();
        for piece in meridian.pieces() {
            let turn = (piece.curvature() * piece.length()).abs();
            let parts = (piece.length() / spacing)
                .max(turn / COARSEST_TURN)
                .ceil()
                .max(1.0);
            for part in 0..parts as usize {
                let s = piece.length() * part as f64 / parts;
                profile.push(if part == 0 {
                    piece.start()
                } else {
                    piece.point(s)
                });
            }
        }
        let closed = meridian.chains()[0].ends == Ends::Closed;
        let last = meridian.pieces().last().map_or(profile[0], Piece::end);
        profile.push(if closed { profile[0] } else { last });
        if !closed {
            // The poles are single points.
            let end = profile.len() - 1;
            profile[0].y = 0.0;
            profile[end].y = 0.0;
        }
        facets(&profile, around)
    }
}

/// Fewest facets around the axis.
const LEAST_AROUND: usize = 32;

/// Facets about `size` long where the surface meets `region`, or comes to it by a move no longer than that is wide.
pub(crate) fn cover(body: &Revolution, size: f64, region: &Bounds<3>) -> Vec<Facet> {
    let region = region.grown(region.size().norm());
    // Along the axis, and off it.
    let nearest = |k: usize| region.min[k].max(-region.max[k]).max(0.0);
    let farthest = |k: usize| region.min[k].abs().max(region.max[k].abs());
    let meridian = Bounds::new(
        Vector::from([region.min.x, nearest(1).hypot(nearest(2))]),
        Vector::from([region.max.x, farthest(1).hypot(farthest(2))]),
    );
    let chords = body.meridian().facets(size, &meridian);
    chords
        .iter()
        .flat_map(|chord| {
            let widest = chord[0].y.max(chord[1].y);
            let around = (TAU * widest / size).ceil() as usize;
            facets(chord, around.max(LEAST_AROUND))
        })
        .collect()
}

fn facets(profile: &[Vector<2>], around: usize) -> Vec<Facet> {
    let directions: Vec<(f64, f64)> = (0..around)
        .map(|k| (TAU * k as f64 / around as f64).sin_cos())
        .collect();
    let point = |p: &Vector<2>, k: usize| {
        let (sin, cos) = directions[k % around];
        Vector::<3>::new(p.x, p.y * cos, p.y * sin)
    };
    let mut facets = Vec::with_capacity(2 * around * profile.len());
    for pair in profile.windows(2) {
        for k in 0..around {
            let [a, b] = [&pair[0], &pair[1]].map(|p| point(p, k));
            let [c, d] = [&pair[0], &pair[1]].map(|p| point(p, k + 1));
            if pair[0].y > 0.0 {
                facets.push([a, b, c]);
            }
            if pair[1].y > 0.0 {
                facets.push([b, d, c]);
            }
        }
    }
    facets
}
