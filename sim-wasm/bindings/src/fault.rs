//! The message of the last panic. WASM cannot unwind: a panic traps, and the web side only sees `unreachable`. The hook
//! stores the message for a later call.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;

thread_local! {
    static LAST_FAULT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Stores the message of every panic. Runs once, when the module is instantiated.
#[wasm_bindgen(start)]
pub fn record_faults() {
    std::panic::set_hook(Box::new(|panic| {
        LAST_FAULT.with(|fault| *fault.borrow_mut() = panic.to_string());
    }));
}

/// Message and source line of the last panic; empty without one.
#[wasm_bindgen(js_name = lastFault)]
pub fn last_fault() -> String {
    LAST_FAULT.with(|fault| fault.borrow().clone())
}

/// Panics with `reason`, so that applications can test their handling of a stopped simulator.
#[wasm_bindgen(js_name = provokeFault)]
pub fn provoke_fault(reason: &str) {
    panic!("{reason}");
}
