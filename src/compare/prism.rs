//! Bodies of one section all along, as files of triangles.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use super::context::CompareError;

/// The surface between two planes across the third axis whose section is convex, travelled counter-clockwise.
pub fn facets(section: &[[f64; 2]], ends: [f64; 2]) -> Vec<[[f64; 3]; 3]> {
    let corner = |n: usize, end: usize| {
        let [x, y] = section[n % section.len()];
        [x, y, ends[end]]
    };
    let mut facets = Vec::new();
    for n in 0..section.len() {
        let [a, b] = [corner(n, 0), corner(n + 1, 0)];
        let [c, d] = [corner(n + 1, 1), corner(n, 1)];
        facets.extend([[a, b, c], [a, c, d]]);
    }
    // The section is convex: a fan covers an end.
    for n in 1..section.len() - 1 {
        facets.push([corner(0, 1), corner(n, 1), corner(n + 1, 1)]);
        facets.push([corner(0, 0), corner(n + 1, 0), corner(n, 0)]);
    }
    facets
}

/// Writes the triangles as `NAME.stl` beside the pictures; where they are.
///
/// # Errors
/// A file that cannot be written.
pub fn written(
    folder: &Path,
    name: &str,
    facets: &[[[f64; 3]; 3]],
) -> Result<PathBuf, CompareError> {
    let mut text = format!("solid {name}\n");
    for facet in facets {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for [x, y, z] in facet {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "vertex {x:?} {y:?} {z:?}");
        }
        text.push_str("endloop\nendfacet\n");
    }
    let _ = writeln!(text, "endsolid {name}");
    let path = folder.join(format!("{name}.stl"));
    let report = |source| CompareError::Report {
        path: path.clone(),
        source,
    };
    std::fs::create_dir_all(folder).map_err(report)?;
    std::fs::write(&path, text).map_err(report)?;
    std::path::absolute(&path).map_err(report)
}
