//! Numbers in whole parts, as takes keep them.

use crate::layout::error::{ParameterError, RestoreError};

/// `value` in whole parts, `parts` to a unit. Refuses by name what is not finite or outside of `range`.
pub(crate) fn quantise(key: &str, value: f64, range: [f64; 2], parts: f64) -> Result<f64, ParameterError> {
    let [min, max] = range;
    if (min..=max).contains(&value) {
        return Ok(libm::round(value * parts));
    }
    Err(ParameterError::out_of_range(key, value, min, max))
}

/// `value` if it is one that the quantiser can have made.
pub(crate) fn within<T: PartialOrd>(value: T, min: T, max: T) -> Result<T, RestoreError> {
    if (min..=max).contains(&value) {
        return Ok(value);
    }
    Err(impossible_input())
}

pub(crate) fn impossible_input() -> RestoreError {
    RestoreError::new("the take holds an input that nobody can have given")
}
