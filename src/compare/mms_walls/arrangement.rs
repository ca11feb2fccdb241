//! Where gas and ghosts lie: beside a straight wall on a lattice, about a disk and within a ring on a lattice cut in steps or packed.

use std::f64::consts::{PI, TAU};

use aero_geometry::outline::{Outline, Piece};
use aero_geometry::{Bounds, Vector};
use aero_packer::{PackOptions, pack};

use crate::context::CompareError;

/// Layers of ghosts: gradients are asked for at ghosts that reach the gas.
const LAYERS: f64 = 8.0;

/// The wall that is tested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// y = 1, the gas in the unit square below.
    Straight,
    /// The disk inside the ring of gas.
    Convex,
    /// What is around the ring of gas.
    Concave,
}

impl Form {
    /// Radius of a round wall about (1/2, 1/2), m.
    pub const fn radius(self) -> f64 {
        match self {
            Self::Convex => 0.25,
            _ => 0.5,
        }
    }

    /// Signed distance into the gas of this wall, and the unit normal into the gas.
    pub fn height(self, place: &Vector<2>) -> (f64, Vector<2>) {
        let arm = place - Vector::<2>::repeat(0.5);
        match self {
            Self::Straight => (1.0 - place.y, -Vector::<2>::y()),
            Self::Convex => (arm.norm() - self.radius(), arm.normalize()),
            Self::Concave => (self.radius() - arm.norm(), -arm.normalize()),
        }
    }
}

/// A wall and how particles lie beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrangement {
    pub form: Form,
    pub is_packed: bool,
    /// Spacings to the unit of length.
    pub cells: u32,
}

/// How the particles at a wall lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manner {
    /// On a lattice that goes with it.
    Along,
    /// On a lattice that it cuts in steps.
    Steps,
    /// Packed.
    Packed,
}

/// Which ghosts a treatment asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layers {
    /// Several, behind the wall.
    Several,
    /// One, on the wall; the first behind it where that has steps.
    Surface,
    /// Images of the gas.
    Images,
}

/// A ghost of the tested wall.
#[derive(Clone, Copy, Debug)]
pub struct Ghost {
    pub position: Vector<2>,
    /// The nearest point of the wall.
    pub foot: Vector<2>,
    /// Unit normal into the gas.
    pub normal: Vector<2>,
    /// Depth behind the wall, m.
    pub depth: f64,
    /// The particle of gas that it is the image of.
    pub image_of: Option<usize>,
}

/// Particles of gas and ghosts.
#[derive(Clone, Debug)]
pub struct Places {
    pub spacing: f64,
    pub gas: Vec<Vector<2>>,
    /// Ghosts that take the solution.
    pub given: Vec<Vector<2>>,
    /// Ghosts of the wall that is tested, in several layers.
    pub tested: Vec<Ghost>,
    arrangement: Arrangement,
}

impl Places {
    /// The ghosts that a treatment asks for.
    pub fn ghosts(&self, layers: Layers) -> Vec<Ghost> {
        match layers {
            Layers::Several => self.tested.clone(),
            Layers::Images => self.images(),
            Layers::Surface if self.has_steps() => {
                let first = |ghost: &&Ghost| ghost.depth < self.spacing;
                self.tested.iter().filter(first).copied().collect()
            }
            Layers::Surface => self.surface(),
        }
    }

    fn has_steps(&self) -> bool {
        self.arrangement.manner() == Manner::Steps
    }

    fn ghost(&self, position: Vector<2>, image_of: Option<usize>) -> Ghost {
        let (height, normal) = self.arrangement.form.height(&position);
        Ghost {
            position,
            foot: position - height * normal,
            normal,
            depth: -height,
            image_of,
        }
    }

    /// Images of the gas near the tested wall.
    fn images(&self) -> Vec<Ghost> {
        let reach = LAYERS * self.spacing;
        let image = |(n, place): (usize, &Vector<2>)| {
            let (height, normal) = self.arrangement.form.height(place);
            (height < reach).then(|| self.ghost(place - 2.0 * height * normal, Some(n)))
        };
        self.gas.iter().enumerate().filter_map(image).collect()
    }

    /// One ghost per spacing on the tested wall.
    fn surface(&self) -> Vec<Ghost> {
        let form = self.arrangement.form;
        if form == Form::Straight {
            let along = |i: u32| (f64::from(i) + 0.5) * self.spacing;
            return (0..self.arrangement.cells)
                .map(|i| self.ghost(Vector::<2>::new(along(i), 1.0), None))
                .collect();
        }
        let count = (TAU * form.radius() / self.spacing).round() as usize;
        let at = |k: usize| {
            let (sin, cos) = (TAU * k as f64 / count as f64).sin_cos();
            let place = Vector::<2>::repeat(0.5) + form.radius() * Vector::<2>::new(cos, sin);
            self.ghost(place, None)
        };
        (0..count).map(at).collect()
    }
}

