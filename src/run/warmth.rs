//! Gas that is hotter or colder, at the end of a run, than its equation of state is meant for.

use aero_packer::{About, Warning};
use aero_solver::frame::{Frame, Kind};
use aero_solver::gas::Gas;
use aero_solver::problem::Problem;

/// What there is to say of the temperatures of a flow as it stands in `frame`.
pub(super) fn warnings<const D: usize>(problem: &Problem<D>, frame: &Frame) -> Vec<Warning> {
    let Gas::Air { air, .. } = problem.gas else {
        return Vec::new();
    };
    let [least, most] = air.range();
    let (mut coldest, mut hottest) = ((least, None), (most, None));
    for i in (0..frame.kind.len()).filter(|&i| frame.kind[i] == Kind::Fluid as u8) {
        let temperature = air.temperature(frame.density[i], frame.pressure[i]);
        if temperature < coldest.0 {
            coldest = (temperature, Some(i));
        }
        if temperature > hottest.0 {
            hottest = (temperature, Some(i));
        }
    }
    let ends = [
        (coldest, "cold", least, "down to"),
        (hottest, "hot", most, "up to"),
    ];
    let lines = ends
        .into_iter()
        .filter_map(|((temperature, place), word, end, to)| {
            let at = &frame.position[place?];
            let place: Vec<String> = at[..D].iter().map(|x| format!("{x:.4}")).collect();
            Some(format!(
                "the gas is as {word} as {temperature:.0} K at ({}); {air} holds {to} {end} K",
                place.join(", ")
            ))
        });
    lines.map(|text| Warning::new(About::Scene, text)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    const SCENE: &str = r#"
dimension = 1
spacing = 0.1
end_time = 1.0
[gas]
equation_of_state = "thermally-perfect-air"
[free_stream]
mach = 2.0
temperature = 300.0
pressure = 1e5
[domain]
min = [0.0]
max = [1.0]
[domain.sides]
x_min = "inlet"
x_max = "outlet"
"#;

    #[test]
    fn gas_beyond_the_range_is_told_with_its_place() {
        let scene = Scene::parse(SCENE, "tube", std::path::Path::new("")).unwrap();
        let problem = scene.build::<1>().unwrap().problem;
        let frame = |temperature: f64| Frame {
            position: vec![[0.25, 0.0, 0.0], [0.75, 0.0, 0.0]],
            density: vec![1.0; 2],
            pressure: vec![1e5, 287.06 * temperature],
            kind: vec![Kind::Fluid as u8; 2],
            ..Frame::default()
        };
        assert!(warnings(&problem, &frame(400.0)).is_empty());
        let told = warnings(&problem, &frame(7000.0))[0].to_string();
        assert!(
            told.contains("7000 K at (0.7500)") && told.contains("6000 K"),
            "{told}"
        );
        let told = warnings(&problem, &frame(90.0))[0].to_string();
        assert!(
            told.contains("cold as 90 K") && told.contains("200 K"),
            "{told}"
        );
    }
}
