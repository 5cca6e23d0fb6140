//! Rigid bodies.

mod air;
mod compound;
mod drag;
mod joints;
mod paths;
mod removal;
mod sensors;
