//! The state of the shedders.

use crate::layout::parameters::item::LIST_LIMIT;
use crate::math::hash::Hash;
use crate::math::random::Random;

/// What shedders remember from step to step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shedding {
    /// Of each shedder the part of a vortex particle that it owes, 0..1.
    pub owed: [f64; LIST_LIMIT],
    /// Of each shedder, how many fell due so far.
    pub due: [u64; LIST_LIMIT],
    pub random: Random,
}

impl Shedding {
    /// Nothing shed yet.
    pub fn new(seed: u32) -> Self {
        Self {
            owed: [0.0; LIST_LIMIT],
            due: [0; LIST_LIMIT],
            // Not the stream of the emitters, which must not change with what is shed.
            random: Random::new(seed ^ 0x9e37_79b9),
        }
    }

    pub fn hash_into(&self, hash: &mut Hash) {
        self.owed.iter().for_each(|owed| hash.long(owed.to_bits()));
        self.due.iter().for_each(|due| hash.long(*due));
        hash.long(self.random.state());
    }
}
