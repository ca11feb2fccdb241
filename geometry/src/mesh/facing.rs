//! Which side of each closed part of the surface the solid is on: inside of it, or, around a cavity,
//! outside.

use rayon::prelude::*;

use super::edges::parts;
use super::nest::{Fate, Nest, Part};
use super::openings::Caps;
use super::weld::{Indexed, bounds};
use super::winding::OFF_SKIN;
use crate::error::{GeometryError, THICKEN, WRAP, no_volume};

/// A wall without thickness is lost without harm if the square root of its area is below this part of
/// the body's diagonal.
const SLIGHT: f64 = 0.02;

/// Turns whole parts that are inside out, and drops those without thickness inside of others. `caps`
/// close what was open: they have to be inside of other parts, unless holes are to be filled.
pub(super) fn settle(
    mesh: &mut Indexed,
    across: &[[u32; 3]],
    turned: &[bool],
    (caps, fill): (&Caps, bool),
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
    if caps.is_empty() && parts.iter().all(sound) {
        return Ok(());
    }
    let mut fates = vec![Fate::Outwards; count];
    if count > 1 || !caps.is_empty() {
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
        if !fill {
            caps.settle(&nest, &fates, fill, repairs)?;
        }
        if thin.iter().all(|&thin| thin) {
            return Err(no_volume());
        }
        refuse_bare(&nest, &thin)?;
        if fill {
            caps.settle(&nest, &fates, fill, repairs)?;
        }
    }
    apply(mesh, &part_of, &parts, &fates, repairs);
    Ok(())
}

/// Refuses walls without thickness that are not inside of the solid: they would vanish.
fn refuse_bare(nest: &Nest<'_>, thin: &[bool]) -> Result<(), GeometryError> {
    let numbers: Vec<usize> = (0..thin.len()).filter(|&number| thin[number]).collect();
    let bare: Vec<f64> = numbers
        .par_iter()
        .map(|&number| nest.bare_area(number, thin))
        .collect();
    let mesh = nest.mesh;
    let extent = bounds(
        mesh.facets
            .iter()
            .flatten()
            .map(|&v| mesh.vertices[v as usize]),
    );
    let slight = (SLIGHT * extent.size().norm()).powi(2);
    let largest = (0..numbers.len()).max_by(|&a, &b| bare[a].total_cmp(&bare[b]));
    let Some(largest) = largest.filter(|_| bare.iter().sum::<f64>() > slight) else {
        return Ok(());
    };
    let facet = nest.parts[numbers[largest]].facets[0];
    let [a, b, c] = mesh.corners(mesh.facets[facet as usize]);
    let p = (a + b + c) / 3.0;
    let count = bare.iter().filter(|&&area| area > 0.0).count();
    Err(GeometryError::Surface(format!(
        "has {count} walls without thickness outside of the solid, {:.3e} in area, the largest near \
         ({:.6}, {:.6}, {:.6}); {THICKEN}, {WRAP}",
        bare.iter().sum::<f64>(),
        p.x,
        p.y,
        p.z
    )))
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
        let what = if cavities == 1 { "cavity" } else { "cavities" };
        repairs.push(format!("kept {cavities} {what} inside of the solid"));
    }
    if dropped > 0 {
        let mut fate = part_of.iter().map(|&number| fates[number as usize]);
        mesh.facets.retain(|_| fate.next() != Some(Fate::Dropped));
        repairs.push(format!(
            "dropped {dropped} triangles of walls that enclose nothing"
        ));
    }
}
