//! Step length, limits of capacity, speed and pools.

use crate::layout::error::ParameterError;

/// Length of a step (s).
pub const STEP: f64 = 1.0 / 60.0;

/// Maximum capacity of a simulator.
pub const CAPACITY_LIMIT: u32 = 1_000_000;

/// Number of emitters outside of the table.
pub const POOL_LIMIT: usize = 384;

/// Number of colliders outside of the table.
pub const COLLIDER_LIMIT: usize = 256;

/// Maximum speed of the surface of a collider or a kinematic rigid (m/s): up to it no particle can pass through.
pub const TOP_SPEED: f32 = 120.0;

/// Greatest ratio of the axes of a stretched puff.
pub const MAX_STRETCH: f32 = 4.0;

pub(crate) fn check_capacity(capacity: u32) -> Result<usize, ParameterError> {
    if (1..=CAPACITY_LIMIT).contains(&capacity) {
        return Ok(capacity as usize);
    }
    let limit = f64::from(CAPACITY_LIMIT);
    Err(ParameterError::out_of_range(
        "simulation.maxParticles",
        f64::from(capacity),
        1.0,
        limit,
    ))
}
