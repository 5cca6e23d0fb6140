//! Births: their number and their times.
//!
//! An emitter owes rate * share / (sum of shares) * level particles per second, with the level of its envelope in the
//! middle of the step. The fraction of a particle is carried over, so counts are exact over any time. Each birth has
//! its own time within the step. The path of the emitter adds `perMetre` particles for each metre, as a rate for the
//! step; a path that would take more than [`TOP_SPEED`](crate::layout::limits::TOP_SPEED) is a jump and adds none. The emitter stands at its pose of that time, and the particle moves from then on (see
//! `ParticleMotion::launch`), so fast jets, wind and fast emitters leave no gaps.
//!
//! A burst is owed when the envelope starts, or when the caller asks for it, and is spread evenly over that step. Births
//! wait while the simulator is full and are made up when there is capacity, of which each emitter gets at least about
//! its share. Emitters of the pool follow those of the table and have rates of their own, see `pool`.

pub(crate) mod birth;
pub(crate) mod looks;
pub mod pool;
pub(crate) mod shapes;
pub mod surface;
pub mod swelling;

use crate::emission::birth::{EmissionContext, EmitterSource};
use crate::layout::limits::POOL_LIMIT;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::scope::envelope;
use crate::math::hash::Hash;
use crate::math::random::Random;
use crate::math::scalar::clamped;
use crate::math::vector::Vector;
use crate::particles::Particles;

/// What an emitter owes between steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Debt {
    /// The fraction of a particle that it owes, 0..1.
    pub owed: f64,
    /// The number of births that wait for capacity.
    pub waiting: u64,
    /// The place (m) of an emitter in world space at the end of the last step, if it emits by its path.
    place: Option<[f32; 3]>,
    /// The step at which the latest burst ends, as far as its births were made; 0 without births.
    end: u64,
}

impl Debt {
    /// Adds births at once.
    fn wait(&mut self, count: u64) {
        if count > 0 && self.waiting == 0 {
            self.end = 0;
        }
        self.waiting = self.waiting.saturating_add(count);
    }
}

/// State of the emitters between steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Births {
    /// What each emitter owes: first those of the table, then those of the pool.
    debts: [Debt; LIST_LIMIT + POOL_LIMIT],
    /// Emitters outside of the table by slot; empty until the first is set.
    pool: Vec<Emitter>,
}

impl Default for Births {
    fn default() -> Self {
        Self {
            debts: [Debt::default(); LIST_LIMIT + POOL_LIMIT],
            pool: Vec::new(),
        }
    }
}

impl Births {
    /// What each emitter of the table owes, then what those of the pool owe.
    pub fn debts(&self) -> &[Debt] {
        &self.debts[..LIST_LIMIT + self.pool.len()]
    }

    /// Number of births that wait for capacity.
    pub fn waiting(&self) -> u64 {
        self.debts.iter().fold(0, |sum, debt| sum.saturating_add(debt.waiting))
    }

    /// Drops the births that wait for capacity, and the ends of bursts.
    pub(crate) fn forget_waiting(&mut self) {
        self.debts.iter_mut().for_each(|debt| (debt.waiting, debt.end) = (0, 0));
    }

    /// The number of steps at which the last particle of the latest burst of an emitter ends: at the end of the longest
    /// lifetime, as of its birth. None without such an emitter or burst, and while births of it wait. Not saved.
    pub fn burst_end(&self, index: usize) -> Option<u64> {
        let debt = self.debts.get(index)?;
        (debt.end > 0 && debt.waiting == 0).then_some(debt.end)
    }

    /// Adds the places of emitters that emit by their paths to `hash`.
    pub(crate) fn hash_places_into(&self, hash: &mut Hash) {
        for (index, debt) in self.debts.iter().enumerate() {
            if let Some(place) = &debt.place {
                hash.word(index as u32);
                hash.floats(place);
            }
        }
    }

    /// Makes the births of one step.
    pub fn step(&mut self, around: &EmissionContext, random: &mut Random, particles: &mut Particles) {
        let emitters = around.parameters.emitters.items();
        let (table, pool) = self.debts.split_at_mut(LIST_LIMIT);
        for (emitter, debt) in emitters.iter().zip(table).chain(self.pool.iter().zip(pool)) {
            debt.wait(burst(emitter, around));
        }
        self.make_up(around, random, particles);
        let shares: f64 = emitters.iter().map(|emitter| emitter.share).sum();
        for number in rotated_order(emitters.len() + self.pool.len(), around.step) {
            let (emitter, debt) = self.emitter(emitters, number);
            let rate = if number < emitters.len() {
                around.parameters.emission.rate * (emitter.share / shares.max(f64::MIN_POSITIVE))
            } else {
                emitter.share
            };
            let (mut rate, mut way) = (rate, Vector::ZERO);
            if emitter.per_metre > 0.0 {
                let (length, vector) = around.path(emitter, &mut debt.place);
                rate += emitter.per_metre * length / around.dt;
                way = vector;
            } else {
                debt.place = None;
            }
            let rate = rate * envelope::level(&emitter.scope, around.time);
            if rate > 0.0 {
                emit(
                    debt,
                    rate,
                    &mut EmitterSource::new((number, emitter), way, around, random, particles),
                );
            }
        }
    }

    /// Emitter `number` of the table, followed by the pool, and what it owes.
    #[inline(never)]
    fn emitter<'e>(&'e mut self, table: &'e [Emitter], number: usize) -> (&'e Emitter, &'e mut Debt) {
        match number.checked_sub(table.len()) {
            None => (&table[number], &mut self.debts[number]),
            Some(slot) => (&self.pool[slot], &mut self.debts[LIST_LIMIT + slot]),
        }
    }

    /// Makes waiting births, spread evenly over the step. If capacity is short, each emitter gets its share.
    fn make_up(&mut self, around: &EmissionContext, random: &mut Random, particles: &mut Particles) {
        let emitters = around.parameters.emitters.items();
        let mut left: f64 = self.debts.iter().map(|debt| debt.waiting as f64).sum();
        if left == 0.0 {
            return;
        }
        for number in rotated_order(emitters.len() + self.pool.len(), around.step) {
            let (emitter, debt) = self.emitter(emitters, number);
            let waiting = debt.waiting;
            if waiting == 0 {
                continue;
            }
            let mut source = EmitterSource::new((number, emitter), Vector::ZERO, around, random, particles);
            // Rounded up: the first emitter gets at least one, and every emitter is first in some steps.
            let part = libm::ceil(source.room() as f64 * (waiting as f64 / left));
            let count = waiting.min(part as u64).min(source.room() as u64);
            for number in 0..count {
                let seconds = source.spawn(around.dt * (number as f64 + 0.5) / count as f64);
                let end = around.step.saturating_add(libm::ceil(seconds / around.dt) as u64);
                debt.end = debt.end.max(end);
            }
            debt.waiting -= count;
            left -= waiting as f64;
        }
    }
}

/// Makes the births due in this step, each at its time.
fn emit(debt: &mut Debt, rate: f64, source: &mut EmitterSource) {
    // Sums of decimal fractions miss whole numbers by a few units in the last place.
    const SLACK: f64 = 1e-9;
    let before = debt.owed;
    let owed = before + rate * source.dt();
    let due = libm::floor(owed + SLACK);
    for number in 1..=due as u64 {
        if source.room() == 0 {
            debt.waiting = debt.waiting.saturating_add(due as u64 + 1 - number);
            break;
        }
        source.spawn(clamped((number as f64 - before) / rate, 0.0, source.dt()));
    }
    debt.owed = owed - due;
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
