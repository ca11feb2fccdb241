//! What is shown of the gas between its particles or points, beside every frame.

use std::path::{Path, PathBuf};

use aero_geometry::Vector;
use rayon::prelude::*;

use crate::case::{OutputPlan, RunPlan, Stretch};
use crate::output::{self, Caption, Collection, Mirrors, OutputError, Reference};
use crate::sample::{Field, Gas, Sample, Solids};
use aero_solver::Flow;
use aero_solver::frame::Frame;

/// Points of a curve.
const SAMPLES: usize = 800;

/// Files that wait to be written.
pub(super) type Job = Box<dyn FnOnce() -> Result<(), OutputError> + Send>;

/// Takes the views that a plan asks for.
#[derive(Debug)]
pub(super) struct Views<const D: usize> {
    folder: PathBuf,
    /// Of the scene.
    name: String,
    plan: OutputPlan<D>,
    reference: Reference,
    fields: Collection,
}

impl<const D: usize> Views<D> {
    pub(super) fn new(folder: &Path, plan: &RunPlan<D>, reference: Reference) -> Self {
        Self {
            folder: folder.to_owned(),
            name: plan.name.clone(),
            plan: plan.output.clone(),
            reference,
            fields: Collection::new(folder.join("field.pvd")),
        }
    }

    /// Notes that the views of a frame are there already.
    pub(super) fn note(&mut self, number: usize, time: f64) {
        self.fields.note(time, &field_name(number));
    }

    /// The views of frame `number`, said to show `time`; nothing is computed that no plan asks for.
    pub(super) fn take(&mut self, flow: &Flow<D>, number: usize, time: f64) -> Vec<Job> {
        self.note(number, time);
        if self.plan.field.is_none() && self.plan.picture.is_none() {
            return Vec::new();
        }
        let problem = flow.problem();
        let solids = Solids::new(&problem.bodies, |number| flow.pose(number));
        // Cells that a surface cuts are shown, with all their corners.
        let field = self.plan.field.as_ref();
        let across = field.map_or(0.0, |plan| plan.lattice.spacing.norm());
        let gas = Gas::new(&flow.frame(), problem, &solids).carried_on(across);
        let field = self.field(&gas, number, time);
        let picture = self.picture(&gas, flow, number);
        [field, picture].into_iter().flatten().collect()
    }

    /// How the density changes where `frame`, mirrored as it is shown, has gas; none unless the plan asks for it.
    pub(super) fn gradients(&self, flow: &Flow<D>, frame: &Frame) -> Vec<[f64; 3]> {
        if !self.plan.extras.gradients {
            return Vec::new();
        }
        let mut shown = frame.clone();
        Mirrors(self.plan.mirrors.clone()).apply(&mut shown, None);
        let problem = flow.problem();
        let solids = Solids::new(&problem.bodies, |number| flow.pose(number));
        let gas = Gas::new(&flow.frame(), problem, &solids);
        let gradient = |place: &[f64; 3]| {
            let spot = gas.at(&Vector::from_fn(|k, _| place[k]));
            spot.state.map_or([0.0; 3], |state| state.density_gradient)
        };
        shown.position.par_iter().map(gradient).collect()
    }

    fn field(&self, gas: &Gas<'_, D>, number: usize, time: f64) -> Option<Job> {
        let field = Field::new(gas, &self.plan.field.as_ref()?.lattice);
        let path = self.folder.join(field_name(number));
        let (reference, fields) = (self.reference.clone(), self.fields.clone());
        let is_compressed = self.plan.is_compressed;
        Some(Box::new(move || {
            output::write_field(&path, &field, time, &reference, is_compressed)?;
            fields.write()
        }))
    }

    fn picture(&self, gas: &Gas<'_, D>, flow: &Flow<D>, number: usize) -> Option<Job> {
        let plan = self.plan.picture.as_ref()?;
        let caption = Caption {
            title: format!("{}, {}", self.name, moment(flow, self.reference.is_si())),
            quantity: plan.quantity,
            is_si: self.reference.is_si(),
        };
        let (path, range) = (self.folder.join(picture_name(number)), plan.range);
        let scale = self.reference.scale();
        let value = |place: [f64; 3]| {
            let spot = gas.at(&Vector::from_fn(|k, _| place[k]));
            let value = spot
                .state
                .and_then(|state| scale.value(plan.quantity, &state));
            Sample {
                values: [value.unwrap_or(f64::NAN)],
                is_gas: spot.is_gas,
                clear: spot.clear,
            }
        };
        match &plan.stretch {
            Stretch::Plane(view) => {
                let view = *view;
                let [raster] = view.rasters(value);
                Some(Box::new(move || {
                    output::draw_plane(&path, &caption, &view, &raster, range)
                }))
            }
            Stretch::Line([from, to]) => {
                let place = |n: usize| from + n as f64 / SAMPLES as f64 * (to - from);
                let points = (0..=SAMPLES).map(|n| {
                    let [value] = value([place(n), 0.0, 0.0]).values;
                    [place(n), value]
                });
                let points = points.collect();
                Some(Box::new(move || {
                    output::draw_curve(&path, &caption, points, range)
                }))
            }
        }
    }
}

/// What the clock shows: a time, or iterations of a flow that settles.
fn moment<const D: usize>(flow: &Flow<D>, is_si: bool) -> String {
    if flow.problem().method.settles() {
        return format!("iteration {}", flow.steps());
    }
    let time = flow.time();
    let digits = if time == 0.0 || (1e-2..1e4).contains(&time) {
        format!("{time:.4}")
    } else {
        format!("{time:.4e}")
    };
    format!("t = {digits}{}", if is_si { " s" } else { "" })
}

fn field_name(number: usize) -> String {
    format!("field-{number:06}.vti")
}

fn picture_name(number: usize) -> String {
    format!("picture-{number:06}.png")
}
