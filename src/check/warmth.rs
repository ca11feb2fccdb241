//! Streams that are hotter or colder than what their gas is meant for, or get so where they come to rest.

use aero_packer::{About, Warning};
use aero_solver::gas::{Air, Gas};
use aero_solver::problem::Problem;

use super::Check;

/// Looks at the free stream.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    let Gas::Air { air, .. } = problem.gas else {
        return;
    };
    let stream = &problem.free_stream;
    let [least, most] = air.range();
    let own = air.temperature(stream.density, stream.pressure);
    if own < least {
        found.warnings.push(Warning::new(
            About::Scene,
            format!("the stream has {own:.4} K; below {least} K {air} goes on as an ideal gas"),
        ));
    }
    let square = stream.velocity.norm_squared();
    let enthalpy = problem.gas.enthalpy(stream.density, stream.pressure) + 0.5 * square;
    let pressure = stream.pressure + stream.density * square;
    let rest = air.temperature(
        pressure / air.heat_of_enthalpy(pressure, enthalpy),
        pressure,
    );
    if rest > most {
        let mend = match air {
            Air::ThermallyPerfect => "; its molecules come apart, as those of `equilibrium-air` do",
            Air::Equilibrium => "",
        };
        found.warnings.push(Warning::new(
            About::Scene,
            format!("the stream comes to rest at about {rest:.0} K, and {air} holds up to {most} K{mend}"),
        ));
    }
    let [thinnest, densest] = air.densities();
    if stream.density < thinnest || stream.density > densest {
        found.warnings.push(Warning::new(
            About::Scene,
            format!(
                "the stream has a density of {:.3e}; {air} holds from {thinnest:e} to {densest}, in SI",
                stream.density
            ),
        ));
    }
}

#[cfg(test)]
mod tests {
    use crate::check::told;

    const SCENE: &str = r#"
dimension = 1
spacing = 0.1
end_time = 1.0
[gas]
equation_of_state = "thermally-perfect-air"
[free_stream]
mach = 3.0
temperature = 300.0
pressure = 1e5
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
    fn streams_that_are_too_hot_or_too_cold_are_told() {
        assert!(warnings(&[]).is_empty());
        let hot = warnings(&["free_stream.mach=16.0"]);
        assert!(
            hot[0].contains("comes to rest at") && hot[0].contains("equilibrium-air"),
            "{hot:?}"
        );
        let mended = [
            "free_stream.mach=16.0",
            "gas.equation_of_state=equilibrium-air",
        ];
        assert!(warnings(&mended).is_empty());
        let cold = warnings(&["free_stream.temperature=50.0"]);
        assert!(
            cold[0].contains("50.0000 K") || cold[0].contains("50 K"),
            "{cold:?}"
        );
    }
}
