//! Arrays of numbers as VTK's appended data: a count of bytes, then the bytes, little end first; or blocks
//! compressed by zlib behind a table of their lengths.

use std::io::{self, Write};
use std::ops::Range;

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// Bytes of a block that is compressed at once, and of a piece that is turned into bytes at once.
const BLOCK: usize = 1 << 20;

/// Numbers to be written.
#[derive(Clone, Copy, Debug)]
pub(super) enum Numbers<'a> {
    /// Real numbers.
    F64(&'a [f64]),
    /// Small whole numbers.
    U8(&'a [u8]),
    /// Whole numbers.
    U32(&'a [u32]),
    /// Large whole numbers.
    U64(&'a [u64]),
    /// So many, each one more than the one before.
    Count { from: usize, count: usize },
}

impl<'a> From<&'a [f64]> for Numbers<'a> {
    fn from(values: &'a [f64]) -> Self {
        Self::F64(values)
    }
}

impl<'a> From<&'a [u8]> for Numbers<'a> {
    fn from(values: &'a [u8]) -> Self {
        Self::U8(values)
    }
}

impl<'a> From<&'a [u32]> for Numbers<'a> {
    fn from(values: &'a [u32]) -> Self {
        Self::U32(values)
    }
}

impl<'a> From<&'a [u64]> for Numbers<'a> {
    fn from(values: &'a [u64]) -> Self {
        Self::U64(values)
    }
}

impl Numbers<'_> {
    /// `count` numbers from `from` on.
    pub(super) fn count_from(from: usize, count: usize) -> Self {
        Self::Count { from, count }
    }

    /// How many.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::F64(values) => values.len(),
            Self::U8(values) => values.len(),
            Self::U32(values) => values.len(),
            Self::U64(values) => values.len(),
            Self::Count { count, .. } => *count,
        }
    }

    /// What VTK calls them.
    pub(super) fn vtk_type(&self) -> &'static str {
        match self {
            Self::F64(_) => "Float64",
            Self::U8(_) => "UInt8",
            Self::U32(_) => "UInt32",
            Self::U64(_) => "UInt64",
            Self::Count { .. } => "Int64",
        }
    }

    /// Bytes of one.
    fn size(&self) -> usize {
        match self {
            Self::U8(_) => 1,
            Self::U32(_) => 4,
            Self::F64(_) | Self::U64(_) | Self::Count { .. } => 8,
        }
    }

    /// The bytes of a part of them.
    fn bytes(&self, part: Range<usize>, bytes: &mut Vec<u8>) {
        bytes.clear();
        match self {
            Self::F64(values) => bytes.extend(values[part].iter().flat_map(|v| v.to_le_bytes())),
            Self::U8(values) => bytes.extend_from_slice(&values[part]),
            Self::U32(values) => bytes.extend(values[part].iter().flat_map(|v| v.to_le_bytes())),
            Self::U64(values) => bytes.extend(values[part].iter().flat_map(|v| v.to_le_bytes())),
            Self::Count { from, .. } => {
                bytes.extend(part.flat_map(|number| ((from + number) as u64).to_le_bytes()));
            }
        }
    }

    /// Calls `visit` with the bytes of block after block.
    fn for_each_block(&self, mut visit: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        let per_block = BLOCK / self.size();
        let mut bytes = Vec::with_capacity(BLOCK.min(self.len() * self.size()));
        for start in (0..self.len()).step_by(per_block) {
            self.bytes(start..self.len().min(start + per_block), &mut bytes);
            visit(&bytes)?;
        }
        Ok(())
    }

    /// Writes them as they are; returns the number of bytes.
    pub(super) fn write(&self, writer: &mut impl Write) -> io::Result<u64> {
        let length = (self.len() * self.size()) as u64;
        writer.write_all(&length.to_le_bytes())?;
        self.for_each_block(|bytes| writer.write_all(bytes))?;
        Ok(8 + length)
    }

    /// Writes them compressed; returns the number of bytes.
    pub(super) fn write_compressed(&self, writer: &mut impl Write) -> io::Result<u64> {
        let mut blocks = Vec::new();
        self.for_each_block(|bytes| {
            let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
            encoder.write_all(bytes)?;
            blocks.push(encoder.finish()?);
            Ok(())
        })?;
        // Number of blocks, length of a whole one, of the last one if it is not whole, and of each once
        // compressed.
        let length = self.len() * self.size();
        let head = [blocks.len(), BLOCK, length % BLOCK];
        let table = head.into_iter().chain(blocks.iter().map(Vec::len));
        let table: Vec<u8> = table.flat_map(|n| (n as u64).to_le_bytes()).collect();
        let mut written = table.len();
        writer.write_all(&table)?;
        for block in &blocks {
            writer.write_all(block)?;
            written += block.len();
        }
        Ok(written as u64)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use flate2::read::ZlibDecoder;

    use super::*;

    #[test]
    fn numbers_are_written_behind_their_length() {
        let mut bytes = Vec::new();
        let written = Numbers::from(&[1_u32, 258][..]).write(&mut bytes).unwrap();
        assert_eq!(bytes, [8, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 0]);
        assert_eq!(written, 16);
    }

    #[test]
    fn compressed_blocks_hold_the_same_bytes() {
        let values: Vec<f64> = (0..300_000).map(|k| f64::from(k).sqrt()).collect();
        let numbers = Numbers::from(&values[..]);
        let mut raw = Vec::new();
        numbers.write(&mut raw).unwrap();
        let mut packed = Vec::new();
        let written = numbers.write_compressed(&mut packed).unwrap();
        assert_eq!(written, packed.len() as u64);

        let word = |k: usize| u64::from_le_bytes(packed[8 * k..8 * k + 8].try_into().unwrap());
        assert_eq!(
            [word(0), word(1), word(2)],
            [3, 1 << 20, 2_400_000 % (1 << 20)]
        );
        let mut back = Vec::new();
        let mut start = 8 * (3 + 3);
        for block in 0..3 {
            let end = start + word(3 + block) as usize;
            let mut decoder = ZlibDecoder::new(&packed[start..end]);
            decoder.read_to_end(&mut back).unwrap();
            start = end;
        }
        assert_eq!(start, packed.len());
        assert!(back == raw[8..]);
    }
}
