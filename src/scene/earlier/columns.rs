//! What the frame of an earlier run says of its particles or points.

use std::path::Path;

use aero_geometry::Vector;
use aero_solver::problem::Split;
use vtkio::model::{Attribute, DataSet, Piece, PolyDataPiece, Vtk};

/// The points of cells that the lattice was split into.
pub fn split<const D: usize>(columns: &Columns) -> Vec<Split<D>> {
    let Some(widest) = widest(columns) else {
        return Vec::new();
    };
    let numbers = (0..columns.spacing.len()).filter(|&n| columns.spacing[n] < 0.75 * widest);
    let each = numbers.map(|n| Split {
        point: Vector::from_fn(|k, _| columns.position[3 * n + k]),
        level: (widest / columns.spacing[n]).log2().round() as u8,
    });
    each.collect()
}

/// Spacing of the lattice of points that stay.
pub fn widest(columns: &Columns) -> Option<f64> {
    let spacings = columns.spacing.iter().copied();
    spacings
        .filter(|spacing| spacing.is_finite())
        .max_by(f64::total_cmp)
}

/// What a frame says of its particles; vectors three numbers each.
pub struct Columns {
    pub position: Vec<f64>,
    pub velocity: Vec<f64>,
    pub density: Vec<f64>,
    pub pressure: Vec<f64>,
    pub smoothing_length: Vec<f64>,
    /// Of points that stay, otherwise empty.
    pub spacing: Vec<f64>,
    pub kind: Vec<f64>,
}

pub fn read(path: &Path) -> Result<Columns, String> {
    std::fs::File::open(path).map_err(|error| format!("cannot be read: {error}"))?;
    let vtk = Vtk::import(path).map_err(|_| "is no VTK file, or not all of one")?;
    let DataSet::PolyData { pieces, .. } = vtk.data else {
        return Err("holds no `PolyData`".into());
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        return Err("holds no points".into());
    };
    let position: Vec<f64> = piece.points.cast_into().unwrap_or_default();
    let count = position.len() / 3;
    let column = |name, components| column(&piece, name, components * count);
    Ok(Columns {
        velocity: column("velocity", 3)?,
        density: column("density", 1)?,
        pressure: column("pressure", 1)?,
        smoothing_length: column("smoothing_length", 1)?,
        kind: column("kind", 1)?,
        spacing: column("spacing", 1).unwrap_or_default(),
        position,
    })
}

/// The `length` numbers of a named array.
fn column(piece: &PolyDataPiece, name: &str, length: usize) -> Result<Vec<f64>, String> {
    let arrays = piece.data.point.iter();
    let mut named = arrays.filter_map(|attribute| match attribute {
        Attribute::DataArray(array) if array.name == name => Some(&array.data),
        _ => None,
    });
    let data = named
        .next()
        .ok_or_else(|| format!("has no array `{name}`"))?;
    let numbers: Vec<f64> = data.cast_into().unwrap_or_default();
    if numbers.len() == length {
        return Ok(numbers);
    }
    let found = numbers.len();
    Err(format!(
        "has {found} numbers in the array `{name}`, not {length}"
    ))
}
