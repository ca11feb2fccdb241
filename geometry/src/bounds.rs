//! Axis-aligned boxes.

use crate::Vector;

/// An axis-aligned box; infinite sides are allowed (a compression corner has no end).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds<const D: usize> {
    /// Lowest corner.
    pub min: Vector<D>,
    /// Highest corner.
    pub max: Vector<D>,
}

impl<const D: usize> Bounds<D> {
    /// The box from `min` to `max`.
    pub fn new(min: Vector<D>, max: Vector<D>) -> Self {
        Self { min, max }
    }

    /// The box grown by `margin` on every side.
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        Self {
            min: self.min.add_scalar(-margin),
            max: self.max.add_scalar(margin),
        }
    }

    /// True where `point` lies inside or on the box.
    pub fn contains(&self, point: &Vector<D>) -> bool {
        (0..D).all(|k| self.min[k] <= point[k] && point[k] <= self.max[k])
    }

    /// The part common to both boxes; empty where some `min > max`.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        Self {
            min: self.min.sup(&other.min),
            max: self.max.inf(&other.max),
        }
    }

    /// True where no point is inside.
    pub fn is_empty(&self) -> bool {
        (0..D).any(|k| self.min[k] > self.max[k])
    }

    /// Edge lengths.
    pub fn size(&self) -> Vector<D> {
        self.max - self.min
    }
}
