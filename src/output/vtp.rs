//! Point clouds as VTK XML `PolyData`, one vertex cell per point, so that `ParaView` draws them
//! without a filter.

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

/// Points with arrays, ready to be written.
pub(super) struct Cloud {
    points: Vec<f64>,
    arrays: Vec<Attribute>,
    compressor: Compressor,
}

impl Cloud {
    /// Points without arrays yet.
    pub(super) fn new(points: &[[f64; 3]]) -> Self {
        Self {
            points: points.as_flattened().to_vec(),
            arrays: Vec::new(),
            compressor: Compressor::None,
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
        let vtk = Vtk {
            version: Version::new_xml(1, 0),
            byte_order: ByteOrder::LittleEndian,
            title: String::new(),
            file_path: None,
            data: DataSet::inline(PolyDataPiece {
                points: self.points.into(),
                verts: Some(VertexNumbers::XML {
                    connectivity: (0..count).collect(),
                    offsets: (1..=count).collect(),
                }),
                data: Attributes {
                    point: self.arrays,
                    cell: Vec::new(),
                },
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
