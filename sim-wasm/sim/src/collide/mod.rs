//! Collision of particles with one obstacle. Resolution of all collisions is in `simulator::collisions`.
//!
//! Particles are spheres. [`contact`] is the exact test; `survey` culls by boxes, four particles at a time.

pub mod analytic;
pub mod contact;
pub mod core;
pub mod pool;
pub mod shapes;
pub(crate) mod survey;
pub(crate) mod swept_particle;

pub use analytic::{AnalyticCollider, ColliderShape};
