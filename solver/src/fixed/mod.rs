//! Gas dynamics on points that stay where they are: cells derived from them, and what flows through their faces.
//!
//! [`FixedSimulation::step`] marches in time, `settle` goes to the steady state. Neither knows how cells are made.

mod adapt;
mod apex;
mod assemble;
mod attached;
mod bend;
mod bends;
mod bent;
mod bent_face;
mod beside;
mod beyond;
mod brinks;
mod build;
mod calmness;
mod cancel;
mod carry;
mod cell_shapes;
mod cells;
mod chain;
mod checkpoint;
mod closed_in;
mod cloud;
mod cloven;
mod columns;
mod cone_cells;
mod cone_field;
mod cone_rings;
mod conical;
mod cornered;
mod crests;
mod cut;
mod cut_cell;
mod drawing;
mod edge;
mod edges;
mod energy;
mod equation_of_state;
mod even;
mod exchange;
mod face_list;
mod fan;
mod far_field;
mod filler;
mod fluxes;
mod folding;
mod gains;
mod gather;
mod given;
mod gradients;
mod ground;
mod hll;
mod hllc;
mod hulls;
mod image;
mod kink;
mod levels;
pub(crate) mod limiter;
mod loads;
mod mach_lines;
mod march;
mod merge;
mod nearby;
mod net;
mod oblique;
mod order;
mod origins;
mod outline_piece;
mod outlines;
mod outside;
mod pace;
mod panels;
mod part;
mod passes;
mod pieces;
mod plot;
mod poles;
mod polytope;
mod prandtl_meyer;
mod quiet;
mod reach;
mod real;
mod rebuild;
mod reconstruction;
mod refine;
mod refusal;
mod relax;
mod rides;
mod ridges;
mod riding;
mod rim;
mod root;
mod roots;
mod seams;
mod section;
mod settle;
mod sides;
mod sight;
mod site;
mod slopes;
mod slow;
mod snapshot;
mod solids;
mod sources;
mod spreading;
mod staged;
mod stages;
mod state;
mod stick;
mod stillness;
mod sweeps;
mod tally;
#[cfg(test)]
pub(crate) mod tests;
mod tips;
mod total;
mod turn;
mod twins;
mod unshown;
mod viscous;
mod voronoi;
mod wall_fit;
mod walls;
mod whole;
mod wishes;

use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use aero_geometry::Vector;

pub use cells::{Cells, SideFace, WallFace, WallOwner};
pub use checkpoint::FixedMemory;
pub use face_list::{Face, FaceList};
pub use settle::{Settled, Settling};

use crate::frame::{CellFrame, Load};
use crate::panels::Panels;
use crate::problem::Problem;
use crate::scheme::Precision;
use crate::vectors::Arch;
use crate::walls::wall_sides;
use columns::Columns;
use equation_of_state::AnyGas;
use given::beyond_faces;
use ground::Ground;
use net::Net;
use outside::Outside;
use quiet::Quiet;
use state::Primitive;
use tally::Tally;
use viscous::Viscous;

/// A flow about points that stay where they are.
#[derive(Debug)]
pub struct FixedSimulation<const D: usize> {
    problem: Problem<D>,
    fluid: Fluid,
    arch: pulp::Arch,
    points: Vec<Vector<D>>,
    /// What the points came from, where more may come.
    ground: Option<Box<Ground<D>>>,
    net: Net<D>,
    outside: Outside<D>,
    quiet: Quiet<D>,
    columns: Columns<D>,
    tally: Tally<D>,
    settling: Settling,
    shown: Shown<D>,
}

/// The gas that flows.
#[derive(Debug)]
struct Fluid {
    gas: AnyGas,
    /// Its viscosity, if it has one.
    viscous: Option<Viscous>,
}

/// What is made when somebody asks to see it.
#[derive(Debug, Default)]
struct Shown<const D: usize> {
    /// Surfaces of bodies and walls.
    panels: OnceLock<Panels<D>>,
    /// What a pressure of one everywhere presses them with.
    uniform_loads: OnceLock<Vec<Load>>,
    /// What the cells look like.
    outlines: OnceLock<Arc<CellFrame>>,
}

impl<const D: usize> FixedSimulation<D> {
    /// The flow of `problem` on `cells`, at its start.
    ///
    /// # Errors
    /// What cannot be flown on points that stay: walls and bodies that move, walls that gas sticks to, a vacuum; cells that are none.
    pub fn on(cells: Cells<D>, problem: Problem<D>) -> Result<Self, String> {
        problem.check_fixed()?;
        let states = Self::initial_states(&problem, &cells)?;
        Self::from_states(cells, problem, states)
    }

