//! Where a take begins.

use crate::layout::parameters::table::Parameters;

/// Where a take begins.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The simulation as `save` writes it; empty in a take that was read and begins with a fresh scene.
    pub(super) state: Vec<u8>,
    /// Nothing has happened yet: seed, capacity and parameters say all, in the same scene.
    pub(super) is_fresh: bool,
    /// Fingerprint of the rigids and of the surfaces that emitters smoke from.
    pub(super) scene: u64,
    pub seed: u32,
    pub capacity: u32,
    /// Steps made before the take.
    pub step: u64,
    pub(super) parameters: Parameters,
}
