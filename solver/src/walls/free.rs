//! Rigid bodies that the gas moves [Newton 1687; Euler 1765].

use aero_geometry::Vector;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use super::rigid::{Pose, pad};
use crate::problem::{Freedom, Motion};

/// Where a free body is, and how it moves.
///
/// It drifts at its velocities, is kicked by the forces of the middle of a step, and drifts on, as the gas around it does: what it
/// gets is to the bit what the gas loses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FreeBody {
    time: f64,
    pivot: Vector3<f64>,
    rotation: UnitQuaternion<f64>,
    velocity: Vector3<f64>,
    angular_velocity: Vector3<f64>,
    /// About the pivot, along the axes that the body can turn about.
    angular_momentum: Vector3<f64>,
    /// Of the last step.
    acceleration: Vector3<f64>,
    angular_acceleration: Vector3<f64>,
}

impl FreeBody {
    /// At time zero.
    pub fn new<const D: usize>(motion: &Motion<D>, freedom: &Freedom) -> Self {
        let angular_velocity = motion.turning.rate(0.0);
        Self {
            time: 0.0,
            pivot: pad(&motion.pivot),
            rotation: UnitQuaternion::identity(),
            velocity: pad(&motion.velocity),
            angular_velocity,
            angular_momentum: freedom.inertia * angular_velocity,
            acceleration: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
        }
    }

    /// The pose at `time`, not far ahead of the last step's end, of a body whose pivot was at `origin` at time zero.
    pub fn pose<const D: usize>(&self, origin: &Vector<D>, time: f64) -> Pose<D> {
        let ahead = time - self.time;
        let rotation = self.turned(&self.angular_velocity, ahead);
        let rotation = rotation.to_rotation_matrix();
        let own = |vector: Vector3<f64>| Vector::from_fn(|k, _| vector[k]);
        Pose {
            rotation: nalgebra::SMatrix::from_fn(|a, b| rotation[(a, b)]),
            first_pivot: *origin,
            pivot: own(self.pivot + self.velocity * ahead),
            velocity: own(self.velocity + self.acceleration * ahead),
            acceleration: own(self.acceleration),
            angular_velocity: self.angular_velocity + self.angular_acceleration * ahead,
            angular_acceleration: self.angular_acceleration,
        }
    }

    /// Goes on by `step` with the force and the moment about the pivot of its middle, and an acceleration by what is not gas.
    pub fn kick(
        &mut self,
        freedom: &Freedom,
        [force, moment]: [Vector3<f64>; 2],
        other: &Vector3<f64>,
        step: f64,
    ) {
        let acceleration = freedom.along(&(force / freedom.mass + other));
        let before = *self;
        self.velocity += acceleration * step;
        self.pivot += (before.velocity + self.velocity) * (0.5 * step);
        self.angular_momentum += freedom.about(&moment) * step;
        let half_way = before.turned(&before.angular_velocity, 0.5 * step);
        let mean = (before.angular_momentum + self.angular_momentum) * 0.5;
        self.rotation = before.turned(&freedom.angular_velocity(&half_way, &mean), step);
        self.rotation.renormalize();
        self.angular_velocity = freedom.angular_velocity(&self.rotation, &self.angular_momentum);
        self.acceleration = acceleration;
        self.angular_acceleration = (self.angular_velocity - before.angular_velocity) / step;
        self.time += step;
    }

    /// Takes an impulse, and its moment about the pivot.
    pub fn strike(&mut self, freedom: &Freedom, [impulse, moment]: [Vector3<f64>; 2]) {
        self.velocity += freedom.along(&(impulse / freedom.mass));
        self.angular_momentum += freedom.about(&moment);
        self.angular_velocity = freedom.angular_velocity(&self.rotation, &self.angular_momentum);
    }

    /// Turned on at an angular velocity.
    fn turned(&self, angular_velocity: &Vector3<f64>, time: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(angular_velocity * time) * self.rotation
    }
}

impl Freedom {
    /// What of a vector lies along axes that the body can move along.
    fn along(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        Vector3::from_fn(|k, _| if self.is_held[k] { 0.0 } else { vector[k] })
    }

    /// What of a vector lies along axes that the body can turn about.
    fn about(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        Vector3::from_fn(|k, _| if self.keeps_turn[k] { 0.0 } else { vector[k] })
    }

