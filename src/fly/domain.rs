//! The box of a flight: as small as lets no wave from its sides come back to the body.

use aero_geometry::{Bounds, Vector};

/// Least Mach number: below it the waves of a body go too far ahead and aside.
pub const LEAST_MACH: f64 = 1.15;

/// A shock off the body goes out at the Mach angle times this, as tangents; it weakens on its way.
const STEEPER: f64 = 1.6;

/// Room beyond what the waves need.
const ROOM: f64 = 1.15;

/// Stand-off over radius of spheres, `a exp(b / M^2)` [Billig 1967].
const ROUND: [f64; 2] = [0.143, 3.24];

/// The detached shock wants so much more room than that.
const AHEAD: f64 = 1.6;

/// Length of wake behind the body, in its smaller half width.
const WAKE: f64 = 3.0;

/// The box around a body that spans `body`, nose at x = 0, in a stream along x turned by so many degrees.
pub fn around(body: &Bounds<3>, mach: f64, angles: [f64; 2]) -> Bounds<3> {
    let size = body.size();
    let wave = 1.0 / (mach * mach - 1.0).sqrt();
    let half = [1, 2].map(|k| body.max[k].abs().max(body.min[k].abs()));
    let [thin, wide] = [half[0].min(half[1]), half[0].max(half[1])];
    let stand_off = ROUND[0] * (ROUND[1] / (mach * mach)).exp() * thin.max(0.3 * wide);
    let ahead = (AHEAD * stand_off).max(0.08 * size[0]);
    // Out at the shock's angle and back at the Mach angle, not before the end of the body.
    let shock = STEEPER * wave;
    let aside = ROOM * (size[0] + ahead) * shock * wave / (shock + wave);
    let aside = aside.max(2.0 * stand_off).max(0.3 * wide);
    let mut bounds = *body;
    bounds.min[0] -= ahead;
    bounds.max[0] += (WAKE * thin).max(0.1 * size[0]);
    for (k, angle) in angles.iter().enumerate() {
        let tilt = size[0] * angle.to_radians().tan().abs();
        bounds.min[k + 1] -= aside + tilt;
        bounds.max[k + 1] += aside + tilt;
    }
    bounds
}

/// The box with each width a whole number of spacings; what lies on a plane of symmetry stays there.
pub fn whole<const D: usize>(bounds: &Bounds<D>, spacing: f64) -> Bounds<D> {
    let mut whole = *bounds;
    for k in 0..D {
        let count = (bounds.size()[k] / spacing - 1e-6).ceil().max(4.0);
        if bounds.min[k] == 0.0 && k > 0 {
            whole.max[k] = count * spacing;
        } else {
            let more = count * spacing - bounds.size()[k];
            whole.min[k] -= 0.5 * more;
            whole.max[k] = whole.min[k] + count * spacing;
        }
    }
    whole
}

/// The part of a box on the upper side of its planes of symmetry, `(axis, position)`.
pub fn part(bounds: &Bounds<3>, mirrors: &[usize]) -> Bounds<3> {
    let mut part = *bounds;
    for &axis in mirrors {
        part.min[axis] = 0.0;
    }
    part
}

/// The box of a plane through the axis.
pub fn plane(bounds: &Bounds<3>) -> Bounds<2> {
    Bounds::new(
        Vector::<2>::new(bounds.min[0], 0.0),
        Vector::<2>::new(bounds.max[0], bounds.max[1]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faster_streams_need_narrower_boxes_and_turned_ones_wider() {
        let body = Bounds::new(
            Vector::<3>::new(0.0, -0.1, -0.1),
            Vector::<3>::new(1.0, 0.1, 0.1),
        );
        let width = |mach: f64, angle: f64| around(&body, mach, [angle, 0.0]).max[1];
        assert!(width(4.0, 0.0) < width(2.0, 0.0));
        assert!(width(2.0, 5.0) > width(2.0, 0.0));
        // A wave that leaves the nose at the Mach angle and comes back meets no body.
        let mach_angle = (1.0_f64 / 2.0).asin();
        let back = 2.0 * (width(2.0, 0.0) - 0.1) / mach_angle.tan();
        assert!(back > 1.0, "{back}");
    }

    #[test]
    fn boxes_are_whole_numbers_of_spacings_and_stay_on_their_planes() {
        let bounds = Bounds::new(Vector::<2>::new(-0.31, 0.0), Vector::<2>::new(1.0, 0.77));
        let whole = whole(&bounds, 0.1);
        assert_eq!(whole.min[1], 0.0);
        for k in 0..2 {
            let count = whole.size()[k] / 0.1;
            assert!((count - count.round()).abs() < 1e-9);
            assert!(whole.min[k] <= bounds.min[k] + 1e-12 && whole.max[k] >= bounds.max[k]);
        }
    }
}
