//! Accepted ranges of descriptions, and the errors outside of them.

use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::math::vector::Vector;

/// Range of a length of a shape (m), and of a coordinate in world space (m).
pub(super) const LENGTHS: (f64, f64) = (1e-3, 1e3);

pub(super) const PLACES: (f64, f64) = (-1e4, 1e4);

pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// Least half length of a hull, and square root of the least area of a mesh (m).
pub(super) const MIN_HALF_EXTENT: f32 = 5e-4;

/// Reads position and quaternion. The quaternion is normalised.
///
/// # Errors
/// A number is missing, not finite or out of range, or the quaternion is zero.
pub fn pose_of(numbers: &[f32]) -> Result<Pose, ParameterError> {
    pose_under("rigid", numbers)
}

/// Same as [`pose_of`], with `name` in the keys of errors.
pub(super) fn pose_under(name: &str, numbers: &[f32]) -> Result<Pose, ParameterError> {
    let Ok([x, y, z, rotation @ ..]) = <[f32; 7]>::try_from(numbers) else {
        return Err(count_error(&format!("{name}.pose"), numbers.len(), 7));
    };
    for (axis, value) in AXES.iter().zip([x, y, z]) {
        ranged(&format!("{name}.position.{axis}"), value, PLACES)?;
    }
    for (part, value) in ["x", "y", "z", "w"].iter().zip(rotation) {
        ranged(&format!("{name}.rotation.{part}"), value, (-1e3, 1e3))?;
    }
    let length = rotation.iter().map(|part| part * part).sum::<f32>().sqrt();
    ranged(&format!("{name}.rotation"), length, (1e-3, 2e3))?;
    // A quaternion of unit length up to rounding stays bit for bit: saving and restoring must not change a pose.
    let scale = if (length - 1.0).abs() < 1e-5 { 1.0 } else { length };
    Ok(Pose {
        position: Vector::new(x, y, z),
        rotation: rotation.map(|part| part / scale),
    })
}

/// Checks that a number is finite and within a range.
pub(super) fn ranged(key: &str, value: f32, (min, max): (f64, f64)) -> Result<f32, ParameterError> {
    let wide = f64::from(value);
    // Bounds are compared as f32, so that 0.001 is accepted although it is 0.00099999 in f32.
    if value.is_finite() && value >= min as f32 && value <= max as f32 {
        Ok(value)
    } else {
        Err(ParameterError::out_of_range(key, wide, min, max))
    }
}

/// The error of a list of the wrong length.
pub(super) fn count_error(key: &str, count: usize, wanted: usize) -> ParameterError {
    shape_error(
        key,
        count as f64,
        format!("{key} takes {wanted} numbers and was given {count}"),
    )
}

/// An error without a range.
pub fn shape_error(key: &str, value: f64, message: String) -> ParameterError {
    ParameterError {
        key: key.to_owned(),
        value,
        min: f64::NAN,
        max: f64::NAN,
        message,
    }
}

/// The error of a rigid's index that is out of range; there are `count` rigids.
pub(super) fn no_such_rigid(index: u32, count: usize) -> ParameterError {
    ParameterError::out_of_range("rigid.index", f64::from(index), 0.0, count as f64 - 1.0)
}
