//! The particle simulator of cartoon-smoke: pure, deterministic, without WASM and without a clock.
//!
//! Start at [`Simulator::step`], which shows the order of a step.

pub mod arrange;
mod bytes;
mod clamp;
pub mod collide;
pub mod coverage;
pub mod emission;
pub mod error;
pub mod forces;
pub mod hash;
pub mod held;
pub mod life;
#[cfg(feature = "bench")]
pub mod measure;
pub mod motion;
mod obstacles;
mod order;
pub mod parameters;
pub mod particles;
pub mod parts;
pub mod random;
#[cfg(feature = "rigids")]
pub mod rigids;
pub mod rows;
pub mod scope;
pub mod simd;
pub mod simulator;
mod snapshot;
pub mod take;
pub mod tile;
pub mod view;
pub mod vortex_particles;

pub use error::{ParameterError, RestoreError};
pub use simulator::Simulator;
