//! Births: their number and their times.
//!
//! An emitter owes rate * share / (sum of shares) * level particles per second, with the level of its envelope in the
//! middle of the step. The fraction of a particle is carried over, so counts are exact over any time. Each birth has
//! its own time within the step. The emitter stands at its pose of that time, and the particle moves from then on (see
//! `ParticleMotion::launch`), so fast jets, wind and fast emitters leave no gaps.
//!
//! A burst is owed when the envelope starts and is spread evenly over that step. Births wait while the simulator is
//! full and are made up when there is capacity, of which each emitter gets at least about its share.

pub(crate) mod birth;
pub(crate) mod shapes;
pub mod surface;

use crate::emission::birth::{EmissionContext, EmitterSource};
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::scope::envelope;
use crate::math::random::Random;
use crate::math::scalar::clamped;
use crate::particles::Particles;

/// State of the emitters between steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Births {
    /// Per emitter: the fraction of a particle that it owes, 0..1.
    pub owed: [f64; LIST_LIMIT],
    /// Per emitter: the number of births that wait for capacity.
    pub waiting: [u64; LIST_LIMIT],
}

impl Births {
    /// Number of births that wait for capacity.
    pub fn waiting(&self) -> u64 {
        self.waiting.iter().fold(0, |sum, count| sum.saturating_add(*count))
    }

    /// Makes the births of one step.
    pub fn step(&mut self, around: &EmissionContext, random: &mut Random, particles: &mut Particles) {
        let emitters = around.parameters.emitters.items();
        for (emitter, waiting) in emitters.iter().zip(&mut self.waiting) {
            *waiting = waiting.saturating_add(burst(emitter, around));
        }
        self.make_up(around, random, particles);
        let shares: f64 = emitters.iter().map(|emitter| emitter.share).sum();
        for index in rotated_order(emitters.len(), around.step) {
            let emitter = &emitters[index];
            let share = emitter.share / shares.max(f64::MIN_POSITIVE);
            let rate = around.parameters.emission.rate * share * envelope::level(&emitter.scope, around.time);
            if rate > 0.0 {
                self.emit(index, rate, &mut EmitterSource::new(emitter, around, random, particles));
            }
        }
    }

    /// Makes waiting births, spread evenly over the step. If capacity is short, each emitter gets its share.
    fn make_up(&mut self, around: &EmissionContext, random: &mut Random, particles: &mut Particles) {
        let emitters = around.parameters.emitters.items();
        let mut left: f64 = self.waiting[..emitters.len()].iter().map(|count| *count as f64).sum();
        if left == 0.0 {
            return;
        }
        for index in rotated_order(emitters.len(), around.step) {
            let waiting = self.waiting[index];
            if waiting == 0 {
                continue;
            }
            let mut source = EmitterSource::new(&emitters[index], around, random, particles);
            // Rounded up: the first emitter gets at least one, and every emitter is first in some steps.
            let part = libm::ceil(source.room() as f64 * (waiting as f64 / left));
            let count = waiting.min(part as u64).min(source.room() as u64);
            for number in 0..count {
                source.spawn(around.dt * (number as f64 + 0.5) / count as f64);
            }
            self.waiting[index] -= count;
            left -= waiting as f64;
        }
    }

    /// Makes the births due in this step, each at its time.
    fn emit(&mut self, index: usize, rate: f64, source: &mut EmitterSource) {
        // Sums of decimal fractions miss whole numbers by a few units in the last place.
        const SLACK: f64 = 1e-9;
        let before = self.owed[index];
        let owed = before + rate * source.dt();
        let due = libm::floor(owed + SLACK);
        for number in 1..=due as u64 {
            if source.room() == 0 {
                self.waiting[index] = self.waiting[index].saturating_add(due as u64 + 1 - number);
                break;
            }
            source.spawn(clamped((number as f64 - before) / rate, 0.0, source.dt()));
        }
        self.owed[index] = owed - due;
    }
}

/// The numbers below `count`, rotated by a different amount in each step. The amounts have no period that deaths could
/// synchronise with.
fn rotated_order(count: usize, step: u64) -> impl Iterator<Item = usize> {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let first = (step.wrapping_mul(GOLDEN) >> 33) as usize;
    (0..count).map(move |turn| (first + turn) % count)
}

/// Number of births of the bursts of `emitter` that start between the middle of the last step and the middle of this
/// one: a start at a whole number of steps does not depend on rounding.
fn burst(emitter: &Emitter, around: &EmissionContext) -> u64 {
    if emitter.burst_count <= 0.0 {
        return 0;
    }
    let starts = |time| envelope::starts_until(&emitter.scope, time);
    let begun = starts(around.time) - starts(around.time - around.dt);
    begun.saturating_mul(emitter.burst_count as u64)
}
