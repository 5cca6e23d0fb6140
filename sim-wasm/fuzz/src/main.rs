//! The fuzz target. The first byte selects the input: a configuration, a saved simulation or a take, with or without a
//! valid envelope. With FUZZ_SEEDS=FOLDER it writes valid inputs there.
//!
//! Any input is either an error that leaves the running simulation unchanged, or accepted by a simulation that
//! continues.

#![no_main]

mod forge;
mod running;
mod seeds;

use libfuzzer_sys::fuzz_target;

fuzz_target!(
    init: seeds::write_if_asked(),
    |data: &[u8]| running::with(|running| {
        let Some((choice, rest)) = data.split_first() else {
            return;
        };
        match choice % 5 {
            0 => running.configure(rest),
            1 => running.restore(rest),
            2 => running.restore(&forge::sealed(forge::save(), rest)),
            3 => running.replay(rest),
            _ => running.replay(&forge::sealed(forge::take(), rest)),
        }
    })
);
