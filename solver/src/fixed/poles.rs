//! What bodies are to a plane stream slower than sound far away: a vortex, a source and a doublet, see [`super::far_field`].

use aero_geometry::Vector;
use nalgebra::Complex;
use serde::{Deserialize, Serialize};

/// What bodies are to a stream far away: `w = (source + i circulation) / (2 pi z) + doublet / z^2`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Poles {
    /// Of the vortex, clockwise.
    pub circulation: f64,
    /// Gas that it gives, by the speed that it leaves with.
    pub source: f64,
    /// Along the stream and across it.
    pub doublet: [f64; 2],
}

impl Poles {
    /// The change `w` of the velocity at a `place`.
    pub fn turn(&self, place: Complex<f64>) -> Complex<f64> {
        let [along, across] = self.doublet;
        let single = Complex::new(self.source, self.circulation) / std::f64::consts::TAU;
        (single + Complex::new(along, across) / place) / place
    }

    /// Part of the way to `other` ones.
    #[must_use]
    pub fn towards(self, other: Self, part: f64) -> Self {
        let step = |from: f64, to: f64| from + part * (to - from);
        Self {
            circulation: step(self.circulation, other.circulation),
            source: step(self.source, other.source),
            doublet: std::array::from_fn(|k| step(self.doublet[k], other.doublet[k])),
        }
    }
}

/// The stream's own axes.
#[derive(Clone, Copy, Debug)]
pub struct Frame<const D: usize> {
    along: Vector<D>,
    across: Vector<D>,
    /// `sqrt(1 - M^2)`.
    slimmer: f64,
}

impl<const D: usize> Frame<D> {
    pub fn new(along: Vector<D>, mach: f64) -> Self {
        Self {
            along,
            across: left_of(&along),
            slimmer: (1.0 - mach * mach).sqrt(),
        }
    }

    /// `x + i b y` of a way.
    pub fn plane(&self, way: &Vector<D>) -> Complex<f64> {
        Complex::new(self.along.dot(way), self.slimmer * self.across.dot(way))
    }

    /// `w` of a change of the velocity, that along the stream given apart.
    pub fn change(&self, along: f64, velocity: &Vector<D>) -> Complex<f64> {
        Complex::new(along, -self.across.dot(velocity) / self.slimmer)
    }

    pub fn velocity(&self, change: Complex<f64>) -> Vector<D> {
        self.along * change.re - self.across * (self.slimmer * change.im)
    }
}

/// A plane vector turned to the left.
pub fn left_of<const D: usize>(v: &Vector<D>) -> Vector<D> {
    Vector::from_fn(|k, _| [-v[1], v[0]][k.min(1)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const MACH: f64 = 0.6;

    fn along() -> Vector<2> {
        Vector::<2>::new(0.8, 0.6)
    }

    fn velocity(poles: &Poles, arm: &Vector<2>) -> Vector<2> {
        let frame = Frame::new(along(), MACH);
        frame.velocity(poles.turn(frame.plane(arm)))
    }

    const VORTEX: Poles = Poles {
        circulation: 1.0,
        source: 0.0,
        doublet: [0.0; 2],
    };

    const ALL: Poles = Poles {
        circulation: 0.7,
        source: 0.4,
        doublet: [0.9, -0.3],
    };

    #[test]
    fn its_circulation_is_one_clockwise() {
        let count = 2000;
        let around = (0..count).map(|k| {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(count);
            let [tangent, arm] = [angle + 0.5 * std::f64::consts::PI, angle]
                .map(|angle| Vector::<2>::new(angle.cos(), angle.sin()));
            velocity(&VORTEX, &(arm * 3.0)).dot(&tangent) * 3.0
        });
        let circulation = around.sum::<f64>() * std::f64::consts::TAU / f64::from(count);
        assert!((circulation + 1.0).abs() < 1e-12, "{circulation}");
        assert!(
            velocity(&VORTEX, &-along()).dot(&Vector::<2>::new(-0.6, 0.8)) > 0.0,
            "ahead it goes up"
        );
    }

    /// `(1 - M^2) du/ds + dv/dn = 0` of small changes, and no vorticity, along and across the stream.
    #[test]
    fn it_neither_makes_gas_nor_turns_it() {
        let [s, n] = [along(), Vector::<2>::new(-0.6, 0.8)];
        let step = 1e-4;
        for arm in [[2.0, 0.3], [-0.5, 1.7], [0.4, -3.0]].map(Vector::from) {
            let slope = |way: &Vector<2>, of: &Vector<2>| {
                let [after, before] = [step, -step].map(|step| velocity(&ALL, &(arm + way * step)));
                (after - before).dot(of) / (2.0 * step)
            };
            let made = (1.0 - MACH * MACH) * slope(&s, &s) + slope(&n, &n);
            let turned = slope(&s, &n) - slope(&n, &s);
            let size = slope(&s, &s).abs() + slope(&s, &n).abs();
            assert!(made.abs() < 1e-6 * size, "{made}");
            assert!(turned.abs() < 1e-6 * size, "{turned}");
        }
    }

    /// Without compressibility a circle of radius one is a doublet of one: the stream rests before it.
    #[test]
    fn a_circle_is_a_doublet_of_the_square_of_its_radius() {
        let frame = Frame::new(along(), 0.0);
        let poles = Poles {
            doublet: [-1.0, 0.0],
            ..Poles::default()
        };
        let turn = frame.velocity(poles.turn(frame.plane(&-along())));
        assert!((turn + along()).norm() < 1e-15);
    }
}
