//! Made-up particles for the tests of this folder.

/// A smeared straight shock off a ramp at the origin, on disordered particles.
pub(super) struct Wedge {
    /// Angle of the shock, radians.
    pub(super) beta: f64,
    /// Angle of the ramp, radians.
    pub(super) ramp: f64,
    /// Density behind, 1 ahead.
    pub(super) ratio: f64,
    /// Particle spacing ahead.
    pub(super) spacing: f64,
    /// Relative scatter of the density.
    pub(super) noise: f64,
}

/// A small generator of uniform numbers in [-1, 1): the same scatter on every machine.
pub(super) struct Scatter(u64);

impl Scatter {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(2).wrapping_add(0x9E37_79B9_7F4A_7C15))
    }

    pub(super) fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Positions and densities for `-1 < x < 3`, above the wall and below `y = 3`. Behind the shock the
/// particles stand closer, as their density asks; the shock is about three spacings thick.
pub(super) fn wedge(flow: &Wedge) -> (Vec<[f64; 3]>, Vec<f64>) {
    let mut scatter = Scatter::new(7);
    let (sin, cos) = flow.beta.sin_cos();
    let behind = |x: f64, y: f64| x * sin - y * cos;
    let wall = |x: f64| (x * flow.ramp.tan()).max(0.0);
    let (mut positions, mut density) = (Vec::new(), Vec::new());
    for (spacing, dense) in [
        (flow.spacing, false),
        (flow.spacing / flow.ratio.sqrt(), true),
    ] {
        let (columns, rows) = ((4.0 / spacing) as usize, (3.0 / spacing) as usize);
        for i in 0..columns {
            for j in 0..rows {
                let x = -1.0 + (i as f64 + 0.5 + 0.3 * scatter.next()) * spacing;
                let y = (j as f64 + 0.5 + 0.3 * scatter.next()) * spacing;
                let depth = behind(x, y);
                if y > wall(x) && (depth > 0.0) == dense {
                    let share = 0.5 * (1.0 + (depth / (0.8 * flow.spacing)).tanh());
                    let rho = 1.0 + (flow.ratio - 1.0) * share;
                    positions.push([x, y, 0.0]);
                    density.push(rho * (1.0 + flow.noise * scatter.next()));
                }
            }
        }
    }
    (positions, density)
}
