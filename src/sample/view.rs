//! A plane of pixels through the gas.

use aero_geometry::parallel::prelude::*;
use aero_validation::pictures::Colour;

const WHITE: Colour = [255, 255, 255];
const BODY: Colour = [205, 208, 214];

/// Edge of the largest squares of pixels that are filled from their corners.
const SQUARE: usize = 8;

/// What is found at a place.
#[derive(Clone, Copy, Debug)]
pub struct Sample<const N: usize> {
    /// Values; not a number where there are none.
    pub values: [f64; N],
    /// The place lies outside of bodies.
    pub is_gas: bool,
    /// How far around the place values are as good as on a straight line, and no body is.
    pub clear: f64,
}

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
    /// The place of the middle of a pixel, by its column and its row from the top; there are such places beyond the edges too.
    fn place(&self, [column, row]: [usize; 2]) -> [f64; 3] {
        let part = |n: usize, of: usize| (n as f64 + 0.5) / of as f64;
        let [columns, rows] = self.size;
        let [[left, right], [low, high]] = self.window;
        let x = left + part(column, columns) * (right - left);
        let y = high - part(row, rows) * (high - low);
        let [across, up] = self.axes;
        std::array::from_fn(|k| self.origin[k] + x * across[k] + y * up[k])
    }

    /// Pixels of what `at` finds. Where it finds nothing but gas whose values are as good as on a straight line from pixel to pixel, it is
    /// asked at the corners of squares of them alone.
    pub fn rasters<const N: usize>(
        &self,
        at: impl Fn([f64; 3]) -> Sample<N> + Sync,
    ) -> [Raster; N] {
        let [columns, rows] = self.size;
        let bands = 0..rows.div_ceil(SQUARE);
        let bands: Vec<_> = bands.into_par_iter().map(|n| self.band(n, &at)).collect();
        let found = bands.concat();
        let is_solid: Vec<bool> = found.iter().map(|(_, is_gas)| !is_gas).collect();
        debug_assert_eq!(found.len(), columns * rows);
        std::array::from_fn(|n| Raster {
            size: self.size,
            values: found.iter().map(|(values, _)| values[n]).collect(),
            is_solid: is_solid.clone(),
        })
    }

    /// The pixels of a row of squares: values, and whether the place lies in the gas.
    fn band<const N: usize>(
        &self,
        number: usize,
        at: &impl Fn([f64; 3]) -> Sample<N>,
    ) -> Vec<([f64; N], bool)> {
        let [columns, rows] = self.size;
        let top = number * SQUARE;
        let mut pixels = vec![([f64::NAN; N], false); columns * SQUARE.min(rows - top)];
        // What has been found, at the edges of squares as well.
        let width = columns.next_multiple_of(SQUARE) + 1;
        let mut known = vec![None; width * (SQUARE + 1)];
        let mut find = |[column, row]: [usize; 2]| {
            *known[(row - top) * width + column]
                .get_or_insert_with(|| at(self.place([column, row])))
        };
        let mut put = |[column, row]: [usize; 2], pixel| {
            if column < columns && row < rows {
                pixels[(row - top) * columns + column] = pixel;
            }
        };
        for left in (0..columns).step_by(SQUARE) {
            self.square([left, top], SQUARE, &mut find, &mut put);
        }
        pixels
    }

    /// The pixels of one square with this corner and edge.
    fn square<const N: usize>(
        &self,
        [left, top]: [usize; 2],
        edge: usize,
        find: &mut impl FnMut([usize; 2]) -> Sample<N>,
        put: &mut impl FnMut([usize; 2], ([f64; N], bool)),
    ) {
        let [columns, rows] = self.size;
        if left >= columns || top >= rows {
            return;
        }
        if edge == 1 {
            let there = find([left, top]);
            put([left, top], (there.values, there.is_gas));
            return;
        }
        let size = |[from, to]: [f64; 2], count: usize| edge as f64 * (to - from) / count as f64;
        let diagonal = size(self.window[0], columns).hypot(size(self.window[1], rows));
        let is_straight = |corner: &Sample<N>| {
            let is_known = corner.values.iter().all(|value| value.is_finite());
            corner.is_gas && is_known && corner.clear >= diagonal
        };
        let mut corners = [[f64::NAN; N]; 4];
        let is_straight = corners.iter_mut().enumerate().all(|(n, values)| {
            let corner = find([left + edge * (n & 1), top + edge * (n >> 1)]);
            *values = corner.values;
            is_straight(&corner)
        });
        if !is_straight {
            let half = edge / 2;
            for n in 0..4 {
                self.square(
                    [left + half * (n & 1), top + half * (n >> 1)],
                    half,
                    find,
                    put,
                );
            }
            return;
        }
        let between = |from: f64, to: f64, part: f64| from + part * (to - from);
        for n in 0..edge * edge {
            let [x, y] = [n % edge, n / edge];
            let [across, down] = [x, y].map(|k| k as f64 / edge as f64);
            let value = |k: usize| {
                let [high, low] = [0, 2].map(|n| between(corners[n][k], corners[n + 1][k], across));
                between(high, low, down)
            };
            put([left + x, top + y], (std::array::from_fn(value), true));
        }
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

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    /// A window that is not filled by whole squares: 37 by 21 pixels, a tenth wide each.
    const VIEW: View = View {
        origin: [0.0; 3],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        window: [[0.0, 3.7], [0.0, 2.1]],
        size: [37, 21],
    };

    fn found(at: impl Fn([f64; 3]) -> Sample<1> + Sync) -> (Raster, usize) {
        let asked = AtomicUsize::new(0);
        let [raster] = VIEW.rasters(|place| {
            asked.fetch_add(1, Ordering::Relaxed);
            at(place)
        });
        (raster, asked.into_inner())
    }

    fn line([x, y, _]: [f64; 3]) -> f64 {
        1.0 + 2.0 * x - y
    }

    #[test]
    fn values_on_a_straight_line_are_met_from_the_corners_of_squares() {
        let (raster, asked) = found(|place| Sample {
            values: [line(place)],
            is_gas: true,
            clear: 2.0,
        });
        assert!(asked < 37 * 21 / 8, "{asked}");
        for (n, value) in raster.values.iter().enumerate() {
            let there = VIEW.place([n % 37, n / 37]);
            assert!((value - line(there)).abs() < 1e-12);
        }
    }

    /// A body a fifth of a pixel wider than one, that no square of pixels may hide, and a jump at it.
    #[test]
    fn beside_bodies_and_jumps_each_pixel_is_asked_for_itself() {
        let at = |place: [f64; 3]| {
            let away = (place[0] - 1.23).abs() - 0.06;
            Sample {
                values: [if place[0] > 1.23 { 5.0 } else { line(place) }],
                is_gas: away > 0.0,
                clear: away.max(0.0),
            }
        };
        let (raster, asked) = found(at);
        assert!(asked < 37 * 21);
        for n in 0..raster.values.len() {
            let there = at(VIEW.place([n % 37, n / 37]));
            assert!((raster.values[n] - there.values[0]).abs() < 1e-12);
            assert_eq!(raster.is_solid[n], !there.is_gas);
        }
    }
}
