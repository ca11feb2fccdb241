//! Boundary layers of viscous gas: whether the spacing can show them, and whether they stay laminar.

use aero_geometry::{Bounds, Vector};
use aero_packer::{About, Warning};
use aero_solver::problem::{Problem, Side};

use super::{Check, side_name};

/// Spacings across a layer below which its friction and heat are not to be trusted.
const LEAST: f64 = 10.0;

/// Thickness of a laminar layer over `L / sqrt(Re)`, to 99 % of the stream's speed [Blasius 1908].
const BLASIUS: f64 = 5.0;

/// Reynolds number by the length of a plate beyond which its layer is hardly laminar (White, Viscous Fluid Flow, section 5-1).
const TURBULENT: f64 = 5e5;

/// Looks at the layer on each wall that the gas sticks to in a stream.
pub(super) fn look<const D: usize>(problem: &Problem<D>, found: &mut Check) {
    let Some(per_length) = reynolds_per_length(problem) else {
        return;
    };
    let stream = &problem.free_stream;
    let along = |bounds: &Bounds<D>| {
        let direction: Vector<D> = stream.velocity.normalize();
        bounds.size().dot(&direction.abs())
    };
    let bodies = problem
        .bodies
        .iter()
        .filter(|body| body.wall.sticks())
        .map(|body| (body.name.clone(), along(&body.shape.bounds()), true));
    // A wall without ends has a layer that grows until it meets another: no length says how thick it is.
    let ends = problem.domain.sides[stream.velocity.iamax()][0] != Side::Periodic;
    let sides = problem.domain.each_side();
    let sides = sides.filter_map(|(axis, end, side, _)| match side {
        Side::Wall { kind, .. } if kind.sticks() => {
            Some((side_name(axis, end), along(&problem.domain.bounds), ends))
        }
        _ => None,
    });
    // Bodies ask for none where they are neither thin nor bent.
    let levels = problem.method.fixed().map_or(0, |p| p.refine.of_flow());
    let finest = problem.resolution.lattice() / f64::from(1_u32 << levels.min(20));
    for (name, length, ends) in bodies.chain(sides) {
        let reynolds = per_length * length;
        let thickness = (BLASIUS * length / reynolds.sqrt()).min(length);
        if !(thickness > 0.0 && thickness.is_finite()) {
            continue;
        }
        let mut tell = |text| found.warnings.push(Warning::new(About::Scene, text));
        if ends && thickness < LEAST * finest {
            tell(format!(
                "`{name}`: a laminar boundary layer is about {thickness:.2e} thick at its end (Reynolds number {reynolds:.1e}), {:.1} spacings: \
                 friction and heat ask for {LEAST}; take `spacing = {:.1e}`, or with points that stay `refine = {}`",
                thickness / finest,
                thickness / LEAST,
                (problem.resolution.lattice() * LEAST / thickness)
                    .log2()
                    .ceil()
                    .max(1.0)
            ));
        }
        if reynolds > TURBULENT {
            tell(format!(
                "`{name}`: at a Reynolds number of {reynolds:.1e} boundary layers are turbulent in nature; this one is computed as laminar"
            ));
        }
    }
}

/// `rho u / mu` of the free stream; none where it does not move, or is not viscous.
pub(super) fn reynolds_per_length<const D: usize>(problem: &Problem<D>) -> Option<f64> {
    let (gas, stream) = (&problem.gas, &problem.free_stream);
    let speed = stream.velocity.norm();
    if !gas.is_viscous() || speed == 0.0 {
        return None;
    }
    let energy = gas.energy(stream.density, stream.pressure);
    Some(stream.density * speed / gas.coefficients(stream.density, energy).viscosity)
}

#[cfg(test)]
mod tests {
    use crate::check::told;

    const SCENE: &str = r#"
dimension = 2
spacing = 0.01
end_time = 1.0
[gas]
viscosity = { reynolds = 1e3 }
[scheme]
motion = "fixed"
[free_stream]
mach = 2.0
density = 1.0
pressure = 1.0
[domain]
min = [0.0, 0.0]
max = [1.0, 0.5]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
y_min = { wall = { kind = "no-slip" } }
y_max = "free-stream"
"#;

    fn warnings(settings: &[&str]) -> Vec<String> {
        told(SCENE, settings)
    }

    #[test]
    fn layers_thinner_than_spacings_can_show_are_told_with_the_mend() {
        // 5 / sqrt(1e3) = 0.158 is sixteen spacings.
        assert!(warnings(&[]).is_empty(), "{:?}", warnings(&[]));
        let told = warnings(&["gas.viscosity={ reynolds = 1e5 }"]);
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains("`y_min`") && told[0].contains("1.6 spacings"));
        assert!(told[0].contains("spacing = 1.6e-3") && told[0].contains("refine = 3"));
        let mended = ["gas.viscosity={ reynolds = 1e5 }", "scheme.refine=3"];
        assert!(warnings(&mended).is_empty());
        let for_bodies = [mended[0], "scheme.refine={ flow = 1, bodies = 3 }"];
        let told = warnings(&for_bodies);
        assert!(
            told.len() == 1 && told[0].contains("3.2 spacings"),
            "{told:?}"
        );
        let slides = [
            "domain.sides.y_min={ wall = {} }",
            "gas.viscosity={ reynolds = 1e5 }",
        ];
        assert!(warnings(&slides).is_empty());
    }

    #[test]
    fn walls_without_ends_have_no_thickness_told_and_may_be_turbulent() {
        let endless = |reynolds: &str| {
            warnings(&[
                "domain.sides.x_min=periodic",
                "domain.sides.x_max=periodic",
                &format!("gas.viscosity={{ reynolds = {reynolds} }}"),
            ])
        };
        assert!(endless("1e5").is_empty(), "{:?}", endless("1e5"));
        let told = endless("1e6");
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains("turbulent"));
    }

    #[test]
    fn layers_that_nature_has_turbulent_are_told() {
        let told = warnings(&["gas.viscosity={ reynolds = 1e6 }", "scheme.refine=6"]);
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains("turbulent"));
    }
}
