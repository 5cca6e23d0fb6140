//! Dragging a rigid by a spring.
//!
//! The spring is critically damped and of unit mass: x'' = w2 (goal - x) - 2 w x'. Implicit Euler advances it: v' =
//! (v + w2 h (goal - x)) / (1 + w h)2, x' = x + v' h. Both eigenvalues are 1 / (1 + w h), so the discrete spring is
//! critically damped for any w and h. After n steps from rest at the distance d, the distance is d (1 + n w h / (1 + w
//! h)) / (1 + w h)^n.

use crate::layout::error::ParameterError;
use crate::layout::limits::TOP_SPEED;
use crate::math::vector::Vector;
use crate::rigids::checks::{PLACES, ranged};

/// Range of the stiffness (1/s). Its maximum corresponds to the length of a step.
const STIFFNESSES: (f64, f64) = (0.1, 200.0);

/// A point of a rigid, and the position it is dragged to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grab {
    /// The point in the rigid's space (m).
    pub anchor: Vector,
    /// The target in world space (m).
    pub target: Vector,
    /// Angular frequency w of the spring, 0.1..=200 1/s: after 4.7 / w seconds 5 % of the distance is left.
    pub stiffness: f32,
}

impl Grab {
    /// Reads anchor, target and stiffness.
    ///
    /// # Errors
    /// A number is not finite or out of range; the key is `rigid.drag.*`.
    pub fn from_numbers(anchor: [f32; 3], target: [f32; 3], stiffness: f32) -> Result<Self, ParameterError> {
        for (name, place) in [("anchor", anchor), ("target", target)] {
            for (axis, value) in ["x", "y", "z"].iter().zip(place) {
                ranged(&format!("rigid.drag.{name}.{axis}"), value, PLACES)?;
            }
        }
        Ok(Self {
            anchor: anchor.into(),
            target: target.into(),
            stiffness: ranged("rigid.drag.stiffness", stiffness, STIFFNESSES)?,
        })
    }

    /// Anchor, target and stiffness.
    pub fn numbers(&self) -> [f32; 7] {
        let ([a, b, c], [x, y, z]): ([f32; 3], [f32; 3]) = (self.anchor.into(), self.target.into());
        [a, b, c, x, y, z, self.stiffness]
    }

    /// Velocity (m/s) after `dt` seconds of a point at `place` with `velocity` that the spring pulls to `goal`.
    pub fn spring(&self, place: Vector, velocity: Vector, goal: Vector, dt: f32) -> Vector {
        let a = self.stiffness * dt;
        let drawn = (velocity + (goal - place) * (self.stiffness * a)) * (1.0 / ((1.0 + a) * (1.0 + a)));
        drawn * (TOP_SPEED / drawn.length().max(TOP_SPEED))
    }
}
