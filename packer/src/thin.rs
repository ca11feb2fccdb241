//! Parts too thin for their layers, by volume: gaps between walls, and in the plane what deeper layers of ghosts leave between them.
//!
//! Where a part is thinner than both sides' layers together, the middle levels are crowded or do
//! not exist. There, a front sweeps over the part and sets a particle wherever enough of the ideal density is
//! missing, as many as the volume holds; relaxation then spaces them.

use std::collections::HashMap;

use aero_geometry::kernel::{QuinticSpline, SUPPORT};
use aero_geometry::parallel::prelude::*;
use aero_geometry::{Pencils, Vector};

use crate::cloud::{Cloud, Lock};
use crate::grid::Cell;
use crate::plan::Plan;
use crate::room_across::thickness;
use crate::sources::Sources;

/// Smoothing length, in spacings, of the density whose lack decides where a particle goes.
const SMOOTHING: f64 = 1.0;

/// Below this thickness, in spacings, one row of particles suits a part better than two: its cells
/// are nearer to squares.
const ONE_ROW: f64 = std::f64::consts::SQRT_2;

/// A particle nearer than this to a mirror plane, in spacings, is put on it.
const ONTO_PLANE: f64 = 0.35;

/// Particles in thin parts start at least this far apart, in spacings.
const APART: f64 = 0.6;

/// Halvings in the search for the demand that uses up the volume.
const HALVINGS: usize = 24;

/// Reach, in spacings, of the neighbourhood whose thickest place counts.
const NEIGHBOURHOOD: f64 = 2.5;

/// Adds particles in the thin parts until `volume` is used up. `wanted(points, smoothing)` is
/// the density aimed at, `placed` what contributes to it already.
pub(crate) fn fill_thin<const D: usize>(
    plan: &Plan<'_, D>,
    cloud: &mut Cloud<D>,
    volume: f64,
    placed: &Sources<D>,
    wanted: impl Fn(&[Vector<D>], f64) -> Vec<f64>,
) {
    if volume < 0.5 * plan.particle_volume() {
        return;
    }
    let mut front = Front::new(plan);
    let spacing = plan.options.spacing;
    let points: Vec<Vector<D>> = front.places.iter().map(|place| place.point).collect();
    let gaps = placed.nearest(&points, SMOOTHING * spacing, false);
    let present = placed.densities(&points, SMOOTHING * spacing);
    let wanted = wanted(&points, SMOOTHING * spacing);
    front.missing = (0..points.len())
        .map(|n| {
            if gaps[n] < APART * spacing {
                f64::NEG_INFINITY
            } else {
                wanted[n] - present[n]
            }
        })
        .collect();
    // The stricter the demand, the fewer particles: halve the interval until the volume fits.
    let (mut low, mut high) = (0.0, 4.0);
    let mut best: (f64, Vec<usize>) = (f64::INFINITY, Vec::new());
    for _ in 0..HALVINGS {
        let demand = 0.5 * (low + high);
        let chosen = front.fill(plan, demand);
        let filled: f64 = chosen.iter().map(|&n| front.places[n].counted).sum();
        if (filled - volume).abs() < (best.0 - volume).abs() {
            best = (filled, chosen);
        }
        if filled > volume {
            low = demand;
        } else {
            high = demand;
        }
    }
    let (filled, chosen) = best;
    for n in chosen {
        let place = &front.places[n];
        // The number is rounded; the volumes make up for it.
        let own = place.volume * volume / filled;
        cloud.push(place.point, place.layer, Lock::Thin, own);
    }
}

/// A place where a particle may start.
#[derive(Clone, Copy, Debug)]
struct Place<const D: usize> {
    point: Vector<D>,
    layer: u32,
    /// Volume of a particle here.
    volume: f64,
    /// The part of it in the packed part of space.
    counted: f64,
}

/// The places of all thin parts in the order in which they are swept, along their longest extent.
struct Front<const D: usize> {
    places: Vec<Place<D>>,
    missing: Vec<f64>,
    pencils: Pencils<D>,
}

impl<const D: usize> Front<D> {
    fn new(plan: &Plan<'_, D>) -> Self {
        let cells = plan.thin_cells();
        let sizes = local_thickness(plan, &cells);
        let mut places: Vec<Place<D>> = cells
            .par_iter()
            .zip(&sizes)
            .filter_map(|(cell, size)| {
                let point = start(plan, cell)?;
                let volume = plan.particle_volume() * (size / plan.options.spacing).clamp(0.1, 1.0);
                Some(Place {
                    point,
                    layer: (cell.distance.abs() / plan.options.spacing).floor() as u32,
                    volume,
                    counted: volume * plan.mirrors.share(&point),
                })
            })
            .collect();
        let mut low = Vector::<D>::repeat(f64::INFINITY);
        let mut high = Vector::<D>::repeat(f64::NEG_INFINITY);
        for place in &places {
            low = low.inf(&place.point);
            high = high.sup(&place.point);
        }
        let longest = (high - low).imax();
        places.sort_by(|a, b| a.point[longest].total_cmp(&b.point[longest]));
        let points: Vec<Vector<D>> = places.iter().map(|place| place.point).collect();
        let pencils = Pencils::new(&points, SUPPORT * SMOOTHING * plan.options.spacing);
        Self {
            places,
            missing: Vec::new(),
            pencils,
        }
    }

