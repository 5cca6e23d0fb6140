//! Births: how many, and when.
//!
//! An emitter owes rate * share / (sum of shares) * level particles a second, its envelope's level in the middle of the
//! step. What it owes is kept as a fraction, so that counts are exact over any time. Each birth has its own moment
//! within the step, at which the emitter stands where its rigid has carried it by then, and from which on the particle
//! moves (see `motion::PoseMotion::launch`). Therefore neither a fast jet nor wind nor a fast emitter shows beads.
//!
//! A burst is owed as a whole when the envelope starts, and spread evenly over that step. When the simulator is full,
//! births wait, bursts too, and are made up as soon as there is room, of which each emitter gets at least about its
//! share, so that none starves.

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

/// What emitters remember from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Births {
    /// Of each emitter: the part of a particle that it owes, 0..1.
    pub owed: [f64; LIST_LIMIT],
    /// Of each emitter: how many births wait for room.
    pub waiting: [u64; LIST_LIMIT],
}

impl Births {
    /// How many births wait for room.
    pub fn waiting(&self) -> u64 {
        self.waiting.iter().fold(0, |sum, count| sum.saturating_add(*count))
    }

    /// The births of one step.
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

    /// Births that waited, spread evenly over the step. Where there is no room for all, each emitter gets its share of
    /// the room.
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
            // Rounded up: who is first gets at least one, and everybody is first at times.
            let part = libm::ceil(source.room() as f64 * (waiting as f64 / left));
            let count = waiting.min(part as u64).min(source.room() as u64);
            for number in 0..count {
                source.spawn(around.dt * (number as f64 + 0.5) / count as f64);
            }
            self.waiting[index] -= count;
            left -= waiting as f64;
        }
    }

    /// Births that fall due in this step, each at its moment.
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

/// The numbers below `count` in an order that begins with another one at each step, without a period that deaths could
/// keep time with.
fn rotated_order(count: usize, step: u64) -> impl Iterator<Item = usize> {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let first = (step.wrapping_mul(GOLDEN) >> 33) as usize;
    (0..count).map(move |turn| (first + turn) % count)
}

/// How many births the bursts of `emitter` owe that begin between the middles of the last step and of this one: starts
/// that are whole numbers of steps then never depend on rounding.
fn burst(emitter: &Emitter, around: &EmissionContext) -> u64 {
    if emitter.burst_count <= 0.0 {
        return 0;
    }
    let starts = |time| envelope::starts_until(&emitter.scope, time);
    let begun = starts(around.time) - starts(around.time - around.dt);
    begun.saturating_mul(emitter.burst_count as u64)
}
