//! Folders of the repository.

use std::path::{Path, PathBuf};

/// The folders that a build reads and writes.
pub struct Folders {
    /// The Rust workspace, `sim-wasm/`.
    pub workspace: PathBuf,
    /// Output for the web side, `src/simulator/wasm/`; not in git.
    pub output: PathBuf,
}

impl Folders {
    /// Finds the folders relative to this program's manifest.
    pub fn find() -> Folders {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR"))
            .parent()
            .expect("xtask stands inside the workspace")
            .to_path_buf();
        let output = workspace.with_file_name("src").join("simulator").join("wasm");
        Folders { workspace, output }
    }
}
