//! Walls before the rim of a blunt base.

use std::sync::Arc;

use aero_geometry::{Placed, Placement, Shape, bodies};

use super::flows::stream;
use crate::fixed::FixedSimulation;

/// Walls that are a smaller part of a face of a cell are slivers.
const SLIVER: f64 = 1e-3;

/// The largest departure of the pressure from the stream's on the sides of a block along it, up to its base.
fn off<const D: usize>(block: Arc<dyn Shape<D>>, dx: f64, at: [f64; 2]) -> f64 {
    let mut moved = [at[1]; D];
    moved[0] = at[0];
    let placed = Placed::new(block, Placement::default().moved(moved.into()));
    let (mut min, mut max) = ([-0.6; D], [0.6; D]);
    (min[0], max[0]) = (-0.4, 0.5);
    let problem = stream(2.0, [min, max], dx, vec![Arc::new(placed)]);
    let mut flow = FixedSimulation::new(problem).unwrap();
    flow.settle(150).unwrap();
    let least = SLIVER * dx.powi(D as i32 - 1);
    let sides = flow
        .walls()
        .filter(|(wall, _)| wall.image.normal[0].abs() < 0.1 && wall.image.share > least);
    let departures = sides.map(|(_, pressure)| (1.4 * pressure - 1.0).abs());
    departures.fold(0.0, f64::max)
}

/// Wherever in its cell the rim lies, which turns by a right angle: the cell that holds it is up to a sixth off.
#[test]
fn a_fast_stream_along_a_block_presses_on_its_sides_up_to_its_base() {
    for shift in [[0.0, 0.0], [0.013, 0.007], [-0.011, 0.02]] {
        let at = [shift[0] - 1.5, shift[1]];
        let rectangle = bodies::rectangle(3.0, 0.4, 0.0).unwrap();
        let plane = off::<2>(Arc::new(rectangle), 0.05, at);
        let cuboid = bodies::cuboid([3.0, 0.4, 0.4]).unwrap();
        let space = off::<3>(Arc::new(cuboid), 0.1, at);
        assert!(plane < 0.03 && space < 0.03, "{shift:?}: {plane}, {space}");
    }
}
