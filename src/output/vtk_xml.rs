//! VTK XML files with their arrays appended as they lie in memory, compressed or not [VTK File Formats, "XML File Formats"]: a
//! header in text, then the bytes. `vtkio` reads them, but writes neither polyhedra nor field data.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::atomic;
use super::error::OutputError;
use crate::base64::base64;

/// Bytes that are compressed at once.
const BLOCK: usize = 1 << 20;

/// Effort that zlib spends, of 9: more takes several times as long and saves two per cent.
const LEVEL: u32 = 2;

/// Numbers of an array.
pub(super) enum Numbers<'a> {
    /// Reals.
    Real(&'a [f64]),
    /// Whole numbers.
    Whole(&'a [i64]),
    /// Numbers of bodies, layers, faces.
    Count(&'a [u32]),
    /// Small ones.
    Byte(&'a [u8]),
}

macro_rules! numbers_from {
    ($($kind:ty => $variant:ident),*) => {$(
        impl<'a> From<&'a [$kind]> for Numbers<'a> {
            fn from(values: &'a [$kind]) -> Self {
                Self::$variant(values)
            }
        }
    )*};
}

numbers_from!(f64 => Real, i64 => Whole, u32 => Count, u8 => Byte);

/// What a file says of the whole, and how.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Told {
    /// Arrays of few numbers by name.
    pub(super) fields: Vec<(&'static str, Vec<f64>)>,
    /// The set of units; nothing is said of it where it is empty.
    pub(super) units: &'static str,
    /// Arrays are compressed.
    pub(super) is_compressed: bool,
}

/// A file being put together.
pub(super) struct Document {
    kind: &'static str,
    is_compressed: bool,
    /// Arrays are appended as letters: a third longer, but `vtkio` reads no others, which the next run starts from.
    is_lettered: bool,
    text: String,
    appended: Vec<u8>,
}

impl Document {
    /// An empty one of a kind such as `UnstructuredGrid`, whose element has these attributes.
    pub(super) fn new(kind: &'static str, attributes: &str, is_compressed: bool) -> Self {
        Self {
            kind,
            is_compressed,
            is_lettered: kind == "PolyData",
            text: format!("  <{kind}{attributes}>\n"),
            appended: Vec::new(),
        }
    }

    /// Begins an element, with its attributes if it has any.
    pub(super) fn open(&mut self, element: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "<{element}>");
    }

    /// Ends it.
    pub(super) fn close(&mut self, name: &str) {
        let _ = writeln!(self.text, "</{name}>");
    }

    /// Adds an array of so many components.
    pub(super) fn array<'a>(
        &mut self,
        name: &str,
        components: usize,
        numbers: impl Into<Numbers<'a>>,
    ) {
        let attributes = format!("NumberOfComponents=\"{components}\"");
        self.add(name, &attributes, &numbers.into());
    }

    /// Adds what belongs to the whole.
    pub(super) fn field_data(&mut self, told: &Told) {
        self.open("FieldData");
        for (name, numbers) in &told.fields {
            let attributes = format!("NumberOfTuples=\"{}\"", numbers.len());
            self.add(name, &attributes, &Numbers::Real(numbers));
        }
        if !told.units.is_empty() {
            self.open(
                "DataArray type=\"String\" Name=\"units\" NumberOfTuples=\"1\" format=\"ascii\"",
            );
            for letter in told.units.bytes() {
                let _ = write!(self.text, "{letter} ");
            }
            self.text.push_str("0\n");
            self.close("DataArray");
        }
        self.close("FieldData");
    }

    fn add(&mut self, name: &str, attributes: &str, numbers: &Numbers<'_>) {
        let (kind, bytes) = match numbers {
            Numbers::Real(all) => (
                "Float64",
                all.iter().flat_map(|x| x.to_le_bytes()).collect(),
            ),
            Numbers::Whole(all) => ("Int64", all.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Numbers::Count(all) => ("UInt32", all.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Numbers::Byte(all) => ("UInt8", all.to_vec()),
        };
        let _ = writeln!(
            self.text,
            "<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} format=\"appended\" offset=\"{}\"/>",
            self.appended.len()
        );
        self.append(&bytes);
    }

    /// Bytes after their count; of compressed ones the number of blocks, their size, that of the last if it is less, and what each
    /// takes.
    fn append(&mut self, bytes: &[u8]) {
        let words = |numbers: &[usize]| -> Vec<u8> {
            let numbers = numbers.iter().map(|&number| number as u64);
            numbers.flat_map(u64::to_le_bytes).collect()
        };
        if !self.is_compressed {
            self.put(&[&words(&[bytes.len()]), bytes].concat());
            return;
        }
        let blocks: Vec<Vec<u8>> = bytes.chunks(BLOCK).map(compressed).collect();
        let sizes = blocks.iter().map(Vec::len);
        let header: Vec<usize> = [blocks.len(), BLOCK, bytes.len() % BLOCK]
            .into_iter()
            .chain(sizes)
            .collect();
        self.put(&words(&header));
        self.put(&blocks.concat());
    }

    /// Bytes as they are, or their letters.
    fn put(&mut self, bytes: &[u8]) {
        if self.is_lettered {
            self.appended.extend(base64(bytes).into_bytes());
        } else {
            self.appended.extend(bytes);
        }
    }

    /// Writes the file.
    pub(super) fn write(self, path: &Path) -> Result<(), OutputError> {
        let Self { kind, text, .. } = &self;
        let encoding = if self.is_lettered { "base64" } else { "raw" };
        let compressor = if self.is_compressed {
            " compressor=\"vtkZLibDataCompressor\""
        } else {
            ""
        };
        atomic::write(path, |writer| {
            write!(
                writer,
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
                 header_type=\"UInt64\"{compressor}>\n{text}  </{kind}>\n  <AppendedData encoding=\"{encoding}\">\n_"
            )?;
            writer.write_all(&self.appended)?;
            writer.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
        })
    }
}

fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(LEVEL));
    // Writing to memory cannot fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}
