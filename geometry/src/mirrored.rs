//! A body that mirrors cut off.

use crate::{Bounds, Closest, Shape, Vector};

/// A plane across an axis that is a mirror, and the side of it that it shows beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorPlane {
    /// Axis across which it lies.
    pub axis: usize,
    /// Where on that axis.
    pub position: f64,
    /// True where the side above it is the one that it shows.
    pub shows_above: bool,
}

impl MirrorPlane {
    /// How far a coordinate is on the side that is shown; negative beyond the plane.
    pub(crate) fn height<const D: usize>(&self, point: &Vector<D>) -> f64 {
        let above = point[self.axis] - self.position;
        if self.shows_above { above } else { -above }
    }

    /// The image of a point.
    pub(crate) fn image<const D: usize>(&self, mut point: Vector<D>) -> Vector<D> {
        point[self.axis] = 2.0 * self.position - point[self.axis];
        point
    }
}

/// A body of which mirrors show one side each, at most one of them across each axis: what is beyond a plane is the image of what is on its
/// other side, whatever the body itself is there. So it is its own mirror image about each of them.
///
/// Distances are those to the body itself from the place or its image, and near a plane that cuts it askew the closest place may be a
/// little beyond it: distances are continuous there, but their gradient has a kink, as at the crease in which body and image meet.
#[derive(Clone, Debug)]
pub struct Mirrored<S, const D: usize> {
    body: S,
    planes: Vec<MirrorPlane>,
}

impl<S: Shape<D>, const D: usize> Mirrored<S, D> {
    /// `body` as mirrors show it.
    pub fn new(body: S, planes: Vec<MirrorPlane>) -> Self {
        Self { body, planes }
    }

    /// The planes beyond which a point lies.
    fn beyond(&self, point: &Vector<D>) -> impl Iterator<Item = &MirrorPlane> {
        let point = *point;
        (self.planes.iter()).filter(move |plane| plane.height(&point) < 0.0)
    }

    /// The place of which a point is the image, or the point itself.
    fn original(&self, point: &Vector<D>) -> Vector<D> {
        self.beyond(point)
            .fold(*point, |place, plane| plane.image(place))
    }

    /// A piece of the surface and its images, cut off at the planes.
    fn shown(&self, piece: [Vector<D>; D]) -> Vec<[Vector<D>; D]> {
        let mut pieces = vec![piece];
        for plane in &self.planes {
            let kept = pieces.iter().flat_map(|piece| cut_off(piece, plane));
            pieces = kept
                .flat_map(|piece| {
                    let mut image = piece.map(|corner| plane.image(corner));
                    image.swap(0, 1);
                    [piece, image]
                })
                .collect();
        }
        pieces
    }
}

/// A piece this near to a plane, in parts of its own size, lies in it.
const IN_PLANE: f64 = 1e-9;

/// The part of a segment or triangle on the side of a plane that is shown: none, or one or two pieces that face the same way
/// [Sutherland & Hodgman 1974, Commun. ACM 17, 32, doi:10.1145/360767.360802]. What lies in the plane is no surface: both sides of it are
/// alike.
fn cut_off<const D: usize>(piece: &[Vector<D>; D], plane: &MirrorPlane) -> Vec<[Vector<D>; D]> {
    let size = (1..D).map(|n| (piece[n] - piece[0]).norm());
    let size = size.fold(0.0, f64::max);
    if piece
        .iter()
        .all(|corner| plane.height(corner).abs() <= IN_PLANE * size)
    {
        return Vec::new();
    }
    let mut outline: Vec<Vector<D>> = Vec::with_capacity(D + 1);
    for n in 0..D {
        let (from, to) = (piece[n], piece[(n + 1) % D]);
        let heights = [plane.height(&from), plane.height(&to)];
        if heights[0] >= 0.0 {
            outline.push(from);
        }
        if (heights[0] < 0.0) != (heights[1] < 0.0) {
            let part = heights[0] / (heights[0] - heights[1]);
            outline.push(from + part * (to - from));
        }
    }
    // Back at its beginning the outline of a segment repeats the cut.
    let count = outline.len().saturating_sub(D - 1).min(D - 1);
    (1..=count)
        .map(|k| {
            std::array::from_fn(|m| {
                if m == 0 {
                    outline[0]
                } else {
                    outline[k + m - 1]
                }
            })
        })
        .collect()
}

impl<S: Shape<D>, const D: usize> Shape<D> for Mirrored<S, D> {
    fn bounds(&self) -> Bounds<D> {
        let mut bounds = self.body.bounds();
        for &MirrorPlane {
            axis,
            position,
            shows_above,
        } in &self.planes
        {
            if shows_above {
                bounds.min[axis] = 2.0 * position - bounds.max[axis];
            } else {
                bounds.max[axis] = 2.0 * position - bounds.min[axis];
            }
        }
        bounds
    }

    fn closest(&self, point: &Vector<D>) -> Closest<D> {
        let mut seen = self.body.closest(&self.original(point));
        for plane in self.beyond(point) {
            seen.point = plane.image(seen.point);
            seen.normal[plane.axis] = -seen.normal[plane.axis];
        }
        seen
    }

    fn signed_distance(&self, point: &Vector<D>) -> f64 {
        self.body.signed_distance(&self.original(point))
    }

    fn mirror_planes(&self) -> Vec<(usize, f64)> {
        let is_free = |axis: usize| self.planes.iter().all(|plane| plane.axis != axis);
        let own = self.body.mirror_planes().into_iter();
        let shown = self.planes.iter().map(|plane| (plane.axis, plane.position));
        shown.chain(own.filter(|own| is_free(own.0))).collect()
    }

    fn facets(&self, size: f64, region: &Bounds<D>) -> Vec<[Vector<D>; D]> {
        let with_images = self.planes.iter().fold(*region, |region, plane| {
            let [low, high] = [region.min, region.max].map(|corner| plane.image(corner));
            Bounds::new(
                region.min.inf(&low.inf(&high)),
                region.max.sup(&low.sup(&high)),
            )
        });
        let pieces = self.body.facets(size, &with_images);
        pieces
            .into_iter()
            .flat_map(|piece| self.shown(piece))
            .collect()
    }
}
