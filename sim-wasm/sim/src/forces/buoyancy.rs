//! Buoyancy: warm smoke rises until it has cooled.
//!
//! a = b m T up, and T falls by T' = -T / tau. Parameters: `buoyancy.acceleration` b (m/s2 upward at temperature 1),
//! `forces.buoyancy` m (multiplier), `buoyancy.coolingTime` tau (s). The cooling of a whole step is exact.

use crate::parameters::Parameters;

/// Upward acceleration (m/s2) at temperature 1.
pub fn acceleration_per_temperature(parameters: &Parameters) -> f32 {
    (parameters.buoyancy.acceleration * parameters.forces.buoyancy) as f32
}

/// What is left of a temperature after `dt` seconds, 0..1.
pub fn cooling(parameters: &Parameters, dt: f64) -> f32 {
    libm::exp(-dt / parameters.buoyancy.cooling_time) as f32
}
