//! Which of many points is nearest.

use aero_geometry::{Pencils, Vector};

use crate::mirror::Mirrors;

/// Points and their images about the mirror planes, sorted for searching.
#[derive(Clone, Debug)]
pub(crate) struct Nearest<const D: usize> {
    /// In the order of the pencils' slots, each with its number; an image has that of its original.
    sorted: Vec<(Vector<D>, u32)>,
    pencils: Pencils<D>,
}

impl<const D: usize> Nearest<D> {
    /// For searches up to about `reach`.
    pub fn new(mirrors: &Mirrors, points: &[Vector<D>], reach: f64) -> Self {
        let mut all: Vec<(Vector<D>, u32)> = Vec::with_capacity(points.len());
        for (n, point) in points.iter().enumerate() {
            all.push((*point, n as u32));
            mirrors.images_within(point, reach, |_, image| all.push((image, n as u32)));
        }
        let places: Vec<Vector<D>> = all.iter().map(|entry| entry.0).collect();
        let pencils = Pencils::new(&places, 0.5 * reach);
        let sorted = pencils.order().iter().map(|&n| all[n as usize]).collect();
        Self { sorted, pencils }
    }

    /// Number and distance of the nearest of the `wanted` points nearer than `reach`; the lowest number of several.
    pub fn find(
        &self,
        centre: &Vector<D>,
        reach: f64,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<(u32, f64)> {
        let mut best: Option<(u32, f64)> = None;
        self.within(centre, reach, |number, _, distance| {
            let nearer = best.is_none_or(|(n, r)| distance < r || distance == r && number < n);
            if nearer && wanted(number) {
                best = Some((number, distance));
            }
        });
        best
    }

    /// Calls `visit` with number, place and distance of every point nearer than `reach`.
    pub fn within(
        &self,
        centre: &Vector<D>,
        reach: f64,
        mut visit: impl FnMut(u32, &Vector<D>, f64),
    ) {
        let (low, high) = (centre.add_scalar(-reach), centre.add_scalar(reach));
        self.pencils.for_each_run(&low, &high, |slots| {
            for (place, number) in &self.sorted[slots] {
                let distance = (place - centre).norm();
                if distance < reach {
                    visit(*number, place, distance);
                }
            }
        });
    }
}
