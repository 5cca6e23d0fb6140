//! Rows and coverage.

mod coverage;
mod rows;
