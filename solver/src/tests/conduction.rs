use super::*;

/// Range of the energies in a line of gas at rest whose temperature varies, and its total energy,
/// first and after several hundred steps.
fn ranges(is_limited: bool) -> [(f64, f64); 2] {
    let mut problem = cube::<1>(60, Side::Periodic);
    problem.scheme.limit_conduction(is_limited);
    let wave = std::f64::consts::TAU / problem.domain.bounds.max[0];
    problem.initial = Initial::Field(Field(Arc::new(move |position: &Vector<1>| State {
        density: 1.4 + 0.4 * (wave * position[0]).sin(),
        velocity: Vector::zeros(),
        pressure: 1.0,
    })));
    let mut simulation = start(problem);
    let measure = |simulation: &Simulation<1>| {
        let energies = || simulation.fluid.iter().map(|particle| particle.energy);
        let range = energies().fold(0.0, f64::max) - energies().fold(f64::INFINITY, f64::min);
        (range, simulation.totals().energy)
    };
    let before = measure(&simulation);
    advance_to(&mut simulation, 20.0);
    [before, measure(&simulation)]
}

#[test]
fn temperature_that_varies_smoothly_is_conducted_less() {
    let [before, limited] = ranges(true);
    let [_, unlimited] = ranges(false);
    let lost = |after: (f64, f64)| 1.0 - after.0 / before.0;
    assert!(
        lost(limited) < 0.4 * lost(unlimited),
        "lost {} of the range, {} without the limit",
        lost(limited),
        lost(unlimited)
    );
    assert!((limited.1 / before.1 - 1.0).abs() < 1e-12);
}
