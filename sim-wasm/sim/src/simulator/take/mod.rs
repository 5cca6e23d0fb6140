//! Takes: what a person did, by step, so that it can be done again to the same hash.
//!
//! A simulation that records keeps its state at the start of the take and a log of inputs. An input is quantised first
//! and acts then, so that what was live and what is replayed are the same. It acts in the step that follows: the
//! inputs of step k are those given after k steps were made. They are no part of the hash after k steps, with two
//! exceptions that change particles at once: another capacity that is too small, and another integrator. [`Simulator::rewind`] goes back and the log runs again;
//! an input that comes while the log runs takes over, and the rest of the log is dropped.
//!
//! What the program does by itself at the same steps, such as a scene that steers a rigid by the clock, is no input.

pub mod active_inputs;
pub(crate) mod bytes;
pub(crate) mod columns;
pub mod input;
pub(crate) mod live;
pub mod log;
pub(crate) mod origin;
pub(crate) mod recorder;
pub(crate) mod replay;

pub use bytes::Take;
pub use origin::Origin;
