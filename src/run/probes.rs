//! Probes of a run: what is read at points and through sections beside the history, and along lines beside frames.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;

use aero_geometry::parallel::prelude::*;
use aero_geometry::{Bounds, Vector};

use super::section::{Part, parts};
use super::views::Job;
use crate::case::{Probe, Reach};
use crate::output::{self, OutputError, Reference, Rows};
use crate::sample::{Gas, Scale, Solids, State};
use aero_solver::Flow;

/// So far around a probe gas is asked, in spacings: particles may be further apart than they were.
const AROUND: f64 = 8.0;

/// Columns of a section.
const FLOWS: [&str; 8] = [
    "area",
    "mass_flux",
    "momentum_flux_x",
    "momentum_flux_y",
    "momentum_flux_z",
    "enthalpy_flux",
    "mean_pressure",
    "mean_mach",
];

/// The probes of a run.
#[derive(Debug)]
pub(super) struct Probes<const D: usize> {
    all: Vec<Probe<D>>,
    scale: Scale,
    /// Of those at points and through sections; none where there are none.
    rows: Option<Rows>,
}

impl<const D: usize> Probes<D> {
    /// Those of a run that begins, or goes on after what has been written, as many bytes.
    pub(super) fn new(
        folder: &Path,
        probes: &[Probe<D>],
        reference: &Reference,
        written: Option<u64>,
    ) -> Result<Self, OutputError> {
        let scale = reference.scale();
        let mut header = String::from("step,time");
        let mut has_columns = false;
        for probe in probes {
            let columns = match probe.reach {
                Reach::Point(_) => output::state_columns(&scale),
                Reach::Line(..) => continue,
                Reach::Section(..) => FLOWS.to_vec(),
            };
            has_columns = true;
            for column in columns {
                // Writing to a string cannot fail.
                let _ = write!(header, ",{}.{column}", probe.name);
            }
        }
        let path = folder.join("probes.csv");
        let rows = match written {
            _ if !has_columns => None,
            None => Some(Rows::create(&path, &header)?),
            Some(bytes) => Some(Rows::resume(&path, bytes)?),
        };
        Ok(Self {
            all: probes.to_vec(),
            scale,
            rows,
        })
    }

    /// Length of the table once all rows so far are on disk.
    pub(super) fn bytes(&self) -> u64 {
        self.rows.as_ref().map_or(0, Rows::bytes)
    }

    /// Brings all rows so far to disk.
    pub(super) fn flush(&mut self) -> Result<(), OutputError> {
        self.rows.as_mut().map_or(Ok(()), Rows::flush)
    }

    /// Adds a row of what is now.
    pub(super) fn add(&mut self, flow: &Flow<D>) -> Result<(), OutputError> {
        let Some(rows) = &mut self.rows else {
            return Ok(());
        };
        let mut row = format!("{},{:?}", flow.steps(), flow.time());
        for probe in &self.all {
            match &probe.reach {
                Reach::Point(point) => {
                    let states = read(flow, &[*point]);
                    row += &output::state_row(&self.scale, states[0].as_ref());
                }
                Reach::Line(..) => {}
                Reach::Section(axis, lattice) => {
                    let bodies = &flow.problem().bodies;
                    let solids = Solids::new(bodies, |number| flow.pose(number));
                    let parts = parts(&solids, *axis, lattice);
                    let places: Vec<Vector<D>> = parts.iter().map(|part| part.middle).collect();
                    let states = read(flow, &places);
                    let is_round = flow.problem().domain.is_axisymmetric();
                    for value in flows(&self.scale, *axis, is_round, (&parts, &states)) {
                        let _ = write!(row, ",{value:?}");
                    }
                }
            }
        }
        rows.add(&row)
    }

    /// The lines of frame `number`.
    pub(super) fn lines(&self, folder: &Path, flow: &Flow<D>, number: usize) -> Vec<Job> {
        let lines = self
            .all
            .iter()
            .filter(|probe| matches!(probe.reach, Reach::Line(..)));
        let job = |probe: &Probe<D>| -> Job {
            let places = probe.reach.places();
            let states = read(flow, &places);
            let path = folder.join(format!("line-{}-{number:06}.csv", probe.name));
            let pad = |p: &Vector<D>| std::array::from_fn(|k| if k < D { p[k] } else { 0.0 });
            let places: Vec<[f64; 3]> = places.iter().map(pad).collect();
            let scale = self.scale;
            Box::new(move || output::write_line(&path, &scale, &places, &states))
        };
        lines.map(job).collect()
    }
}

/// The gas at places now; none in bodies.
fn read<const D: usize>(flow: &Flow<D>, places: &[Vector<D>]) -> Vec<Option<State>> {
    let problem = flow.problem();
    let mut bounds = Bounds::new(places[0], places[0]);
    for place in places {
        bounds.min = bounds.min.inf(place);
        bounds.max = bounds.max.sup(place);
    }
    let frame = flow.frame_within(&bounds.grown(AROUND * problem.resolution.lattice()));
    let solids = Solids::new(&problem.bodies, |number| flow.pose(number));
    let gas = Gas::new(&frame, problem, &solids);
    let at = |place: &Vector<D>| {
        let spot = gas.at(place);
        spot.state.filter(|_| spot.is_gas)
    };
    places.par_iter().map(at).collect()
}

/// What flows through a section towards its axis, `int rho u_n`, `int (rho u_n u + p n)`, `int rho u_n H` with
/// `H = gamma / (gamma - 1) p / rho + u^2 / 2`, and means over its area. About an axis all around it; what points away from it cancels.
fn flows<const D: usize>(
    scale: &Scale,
    axis: usize,
    is_round: bool,
    (parts, states): (&[Part<D>], &[Option<State>]),
) -> [f64; 8] {
    let [mut area, mut mass, mut enthalpy, mut pressure, mut mach] = [0.0; 5];
    let mut momentum = [0.0; 3];
    for (part, state) in parts.iter().zip(states) {
        let Some(state) = state else { continue };
        let around = if is_round { TAU * part.middle[1] } else { 1.0 };
        let share = part.area * around;
        let flux = share * state.density * state.velocity[axis];
        let square = state.velocity.iter().map(|u| u * u).sum::<f64>();
        let heat = scale.gas(state).enthalpy(state.density, state.pressure);
        area += share;
        mass += flux;
        enthalpy += flux * (heat + 0.5 * square);
        pressure += share * state.pressure;
        mach += share * scale.mach(state);
        for (k, sum) in momentum.iter_mut().enumerate() {
            *sum += flux * state.velocity[k];
        }
        momentum[axis] += share * state.pressure;
    }
    if is_round {
        momentum[1] = 0.0;
    }
    let [x, y, z] = momentum;
    let mean = |sum: f64| if area > 0.0 { sum / area } else { 0.0 };
    [area, mass, x, y, z, enthalpy, mean(pressure), mean(mach)]
}
