//! `cargo xtask wasm [--force | --bench]`: builds the simulator as WASM, with its JavaScript and TypeScript bindings.
//!
//! Builds variants of one API into `src/simulator/wasm`: `core`, `meshes` (with parry) and `physics` (with Rapier). Skips
//! compilation if the sources are those of the last build; see [`stamp`]. `--bench` only builds one more with calls for
//! measurements, into `sim-wasm/target/wasm/bench`, since no page loads it.

mod build;
mod folders;
#[path = "../../../scripts/patches/rapier.rs"]
mod rapier;
mod stamp;

use std::process::ExitCode;

use anyhow::{Result, bail};
use folders::Folders;

const USAGE: &str = "usage: cargo xtask wasm [--force | --bench]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<()> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["wasm"] => wasm(false),
        ["wasm", "--force"] => wasm(true),
        ["wasm", "--bench"] => bench(),
        _ => bail!(USAGE),
    }
}

fn bench() -> Result<()> {
    let folders = Folders::find();
    build::build(&build::BENCH, &folders, &folders.workspace.join("target").join("wasm")).map(|_| ())
}

fn wasm(force: bool) -> Result<()> {
    let folders = Folders::find();
    let digest = stamp::digest(&folders.workspace)?;
    if !force && stamp::is_fresh(&folders, &digest) {
        println!("wasm is up to date");
        return Ok(());
    }
    stamp::clear(&folders)?;
    for variant in build::VARIANTS {
        println!("building wasm: {}", variant.name);
        let size = build::build(variant, &folders, &folders.output)?;
        println!("built {} ({} kB)", variant.name, size / 1000);
    }
    // Checked again: sources edited during compilation must not count as built.
    if stamp::digest(&folders.workspace)? == digest {
        stamp::write(&folders, &digest)?;
    }
    Ok(())
}
