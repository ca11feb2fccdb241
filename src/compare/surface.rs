//! Surfaces of triangles that comparisons make for themselves.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use aero_solver::frame::SurfaceFrame;

use super::context::CompareError;

/// Walls smaller than this, in squares of a spacing, are slivers.
const SLIVER: f64 = 0.1;

/// Mean by area of the pressure on walls `spacing` wide, and that which is farthest from `exact`, where `is_there`; but for slivers.
pub fn pressed(
    surface: &SurfaceFrame,
    spacing: f64,
    exact: f64,
    is_there: impl Fn(&[f64; 3]) -> bool,
) -> [f64; 2] {
    let walls = surface.position.iter().zip(&surface.pressure);
    let (mut sum, mut size, mut farthest) = (0.0, 0.0, exact);
    for ((foot, pressure), area) in walls.zip(&surface.area) {
        if is_there(foot) && *area > SLIVER * spacing * spacing {
            sum += area * pressure;
            size += area;
            if (pressure - exact).abs() > (farthest - exact).abs() {
                farthest = *pressure;
            }
        }
    }
    [sum / size, farthest]
}

/// A triangle.
pub type Facet = [[f64; 3]; 3];

/// Facets of the prism from `outline`, which is convex and goes round to the left as seen from beyond its further end, between the heights
/// `ends`; `place` tells where a point of the plane and a height are.
pub fn prism(
    outline: &[[f64; 2]],
    ends: [f64; 2],
    place: impl Fn([f64; 2], f64) -> [f64; 3],
) -> Vec<Facet> {
    let corner = |n: usize, end: usize| place(outline[n % outline.len()], ends[end]);
    let mut facets = Vec::new();
    for n in 0..outline.len() {
        let [a, b] = [corner(n, 0), corner(n + 1, 0)];
        let [c, d] = [corner(n + 1, 1), corner(n, 1)];
        facets.extend([[a, b, c], [a, c, d]]);
    }
    // A fan covers an end.
    for n in 1..outline.len() - 1 {
        facets.push([corner(0, 1), corner(n, 1), corner(n + 1, 1)]);
        facets.push([corner(0, 0), corner(n + 1, 0), corner(n, 0)]);
    }
    facets
}

/// Writes `facets` to `NAME.stl` in `folder`, beside the pictures; the setting that makes them the shape of `body`.
///
/// # Errors
/// A file that cannot be written.
pub fn as_shape(
    body: &str,
    folder: &Path,
    name: &str,
    facets: &[Facet],
) -> Result<String, CompareError> {
    let path = written(folder, name, facets)?;
    Ok(format!(
        "body.{body}.shape={{ stl = {{ file = {:?} }} }}",
        path.display().to_string()
    ))
}

/// Writes the facets; where they are.
fn written(folder: &Path, name: &str, facets: &[Facet]) -> Result<PathBuf, CompareError> {
    let mut text = format!("solid {name}\n");
    for facet in facets {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for [x, y, z] in facet {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "vertex {x:?} {y:?} {z:?}");
        }
        text.push_str("endloop\nendfacet\n");
    }
    text.push_str("endsolid\n");
    let path = folder.join(format!("{name}.stl"));
    let report = |source| CompareError::Report {
        path: path.clone(),
        source,
    };
    std::fs::create_dir_all(folder).map_err(report)?;
    std::fs::write(&path, text).map_err(report)?;
    std::path::absolute(&path).map_err(report)
}
