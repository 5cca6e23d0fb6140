//! The state of the shedders.

use crate::layout::parameters::item::LIST_LIMIT;
use crate::math::hash::Hash;
use crate::math::random::Random;

/// State of the shedders between steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shedding {
    /// Per shedder: the fraction of a vortex particle that it owes, 0..1.
    pub owed: [f64; LIST_LIMIT],
    /// Per shedder: the number that fell due so far.
    pub due: [u64; LIST_LIMIT],
    pub random: Random,
}

impl Shedding {
    /// The initial state.
    pub fn new(seed: u32) -> Self {
        Self {
            owed: [0.0; LIST_LIMIT],
            due: [0; LIST_LIMIT],
            // A stream of its own: shedding must not affect the emitters.
            random: Random::new(seed ^ 0x9e37_79b9),
        }
    }

    pub fn hash_into(&self, hash: &mut Hash) {
        self.owed.iter().for_each(|owed| hash.long(owed.to_bits()));
        self.due.iter().for_each(|due| hash.long(*due));
        hash.long(self.random.state());
    }
}