impl Arrangement {
    pub fn manner(self) -> Manner {
        match (self.form, self.is_packed) {
            (Form::Straight, _) => Manner::Along,
            (_, false) => Manner::Steps,
            (_, true) => Manner::Packed,
        }
    }

    pub fn name(self) -> &'static str {
        match (self.form, self.is_packed) {
            (Form::Straight, _) => "straight, lattice",
            (Form::Convex, false) => "convex, lattice in steps",
            (Form::Convex, true) => "convex, packed",
            (Form::Concave, false) => "concave, lattice in steps",
            (Form::Concave, true) => "concave, packed",
        }
    }

    /// Lays gas and ghosts.
    ///
    /// # Errors
    /// A spacing that the packer refuses.
    pub fn lay(self) -> Result<Places, CompareError> {
        let spacing = 1.0 / f64::from(self.cells);
        let mut places = Places {
            spacing,
            gas: Vec::new(),
            given: Vec::new(),
            tested: Vec::new(),
            arrangement: self,
        };
        let reach = LAYERS * spacing;
        if self.is_packed {
            let packing = pack(&ring()?, &self.packing())?;
            let begins = packing.lattice_begins.unwrap_or(0.0);
            for place in packing.fluid.position {
                places.add(place, reach);
            }
            for place in lattice(self.cells) {
                if clearance(&place) > begins {
                    places.add(place, reach);
                }
            }
            for place in packing.ghosts.position {
                places.add(place, reach);
            }
        } else {
            for place in lattice(self.cells) {
                places.add(place, reach);
            }
        }
        Ok(places)
    }

    fn packing(self) -> PackOptions<2> {
        PackOptions {
            layers: LAYERS as usize,
            fluid_layers: FLUID_LAYERS,
            region: Some(Bounds {
                min: Vector::<2>::repeat(-MARGIN),
                max: Vector::<2>::repeat(1.0 + MARGIN),
            }),
            ..PackOptions::new(1.0 / f64::from(self.cells))
        }
    }
}

/// Layers of gas that follow the walls.
const FLUID_LAYERS: usize = 4;
/// The lattice and what is packed go so far beyond the unit square: eight spacings of a fortieth.
const MARGIN: f64 = 0.2;

impl Places {
    /// Adds what lies within `reach` of the gas, as what it is.
    fn add(&mut self, place: Vector<2>, reach: f64) {
        let form = self.arrangement.form;
        let (height, _) = form.height(&place);
        if form == Form::Straight {
            let outside = place.map(|x| (-x).max(x - 1.0)).max();
            let beside = (-place.x).max(place.x - 1.0).max(-place.y);
            if outside < 0.0 {
                self.gas.push(place);
            } else if beside > 0.0 && outside < reach {
                self.given.push(place);
            } else if outside < reach {
                self.tested.push(self.ghost(place, None));
            }
            return;
        }
        let clear = clearance(&place);
        if clear > 0.0 {
            self.gas.push(place);
        } else if clear > -reach && height <= 0.0 {
            self.tested.push(self.ghost(place, None));
        } else if clear > -reach {
            self.given.push(place);
        }
    }
}

/// Distance into the ring of gas.
fn clearance(place: &Vector<2>) -> f64 {
    let [inside, outside] = [Form::Convex, Form::Concave].map(|form| form.height(place).0);
    inside.min(outside)
}

/// Sites about the unit square.
fn lattice(cells: u32) -> impl Iterator<Item = Vector<2>> {
    let over = (MARGIN * f64::from(cells)).floor() as i64;
    let count = i64::from(cells);
    let along = move |i: i64| (i as f64 + 0.5) / f64::from(cells);
    (-over..count + over)
        .flat_map(move |i| (-over..count + over).map(move |j| Vector::<2>::new(along(i), along(j))))
}

/// The solid about the ring of gas: a disk, and a square with a round hole, whose outside is out of reach.
fn ring() -> Result<Outline, CompareError> {
    let centre = Vector::<2>::repeat(0.5);
    let circle = |form: Form, sweep: f64| vec![Piece::arc(centre, form.radius(), PI, sweep)];
    let corner = |x: f64, y: f64| centre + Vector::<2>::new(x, y);
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| corner(x, y));
    let side = |k: usize| Piece::segment(corners[k], corners[(k + 1) % 4]);
    Ok(Outline::new(vec![
        (0..4).map(side).collect(),
        circle(Form::Concave, -TAU),
        circle(Form::Convex, TAU),
    ])?)
}
