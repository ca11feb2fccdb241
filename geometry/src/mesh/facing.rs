//! Which side of each closed part of the surface the solid is on: inside of it, or, around a cavity,
//! outside.
//!
//! A part that lies in no other one faces outwards, whatever the file says. One that lies inside of
//! others may be the wall of a cavity or a solid: there the file's orientation tells, and where the
//! file is of two minds the surface is refused.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::edges::parts;
use super::smooth::normal;
use super::tree::Tree;
use super::weld::{Indexed, bounds};
use super::winding::{OFF_SKIN, crossings};
use crate::Vector;
use crate::error::{GeometryError, no_volume};
use crate::stl::Facet;

/// A share of the area that decides beyond doubt.
const CLEAR: f64 = 0.75;

/// Triangles of a part that are asked what is around them.
const PROBES: usize = 24;

/// A connected part of the surface, which is closed.
struct Part {
    facets: Vec<u32>,
    /// Six times what it encloses; below zero where it faces inwards.
    volume: f64,
    area: f64,
    /// Share of its area that was turned against the file to agree with the rest.
    turned: f64,
}

impl Part {
    fn new(mesh: &Indexed, facets: Vec<u32>, turned: &[bool]) -> Self {
        let area = |&f: &u32| mesh.area(mesh.facets[f as usize]);
        // What fills a hole is in no file.
        let was_turned = |f: &&u32| turned.get(**f as usize) == Some(&true);
        let whole: f64 = facets.iter().map(area).sum();
        let part: f64 = facets.iter().filter(was_turned).map(area).sum();
        Self {
            volume: volume(mesh, &facets),
            area: whole,
            turned: part / whole.max(f64::MIN_POSITIVE),
            facets,
        }
    }

    /// Which way it faces in the file: true for inwards, nothing where that is in doubt.
    fn inwards(&self) -> Option<bool> {
        let now = self.volume < 0.0;
        if self.turned <= 1.0 - CLEAR {
            Some(now)
        } else if self.turned >= CLEAR {
            Some(!now)
        } else {
            None
        }
    }
}

/// What becomes of a part.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fate {
    Outwards,
    /// The wall of a cavity.
    Inwards,
    /// It encloses nothing.
    Dropped,
}

/// Turns whole parts that are inside out, and drops those without thickness.
pub(super) fn settle(
    mesh: &mut Indexed,
    across: &[[u32; 3]],
    turned: &[bool],
    repairs: &mut Vec<String>,
) -> Result<(), GeometryError> {
    let (part_of, count) = parts(across);
    let mut lists = vec![Vec::new(); count];
    for (facet, &number) in part_of.iter().enumerate() {
        lists[number as usize].push(facet as u32);
    }
    let parts: Vec<Part> = lists
        .into_iter()
        .map(|facets| Part::new(mesh, facets, turned))
        .collect();
    let flat = |part: &Part| part.volume.abs() <= 12.0 * OFF_SKIN * mesh.tolerance * part.area;
    let sound = |part: &Part| part.volume > 0.0 && part.inwards() == Some(false) && !flat(part);
    if parts.iter().all(sound) {
        return Ok(());
    }
    let mut fates = vec![Fate::Outwards; count];
    if count > 1 {
        let nest = Nest::new(mesh, &part_of, &parts);
        let thin: Vec<bool> = (0..count)
            .into_par_iter()
            .map(|number| flat(&parts[number]) && nest.is_thin(number))
            .collect();
        let judged: Vec<Result<Fate, GeometryError>> = (0..count)
            .into_par_iter()
            .map(|number| nest.judge(number, &thin))
            .collect();
        // In order, so that it is the first refusal that is told.
        fates = judged.into_iter().collect::<Result<_, _>>()?;
        if thin.iter().all(|&thin| thin) {
            return Err(no_volume());
        }
    }
    apply(mesh, &part_of, &parts, &fates, repairs);
    Ok(())
}

fn apply(
    mesh: &mut Indexed,
    part_of: &[u32],
    parts: &[Part],
    fates: &[Fate],
    repairs: &mut Vec<String>,
) {
    let (mut turned, mut cavities, mut dropped) = (0, 0, 0);
    for (part, fate) in parts.iter().zip(fates) {
        match fate {
            Fate::Dropped => dropped += part.facets.len(),
            Fate::Inwards => cavities += 1,
            Fate::Outwards => {}
        }
        if *fate != Fate::Dropped && (part.volume < 0.0) != (*fate == Fate::Inwards) {
            turned += 1;
            for &facet in &part.facets {
                mesh.facets[facet as usize].swap(1, 2);
            }
        }
    }
    if turned > 0 {
        repairs.push(format!(
            "turned {turned} closed parts of the surface that were inside out"
        ));
    }
    if cavities > 0 {
        repairs.push(format!("kept {cavities} cavities inside of the solid"));
    }
    if dropped > 0 {
        let mut fate = part_of.iter().map(|&number| fates[number as usize]);
        mesh.facets.retain(|_| fate.next() != Some(Fate::Dropped));
        repairs.push(format!(
            "dropped {dropped} triangles of walls that enclose nothing"
        ));
    }
}

