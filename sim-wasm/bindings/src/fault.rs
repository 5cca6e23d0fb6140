//! What is known about the last panic. WASM cannot unwind: after a panic the call traps, and all that the web side
//! gets is `unreachable`. The hook keeps the message, which can still be asked for afterwards.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;

thread_local! {
    static LAST_FAULT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Keeps the message of every panic from now on; runs once, when the module is instantiated.
#[wasm_bindgen(start)]
pub fn record_faults() {
    std::panic::set_hook(Box::new(|panic| {
        LAST_FAULT.with(|fault| *fault.borrow_mut() = panic.to_string());
    }));
}

/// Message and source line of the last panic; empty when there was none.
#[wasm_bindgen(js_name = lastFault)]
pub fn last_fault() -> String {
    LAST_FAULT.with(|fault| fault.borrow().clone())
}

/// Panics with `reason`, so that an application can try how it copes with a simulator that stops.
#[wasm_bindgen(js_name = provokeFault)]
pub fn provoke_fault(reason: &str) {
    panic!("{reason}");
}
