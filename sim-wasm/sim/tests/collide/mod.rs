//! Particles against colliders and rigids.

mod analytic;
#[cfg(feature = "rigids")]
pub mod cloud;
mod core;
mod fixture;
#[cfg(feature = "rigids")]
mod grid;
#[cfg(feature = "rigids")]
mod inside;
#[cfg(feature = "rigids")]
mod moving;
mod pool;
#[cfg(feature = "rigids")]
mod restore;
