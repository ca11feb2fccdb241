//! What moments of a body are about.

use std::str::FromStr;

use aero_geometry::{Bounds, Shape, Vector};

/// A point that moments are about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Centre {
    /// Behind the nose, m.
    pub behind: f64,
    /// Above the middle of the body's box and to the left of it, m; as the body's volume lies if none.
    pub across: Option<[f64; 2]>,
}

impl FromStr for Centre {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let refused =
            || format!("`{text}` is no point; write X or X,Y,Z in m, as 1.2 or 1.2,0,0.1");
        let number = |part: &str| part.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        let (behind, across) = match numbers.as_deref() {
            Some(&[x]) => (x, None),
            Some(&[x, y, z]) => (x, Some([y, z])),
            _ => return Err(refused()),
        };
        Ok(Self { behind, across })
    }
}

/// Where the middle of the volume lies across the body, as far as planes of symmetry, `mirrors` across these axes, leave that open.
pub(super) fn axis(shape: &dyn Shape<3>, bounds: &Bounds<3>, mirrors: &[usize]) -> [f64; 2] {
    /// Less, in parts of the length, is round-off of files.
    const LEAST: f64 = 1e-4;
    let (mut volume, mut sum) = (0.0, Vector::<3>::zeros());
    for [a, b, c] in shape.facets(f64::INFINITY, bounds) {
        // Of the tetrahedron over the triangle, from the origin, six times.
        let six = a.dot(&b.cross(&c));
        volume += six;
        sum += (a + b + c) * (0.25 * six);
    }
    [1, 2].map(|k| {
        let place = sum[k] / volume;
        let is_there = place.abs() > LEAST * bounds.size()[0] && !mirrors.contains(&k);
        if is_there && place.abs() < 0.5 * bounds.size()[k] {
            place
        } else {
            0.0
        }
    })
}

#[cfg(test)]
mod tests {
    use aero_geometry::{Mesh, Placed, bodies};

    use super::*;

    #[test]
    fn a_fin_does_not_shift_the_axis_much_and_a_centre_is_one_number_or_three() {
        let body = bodies::sphere(0.5).unwrap().tessellate(24);
        let fin = bodies::sphere(0.05).unwrap().tessellate(12);
        let fin = fin
            .into_iter()
            .map(|f| f.map(|p| p + Vector::<3>::new(0.0, 0.52, 0.0)));
        let mesh = Mesh::from_facets(body.into_iter().chain(fin).collect()).unwrap();
        let shifted = Placed::new(
            mesh,
            aero_geometry::Placement::default().moved(Vector::<3>::new(0.0, -0.035, 0.0)),
        );
        let bounds = shifted.bounds();
        let [up, left] = axis(&shifted, &bounds, &[2]);
        assert!((up + 0.035).abs() < 2e-3 && left == 0.0, "{up} {left}");
        let read = |text: &str| text.parse::<Centre>();
        assert_eq!(read("1.5").unwrap().across, None);
        assert_eq!(read("1.5,0,-0.1").unwrap().across, Some([0.0, -0.1]));
        for text in ["1,2", "nan", "", "1,2,3,4"] {
            assert!(read(text).unwrap_err().contains("X,Y,Z"), "{text}");
        }
    }
}
