//! Files of triangles: which formats are read, and what to do with those that are not.

mod obj;
mod ply;

use std::io::Read as _;
use std::path::Path;

use crate::error::GeometryError;
use crate::mesh::triangulate;
use crate::stl::{self, Soup, Unit};
use crate::{Bounds, Vector};

/// Unpacked files may be this large, bytes: a packed one can hold a thousand times its own length.
const LARGEST: u64 = 8 << 30;

/// Reads an STL, OBJ or PLY file, which may be packed by gzip; the ending of its name tells which. The
/// numbers are in `unit`, the corners given in metres.
///
/// # Errors
/// A file that cannot be read, is damaged, or has another format.
pub fn read(path: &Path, unit: Unit) -> Result<Soup, GeometryError> {
    let within = |source| GeometryError::In {
        path: path.to_owned(),
        source: Box::new(source),
    };
    let cannot_read = |source| GeometryError::Read {
        path: path.to_owned(),
        source,
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.to_ascii_lowercase();
    let (name, packed) = match name.strip_suffix(".gz") {
        Some(inner) => (inner, true),
        None => (name.as_str(), false),
    };
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    refuse_others(ending).map_err(within)?;
    let mut bytes = std::fs::read(path).map_err(cannot_read)?;
    if packed {
        let mut unpacked = Vec::new();
        let reader = flate2::read::MultiGzDecoder::new(&bytes[..]);
        let length = reader.take(LARGEST).read_to_end(&mut unpacked);
        if length.map_err(cannot_read)? as u64 == LARGEST {
            let reason = format!("holds more than {LARGEST} bytes once unpacked");
            return Err(within(GeometryError::file("gzip", reason)));
        }
        bytes = unpacked;
    }
    let soup = match ending {
        "obj" => obj::parse(&bytes),
        "ply" => ply::parse(&bytes),
        _ => stl::parse(bytes),
    };
    let mut soup = soup.map_err(within)?;
    for corner in soup.facets.iter_mut().flatten() {
        *corner *= unit.metres();
    }
    Ok(soup)
}

/// The box around all triangles.
pub fn bounds(soup: &Soup) -> Bounds<3> {
    crate::mesh::bounds(soup.facets.iter().flatten().copied())
}

/// Name of the body in a file: the file's without its endings.
pub fn body_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let is_packed = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("gz"));
    let name = if is_packed {
        &name[..name.len() - ".gz".len()]
    } else {
        &name
    };
    match name.rsplit_once('.') {
        Some((stem, _)) if !stem.is_empty() => stem.to_owned(),
        _ => name.to_owned(),
    }
}

/// Refuses formats that are not read, and says how to make one of them that is.
fn refuse_others(ending: &str) -> Result<(), GeometryError> {
    let cad = "holds curved faces, not triangles: export it as STL from the program that made it, or \
               convert it, as by `gmsh body.step -2 -format stl -o body.stl` or FreeCAD's File > Export";
    let scene = "is not read: open it in Blender or MeshLab and export it as STL, OBJ or PLY";
    let reason = match ending {
        "stl" | "obj" | "ply" => return Ok(()),
        "step" | "stp" | "iges" | "igs" | "brep" | "x_t" | "sldprt" => cad,
        "3mf" => {
            "is not read: convert it, as by `prusa-slicer --export-stl body.3mf`, or open it in Blender \
             or MeshLab and export it as STL, OBJ or PLY"
        }
        "amf" | "gltf" | "glb" | "fbx" | "dae" | "blend" | "dxf" | "off" | "vtp" => scene,
        _ => {
            "is no format of bodies: give .stl, .obj or .ply, each packed as .gz or not, or a scene (.toml)"
        }
    };
    let ending = if ending.is_empty() {
        "no ending".to_owned()
    } else {
        format!(".{ending}")
    };
    Err(GeometryError::file("format", format!("{ending} {reason}")))
}

/// Adds the triangles of a polygon, whose corners are numbers of `points`.
fn add_polygon(soup: &mut Soup, points: &[Vector<3>], polygon: &[u32]) -> Result<(), String> {
    if let Some(missing) = polygon.iter().find(|&&v| v as usize >= points.len()) {
        return Err(format!(
            "a face names vertex {}, but there are {}",
            u64::from(*missing) + 1,
            points.len()
        ));
    }
    let corner = |v: u32| points[v as usize];
    match *polygon {
        [] | [_] | [_, _] => {}
        [a, b, c] => soup.facets.push([a, b, c].map(corner)),
        _ => {
            let corners: Vec<Vector<3>> = polygon.iter().map(|&v| corner(v)).collect();
            soup.facets.extend(triangulate(corners));
        }
    }
    Ok(())
}

/// Refuses numbers that are not finite, and files without triangles.
fn checked(format: &'static str, soup: Soup) -> Result<Soup, GeometryError> {
    if soup.facets.is_empty() {
        return Err(GeometryError::file(format, "the file holds no faces"));
    }
    let not_finite = |facet: &stl::Facet| !facet.iter().flatten().all(|x| x.is_finite());
    match soup.facets.iter().position(not_finite) {
        Some(index) => Err(GeometryError::file(
            format,
            format!("face {} has a corner that is not finite", index + 1),
        )),
        None => Ok(soup),
    }
}
