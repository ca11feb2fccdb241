//! Liquids, through the command line.

use crate::support::Workplace;

/// Water that a wall stops.
const SCENE: &str = r#"
dimension = 1
spacing = 0.02
end_time = 1e-4

[gas]
equation_of_state = { tait = { sound_speed = 1484.0, density = 998.0 } }

[free_stream]
speed = 10.0
density = 998.0

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
fn what_a_liquid_has_not_is_refused_with_the_mend() {
    let gas = "[gas]\n";
    for key in ["gamma = 1.4", "gas_constant = 287.0", "prandtl = 0.7"] {
        let name = key.split(' ').next().unwrap();
        refused(
            gas,
            &format!("{gas}{key}\n"),
            &[&format!("gas.{name}"), "names a liquid", "leave it out"],
        );
    }
    refused(
        gas,
        &format!("{gas}viscosity = {{ sutherland = {{}} }}\n"),
        &["gas.viscosity", "temperature", "give a number in Pa s"],
    );
    let density = "density = 998.0\n\n[domain]";
    for (state, words) in [
        (
            "altitude = 1000.0",
            ["free_stream.altitude", "density or pressure alone"],
        ),
        (
            "temperature = 300.0\npressure = 1e5",
            ["free_stream.temperature", "density or pressure alone"],
        ),
        (
            "density = 998.0\npressure = 1e5",
            ["free_stream.pressure", "leave one of the two out"],
        ),
        ("", ["free_stream", "give density or pressure"]),
    ] {
        refused(density, &format!("{state}\n\n[domain]"), &words);
    }
    let side = "x_min = \"inlet\"";
    refused(
        side,
        "x_min = { inlet = { reflecting = false } }",
        &["domain.sides.x_min", "use `inlet`"],
    );
    refused(
        side,
        "x_min = { inlet = { density = 998.0 } }",
        &["domain.sides.x_min", "names a liquid"],
    );
    refused(
        gas,
        &format!("[scheme]\nmotion = \"fixed\"\n\n{gas}"),
        &["scheme.motion", "`with-the-gas`"],
    );
    refused(
        "sound_speed = 1484.0",
        "sound_speed = 1484.0, exponent = 0.5",
        &["0.5 is not an exponent of a liquid"],
    );
}

#[test]
fn schemes_of_liquids_refuse_what_they_cannot_do() {
    let scheme = |name: &str| format!("[scheme]\nequations = \"{name}\"\n\n[gas]\n");
    let air = SCENE
        .replace("[gas]\n", &scheme("L-IPST-C"))
        .replace(
            "equation_of_state = { tait = { sound_speed = 1484.0, density = 998.0 } }",
            "",
        )
        .replace("speed = 10.0", "speed = 10.0\npressure = 1e5");
    Workplace::new().run(&air, &[]).refuses(&[
        "scheme.equations",
        "`L-IPST-C` evolves the density of a liquid",
        "take `conservative`",
    ]);
    refused(
        "[gas]\n",
        &scheme("E-C"),
        &["domain.sides.x_min", "stay where they are", "`TV-C`"],
    );
    refused(
        "[gas]\n",
        &scheme("TV-C").replace("\n\n[gas]", "\nprecision = \"mixed\"\n\n[gas]"),
        &["scheme.precision", "`double`"],
    );
    refused(
        "[gas]\n",
        &scheme("WCSPH"),
        &["no set of equations", "`L-IPST-C`", "`EDAC`"],
    );
}

#[test]
fn a_liquid_is_told_and_runs_by_each_scheme_that_goes_with_its_sides() {
    let place = Workplace::new();
    place.write("scene.toml", SCENE);
    let told = place.aero(&["check", "scene.toml"]).out;
    assert!(told.contains("gas: a liquid, Tait's equation"), "{told}");
    for scheme in [
        "conservative",
        "paper",
        "L-IPST-C",
        "PE-IPST-C",
        "TV-C",
        "EDAC",
    ] {
        let setting = format!("scheme.equations={scheme}");
        Workplace::new().run(SCENE, &["--set", &setting]).succeeds();
    }
}

#[test]
fn pressure_that_nothing_damps_beside_a_wall_is_told() {
    let scene = SCENE
        .replace(
            "x_max = \"wall\"",
            "x_max = { wall = { kind = \"no-slip\" } }",
        )
        .replace("[gas]\n", "[gas]\nviscosity = 1e-3\n");
    let place = Workplace::new();
    place.write("scene.toml", scene);
    let told = |scheme: &str| {
        let setting = format!("scheme.equations={scheme}");
        let answer = place.aero(&["check", "scene.toml", "--set", &setting]);
        answer.succeeds();
        answer.out + &answer.err
    };
    assert!(told("L-IPST-C").contains("does not damp pressure"));
    assert!(!told("PE-IPST-C").contains("does not damp pressure"));
}
