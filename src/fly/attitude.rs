//! How a body of a file lies in the stream: which end meets it, which side is up.

use std::str::FromStr;

use aero_geometry::{Bounds, Placed, Placement, Shape, Vector};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::error::FlyError;
use crate::scene::way::Way;

/// Lines across a section, to measure it.
const ACROSS: usize = 32;

/// Where the sections of the two ends are looked at, in parts of the length.
const NEAR_END: f64 = 0.1;

/// An extent this much longer than both others, which are like each other, is the length.
const SLENDER: f64 = 1.5;

/// Extents that differ by less than this part are the same.
const ALIKE: f64 = 0.01;

/// A body whose two extents across its length differ by this much flies on its flat side, wings to the left and right.
const FLAT: f64 = 1.5;

/// A body is round where so much of it is still itself after an eighth of a turn.
const ROUND: f64 = 0.9;

/// Directions of the file that point out of the nose and up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    nose: Way,
    up: Option<Way>,
}

impl FromStr for Axes {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let way = |part: &str| {
            let way = part.parse::<Way>();
            way.map_err(|error| format!("{error}; write NOSE or NOSE,UP as in -x or -x,+z"))
        };
        let (nose, up) = match text.split_once(',') {
            Some((nose, up)) => (way(nose)?, Some(way(up)?)),
            None => (way(text)?, None),
        };
        if up.is_some_and(|up| up.axis == nose.axis) {
            return Err(format!(
                "`{text}`: nose and up lie along the same axis; write -x,+z say"
            ));
        }
        Ok(Self { nose, up })
    }
}

/// A body in place: nose tip at x = 0, the stream along +x, up along +y, its middle on the axis.
#[derive(Clone, Debug)]
pub struct Attitude {
    /// Direction of the file out of the nose.
    pub nose: Way,
    /// Direction of the file that is up.
    pub up: Way,
    /// True where nose and up were looked for, not told.
    pub is_guess: bool,
    /// Turn about the length after that, degrees.
    pub roll: f64,
    /// Axis and degrees of the turn as scenes have it; none where there is none.
    pub turn: Option<([f64; 3], f64)>,
    /// Shift after it.
    pub shift: Vector<3>,
}

impl Attitude {
    /// That of `shape` as told by `axes`, or as it looks; of one made whole from its `half`, which was cut from top to bottom, up is in the cut.
    ///
    /// # Errors
    /// A turn that is no number.
    pub fn new(
        shape: &dyn Shape<3>,
        axes: Option<Axes>,
        half: Option<Way>,
        roll: f64,
    ) -> Result<Self, FlyError> {
        let nose = axes.map_or_else(|| nose(shape), |axes| axes.nose);
        let told = axes.and_then(|axes| axes.up);
        let in_cut = half.filter(|half| half.axis != nose.axis).map(|half| Way {
            axis: 3 - nose.axis - half.axis,
            is_negative: false,
        });
        let up = told.or(in_cut).unwrap_or_else(|| up(shape, nose));
        let [x, y] = [-nose.vector(), up.vector()];
        let z = x.cross(&y);
        let rows = Matrix3::from_rows(&[x.transpose(), y.transpose(), z.transpose()]);
        let roll_turn = Rotation3::from_axis_angle(&Vector::<3>::x_axis(), roll.to_radians());
        let turn = roll_turn * Rotation3::from_matrix_unchecked(rows);
        let turn = UnitQuaternion::from_rotation_matrix(&turn).axis_angle();
        let turn = turn.map(|(axis, angle)| {
            // Half and quarter turns are what they are.
            let degrees = (angle.to_degrees() * 1e10).round() / 1e10;
            let axis = axis.map(|a| (a * 1e12).round() / 1e12);
            ([axis[0], axis[1], axis[2]], degrees)
        });
        let mut attitude = Self {
            nose,
            up,
            is_guess: told.is_none(),
            roll,
            turn,
            shift: Vector::zeros(),
        };
        let bounds = attitude.placed_bounds(shape)?;
        let middle = 0.5 * (bounds.min + bounds.max);
        attitude.shift = Vector::<3>::new(-bounds.min[0], -middle[1], -middle[2]);
        Ok(attitude)
    }

    /// Where it puts a body.
    ///
    /// # Errors
    /// A turn that is no number.
    pub fn placement(&self) -> Result<Placement<3>, FlyError> {
        let mut placement = Placement::default();
        if let Some((axis, degrees)) = self.turn {
            let axis = Vector::<3>::from(axis);
            placement = placement
                .rotated_about(&axis, degrees.to_radians())
                .map_err(|error| FlyError::Body(error.to_string()))?;
        }
        Ok(placement.moved(self.shift))
    }

