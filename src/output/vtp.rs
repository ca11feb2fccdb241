//! VTK XML `PolyData`: point clouds, one vertex cell per point, so that `ParaView` draws them without a filter; and surfaces of
//! segments or triangles, whose arrays belong to the cells.

use std::collections::HashMap;
use std::path::Path;

use super::error::OutputError;
use super::vtk_xml::{Document, Numbers, Told};

/// Points, or what spans them, with arrays, as they are put together.
pub(super) struct Cloud {
    document: Document,
    /// Where arrays go.
    section: &'static str,
}

impl Cloud {
    /// Points without arrays yet.
    pub(super) fn new(points: &[[f64; 3]], told: &Told) -> Self {
        let count = points.len();
        Self::begin(
            points,
            ("Verts", count),
            0..count as i64,
            1..count as i64 + 1,
            told,
        )
    }

    /// Cells of so many corners each, without arrays yet: points, segments or triangles. Corners at the same place are one
    /// point.
    pub(super) fn of_cells(each: usize, corners: &[[f64; 3]], told: &Told) -> Self {
        let mut known = HashMap::new();
        let mut points = Vec::new();
        let mut numbers = Vec::with_capacity(corners.len());
        for corner in corners {
            // Zero has two signs.
            let place = corner.map(|x| (x + 0.0).to_bits());
            let number = *known.entry(place).or_insert_with(|| {
                points.push(*corner);
                points.len() as i64 - 1
            });
            numbers.push(number);
        }
        let kind = match each {
            0 | 1 => "Verts",
            2 => "Lines",
            _ => "Polys",
        };
        let each = each.max(1);
        let count = numbers.len() / each;
        let offsets: Vec<i64> = (1..=count).map(|n| (n * each) as i64).collect();
        let mut cloud = Self::begin(&points, (kind, count), &numbers[..], &offsets[..], told);
        cloud.turn_to("CellData");
        cloud
    }

    /// Of so many cells of a kind, by the numbers of their corners, and where each cell's end among those.
    fn begin<'a>(
        points: &[[f64; 3]],
        (kind, cells): (&str, usize),
        connectivity: impl Into<Numbers<'a>>,
        offsets: impl Into<Numbers<'a>>,
        told: &Told,
    ) -> Self {
        let mut document = Document::new("PolyData", "", told.is_compressed);
        document.field_data(told);
        let count = |name: &str| if name == kind { cells } else { 0 };
        document.open(&format!(
            "Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\"",
            points.len(),
            count("Verts"),
            count("Lines"),
            count("Polys")
        ));
        document.open("Points");
        document.array("Points", 3, Numbers::Real(points.as_flattened()));
        document.close("Points");
        document.open(kind);
        document.array("connectivity", 1, connectivity);
        document.array("offsets", 1, offsets);
        document.close(kind);
        document.open("PointData");
        Self {
            document,
            section: "PointData",
        }
    }

    fn turn_to(&mut self, section: &'static str) {
        self.document.close(self.section);
        self.document.open(section);
        self.section = section;
    }

    /// Adds an array of vectors.
    pub(super) fn vectors(mut self, name: &str, values: &[[f64; 3]]) -> Self {
        self.document.array(name, 3, values.as_flattened());
        self
    }

    /// Adds an array of numbers.
    pub(super) fn scalars<'a>(mut self, name: &str, values: impl Into<Numbers<'a>>) -> Self {
        self.document.array(name, 1, values);
        self
    }

    /// Writes the file.
    pub(super) fn write(mut self, path: &Path) -> Result<(), OutputError> {
        self.document.close(self.section);
        self.document.close("Piece");
        self.document.write(path)
    }
}
