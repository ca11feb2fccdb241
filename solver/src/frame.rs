//! Snapshots of a run as plain arrays, whatever the dimension: what output and validation read.

use serde::{Deserialize, Serialize};

/// Kinds of particles, as written to the `kind` array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Kind {
    /// Moves by the equations.
    Fluid = 0,
    /// Carries the free stream towards the domain.
    Inlet = 1,
    /// Has left through an outlet; its state is frozen.
    Outlet = 2,
    /// Fixed to a body or a wall.
    Ghost = 3,
}

/// All particles at one time; arrays of equal length, missing axes are zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Time.
    pub time: f64,
    /// Positions.
    pub position: Vec<[f64; 3]>,
    /// Velocities.
    pub velocity: Vec<[f64; 3]>,
    /// Densities.
    pub density: Vec<f64>,
    /// Pressures.
    pub pressure: Vec<f64>,
    /// Specific internal energies.
    pub energy: Vec<f64>,
    /// Mach numbers.
    pub mach: Vec<f64>,
    /// Smoothing lengths.
    pub smoothing_length: Vec<f64>,
    /// Volumes: area in the plane, length on a line, whole rings about an axis.
    pub volume: Vec<f64>,
    /// [`Kind`] as a number.
    pub kind: Vec<u8>,
    /// Number that a particle keeps for life.
    pub id: Vec<u64>,
    /// What only some flows have.
    pub extra: ExtraColumns,
}

/// What only some flows have of each particle: empty of others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExtraColumns {
    /// Spacing of the points around each, of points that stay.
    pub spacing: Vec<f64>,
    /// One where it is of the second of two gases.
    pub second: Vec<u8>,
}

impl ExtraColumns {
    fn chosen(&self, chosen: &[usize]) -> Self {
        Self {
            spacing: pick_any(&self.spacing, chosen),
            second: pick_any(&self.second, chosen),
        }
    }
}

impl Frame {
    /// Makes room for so many points that stay.
    pub(crate) fn reserve_exact(&mut self, count: usize) {
        self.position.reserve_exact(count);
        self.velocity.reserve_exact(count);
        for column in [
            &mut self.density,
            &mut self.pressure,
            &mut self.energy,
            &mut self.mach,
            &mut self.smoothing_length,
            &mut self.volume,
            &mut self.extra.spacing,
        ] {
            column.reserve_exact(count);
        }
        self.kind.reserve_exact(count);
        self.id.reserve_exact(count);
    }

    /// The same as [`Self::chosen`] where this frame is not needed any more: nothing is copied where all are chosen.
    #[must_use]
    pub fn only(self, is_chosen: impl Fn(u8) -> bool) -> Self {
        if self.kind.iter().all(|&kind| is_chosen(kind)) {
            self
        } else {
            self.chosen(is_chosen)
        }
    }

    /// The particles whose kind, a number as in [`Frame::kind`], is one that is chosen.
    #[must_use]
    pub fn chosen(&self, is_chosen: impl Fn(u8) -> bool) -> Self {
        let chosen: Vec<usize> = (0..self.kind.len())
            .filter(|&i| is_chosen(self.kind[i]))
            .collect();
        Self {
            time: self.time,
            position: pick(&self.position, &chosen),
            velocity: pick(&self.velocity, &chosen),
            density: pick(&self.density, &chosen),
            pressure: pick(&self.pressure, &chosen),
            energy: pick(&self.energy, &chosen),
            mach: pick(&self.mach, &chosen),
            smoothing_length: pick(&self.smoothing_length, &chosen),
            volume: pick(&self.volume, &chosen),
            kind: pick(&self.kind, &chosen),
            id: pick(&self.id, &chosen),
            extra: self.extra.chosen(&chosen),
        }
    }
}

fn pick<T: Copy>(values: &[T], chosen: &[usize]) -> Vec<T> {
    chosen.iter().map(|&i| values[i]).collect()
}

/// The same of a column that may be empty.
fn pick_any<T: Copy>(values: &[T], chosen: &[usize]) -> Vec<T> {
    if values.is_empty() {
        Vec::new()
    } else {
        pick(values, chosen)
    }
}

