//! Wind: the air as a whole moves.
//!
//! u = w, the same everywhere. Parameters: `forces.wind.x`, `.y`, `.z` (m/s). Wind also carries the pattern of
//! turbulence along, as it carries all air.

use crate::parameters::Parameters;

/// Velocity of the wind (m/s).
pub fn velocity(parameters: &Parameters) -> [f32; 3] {
    parameters.forces.wind.map(|component| component as f32)
}
