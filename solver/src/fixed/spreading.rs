//! What thins waves out that leave a stream faster than sound about an axis, beyond the side around it.
//!
//! What they leave behind goes on coming back in from there, and beyond the side the stream is turned by it.
//!
//! [Bayliss & Turkel 1980, Commun. Pure Appl. Math. 33, 707-725: waves of a cylinder in time, here along the stream]

use super::FixedSimulation;
use super::beyond::Beyond;
use super::cells::{Cells, RADIAL};
use super::given::standing;
use super::state::{Primitive, dot};
use crate::problem::{Problem, Side};

/// The stream is turned by this part at most of the angle that Mach lines have in it: beyond, changes are not small.
const MOST: f64 = 0.5;

/// The side around the axis.
#[derive(Clone, Debug)]
pub struct Spreading<const D: usize> {
    /// Block of the cell of each of its faces and the face's number there, along the stream.
    faces: Vec<(usize, usize)>,
    stream: Primitive<D>,
    radius: f64,
    /// The most that the stream is turned by, radians.
    most: f64,
}

impl<const D: usize> Spreading<D> {
    /// That of `problem` on `cells`; none of a stream slower than sound, or that nothing is free around.
    pub fn of(problem: &Problem<D>, cells: &Cells<D>) -> Option<Self> {
        let domain = &problem.domain;
        let place = (RADIAL, 1);
        let mut openings = domain.openings.iter();
        let is_own = openings.any(|opening| (opening.axis, opening.end) == place);
        let mach = problem.stream_mach();
        if !domain.is_axisymmetric() || is_own || mach <= 1.0 {
            return None;
        }
        if domain.sides[place.0][place.1] != Side::FreeStream {
            return None;
        }
        let stream = Primitive::of(&problem.free_stream);
        let around = standing(cells)
            .filter(|(.., face)| (usize::from(face.axis), usize::from(face.end)) == place);
        let mut faces: Vec<_> = around.collect();
        let along = |face: &super::cells::SideFace<D>| face.centre[0] * stream.velocity[0].signum();
        faces.sort_by(|(.., a), (.., b)| along(a).total_cmp(&along(b)));
        Some(Self {
            faces: faces
                .into_iter()
                .map(|(block, side, _)| (block, side))
                .collect(),
            stream,
            radius: domain.bounds.max[RADIAL],
            most: MOST * (1.0 / mach).asin(),
        })
    }

    /// The stream, turned away from the axis by `angle`.
    fn turned(&self, angle: f64) -> Primitive<D> {
        let (sine, cosine) = angle.clamp(-self.most, self.most).sin_cos();
        let mut turned = self.stream;
        turned.velocity[0] *= cosine;
        turned.velocity[RADIAL] += self.stream.velocity[0].abs() * sine;
        turned
    }
}

impl<const D: usize> FixedSimulation<D> {
    /// Turns the stream beyond the side around the axis by what waves have left behind: `v = U(θ) - φ / (2 r)`, with the potential `φ` that the
    /// stream has lost up to there, `φ = -∫ (p - p_s) / (rho U) dx`.
    pub(super) fn turn_around_axis(&mut self) {
        let Some(spreading) = &self.outside.spreading else {
            return;
        };
        let stream = &spreading.stream;
        let share = 1.0
            / (2.0 * spreading.radius * stream.density * dot(&stream.velocity, &stream.velocity));
        let mut turn = 0.0;
        for &(block, side) in &spreading.faces {
            let side = &mut self.net.blocks[block].sides[side];
            let over = self.columns.states[side.i as usize].pressure - stream.pressure;
            let half = 0.5 * share * over * side.image.share;
            side.beyond = Beyond::Stream(spreading.turned(turn + half));
            turn += 2.0 * half;
        }
    }
}
