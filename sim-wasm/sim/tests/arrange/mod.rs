//! Rows and coverage.

mod coverage;
mod glow;
mod rows;
