//! The simulator for JavaScript: calls, numbers and addresses in WASM memory. Everything that thinks is in `sim`.

mod error;
mod fault;
#[cfg(feature = "bench")]
mod measure;
mod rigids;
mod simulator;
mod take;

use wasm_bindgen::prelude::*;

/// Steps without physics take no memory, so that it hardly matters how fast this is. It is far smaller than the one of
/// the standard library.
#[cfg(target_family = "wasm")]
#[global_allocator]
static ALLOCATOR: rlsf::GlobalTlsf = rlsf::GlobalTlsf::new();

/// The layout constants that the web side must share: floats of a place row, words of an attribute row, floats of a view,
/// floats of a rigid in the pose array.
#[wasm_bindgen(js_name = layout)]
pub fn layout() -> Vec<u32> {
    vec![
        sim::arrange::PLACE_FLOATS as u32,
        sim::arrange::ATTRIBUTE_WORDS as u32,
        sim::arrange::VIEW_FLOATS as u32,
        simulator::RIGID_FLOATS as u32,
    ]
}
