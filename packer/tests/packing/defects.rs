//! Bodies with self-made defects: what exporters, editors and broken transfers do to an STL file.

use std::f64::consts::PI;
use std::fmt::Write as _;

use aero_geometry::bodies::sphere;
use aero_geometry::outline::Piece;
use aero_geometry::stl::{Facet, write_binary};
use aero_geometry::{Revolution, Vector};

/// Numbers from a seed, the same on every machine. [Knuth's linear congruence, upper bits]
pub struct Dice(pub u64);

impl Dice {
    pub fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize % count.max(1)
    }

    fn around(&mut self, size: f64) -> Vector<3> {
        Vector::from_fn(|_, _| size * (2.0 * self.unit() - 1.0))
    }
}

/// A file, and the sound surface that it stands for.
pub struct Defective {
    pub bytes: Vec<u8>,
    pub truth: Vec<Facet>,
    /// What was done.
    pub history: Vec<&'static str>,
    /// True where the file says so itself: it is cut off, miscounts or holds no numbers.
    pub damaged: bool,
}

fn moved(facets: Vec<Facet>, by: [f64; 3]) -> Vec<Facet> {
    let offset = Vector::from(by);
    facets.into_iter().map(|f| f.map(|p| p + offset)).collect()
}

fn turned_round(facets: Vec<Facet>) -> Vec<Facet> {
    facets.into_iter().map(|[a, b, c]| [a, c, b]).collect()
}

fn block(edges: [f64; 3]) -> Vec<Facet> {
    let half = Vector::from(edges) / 2.0;
    let corner =
        |n: usize| Vector::from_fn(|k, _| if n >> k & 1 == 1 { half[k] } else { -half[k] });
    [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ]
    .iter()
    .map(|f| f.map(corner))
    .collect()
}

/// A prism over an L, whose corner points inwards.
fn angle_iron() -> Vec<Facet> {
    let base = [
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ];
    let at = |k: usize, z: f64| Vector::from([base[k % 6][0] - 0.8, base[k % 6][1] - 0.8, z]);
    let mut facets = Vec::new();
    for [a, b, c] in [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]] {
        facets.push([at(a, 0.6), at(b, 0.6), at(c, 0.6)]);
        facets.push([at(a, -0.6), at(c, -0.6), at(b, -0.6)]);
    }
    for k in 0..6 {
        facets.push([at(k, -0.6), at(k + 1, -0.6), at(k + 1, 0.6)]);
        facets.push([at(k, -0.6), at(k + 1, 0.6), at(k, 0.6)]);
    }
    facets
}

fn ring() -> Vec<Facet> {
    let arcs = [0.0, PI].map(|from| Piece::arc(Vector::from([0.0, 1.0]), 0.4, from, PI));
    Revolution::new(arcs.to_vec()).unwrap().tessellate(18)
}

/// A sound body, one of ten.
fn sound(number: usize) -> Vec<Facet> {
    match number % 10 {
        0 => block([1.0, 1.0, 1.0]),
        1 => block([2.0, 1.0, 0.05]),
        2 => angle_iron(),
        3 => sphere(1.0).unwrap().tessellate(10),
        4 => ring(),
        5 => [block([1.0; 3]), moved(block([0.7; 3]), [2.0, 0.3, 0.0])].concat(),
        6 => [block([1.0; 3]), moved(block([1.0; 3]), [0.55, 0.35, 0.25])].concat(),
        7 => [block([2.0; 3]), turned_round(block([1.0; 3]))].concat(),
        8 => [block([1.0; 3]), moved(block([1.0; 3]), [1.0, 0.0, 0.0])].concat(),
        _ => sphere(1.0).unwrap().tessellate(24),
    }
}

/// Changes to the triangles; each leaves the truth true.
const ON_TRIANGLES: [&str; 9] = [
    "flip",
    "delete",
    "duplicate",
    "duplicate turned",
    "jitter",
    "sliver",
    "split",
    "split one side",
    "scale",
];

