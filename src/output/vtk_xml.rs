//! VTK XML files with their arrays appended as they lie in memory, compressed or not [VTK File Formats, "XML File Formats"]: a
//! header in text, then the bytes. `vtkio` reads them, but writes neither polyhedra nor field data.

use std::fmt::Write as _;
use std::io::Write as _;
use std::ops::Range;
use std::path::Path;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::atomic;
use super::error::OutputError;
use crate::base64::base64;

/// Bytes that are compressed at once.
const BLOCK: usize = 1 << 20;

/// Bytes that are turned into letters at once: four for three of them.
const LETTERED: usize = 3 << 12;

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
    /// Whole numbers that follow one another.
    Run(Range<i64>),
}

impl Numbers<'_> {
    /// In bytes.
    fn length(&self) -> usize {
        match self {
            Self::Real(all) => size_of_val(*all),
            Self::Whole(all) => size_of_val(*all),
            Self::Count(all) => size_of_val(*all),
            Self::Byte(all) => all.len(),
            Self::Run(run) => run.clone().count() * size_of::<i64>(),
        }
    }

    /// The bytes, [`BLOCK`] at a time.
    fn blocks(&self) -> impl Iterator<Item = Vec<u8>> {
        let count = self.length().div_ceil(BLOCK);
        (0..count).map(|block| match self {
            Self::Real(all) => bytes(all, block, f64::to_le_bytes),
            Self::Whole(all) => bytes(all, block, i64::to_le_bytes),
            Self::Count(all) => bytes(all, block, u32::to_le_bytes),
            Self::Byte(all) => bytes(all, block, |x| [x]),
            Self::Run(run) => {
                let each = BLOCK / size_of::<i64>();
                let some = run.clone().skip(block * each).take(each);
                some.flat_map(i64::to_le_bytes).collect()
            }
        })
    }
}

/// Those of a block of numbers.
fn bytes<T: Copy, const N: usize>(
    all: &[T],
    block: usize,
    bytes: impl Fn(T) -> [u8; N],
) -> Vec<u8> {
    let some = all.chunks(BLOCK / N).nth(block).unwrap_or(&[]);
    some.iter().flat_map(|&number| bytes(number)).collect()
}

impl From<Range<i64>> for Numbers<'_> {
    fn from(run: Range<i64>) -> Self {
        Self::Run(run)
    }
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
    /// What comes after the text, and how long all of it is in the file. Letters are made as it is written.
    appended: Vec<Vec<u8>>,
    length: usize,
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
            length: 0,
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
        let kind = match numbers {
            Numbers::Real(_) => "Float64",
            Numbers::Whole(_) | Numbers::Run(_) => "Int64",
            Numbers::Count(_) => "UInt32",
            Numbers::Byte(_) => "UInt8",
        };
        let _ = writeln!(
            self.text,
            "<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} format=\"appended\" offset=\"{}\"/>",
            self.length
        );
        self.append(numbers);
    }

    /// Bytes after their count; of compressed ones the number of blocks, their size, that of the last if it is less, and what each
    /// takes.
    fn append(&mut self, numbers: &Numbers<'_>) {
        let words = |numbers: &[usize]| -> Vec<u8> {
            let numbers = numbers.iter().map(|&number| number as u64);
            numbers.flat_map(u64::to_le_bytes).collect()
        };
        let length = numbers.length();
        if !self.is_compressed {
            let mut bytes = words(&[length]);
            bytes.reserve_exact(length);
            numbers.blocks().for_each(|block| bytes.extend(block));
            self.put(bytes);
            return;
        }
        let blocks: Vec<Vec<u8>> = numbers.blocks().map(|block| compressed(&block)).collect();
        let sizes = blocks.iter().map(Vec::len);
        let header: Vec<usize> = [blocks.len(), BLOCK, length % BLOCK]
            .into_iter()
            .chain(sizes)
            .collect();
        self.put(words(&header));
        self.put(blocks.concat());
    }

    /// Adds bytes, which go into the file as they are or as letters.
    fn put(&mut self, bytes: Vec<u8>) {
        self.length += if self.is_lettered {
            bytes.len().div_ceil(3) * 4
        } else {
            bytes.len()
        };
        self.appended.push(bytes);
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
            for bytes in &self.appended {
                if !self.is_lettered {
                    writer.write_all(bytes)?;
                    continue;
                }
                for some in bytes.chunks(LETTERED) {
                    writer.write_all(base64(some).as_bytes())?;
                }
            }
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