    /// Box of the triangles of `shape` in place.
    fn placed_bounds(&self, shape: &dyn Shape<3>) -> Result<Bounds<3>, FlyError> {
        let placement = self.placement()?;
        let all = shape.facets(f64::INFINITY, &shape.bounds());
        if all.is_empty() {
            return Ok(Placed::new(shape, placement).bounds());
        }
        let mut bounds: Bounds<3> = Bounds::new(
            Vector::repeat(f64::INFINITY),
            Vector::repeat(f64::NEG_INFINITY),
        );
        for corner in all.iter().flatten() {
            let corner = placement.point(corner);
            bounds.min = bounds.min.inf(&corner);
            bounds.max = bounds.max.sup(&corner);
        }
        Ok(bounds)
    }

    /// The `place` of a scene's body.
    pub fn scene_place(&self) -> String {
        let [x, y, z] = [self.shift[0], self.shift[1], self.shift[2]];
        let translate = format!("translate = [{x:?}, {y:?}, {z:?}]");
        match self.turn {
            None => format!("{{ {translate} }}"),
            Some((axis, angle)) => {
                format!("{{ rotate = {{ axis = {axis:?}, angle = {angle:?} }}, {translate} }}")
            }
        }
    }

    /// How it lies, a line each.
    pub fn words(&self, size: &Vector<3>, incidence: f64, sideslip: f64) -> Vec<String> {
        let looked = if self.is_guess {
            ", as it looks; mend with --axis NOSE,UP"
        } else {
            ""
        };
        let mut lines = vec![
            format!(
                "the nose points along {} of the file, up is {}{looked}",
                self.nose, self.up
            ),
            format!(
                "{:.4} m long, {:.4} m high, {:.4} m wide",
                size[0], size[1], size[2]
            ),
        ];
        if self.roll != 0.0 {
            lines.push(format!("rolled by {} degrees about its length", self.roll));
        }
        let aside = |angle: f64, [plus, minus]: [&str; 2]| match angle {
            0.0 => String::new(),
            a if a > 0.0 => format!(", from {a} degrees {plus}"),
            a => format!(", from {} degrees {minus}", -a),
        };
        lines.push(format!(
            "the stream comes along the body from its nose{}{}",
            aside(incidence, ["below", "above"]),
            aside(sideslip, ["the side of -z", "the side of +z"])
        ));
        lines
    }
}

/// The direction out of the nose: the axis of what is as wide as high, an extent that is much the longest, else x; at the end with the smaller section.
fn nose(shape: &dyn Shape<3>) -> Way {
    let size = shape.bounds().size();
    let slender = |k: &usize| {
        let [a, b] = [(k + 1) % 3, (k + 2) % 3].map(|j| size[j]);
        size[*k] > SLENDER * a.max(b) && a.max(b) < SLENDER * a.min(b)
    };
    // A body of revolution is as wide as it is high, and so is a wing as wide as its fuselage is long.
    let round = |k: &usize| {
        let [a, b] = [(k + 1) % 3, (k + 2) % 3].map(|j| size[j]);
        let alike = (a - b).abs() < ALIKE * a && (size[*k] - a).abs() > ALIKE * a;
        alike && (size[*k] > a || stays(shape, *k) > ROUND)
    };
    let axis = (0..3).find(round).or_else(|| (0..3).find(slender));
    let axis = axis.unwrap_or(0);
    let [low, high] = [NEAR_END, 1.0 - NEAR_END].map(|part| section(shape, axis, part));
    Way {
        axis,
        // Of two like ends the lower one is the nose.
        is_negative: low <= high * 1.02,
    }
}

/// The direction up: the shorter extent across the length where a body is flat, else z, or y of one that flies along z.
fn up(shape: &dyn Shape<3>, nose: Way) -> Way {
    let size = shape.bounds().size();
    let usual = if nose.axis == 2 { 1 } else { 2 };
    let other = 3 - nose.axis - usual;
    let axis = if size[usual] > FLAT * size[other] {
        other
    } else {
        usual
    };
    Way {
        axis,
        is_negative: false,
    }
}

/// Part of the middle section across `axis` that is solid still after an eighth of a turn about the box's middle.
fn stays(shape: &dyn Shape<3>, axis: usize) -> f64 {
    let bounds = shape.bounds();
    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    let middle = 0.5 * (bounds.min + bounds.max);
    let half = 0.5 * bounds.size();
    let is_solid = |u: f64, v: f64| {
        let mut point = middle;
        point[a] += u;
        point[b] += v;
        shape.signed_distance(&point) < 0.0
    };
    let (mut solid, mut both) = (0, 0);
    for n in 0..ACROSS * ACROSS {
        let place = |n: usize| (2.0 * n as f64 + 1.0) / ACROSS as f64 - 1.0;
        let [u, v] = [half[a] * place(n % ACROSS), half[b] * place(n / ACROSS)];
        if is_solid(u, v) {
            solid += 1;
            let turn = std::f64::consts::FRAC_1_SQRT_2;
            both += i32::from(is_solid(turn * (u - v), turn * (u + v)));
        }
    }
    f64::from(both) / f64::from(solid.max(1))
}

