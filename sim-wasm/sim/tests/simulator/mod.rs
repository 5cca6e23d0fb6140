//! The simulator as a whole: state, errors, takes.

mod errors;
mod looks;
mod page_table;
mod parts;
mod properties;
mod saving;
mod take_blow;
mod take_bytes;
mod take_replay;
