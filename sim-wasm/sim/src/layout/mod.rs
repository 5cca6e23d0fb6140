//! Data at the interface of the simulator: parameters, scopes, quantised inputs, bytes and errors.

pub mod blow;
pub(crate) mod bytes;
pub mod error;
pub mod gust;
pub mod limits;
pub mod parameters;
pub(crate) mod quantise;
pub mod quantised;
pub mod scope;
