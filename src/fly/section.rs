//! The flow in a plane, interpolated between points; bodies left white.

use aero_geometry::{Shape, Vector};
use aero_validation::pictures::viridis;
use rayon::prelude::*;

use super::canvas::{Colour, Picture};
use super::read::Points;

/// Width of the weight of a point, in spacings around it.
const WIDTH: f64 = 0.62;

/// Beyond so many of these it counts nothing.
const REACH: f64 = 2.6;

/// Spacings to a smoothing length, of particles.
const SMOOTHING: f64 = 1.5;

const WHITE: Colour = [255, 255, 255];
const BODY: Colour = [205, 208, 214];

/// A plane across an axis, and the part of it that is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Axes to the right and upwards.
    pub axes: [usize; 2],
    /// Coordinate along the third.
    pub at: f64,
    /// From and to along each of `axes`.
    pub window: [[f64; 2]; 2],
    /// Axes whose negative half is the image of the positive one.
    pub mirrored: [bool; 3],
    /// Columns of pixels.
    pub columns: usize,
}

/// Values at the pixels of a plane, row by row from the top; not a number where there is no gas.
#[derive(Clone, Debug)]
pub struct Field {
    /// Columns and rows.
    pub size: [usize; 2],
    /// Their values.
    pub values: Vec<f64>,
    /// Sizes of their gradients.
    pub slopes: Vec<f64>,
    /// True inside of bodies.
    pub masked: Vec<bool>,
}

impl Plane {
    fn size(&self) -> [usize; 2] {
        let [wide, high] = self.window.map(|[a, b]| b - a);
        let rows = (self.columns as f64 * high / wide).round().max(2.0);
        [self.columns, rows as usize]
    }

    fn pixel(&self) -> f64 {
        (self.window[0][1] - self.window[0][0]) / self.columns as f64
    }

    /// The place of a pixel's middle.
    fn place(&self, x: usize, y: usize) -> [f64; 3] {
        let mut place = [0.0; 3];
        let third = 3 - self.axes[0] - self.axes[1];
        place[third] = self.at;
        place[self.axes[0]] = self.window[0][0] + (x as f64 + 0.5) * self.pixel();
        place[self.axes[1]] = self.window[1][1] - (y as f64 + 0.5) * self.pixel();
        place
    }

    /// An array of `gas` in this plane, with what lies in `shape` masked.
    pub fn field(
        &self,
        gas: &Points,
        array: &str,
        is_plane: bool,
        shape: Option<&dyn Shape<3>>,
    ) -> Field {
        let size = self.size();
        let column = |name: &str| gas.arrays.get(name).map_or(&[][..], Vec::as_slice);
        let spacing: Vec<f64> = match column("spacing") {
            [] => column("smoothing_length")
                .iter()
                .map(|h| h / SMOOTHING)
                .collect(),
            spacing => spacing.to_vec(),
        };
        let values = column(array);
        let third = 3 - self.axes[0] - self.axes[1];
        let mut sums = vec![Fit::default(); size[0] * size[1]];
        if values.len() == gas.position.len() && spacing.len() == values.len() {
            for (n, position) in gas.position.iter().enumerate() {
                let off = if is_plane {
                    0.0
                } else {
                    position[third] - self.at
                };
                self.splat(&mut sums, size, *position, off, spacing[n], values[n]);
            }
        }
        let bounds = shape.map(Shape::bounds);
        let masked: Vec<bool> = (0..sums.len())
            .into_par_iter()
            .map(|n| {
                let place = Vector::<3>::from(self.place(n % size[0], n / size[0]));
                let is_near = bounds.is_some_and(|bounds| bounds.contains(&place));
                is_near && shape.is_some_and(|shape| shape.signed_distance(&place) < 0.0)
            })
            .collect();
        let found: Vec<[f64; 2]> = sums
            .iter()
            .zip(&masked)
            .map(|(fit, masked)| if *masked { [f64::NAN; 2] } else { fit.solved() })
            .collect();
        Field {
            values: found.iter().map(|[value, _]| *value).collect(),
            slopes: found.iter().map(|[_, slope]| *slope).collect(),
            size,
            masked,
        }
    }

    /// Adds a point, and its images, to the pixels around it.
    fn splat(
        &self,
        sums: &mut [Fit],
        size: [usize; 2],
        position: [f64; 3],
        off: f64,
        spacing: f64,
        value: f64,
    ) {
        let width = WIDTH * spacing;
        let reach = REACH * width;
        if off.abs() > reach {
            return;
        }
        let pixel = self.pixel();
        // At least the pixel that the point lies in.
        let reach = reach.max(0.75 * pixel);
        for image in 0..4 {
            let mut place = [position[self.axes[0]], position[self.axes[1]]];
            let turned = |k: usize| image >> k & 1 == 1;
            if (0..2).any(|k| turned(k) && !self.mirrored[self.axes[k]]) {
                continue;
            }
            for k in 0..2 {
                if turned(k) {
                    place[k] = -place[k];
                }
            }
            let x = (place[0] - self.window[0][0]) / pixel;
            let y = (self.window[1][1] - place[1]) / pixel;
            let span = reach / pixel;
            let range = |at: f64, most: usize| {
                let low = (at - span).floor().clamp(0.0, most as f64) as usize;
                let high = (at + span).ceil().clamp(0.0, most as f64) as usize;
                low..high
            };
            for row in range(y, size[1]) {
                for column in range(x, size[0]) {
                    let dx = (column as f64 + 0.5 - x) * pixel;
                    let dy = (row as f64 + 0.5 - y) * pixel;
                    let square = (dx * dx + dy * dy + off * off) / (width * width);
                    let weight = (-square).exp().max(1e-9);
                    let offset = [dx / width, dy / width];
                    sums[row * size[0] + column].add(weight, offset, value, width);
                }
            }
        }
    }
}

