//! What Negi, Ramachandran & Haftu 2020 print: errors of pressure, speed and velocity across (tables 1 to 6).

use super::cases::{Case, DAMPING, Suite};

/// Errors of pressure and both velocities, where they are printed.
pub type Printed = [Option<f64>; 3];

/// Treatments in the order of the paper's tables.
const NAMES: [&str; 5] = [
    "characteristic",
    "do-nothing",
    "hybrid",
    "mirror",
    "modified do-nothing",
];

/// Table 1, and table 3: pressure and speed.
const PULSE: [[f64; 2]; 5] = [
    [0.328, 0.057],
    [0.629, 0.038],
    [0.311, 0.035],
    [0.409, 0.106],
    [0.341, 0.042],
];
const RAMP: [[f64; 2]; 5] = [
    [1.099, 0.193],
    [0.433, 0.066],
    [0.043, 0.007],
    [0.123, 0.074],
    [0.197, 0.039],
];
/// Table 2: pressure, with this damping.
pub const DAMPINGS: [f64; 4] = [0.1, 0.2, 0.5, 1.0];
const PULSE_DAMPED: [[f64; 4]; 5] = [
    [0.336, 0.334, 0.328, 0.315],
    [1.135, 0.864, 0.629, 0.587],
    [0.339, 0.319, 0.311, 0.306],
    [0.533, 0.463, 0.409, 0.371],
    [0.391, 0.543, 0.341, 0.354],
];
/// Tables 4 to 6, of these viscosities, m^2/s: Reynolds numbers of a metre, which the paper does not name, and 1 m/s.
pub const VISCOSITIES: [f64; 3] = [0.0, 1e-2, 1e-4];
const VORTEX: [[[f64; 3]; 5]; 3] = [
    [
        [1.216, 0.013, 0.959],
        [0.554, 0.002, 0.174],
        [0.569, 0.002, 0.173],
        [1.588, 0.010, 0.806],
        [0.629, 0.002, 0.182],
    ],
    [
        [0.556, 0.001, 0.263],
        [0.521, 0.001, 0.258],
        [0.519, 0.001, 0.255],
        [0.475, 0.006, 0.725],
        [0.556, 0.001, 0.263],
    ],
    [
        [1.213, 0.013, 0.961],
        [0.553, 0.002, 0.175],
        [0.566, 0.002, 0.173],
        [1.541, 0.010, 0.803],
        [0.589, 0.002, 0.181],
    ],
];

/// The figures of a treatment. Table 5 has the same three for the characteristic as for the modified do-nothing, one of them by mistake: the
/// former's are left out.
pub fn printed(suite: &Suite, treatment: &str) -> Printed {
    let Some(row) = NAMES.iter().position(|name| *name == treatment) else {
        return [None; 3];
    };
    let two = |[p, u]: [f64; 2]| [Some(p), Some(u), None];
    let is_copied = treatment == NAMES[0] && suite.viscosity == VISCOSITIES[1];
    match suite.case {
        _ if is_copied => [None; 3],
        Case::Pulse if suite.damping == DAMPING => two(PULSE[row]),
        Case::Pulse => {
            let column = DAMPINGS
                .iter()
                .position(|damping| *damping == suite.damping);
            [column.map(|k| PULSE_DAMPED[row][k]), None, None]
        }
        Case::Ramp => two(RAMP[row]),
        Case::Vortex => {
            let table = VISCOSITIES.iter().position(|nu| *nu == suite.viscosity);
            table.map_or([None; 3], |k| VORTEX[k][row].map(Some))
        }
    }
}
