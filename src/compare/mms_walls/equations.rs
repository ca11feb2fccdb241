//! The equations of weakly compressible gas about particles that stay.

/// Speed of sound, m/s [Negi & Ramachandran 2022, section II].
pub const SOUND: f64 = 20.0;
/// Density where the pressure is zero, kg/m^3.
const DENSITY: f64 = 1.0;
/// Viscosity, m^2/s, of which the paper says nothing.
const VISCOSITY: f64 = 0.01;

/// `rho = rho_0 + p / c^2`, kg/m^3 [eq 2].
fn density(pressure: f64) -> f64 {
    DENSITY + pressure / (SOUND * SOUND)
}

/// `rho c^2`, Pa.
pub fn stiffness(pressure: f64) -> f64 {
    density(pressure) * SOUND * SOUND
}

/// `-rho c^2 div u - u.grad p` and `-grad p/rho - u.grad u + nu lap u` of a state, its gradients and the Laplacian of its velocity [eq 1].
pub fn terms(state: &[f64; 3], gradient: &[[f64; 2]; 3], bend: [f64; 2]) -> [f64; 3] {
    let [p, u, v] = *state;
    let carried = |k: usize| u * gradient[k][0] + v * gradient[k][1];
    let divergence = gradient[1][0] + gradient[2][1];
    let volume = 1.0 / density(p);
    [
        -stiffness(p) * divergence - carried(0),
        -gradient[0][0] * volume - carried(1) + VISCOSITY * bend[0],
        -gradient[0][1] * volume - carried(2) + VISCOSITY * bend[1],
    ]
}
