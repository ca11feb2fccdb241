//! A second gas, through the command line.

use crate::support::{Workplace, appended};

/// A cylinder of helium in air.
const SCENE: &str = r#"
dimension = 2
spacing = 0.01
end_time = 4e-5

[gas]
gamma = 1.4
gas_constant = 287.0

[gas.second]
gamma = 1.667
gas_constant = 2077.0
density = 0.1655
inside = "r < 0.055"

[domain]
min = [-0.15, 0.0]
max = [0.15, 0.1]

[domain.sides]
x_min = "wall"
x_max = "outlet"
y_min = "symmetry"
y_max = "wall"

[initial.riemann]
position = -0.1
left = { density = 1.6583, pressure = 159060.0, velocity = [114.47, 0.0] }
right = { density = 1.2, pressure = 101325.0 }

[output]
interval = 4e-5
field = { spacing = 0.01 }
"#;

fn refused(from: &str, to: &str, words: &[&str]) {
    Workplace::new().refuses_changed(SCENE, [from, to], words);
}

#[test]
fn what_does_not_go_with_two_gases_is_refused_with_the_mend() {
    refused(
        "[domain]\n",
        "[scheme]\nmotion = \"fixed\"\n\n[domain]\n",
        &[
            "gas.second",
            "goes with particles",
            "leave out scheme.motion",
        ],
    );
    refused(
        "[domain]\n",
        "[scheme]\nequations = \"paper\"\n\n[domain]\n",
        &["gas.second", "would mix the gases", "\"conservative\""],
    );
    refused(
        "[domain]\n",
        "[scheme]\nshifting = true\n\n[domain]\n",
        &["gas.second", "shifting", "leave scheme.shifting out"],
    );
    let first = "gamma = 1.4\ngas_constant = 287.0";
    refused(
        first,
        "gamma = 1.4\ngas_constant = 287.0\nviscosity = 1e-5",
        &["gas.second", "has no viscosity", "leave gas.viscosity out"],
    );
    refused(
        first,
        "equation_of_state = \"equilibrium-air\"",
        &["gas.second", "ideal gas", "leave gas.equation_of_state out"],
    );
    refused(
        first,
        "gamma = 1.4",
        &["gas.second.gas_constant", "gas.gas_constant of the first"],
    );
    refused(
        "gas_constant = 2077.0\n",
        "",
        &["gas.second.gas_constant", "missing", "J/(kg K)"],
    );
    refused(
        "r < 0.055",
        "r < 0.001",
        &["gas.second.inside", "nowhere in the domain", "say where"],
    );
    refused(
        "x_max = \"outlet\"",
        "x_max = { outlet = { pressure = 101325.0 } }",
        &["domain.sides.x_max", "waves of one gas", "use `outlet`"],
    );
    let stream = "[free_stream]\nmach = 1.0\ndensity = 1.2\npressure = 101325.0\n\n[domain]\n";
    let open = SCENE
        .replace("[domain]\n", stream)
        .replace("x_min = \"wall\"", "x_min = \"inlet\"")
        .replace("r < 0.055", "x < 0.0");
    let words = ["gas.second.inside", "side x_min", "keep the second gas off"];
    Workplace::new().run(&open, &[]).refuses(&words);
    // Nor at a part of a side that gas comes in through.
    let part = "x_min = [\"wall\", { patch = { min = [-0.15, 0.0], max = [-0.15, 0.05] }, inlet = { velocity = [114.0, 0.0] } }]\n";
    let partly = open.replace("x_min = \"inlet\"\n", part);
    assert_ne!(partly, open);
    Workplace::new().run(&partly, &[]).refuses(&words);
}

/// Frames tell the gases apart, and each has its own temperature; on a lattice it is that of their mixture.
#[test]
fn results_tell_which_gas_is_where() {
    let place = Workplace::new();
    let answer = place.run(SCENE, &["--set", "output.compress=false"]);
    answer.succeeds();
    let told = answer.out + &answer.err;
    let words = "second gas: ideal, ratio of specific heats 1.667, density 1.65500e-1 at the start";
    assert!(told.contains(words), "{told}");
    let frame = place.path("results/frame-000000.vtp");
    let array = |name: &str| appended(&frame, name).expect("an array");
    let (second, density, temperature) =
        (array("second_gas"), array("density"), array("temperature"));
    let light = second.iter().filter(|second| **second == 1.0).count();
    assert!((40..60).contains(&light), "{light}");
    let mut seen = 0;
    for ((second, density), temperature) in second.iter().zip(&density).zip(&temperature) {
        assert_eq!(*second == 1.0, (density / 0.1655 - 1.0).abs() < 1e-9);
        if *second == 1.0 {
            seen += 1;
            assert!(
                (temperature - 101_325.0 / (0.1655 * 2077.0)).abs() < 2.0,
                "{temperature}"
            );
        }
    }
    assert_eq!(seen, light);
    let field = place.path("results/field-000000.vti");
    let temperature = appended(&field, "temperature").expect("temperatures");
    let near = temperature
        .iter()
        .filter(|t| (285.0..305.0).contains(*t))
        .count();
    // All but what the shock has heated and what bodies' masks leave at zero.
    assert!(
        near * 10 > temperature.len() * 7,
        "{near} of {}",
        temperature.len()
    );
}

/// The second gas outlives a stop: a run that goes on has the bits of one that never stopped.
#[test]
fn a_run_of_two_gases_goes_on_where_it_stopped() {
    let [whole, parts] = [Workplace::new(), Workplace::new()];
    whole.run(SCENE, &["--set", "end_time=8e-5"]).succeeds();
    parts.run(SCENE, &[]).succeeds();
    parts
        .run(SCENE, &["--resume", "--set", "end_time=8e-5"])
        .succeeds();
    let history = |place: &Workplace| {
        let text = std::fs::read_to_string(place.path("results/history.csv")).unwrap();
        text.lines().last().unwrap().to_owned()
    };
    assert_eq!(history(&whole), history(&parts));
}
