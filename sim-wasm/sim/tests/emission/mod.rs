//! Births.

mod births;
mod looks;
mod moments;
mod per_metre;
mod pool;
#[cfg(feature = "rigids")]
mod riding;
mod shapes;
mod surface;
mod swelling;
