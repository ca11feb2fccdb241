//! VTK XML files with their arrays appended as they lie in memory, compressed or not [VTK File Formats, "XML File Formats"]: a
//! header in text, then the bytes. For what `vtkio` does not write: polyhedra and field data.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::atomic;
use super::error::OutputError;

/// Bytes that are compressed at once.
const BLOCK: usize = 1 << 20;

/// Effort that zlib spends, of 9: more takes longer and hardly saves.
const LEVEL: u32 = 4;

/// Numbers of an array.
pub(super) enum Numbers<'a> {
    /// Reals.
    Real(&'a [f64]),
    /// Whole numbers.
    Whole(&'a [i64]),
    /// Small ones.
    Byte(&'a [u8]),
}

/// A file being put together.
pub(super) struct Document {
    kind: &'static str,
    is_compressed: bool,
    text: String,
    appended: Vec<u8>,
}

impl Document {
    /// An empty one of a kind such as `UnstructuredGrid`, whose element has these attributes.
    pub(super) fn new(kind: &'static str, attributes: &str, is_compressed: bool) -> Self {
        Self {
            kind,
            is_compressed,
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
    pub(super) fn array(&mut self, name: &str, components: usize, numbers: &Numbers<'_>) {
        let attributes = format!("NumberOfComponents=\"{components}\"");
        self.add(name, &attributes, numbers);
    }

    /// Adds what belongs to the whole: arrays of few numbers by name.
    pub(super) fn field_data(&mut self, fields: &[(&str, Vec<f64>)]) {
        self.open("FieldData");
        for (name, numbers) in fields {
            let attributes = format!("NumberOfTuples=\"{}\"", numbers.len());
            self.add(name, &attributes, &Numbers::Real(numbers));
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
        let mut put = |number: usize| self.appended.extend((number as u64).to_le_bytes());
        if !self.is_compressed {
            put(bytes.len());
            self.appended.extend(bytes);
            return;
        }
        let blocks: Vec<Vec<u8>> = bytes.chunks(BLOCK).map(compressed).collect();
        put(blocks.len());
        put(BLOCK);
        put(bytes.len() % BLOCK);
        for block in &blocks {
            put(block.len());
        }
        self.appended.extend(blocks.concat());
    }

    /// Writes the file.
    pub(super) fn write(self, path: &Path) -> Result<(), OutputError> {
        let Self { kind, text, .. } = &self;
        let compressor = if self.is_compressed {
            " compressor=\"vtkZLibDataCompressor\""
        } else {
            ""
        };
        atomic::write(path, |writer| {
            write!(
                writer,
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
                 header_type=\"UInt64\"{compressor}>\n{text}  </{kind}>\n  <AppendedData encoding=\"raw\">\n_"
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
