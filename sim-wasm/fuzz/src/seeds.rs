//! Valid inputs: without them the fuzzer would have to guess the formats.

use std::fs;
use std::path::Path;

use crate::forge::{self, ENVELOPE_BYTES};
use crate::running::lively;

/// Writes them to the folder in FUZZ_SEEDS and exits; returns if the variable is not set.
pub fn write_if_asked() {
    let Some(folder) = std::env::var_os("FUZZ_SEEDS") else {
        return;
    };
    let simulator = lively();
    let take = simulator.take("a note").expect("it records");
    for (name, first, bytes) in [("save", 1, simulator.save()), ("take", 3, take)] {
        let body = &bytes[ENVELOPE_BYTES..];
        let head = if first == 1 { forge::save() } else { forge::take() };
        let again = forge::sealed(head, body);
        assert!(again == bytes, "the forger writes another format than the simulator");
        write(&folder, name, first, &bytes);
        write(&folder, &format!("{name}-body"), first + 1, body);
    }
    let configuration: Vec<u8> = (0..40_u16)
        .flat_map(|key| [(key * 97).to_le_bytes().as_slice(), &f64::from(key).to_le_bytes()].concat())
        .collect();
    write(&folder, "configuration", 0, &configuration);
    std::process::exit(0);
}

fn write(folder: impl AsRef<Path>, name: &str, first: u8, rest: &[u8]) {
    let path = folder.as_ref().join(name);
    fs::write(path, [&[first], rest].concat()).expect("the folder takes files");
}
