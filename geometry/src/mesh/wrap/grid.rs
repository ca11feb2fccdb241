//! The nodes of the wrap's grid: which are inside, which the gas reaches.

use rayon::prelude::*;

use super::field::Field;
use crate::Vector;
use crate::error::GeometryError;

/// Empty cells around the body.
const MARGIN: f64 = 3.0;

/// Most nodes of a grid.
const MOST: f64 = 1.5e9;

const FAR: u8 = 0;
const NEAR: u8 = 1;
const SOLID: u8 = 2;
const REACHED: u8 = 4;

/// Nodes of a grid around the body, row by row.
pub(super) struct Nodes {
    origin: Vector<3>,
    pub step: f64,
    pub count: [usize; 3],
    state: Vec<u8>,
}

impl Nodes {
    pub fn new(field: &Field, step: f64) -> Result<Self, GeometryError> {
        let bounds = field.bounds.grown((MARGIN + 1.0) * step);
        // Off round numbers, on which bodies' faces lie.
        let origin = bounds.min - step * Vector::<3>::new(0.137, 0.291, 0.413);
        let size = (bounds.max - origin) / step;
        if size.map(|cells| cells + 2.0).product() > MOST {
            let finest = 2.0 * step * (size.product() / MOST).cbrt();
            return Err(GeometryError::Surface(format!(
                "is too large to be wrapped at this spacing; choose {finest:.1e} or more"
            )));
        }
        let count = [0, 1, 2].map(|k| size[k].ceil() as usize + 2);
        let mut nodes = Self {
            origin,
            step,
            count,
            state: vec![FAR; count.iter().product()],
        };
        nodes.mark_near(field);
        nodes.ask(field);
        nodes.reach();
        Ok(nodes)
    }

    pub fn place(&self, [x, y, z]: [usize; 3]) -> Vector<3> {
        self.origin + self.step * Vector::<3>::new(x as f64, y as f64, z as f64)
    }

    pub fn node(&self, index: usize) -> [usize; 3] {
        let [nx, ny, _] = self.count;
        [index % nx, index / nx % ny, index / (nx * ny)]
    }

    /// Distance in the list between neighbours along an axis.
    pub fn stride(&self, axis: usize) -> usize {
        [1, self.count[0], self.count[0] * self.count[1]][axis]
    }

    /// True for nodes that the gas reaches.
    pub fn is_outside(&self, index: usize) -> bool {
        self.state[index] & REACHED != 0
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.state.len()
    }

    /// Nodes that are not inside of anything, but that the gas does not reach.
    pub fn voids(&self) -> usize {
        let unreached = |state: &&u8| **state == NEAR;
        self.state.par_iter().filter(unreached).count()
    }

    /// Marks the nodes of all cells that the surface may pass through, and their neighbours.
    fn mark_near(&mut self, field: &Field) {
        let (origin, step, count) = (self.origin, self.step, self.count);
        let (width, slab) = (self.stride(1), self.stride(2));
        let state = &mut self.state;
        field.near_surface(step, |low, high| {
            let begin = (low - origin).map(|x| (x / step).floor().max(0.0) as usize);
            let end = (high - origin).map(|x| (x / step).floor().max(0.0) as usize + 1);
            for z in begin.z..=end.z.min(count[2] - 1) {
                for y in begin.y..=end.y.min(count[1] - 1) {
                    let row = z * slab + y * width;
                    state[row + begin.x..=row + end.x.min(count[0] - 1)].fill(NEAR);
                }
            }
        });
    }

    /// Asks the field at the nodes marked.
    fn ask(&mut self, field: &Field) {
        let near: Vec<usize> = (0..self.state.len())
            .into_par_iter()
            .filter(|&n| self.state[n] == NEAR)
            .collect();
        let solid: Vec<bool> = near
            .par_iter()
            .map(|&n| field.at(&self.place(self.node(n))).0 <= 0.0)
            .collect();
        for (&n, _) in near.iter().zip(solid).filter(|(_, solid)| *solid) {
            self.state[n] = SOLID;
        }
    }

    /// Floods from a corner all that is not solid.
    fn reach(&mut self) {
        let mut open = vec![0];
        self.state[0] |= REACHED;
        while let Some(index) = open.pop() {
            let node = self.node(index);
            for axis in 0..3 {
                let stride = self.stride(axis);
                let below = (node[axis] > 0).then(|| index - stride);
                let above = (node[axis] + 1 < self.count[axis]).then(|| index + stride);
                for next in [below, above].into_iter().flatten() {
                    if self.state[next] & (SOLID | REACHED) == 0 {
                        self.state[next] |= REACHED;
                        open.push(next);
                    }
                }
            }
        }
    }
}
