//! Bodies as binary STL: turned lines and sections drawn out along the span, noses at x = 0.

use std::f64::consts::{PI, TAU};

/// Facets around an axis.
const AROUND: usize = 240;

/// Three corners.
pub type Facet = [[f64; 3]; 3];

/// A file of facets.
pub fn stl(facets: &[Facet]) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((facets.len() as u32).to_le_bytes());
    for facet in facets {
        // Readers take normals from the corners.
        bytes.extend([0; 12]);
        for number in facet.iter().flatten() {
            bytes.extend((*number as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// A line `(x, radius)` from nose to tail, both on the axis, turned about it.
fn turned(line: &[[f64; 2]]) -> Vec<Facet> {
    let at = |[x, radius]: [f64; 2], k: usize| {
        let (sin, cos) = (TAU * (k % AROUND) as f64 / AROUND as f64).sin_cos();
        [x, radius * cos, radius * sin]
    };
    let mut facets = Vec::new();
    for pair in line.windows(2) {
        for k in 0..AROUND {
            let [a, b, c, d] = [
                at(pair[0], k),
                at(pair[0], k + 1),
                at(pair[1], k + 1),
                at(pair[1], k),
            ];
            if pair[1][1] > 0.0 {
                facets.push([a, c, d]);
            }
            if pair[0][1] > 0.0 {
                facets.push([a, b, c]);
            }
        }
    }
    facets
}

/// A convex section, counter-clockwise in x and y, drawn out along z to both sides.
fn drawn_out(section: &[[f64; 2]], span: f64) -> Vec<Facet> {
    let count = section.len() as f64;
    let middle = [0, 1].map(|k| section.iter().map(|p| p[k]).sum::<f64>() / count);
    let at = |[x, y]: [f64; 2], side: f64| [x, y, 0.5 * side * span];
    let mut facets = Vec::new();
    for (n, a) in section.iter().enumerate() {
        let b = section[(n + 1) % section.len()];
        let [low, far, back, near] = [at(*a, -1.0), at(b, -1.0), at(b, 1.0), at(*a, 1.0)];
        facets.extend([[low, far, back], [low, back, near]]);
        facets.push([at(middle, 1.0), near, back]);
        facets.push([at(middle, -1.0), far, low]);
    }
    facets
}

/// Down a flat base to the axis.
fn with_base(mut line: Vec<[f64; 2]>) -> Vec<Facet> {
    if let Some([x, radius]) = line.last().copied() {
        line.extend([0.75, 0.5, 0.25, 0.0].map(|part| [x, part * radius]));
    }
    turned(&line)
}

/// A cone, one long.
pub fn cone(degrees: f64) -> Vec<Facet> {
    let slope = degrees.to_radians().tan();
    let line = (0..=20).map(|n| [f64::from(n) / 20.0, slope * f64::from(n) / 20.0]);
    with_base(line.collect())
}

/// A sphere, one across.
pub fn sphere() -> Vec<Facet> {
    spheroid(1.0)
}

/// A spheroid, one long, so many times as long as thick.
pub fn spheroid(fineness: f64) -> Vec<Facet> {
    let line = (0..=120).map(|n| {
        let (sin, cos) = (PI * f64::from(n) / 120.0).sin_cos();
        let radius = if n % 120 == 0 { 0.0 } else { 0.5 * sin };
        [0.5 - 0.5 * cos, radius / fineness]
    });
    turned(&line.collect::<Vec<_>>())
}

/// A tangent ogive, one across and three long.
pub fn ogive() -> Vec<Facet> {
    let (radius, length) = (0.5, 3.0_f64);
    let arc = (radius * radius + length * length) / (2.0 * radius);
    let line = (0..=120).map(|n| {
        let x = length * f64::from(n) / 120.0;
        let y = (arc * arc - (length - x).powi(2)).sqrt() + radius - arc;
        [x, if n == 0 { 0.0 } else { y }]
    });
    with_base(line.collect())
}

/// The Apollo command module: heat shield, corner, cone of 33 degrees [Bertin 1966], its top flat, 0.2 m to the rim.
pub fn apollo() -> Vec<Facet> {
    let (widest, nose, corner, top) = (1.9558, 4.6939, 0.1956, 0.2);
    let meets = f64::asin((widest - corner) / (nose - corner));
    let shield = (0..80).map(|n| {
        let (sin, cos) = (meets * f64::from(n) / 79.0).sin_cos();
        [nose * (1.0 - cos), nose * sin]
    });
    let mut line: Vec<[f64; 2]> = shield.collect();
    let middle = [nose - (nose - corner) * meets.cos(), widest - corner];
    let aft = 123_f64.to_radians();
    line.extend((1..40).map(|n| {
        let (sin, cos) = (meets + (aft - meets) * f64::from(n) / 39.0).sin_cos();
        [middle[0] - corner * cos, middle[1] + corner * sin]
    }));
    if let Some([x, radius]) = line.last().copied() {
        let end = x + (radius - top) / 33_f64.to_radians().tan();
        line.extend([[end, top], [end, 0.0]]);
    }
    turned(&line)
}

/// A wing of a diamond's section, chord 1, a tenth thick, span 4.
pub fn diamond() -> Vec<Facet> {
    drawn_out(&[[0.0, 0.0], [0.5, -0.05], [1.0, 0.0], [0.5, 0.05]], 4.0)
}

/// A wing of two parabolic arcs, chord 1, a tenth thick, span 4.
pub fn biconvex() -> Vec<Facet> {
    let arc = |n: i32, side: f64| {
        let x = f64::from(n) / 60.0;
        [x, side * 0.2 * x * (1.0 - x)]
    };
    let lower = (0..=60).map(|n| arc(n, -1.0));
    let upper = (1..60).rev().map(|n| arc(n, 1.0));
    drawn_out(&lower.chain(upper).collect::<Vec<_>>(), 4.0)
}

/// A wedge of 10 degrees to either side, one long, four wide.
pub fn wedge() -> Vec<Facet> {
    let half = 10_f64.to_radians().tan();
    drawn_out(&[[0.0, 0.0], [1.0, -half], [1.0, half]], 4.0)
}

/// A plate, chord 1, 3 % thick, bevelled at both ends, span 2.
pub fn plate() -> Vec<Facet> {
    let section = [
        [0.0, 0.0],
        [0.03, -0.015],
        [0.97, -0.015],
        [1.0, 0.0],
        [0.97, 0.015],
        [0.03, 0.015],
    ];
    drawn_out(&section, 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of facets that face outwards.
    fn volume(facets: &[Facet]) -> f64 {
        let of = |[a, b, c]: &Facet| {
            let cross = [
                b[1] * c[2] - b[2] * c[1],
                b[2] * c[0] - b[0] * c[2],
                b[0] * c[1] - b[1] * c[0],
            ];
            (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6.0
        };
        facets.iter().map(of).sum()
    }

    #[test]
    fn bodies_are_closed_face_outwards_and_hold_what_they_should() {
        let cone_volume = |degrees: f64| PI * degrees.to_radians().tan().powi(2) / 3.0;
        let all = [
            (cone(10.0), cone_volume(10.0)),
            (sphere(), PI / 6.0),
            (diamond(), 0.2),
            (biconvex(), 4.0 * 0.2 / 3.0),
            (wedge(), 4.0 * 10_f64.to_radians().tan()),
            (plate(), 2.0 * 0.03 * 0.97),
        ];
        for (n, (facets, exact)) in all.into_iter().enumerate() {
            let found = volume(&facets);
            assert!((found / exact - 1.0).abs() < 2e-3, "{n}: {found} {exact}");
            assert_eq!(stl(&facets).len(), 84 + 50 * facets.len());
        }
        assert!(volume(&apollo()) > 10.0 && volume(&ogive()) > 1.0);
    }
}
