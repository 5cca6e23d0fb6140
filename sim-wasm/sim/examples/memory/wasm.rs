//! The memory pass as a WASM module of its own, for `npm run bench -- sim`.

mod pass;

use std::cell::RefCell;

use pass::Columns;

thread_local! {
    static COLUMNS: RefCell<Columns> = RefCell::new(Columns::new(0));
}

/// Takes memory for `count` particles; what was taken before is given back.
#[unsafe(no_mangle)]
pub extern "C" fn prepare(count: u32) {
    COLUMNS.with(|columns| *columns.borrow_mut() = Columns::new(count as usize));
}

/// Makes `count` passes; the number returned means nothing.
#[unsafe(no_mangle)]
pub extern "C" fn pass(count: u32) -> u32 {
    COLUMNS.with(|columns| {
        let mut columns = columns.borrow_mut();
        (0..count).fold(0, |sum, _| sum ^ columns.pass())
    })
}
