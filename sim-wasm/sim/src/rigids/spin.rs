//! Steady spins.

use crate::layout::error::ParameterError;
use crate::math::vector::Vector;
use crate::rigids::checks::{TOP_SPEED, ranged};

/// Maximum spin (rad/s) of shapes so small that [`TOP_SPEED`] would allow more: two revolutions per step.
const MAX_SPIN: f32 = 720.0;

/// A steady spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// Unit vector in the rigid's own space.
    pub axis: Vector,
    /// Angular velocity (rad/s), limited by [`super::TOP_SPEED`] at the surface; 0: no spin.
    pub rate: f32,
}

impl Spin {
    /// No spin.
    pub const NONE: Spin = Spin {
        axis: Vector::Y,
        rate: 0.0,
    };
}

/// Reads a spin: axis and rate (rad/s). The axis is normalised.
///
/// # Errors
/// A number is not finite or out of range, or the axis is zero.
pub(super) fn spin_of(axis: [f32; 3], rate: f32) -> Result<Spin, ParameterError> {
    let rate = ranged("rigid.spin.rate", rate, (-f64::from(MAX_SPIN), f64::from(MAX_SPIN)))?;
    for (name, value) in ["x", "y", "z"].iter().zip(axis) {
        ranged(&format!("rigid.spin.axis.{name}"), value, (-1e3, 1e3))?;
    }
    let length = Vector::from(axis).length();
    ranged("rigid.spin.axis", length, (1e-3, 2e3))?;
    // An axis of unit length up to rounding stays bit for bit, as with rotations.
    let scale = if (length - 1.0).abs() < 1e-5 { 1.0 } else { 1.0 / length };
    let axis = Vector::from(axis) * scale;
    Ok(Spin { axis, rate })
}

/// Checks that a rigid of `reach` (m) stays below [`TOP_SPEED`].
pub(super) fn check_spin(spin: &Spin, reach: f32) -> Result<(), ParameterError> {
    let most = f64::from((TOP_SPEED / reach).min(MAX_SPIN));
    ranged("rigid.spin.rate", spin.rate, (-most, most)).map(|_| ())
}