    /// The flow of `problem` on the cells of its lattice, at its start.
    ///
    /// # Errors
    /// As of [`Self::on`].
    pub fn new(problem: Problem<D>) -> Result<Self, String> {
        problem.check_fixed()?;
        let (ground, cells) = Ground::new(&problem)?;
        let ground = ground.if_wanted();
        let mut simulation = Self::on(cells, problem)?;
        if let Some(ground) = ground {
            let (starts_settled, most) = (ground.starts_settled(), u32::from(ground.most()));
            simulation.ground = Some(ground);
            if starts_settled {
                simulation.settling = Settling::from_earlier(most);
            } else {
                simulation.adapt_start()?;
            }
        }
        Ok(simulation)
    }

    /// The state in each of `cells` at the start.
    fn initial_states(problem: &Problem<D>, cells: &Cells<D>) -> Result<Vec<Primitive<D>>, String> {
        let state = |point: &Vector<D>| match problem.initial_state(point)? {
            Some(state) => Ok(Primitive::of(&state)),
            None => Err(refusal::vacuum(point.as_slice())),
        };
        // A collection that may fail grows bit by bit, and keeps more room than it needs.
        let mut states = Vec::with_capacity(cells.points.len());
        for point in &cells.points {
            states.push(state(point)?);
        }
        Ok(states)
    }

    /// The same with a state in each cell.
    fn from_states(
        cells: Cells<D>,
        problem: Problem<D>,
        states: Vec<Primitive<D>>,
    ) -> Result<Self, String> {
        if cells.points.is_empty() {
            return Err("no point fits between the bodies and the sides; \
                        use a smaller `spacing` or a larger domain"
                .into());
        }
        let net = Self::net(&cells, &problem)?;
        let outside = Outside::of(&problem, &cells, &net);
        let gas = AnyGas::of(&problem.gas)?;
        let held = states.iter().map(|state| state.conserved(&gas)).collect();
        let mut simulation = Self {
            arch: Arch::of_processor(Precision::Double)?.instructions,
            quiet: Quiet::of(&net, &problem),
            columns: Columns::new(
                held,
                states,
                &net,
                problem.free_stream.pressure,
                problem.gas.is_viscous(),
            ),
            fluid: Fluid {
                gas,
                viscous: Viscous::of(&problem.gas),
            },
            points: cells.into_points(),
            ground: None,
            net,
            outside,
            tally: Tally::default(),
            settling: Settling::default(),
            shown: Shown::default(),
            problem,
        };
        simulation.start();
        Ok(simulation)
    }

    fn net(cells: &Cells<D>, problem: &Problem<D>) -> Result<Net<D>, String> {
        problem.check_closed(cells)?;
        let beyond = beyond_faces(problem, cells)?;
        let sides = wall_sides(&problem.domain);
        let bodies = problem.bodies.len();
        let mut net = Net::new(
            cells,
            &beyond,
            |owner| match owner {
                WallOwner::Body(body) => body,
                WallOwner::Side { axis, end } => {
                    let place = (axis as usize, end as usize);
                    let number = sides.iter().position(|side| *side == place);
                    (bodies + number.unwrap_or(0)) as u32
                }
            },
            problem.domain.is_axisymmetric(),
        )?;
        viscous::stick(&mut net, &cells.points, problem)?;
        let least = slow::least_mach(problem);
        let walls = net.blocks.iter_mut().flat_map(|block| &mut block.walls);
        walls.for_each(|wall| wall.least_mach = least);
        net.add_bends(cells, problem);
        net.find_even_faces(problem);
        Ok(net)
    }

    /// Finds out which blocks rest, and evaluates once so that loads can be told.
    fn start(&mut self) {
        self.give(self.tally.time);
        self.find_quiet();
        self.wake();
        self.find_slopes();
        self.exchange(|_, _, _| {});
    }

    /// The problem that is solved.
    pub fn problem(&self) -> &Problem<D> {
        &self.problem
    }

    /// Time reached.
    pub fn time(&self) -> f64 {
        self.tally.time
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.tally.steps
    }

    /// What a value per radian counts all around an axis; one without.
    fn around(&self) -> f64 {
        if self.problem.domain.is_axisymmetric() {
            TAU
        } else {
            1.0
        }
    }

    fn awake_cells(&self) -> u64 {
        let blocks = self.net.blocks.iter().zip(&self.quiet.blocks);
        blocks
            .filter(|(_, rest)| rest.is_awake)
            .map(|(block, _)| block.cells.len() as u64)
            .sum()
    }
}
