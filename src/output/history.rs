//! `history.csv`: step, time, loads and conserved totals, one row per so many steps.

use std::fmt::Write as _;
use std::path::Path;

use super::body_motion::BodyMotion;
use super::error::OutputError;
use super::rows::Rows;
use super::summary::BodyCoefficients;
use aero_solver::frame::{Load, Totals};

/// One row.
#[derive(Clone, Copy, Debug)]
pub struct HistoryRow<'a> {
    /// Step.
    pub step: u64,
    /// Time after it.
    pub time: f64,
    /// Its length.
    pub dt: f64,
    /// Loads, in the order of the names that the file was made with.
    pub loads: &'a [Load],
    /// Conserved totals of the fluid.
    pub totals: Totals,
    /// Coefficients of the bodies, the first of the names; none in a gas at rest.
    pub coefficients: &'a [Option<BodyCoefficients>],
    /// How the bodies move that the gas moves, in the order of their names.
    pub motions: &'a [BodyMotion],
}

/// A history being written, as [`Rows`] are.
#[derive(Debug)]
pub struct History {
    rows: Rows,
    loads: usize,
    bodies: usize,
}

impl History {
    /// Starts the file with its header; `names` are those of whatever carries a load, the `bodies` first, and `free` those of bodies
    /// that the gas moves.
    pub fn create(
        path: &Path,
        names: &[String],
        bodies: usize,
        free: &[String],
    ) -> Result<Self, OutputError> {
        let mut header = String::from("step,time,dt");
        for name in names {
            for column in ["fx", "fy", "fz", "mx", "my", "mz"] {
                // Writing to a string cannot fail.
                let _ = write!(header, ",{name}.{column}");
            }
        }
        header.push_str(",mass,momentum_x,momentum_y,momentum_z,energy");
        for name in &names[..bodies] {
            let _ = write!(header, ",{name}.cd,{name}.cl,{name}.cm");
        }
        for name in free {
            for column in BodyMotion::COLUMNS {
                let _ = write!(header, ",{name}.{column}");
            }
        }
        Ok(Self {
            rows: Rows::create(path, &header)?,
            loads: names.len(),
            bodies,
        })
    }

    /// Goes on with the file after its first `bytes`; what came later is cut off.
    pub fn resume(
        path: &Path,
        [loads, bodies]: [usize; 2],
        bytes: u64,
    ) -> Result<Self, OutputError> {
        Ok(Self {
            rows: Rows::resume(path, bytes)?,
            loads,
            bodies,
        })
    }

    /// Length of the file once all rows so far are on disk.
    pub fn bytes(&self) -> u64 {
        self.rows.bytes()
    }

    /// Adds a row.
    pub fn add(&mut self, row: HistoryRow<'_>) -> Result<(), OutputError> {
        let mut line = format!("{},{:?},{:?}", row.step, row.time, row.dt);
        let none = Load::default();
        for number in 0..self.loads {
            let load = row.loads.get(number).unwrap_or(&none);
            for value in load.force.iter().chain(&load.moment) {
                let _ = write!(line, ",{value:?}");
            }
        }
        let totals = row.totals;
        let [x, y, z] = totals.momentum;
        for value in [totals.mass, x, y, z, totals.energy] {
            let _ = write!(line, ",{value:?}");
        }
        for number in 0..self.bodies {
            match row.coefficients.get(number) {
                Some(Some(c)) => {
                    let _ = write!(line, ",{:?},{:?},{:?}", c.cd, c.cl, c.cm);
                }
                _ => line.push_str(",,,"),
            }
        }
        for value in row.motions.iter().flat_map(BodyMotion::numbers) {
            let _ = write!(line, ",{value:?}");
        }
        self.rows.add(&line)
    }

    /// Brings all rows so far to disk.
    pub fn flush(&mut self) -> Result<(), OutputError> {
        self.rows.flush()
    }
}