/// The parts, and what is around them.
struct Nest<'a> {
    mesh: &'a Indexed,
    part_of: &'a [u32],
    parts: &'a [Part],
    tree: Tree,
    order: Vec<u32>,
}

impl<'a> Nest<'a> {
    fn new(mesh: &'a Indexed, part_of: &'a [u32], parts: &'a [Part]) -> Self {
        let (tree, order) = Tree::new(&mesh.vertices, &mesh.facets);
        Self {
            mesh,
            part_of,
            parts,
            tree,
            order,
        }
    }

    fn corners(&self, facet: u32) -> Facet {
        self.mesh.corners(self.mesh.facets[facet as usize])
    }

    /// Some triangles of a part, and points off them on the `side` that their normals lead to.
    fn probes(&self, part: &Part, side: f64) -> Vec<(u32, Vector<3>)> {
        let stride = part.facets.len().div_ceil(PROBES).max(1);
        let facets = part.facets.iter().step_by(stride);
        let point = |&facet: &u32| {
            let [a, b, c] = self.corners(facet);
            let offset = side * OFF_SKIN * self.mesh.tolerance * normal(&[a, b, c]);
            (facet, (a + b + c) / 3.0 + offset)
        };
        facets.map(point).collect()
    }

    /// How many times each wanted part winds around a point.
    fn around(&self, p: &Vector<3>, wanted: impl Fn(u32) -> bool) -> BTreeMap<u32, i32> {
        let owner = |place: u32| self.part_of[self.order[place as usize] as usize];
        let mut times = BTreeMap::new();
        crossings(
            &self.tree,
            p,
            |place| self.corners(self.order[place as usize]),
            |place| wanted(owner(place)),
            |place, side| *times.entry(owner(place)).or_default() += side,
        );
        times.retain(|_, times| *times != 0);
        times
    }

    /// True for a wall given from both sides: there is nothing between its triangles.
    fn is_thin(&self, number: usize) -> bool {
        let own = |part| part == number as u32;
        let part = &self.parts[number];
        [1.0, -1.0].into_iter().all(|side| {
            let mut probes = self.probes(part, side).into_iter();
            probes.all(|(_, p)| self.around(&p, own).is_empty())
        })
    }

    /// What becomes of a part: which way it shall face among those that are not `thin`.
    fn judge(&self, number: usize, thin: &[bool]) -> Result<Fate, GeometryError> {
        if thin[number] {
            return Ok(Fate::Dropped);
        }
        let part = &self.parts[number];
        let wanted = |other: u32| other as usize != number && !thin[other as usize];
        let (mut all, mut inside, mut outermost) = (0.0, 0.0, None);
        // What the part encloses is beside the outside even where it lies on the wall around it.
        for (facet, p) in self.probes(part, -part.volume.signum()) {
            let area = self.mesh.area(self.mesh.facets[facet as usize]);
            let around = self.around(&p, wanted);
            all += area;
            if around.len() % 2 == 1 {
                inside += area;
                let size = |&other: &u32| self.parts[other as usize].volume.abs();
                let largest = around
                    .into_keys()
                    .max_by(|a, b| size(a).total_cmp(&size(b)));
                outermost = outermost.or(largest);
            }
        }
        let Some(outermost) = outermost.filter(|_| inside > (1.0 - CLEAR) * all) else {
            return Ok(Fate::Outwards);
        };
        // A file that was mirrored is inside out as a whole.
        let mirrored = self.parts[outermost as usize].inwards() == Some(true);
        let near = self.corners(part.facets[0]);
        let near = (near[0] + near[1] + near[2]) / 3.0;
        let place = format!("near ({:.6}, {:.6}, {:.6})", near.x, near.y, near.z);
        match part.inwards().map(|inwards| inwards != mirrored) {
            Some(false) => Ok(Fate::Outwards),
            Some(true) if inside >= CLEAR * all => Ok(Fate::Inwards),
            Some(true) => Err(GeometryError::Surface(format!(
                "has a part of {} triangles, one {place}, that faces inwards and lies half inside of \
                 others: cut the pocket out of the solid, or turn that part outwards",
                part.facets.len()
            ))),
            None if inside < CLEAR * all => Ok(Fate::Outwards),
            None => Err(GeometryError::Surface(format!(
                "may be hollow or not: of the {} triangles of an inner part, one {place}, {:.0} % \
                 face the other way than the rest; turn them all inwards for a cavity, outwards for \
                 a solid",
                part.facets.len(),
                100.0 * part.turned.min(1.0 - part.turned)
            ))),
        }
    }
}

/// Six times the volume that a connected part of the surface encloses.
fn volume(mesh: &Indexed, facets: &[u32]) -> f64 {
    let corners = |f: u32| mesh.corners(mesh.facets[f as usize]);
    let bounds = bounds(facets.iter().flat_map(|&f| corners(f)));
    // About a point nearby, lest cancellation eat the digits.
    let middle = 0.5 * (bounds.min + bounds.max);
    let doubled = |&f: &u32| {
        let [a, b, c] = corners(f).map(|v| v - middle);
        a.dot(&b.cross(&c))
    };
    facets.iter().map(doubled).sum()
}
