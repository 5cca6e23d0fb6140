//! The integration tests, in one program: a program for each file would be linked with the simulator each, which costs
//! far more than compiling them. A new file is a `mod` here; `cargo test -p sim --test all NAME` runs one.

mod anything;
mod arrange;
mod births;
mod collide;
#[cfg(feature = "rigids")]
mod collide_cloud;
mod collide_core;
mod collide_fixture;
#[cfg(feature = "rigids")]
mod collide_grid;
#[cfg(feature = "rigids")]
mod collide_inside;
#[cfg(feature = "rigids")]
mod collide_moving;
#[cfg(feature = "rigids")]
mod collide_restore;
mod common;
mod coverage;
mod emission_moments;
#[cfg(feature = "rigids")]
mod emission_riding;
mod emission_shapes;
mod emission_surface;
mod errors;
mod forces;
mod forces_edges;
mod forces_explosions;
mod forces_jets;
mod forces_orbits;
#[cfg(feature = "rigids")]
mod forces_riding;
mod forces_scopes;
mod forces_spirals;
mod forces_weather;
mod hold;
mod life;
mod life_curves;
mod page_table;
mod parts;
#[cfg(feature = "rigids")]
mod rigids_air;
#[cfg(feature = "rigids")]
mod rigids_compound;
#[cfg(feature = "rigids")]
mod rigids_drag;
#[cfg(feature = "rigids")]
mod rigids_joints;
#[cfg(feature = "rigids")]
mod rigids_paths;
#[cfg(feature = "rigids")]
mod rigids_sensors;
mod saving;
mod take_blow;
mod take_bytes;
mod take_replay;
mod turbulence;
mod vortex;
mod vortex_particles;
#[cfg(feature = "rigids")]
mod vortex_shedding;

/// Files that are a program of their own. `memory` counts what the whole process allocates.
const ALONE: [&str; 2] = ["all", "memory"];

#[test]
fn every_file_of_tests_is_run() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let listed = include_str!("all.rs");
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let name = path.file_stem().unwrap().to_str().unwrap();
        let is_listed = listed.lines().any(|line| line == format!("mod {name};"));
        assert!(
            is_listed || ALONE.contains(&name),
            "tests/{name}.rs runs nowhere: add `mod {name};` to tests/all.rs"
        );
    }
}