    /// Sweeps over the places and takes each at which at least `demand` times what a particle there
    /// adds to its own density is missing.
    fn fill(&self, plan: &Plan<'_, D>, demand: f64) -> Vec<usize> {
        let spacing = plan.options.spacing;
        let smoothing = SMOOTHING * spacing;
        let reach = SUPPORT * smoothing;
        let own_density = QuinticSpline::<D>::value(0.0, smoothing);
        let mut missing = self.missing.clone();
        let mut chosen = Vec::new();
        for (n, place) in self.places.iter().enumerate() {
            if missing[n] < demand * place.volume * own_density {
                continue;
            }
            chosen.push(n);
            let mut take = |source: &Vector<D>| {
                let (low, high) = (source.add_scalar(-reach), source.add_scalar(reach));
                self.pencils.for_each_run(&low, &high, |slots| {
                    for &m in &self.pencils.order()[slots] {
                        let m = m as usize;
                        let r = (self.places[m].point - source).norm();
                        missing[m] -= if r < APART * spacing {
                            f64::INFINITY
                        } else {
                            place.volume * QuinticSpline::<D>::value(r, smoothing)
                        };
                    }
                });
            };
            take(&place.point);
            plan.mirrors
                .images_within(&place.point, reach, |_, image| take(&image));
        }
        chosen
    }
}

/// Where a particle that is put into a thin cell starts: in its middle, or on a mirror plane. Two
/// rows beside a plane keep off it; a single row lies on it.
fn start<const D: usize>(plan: &Plan<'_, D>, cell: &Cell<D>) -> Option<Vector<D>> {
    let spacing = plan.options.spacing;
    let centre = cell.centre;
    let seen = (&centre, cell.distance, &cell.normal);
    // What the layers above leave of the thickness.
    let above = (cell.distance.abs() / spacing).floor() * 2.0 * spacing;
    let across = thickness(plan.shape, seen, above + 2.0 * spacing) - above;
    let mut place = centre;
    for &(axis, position) in plan.mirrors.planes() {
        let height = place[axis] - position;
        let along_plane = cell.normal[axis].abs() > 0.7;
        let one_row = along_plane && across < ONE_ROW * spacing;
        if height < ONTO_PLANE * spacing && along_plane && !one_row {
            return None;
        }
        if one_row && height < 0.5 * across || height < ONTO_PLANE * spacing {
            place[axis] = position;
        }
    }
    Some(place)
}

/// For every thin cell the largest thickness nearby: small throughout a plate, but not at the tip
/// of a wedge.
fn local_thickness<const D: usize>(plan: &Plan<'_, D>, cells: &[Cell<D>]) -> Vec<f64> {
    let spacing = plan.options.spacing;
    let width = NEIGHBOURHOOD * spacing;
    let block = |point: &Vector<D>| -> [i64; D] {
        std::array::from_fn(|k| (point[k] / width).floor() as i64)
    };
    let mut thickest: HashMap<[i64; D], f64> = HashMap::new();
    let thick: Vec<([i64; D], f64)> = plan
        .band
        .par_iter()
        .filter(|cell| plan.is_inside_layers(cell))
        .map(|cell| {
            let centre = cell.centre;
            let seen = (&centre, cell.distance, &cell.normal);
            // Half way through lies the centre of the largest ball that fits in here.
            let half = 0.5 * thickness(plan.shape, seen, spacing) - cell.distance.abs();
            let middle = centre + half * 1.0_f64.copysign(cell.distance) * cell.normal;
            let size = 2.0 * plan.shape.signed_distance(&middle).abs();
            (block(&centre), size.min(spacing))
        })
        .collect();
    for (key, size) in thick {
        let entry = thickest.entry(key).or_insert(0.0);
        *entry = entry.max(size);
    }
    cells
        .iter()
        .map(|cell| {
            let home = block(&cell.centre);
            (0..3_usize.pow(D as u32))
                .filter_map(|code| {
                    let key: [i64; D] = std::array::from_fn(|k| {
                        home[k] + (code / 3_usize.pow(k as u32) % 3) as i64 - 1
                    });
                    thickest.get(&key)
                })
                .fold(0.0, |most: f64, &size| most.max(size))
        })
        .collect()
}
