//! Where things lie in the repository.

use std::path::{Path, PathBuf};

/// The folders that a build reads from and writes to.
pub struct Places {
    /// The Rust workspace, `sim-wasm/`.
    pub workspace: PathBuf,
    /// What the web side loads, `src/sim/wasm/`; not kept in git.
    pub output: PathBuf,
}

impl Places {
    /// Finds the folders from where this program's own manifest stands.
    pub fn find() -> Places {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR"))
            .parent()
            .expect("xtask stands inside the workspace")
            .to_path_buf();
        let output = workspace.with_file_name("src").join("sim").join("wasm");
        Places { workspace, output }
    }
}
