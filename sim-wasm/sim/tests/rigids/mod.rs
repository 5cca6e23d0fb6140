//! Rigid bodies.

mod air;
mod compound;
mod drag;
mod removal;
mod sensors;
