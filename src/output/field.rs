//! `field-NNNNNN.vti`: the gas on a lattice.

use std::path::Path;

use super::error::OutputError;
use super::reference::Reference;
use super::vtk_xml::{Document, Numbers};
use crate::sample::{Field, State};

/// What VTK's `vtkGhostType` says of a cell that is not to be shown.
const HIDDEN_CELL: u8 = 32;

/// Writes a field of the gas. Points in bodies are zero in `vtkValidPointMask`; cells wholly in bodies are hidden.
pub fn write_field(
    path: &Path,
    field: &Field,
    time: f64,
    reference: &Reference,
    is_compressed: bool,
) -> Result<(), OutputError> {
    let extent = field.cells.map(|n| format!("0 {n}")).join(" ");
    let list = |numbers: &[f64; 3]| numbers.map(|x| format!("{x:?}")).join(" ");
    let attributes = format!(
        " WholeExtent=\"{extent}\" Origin=\"{}\" Spacing=\"{}\"",
        list(&field.origin),
        list(&field.spacing)
    );
    let mut document = Document::new("ImageData", &attributes, is_compressed);
    document.field_data(&reference.told(time, is_compressed));
    document.open(&format!("Piece Extent=\"{extent}\""));
    document.open("PointData Scalars=\"pressure\" Vectors=\"velocity\"");
    let scale = reference.scale();
    let states = || field.states.iter();
    let mut scalars = |name: &str, value: &dyn Fn(&State) -> f64| {
        let values: Vec<f64> = states().map(value).collect();
        document.array(name, 1, Numbers::Real(&values));
    };
    scalars("density", &|state| state.density);
    scalars("pressure", &|state| state.pressure);
    scalars("mach", &|state| scale.mach(state));
    scalars("entropy", &|state| scale.entropy(state));
    if scale.gas_constant.is_some() {
        scalars("temperature", &|state| {
            scale.temperature(state).unwrap_or_default()
        });
    }
    let velocity: Vec<[f64; 3]> = states().map(|state| state.velocity).collect();
    document.array("velocity", 3, Numbers::Real(velocity.as_flattened()));
    let gradient: Vec<[f64; 3]> = states().map(|state| state.density_gradient).collect();
    document.array(
        "density_gradient",
        3,
        Numbers::Real(gradient.as_flattened()),
    );
    let mask: Vec<u8> = field
        .is_gas
        .iter()
        .map(|&is_gas| u8::from(is_gas))
        .collect();
    document.array("vtkValidPointMask", 1, Numbers::Byte(&mask));
    document.close("PointData");
    document.open("CellData");
    let hidden = field.hidden_cells().into_iter();
    let hidden: Vec<u8> = hidden
        .map(|is_hidden| if is_hidden { HIDDEN_CELL } else { 0 })
        .collect();
    document.array("vtkGhostType", 1, Numbers::Byte(&hidden));
    document.close("CellData");
    document.close("Piece");
    document.write(path)
}
