//! Where a point is in relation to the domain, and which lattice points lie in the buffers.

use aero_geometry::Vector;

use super::model::{OpenModel, Place};
use super::model_of;
use super::rows::Rows;
use crate::layers::BUFFER;
use crate::problem::{Domain, Given, Opening, Problem, Side, State};

/// Where a point is in relation to the domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// In the domain, or behind a side that is not open.
    Interior,
    /// In the buffer of the open side of this number.
    Beyond(usize),
    /// Past all buffers.
    Outside,
}

/// An open side.
#[derive(Debug)]
pub struct OpenSide<const D: usize> {
    /// Where it is.
    pub place: Place,
    /// How gas crosses it.
    pub model: Box<dyn OpenModel<D>>,
    /// Number of the stream that enters; none where gas only leaves.
    pub stream: Option<usize>,
}

/// All open sides of a domain.
#[derive(Debug)]
pub struct OpenSides<const D: usize> {
    sides: Vec<OpenSide<D>>,
    /// Which ends of each axis have a buffer.
    buffers: [[bool; 2]; D],
    spacing: f64,
    /// The lattice of the gas.
    pub rows: Rows<D>,
}

impl<const D: usize> OpenSides<D> {
    /// Those of `problem`, and the states of the streams that enter at first. Sides that the same gas enters through share a
    /// stream, and so a lattice that has no seam where they meet, unless they answer to the flow inside.
    pub fn new(problem: &Problem<D>) -> (Self, Vec<State<D>>) {
        let mut sides: Vec<OpenSide<D>> = Vec::new();
        let mut streams = Vec::new();
        let mut buffers = [[false; 2]; D];
        for (place, side, given) in crossed(&problem.domain) {
            let Some(model) = model_of(problem, side, place, given) else {
                continue;
            };
            let stream = model.inflow(problem).map(|state| {
                let shared = sides.iter().find(|other| {
                    let same = |number: usize| streams[number] == state;
                    !model.answers() && !other.model.answers() && other.stream.is_some_and(same)
                });
                shared.and_then(|other| other.stream).unwrap_or_else(|| {
                    streams.push(state);
                    streams.len() - 1
                })
            });
            buffers[place.axis][place.end] = true;
            sides.push(OpenSide {
                place,
                model,
                stream,
            });
        }
        let all = Self {
            sides,
            buffers,
            spacing: problem.resolution.lattice(),
            rows: Rows::new(problem),
        };
        (all, streams)
    }

    /// True of a domain that no gas crosses the sides of.
    pub fn is_empty(&self) -> bool {
        self.sides.is_empty()
    }

    /// Open side `number`.
    pub fn side(&self, number: usize) -> &OpenSide<D> {
        &self.sides[number]
    }

    /// All of them.
    pub fn iter(&self) -> std::slice::Iter<'_, OpenSide<D>> {
        self.sides.iter()
    }

    /// The stream whose buffer holds what is in `zone`.
    pub fn stream_at(&self, zone: Zone) -> Option<usize> {
        match zone {
            Zone::Beyond(side) => self.sides[side].stream,
            Zone::Interior | Zone::Outside => None,
        }
    }

    /// True of a position that has gone round the rim of the part `number` of a side, behind the rest of it.
    pub fn is_behind(&self, number: usize, position: &Vector<D>) -> bool {
        let place = &self.sides[number].place;
        !place.faces(position) && place.is_beyond(place.depth(position))
    }

    /// The zone of `position`. Where buffers meet, that of the first side that gas enters through.
    pub fn zone(&self, position: &Vector<D>) -> Zone {
        let buffer = BUFFER as f64 * self.spacing;
        let mut zone = Zone::Interior;
        for (number, side) in self.sides.iter().enumerate() {
            let depth = side.place.depth(position);
            if !side.place.is_beyond(depth) || !side.place.faces(position) {
                continue;
            }
            if depth > buffer {
                return Zone::Outside;
            }
            let is_first_entrance = side.stream.is_some() && self.stream_at(zone).is_none();
            if zone == Zone::Interior || is_first_entrance {
                zone = Zone::Beyond(number);
            }
        }
        zone
    }

    /// First and last lattice index, after a drift, of the domain with its buffers.
    pub fn lattice_range(&self, drift: &Vector<D>) -> ([i64; D], [i64; D]) {
        let mut first = [0; D];
        let mut last = [0; D];
        for k in 0..D {
            let drift = drift[k] / self.rows.pitch(k);
            let cells = self.rows.cells(k);
            let [lower, upper] =
                self.buffers[k].map(|is_there| if is_there { BUFFER as i64 } else { 0 });
            if lower + upper == 0 {
                (first[k], last[k]) = (0, cells);
            } else {
                first[k] = (-drift).floor() as i64 - lower - 1;
                last[k] = (-drift).ceil() as i64 + cells + upper + 1;
            }
        }
        (first, last)
    }

    /// Slabs of lattice indices that cover all buffers after a drift, without overlap.
    pub fn slabs(&self, drift: &Vector<D>) -> Vec<([i64; D], [i64; D])> {
        let (mut first, mut last) = self.lattice_range(drift);
        let mut slabs = Vec::new();
        let depth = BUFFER as i64 + 3;
        for k in 0..D {
            let [lower, upper] = self.buffers[k];
            if lower && first[k] < last[k] {
                let mut end = last;
                end[k] = (first[k] + depth).min(last[k]);
                slabs.push((first, end));
                first[k] = end[k];
            }
            if upper && first[k] < last[k] {
                let mut begin = first;
                begin[k] = (last[k] - depth).max(first[k]);
                slabs.push((begin, last));
                last[k] = begin[k];
            }
        }
        slabs
    }
}

/// Every side of `domain`, each followed by its parts: where it is, its kind, and the state of the gas beyond it if that is given.
fn crossed<const D: usize>(
    domain: &Domain<D>,
) -> impl Iterator<Item = (Place, Side, Option<&Given<D>>)> {
    domain.each_side().flat_map(|(axis, end, side, _)| {
        let own = |opening: &&Opening<D>| (opening.axis, opening.end) == (axis, end);
        let whole = domain
            .openings
            .iter()
            .find(|opening| own(opening) && opening.part.is_none());
        let given = whole.and_then(|whole| whole.given.as_ref());
        let parts = domain.parts(axis, end);
        let parts = parts.map(|part| (Place::of(domain, part), part.side, part.given.as_ref()));
        [(Place::whole(domain, axis, end), side, given)]
            .into_iter()
            .chain(parts)
    })
}
