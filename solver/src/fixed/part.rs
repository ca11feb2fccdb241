//! A connected part of the gas in a cell: its volume, its faces to neighbours and sides, its walls.

use aero_geometry::Vector;

/// One connected part of the gas in a cell.
#[derive(Clone, Debug)]
pub struct Part<const D: usize> {
    /// True where the cell's point sees it.
    pub is_own: bool,
    /// Volume; per radian about an axis.
    pub volume: f64,
    /// Faces to neighbours and sides.
    pub faces: Vec<PartFace<D>>,
    /// Walls.
    pub walls: Vec<PartWall<D>>,
    /// The polygons that bound it, in the plane the one that it is, from the cell's point; where they are kept.
    pub rings: Vec<Vec<Vector<D>>>,
}

/// The gas in one facet of a cell.
#[derive(Clone, Copy, Debug)]
pub struct PartFace<const D: usize> {
    /// The facet's label.
    pub label: u32,
    /// Area vector, outwards.
    pub area: Vector<D>,
    /// Middle, from the cell's point.
    pub centre: Vector<D>,
}

/// A smooth face of a body within a cell.
#[derive(Clone, Copy, Debug)]
pub struct PartWall<const D: usize> {
    /// The body.
    pub body: u32,
    /// Its smooth face.
    pub facet: u32,
    /// Area vector, out of the gas.
    pub area: Vector<D>,
    /// Its size; in the plane of rings, whose area grows with the radius, its length there.
    pub size: f64,
    /// Middle, from the cell's point.
    pub centre: Vector<D>,
}

impl<const D: usize> Part<D> {
    /// Nothing yet.
    pub fn new() -> Self {
        Self {
            is_own: true,
            volume: 0.0,
            faces: Vec::new(),
            walls: Vec::new(),
            rings: Vec::new(),
        }
    }

    /// Gives back the room for more.
    pub fn shrink_to_fit(&mut self) {
        self.faces.shrink_to_fit();
        self.walls.shrink_to_fit();
    }

    /// Adds a face. Those of one label stay apart: beyond them there may be different pieces.
    pub fn add_face(&mut self, face: PartFace<D>) {
        self.faces.push(face);
    }

    /// Adds to the wall of the same smooth face.
    pub fn add_wall(&mut self, wall: PartWall<D>) {
        let same = |w: &&mut PartWall<D>| w.body == wall.body && w.facet == wall.facet;
        let known = self.walls.iter_mut().find(same);
        if let Some(known) = known {
            known.centre = middle((known.size, known.centre), (wall.size, wall.centre));
            known.area += wall.area;
            known.size += wall.size;
        } else {
            self.walls.push(wall);
        }
    }
}

/// The middle of two walls of these sizes and middles.
fn middle<const D: usize>(
    (a, centre): (f64, Vector<D>),
    (b, other): (f64, Vector<D>),
) -> Vector<D> {
    let weight = if a + b > 0.0 { b / (a + b) } else { 0.5 };
    centre + (other - centre) * weight
}

/// Own pieces become one, the first; where no piece is seen, the largest is the cell's own.
pub fn own_first<const D: usize>(mut parts: Vec<Part<D>>) -> Vec<Part<D>> {
    if !parts.iter().any(|part| part.is_own) {
        let largest = parts
            .iter_mut()
            .reduce(|a, b| if b.volume > a.volume { b } else { a });
        if let Some(largest) = largest {
            largest.is_own = true;
        }
    }
    let (own, mut rest): (Vec<_>, Vec<_>) = parts.into_iter().partition(|part| part.is_own);
    let own = own.into_iter().reduce(|mut sum, part| {
        sum.volume += part.volume;
        part.faces.into_iter().for_each(|face| sum.add_face(face));
        part.walls.into_iter().for_each(|wall| sum.add_wall(wall));
        sum.rings.extend(part.rings);
        sum
    });
    rest.splice(0..0, own);
    rest
}
