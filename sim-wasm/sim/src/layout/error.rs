//! Errors of the simulator. Invalid input never panics.

use std::fmt;

/// An invalid parameter, argument or view. The call that returned it changed nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterError {
    /// The key as the caller gave it, for example `emission.rate` or `emitters.0.size`.
    pub key: String,
    /// The invalid value, in the unit of the parameter.
    pub value: f64,
    /// Minimum accepted value; NaN without a range.
    pub min: f64,
    /// Maximum accepted value; NaN without a range.
    pub max: f64,
    /// What happened and what to do, as one sentence.
    pub message: String,
}

impl ParameterError {
    /// A value that is out of range or not finite.
    #[cold]
    #[inline(never)]
    pub fn out_of_range(key: &str, value: f64, min: f64, max: f64) -> Self {
        let message = advice(key, value, "finite", min, max);
        Self {
            key: key.to_owned(),
            value,
            min,
            max,
            message,
        }
    }

    /// A value that must be a whole number.
    pub fn not_whole(key: &str, value: f64, min: f64, max: f64) -> Self {
        let message = advice(key, value, "whole", min, max);
        Self {
            key: key.to_owned(),
            value,
            min,
            max,
            message,
        }
    }

    /// More looks than puffs can have at a time.
    #[cold]
    pub fn too_many_looks() -> Self {
        let message = "there would be 16 looks at once; at most 15 different ones are possible, of emitters and of puffs in the air";
        Self {
            key: "look".to_owned(),
            value: 16.0,
            min: 0.0,
            max: 15.0,
            message: message.to_owned(),
        }
    }

    /// An unknown key.
    pub fn unknown_key(key: &str, value: f64) -> Self {
        let message = format!("there is no parameter named {key}");
        Self {
            key: key.to_owned(),
            value,
            min: f64::NAN,
            max: f64::NAN,
            message,
        }
    }
}

#[cfg(not(target_family = "wasm"))]
fn advice(key: &str, value: f64, kind: &str, min: f64, max: f64) -> String {
    format!("{key} is {value}; give a {kind} number from {min} to {max}")
}

/// Without the numbers: formatting them takes 20 kB. The web side adds them.
#[cfg(target_family = "wasm")]
fn advice(key: &str, _value: f64, kind: &str, _min: f64, _max: f64) -> String {
    format!("{key} is out of range; give a {kind} number within it")
}

impl fmt::Display for ParameterError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for ParameterError {}

/// Saved bytes that cannot be restored. The call that returned it changed nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RestoreError {
    /// What is wrong with the bytes and what to do, as one sentence.
    pub message: String,
}

impl RestoreError {
    /// Creates an error with `message`.
    #[cold]
    #[inline(never)]
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
        }
    }
}

impl From<ParameterError> for RestoreError {
    fn from(error: ParameterError) -> Self {
        Self::new(error.message)
    }
}

impl fmt::Display for RestoreError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for RestoreError {}
