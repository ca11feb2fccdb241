//! VTK XML `PolyData`: point clouds, one vertex cell per point, so that `ParaView` draws them without a filter; and surfaces of
//! segments or triangles, whose arrays belong to the cells.

use std::collections::HashMap;
use std::io;
use std::path::Path;

use vtkio::IOBuffer;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, DataArray, DataSet, ElementType, PolyDataPiece, Version,
    VertexNumbers, Vtk,
};
use vtkio::xml::Compressor;

use super::atomic;
use super::error::OutputError;

/// Effort that zlib spends, of 9: more takes longer and hardly saves.
const LEVEL: u32 = 4;

/// Points, or what spans them, with arrays, ready to be written.
pub(super) struct Cloud {
    points: Vec<f64>,
    /// Corners of each cell, and all of them cell by cell; none of a cloud.
    cells: Option<(usize, Vec<u64>)>,
    arrays: Vec<Attribute>,
    compressor: Compressor,
}

impl Cloud {
    /// Points without arrays yet.
    pub(super) fn new(points: &[[f64; 3]]) -> Self {
        Self {
            points: points.as_flattened().to_vec(),
            cells: None,
            arrays: Vec::new(),
            compressor: Compressor::None,
        }
    }

    /// Cells of so many corners each, without arrays yet: points, segments or triangles. Corners at the same place are one
    /// point.
    pub(super) fn of_cells(each: usize, corners: &[[f64; 3]]) -> Self {
        let mut known = HashMap::new();
        let mut points = Vec::new();
        let mut numbers = Vec::with_capacity(corners.len());
        for corner in corners {
            // Zero has two signs.
            let place = corner.map(|x| (x + 0.0).to_bits());
            let number = *known.entry(place).or_insert_with(|| {
                points.push(*corner);
                points.len() as u64 - 1
            });
            numbers.push(number);
        }
        Self {
            cells: Some((each, numbers)),
            ..Self::new(&points)
        }
    }

    /// Adds an array of vectors.
    pub(super) fn vectors(mut self, name: &str, values: &[[f64; 3]]) -> Self {
        self.push(name, ElementType::Vectors, values.as_flattened().to_vec());
        self
    }

    /// Adds an array of numbers.
    pub(super) fn scalars<T: Clone>(mut self, name: &str, values: &[T]) -> Self
    where
        Vec<T>: Into<IOBuffer>,
    {
        let element = ElementType::Scalars {
            num_comp: 1,
            lookup_table: None,
        };
        self.push(name, element, values.to_vec());
        self
    }

    fn push(&mut self, name: &str, elem: ElementType, data: impl Into<IOBuffer>) {
        self.arrays.push(Attribute::DataArray(DataArray {
            name: name.to_owned(),
            elem,
            data: data.into(),
        }));
    }

    /// Has the file compressed, if so wished: smaller, and slower to write.
    pub(super) fn compressed(mut self, is_compressed: bool) -> Self {
        if is_compressed {
            self.compressor = Compressor::ZLib;
        }
        self
    }

    /// Writes the file.
    pub(super) fn write(self, path: &Path) -> Result<(), OutputError> {
        let count = (self.points.len() / 3) as u64;
        let (each, connectivity) = self.cells.unwrap_or_else(|| (0, (0..count).collect()));
        let corners = each.max(1);
        let offsets = 1..=connectivity.len() / corners;
        let topology = Some(VertexNumbers::XML {
            offsets: offsets.map(|n| (n * corners) as u64).collect(),
            connectivity,
        });
        let [mut verts, mut lines, mut polys] = [None, None, None];
        match each {
            0 | 1 => verts = topology,
            2 => lines = topology,
            _ => polys = topology,
        }
        let (point, cell) = match each {
            0 => (self.arrays, Vec::new()),
            _ => (Vec::new(), self.arrays),
        };
        let vtk = Vtk {
            version: Version::new_xml(1, 0),
            byte_order: ByteOrder::LittleEndian,
            title: String::new(),
            file_path: None,
            data: DataSet::inline(PolyDataPiece {
                points: self.points.into(),
                verts,
                lines,
                polys,
                data: Attributes { point, cell },
                ..Default::default()
            }),
        };
        let broken = |error: &dyn std::fmt::Display| io::Error::other(error.to_string());
        atomic::write(path, |writer| {
            let file = vtk
                .try_into_xml_format(self.compressor, LEVEL)
                .map_err(|error| broken(&error))?;
            file.write(writer).map_err(|error| match error {
                vtkio::xml::Error::IO(source) => source,
                other => broken(&other),
            })
        })
    }
}
