//! A steady spin.

use crate::layout::error::ParameterError;
use crate::math::vector::Vector;
use crate::rigids::checks::{TOP_SPEED, ranged};

/// Fastest spin (rad/s), for shapes so small that [`TOP_SPEED`] would allow more: two turns a step.
const MAX_SPIN: f32 = 720.0;

/// A steady spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// Unit vector in the rigid's own space.
    pub axis: Vector,
    /// rad/s, at most so much that no point of the surface is faster than [`super::TOP_SPEED`]; 0: none.
    pub rate: f32,
}

impl Spin {
    /// No spin.
    pub const NONE: Spin = Spin {
        axis: Vector::Y,
        rate: 0.0,
    };
}

/// Reads a spin: its axis, brought to unit length, and its rate (rad/s).
///
/// # Errors
/// When a number is not finite or too large, or the axis has no direction.
pub(super) fn spin_of(axis: [f32; 3], rate: f32) -> Result<Spin, ParameterError> {
    let rate = ranged("rigid.spin.rate", rate, (-f64::from(MAX_SPIN), f64::from(MAX_SPIN)))?;
    for (name, value) in ["x", "y", "z"].iter().zip(axis) {
        ranged(&format!("rigid.spin.axis.{name}"), value, (-1e3, 1e3))?;
    }
    let length = Vector::from(axis).length();
    ranged("rigid.spin.axis", length, (1e-3, 2e3))?;
    // What is a unit but for rounding stays bit for bit, as with rotations.
    let scale = if (length - 1.0).abs() < 1e-5 { 1.0 } else { 1.0 / length };
    let axis = Vector::from(axis) * scale;
    Ok(Spin { axis, rate })
}

/// Refuses a spin at which a rigid of `reach` (m) would be faster than [`TOP_SPEED`].
pub(super) fn check_spin(spin: &Spin, reach: f32) -> Result<(), ParameterError> {
    let most = f64::from((TOP_SPEED / reach).min(MAX_SPIN));
    ranged("rigid.spin.rate", spin.rate, (-most, most)).map(|_| ())
}
