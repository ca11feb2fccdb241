//! Measures how good a packing is.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;

use crate::fluid::Fluid;
use crate::mirror::Mirrors;
use crate::plan::Plan;
use crate::sources::Sources;
use crate::{Ghosts, PackReport};

/// What is measured.
pub(crate) struct Quality<'a, const D: usize> {
    /// Frame of the packing.
    pub plan: &'a Plan<'a, D>,
    /// All ghosts, those just outside the region included.
    pub ghosts: &'a Ghosts<D>,
}

impl<const D: usize> Quality<'_, D> {
    /// The report on the ghosts alone, `kept` being those inside the region.
    pub fn of_ghosts(&self, kept: &Ghosts<D>, target: &Sources<D>) -> PackReport {
        let plan = self.plan;
        let spacing = plan.options.spacing;
        let mut layer_counts = vec![0; plan.options.layers];
        for &layer in &kept.layer {
            layer_counts[layer as usize] += 1;
        }
        let exact = plan.shell_volume();
        let packed: f64 = kept.volume.iter().sum();
        let wall = kept.distance.iter().zip(&kept.layer);
        let wall_offset_max = wall
            .filter(|&(_, &layer)| layer == 0)
            .map(|(distance, _)| (distance + 0.5 * spacing).abs() / spacing)
            .fold(0.0, f64::max);
        let sources = self.sources(self.ghosts, []);
        let errors = self.at_wall(self.ghosts, &sources, |points, smoothing| {
            let folded: Vec<Vector<D>> = points.iter().map(|p| plan.mirrors.folded(*p)).collect();
            target.densities(&folded, smoothing)
        });
        let (density_std_percent, density_max_percent) = spread(&errors);
        PackReport {
            spacing,
            ghosts: kept.position.len(),
            layer_counts,
            density_std_percent,
            density_max_percent,
            shell_volume_error_percent: 100.0 * (packed - exact).abs() / exact,
            wall_offset_max,
            min_gap: smallest_gap(kept, spacing),
            ..PackReport::default()
        }
    }

    /// Replaces the density figures by those over both sides.
    pub fn of_both(&self, all_fluid: &Ghosts<D>, fluid: &Fluid<'_, D>, report: &mut PackReport) {
        let volume = fluid.plan.particle_volume();
        let mut lattice: Vec<(Vector<D>, f64)> = Vec::new();
        for &site in &fluid.lattice {
            lattice.push((site, volume));
            fluid
                .plan
                .mirrors
                .images(&site, |_, image| lattice.push((image, volume)));
        }
        let sources = self.sources(self.ghosts, particles(all_fluid).chain(lattice));
        let mut errors = self.at_wall(self.ghosts, &sources, |points, _| vec![1.0; points.len()]);
        errors.extend(self.at_wall(all_fluid, &sources, |points, _| vec![1.0; points.len()]));
        (report.density_std_percent, report.density_max_percent) = spread(&errors);
    }

    /// All of two sets of particles; images are among them already.
    fn sources(
        &self,
        set: &Ghosts<D>,
        more: impl IntoIterator<Item = (Vector<D>, f64)>,
    ) -> Sources<D> {
        let points = particles(set).chain(more);
        Sources::new(&Mirrors::default(), points, self.plan.support())
    }

    /// Summed density less the `wanted` one at the wall particles of `set` inside the region.
    fn at_wall(
        &self,
        set: &Ghosts<D>,
        sources: &Sources<D>,
        wanted: impl Fn(&[Vector<D>], f64) -> Vec<f64>,
    ) -> Vec<f64> {
        let smoothing = SMOOTHING_RATIO * self.plan.options.spacing;
        let wall: Vec<Vector<D>> = (0..set.position.len())
            .filter(|&n| set.layer[n] == 0 && self.plan.keeps(&set.position[n]))
            .map(|n| set.position[n])
            .collect();
        let sums = sources.densities(&wall, smoothing);
        sums.iter()
            .zip(wanted(&wall, smoothing))
            .map(|(sum, wanted)| sum - wanted)
            .collect()
    }
}

fn particles<const D: usize>(set: &Ghosts<D>) -> impl Iterator<Item = (Vector<D>, f64)> {
    set.position.iter().copied().zip(set.volume.iter().copied())
}

/// Standard deviation and largest absolute value, in per cent.
fn spread(errors: &[f64]) -> (f64, f64) {
    let count = errors.len().max(1) as f64;
    let mean = errors.iter().sum::<f64>() / count;
    let variance = errors.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / count;
    let largest = errors.iter().fold(0.0, |l: f64, e| l.max(e.abs()));
    (100.0 * variance.sqrt(), 100.0 * largest)
}

/// Smallest distance between two particles, in spacings; at most two.
fn smallest_gap<const D: usize>(set: &Ghosts<D>, spacing: f64) -> f64 {
    let reach = 2.0 * spacing;
    let sources = Sources::new(&Mirrors::default(), particles(set), reach);
    let gaps = sources.nearest(&set.position, reach);
    gaps.into_iter().fold(reach, f64::min) / spacing
}
