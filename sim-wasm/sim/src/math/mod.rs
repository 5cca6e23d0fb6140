//! Vectors, poses, SIMD lanes, random numbers, hashes and sorting.

pub mod bounds;
pub(crate) mod double;
pub mod hash;
pub mod pose;
pub mod pose_motion;
pub(crate) mod radix_sort;
pub mod random;
pub(crate) mod scalar;
pub mod simd;
pub mod vector;
