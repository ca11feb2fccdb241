//! The box of a flight: as small as lets no wave from its sides come back to the body.

use aero_geometry::{Bounds, Vector};

/// Below this Mach number waves of a body go so far ahead and aside that its box is one of a stream slower than sound.
const SLOW: f64 = 1.15;

/// How far the sides of such a box are from the body, in its longest edge, where the stream could not be compressed.
const FAR: f64 = 4.0;

/// What is felt aside is felt farther by `1 / sqrt(|1 - M^2|)` (Prandtl & Glauert), which is no more than the inverse of this: near the speed of sound
/// it is not linear.
const LEAST_STRETCH: f64 = 0.5;

/// A shock off the body goes out at the Mach angle times this, as tangents; it weakens on its way.
const STEEPER: f64 = 1.6;

/// Room beyond what the waves need.
const ROOM: f64 = 1.15;

/// How far ahead of a front a detached shock stands, over its radius, `a exp(b / M^2)`.
struct StandOff(f64, f64);

/// Of spheres [Billig 1967, J. Spacecraft Rockets 4, 822].
const ROUND: StandOff = StandOff(0.143, 3.24);

/// Of cylinders in a stream across their axis [the same].
const ACROSS: StandOff = StandOff(0.386, 4.67);

/// Of flat faces, round ones, from Mach 1.5 on: by flows computed about points that stay in boxes five times as long, 2.15, 1.27, 0.88, 0.65 and 0.53 at
/// Mach 1.2, 1.5, 2, 3 and 6; of hollow ones 0.01 to 0.06 more.
const FLAT: StandOff = StandOff(0.495, 2.29);

/// Bluntness of what is round, and of what is flat.
const BLUNT: [f64; 2] = [0.5, 1.0];

/// The detached shock wants so much more room than that, ahead of what is round and of what is flat.
const AHEAD: [f64; 2] = [1.6, 1.35];

/// Length of wake behind the body, in its smaller half width.
const WAKE: f64 = 3.0;

impl StandOff {
    fn at(&self, mach: f64) -> f64 {
        self.0 * (self.1 / (mach * mach)).exp()
    }
}

/// Between what holds of round fronts and of flat ones.
fn between([round, flat]: [f64; 2], bluntness: f64) -> f64 {
    let part = (bluntness - BLUNT[0]) / (BLUNT[1] - BLUNT[0]);
    round + part.clamp(0.0, 1.0) * (flat - round)
}

/// Room that a detached shock wants ahead of a body as blunt as that, half as high as `thin` and as `wide`.
fn room_ahead(bluntness: f64, mach: f64, [thin, wide]: [f64; 2]) -> f64 {
    let round = ROUND.at(mach);
    // From the sphere to the cylinder, and of wide and thin ones what their tips are ahead of each other.
    let across = thin * (round + (1.0 - thin / wide) * (ACROSS.at(mach) - round).max(0.0));
    let own = across.max(0.3 * wide * round);
    let more = (AHEAD[1] * FLAT.at(mach) / round).max(AHEAD[0]);
    own * between([AHEAD[0], more], bluntness)
}

/// True of streams in which what a body does is felt on all sides of it.
pub fn is_slow(mach: f64) -> bool {
    mach < SLOW
}

/// The box around a body in a stream in which it is felt on all sides.
fn far_around(body: &Bounds<3>, mach: f64) -> Bounds<3> {
    let stretch = (1.0 - mach * mach).abs().sqrt().max(LEAST_STRETCH);
    let away = Vector::<3>::repeat(FAR * body.size().max() / stretch);
    Bounds::new(body.min - away, body.max + away)
}

/// The box around a body that spans `body`, nose at x = 0, with a front so blunt, in a stream along x turned by so many
/// degrees.
pub fn around(body: &Bounds<3>, bluntness: f64, mach: f64, angles: [f64; 2]) -> Bounds<3> {
    if is_slow(mach) {
        return far_around(body, mach);
    }
    let size = body.size();
    let wave = 1.0 / (mach * mach - 1.0).sqrt();
    let half = [1, 2].map(|k| body.max[k].abs().max(body.min[k].abs()));
    let [thin, wide] = [half[0].min(half[1]), half[0].max(half[1])];
    let detached = room_ahead(bluntness, mach, [thin, wide]);
    let ahead = detached.max(0.08 * size[0]);
    // Out at the shock's angle and back at the Mach angle, not before the end of the body.
    let shock = STEEPER * wave;
    let aside = ROOM * (size[0] + ahead) * shock * wave / (shock + wave);
    let aside = aside.max(1.25 * detached).max(0.3 * wide);
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

/// Moves a side of a box away from the `body` in it, by half of how far it is.
pub fn move_away(bounds: &mut Bounds<3>, body: &Bounds<3>, (axis, end): (usize, usize)) {
    const MORE: f64 = 0.5;
    if end == 0 {
        bounds.min[axis] -= MORE * (body.min[axis] - bounds.min[axis]);
    } else {
        bounds.max[axis] += MORE * (bounds.max[axis] - body.max[axis]);
    }
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
        let width = |mach: f64, angle: f64| around(&body, 0.1, mach, [angle, 0.0]).max[1];
        assert!(width(4.0, 0.0) < width(2.0, 0.0));
        assert!(width(2.0, 5.0) > width(2.0, 0.0));
        // A wave that leaves the nose at the Mach angle and comes back meets no body.
        let mach_angle = (1.0_f64 / 2.0).asin();
        let back = 2.0 * (width(2.0, 0.0) - 0.1) / mach_angle.tan();
        assert!(back > 1.0, "{back}");
    }

    /// Places of shocks ahead of a round face and of a shield of 2.4 radii, computed in boxes five times as long.
    #[test]
    fn flat_fronts_have_room_for_their_shocks() {
        let body = Bounds::new(
            Vector::<3>::new(0.0, -1.0, -1.0),
            Vector::<3>::new(2.0, 1.0, 1.0),
        );
        let shield = 1.0 - 0.5 / (2.4 * 2.4);
        for (bluntness, shocks) in [
            (1.0, [2.15, 1.27, 0.88, 0.65, 0.53]),
            (shield, [1.87, 1.03, 0.65, 0.45, 0.33]),
        ] {
            for (mach, shock) in [1.2, 1.5, 2.0, 3.0, 6.0].into_iter().zip(shocks) {
                let room = -around(&body, bluntness, mach, [0.0; 2]).min[0];
                assert!(room > 1.25 * shock, "{room} for {shock} at Mach {mach}");
            }
        }
        // Round ones have what they had.
        let room = -around(&body, 0.5, 2.0, [0.0; 2]).min[0];
        assert!((room - 1.6 * 0.143 * 0.81_f64.exp()).abs() < 1e-12);
    }

    #[test]
    fn sides_that_are_too_near_move_away() {
        let body = Bounds::new(Vector::<3>::repeat(0.0), Vector::<3>::repeat(1.0));
        let mut bounds = Bounds::new(Vector::<3>::repeat(-1.0), Vector::<3>::repeat(3.0));
        move_away(&mut bounds, &body, (0, 0));
        move_away(&mut bounds, &body, (2, 1));
        assert_eq!(bounds.min, Vector::<3>::new(-1.5, -1.0, -1.0));
        assert_eq!(bounds.max, Vector::<3>::new(3.0, 3.0, 4.0));
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
