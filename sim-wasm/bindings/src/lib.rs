//! The simulator for JavaScript: calls, numbers and addresses in WASM memory. All logic is in `sim`.

mod error;
mod fault;
#[cfg(feature = "bench")]
mod measure;
mod rigids;
mod simulator;
mod take;

/// Steps without physics do not allocate, so the speed of the allocator hardly matters. It is far smaller than that of
/// the standard library.
#[cfg(target_family = "wasm")]
#[global_allocator]
static ALLOCATOR: rlsf::GlobalTlsf = rlsf::GlobalTlsf::new();
