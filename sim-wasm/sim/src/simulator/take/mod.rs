//! Takes: the inputs of a user by step, for a replay that ends with the same hash.
//!
//! A recording simulator keeps its state at the start of the take and a log of inputs. An input is quantised before it
//! acts, so a live run and its replay are equal. Inputs of step k are given after k steps and act in the step that
//! follows. They are not part of the hash after k steps, with exceptions that change the state at once: a smaller
//! capacity, another integrator, a clear, and an emission, whose slot owes nothing from then on. [`Simulator::rewind`] goes back and applies the log again. A new input drops the
//! rest of the log.
//!
//! Changes by the program itself at fixed steps, such as a scene that steers a rigid by the clock, are not inputs.

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
