//! The origin of a take.

use crate::layout::parameters::table::Parameters;

/// The state in which a take starts.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The saved simulation; empty in a parsed take that starts from a fresh scene.
    pub(super) state: Vec<u8>,
    /// The scene is in its initial state: seed, capacity and parameters determine it.
    pub(super) is_fresh: bool,
    /// Hash of the rigids and of the surfaces of emitters.
    pub(super) scene: u64,
    pub seed: u32,
    pub capacity: u32,
    /// Number of steps before the take.
    pub step: u64,
    pub(super) parameters: Parameters,
}
