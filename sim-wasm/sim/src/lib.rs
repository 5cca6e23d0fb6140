//! The particle simulator of cartoon-smoke: pure, deterministic, without WASM and without a clock.

pub mod collide;
pub mod error;
pub mod hash;
pub mod life;
pub mod particles;
#[cfg(feature = "rigids")]
pub mod rigids;
