//! Checks whether the WASM was built from the current sources.
//!
//! `src/simulator/wasm/stamp.txt` holds one line, the SHA-256 of all sources in lower-case hex: for each file, in byte order
//! of its path, the path relative to `sim-wasm/` with `/` as separator, a NUL, the content, a NUL. The sources are
//! [`SINGLE_FILES`] and every file under [`FOLDERS`]. Other programs can compute the same digest in a few lines.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use sha2::{Digest, Sha256};

use crate::build::{FILES, VARIANTS};
use crate::folders::Folders;

const SINGLE_FILES: &[&str] = &[
    "../scripts/patches/rapier.rs",
    ".cargo/config.toml",
    "Cargo.lock",
    "Cargo.toml",
    "bindings/Cargo.toml",
    "rust-toolchain.toml",
    "sim/Cargo.toml",
    "world/Cargo.toml",
    "xtask/Cargo.toml",
];
const FOLDERS: &[&str] = &["bindings/src", "sim/src", "world/src", "xtask/src"];
const STAMP: &str = "stamp.txt";

/// The digest of the sources under `workspace`, as 64 hexadecimal digits.
///
/// # Errors
/// When a source cannot be read.
pub fn digest(workspace: &Path) -> Result<String> {
    let mut paths: Vec<String> = SINGLE_FILES.iter().map(|path| path.to_string()).collect();
    for folder in FOLDERS {
        collect(workspace, folder, &mut paths)?;
    }
    paths.sort();
    let mut hasher = Sha256::new();
    for path in &paths {
        let content = fs::read(workspace.join(path)).with_context(|| format!("{path} cannot be read"))?;
        hasher.update(path.as_bytes());
        hasher.update([0]);
        hasher.update(&content);
        hasher.update([0]);
    }
    Ok(hasher.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

fn collect(workspace: &Path, folder: &str, paths: &mut Vec<String>) -> Result<()> {
    let entries = fs::read_dir(workspace.join(folder)).with_context(|| format!("{folder} cannot be read"))?;
    for entry in entries {
        let entry = entry?;
        let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            collect(workspace, &path, paths)?;
        } else {
            paths.push(path);
        }
    }
    Ok(())
}

/// Returns true if the last build used sources of this digest and all its files exist.
pub fn is_fresh(folders: &Folders, digest: &str) -> bool {
    let stamped = fs::read_to_string(folders.output.join(STAMP)).unwrap_or_default();
    stamped.trim() == digest
        && VARIANTS.iter().all(|variant| {
            let folder = folders.output.join(variant.name);
            FILES.iter().all(|file| folder.join(file).is_file())
        })
}

/// Removes the stamp, so that an interrupted build does not count as complete.
///
/// # Errors
/// When the folder cannot be made or the old stamp cannot be removed.
pub fn clear(folders: &Folders) -> Result<()> {
    fs::create_dir_all(&folders.output)?;
    let stamp = folders.output.join(STAMP);
    if stamp.exists() {
        fs::remove_file(stamp)?;
    }
    Ok(())
}

/// Stores the digest of the built sources.
///
/// # Errors
/// When the stamp cannot be written.
pub fn write(folders: &Folders, digest: &str) -> Result<()> {
    fs::write(folders.output.join(STAMP), format!("{digest}\n"))?;
    Ok(())
}
