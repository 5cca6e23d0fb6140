//! Errors of the simulator as plain JavaScript objects.

use sim::layout::error::ParameterError;
use wasm_bindgen::prelude::*;

// js-sys provides both, with twice as much glue code.
#[wasm_bindgen]
extern "C" {
    /// A plain JavaScript object.
    pub type Object;

    #[wasm_bindgen(constructor)]
    pub fn new() -> Object;

    /// Sets a property.
    #[wasm_bindgen(method, structural, indexing_setter)]
    pub fn put(this: &Object, name: &str, value: JsValue);
}

/// `{ key, value, min, max, message }` of a parameter error. `min` and `max` are NaN without a range.
pub fn parameter_error(error: ParameterError) -> JsValue {
    error_object(&error.key, error.value, error.min, error.max, &error.message)
}

/// An error without a key.
pub fn plain_error(message: &str) -> JsValue {
    error_object("", f64::NAN, f64::NAN, f64::NAN, message)
}

fn error_object(key: &str, value: f64, min: f64, max: f64, message: &str) -> JsValue {
    let object = Object::new();
    object.put("key", key.into());
    object.put("value", value.into());
    object.put("min", min.into());
    object.put("max", max.into());
    object.put("message", message.into());
    object.into()
}
