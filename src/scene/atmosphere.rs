//! The US Standard Atmosphere [U.S. Standard Atmosphere, 1976, NOAA-S/T 76-1562, part 1, eqs 18, 23, 33 and table 4].

/// Gas constant of the air of the standard, J/(kg K): 8 314.32 / 28.964 4.
pub(crate) const GAS_CONSTANT: f64 = 8_314.32 / 28.964_4;

/// Standard gravity, m/s^2.
const GRAVITY: f64 = 9.806_65;

/// Radius of the Earth at which gravity is that, m.
const EARTH: f64 = 6_356_766.0;

/// Highest altitude of the tables, m.
pub(super) const HIGHEST: f64 = 86_000.0;

/// Lowest altitude of the tables, m.
pub(super) const LOWEST: f64 = -5_000.0;

/// Geopotential height in m of the foot of each layer, and how temperature changes with height in it, K/m.
const LAYERS: [(f64, f64); 7] = [
    (0.0, -0.006_5),
    (11_000.0, 0.0),
    (20_000.0, 0.001),
    (32_000.0, 0.002_8),
    (47_000.0, 0.0),
    (51_000.0, -0.002_8),
    (71_000.0, -0.002),
];

/// Air at rest at an altitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Air {
    /// Pressure, Pa.
    pub pressure: f64,
    /// Temperature on the molecular scale, K: that of the air up to 80 km, 0.04 % above it at 86 km.
    pub temperature: f64,
}

impl Air {
    /// At `altitude` m above the sea, between [`LOWEST`] and [`HIGHEST`].
    pub(crate) fn at(altitude: f64) -> Self {
        let height = EARTH * altitude / (EARTH + altitude);
        let mut air = Self {
            pressure: 101_325.0,
            temperature: 288.15,
        };
        for (number, &(foot, slope)) in LAYERS.iter().enumerate() {
            let top = LAYERS.get(number + 1).map_or(f64::INFINITY, |next| next.0);
            air = air.above(height.min(top) - foot, slope);
            if height <= top {
                break;
            }
        }
        air
    }

    /// `rise` m higher in a layer where the temperature changes by `slope`.
    fn above(self, rise: f64, slope: f64) -> Self {
        let temperature = self.temperature + slope * rise;
        let weight = GRAVITY / GAS_CONSTANT;
        let factor = if slope == 0.0 {
            (-weight * rise / self.temperature).exp()
        } else {
            (self.temperature / temperature).powf(weight / slope)
        };
        Self {
            pressure: self.pressure * factor,
            temperature,
        }
    }

    /// Density, kg/m^3.
    pub(super) fn density(self) -> f64 {
        self.pressure / (GAS_CONSTANT * self.temperature)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Table I of the standard, metric: altitude, temperature, pressure, density.
    #[test]
    fn the_air_is_that_of_the_tables() {
        for (altitude, temperature, pressure, density) in [
            (-1_000.0, 294.651, 113_929.0, 1.3470),
            (0.0, 288.150, 101_325.0, 1.2250),
            (5_000.0, 255.676, 54_048.0, 0.736_43),
            (11_000.0, 216.774, 22_700.0, 0.364_80),
            (12_000.0, 216.650, 19_399.0, 0.311_94),
            (20_000.0, 216.650, 5_529.3, 0.088_910),
            (30_000.0, 226.509, 1_197.0, 0.018_410),
            (40_000.0, 250.350, 287.14, 0.003_995_7),
            (50_000.0, 270.650, 79.779, 0.001_026_9),
            (60_000.0, 247.021, 21.958, 3.096_8e-4),
            (70_000.0, 219.585, 5.220_9, 8.282_9e-5),
            (80_000.0, 198.639, 1.052_4, 1.845_8e-5),
        ] {
            let air = Air::at(altitude);
            assert_relative_eq!(air.temperature, temperature, max_relative = 3e-5);
            assert_relative_eq!(air.pressure, pressure, max_relative = 1e-4);
            assert_relative_eq!(air.density(), density, max_relative = 1e-4);
        }
    }

    #[test]
    fn nothing_jumps_between_layers() {
        for (foot, _) in LAYERS.into_iter().skip(1) {
            let altitude = EARTH * foot / (EARTH - foot);
            let (below, above) = (Air::at(altitude - 1e-3), Air::at(altitude + 1e-3));
            assert_relative_eq!(below.pressure, above.pressure, max_relative = 1e-6);
            assert_relative_eq!(below.temperature, above.temperature, max_relative = 1e-6);
        }
    }
}
