//! Collision of particles with one obstacle. Resolution of all collisions is in `simulator::collisions`.
//!
//! Particles are spheres. [`contact`] is the exact test; `broad_phase` culls by boxes, four particles at a time.

pub mod analytic;
pub(crate) mod broad_phase;
pub mod contact;
pub mod core;
pub mod pool;
pub mod shapes;
pub(crate) mod swept_particle;

pub use analytic::{AnalyticCollider, ColliderShape};
