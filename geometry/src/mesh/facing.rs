//! Which side of each closed part of the surface the solid is on: inside of it, or, around a cavity,
//! outside.

use rayon::prelude::*;

use super::edges::parts;
use super::nest::{Fate, Nest, Part};
use super::weld::Indexed;
use super::winding::OFF_SKIN;
use crate::error::{GeometryError, no_volume};

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
