//! The particle simulator of cartoon-smoke: pure, deterministic, without WASM and without a clock.
//!
//! Start at [`Simulator::step`], which shows the order of a step. The folders are layers: each uses only those before it
//! in this list.

pub mod arrange;
pub mod collide;
pub mod emission;
pub mod forces;
pub mod layout;
pub mod life;
pub mod math;
pub mod particles;
#[cfg(feature = "meshes")]
pub mod rigids;
pub mod simulator;

pub use layout::error::{ParameterError, RestoreError};
pub use simulator::Simulator;
