//! A plane of pixels through the gas.

use aero_geometry::parallel::prelude::*;
use aero_validation::pictures::Colour;

const WHITE: Colour = [255, 255, 255];
const BODY: Colour = [205, 208, 214];

/// A window in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// A point of the plane, from which windows are counted.
    pub origin: [f64; 3],
    /// Unit vectors to the right and upwards.
    pub axes: [[f64; 3]; 2],
    /// From and to along each of them.
    pub window: [[f64; 2]; 2],
    /// Columns and rows of pixels.
    pub size: [usize; 2],
}

impl View {
    /// The place of the middle of a pixel, counted row by row from the top.
    pub fn place(&self, pixel: usize) -> [f64; 3] {
        let [columns, rows] = self.size;
        let part = |n: usize, of: usize| (n as f64 + 0.5) / of as f64;
        let [[left, right], [low, high]] = self.window;
        let x = left + part(pixel % columns, columns) * (right - left);
        let y = high - part(pixel / columns, rows) * (high - low);
        let [across, up] = self.axes;
        std::array::from_fn(|k| self.origin[k] + x * across[k] + y * up[k])
    }

    /// Pixels where `at` finds them: values, and whether the place lies in the gas.
    pub fn rasters<const N: usize>(
        &self,
        at: impl Fn([f64; 3]) -> ([f64; N], bool) + Sync,
    ) -> [Raster; N] {
        let pixels = 0..self.size[0] * self.size[1];
        let found: Vec<_> = pixels.into_par_iter().map(|n| at(self.place(n))).collect();
        let is_solid: Vec<bool> = found.iter().map(|(_, is_gas)| !is_gas).collect();
        std::array::from_fn(|n| Raster {
            size: self.size,
            values: found.iter().map(|(values, _)| values[n]).collect(),
            is_solid: is_solid.clone(),
        })
    }
}

/// Values at the pixels of a plane, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Their values; not a number where no gas is near.
    pub values: Vec<f64>,
    /// True in bodies.
    pub is_solid: Vec<bool>,
}

impl Raster {
    /// The values that so large parts of all in the gas lie below.
    pub fn range(&self, part: [f64; 2]) -> [f64; 2] {
        let pixels = self.values.iter().zip(&self.is_solid);
        let gas = pixels.filter(|(value, is_solid)| !**is_solid && value.is_finite());
        let mut all: Vec<f64> = gas.map(|(value, _)| *value).collect();
        range(&mut all, part)
    }

    /// Colours by the share of a range; bodies grey, white where there is no gas.
    pub fn colours(&self, colour: fn(f64) -> Colour, [low, high]: [f64; 2]) -> Vec<Colour> {
        let pixels = self.values.iter().zip(&self.is_solid);
        let coloured = pixels.map(|(value, is_solid)| {
            if *is_solid {
                BODY
            } else if value.is_finite() {
                colour((value - low) / (high - low).max(f64::MIN_POSITIVE))
            } else {
                WHITE
            }
        });
        coloured.collect()
    }
}

/// The values that so large parts of all lie below.
pub fn range(all: &mut [f64], parts: [f64; 2]) -> [f64; 2] {
    if all.is_empty() {
        return [0.0, 1.0];
    }
    all.sort_by(f64::total_cmp);
    parts.map(|part| all[((all.len() - 1) as f64 * part) as usize])
}
