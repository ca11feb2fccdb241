//! Point clouds as VTK XML `PolyData`, one vertex cell per point, so that `ParaView` draws them
//! without a filter.
//!
//! The numbers stand behind the XML as they are in memory ("appended raw"), or in blocks that zlib
//! has compressed. What the arrays borrow is written piece by piece: a file needs no second copy.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use super::numbers::Numbers;
use super::{OutputError, atomic};

/// Points with arrays, ready to be written.
pub(super) struct Cloud<'a> {
    points: Array<'a>,
    arrays: Vec<Array<'a>>,
    is_compressed: bool,
}

/// Numbers with a name, so many to a point.
struct Array<'a> {
    name: &'a str,
    components: usize,
    numbers: Numbers<'a>,
}

impl<'a> Cloud<'a> {
    /// Points without arrays yet.
    pub(super) fn new(points: &'a [[f64; 3]]) -> Self {
        Self {
            points: Array {
                name: "Points",
                components: 3,
                numbers: points.as_flattened().into(),
            },
            arrays: Vec::new(),
            is_compressed: false,
        }
    }

    /// Adds an array of vectors.
    pub(super) fn vectors(mut self, name: &'a str, values: &'a [[f64; 3]]) -> Self {
        self.arrays.push(Array {
            name,
            components: 3,
            numbers: values.as_flattened().into(),
        });
        self
    }

    /// Adds an array of numbers.
    pub(super) fn scalars(mut self, name: &'a str, values: impl Into<Numbers<'a>>) -> Self {
        self.arrays.push(Array {
            name,
            components: 1,
            numbers: values.into(),
        });
        self
    }

    /// Has the file compressed, if so wished: smaller, and slower to write.
    pub(super) fn compressed(mut self, is_compressed: bool) -> Self {
        self.is_compressed = is_compressed;
        self
    }

    /// Writes the file.
    pub(super) fn write(self, path: &Path) -> Result<(), OutputError> {
        atomic::write(path, |writer| self.fill(writer))
    }

    /// Where an array begins is known once those before it have been compressed: the header is written a
    /// second time, over the first, with the right places.
    fn fill(&self, writer: &mut BufWriter<File>) -> io::Result<()> {
        let count = self.points.numbers.len() / 3;
        let vertex = |name, from| Array {
            name,
            components: 1,
            numbers: Numbers::count_from(from, count),
        };
        let vertices = [vertex("connectivity", 0), vertex("offsets", 1)];
        let all = || {
            let arrays = self.arrays.iter().chain([&self.points]);
            arrays.chain(&vertices)
        };
        let mut places = vec![0; all().count()];
        writer.write_all(self.header(&vertices, &places).as_bytes())?;
        let mut place = 0;
        for (array, start) in all().zip(&mut places) {
            *start = place;
            place += if self.is_compressed {
                array.numbers.write_compressed(writer)?
            } else {
                array.numbers.write(writer)?
            };
        }
        writer.write_all(b"\n  </AppendedData>\n</VTKFile>\n")?;
        writer.seek(SeekFrom::Start(0))?;
        writer.write_all(self.header(&vertices, &places).as_bytes())
    }

    /// All up to the first number, of the same length whatever the `places` of the arrays.
    fn header(&self, vertices: &[Array<'_>; 2], places: &[u64]) -> String {
        let count = self.points.numbers.len() / 3;
        let compressor = if self.is_compressed {
            " compressor=\"vtkZLibDataCompressor\""
        } else {
            ""
        };
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n\
             <VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\"{compressor}>\n  <PolyData>\n    \
             <Piece NumberOfPoints=\"{count}\" NumberOfVerts=\"{count}\" NumberOfLines=\"0\" \
             NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
        );
        let mut places = places.iter();
        let mut section = |name: &str, arrays: &mut dyn Iterator<Item = &Array<'_>>| {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "      <{name}>");
            for (array, place) in arrays.zip(&mut places) {
                let offset = format!("offset=\"{place}\"");
                let _ = writeln!(
                    text,
                    "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" \
                     format=\"appended\" {offset:<29}/>",
                    array.numbers.vtk_type(),
                    array.name,
                    array.components,
                );
            }
            let _ = writeln!(text, "      </{name}>");
        };
        section("PointData", &mut self.arrays.iter());
        section("Points", &mut [&self.points].into_iter());
        section("Verts", &mut vertices.iter());
        text.push_str("    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n    _");
        text
    }
}
