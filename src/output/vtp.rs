//! Point clouds as VTK XML `PolyData`, one vertex cell per point, so that `ParaView` draws them
//! without a filter.

use std::io;
use std::path::Path;

use vtkio::IOBuffer;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, DataArray, DataSet, ElementType, PolyDataPiece, Version,
    VertexNumbers, Vtk,
};

use super::{OutputError, atomic};

/// Points with arrays, ready to be written.
pub(super) struct Cloud {
    points: Vec<f64>,
    arrays: Vec<Attribute>,
}

impl Cloud {
    /// Points without arrays yet.
    pub(super) fn new(points: &[[f64; 3]]) -> Self {
        Self {
            points: points.as_flattened().to_vec(),
            arrays: Vec::new(),
        }
    }

    /// Adds an array of vectors.
    pub(super) fn vectors(mut self, name: &str, values: &[[f64; 3]]) -> Self {
        self.push(name, ElementType::Vectors, values.as_flattened().to_vec());
        self
    }

    /// Adds an array of numbers.
    pub(super) fn scalars(mut self, name: &str, values: impl Into<IOBuffer>) -> Self {
        let element = ElementType::Scalars {
            num_comp: 1,
            lookup_table: None,
        };
        self.push(name, element, values);
        self
    }

    fn push(&mut self, name: &str, elem: ElementType, data: impl Into<IOBuffer>) {
        self.arrays.push(Attribute::DataArray(DataArray {
            name: name.to_owned(),
            elem,
            data: data.into(),
        }));
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
        atomic::write(path, |writer| {
            vtk.write_xml(writer).map_err(|error| match error {
                vtkio::Error::IO(source) => source,
                other => io::Error::other(other.to_string()),
            })
        })
    }
}
