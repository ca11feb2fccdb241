//! OBJ files: faces of any number of corners, in groups and objects.

use std::collections::HashMap;
use std::path::Path;

use super::{add_polygon, checked};
use crate::Vector;
use crate::error::GeometryError;
use crate::stl::Soup;

pub(super) fn parse(bytes: &[u8]) -> Result<Soup, GeometryError> {
    let damaged = |reason: String| GeometryError::file("obj", reason);
    let options = tobj::LoadOptions::default();
    let no_materials = |_: &Path| Ok((Vec::new(), HashMap::new()));
    let mut reader = bytes;
    let (models, _) = tobj::load_obj_buf(&mut reader, &options, no_materials)
        .map_err(|error| damaged(error.to_string()))?;
    let mut soup = Soup::default();
    for model in models {
        soup.begin(&model.name);
        let mesh = model.mesh;
        let (points, _) = mesh.positions.as_chunks::<3>();
        let points: Vec<Vector<3>> = points.iter().map(|p| Vector::from(*p)).collect();
        let mut left = &mesh.indices[..];
        let triangles = vec![3; left.len() / 3];
        let arities = if mesh.face_arities.is_empty() {
            &triangles
        } else {
            &mesh.face_arities
        };
        for &arity in arities {
            let Some((polygon, rest)) = left.split_at_checked(arity as usize) else {
                return Err(damaged("a face has fewer corners than it says".into()));
            };
            add_polygon(&mut soup, &points, polygon).map_err(damaged)?;
            left = rest;
        }
    }
    checked("obj", soup)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_of_any_number_of_corners_become_triangles() {
        let text = "o box\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nvt 0 0\nvn 0 0 1\n\
                    f 1/1/1 2/1/1 3/1/1 4/1/1 5/1/1\ng lid\nf -5//1 -4//1 -3//1\nl 1 2\n";
        let soup = parse(text.as_bytes()).unwrap();
        assert_eq!(soup.facets.len(), 4);
        let names: Vec<&str> = soup.solids.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["box", "lid"]);
        let area = |[a, b, c]: &[Vector<3>; 3]| 0.5 * (b - a).cross(&(c - a)).z;
        // The polygon is not convex: a fan would cover the notch.
        let first: f64 = soup.facets[..3].iter().map(area).sum();
        assert!((first - 2.5).abs() < 1e-12, "{first}");
        assert!(soup.facets[..3].iter().all(|facet| area(facet) > 0.0));
    }

    #[test]
    fn damaged_files_are_refused_with_a_reason() {
        for text in [
            "",
            "v 0 0 0\n",
            "v 0 0 0\nf 1 2 3\n",
            "v 0 0 x\n",
            "v 0 0 0\nf 1 1 a\n",
        ] {
            let error = parse(text.as_bytes()).unwrap_err().to_string();
            assert!(error.starts_with("obj: "), "{error}");
        }
        let text = "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        assert!(parse(text.as_bytes()).is_err());
    }
}
