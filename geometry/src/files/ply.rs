//! PLY files, text or binary of either byte order: elements `vertex` with `x`, `y`, `z` and `face` with
//! a list of vertices.

use std::io::Cursor;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use super::{add_polygon, checked};
use crate::Vector;
use crate::error::GeometryError;
use crate::stl::Soup;

/// A vertex or a face; what else they carry is passed over.
#[derive(Default)]
struct Element {
    place: [Option<f64>; 3],
    corners: Option<Vec<u32>>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
        if let Some(axis) = axis {
            self.place[axis] = number(&property);
        } else if ["vertex_indices", "vertex_index"].contains(&name) {
            self.corners = property.to_u32_list();
        } else {
            return PropertyAccessResult::Ignored;
        }
        PropertyAccessResult::Set
    }
}

fn number(property: &Property) -> Option<f64> {
    match property {
        Property::Double(x) => Some(*x),
        Property::Int(x) => Some(f64::from(*x)),
        Property::UInt(x) => Some(f64::from(*x)),
        other => other.to_f32_lossy().map(f64::from),
    }
}

pub(super) fn parse(bytes: &[u8]) -> Result<Soup, GeometryError> {
    let damaged = |reason: String| GeometryError::file("ply", reason);
    let mut reader = Cursor::new(bytes);
    let ply = Parser::<Element>::new()
        .read_ply(&mut reader)
        .map_err(|error| damaged(error.to_string()))?;
    let elements = |name: &str| {
        let list = ply.payload.get(name);
        list.ok_or_else(|| damaged(format!("the file has no element `{name}`")))
    };
    let mut points = Vec::with_capacity(elements("vertex")?.len());
    for (index, vertex) in elements("vertex")?.iter().enumerate() {
        let [Some(x), Some(y), Some(z)] = vertex.place else {
            return Err(damaged(format!("vertex {} lacks x, y or z", index + 1)));
        };
        points.push(Vector::<3>::new(x, y, z));
    }
    let mut soup = Soup::default();
    soup.begin("");
    for (index, face) in elements("face")?.iter().enumerate() {
        let Some(corners) = &face.corners else {
            return Err(damaged(format!(
                "face {} has no list `vertex_indices` of numbers from zero",
                index + 1
            )));
        };
        add_polygon(&mut soup, &points, corners).map_err(damaged)?;
    }
    checked("ply", soup)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "element vertex 4\nproperty float x\nproperty float y\nproperty double z\n\
                        property uchar red\nelement face 2\n\
                        property list uchar int vertex_indices\nend_header\n";

    fn text() -> String {
        let points = "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0.5 9\n";
        format!("ply\nformat ascii 1.0\ncomment by hand\n{HEAD}{points}4 0 1 2 3\n3 0 2 1\n")
    }

    #[test]
    fn text_and_binary_files_of_either_order_hold_the_same_triangles() {
        let soup = parse(text().as_bytes()).unwrap();
        assert_eq!(soup.facets.len(), 3);
        assert_eq!(soup.facets[2][1], Vector::<3>::new(1.0, 1.0, 0.0));
        for little in [true, false] {
            let order = if little { "little" } else { "big" };
            let head = format!("ply\nformat binary_{order}_endian 1.0\n{HEAD}");
            let mut bytes = head.into_bytes();
            let f32s = |x: f32| {
                if little {
                    x.to_le_bytes()
                } else {
                    x.to_be_bytes()
                }
            };
            let f64s = |x: f64| {
                if little {
                    x.to_le_bytes()
                } else {
                    x.to_be_bytes()
                }
            };
            let i32s = |x: i32| {
                if little {
                    x.to_le_bytes()
                } else {
                    x.to_be_bytes()
                }
            };
            for (x, y, z) in [
                (0.0, 0.0, 0.0),
                (1.0, 0.0, 0.0),
                (1.0, 1.0, 0.0),
                (0.0, 1.0, 0.5),
            ] {
                bytes.extend([f32s(x), f32s(y)].concat());
                bytes.extend(f64s(z));
                bytes.push(9);
            }
            for face in [&[0, 1, 2, 3][..], &[0, 2, 1]] {
                bytes.push(face.len() as u8);
                bytes.extend(face.iter().flat_map(|&v| i32s(v)));
            }
            assert_eq!(parse(&bytes).unwrap(), soup);
            bytes.truncate(bytes.len() - 3);
            assert!(parse(&bytes).is_err());
        }
    }

    #[test]
    fn damaged_files_are_refused_with_a_reason() {
        let cases = [
            ("", ""),
            ("vertex 4", "vertex 5"),
            ("3 0 2 1", "3 0 2 7"),
            ("3 0 2 1", "3 0 2 -1"),
            ("4 0 1", "400000000 0 1"),
            ("element face", "element fan"),
            ("double z", "double w"),
            ("0 1 0.5", "0 1 nan"),
            ("face 2", "face 999999999999"),
        ];
        for (old, new) in cases {
            let text = if old.is_empty() {
                String::new()
            } else {
                text().replace(old, new)
            };
            let error = parse(text.as_bytes()).unwrap_err().to_string();
            assert!(error.starts_with("ply: "), "{error}");
        }
    }
}
