//! The flow in a plane, interpolated between points.

use aero_geometry::kernel::SMOOTHING_RATIO;
use aero_geometry::{Shape, Vector};
use aero_validation::pictures::{schlieren, viridis};

use super::canvas::Picture;
use super::read::Points;
use crate::sample::{self, Cloud, Raster, Sample, Solids, View};

/// Parts of all values between which colours range.
const NEARLY_ALL: [f64; 2] = [0.002, 0.998];

/// What is steeper is as dark as can be.
const STEEPEST: [f64; 2] = [0.0, 0.99];

/// Spacings to a mirror within which points count beyond it.
const NEAR: f64 = 4.0;

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

/// Values at the pixels of a plane, and the sizes of slopes.
#[derive(Clone, Debug)]
pub struct Field {
    /// Values of one array.
    pub values: Raster,
    /// Sizes of the gradients of another one.
    pub slopes: Raster,
}

impl Plane {
    fn view(&self) -> View {
        let [wide, high] = self.window.map(|[a, b]| b - a);
        let rows = (self.columns as f64 * high / wide).round().max(2.0);
        let unit = |axis: usize| std::array::from_fn(|k| f64::from(u8::from(k == axis)));
        let mut origin = [0.0; 3];
        origin[3 - self.axes[0] - self.axes[1]] = self.at;
        View {
            origin,
            axes: self.axes.map(unit),
            window: self.window,
            size: [self.columns, rows as usize],
        }
    }

    /// The values of one array of `gas` in this plane and the slopes of another one, with what lies in `shape` masked.
    pub fn field(
        &self,
        gas: &Points,
        arrays: [&str; 2],
        is_plane: bool,
        shape: Option<&dyn Shape<3>>,
    ) -> Field {
        if is_plane {
            self.field_of::<2>(gas, arrays, shape)
        } else {
            self.field_of::<3>(gas, arrays, shape)
        }
    }

    fn field_of<const D: usize>(
        &self,
        gas: &Points,
        arrays: [&str; 2],
        shape: Option<&dyn Shape<3>>,
    ) -> Field {
        let column = |name: &str| gas.arrays.get(name).map_or(&[][..], Vec::as_slice);
        let mut spacing: Vec<f64> = match column("spacing") {
            [] => {
                let lengths = column("smoothing_length").iter();
                lengths.map(|h| h / SMOOTHING_RATIO).collect()
            }
            spacing => spacing.to_vec(),
        };
        let vector = |place: &[f64; 3]| Vector::<D>::from_fn(|k, _| place[k]);
        let mut positions: Vec<Vector<D>> = gas.position.iter().map(vector).collect();
        let [shown, sloped] = arrays.map(column);
        let pairs = shown.iter().zip(sloped);
        let mut values: Vec<[f64; 2]> = pairs.map(|(&a, &b)| [a, b]).collect();
        for axis in (0..D).filter(|&axis| self.mirrored[axis]) {
            let count = positions.len().min(values.len()).min(spacing.len());
            for n in 0..count {
                if positions[n][axis] < NEAR * spacing[n] {
                    let mut image = positions[n];
                    image[axis] = -image[axis];
                    positions.push(image);
                    spacing.push(spacing[n]);
                    values.push(values[n]);
                }
            }
        }
        let solids = shape.map_or_else(Solids::none, Solids::section);
        let cloud = Cloud::new(&solids, &positions, &spacing, &values);
        let at = |mut place: [f64; 3]| {
            for (x, is_mirrored) in place.iter_mut().zip(self.mirrored) {
                *x = if is_mirrored { x.abs() } else { *x };
            }
            let near = cloud.at(&vector(&place));
            let found = near
                .found
                .map(|found| [found.values[0], found.slopes[1].norm()]);
            Sample {
                values: found.unwrap_or([f64::NAN; 2]),
                is_gas: !near.is_solid,
                clear: near.clear,
            }
        };
        let [values, slopes] = self.view().rasters(at);
        Field { values, slopes }
    }
}

impl Field {
    /// The values' ends, less what is rare.
    pub fn range(&self) -> [f64; 2] {
        self.values.range(NEARLY_ALL)
    }

    /// Coloured over `range`.
    pub fn coloured(&self, range: [f64; 2]) -> Picture {
        Picture {
            size: self.values.size,
            pixels: self.values.colours(viridis, range),
        }
    }

    /// The size of the gradient as schlieren show it: darker where it is larger.
    pub fn schlieren(&self) -> Picture {
        let most = self.slopes.range(STEEPEST)[1];
        Picture {
            size: self.slopes.size,
            pixels: self.slopes.colours(schlieren, [0.0, most]),
        }
    }
}

/// Range of nearly all of the values that are numbers.
pub fn range(values: &[f64]) -> [f64; 2] {
    let mut all: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sample::range(&mut all, NEARLY_ALL)
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
        let field = plane.field(&gas, ["mach", "mach"], true, None);
        assert_eq!(field.values.size, [50, 100]);
        // Rows 25 and 74 lie at y = 0.49 and -0.49.
        for row in [25, 74] {
            let value = field.values.values[row * 50 + 25];
            assert!((value - 1.49).abs() < 1e-12, "{value}");
        }
    }
}
