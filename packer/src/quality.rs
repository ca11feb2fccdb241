//! Measures how good a packing is.

use aero_geometry::Vector;
use aero_geometry::kernel::SMOOTHING_RATIO;

use crate::cover::cover;
use crate::finish::Finished;
use crate::fluid::Fluid;
use crate::gaps::LEAST_GAP;
use crate::mirror::{Mirrors, reflect};
use crate::nearest::Nearest;
use crate::plan::Plan;
use crate::sources::Sources;
use crate::surface::Sample;
use crate::thinnest::Thinnest;
use crate::{About, Ghosts, PackReport, Warning};

/// Ghosts nearer than this, in spacings, to those of parts thinner than two spacings are beside a thin part.
const NEAR_ROWS: f64 = 2.0;

/// What is measured.
pub(crate) struct Quality<'a, const D: usize> {
    /// Frame of the packing.
    pub plan: &'a Plan<'a, D>,
    /// All ghosts, those just outside the region included.
    pub ghosts: &'a Finished<D>,
    /// Numbers of the ghosts inside.
    pub kept: &'a [usize],
}

impl<const D: usize> Quality<'_, D> {
    /// The report on the ghosts alone.
    pub fn of_ghosts(
        &self,
        target: &Sources<D>,
        surface: &[Sample<D>],
        thinnest: Option<Thinnest>,
    ) -> PackReport {
        let plan = self.plan;
        let all = &self.ghosts.all;
        let spacing = plan.options.spacing;
        let mut layer_counts = vec![0; plan.options.layers];
        for &n in self.kept {
            layer_counts[(all.layer[n] as usize).min(plan.options.layers - 1)] += 1;
        }
        let wall = |&&n: &&usize| all.layer[n] == 0 && !self.ghosts.thin[n];
        let wall_offset_max = self
            .kept
            .iter()
            .filter(wall)
            .map(|&n| (all.distance[n] + 0.5 * spacing).abs() / spacing)
            .fold(0.0, f64::max);
        let sources = self.sources([]);
        let errors = self.at_wall(all, &sources, |points, smoothing| {
            let folded: Vec<Vector<D>> = points.iter().map(|p| plan.mirrors.folded(*p)).collect();
            target.densities(&folded, smoothing)
        });
        let (density_max_percent, density_max_at) = self.worst(&errors);
        let away = self.away_from_rows();
        let (density_std_percent, _) = spread(
            &errors
                .iter()
                .zip(away)
                .filter(|entry| entry.1)
                .map(|entry| *entry.0)
                .collect::<Vec<_>>(),
        );
        let thin = self.kept.iter().filter(|&&n| self.ghosts.thin[n]).count();
        let positions: Vec<Vector<D>> = self.kept.iter().map(|&n| all.position[n]).collect();
        let above: Vec<Vector<D>> = particles(all)
            .map(|(point, _)| point)
            .filter(|point| plan.mirrors.above(point))
            .collect();
        let cover = cover(plan, surface, &above).unwrap_or_default();
        let gaps = sources.nearest(&positions, 2.0 * spacing, true);
        let close = |&&gap: &&f64| gap < LEAST_GAP * (1.0 - 1e-9) * spacing;
        PackReport {
            spacing,
            uncovered_area_percent: cover.uncovered_percent,
            hole_max: cover.hole,
            hole_at: cover.hole_at,
            surface_area: cover.area,
            volume_error_percent: self.whole_volume_error(surface),
            coincident_ghosts: gaps.iter().filter(close).count(),
            ghosts: self.kept.len(),
            layer_counts,
            density_std_percent,
            density_max_percent,
            density_max_at,
            shell_volume_error_percent: self.volume_error(),
            wall_offset_max,
            min_gap: least(&gaps) / spacing,
            layer_hole_max: self.largest_hole(),
            thin,
            mirror_error_max: self.mirror_error(&positions),
            warnings: thinnest.map(|found| found.warning()).into_iter().collect(),
            ..PackReport::default()
        }
    }

    /// Replaces the density figures by those over both sides.
    pub fn of_both(&self, all_fluid: &Ghosts<D>, fluid: &Fluid<'_, D>, report: &mut PackReport) {
        let volume = fluid.plan.particle_volume();
        let mut lattice: Vec<(Vector<D>, f64)> = Vec::new();
        for &site in &fluid.lattice {
            lattice.push((site, volume));
            let mirrors = &fluid.plan.mirrors;
            mirrors.images(&site, |_, image| lattice.push((image, volume)));
        }
        let sources = self.sources(particles(all_fluid).chain(lattice));
        let one = |points: &[Vector<D>], _: f64| vec![1.0; points.len()];
        let mut errors = self.at_wall(&self.ghosts.all, &sources, one);
        errors.extend(self.at_wall(all_fluid, &sources, one));
        (report.density_std_percent, report.density_max_percent) = spread(&errors);
        if fluid.plan.mirrors.planes().len() < self.plan.mirrors.planes().len() {
            report.warnings.push(Warning::new(
                About::Symmetry,
                "the lattice is not symmetric about all of the body's mirror planes, nor is the \
                 packed fluid; move the lattice by a quarter of a spacing or less to mend that",
            ));
        }
    }

    /// The ghosts and more; images are among them already.
    fn sources(&self, more: impl IntoIterator<Item = (Vector<D>, f64)>) -> Sources<D> {
        let points = particles(&self.ghosts.all).chain(more);
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

    /// Numbers of the wall ghosts inside the region, in the order of [`Self::at_wall`].
    fn wall(&self) -> impl Iterator<Item = usize> {
        let all = &self.ghosts.all;
        (0..all.position.len()).filter(|&n| all.layer[n] == 0 && self.plan.keeps(&all.position[n]))
    }

    /// The largest of the wall ghosts' errors, per cent, and its place.
    fn worst(&self, errors: &[f64]) -> (f64, Vec<f64>) {
        let all = self.wall().zip(errors);
        let worst = all.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()).then(b.0.cmp(&a.0)));
        worst.map_or((0.0, Vec::new()), |(n, error)| {
            let place = &self.ghosts.all.position[n];
            (100.0 * error.abs(), place.iter().copied().collect())
        })
    }

    /// For each wall ghost whether it is away from the rows of thin parts in space, beside which a whole ghost more or less
    /// decides the density.
    fn away_from_rows(&self) -> Vec<bool> {
        let all = &self.ghosts.all;
        let rows: Vec<Vector<D>> = (0..all.position.len())
            .filter(|&n| D == 3 && self.ghosts.thin[n])
            .map(|n| all.position[n])
            .collect();
        let reach = NEAR_ROWS * self.plan.options.spacing;
        let nearest = Nearest::new(&Mirrors::default(), &rows, reach);
        self.wall()
            .map(|n| nearest.find(&all.position[n], reach, |_| true).is_none())
            .collect()
    }

    /// The ghosts' volume against that of the layers, in per cent.
    fn volume_error(&self) -> f64 {
        let mirrors = &self.plan.mirrors;
        let packed: f64 = particles(&self.ghosts.all)
            .filter(|(point, _)| mirrors.above(point))
            .map(|(point, volume)| volume * self.plan.part_in_region(&point))
            .sum();
        let exact = self.plan.shell_volume;
        100.0 * (packed - exact).abs() / exact
    }

    /// The volume of ghosts and core against that of the body itself, in per cent; against that of the layers where a region cuts the
    /// body off or where its own volume is not known.
    fn whole_volume_error(&self, surface: &[Sample<D>]) -> f64 {
        let plan = self.plan;
        let body = plan.shape.bounds();
        let is_whole = (plan.options.region)
            .is_none_or(|region| region.contains(&body.min) && region.contains(&body.max));
        let exact = plan
            .shape
            .measure()
            .filter(|_| is_whole && !surface.is_empty());
        let Some(exact) = exact else {
            return self.volume_error();
        };
        let copies = 2.0_f64.powi(plan.mirrors.planes().len() as i32);
        let ghosts: f64 = particles(&self.ghosts.all).map(|(_, volume)| volume).sum();
        100.0 * (ghosts + copies * plan.core_volume - exact) / exact
    }

    /// Largest distance from a place on the wall layer's middle to the nearest ghost, in spacings.
    fn largest_hole(&self) -> f64 {
        let plan = self.plan;
        let spacing = plan.options.spacing;
        let level = plan.level(0);
        let places: Vec<Vector<D>> = plan
            .wall_cells()
            .flat_map(|cell| {
                // A few places around the centre, brought onto the level's plane.
                (0..1_usize << D).map(move |n| {
                    let quarter = 0.25 * cell.step;
                    let off =
                        Vector::<D>::from_fn(
                            |k, _| if n >> k & 1 == 1 { quarter } else { -quarter },
                        );
                    let distance = cell.distance + off.dot(&cell.normal);
                    cell.centre + off - (distance - level) * cell.normal
                })
            })
            .filter(|place| plan.keeps(place))
            .collect();
        let mirrors = &plan.mirrors;
        let ghosts = particles(&self.ghosts.all).filter(|(point, _)| mirrors.above(point));
        let sources = Sources::new(mirrors, ghosts, 2.0 * spacing);
        let gaps = sources.nearest(&places, 2.0 * spacing, false);
        gaps.into_iter().fold(0.0, f64::max) / spacing
    }

    /// Largest distance from a ghost's mirror image to the nearest ghost, in spacings, over the
    /// planes.
    fn mirror_error(&self, positions: &[Vector<D>]) -> Option<f64> {
        let spacing = self.plan.options.spacing;
        let planes = self.plan.mirrors.planes();
        let sources = self.sources([]);
        planes
            .iter()
            .map(|&(axis, position)| {
                let images: Vec<Vector<D>> = positions
                    .iter()
                    .map(|point| {
                        let mut image = *point;
                        image[axis] = reflect(image[axis], position);
                        image
                    })
                    .collect();
                let errors = sources.nearest(&images, spacing, false);
                errors.into_iter().fold(0.0, f64::max) / spacing
            })
            .reduce(f64::max)
    }
}

fn particles<const D: usize>(set: &Ghosts<D>) -> impl Iterator<Item = (Vector<D>, f64)> {
    set.position.iter().copied().zip(set.volume.iter().copied())
}

/// Standard deviation and largest absolute value, in per cent.
fn spread(errors: &[f64]) -> (f64, f64) {
    let count = errors.len().max(1) as f64;
    // From zero: the empty sum of floats is -0.
    let mean = errors.iter().fold(0.0, |sum, e| sum + e) / count;
    let variance = errors.iter().fold(0.0, |sum, e| sum + (e - mean).powi(2)) / count;
    let largest = errors.iter().fold(0.0, |l: f64, e| l.max(e.abs()));
    (100.0 * variance.sqrt(), 100.0 * largest)
}

fn least(values: &[f64]) -> f64 {
    values.iter().fold(f64::INFINITY, |a, &b| a.min(b))
}
