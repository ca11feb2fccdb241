//! A body seen from afar, its triangles coloured.

use aero_validation::pictures::viridis;

use super::canvas::{Colour, Picture};

/// Triangles with a value each; those without one are grey.
#[derive(Clone, Debug, Default)]
pub struct Skin {
    /// Corners.
    pub corners: Vec<[[f64; 3]; 3]>,
    /// What they are coloured by.
    pub values: Vec<f64>,
}

/// From where it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// To the right of the picture.
    pub right: [f64; 3],
    /// Upwards in it.
    pub up: [f64; 3],
}

impl Eye {
    /// Turned about the vertical, then raised, by degrees, from a look along -z.
    pub fn turned(about: f64, raised: f64) -> Self {
        let (s, c) = about.to_radians().sin_cos();
        let (rs, rc) = raised.to_radians().sin_cos();
        Self {
            right: [c, 0.0, -s],
            up: [-s * rs, rc, -c * rs],
        }
    }

    fn toward(&self) -> [f64; 3] {
        let ([a, b, c], [x, y, z]) = (self.right, self.up);
        [b * z - c * y, c * x - a * z, a * y - b * x]
    }
}

/// A picture and what it spans, to the right and upwards.
#[derive(Clone, Debug)]
pub struct View {
    /// The pixels.
    pub picture: Picture,
    /// From and to, along each axis of the picture.
    pub window: [[f64; 2]; 2],
}

/// Columns of a picture.
const COLUMNS: usize = 720;

/// Rows at most and at least.
const ROWS: [usize; 2] = [120, 620];

/// Room around the body.
const MARGIN: f64 = 0.06;

const WHITE: Colour = [255, 255, 255];

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Draws the skin; colours span `range`.
pub fn draw(skin: &Skin, eye: &Eye, range: [f64; 2]) -> View {
    let toward = eye.toward();
    let seen = |p: &[f64; 3]| [dot(p, &eye.right), dot(p, &eye.up), dot(p, &toward)];
    let mut window = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for corner in skin.corners.iter().flatten() {
        let place = seen(corner);
        for k in 0..2 {
            window[k] = [window[k][0].min(place[k]), window[k][1].max(place[k])];
        }
    }
    let [wide, high] = window.map(|[a, b]| (b - a).max(1e-12));
    let room = MARGIN * wide.max(high);
    let window = window.map(|[a, b]| [a - room, b + room]);
    let (wide, high) = (wide + 2.0 * room, high + 2.0 * room);
    let scale = (COLUMNS as f64 / wide).min(ROWS[1] as f64 / high);
    let rows = ((high * scale) as usize).max(ROWS[0]);
    let size = [2 * ((wide * scale) as usize).max(2), 2 * rows];
    let scale = 2.0 * scale;
    let mut picture = Picture::new(size, WHITE);
    let mut depth = vec![f64::NEG_INFINITY; size[0] * size[1]];
    for (corners, value) in skin.corners.iter().zip(&skin.values) {
        let places = corners.map(|corner| {
            let [x, y, z] = seen(&corner);
            [(x - window[0][0]) * scale, (window[1][1] - y) * scale, z]
        });
        let colour = shaded(corners, &toward, *value, range);
        fill(&mut picture, &mut depth, &places, colour);
    }
    View {
        picture: picture.halved(),
        window,
    }
}

/// The colour of a triangle, darker where it is seen askew.
fn shaded(corners: &[[f64; 3]; 3], toward: &[f64; 3], value: f64, [low, high]: [f64; 2]) -> Colour {
    let [u, v]: [[f64; 3]; 2] =
        [1, 2].map(|n| std::array::from_fn(|k| corners[n][k] - corners[0][k]));
    let normal = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let size = dot(&normal, &normal).sqrt().max(f64::MIN_POSITIVE);
    let light = 0.62 + 0.38 * (dot(&normal, toward) / size).abs();
    let colour = if value.is_finite() {
        viridis((value - low) / (high - low).max(f64::MIN_POSITIVE))
    } else {
        [190, 195, 205]
    };
    colour.map(|c| (f64::from(c) * light) as u8)
}

/// Fills a triangle where nothing nearer is.
fn fill(picture: &mut Picture, depth: &mut [f64], [a, b, c]: &[[f64; 3]; 3], colour: Colour) {
    let double = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if double == 0.0 {
        return;
    }
    let range = |k: usize| {
        let low = a[k].min(b[k]).min(c[k]).max(0.0) as usize;
        let high = a[k]
            .max(b[k])
            .max(c[k])
            .ceil()
            .clamp(0.0, picture.size[k] as f64) as usize;
        low..high
    };
    let side = |u: &[f64; 3], v: &[f64; 3], p: [f64; 2]| {
        ((v[0] - u[0]) * (p[1] - u[1]) - (v[1] - u[1]) * (p[0] - u[0])) / double
    };
    for y in range(1) {
        for x in range(0) {
            let p = [x as f64 + 0.5, y as f64 + 0.5];
            let [wa, wb, wc] = [side(b, c, p), side(c, a, p), side(a, b, p)];
            // A hair over the edge, so that no gaps show between neighbours.
            if wa.min(wb).min(wc) < -1e-9 {
                continue;
            }
            let z = wa * a[2] + wb * b[2] + wc * c[2];
            let place = y * picture.size[0] + x;
            if z > depth[place] {
                depth[place] = z;
                picture.pixels[place] = colour;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_triangle_hides_the_farther() {
        let at = |z: f64| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
        let skin = Skin {
            corners: vec![at(1.0), at(0.0)],
            values: vec![1.0, 0.0],
        };
        let eye = Eye {
            right: [1.0, 0.0, 0.0],
            up: [0.0, 1.0, 0.0],
        };
        let view = draw(&skin, &eye, [0.0, 1.0]);
        let [columns, rows] = view.picture.size;
        let middle = view.picture.pixels[(rows * 6 / 10) * columns + columns * 4 / 10];
        assert_eq!(middle, viridis(1.0));
    }
}
