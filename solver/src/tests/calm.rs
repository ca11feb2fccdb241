use super::*;

/// A stream towards a wall, summed in full or where it is disturbed.
fn against_a_wall(skips: bool) -> Vec<[f64; 5]> {
    let mut problem = cube::<2>(40, Side::Symmetry);
    problem.domain.sides[0] = [Side::Inlet, WALL];
    problem.free_stream.velocity = Vector::<2>::new(2.0, 0.0);
    problem.scheme.skip_undisturbed = skips;
    let mut simulation = start(problem);
    advance(&mut simulation, 60);
    let calm = simulation.fluid.iter().filter(|p| p.is_calm).count();
    assert_eq!(calm > 200, skips, "{calm} particles are calm");
    let mut particles = simulation.fluid.to_vec();
    particles.sort_by_key(|particle| particle.id);
    particles
        .iter()
        .map(|p| {
            [
                p.position[0],
                p.position[1],
                p.velocity[0],
                p.density,
                p.energy,
            ]
        })
        .collect()
}

#[test]
fn a_stream_that_hits_a_wall_is_the_same_without_the_sums_of_its_undisturbed_part() {
    let (all, part) = (against_a_wall(false), against_a_wall(true));
    assert_eq!(all.len(), part.len());
    let pairs = all.iter().flatten().zip(part.iter().flatten());
    let furthest = pairs
        .map(|(all, part)| (all - part).abs())
        .fold(0.0, f64::max);
    assert!(furthest < 1e-12, "off by {furthest:.1e}");
}
