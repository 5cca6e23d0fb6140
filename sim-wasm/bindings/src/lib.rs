//! The simulator for JavaScript: calls, numbers and addresses in WASM memory. All logic is in `sim`.

mod error;
mod fault;
#[cfg(feature = "bench")]
mod measure;
mod rigids;
mod simulator;
mod take;

use wasm_bindgen::prelude::*;

/// Steps without physics do not allocate, so the speed of the allocator hardly matters. It is far smaller than that of
/// the standard library.
#[cfg(target_family = "wasm")]
#[global_allocator]
static ALLOCATOR: rlsf::GlobalTlsf = rlsf::GlobalTlsf::new();

/// Layout constants for the web side: floats of a place row, words of an attribute row, floats of a view, floats of a
/// rigid in the pose array.
#[wasm_bindgen(js_name = layout)]
pub fn layout() -> Vec<u32> {
    vec![
        sim::arrange::PLACE_FLOATS as u32,
        sim::arrange::ATTRIBUTE_WORDS as u32,
        sim::arrange::VIEW_FLOATS as u32,
        simulator::RIGID_FLOATS as u32,
    ]
}
