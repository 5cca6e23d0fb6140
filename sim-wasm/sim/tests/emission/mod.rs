//! Births.

mod births;
mod moments;
mod pool;
#[cfg(feature = "rigids")]
mod riding;
mod shapes;
mod surface;
mod swelling;
