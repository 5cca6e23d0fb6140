//! Builds one variant: cargo for wasm32, then wasm-bindgen as a library, so that its version is the one in Cargo.lock.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use wasm_bindgen_cli_support::Bindgen;

use crate::folders::Folders;
use crate::rapier::trim;

const TARGET: &str = "wasm32-unknown-unknown";
/// See `Cargo.toml`.
const PROFILE: &str = "wasm";

/// One build of the bindings.
pub struct Variant {
    /// Name of the output folder.
    pub name: &'static str,
    features: &'static [&'static str],
    has_rapier: bool,
    /// Limit for inlining. It applies to parry's and Rapier's code too.
    inlined: u32,
}

/// Set-up code is not inlined: a tenth of the module. Loops over particles mark what must be inlined. Only short loops
/// are unrolled, and only completely: unrolling loops over particles gains nothing.
fn llvm_arguments(Variant { inlined, .. }: &Variant) -> [String; 1] {
    [format!(
        "-Cllvm-args=-inline-threshold={inlined} -unroll-threshold=60 -unroll-partial-threshold=0 -unroll-runtime=false"
    )]
}

/// All builds in order. The smallest comes first: most pages load it.
pub const VARIANTS: &[Variant] = &[
    Variant {
        name: "core",
        features: &[],
        has_rapier: false,
        inlined: 60,
    },
    Variant {
        name: "meshes",
        features: &["meshes"],
        has_rapier: false,
        inlined: 25,
    },
    Variant {
        name: "physics",
        features: &["rigids"],
        has_rapier: true,
        inlined: 25,
    },
];

/// With calls for measurements; no page loads it.
pub const BENCH: Variant = Variant {
    name: "bench",
    features: &["bench"],
    has_rapier: true,
    inlined: 25,
};

/// Generated files of a variant. If one is missing, the variant is built again.
pub const FILES: &[&str] = &["bindings.js", "bindings.d.ts", "bindings_bg.wasm"];

/// Builds `variant` into its folder under `output`.
///
/// # Returns
/// The size of the WASM module, bytes.
///
/// # Errors
/// When cargo or wasm-bindgen fail, or the folder cannot be written.
pub fn build(variant: &Variant, folders: &Folders, output: &Path) -> Result<u64> {
    let target = folders.workspace.join("target").join("wasm");
    compile(variant, folders, &target)?;
    let module = target.join(TARGET).join(PROFILE).join("bindings.wasm");
    let folder = output.join(variant.name);
    let bytes = fs::read(&module).with_context(|| format!("{} cannot be read", module.display()))?;
    bind(if variant.has_rapier { trim(&bytes)? } else { bytes }, &folder)?;
    let size = fs::metadata(folder.join("bindings_bg.wasm"))?.len();
    Ok(size)
}

fn compile(variant: &Variant, folders: &Folders, target: &PathBuf) -> Result<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .current_dir(&folders.workspace)
        .args(["build", "--package", "bindings", "--profile", PROFILE, "--locked"])
        .args(["--target", TARGET])
        .arg("--target-dir")
        .arg(target)
        .args([
            "--config",
            &format!("target.{TARGET}.rustflags={:?}", llvm_arguments(variant)),
        ])
        .args(["--features", &variant.features.join(",")])
        .status()
        .context("cargo cannot be started")?;
    if !status.success() {
        bail!("the {} variant does not compile", variant.name);
    }
    Ok(())
}

fn bind(module: Vec<u8>, folder: &Path) -> Result<()> {
    Bindgen::new()
        .input_bytes("bindings", module)
        .web(true)?
        .typescript(true)
        .omit_default_module_path(true)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(folder)
        .with_context(|| format!("wasm-bindgen refused what goes to {}", folder.display()))
}
