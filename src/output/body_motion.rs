//! How bodies move that the gas moves.

use aero_solver::Flow;
use nalgebra::Vector3;
use serde::Serialize;

/// Where a body that the gas moves is, and how it moves; missing axes zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct BodyMotion {
    /// Its centre, or the hinge that holds it.
    pub position: [f64; 3],
    /// Velocity of that point.
    pub velocity: [f64; 3],
    /// How it has turned, degrees, right-handed: a vector along the axis, as long as the angle, of half a turn at most.
    pub turn: [f64; 3],
    /// Angular velocity, rad/s.
    pub angular_velocity: [f64; 3],
}

impl BodyMotion {
    /// Its columns in `history.csv`.
    pub const COLUMNS: [&str; 12] = [
        "x", "y", "z", "vx", "vy", "vz", "turn_x", "turn_y", "turn_z", "wx", "wy", "wz",
    ];

    /// That of body `number` now; none of a body that moves as prescribed.
    pub fn of<const D: usize>(flow: &Flow<D>, number: usize) -> Option<Self> {
        flow.problem().bodies[number].motion.free.as_ref()?;
        let pose = flow.pose(number);
        let pivot = pose.pivot();
        let full = |vector: aero_geometry::Vector<D>| {
            std::array::from_fn(|k| vector.get(k).copied().unwrap_or(0.0))
        };
        let turn: Vector3<f64> = pose.turn();
        Some(Self {
            position: full(pivot),
            velocity: full(pose.velocity(&pivot)),
            turn: turn.map(f64::to_degrees).into(),
            angular_velocity: pose.angular_velocity().into(),
        })
    }

    /// Its numbers, in the order of [`Self::COLUMNS`].
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        [
            self.position,
            self.velocity,
            self.turn,
            self.angular_velocity,
        ]
        .into_iter()
        .flatten()
    }
}
