//! Outlets that the free stream comes in by. Nothing is known of the gas beyond an outlet: of particles none comes in, and points that stay see
//! their own gas there.

use aero_packer::{About, Warning};
use aero_solver::problem::{Problem, Side};

use super::{Check, side_name};

/// A stream that comes in by less than this part of its speed goes along a side.
const ALONG: f64 = 0.01;

/// Looks at each side.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    for (axis, end, side, _) in problem.domain.each_side() {
        if !is_against(problem, axis, end, side) {
            continue;
        }
        let name = side_name(axis, end);
        let text = format!(
            "side `{name}`: is an outlet, but the free stream comes in there at a speed of {:.4}, and an outlet brings no gas; take \
             `{name} = \"free-stream\"`",
            problem.free_stream.velocity[axis].abs()
        );
        found.warnings.push(Warning::new(About::Scene, text));
    }
}

/// True of an outlet that the free stream comes in by.
pub(crate) fn is_against<const D: usize>(
    problem: &Problem<D>,
    axis: usize,
    end: usize,
    side: Side,
) -> bool {
    let stream = &problem.free_stream.velocity;
    let inwards = [1.0, -1.0][end] * stream[axis];
    side.lets_out() && inwards > ALONG * stream.norm()
}

#[cfg(test)]
mod tests {
    use crate::check::told;

    const SCENE: &str = r#"
dimension = 2
spacing = 0.1
end_time = 1.0
[free_stream]
mach = 2.0
density = 1.0
pressure = 1.0
[domain]
min = [0.0, 0.0]
max = [1.0, 1.0]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = "outlet"
y_max = "outlet"
"#;

    fn warnings(settings: &[&str]) -> Vec<String> {
        told(SCENE, settings)
    }

    #[test]
    fn outlets_that_the_stream_comes_in_by_are_told() {
        assert!(warnings(&[]).is_empty());
        for motion in ["scheme.motion=fixed", "scheme.motion=with-the-gas"] {
            let told = warnings(&["free_stream.incidence=5", motion]);
            assert_eq!(told.len(), 1, "{told:?}");
            assert!(told[0].contains("`y_min`: is an outlet") && told[0].contains("free-stream"));
            let above = warnings(&["free_stream.incidence=-5", motion]);
            assert!(
                above.len() == 1 && above[0].contains("`y_max`"),
                "{above:?}"
            );
        }
        let held = "domain.sides.y_min={ outlet = { pressure = 1.0 } }";
        assert_eq!(warnings(&["free_stream.incidence=5", held]).len(), 1);
        let open = "domain.sides.y_min=free-stream";
        assert!(warnings(&["free_stream.incidence=5", open]).is_empty());
    }
}
