//! The integration tests, in one program.
//!
//! Linking costs far more than compiling: a program for each file would link the simulator each time. A new file is a
//! `mod` in the `mod.rs` of its folder; `cargo test -p sim-tests NAME` runs one.

mod arrange;
mod collide;
mod common;
mod emission;
mod forces;
mod layers;
mod life;
#[cfg(feature = "rigids")]
mod rigids;
mod simulator;

use std::path::Path;

/// Files that are separate programs. `memory` counts the allocations of the whole process.
const PROGRAMS: [&str; 2] = ["all", "memory"];

#[test]
fn every_file_of_tests_is_declared() {
    assert_declared(Path::new(env!("CARGO_MANIFEST_DIR")), "all.rs");
}

/// Asserts that `list` in `folder` declares each file and each folder beside it as a module.
fn assert_declared(folder: &Path, list: &str) {
    let declarations = std::fs::read_to_string(folder.join(list)).unwrap();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        if path.is_dir() {
            assert_declared(&path, "mod.rs");
        } else if path.extension().is_none_or(|extension| extension != "rs")
            || [&PROGRAMS[..], &["mod"]].concat().contains(&name)
        {
            continue;
        }
        let is_declared = declarations
            .lines()
            .any(|line| line.trim_start_matches("pub ") == format!("mod {name};"));
        assert!(
            is_declared,
            "{} runs nowhere: add `mod {name};` to {list}",
            path.display()
        );
    }
}