/// Sums of a plane fitted to the values around a pixel, weighted [Lancaster & Salkauskas 1981].
#[derive(Clone, Copy, Debug, Default)]
struct Fit {
    weight: f64,
    /// Of the offsets, in widths.
    first: [f64; 2],
    /// Of their products.
    second: [f64; 3],
    value: f64,
    /// Of values times offsets.
    mixed: [f64; 2],
    /// Of the widths.
    width: f64,
}

impl Fit {
    fn add(&mut self, weight: f64, [x, y]: [f64; 2], value: f64, width: f64) {
        self.weight += weight;
        self.width += weight * width;
        self.value += weight * value;
        for (k, offset) in [x, y].into_iter().enumerate() {
            self.first[k] += weight * offset;
            self.mixed[k] += weight * offset * value;
        }
        for (sum, product) in self.second.iter_mut().zip([x * x, x * y, y * y]) {
            *sum += weight * product;
        }
    }

    /// The value of the plane at the pixel, and the size of its slope; not numbers where there is no gas.
    fn solved(&self) -> [f64; 2] {
        /// Less spread than this, on one side or along a line, and the mean is taken.
        const SPREAD: f64 = 0.02;
        if self.weight <= 1e-12 {
            return [f64::NAN; 2];
        }
        let part = 1.0 / self.weight;
        let mean = self.value * part;
        let [x, y] = self.first.map(|sum| sum * part);
        let [xx, xy, yy] = self.second.map(|sum| sum * part);
        let (xx, xy, yy) = (xx - x * x, xy - x * y, yy - y * y);
        let [vx, vy] = self.mixed.map(|sum| sum * part);
        let (vx, vy) = (vx - mean * x, vy - mean * y);
        let double = xx * yy - xy * xy;
        if double < SPREAD * SPREAD {
            return [mean, 0.0];
        }
        let slope = [(yy * vx - xy * vy) / double, (xx * vy - xy * vx) / double];
        let width = self.width * part;
        [
            mean - slope[0] * x - slope[1] * y,
            slope[0].hypot(slope[1]) / width,
        ]
    }
}

impl Field {
    /// The values' ends, less what is rare.
    pub fn range(&self) -> [f64; 2] {
        range(&self.values)
    }

    /// Coloured over `range`.
    pub fn coloured(&self, [low, high]: [f64; 2]) -> Picture {
        let mut picture = Picture::new(self.size, WHITE);
        for (n, value) in self.values.iter().enumerate() {
            if self.masked[n] {
                picture.pixels[n] = BODY;
            } else if value.is_finite() {
                picture.pixels[n] = viridis((value - low) / (high - low).max(f64::MIN_POSITIVE));
            }
        }
        picture
    }

    /// The size of the gradient as schlieren show it: darker where it is larger.
    pub fn schlieren(&self) -> Picture {
        /// What the steepest hundredth is darkened by.
        const DARK: f64 = 2.2;
        let mut known: Vec<f64> = self
            .slopes
            .iter()
            .copied()
            .filter(|g| g.is_finite())
            .collect();
        known.sort_by(f64::total_cmp);
        let most = known.get(known.len() * 99 / 100).copied().unwrap_or(1.0);
        let mut picture = Picture::new(self.size, WHITE);
        for (n, gradient) in self.slopes.iter().enumerate() {
            if self.masked[n] {
                picture.pixels[n] = BODY;
            } else if gradient.is_finite() {
                let light = (-DARK * gradient / most.max(f64::MIN_POSITIVE)).exp();
                picture.pixels[n] = [(255.0 * light) as u8; 3];
            }
        }
        picture
    }
}

/// Range of nearly all of the values that are numbers.
pub fn range(values: &[f64]) -> [f64; 2] {
    let mut all: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    if all.is_empty() {
        return [0.0, 1.0];
    }
    all.sort_by(f64::total_cmp);
    let at = |part: f64| all[((all.len() - 1) as f64 * part) as usize];
    [at(0.002), at(0.998)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_field_is_shown_where_it_is_and_mirrored_where_that_is_said() {
        let mut gas = Points::default();
        let (mut mach, mut spacing) = (Vec::new(), Vec::new());
        for n in 0..400 {
            let place = |k: usize| (k as f64 + 0.5) * 0.05;
            let [x, y] = [place(n % 20), place(n / 20)];
            gas.position.push([x, y, 0.0]);
            mach.push(1.0 + y);
            spacing.push(0.05);
        }
        gas.arrays.insert("mach".into(), mach);
        gas.arrays.insert("spacing".into(), spacing);
        let plane = Plane {
            axes: [0, 1],
            at: 0.0,
            window: [[0.0, 1.0], [-1.0, 1.0]],
            mirrored: [false, true, false],
            columns: 50,
        };
        let field = plane.field(&gas, "mach", true, None);
        assert_eq!(field.size, [50, 100]);
        // Rows 25 and 74 lie at y = 0.49 and -0.49.
        for row in [25, 74] {
            let value = field.values[row * 50 + 25];
            assert!((value - 1.49).abs() < 1e-6, "{value}");
        }
    }
}