/// Part of the box's section that is solid.
fn section(shape: &dyn Shape<3>, axis: usize, part: f64) -> f64 {
    let bounds = shape.bounds();
    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    let along = |k: usize, part: f64| bounds.min[k] + part * bounds.size()[k];
    let inside = (0..ACROSS * ACROSS).filter(|n| {
        let place = |n: usize| (n as f64 + 0.5) / ACROSS as f64;
        let mut point = Vector::<3>::zeros();
        point[axis] = along(axis, part);
        point[a] = along(a, place(n % ACROSS));
        point[b] = along(b, place(n / ACROSS));
        shape.signed_distance(&point) < 0.0
    });
    inside.count() as f64 / (ACROSS * ACROSS) as f64
}

#[cfg(test)]
mod tests {
    use aero_geometry::bodies;

    use super::*;

    #[test]
    fn axes_are_read_and_what_is_none_is_refused() {
        let axes: Axes = "-z,+y".parse().unwrap();
        assert_eq!(axes.nose.to_string(), "-z");
        assert_eq!(axes.up.unwrap().to_string(), "+y");
        for (text, words) in [("w", "not a direction"), ("x,-x", "same axis")] {
            assert!(text.parse::<Axes>().unwrap_err().contains(words));
        }
    }

    /// A fuselage and its wings.
    #[derive(Debug)]
    struct Aircraft(bodies::Cuboid, bodies::Cuboid);

    impl Shape<3> for Aircraft {
        fn bounds(&self) -> Bounds<3> {
            let (a, b) = (self.0.bounds(), self.1.bounds());
            Bounds::new(a.min.inf(&b.min), a.max.sup(&b.max))
        }

        fn closest(&self, point: &Vector<3>) -> aero_geometry::Closest<3> {
            let (a, b) = (self.0.closest(point), self.1.closest(point));
            if a.distance <= b.distance { a } else { b }
        }
    }

    #[test]
    fn an_aircraft_as_wide_as_long_flies_along_its_length_on_its_flat_side() {
        let body = Aircraft(
            bodies::cuboid([1.0, 0.1, 0.1]).unwrap(),
            bodies::cuboid([0.3, 1.0, 0.02]).unwrap(),
        );
        let attitude = Attitude::new(&body, None, None, 0.0).unwrap();
        assert_eq!((attitude.nose.axis, attitude.up.axis), (0, 2));
        // The same with wings along z.
        let body = Aircraft(
            bodies::cuboid([1.0, 0.1, 0.1]).unwrap(),
            bodies::cuboid([0.3, 0.02, 1.0]).unwrap(),
        );
        let attitude = Attitude::new(&body, None, None, 0.0).unwrap();
        assert_eq!((attitude.nose.axis, attitude.up.axis), (0, 1));
        assert!(attitude.is_guess);
    }

    #[test]
    fn a_round_body_shorter_than_wide_flies_along_its_axis() {
        let shield = bodies::cone(60.0, 0.5).unwrap();
        let attitude = Attitude::new(&shield, None, None, 0.0).unwrap();
        assert_eq!((attitude.nose.axis, attitude.nose.is_negative), (0, true));
        let turned = Placement::default()
            .rotated_about(&Vector::<3>::z(), std::f64::consts::FRAC_PI_2)
            .unwrap();
        let attitude = Attitude::new(&Placed::new(shield, turned), None, None, 0.0).unwrap();
        assert_eq!((attitude.nose.axis, attitude.nose.is_negative), (1, true));
    }

    #[test]
    fn a_cuboid_told_to_fly_along_z_lies_along_the_stream() {
        let body = bodies::cuboid([1.0, 2.0, 3.0]).unwrap();
        let attitude = Attitude::new(&body, Some("+z,+x".parse().unwrap()), None, 0.0).unwrap();
        let placement = attitude.placement().unwrap();
        // The nose, +z, comes to x = 0; the tail lies downstream.
        let nose = placement.point(&Vector::<3>::new(0.0, 0.0, 1.5));
        let top = placement.direction(&Vector::<3>::new(1.0, 0.0, 0.0));
        assert!(nose.norm() < 1e-12, "{nose}");
        assert!((top - Vector::<3>::new(0.0, 1.0, 0.0)).norm() < 1e-12);
    }

    #[test]
    fn a_body_made_whole_from_its_half_flies_with_the_cut_upright() {
        let body = bodies::cuboid([2.0, 0.5, 0.4]).unwrap();
        for (half, up) in [("-z", "+y"), ("+y", "+z"), ("+x", "+z")] {
            let half: Way = half.parse().unwrap();
            let attitude = Attitude::new(&body, None, Some(half), 0.0).unwrap();
            assert_eq!(attitude.up.to_string(), up, "{half}");
        }
    }
}
