//! What smoke bumps into: analytic colliders here, rigids of Rapier by the feature `rigids`.
//!
//! Particles are spheres. Each one that comes near an obstacle meets it as [`contact`] tells; what is far is passed
//! over by boxes, four particles at a time.

pub mod analytic;
pub mod contact;
pub mod core;
pub mod shapes;
pub(crate) mod survey;
pub(crate) mod swept_particle;

pub use analytic::{AnalyticCollider, ColliderShape};