/// State on the bodies' surfaces, one point per wall-layer ghost.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceFrame {
    /// Time.
    pub time: f64,
    /// Closest points on the surface.
    pub position: Vec<[f64; 3]>,
    /// Unit normals out of the body.
    pub normal: Vec<[f64; 3]>,
    /// Wall pressure.
    pub pressure: Vec<f64>,
    /// `(p - p_inf) / (rho_inf u_inf^2 / 2)`.
    pub pressure_coefficient: Vec<f64>,
    /// Areas that the pressures hold on, of points that stay: lengths in the plane, whole rings about an axis; empty of particles.
    pub area: Vec<f64>,
    /// Number of the body, in scene order.
    pub body: Vec<u32>,
}

/// The surfaces themselves with the state on them: segments in the plane (of the meridian about an axis), triangles in space,
/// points on a line. Forces are the sum of `(friction - pressure normal) area`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PanelFrame {
    /// Time.
    pub time: f64,
    /// Corners of each panel: as many as there are dimensions.
    pub corners: usize,
    /// The corners, panel by panel.
    pub points: Vec<[f64; 3]>,
    /// Unit normals out of the body.
    pub normal: Vec<[f64; 3]>,
    /// Areas: lengths in the plane, whole rings about an axis.
    pub area: Vec<f64>,
    /// Wall pressure.
    pub pressure: Vec<f64>,
    /// `(p - p_inf) / (rho_inf u_inf^2 / 2)`.
    pub pressure_coefficient: Vec<f64>,
    /// Force per area that no pressure makes.
    pub friction: Vec<[f64; 3]>,
    /// Mach number of the gas in front.
    pub mach: Vec<f64>,
    /// Number of the body, in scene order; wall sides after.
    pub body: Vec<u32>,
    /// What heat does; of viscous gas alone.
    pub heat: HeatColumns,
    /// Of what the domain holds of each body, then of each wall side, the force in the friction that is spread over panels because
    /// nobody can tell which of them bears it; empty where there is none.
    pub spread: Vec<[f64; 3]>,
}

/// What heat does on each panel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeatColumns {
    /// Heat that goes from it into the gas, per area and time.
    pub flux: Vec<f64>,
    /// Temperature of the gas on it.
    pub temperature: Vec<f64>,
}

impl PanelFrame {
    /// The middle of panel `n`.
    pub fn middle(&self, n: usize) -> [f64; 3] {
        let corners = &self.points[n * self.corners..(n + 1) * self.corners];
        let sum = |k: usize| corners.iter().map(|corner| corner[k]).sum::<f64>();
        std::array::from_fn(|k| sum(k) / self.corners as f64)
    }
}

/// What the cells about points that stay look like, in the plane (of the meridian about an axis) or in space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CellFrame {
    /// Number of dimensions.
    pub dimension: usize,
    /// One piece for each cell, in their order; more where a thin part of a body divides what a cell holds.
    pub pieces: Vec<CellPiece>,
}

/// A connected piece of a cell.
#[derive(Clone, Debug, PartialEq)]
pub struct CellPiece {
    /// Number of the cell, and of its point in a frame of all points.
    pub cell: u32,
    /// Its shape.
    pub look: Look,
}

/// Shape of a piece of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Look {
    /// A box of the lattice, from its lowest to its highest corner.
    Block([[f64; 3]; 2]),
    /// In the plane the polygon that it is, gas to the left; in space those that bound it, seen from without.
    Rings(Vec<Vec<[f64; 3]>>),
}

/// Force and moment of the gas on one body, missing axes zero (per metre of span in 2D, per
/// square metre in 1D).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Force.
    pub force: [f64; 3],
    /// Moment about the body's moment centre.
    pub moment: [f64; 3],
    /// What of the force viscosity makes: friction. None of gas without.
    pub friction: [f64; 3],
    /// Heat that goes from it into the gas per time.
    pub heat: f64,
}

/// Conserved totals over the fluid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Totals {
    /// Mass.
    pub mass: f64,
    /// Momentum.
    pub momentum: [f64; 3],
    /// Internal plus kinetic energy.
    pub energy: f64,
}
