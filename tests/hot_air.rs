//! Gases beyond the ideal one, through the command line.

use crate::support::Workplace;

/// Air that a wall stops.
const SCENE: &str = r#"
dimension = 1
spacing = 0.02
end_time = 2e-4

[gas]
equation_of_state = "thermally-perfect-air"

[free_stream]
speed = 1800.0
pressure = 1e4
temperature = 300.0

[domain]
min = [0.0]
max = [1.0]

[domain.sides]
x_min = "inlet"
x_max = "wall"
"#;

fn refused(from: &str, to: &str, words: &[&str]) {
    Workplace::new().refuses_changed(SCENE, [from, to], words);
}

#[test]
fn what_is_of_an_ideal_gas_alone_is_refused_with_the_mend() {
    let air = "equation_of_state = \"thermally-perfect-air\"";
    let also = |key: &str| format!("{air}\n{key}");
    let both = [
        "follows from gas.equation_of_state",
        "leave one of the two out",
    ];
    refused(
        air,
        &also("gamma = 1.4"),
        &[&["gas.gamma"], &both[..]].concat(),
    );
    refused(
        air,
        &also("gas_constant = 287.0"),
        &[&["gas.gas_constant"], &both[..]].concat(),
    );
    refused(
        air,
        &also("prandtl = 0.7"),
        &["gas.prandtl", "there is none", "add `viscosity`"],
    );
    refused(
        air,
        "equation_of_state = \"steam\"",
        &["steam", "equilibrium-air"],
    );
    let side = "x_min = \"inlet\"";
    refused(
        side,
        "x_min = { inlet = { reflecting = false } }",
        &["domain.sides.x_min", "waves of an ideal gas", "use `inlet`"],
    );
    refused(
        "x_max = \"wall\"",
        "x_max = { outlet = { pressure = 1e4 } }",
        &[
            "domain.sides.x_max",
            "waves of an ideal gas",
            "use `outlet`",
        ],
    );
}

/// The gas is told in words, and where it gets hotter than it is meant for with the mend.
#[test]
fn the_check_tells_the_gas_and_its_temperature() {
    let place = Workplace::new();
    place.write("hot.toml", SCENE);
    let said = |settings: &[&str]| {
        let mut arguments = vec!["check", "hot.toml"];
        for setting in settings {
            arguments.extend(["--set", setting]);
        }
        let answer = place.aero(&arguments);
        answer.succeeds();
        answer.out + &answer.err
    };
    let text = said(&[]);
    assert!(
        text.contains("gas: thermally perfect air, 200 to 6000 K"),
        "{text}"
    );
    assert!(text.contains("the stream has 300.00 K"), "{text}");
    assert!(!text.contains("comes to rest"), "{text}");
    let text = said(&["free_stream.speed=7000.0"]);
    assert!(
        text.contains("comes to rest at about") && text.contains("6000 K"),
        "{text}"
    );
    let text = said(&["gas.equation_of_state=ideal"]);
    assert!(
        text.contains("gas: ideal, ratio of specific heats 1.4"),
        "{text}"
    );
}

/// Both motions run it, and say of gas that has got too hot where.
#[test]
fn gas_that_gets_too_hot_is_told_with_its_place() {
    for motion in ["fixed", "with-the-gas"] {
        let place = Workplace::new();
        let motion = format!("scheme.motion={motion}");
        let hot = [
            "--set",
            "free_stream.speed=6000.0",
            "--set",
            "end_time=1e-4",
            "--set",
            &motion,
        ];
        place.run(SCENE, &hot).succeeds();
        let summary = place.json("results/summary.json");
        let warnings = summary["warnings"].to_string();
        assert!(warnings.contains("the gas is as hot as"), "{warnings}");
        assert!(
            warnings.contains("thermally perfect air holds up to 6000 K"),
            "{warnings}"
        );
    }
}
