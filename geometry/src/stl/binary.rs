//! The binary form of STL: 80 bytes of header, the count, and 50 bytes per triangle.

use std::io::{Cursor, Write};

use super::{Facet, Soup};
use crate::error::GeometryError;
use crate::{Bounds, Vector};

const HEADER: usize = 80;
const PREAMBLE: usize = HEADER + 4;
const RECORD: usize = 50;

/// A body that is fewer steps of its coordinates across has lost its shape: they are off by half a step.
const FEWEST_STEPS: f64 = 64.0;

/// The length of the file by the count it states; `None` where it is too short to state one.
pub(super) fn promised_length(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER..PREAMBLE)?.try_into().ok()?;
    Some(PREAMBLE + RECORD * u32::from_le_bytes(count) as usize)
}

pub(super) fn parse(mut bytes: Vec<u8>) -> Result<Soup, GeometryError> {
    let Some(promised) = promised_length(&bytes) else {
        return Err(GeometryError::Stl(format!(
            "{} bytes are too few for a binary file, and a text file begins with `solid`",
            bytes.len()
        )));
    };
    let is_text = |byte: &u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
    if promised != bytes.len() && bytes.iter().take(PREAMBLE).all(is_text) {
        return Err(GeometryError::Stl(
            "the file is text, but does not begin with `solid`: it is no STL file".into(),
        ));
    }
    if promised != bytes.len() {
        return Err(GeometryError::Stl(format!(
            "the header promises {} triangles, but the file holds {}{}: it is cut off or damaged",
            (promised - PREAMBLE) / RECORD,
            (bytes.len() - PREAMBLE) / RECORD,
            if (bytes.len() - PREAMBLE).is_multiple_of(RECORD) {
                ""
            } else {
                " and part of another"
            }
        )));
    }
    // The reader takes a file whose header begins with "solid" for text.
    bytes[..HEADER].fill(0);
    let mut cursor = Cursor::new(bytes);
    let damaged = |error: std::io::Error| GeometryError::Stl(error.to_string());
    let triangles = stl_io::create_stl_reader(&mut cursor).map_err(damaged)?;
    let mut soup = Soup::default();
    soup.begin("");
    soup.facets.reserve_exact((promised - PREAMBLE) / RECORD);
    for (index, triangle) in triangles.enumerate() {
        let corners = triangle
            .map_err(damaged)?
            .vertices
            .map(|vertex| Vector::<3>::from(vertex.0.map(f64::from)));
        if let Some(corner) = corners
            .iter()
            .find(|corner| !corner.iter().all(|x| x.is_finite()))
        {
            return Err(GeometryError::Stl(format!(
                "triangle {} has a corner at ({}, {}, {}), which is not finite",
                index + 1,
                corner.x,
                corner.y,
                corner.z
            )));
        }
        soup.facets.push(corners);
    }
    has_a_shape(&soup)?;
    Ok(soup)
}

/// Refuses a body so far from the origin that single precision leaves nothing of its shape.
fn has_a_shape(soup: &Soup) -> Result<(), GeometryError> {
    let mut corners = soup.facets.iter().flatten();
    let Some(&first) = corners.next() else {
        return Ok(());
    };
    let bounds = corners.fold(Bounds::new(first, first), |bounds, corner| {
        Bounds::new(bounds.min.inf(corner), bounds.max.sup(corner))
    });
    let away = bounds.min.abs().sup(&bounds.max.abs()).max();
    let steps = bounds.size().max() / (f64::from(f32::EPSILON) * away);
    if steps < FEWEST_STEPS {
        return Err(GeometryError::Stl(format!(
            "coordinates near {away:.6e} are in single precision, and all of the body is {steps:.0} of its steps across: its shape is lost; \
             move it to the origin before it is exported"
        )));
    }
    Ok(())
}

/// Writes triangles as a binary file, in single precision as the format has it.
///
/// # Errors
/// What the writer cannot write.
pub fn write_binary(writer: &mut impl Write, facets: &[Facet]) -> std::io::Result<()> {
    let single = |v: &Vector<3>| [v.x as f32, v.y as f32, v.z as f32];
    let triangles: Vec<stl_io::Triangle> = facets
        .iter()
        .map(|[a, b, c]| {
            let normal = (b - a)
                .cross(&(c - a))
                .try_normalize(0.0)
                .unwrap_or_default();
            stl_io::Triangle {
                normal: stl_io::Normal::new(single(&normal)),
                vertices: [a, b, c].map(|v| stl_io::Vertex::new(single(v))),
            }
        })
        .collect();
    stl_io::write_stl(writer, triangles.iter())
}
