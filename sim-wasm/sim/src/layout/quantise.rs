//! Quantisation of inputs to whole numbers.

use crate::layout::error::{ParameterError, RestoreError};

/// Rounds `value` to whole units of 1 / `parts`. A value that is not finite or outside of `range` is an error that
/// names `key`.
pub(crate) fn quantise(key: &str, value: f64, range: [f64; 2], parts: f64) -> Result<f64, ParameterError> {
    let [min, max] = range;
    if (min..=max).contains(&value) {
        return Ok(libm::round(value * parts));
    }
    Err(ParameterError::out_of_range(key, value, min, max))
}

/// Returns `value` if the quantiser can have produced it.
pub(crate) fn within<T: PartialOrd>(value: T, min: T, max: T) -> Result<T, RestoreError> {
    if (min..=max).contains(&value) {
        return Ok(value);
    }
    Err(impossible_input())
}

pub(crate) fn impossible_input() -> RestoreError {
    RestoreError::new("the take contains an invalid input")
}
