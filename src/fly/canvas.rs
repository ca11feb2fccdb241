//! Pictures as pixels, and as text that a page can hold.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::base64::base64;

/// Red, green, blue.
pub type Colour = [u8; 3];

/// Pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Their colours.
    pub pixels: Vec<Colour>,
}

impl Picture {
    /// All of one colour.
    pub fn new(size: [usize; 2], colour: Colour) -> Self {
        Self {
            size,
            pixels: vec![colour; size[0] * size[1]],
        }
    }

    /// The picture at half its size, each pixel the mean of four.
    pub fn halved(&self) -> Self {
        let size = self.size.map(|n| n / 2);
        let at = |x: usize, y: usize| self.pixels[y * self.size[0] + x];
        let pixels = (0..size[0] * size[1]).map(|n| {
            let (x, y) = (2 * (n % size[0]), 2 * (n / size[0]));
            let four = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            std::array::from_fn(|c| (four.iter().map(|p| u16::from(p[c])).sum::<u16>() / 4) as u8)
        });
        Self {
            pixels: pixels.collect(),
            size,
        }
    }

    /// The picture as a PNG file (ISO/IEC 15948).
    pub fn png(&self) -> Vec<u8> {
        let mut rows = Vec::with_capacity(self.pixels.len() * 3 + self.size[1]);
        for row in self.pixels.chunks(self.size[0].max(1)) {
            // No filter.
            rows.push(0);
            rows.extend(row.as_flattened());
        }
        let mut packer = ZlibEncoder::new(Vec::new(), Compression::best());
        // Writing to memory cannot fail.
        let _ = packer.write_all(&rows);
        let packed = packer.finish().unwrap_or_default();
        let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
        let mut head = Vec::new();
        for n in self.size {
            head.extend((n as u32).to_be_bytes());
        }
        // Eight bits, red green blue, deflate, adaptive filters, not interlaced.
        head.extend([8, 2, 0, 0, 0]);
        chunk(&mut file, *b"IHDR", &head);
        chunk(&mut file, *b"IDAT", &packed);
        chunk(&mut file, *b"IEND", &[]);
        file
    }

    /// The picture in an address.
    pub fn data_uri(&self) -> String {
        format!("data:image/png;base64,{}", base64(&self.png()))
    }
}

fn chunk(file: &mut Vec<u8>, name: [u8; 4], data: &[u8]) {
    file.extend((data.len() as u32).to_be_bytes());
    file.extend(name);
    file.extend(data);
    let mut check = flate2::Crc::new();
    check.update(&name);
    check.update(data);
    file.extend(check.sum().to_be_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_a_png_with_its_size() {
        let png = Picture::new([3, 2], [1, 2, 3]).png();
        assert_eq!(&png[1..4], b"PNG");
        assert_eq!(&png[16..24], [0, 0, 0, 3, 0, 0, 0, 2]);
        assert_eq!(&png[png.len() - 8..png.len() - 4], b"IEND");
    }
}
