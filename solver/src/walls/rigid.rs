//! Rigid motion of bodies and walls.

use aero_geometry::Vector;
use nalgebra::Vector3;

use crate::problem::{Motion, Turning};
use crate::records::Matrix;

/// Where a rigid body is at one time.
#[derive(Clone, Copy, Debug)]
pub struct Pose<const D: usize> {
    pub(super) rotation: Matrix<D>,
    pub(super) first_pivot: Vector<D>,
    pub(super) pivot: Vector<D>,
    pub(super) velocity: Vector<D>,
    pub(super) acceleration: Vector<D>,
    pub(super) angular_velocity: Vector3<f64>,
    pub(super) angular_acceleration: Vector3<f64>,
}

impl<const D: usize> Pose<D> {
    /// The pose of what stays as it is.
    pub fn at_rest() -> Self {
        Self {
            rotation: Matrix::identity(),
            first_pivot: Vector::zeros(),
            pivot: Vector::zeros(),
            velocity: Vector::zeros(),
            acceleration: Vector::zeros(),
            angular_velocity: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
        }
    }

    /// The pose at `time` of a body that moves as prescribed: the pivot moves at constant acceleration, the body turns about it.
    pub fn new(motion: &Motion<D>, time: f64) -> Self {
        Self {
            rotation: rotation(&motion.turning.angle(time)),
            first_pivot: motion.pivot,
            pivot: motion.pivot
                + motion.velocity * time
                + motion.acceleration * (0.5 * time * time),
            velocity: motion.velocity + motion.acceleration * time,
            acceleration: motion.acceleration,
            angular_velocity: motion.turning.rate(time),
            angular_acceleration: motion.turning.acceleration(time),
        }
    }

    /// Position now of a point that was at `origin` at time zero.
    pub fn position(&self, origin: &Vector<D>) -> Vector<D> {
        self.pivot + self.rotation * (origin - self.first_pivot)
    }

    /// Direction now of what pointed along `origin` at time zero.
    pub fn direction(&self, origin: &Vector<D>) -> Vector<D> {
        self.rotation * origin
    }

    /// Tensor now of what was `origin` at time zero.
    pub fn tensor(&self, origin: &Matrix<D>) -> Matrix<D> {
        self.rotation * origin * self.rotation.transpose()
    }

    /// What, times the velocity relative to the body, gives the Coriolis acceleration along `normal`:
    /// `n.(2 w x u) = (2 n x w).u`.
    pub fn coriolis(&self, normal: &Vector<D>) -> Vector<D> {
        let full = pad(normal).cross(&self.angular_velocity) * 2.0;
        Vector::from_fn(|k, _| full[k])
    }

    /// Where its pivot is now.
    pub fn pivot(&self) -> Vector<D> {
        self.pivot
    }

    /// How it has turned, radians: a vector along the axis, as long as the angle, of half a turn at most.
    pub fn turn(&self) -> Vector3<f64> {
        let full = nalgebra::Matrix3::from_fn(|a, b| match (a < D, b < D) {
            (true, true) => self.rotation[(a, b)],
            _ => f64::from(u8::from(a == b)),
        });
        nalgebra::Rotation3::from_matrix_unchecked(full).scaled_axis()
    }

    /// Its angular velocity, rad/s.
    pub fn angular_velocity(&self) -> Vector3<f64> {
        self.angular_velocity
    }

    /// Position at time zero of the body's point that is at `position` now.
    pub fn origin(&self, position: &Vector<D>) -> Vector<D> {
        self.first_pivot + self.rotation.transpose() * (position - self.pivot)
    }

    /// Velocity of the body's point at `position`: `v + w x r`.
    pub fn velocity(&self, position: &Vector<D>) -> Vector<D> {
        self.velocity + cross(&self.angular_velocity, &(position - self.pivot))
    }

    /// Acceleration of the body's point at `position`: `a + dw/dt x r + w x (w x r)`.
    pub fn acceleration(&self, position: &Vector<D>) -> Vector<D> {
        let arm = position - self.pivot;
        self.acceleration
            + cross(&self.angular_acceleration, &arm)
            + cross(&self.angular_velocity, &cross(&self.angular_velocity, &arm))
    }
}

impl<const D: usize> Motion<D> {
    /// A body at rest.
    pub fn none() -> Self {
        Self {
            velocity: Vector::zeros(),
            acceleration: Vector::zeros(),
            turning: Turning::Steady(Vector3::zeros()),
            pivot: Vector::zeros(),
            free: None,
        }
    }

    /// True where the body ever turns.
    pub fn is_turning(&self) -> bool {
        self.turning != Turning::Steady(Vector3::zeros())
            || (self.free.as_ref()).is_some_and(|free| free.keeps_turn != [true; 3])
    }

    /// True where the body ever moves.
    pub fn is_moving(&self) -> bool {
        self.velocity != Vector::<D>::zeros()
            || self.acceleration != Vector::<D>::zeros()
            || self.free.is_some()
            || self.is_turning()
    }
}

/// A vector in three dimensions, missing axes zero.
pub fn pad<const D: usize>(vector: &Vector<D>) -> Vector3<f64> {
    Vector3::from_fn(|k, _| if k < D { vector[k] } else { 0.0 })
}

fn cross<const D: usize>(angular_velocity: &Vector3<f64>, arm: &Vector<D>) -> Vector<D> {
    let full = angular_velocity.cross(&pad(arm));
    Vector::from_fn(|k, _| full[k])
}

/// Rotation matrix of a rotation vector; in 2D only its third component turns anything.
fn rotation<const D: usize>(turn: &Vector3<f64>) -> Matrix<D> {
    let full = nalgebra::Rotation3::new(*turn);
    Matrix::from_fn(|a, b| full[(a, b)])
}
