//! Sizes as drawn: `emission.sizeSpread`.
//!
//! Few puffs are large and many are small: sizes are multiplied by 1 + spread (3 v^3 - 0.55), of which the mean is about 1.
//! A part of v, 0..=1, is random for each puff. The other is the level of its emitter, which changes smoothly, so that a
//! plume swells and thins. Large puffs live longer.

use crate::math::hash::Hash;
use crate::math::random::Random;

/// Time between two random levels of an emitter (s).
pub const SWELL_TIME: f64 = 0.6;
/// Share of the emitter's level in v.
pub const SHARED: f32 = 0.6;
/// Share of a change of size by which the lifetime changes.
pub const OF_LIFETIME: f32 = 0.5;

/// The level of emitter `number` at `time` (s), 0..=1: random values every [`SWELL_TIME`], with smooth steps between.
pub fn level(seed: u32, number: usize, time: f64) -> f32 {
    let at = time / SWELL_TIME;
    let before = libm::floor(at);
    let value = |index: u64| {
        let mut hash = Hash::new();
        hash.word(seed);
        hash.word(number as u32);
        hash.long(index);
        let mut random = Random::from_state(hash.finish());
        random.bits();
        random.unit()
    };
    let share = (at - before) as f32;
    let smooth = share * share * (3.0 - 2.0 * share);
    let [from, to] = [before as u64, before as u64 + 1].map(value);
    from + (to - from) * smooth
}

/// The factor on a size by the level of the emitter and a random number, both 0..=1.
pub fn factor(spread: f32, level: f32, random: f32) -> f32 {
    let v = SHARED * level + (1.0 - SHARED) * random;
    1.0 + spread * (3.0 * v * v * v - 0.55)
}

/// The lifetime of a puff of which the size was multiplied by `factor`.
pub fn lifetime(lifetime: f32, factor: f32) -> f32 {
    lifetime * (1.0 + OF_LIFETIME * (factor - 1.0))
}
