//! Sides that gas crosses, through the command line.

mod support;

use std::collections::BTreeMap;

use support::Workplace;

/// Gas in a tube a thousandth above the pressure that its outlet holds; nothing else comes in.
const ABOVE: &str = r#"
dimension = 1
spacing = 0.02
end_time = 1.4

[free_stream]
mach = 0.2
density = 1.0
pressure = 0.7142857142857143

[domain]
min = [0.0]
max = [1.0]

[domain.sides]
x_min = { inlet = { reflecting = false } }
x_max = { outlet = { pressure = 0.7135714285714286, relaxation = 1.0 } }

[output]
frames = 1

[[probe]]
name = "end"
at = { point = [0.94] }
"#;

const HELD: f64 = 0.713_571_428_571_428_6;

/// Columns of `probes.csv` by name.
fn probes(place: &Workplace) -> BTreeMap<String, Vec<f64>> {
    let text = std::fs::read_to_string(place.path("results/probes.csv")).expect("a table");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let mut columns = BTreeMap::<String, Vec<f64>>::new();
    for line in lines {
        for (name, field) in names.iter().zip(line.split(',')) {
            let number = field.parse().unwrap_or(f64::NAN);
            columns.entry((*name).to_owned()).or_default().push(number);
        }
    }
    columns
}

/// `p - p_held` falls as `exp(-sigma (1 - M^2) c t / 2 L)`: what comes in changes by the law of Poinsot & Lele (1992), eq. 40, and
/// what goes out does not. Both motions once were off by a factor: of two the points, of `1 - M` the particles.
#[test]
fn an_outlet_goes_back_to_its_pressure_as_fast_as_its_relaxation_says() {
    for (motion, allowed) in [("fixed", 0.02), ("with-the-gas", 0.08)] {
        let place = Workplace::new();
        let motion = format!("scheme.motion={motion}");
        place.run(ABOVE, &["--set", &motion]).succeeds();
        let columns = probes(&place);
        let above = |from: f64| {
            let row = columns["time"].iter().position(|time| *time >= from);
            let row = row.expect("a row");
            (columns["time"][row], columns["end.pressure"][row] - HELD)
        };
        let ((first, high), (last, low)) = (above(0.3), above(1.2));
        let rate = (high / low).ln() / (last - first);
        let documented = 0.5 * (1.0 - 0.2 * 0.2);
        let error = rate / documented - 1.0;
        assert!(error.abs() < allowed, "{motion}: {error}");
    }
}
