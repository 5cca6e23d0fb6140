//! Births.

mod births;
mod moments;
#[cfg(feature = "rigids")]
mod riding;
mod shapes;
mod surface;