    /// Angular velocity of the body, turned by `rotation`, at an angular momentum along the axes that it can turn about.
    fn angular_velocity(
        &self,
        rotation: &UnitQuaternion<f64>,
        angular_momentum: &Vector3<f64>,
    ) -> Vector3<f64> {
        let turn = rotation.to_rotation_matrix();
        let mut inertia: Matrix3<f64> = turn * self.inertia * turn.transpose();
        for k in (0..3).filter(|&k| self.keeps_turn[k]) {
            inertia.fill_row(k, 0.0);
            inertia.fill_column(k, 0.0);
            inertia[(k, k)] = 1.0;
        }
        let solved = inertia.lu().solve(&self.about(angular_momentum));
        solved.unwrap_or_else(Vector3::zeros)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Turning;

    const NONE: [Vector3<f64>; 2] = [Vector3::new(0.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 0.0)];

    fn motion(turning: Vector3<f64>) -> Motion<3> {
        Motion {
            velocity: Vector3::new(0.3, -0.2, 0.1),
            turning: Turning::Steady(turning),
            ..Motion::none()
        }
    }

    fn freedom(inertia: [f64; 3]) -> Freedom {
        Freedom {
            mass: 2.0,
            inertia: Matrix3::from_diagonal(&Vector3::from(inertia)),
            is_held: [false; 3],
            keeps_turn: [false; 3],
        }
    }

    /// Angle about `x` that a top left alone has turned by after a time in so many steps.
    fn end(steps: u32) -> (UnitQuaternion<f64>, FreeBody) {
        let freedom = freedom([1.0, 2.0, 3.5]);
        let mut body = FreeBody::new(&motion(Vector3::new(0.4, 1.5, 0.2)), &freedom);
        let step = 4.0 / f64::from(steps);
        for _ in 0..steps {
            body.kick(&freedom, NONE, &Vector3::zeros(), step);
        }
        (body.rotation, body)
    }

    /// A top left alone tumbles about its middle axis; its angular momentum stays, and its energy as the step gets short.
    #[test]
    fn a_top_left_alone_tumbles_with_second_order() {
        let (exact, body) = end(6400);
        let start = Vector3::new(0.4, 2.0 * 1.5, 3.5 * 0.2);
        assert!((body.angular_momentum - start).norm() < 1e-15);
        let energy = 0.5 * body.angular_velocity.dot(&body.angular_momentum);
        let before = 0.5 * start.dot(&Vector3::new(0.4, 1.5, 0.2));
        assert!((energy - before).abs() < 1e-6 * before, "{energy} {before}");
        let [coarse, fine] = [100, 200].map(|steps| end(steps).0.angle_to(&exact));
        let order = (coarse / fine).log2();
        assert!(fine > 1e-6 && (order - 2.0).abs() < 0.1, "{coarse} {fine}");
        assert!((body.pivot - Vector3::new(1.2, -0.8, 0.4)).norm() < 1e-12);
    }

    /// A constant force and moment: `x = v t + 1/2 a t^2`, `angle = 1/2 (M / I) t^2`.
    #[test]
    fn force_and_moment_move_and_turn_it() {
        let mut freedom = freedom([1.0, 1.0, 4.0]);
        freedom.is_held = [false, true, false];
        let mut body = FreeBody::new(&Motion::<3>::none(), &freedom);
        let loads = [Vector3::new(3.0, 5.0, 0.0), Vector3::new(0.0, 0.0, 2.0)];
        for _ in 0..10 {
            body.kick(&freedom, loads, &Vector3::new(0.0, 0.0, -1.0), 0.1);
        }
        assert!((body.pivot - Vector3::new(0.75, 0.0, -0.5)).norm() < 1e-14);
        assert!((body.rotation.scaled_axis() - Vector3::new(0.0, 0.0, 0.25)).norm() < 1e-14);
        let pose: Pose<3> = body.pose(&Vector3::zeros(), 1.0);
        let tip = Vector3::new(1.0, 0.0, 0.0);
        let velocity = pose.velocity(&pose.position(&tip));
        let wanted = Vector3::new(-0.25_f64.sin(), 0.25_f64.cos(), 0.0) * 0.5;
        assert!((velocity - wanted - body.velocity).norm() < 1e-14);
        body.strike(
            &freedom,
            [Vector3::new(-3.0, 1.0, 2.0), Vector3::z() * -2.0],
        );
        assert!(body.velocity.norm() < 1e-14 && body.angular_velocity.norm() < 1e-14);
    }

    /// About an axis that is held it does not turn, whatever its inertia couples; about the other it turns as a hinge does.
    #[test]
    fn held_axes_bear_what_turns_about_them() {
        let mut freedom = freedom([1.0, 1.0, 1.0]);
        freedom.inertia[(0, 2)] = 0.5;
        freedom.inertia[(2, 0)] = 0.5;
        freedom.keeps_turn = [true, true, false];
        let mut body = FreeBody::new(&Motion::<3>::none(), &freedom);
        let loads = [Vector3::zeros(), Vector3::new(7.0, 1.0, 2.0)];
        body.kick(&freedom, loads, &Vector3::zeros(), 0.01);
        assert!((body.angular_velocity - Vector3::new(0.0, 0.0, 0.02)).norm() < 1e-15);
    }
}
