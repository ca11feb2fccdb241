//! What a run is measured by, for the field data of its files.

/// The undisturbed stream and the gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Pressure of the free stream.
    pub pressure: f64,
    /// Density of the free stream.
    pub density: f64,
    /// Velocity of the free stream.
    pub velocity: [f64; 3],
    /// Ratio of specific heats.
    pub gamma: f64,
    /// Specific gas constant, where the scene states or implies it.
    pub gas_constant: Option<f64>,
    /// Spacing of particles or of the lattice.
    pub spacing: f64,
}

impl Reference {
    /// By name, with the time of a frame.
    pub(super) fn fields(&self, time: f64) -> Vec<(&'static str, Vec<f64>)> {
        let mut fields = vec![
            // What ParaView takes for the time.
            ("TimeValue", vec![time]),
            ("free_stream_pressure", vec![self.pressure]),
            ("free_stream_density", vec![self.density]),
            ("free_stream_velocity", self.velocity.to_vec()),
            ("gamma", vec![self.gamma]),
            ("spacing", vec![self.spacing]),
        ];
        fields.extend(
            self.gas_constant
                .map(|constant| ("gas_constant", vec![constant])),
        );
        fields
    }

    /// Temperatures, `p / (rho R)`, in K, where there is a gas constant.
    pub(super) fn temperatures(&self, pressure: &[f64], density: &[f64]) -> Option<Vec<f64>> {
        let constant = self.gas_constant?;
        let pairs = pressure.iter().zip(density);
        Some(pairs.map(|(p, rho)| number(p / (rho * constant))).collect())
    }

    /// Entropies over that of the free stream, in heat capacities at constant volume: `ln((p / p_inf) (rho_inf / rho)^gamma)`.
    pub(super) fn entropies(&self, pressure: &[f64], density: &[f64]) -> Vec<f64> {
        let pairs = pressure.iter().zip(density);
        let rise =
            |p: &f64, rho: &f64| (p / self.pressure).ln() - self.gamma * (rho / self.density).ln();
        pairs.map(|(p, rho)| number(rise(p, rho))).collect()
    }
}

/// `value`, zero where a vacuum leaves none.
fn number(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}
