//! A cell before it is cut.

use aero_geometry::Vector;

use super::part::{Part, PartFace};
use super::polytope::Polytope;
use super::rim::{closed, polygon};

/// A convex cell before it is cut.
#[derive(Clone, Copy, Debug)]
pub struct Whole<'a, const D: usize> {
    /// The cell, measured from its point.
    pub cell: &'a Polytope<D>,
    /// Where its point is.
    pub point: &'a Vector<D>,
    /// Spacing of the points here.
    pub unit: f64,
    /// True where areas and volumes are per radian about the axis, at zero of the last coordinate.
    pub about_axis: bool,
    /// True where the pieces are to be shown.
    pub keeps_rings: bool,
}

impl<const D: usize> Whole<'_, D> {
    /// The cell as it is.
    pub fn uncut(&self) -> Part<D> {
        let mut part = Part::new();
        for (number, facet) in self.cell.facets.iter().enumerate() {
            let face = match D {
                1 => {
                    let place = self.cell.vertices[facet.corners[0] as usize];
                    let outwards = if number == 0 { -1.0 } else { 1.0 };
                    part.volume += place[0] * outwards;
                    PartFace {
                        label: facet.label,
                        area: Vector::repeat(outwards),
                        centre: place,
                    }
                }
                2 => {
                    let [from, to] = [0, 1].map(|k| self.cell.vertices[facet.corners[k] as usize]);
                    part.volume += self.fan(&from, &to);
                    PartFace {
                        label: facet.label,
                        ..self.edge_face(&from, &to)
                    }
                }
                _ => {
                    let corners = facet.corners.iter();
                    let points: Vec<_> = corners
                        .map(|&corner| self.cell.vertices[corner as usize])
                        .collect();
                    let face = polygon(facet.label, closed(&points));
                    part.volume += face.area.dot(&face.centre) / 3.0;
                    if self.keeps_rings {
                        part.rings.push(points);
                    }
                    face
                }
            };
            part.add_face(face);
        }
        if self.keeps_rings && D == 2 {
            let outline = self.cell.outline();
            let corners = outline.iter().map(|&(corner, _)| corner as usize);
            part.rings = vec![corners.map(|corner| self.cell.vertices[corner]).collect()];
        }
        part
    }

    /// Volume of the triangle between the point and an edge, per radian about an axis.
    pub(super) fn fan(&self, from: &Vector<D>, to: &Vector<D>) -> f64 {
        let doubled = from[0] * to[1] - from[1] * to[0];
        if self.about_axis {
            doubled * (0.5 * self.point[1] + (from[1] + to[1]) / 6.0)
        } else {
            0.5 * doubled
        }
    }

    /// The face over an edge with the gas to its left; the area per radian about an axis.
    pub(super) fn edge_face(&self, from: &Vector<D>, to: &Vector<D>) -> PartFace<D> {
        let along = to - from;
        let centre = (from + to) * 0.5;
        let mut area = Vector::<D>::zeros();
        let radius = if self.about_axis {
            self.point[1] + centre[1]
        } else {
            1.0
        };
        area[0] = along[1] * radius;
        area[1] = -along[0] * radius;
        PartFace {
            label: u32::MAX,
            area,
            centre,
        }
    }
}
