//! Gravity: smoke that is heavier than air sinks.
//!
//! a = -g m up. Parameters: `gravity.acceleration` g (m/s2, downward: the weight that the air does not carry, not
//! 9.81 for smoke), `forces.gravity` m (multiplier).

use crate::parameters::Parameters;

/// Downward acceleration (m/s2).
pub fn acceleration(parameters: &Parameters) -> f32 {
    (parameters.gravity_acceleration * parameters.forces.gravity) as f32
}
