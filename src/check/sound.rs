//! Open sides that send sound back: those of particles whose stream is slower than sound. Beside points that stay sound goes out, but an outlet that
//! holds no pressure leaves that of the whole flow open.

use aero_packer::{About, Warning};
use aero_solver::problem::{Problem, Side};

use super::{Check, side_name};

/// Looks at each side.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    let is_fixed = problem.method.fixed().is_some();
    // From a reservoir gas may become faster than sound on its way.
    if is_fixed && problem.domain.has(Side::is_reservoir) {
        return;
    }
    let stream = &problem.free_stream;
    let sound = (problem.gas).sound_speed_at(stream.density, stream.pressure);
    if stream.velocity.norm() > sound {
        return;
    }
    for (axis, end, side, _) in problem.domain.each_side() {
        let outward = [-1.0, 1.0][end] * stream.velocity[axis];
        let crosses = outward.abs() > 0.1 * stream.velocity.norm();
        let mend = match side {
            Side::Outlet if crosses && outward > 0.0 => "take `{ outlet = { pressure = .. } }`",
            _ if is_fixed => continue,
            Side::Inlet => "take `{ inlet = { reflecting = false } }`",
            Side::FreeStream if crosses => "keep it far from the bodies",
            _ => continue,
        };
        let mend = if problem.gas.ideal_gas().is_some() {
            mend
        } else {
            "keep it far from the bodies"
        };
        let wrong = if is_fixed {
            "nothing holds the pressure there, so that the flow may swing for long"
        } else {
            "it sends back sound that meets it"
        };
        let text = format!(
            "side `{}`: the free stream crosses it at Mach {:.2}, and {wrong}; {mend}",
            side_name(axis, end),
            outward.abs() / sound
        );
        found.warnings.push(Warning::new(About::Scene, text));
    }
}

#[cfg(test)]
mod tests {
    use crate::check::told;

    const SCENE: &str = r#"
dimension = 1
spacing = 0.1
end_time = 1.0
[free_stream]
mach = 0.5
density = 1.0
pressure = 1.0
[domain]
min = [0.0]
max = [1.0]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
"#;

    fn warnings(settings: &[&str]) -> Vec<String> {
        told(SCENE, settings)
    }

    #[test]
    fn sides_that_send_sound_back_are_told_with_their_mend() {
        let told = warnings(&[]);
        assert_eq!(told.len(), 2, "{told:?}");
        assert!(told[0].contains("reflecting = false") && told[1].contains("outlet = { pressure"));
        assert!(warnings(&["free_stream.mach=1.5"]).is_empty());
        let fixed = warnings(&["scheme.motion=fixed"]);
        assert_eq!(fixed.len(), 1, "{fixed:?}");
        assert!(
            fixed[0].contains("nothing holds the pressure")
                && fixed[0].contains("outlet = { pressure")
        );
        let nozzle = "domain.sides.x_min=reservoir";
        assert!(warnings(&["scheme.motion=fixed", nozzle]).is_empty());
        let mended = [
            "domain.sides.x_min={ inlet = { reflecting = false } }",
            "domain.sides.x_max={ outlet = { pressure = 1.0 } }",
        ];
        assert!(warnings(&mended).is_empty());
    }
}
