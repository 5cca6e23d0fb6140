//! A pointer that drags a rigid by a spring.
//!
//! The spring is critically damped and of unit mass: x'' = w2 (goal - x) - 2 w x'. It is advanced by implicit Euler,
//! v' = (v + w2 h (goal - x)) / (1 + w h)2, x' = x + v' h, both eigenvalues of which are 1 / (1 + w h): critically
//! damped as the original is, for any w and h. After n steps from rest at distance d the distance is
//! d (1 + n w h / (1 + w h)) / (1 + w h)^n.

use crate::layout::error::ParameterError;
use crate::math::vector::Vector;
use crate::rigids::checks::{PLACES, TOP_SPEED, ranged};

/// Range of a stiffness, 1/s: above it the spring is no softer than a step is long.
const STIFFNESSES: (f64, f64) = (0.1, 200.0);

/// A point of a rigid that is drawn to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grab {
    /// The point, in the rigid's own space (m).
    pub anchor: Vector,
    /// Where it shall be, world space (m).
    pub target: Vector,
    /// The spring's angular frequency w, 0.1..200 1/s: after 4.7 / w seconds a twentieth of the way is left.
    pub stiffness: f32,
}

impl Grab {
    /// Reads anchor, target and stiffness.
    ///
    /// # Errors
    /// Names the number that is not finite or out of range, as `rigid.drag.*`.
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

    /// The velocity (m/s) after `dt` seconds of a point at `place` with `velocity` that the spring draws to `goal`.
    pub fn spring(&self, place: Vector, velocity: Vector, goal: Vector, dt: f32) -> Vector {
        let a = self.stiffness * dt;
        let drawn = (velocity + (goal - place) * (self.stiffness * a)) * (1.0 / ((1.0 + a) * (1.0 + a)));
        drawn * (TOP_SPEED / drawn.length().max(TOP_SPEED))
    }
}
