//! Reads back what a run has written: arrays of a frame, cells of a surface, rows of a history.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use vtkio::model::{Attribute, DataSet, Piece, PolyDataPiece, Vtk};

use super::error::FlyError;

/// Points with their arrays.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// Positions.
    pub position: Vec<[f64; 3]>,
    /// Numbers by name; vectors three to a point.
    pub arrays: BTreeMap<String, Vec<f64>>,
}

/// Segments or triangles with their arrays.
#[derive(Clone, Debug, Default)]
pub struct Cells {
    /// Corners.
    pub corners: Vec<Vec<[f64; 3]>>,
    /// Numbers by name; vectors three to a cell.
    pub arrays: BTreeMap<String, Vec<f64>>,
}

/// The last file of a run whose name begins so.
pub fn last(folder: &Path, stem: &str) -> Option<PathBuf> {
    let files = std::fs::read_dir(folder).ok()?.flatten();
    let named = files.map(|file| file.path()).filter(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with(stem) && path.extension().is_some_and(|end| end == "vtp")
    });
    named.max()
}

fn piece(path: &Path) -> Result<PolyDataPiece, FlyError> {
    let fail = |why: &str| FlyError::Files(format!("`{}` {why}", path.display()));
    let vtk = Vtk::import(path).map_err(|error| fail(&error.to_string()))?;
    let DataSet::PolyData { pieces, .. } = vtk.data else {
        return Err(fail("holds no `PolyData`"));
    };
    match pieces.into_iter().next() {
        Some(Piece::Inline(piece)) => Ok(*piece),
        _ => Err(fail("holds no points")),
    }
}

fn arrays(attributes: &[Attribute]) -> BTreeMap<String, Vec<f64>> {
    let named = attributes.iter().filter_map(|attribute| match attribute {
        Attribute::DataArray(array) => Some((array.name.clone(), array.data.cast_into::<f64>()?)),
        Attribute::Field { .. } => None,
    });
    named.collect()
}

fn triples(numbers: &[f64]) -> Vec<[f64; 3]> {
    numbers.as_chunks::<3>().0.to_vec()
}

/// The gas of a frame.
///
/// # Errors
/// A file that is none.
pub fn gas(path: &Path) -> Result<Points, FlyError> {
    let piece = piece(path)?;
    let all = Points {
        position: triples(&piece.points.cast_into::<f64>().unwrap_or_default()),
        arrays: arrays(&piece.data.point),
    };
    let Some(kind) = all.arrays.get("kind") else {
        return Ok(all);
    };
    let chosen: Vec<usize> = (0..kind.len()).filter(|&n| kind[n] == 0.0).collect();
    let count = all.position.len();
    let pick = |values: &Vec<f64>| {
        let each = values.len() / count.max(1);
        let rows = chosen.iter();
        rows.flat_map(|&n| values[n * each..(n + 1) * each].to_vec())
            .collect::<Vec<f64>>()
    };
    Ok(Points {
        position: chosen.iter().map(|&n| all.position[n]).collect(),
        arrays: all
            .arrays
            .iter()
            .map(|(name, values)| (name.clone(), pick(values)))
            .collect(),
    })
}

/// The cells of a surface.
///
/// # Errors
/// A file that is none.
pub fn surface(path: &Path) -> Result<Cells, FlyError> {
    let piece = piece(path)?;
    let points = triples(&piece.points.cast_into::<f64>().unwrap_or_default());
    let topology = piece.polys.clone().or(piece.lines.clone());
    let Some(topology) = topology else {
        return Ok(Cells::default());
    };
    let (connectivity, offsets) = topology.into_xml();
    let mut from = 0;
    let corners = offsets.iter().map(|&to| {
        let cell = connectivity[from..to as usize].iter();
        from = to as usize;
        cell.map(|&n| points[n as usize]).collect()
    });
    Ok(Cells {
        corners: corners.collect(),
        arrays: arrays(&piece.data.cell),
    })
}

/// Columns of a history by name.
///
/// # Errors
/// A file that cannot be read.
pub fn history(path: &Path) -> Result<BTreeMap<String, Vec<f64>>, FlyError> {
    let text = std::fs::read_to_string(path)
        .map_err(|error| FlyError::Files(format!("`{}`: {error}", path.display())))?;
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let mut columns = vec![Vec::new(); names.len()];
    for line in lines {
        let fields: Vec<&str> = line.split(',').collect();
        if fields.len() == names.len() {
            for (column, field) in columns.iter_mut().zip(fields) {
                column.push(field.parse().unwrap_or(f64::NAN));
            }
        }
    }
    let names = names.into_iter().map(str::to_owned);
    Ok(names.zip(columns).collect())
}
