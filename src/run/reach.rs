//! Bodies that the gas moves by less than a spacing: rows of gas lie beside a wall as they lay at the start, and do not follow one that
//! comes and goes between them.

use aero_geometry::Vector;
use aero_packer::{About, Warning};
use aero_solver::Flow;

/// Part of a spacing below which a body is as good as held.
const HELD: f64 = 1e-3;

/// The largest ways so far of the bodies that the gas moves, from where they were at first, by their numbers.
pub(super) fn grow<const D: usize>(reach: &mut [f64], flow: &Flow<D>) {
    let bodies = flow.problem().bodies.iter();
    for (number, (body, reach)) in bodies.zip(reach).enumerate() {
        if body.motion.free.is_none() {
            continue;
        }
        let (bounds, pose) = (body.shape.bounds(), flow.pose(number));
        for code in 0..1_usize << D {
            let corner = Vector::<D>::from_fn(|k, _| match code >> k & 1 {
                0 => bounds.min[k],
                _ => bounds.max[k],
            });
            *reach = reach.max((pose.position(&corner) - corner).norm());
        }
    }
}

/// What there is to say of bodies that came so far from their places, by their names, in gas of this spacing.
pub(super) fn warnings<'a>(
    ways: impl Iterator<Item = (&'a str, f64)>,
    spacing: f64,
) -> Vec<Warning> {
    let short = ways.filter_map(|(name, way)| {
        let part = way / spacing;
        (HELD..1.0).contains(&part).then(|| {
            Warning::new(
                About::Scene,
                format!(
                    "the gas has moved it by {part:.2} spacings at most: rows of gas do not follow a wall that moves by less than one, and a \
                     swing takes some 12 % less time than it should; give a smaller `spacing`"
                ),
            )
            .of(name)
        })
    });
    short.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn swings_of_less_than_a_spacing_are_told_and_no_others() {
        let told = |way: f64| warnings([("vane", way)].into_iter(), 0.1);
        assert!(
            told(0.03)[0]
                .to_string()
                .starts_with("body `vane`: the gas has moved it by 0.30")
        );
        for way in [0.0, 1e-6, 0.11, 3.0] {
            assert!(told(way).is_empty(), "{way}");
        }
    }
}