fn change(dice: &mut Dice, what: &str, facets: &mut Vec<Facet>, truth: &mut [Facet]) {
    let n = dice.below(facets.len());
    let [a, b, c] = facets[n];
    match what {
        "flip" => {
            for _ in 0..=dice.below(4) {
                let n = dice.below(facets.len());
                facets[n].swap(1, 2);
            }
        }
        "delete" => {
            facets.swap_remove(n);
        }
        "duplicate" => facets.push([b, c, a]),
        "duplicate turned" => facets.push([a, c, b]),
        "jitter" => {
            // Rounding of coordinates, corner by corner.
            let size = 3e-7 * dice.unit();
            for corner in facets.iter_mut().flatten() {
                *corner += dice.around(size);
            }
        }
        "sliver" => {
            // A needle in place of an edge, seen from both sides: its tip lies on the edge.
            let tip = a + dice.unit() * (b - a);
            facets[n] = [tip, b, c];
            facets.push([a, tip, c]);
            facets.push([a, b, tip]);
        }
        "split" => {
            let middle = (a + b + c) / 3.0;
            facets[n] = [a, b, middle];
            facets.push([b, c, middle]);
            facets.push([c, a, middle]);
        }
        "split one side" => {
            let middle = a + (0.2 + 0.6 * dice.unit()) * (b - a);
            facets[n] = [a, middle, c];
            facets.push([middle, b, c]);
        }
        _ => {
            let factor = 10_f64.powf(6.0 * dice.unit() - 3.0);
            let offset = dice.around(20.0 * factor);
            for corner in facets.iter_mut().chain(truth).flatten() {
                *corner = factor * *corner + offset;
            }
        }
    }
}

fn ascii(facets: &[Facet]) -> Vec<u8> {
    let mut text = String::from("solid made by hand\n");
    for facet in facets {
        text += "facet normal 0 0 0\n outer loop\n";
        for p in facet {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  vertex {:e} {:e} {:e}", p[0], p[1], p[2]);
        }
        text += " endloop\nendfacet\n";
    }
    (text + "endsolid\n").into_bytes()
}

/// Body number `number` with up to three defects in its triangles and, now and then, one in its file.
pub fn defective(number: u64) -> Defective {
    let mut dice = Dice(number.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d);
    let mut facets = sound(dice.below(10));
    let mut truth = facets.clone();
    let mut history = Vec::new();
    for _ in 0..=dice.below(3) {
        let what = ON_TRIANGLES[dice.below(ON_TRIANGLES.len())];
        change(&mut dice, what, &mut facets, &mut truth);
        history.push(what);
    }
    for n in (1..facets.len()).rev() {
        facets.swap(n, dice.below(n + 1));
    }
    let text = dice.below(2) == 0;
    let mut bytes = Vec::new();
    if text {
        bytes = ascii(&facets);
    } else {
        write_binary(&mut bytes, &facets).unwrap();
    }
    let mut damaged = false;
    let in_file = [
        "none",
        "none",
        "none",
        "truncate",
        "not a number",
        "wrong count",
        "solid",
        "noise",
    ];
    let what = in_file[dice.below(in_file.len())];
    match what {
        "truncate" => {
            // What comes after the last triangle may go without harm.
            bytes.truncate(1 + dice.below(bytes.len() - 12));
            damaged = true;
        }
        "not a number" if text => {
            let place = bytes.windows(7).rposition(|w| w == b"vertex ").unwrap() + 7;
            bytes.splice(place..=place, *b"nan");
            damaged = true;
        }
        "not a number" => {
            let place = 84 + 50 * dice.below(facets.len()) + 12 + 4 * dice.below(9);
            bytes[place..place + 4].copy_from_slice(&f32::NAN.to_le_bytes());
            damaged = true;
        }
        "wrong count" if !text => {
            let count = facets.len() as u32 + 1 + dice.below(1000) as u32;
            bytes[80..84].copy_from_slice(&count.to_le_bytes());
            damaged = true;
        }
        "solid" if !text => bytes[..17].copy_from_slice(b"solid from a tool"),
        "noise" => {
            // One bit anywhere: it may do any harm, or none.
            let place = dice.below(bytes.len());
            bytes[place] ^= 1 << dice.below(8);
        }
        _ => {}
    }
    history.push(what);
    Defective {
        bytes,
        truth,
        history,
        damaged,
    }
}
