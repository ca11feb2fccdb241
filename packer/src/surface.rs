//! Samples of the true surface, spread by area: what the packing is measured against.

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Shape, Vector};

/// Facets longer than this, in steps between samples, are halved until they are inside of the region or out of it.
const LONG: f64 = 32.0;

/// A sample farther than this part of the step from the surface lies inside of another part of the body.
const ON_SURFACE: f64 = 0.05;

/// Most halvings of one facet.
const HALVINGS: usize = 40;

/// Samples that are brought onto the surface together: enough for all threads, and few beside all of a fine body's.
const BATCH: usize = 1 << 14;

/// A place on the surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample<const D: usize> {
    /// On the surface.
    pub point: Vector<D>,
    /// Unit normal of the facet, out of the body.
    pub normal: Vector<D>,
    /// Area (length in the plane) that it stands for.
    pub area: f64,
}

/// Samples of the part of the surface of `shape` in `region`, about `step` apart, each for the same area. None where the
/// shape shows no facets.
pub(crate) fn samples<const D: usize>(
    shape: &dyn Shape<D>,
    region: &Bounds<D>,
    step: f64,
) -> Vec<Sample<D>> {
    let mut sequence = Sequence {
        shape,
        region,
        step,
        passed: 0.0,
        number: 0,
        guesses: Vec::new(),
        found: Vec::new(),
    };
    shape.for_each_facet(2.0 * step, region, &mut |facet| {
        sequence.sample(facet, HALVINGS);
    });
    sequence.find();
    sequence.found
}

/// Samples so far. A facet gets as many as fit its area; what is left over is passed on, so that slivers and dust get their
/// share together.
struct Sequence<'a, const D: usize> {
    shape: &'a dyn Shape<D>,
    region: &'a Bounds<D>,
    step: f64,
    passed: f64,
    number: u32,
    /// On the facets, not looked up yet.
    guesses: Vec<Sample<D>>,
    /// On the surface.
    found: Vec<Sample<D>>,
}

impl<const D: usize> Sequence<'_, D> {
    fn sample(&mut self, facet: [Vector<D>; D], halvings: usize) {
        let low = facet[1..].iter().fold(facet[0], |low, p| low.inf(p));
        let high = facet[1..].iter().fold(facet[0], |high, p| high.sup(p));
        let region = self.region;
        if Bounds::new(low, high).intersection(region).is_empty() {
            return;
        }
        let (edge, length) = longest(&facet);
        let is_long = length > LONG * self.step;
        if halvings > 0 && is_long && !(region.contains(&low) && region.contains(&high)) {
            let (a, b) = (edge, (edge + 1) % D);
            let middle = 0.5 * (facet[a] + facet[b]);
            let [mut first, mut second] = [facet, facet];
            first[b] = middle;
            second[a] = middle;
            self.sample(first, halvings - 1);
            self.sample(second, halvings - 1);
            return;
        }
        let Some((area, normal)) = oriented(&facet) else {
            return;
        };
        let share = self.step.powi(D as i32 - 1);
        self.passed += area;
        while self.passed >= 0.5 * share {
            self.passed -= share;
            self.number = self.number.wrapping_add(1);
            self.guesses.push(Sample {
                point: place(&facet, self.number),
                normal,
                area: share,
            });
            if self.guesses.len() >= BATCH {
                self.find();
            }
        }
    }

    /// Brings the guesses onto the surface.
    fn find(&mut self) {
        let guesses = self.guesses.par_iter();
        let found: Vec<Sample<D>> = guesses
            .filter_map(|sample| {
                // Inside of an arc the chord is a little off the surface.
                let seen = self.shape.closest(&sample.point);
                let is_on_it = seen.distance.abs() <= ON_SURFACE * self.step;
                (is_on_it && self.region.contains(&seen.point)).then_some(Sample {
                    point: seen.point,
                    ..*sample
                })
            })
            .collect();
        self.found.extend(found);
        self.guesses.clear();
    }
}

/// The longest edge of a facet, by its first corner, and its length.
fn longest<const D: usize>(facet: &[Vector<D>; D]) -> (usize, f64) {
    let length = |k: usize| (facet[(k + 1) % D] - facet[k]).norm();
    (0..D).map(|k| (k, length(k))).fold(
        (0, 0.0),
        |best, edge| if edge.1 > best.1 { edge } else { best },
    )
}

/// Area and unit normal; none of a facet without area.
fn oriented<const D: usize>(facet: &[Vector<D>; D]) -> Option<(f64, Vector<D>)> {
    let u = facet[1] - facet[0];
    let mut across = Vector::<D>::zeros();
    if D == 2 {
        (across[0], across[1]) = (u[1], -u[0]);
    } else {
        let v = facet[2] - facet[0];
        for k in 0..3 {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            across[k] = 0.5 * (u[a] * v[b] - u[b] * v[a]);
        }
    }
    let area = across.norm();
    let normal = across.try_normalize(0.0)?;
    area.is_finite().then_some((area, normal))
}

/// Place number `n` in a facet, of a sequence of low discrepancy: multiples of the plastic number's inverse powers, of the golden
/// ratio's on a line [Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"].
fn place<const D: usize>(facet: &[Vector<D>; D], n: u32) -> Vector<D> {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    const PLASTIC: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];
    let n = f64::from(n);
    if D == 2 {
        return facet[0] + (n * GOLDEN).fract() * (facet[1] - facet[0]);
    }
    let (mut u, mut v) = ((n * PLASTIC[0]).fract(), (n * PLASTIC[1]).fract());
    if u + v > 1.0 {
        (u, v) = (1.0 - u, 1.0 - v);
    }
    facet[0] + u * (facet[1] - facet[0]) + v * (facet[2] - facet[0])
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn samples_lie_on_the_surface_and_add_up_to_its_area() {
        let ball = bodies::sphere(1.0).expect("a sphere");
        let region = Bounds::new(Vector::repeat(-2.0), Vector::repeat(2.0));
        let found = samples(&ball, &region, 0.05);
        let area: f64 = found.iter().map(|sample| sample.area).sum();
        assert!((area / (4.0 * std::f64::consts::PI) - 1.0).abs() < 1e-2);
        assert!(found.iter().all(|s| (s.point.norm() - 1.0).abs() < 1e-12));
        assert!(found.iter().all(|s| s.normal.dot(&s.point) > 0.99));
    }

    #[test]
    fn half_a_region_has_half_of_the_samples_and_no_hole() {
        let block = bodies::cuboid([2.0, 2.0, 2.0]).expect("a cuboid");
        let region = Bounds::new(
            Vector::<3>::new(0.0, -2.0, -2.0),
            Vector::<3>::new(2.0, 2.0, 2.0),
        );
        let found = samples(&block, &region, 0.1);
        let area: f64 = found.iter().map(|sample| sample.area).sum();
        assert!((area / 12.0 - 1.0).abs() < 1e-2, "{area}");
        let hole = |p: Vector<3>| {
            let gaps = found.iter().map(|s| (s.point - p).norm());
            gaps.fold(f64::INFINITY, f64::min)
        };
        let worst = (0..400)
            .map(|n| {
                hole(Vector::<3>::new(
                    1.0,
                    f64::from(n % 20) / 10.0 - 0.95,
                    f64::from(n / 20) / 10.0 - 0.95,
                ))
            })
            .fold(0.0, f64::max);
        assert!(worst < 0.15, "{worst}");
    }
}
