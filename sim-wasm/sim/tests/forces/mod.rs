//! Forces on air and particles.

mod closed_forms;
mod edges;
mod explosions;
mod flows;
mod jets;
mod looks;
mod orbits;
#[cfg(feature = "rigids")]
mod riding;
mod scopes;
mod shapes;
mod spirals;
mod turbulence;
mod vortex;
mod vortex_particles;
#[cfg(feature = "rigids")]
mod vortex_shedding;
mod weather;
