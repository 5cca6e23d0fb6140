//! Errors of the simulator as plain JavaScript objects.

use js_sys::{Object, Reflect};
use sim::error::ParameterError;
use wasm_bindgen::prelude::*;

/// `{ key, value, min, max, message }` of a refused parameter; min and max are NaN where there is no range.
pub fn parameter_refusal(error: ParameterError) -> JsValue {
    refusal(&error.key, error.value, error.min, error.max, &error.message)
}

/// A refusal that is about no single number: the key is empty.
pub fn plain_refusal(message: &str) -> JsValue {
    refusal("", f64::NAN, f64::NAN, f64::NAN, message)
}

fn refusal(key: &str, value: f64, min: f64, max: f64, message: &str) -> JsValue {
    let object = Object::new();
    put(&object, "key", &key.into());
    put(&object, "value", &value.into());
    put(&object, "min", &min.into());
    put(&object, "max", &max.into());
    put(&object, "message", &message.into());
    object.into()
}

/// Gives a fresh plain object a property.
pub fn put(object: &Object, name: &str, value: &JsValue) {
    Reflect::set(object, &name.into(), value).expect("a fresh plain object takes every property");
}
