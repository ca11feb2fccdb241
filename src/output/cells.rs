//! `cells-NNNNNN.vtu`: the cells about points that stay, and the gas in them.

use std::collections::HashMap;
use std::path::Path;

use super::error::OutputError;
use super::reference::Reference;
use super::vtk_xml::{Document, Numbers};
use aero_solver::frame::{CellFrame, Frame, Look};

/// Corners closer than this, in spacings, are one.
const SAME: f64 = 1e-8;

/// Numbers of VTK for kinds of cells.
const POLYGON: u8 = 7;
const QUAD: u8 = 9;
const HEXAHEDRON: u8 = 12;
const POLYHEDRON: u8 = 42;

/// Writes those cells whose points are in `frame`. A cell that a thin part divides is as many as it has pieces, all with its `id`.
pub fn write_cells(
    path: &Path,
    cells: &CellFrame,
    frame: &Frame,
    reference: &Reference,
    is_compressed: bool,
) -> Result<(), OutputError> {
    let rows: HashMap<u64, usize> = frame
        .id
        .iter()
        .enumerate()
        .map(|(n, &id)| (id, n))
        .collect();
    let mut mesh = Mesh::new(reference.spacing);
    let mut chosen = Vec::new();
    for piece in &cells.pieces {
        if let Some(&row) = rows.get(&u64::from(piece.cell)) {
            mesh.add(cells.dimension, &piece.look);
            chosen.push(row);
        }
    }
    let scalars = |values: &[f64]| chosen.iter().map(|&n| values[n]).collect::<Vec<f64>>();
    let vectors = |values: &[[f64; 3]]| {
        let rows = chosen.iter().map(|&n| values[n]);
        rows.collect::<Vec<[f64; 3]>>()
    };
    let mut document = Document::new("UnstructuredGrid", "", is_compressed);
    document.field_data(&reference.told(frame.time, is_compressed));
    document.open(&format!(
        "Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\"",
        mesh.points.len(),
        chosen.len()
    ));
    mesh.write(&mut document);
    document.open("CellData Scalars=\"pressure\" Vectors=\"velocity\"");
    let velocity = vectors(&frame.velocity);
    document.array("velocity", 3, Numbers::Real(velocity.as_flattened()));
    let temperature = reference.temperatures(frame);
    let entropy = reference.entropies(frame);
    let arrays = [
        ("density", Some(&frame.density)),
        ("pressure", Some(&frame.pressure)),
        ("mach", Some(&frame.mach)),
        ("temperature", temperature.as_ref()),
        ("entropy", Some(&entropy)),
        ("volume", Some(&frame.volume)),
    ];
    for (name, values) in arrays {
        if let Some(values) = values {
            document.array(name, 1, Numbers::Real(&scalars(values)));
        }
    }
    let ids: Vec<i64> = chosen.iter().map(|&n| frame.id[n] as i64).collect();
    document.array("id", 1, Numbers::Whole(&ids));
    document.close("CellData");
    document.close("Piece");
    document.write(path)
}

/// Corners and cells, as VTK counts them.
struct Mesh {
    unit: f64,
    known: HashMap<[i64; 3], i64>,
    points: Vec<[f64; 3]>,
    connectivity: Vec<i64>,
    offsets: Vec<i64>,
    types: Vec<u8>,
    /// Of polyhedra: faces, each by its corners, after their count.
    faces: Vec<i64>,
    face_offsets: Vec<i64>,
}

impl Mesh {
    fn new(spacing: f64) -> Self {
        Self {
            unit: SAME * spacing,
            known: HashMap::new(),
            points: Vec::new(),
            connectivity: Vec::new(),
            offsets: Vec::new(),
            types: Vec::new(),
            faces: Vec::new(),
            face_offsets: Vec::new(),
        }
    }

    fn number(&mut self, corner: [f64; 3]) -> i64 {
        let place = corner.map(|x| (x / self.unit).round() as i64);
        let points = &mut self.points;
        *self.known.entry(place).or_insert_with(|| {
            points.push(corner);
            points.len() as i64 - 1
        })
    }

    fn add(&mut self, dimension: usize, look: &Look) {
        match (look, dimension) {
            (Look::Block([low, high]), _) => {
                let layers = if dimension == 2 { 1 } else { 2 };
                for z in [low[2], high[2]].into_iter().take(layers) {
                    let [[ax, ay], [bx, by]] = [low, high].map(|corner| [corner[0], corner[1]]);
                    for [x, y] in [[ax, ay], [bx, ay], [bx, by], [ax, by]] {
                        let number = self.number([x, y, z]);
                        self.connectivity.push(number);
                    }
                }
                self.end(if dimension == 2 { QUAD } else { HEXAHEDRON });
            }
            (Look::Rings(rings), 2) => {
                for ring in rings {
                    let corners = self.ring(ring);
                    self.connectivity.extend(corners);
                }
                self.end(POLYGON);
            }
            (Look::Rings(rings), _) => {
                let rings: Vec<Vec<i64>> = rings.iter().map(|ring| self.ring(ring)).collect();
                // What is no wider than round-off bounds nothing.
                let faces: Vec<&Vec<i64>> = rings.iter().filter(|ring| ring.len() > 2).collect();
                let mut corners: Vec<i64> = faces.iter().copied().flatten().copied().collect();
                corners.sort_unstable();
                corners.dedup();
                self.connectivity.extend(corners);
                self.faces.push(faces.len() as i64);
                for face in faces {
                    self.faces.push(face.len() as i64);
                    self.faces.extend(face);
                }
                self.end(POLYHEDRON);
            }
        }
    }

    /// The corners of a ring, without those that come twice in a row.
    fn ring(&mut self, ring: &[[f64; 3]]) -> Vec<i64> {
        let mut corners: Vec<i64> = ring.iter().map(|&corner| self.number(corner)).collect();
        corners.dedup();
        while corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        corners
    }

    fn end(&mut self, kind: u8) {
        self.offsets.push(self.connectivity.len() as i64);
        self.types.push(kind);
        let has_faces = kind == POLYHEDRON;
        let end = if has_faces {
            self.faces.len() as i64
        } else {
            -1
        };
        self.face_offsets.push(end);
    }

    fn write(&self, document: &mut Document) {
        document.open("Points");
        let points = self.points.as_flattened();
        document.array("Points", 3, points);
        document.close("Points");
        document.open("Cells");
        document.array("connectivity", 1, Numbers::Whole(&self.connectivity));
        document.array("offsets", 1, Numbers::Whole(&self.offsets));
        document.array("types", 1, Numbers::Byte(&self.types));
        if !self.faces.is_empty() {
            document.array("faces", 1, Numbers::Whole(&self.faces));
            document.array("faceoffsets", 1, Numbers::Whole(&self.face_offsets));
        }
        document.close("Cells");
    }
}
