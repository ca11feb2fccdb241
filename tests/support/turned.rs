//! Bodies of revolution as ASCII STL.

use std::f64::consts::TAU;

/// A cone of 20 degrees along z, one long, its tip at the origin, of so many facets.
pub fn cone(around: usize) -> String {
    turned(
        &[[0.0, 0.0], [1.0, 20_f64.to_radians().tan()], [1.0, 0.0]],
        around,
    )
}

/// Corners `(z, radius)` turned about z, of so many facets, as ASCII STL.
pub fn turned(line: &[[f64; 2]], around: usize) -> String {
    let at = |[z, radius]: [f64; 2], k: usize| {
        let (s, c) = (TAU * (k % around) as f64 / around as f64).sin_cos();
        format!("vertex {} {} {z}\n", radius * c, radius * s)
    };
    let mut text = "solid turned\n".to_owned();
    for pair in line.windows(2) {
        for k in 0..around {
            let [a, b, c, d] = [
                at(pair[0], k),
                at(pair[0], k + 1),
                at(pair[1], k + 1),
                at(pair[1], k),
            ];
            let mut facet = |corners: String| {
                text += "facet normal 0 0 0\nouter loop\n";
                text += &corners;
                text += "endloop\nendfacet\n";
            };
            if pair[1][1] > 0.0 {
                facet(format!("{a}{c}{d}"));
            }
            if pair[0][1] > 0.0 {
                facet(format!("{a}{b}{c}"));
            }
        }
    }
    text + "endsolid turned\n"
}
