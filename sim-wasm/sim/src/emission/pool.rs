//! Emitters outside of the table, for objects that come and go while the simulation runs.
//!
//! A slot holds the parameters of `emitters.#`; its `share` is its rate in particles per second. The caller chooses the
//! slots. The first one allocates the memory of all. A free slot has an emitter of size 0 and rate 0. Slots are saved; as of all emitters, only what they owe is part of
//! the hash.

use crate::emission::{Births, Debt};
use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::limits::POOL_LIMIT;
use crate::layout::parameters::accept;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::field::Meta;
use crate::layout::parameters::item::{LIST_LIMIT, Slot, meta, value};

/// Numbers of an emitter: its parameters in the order of the table, three for a vector.
pub const EMITTER_NUMBERS: usize = 30;
/// Largest share, which is a rate here (particles/s): the range of `emission.rate`.
const MAX_RATE: f64 = 20_000.0;

impl Births {
    /// Sets an emitter of the pool and adds births to those that an emitter makes in the next step.
    ///
    /// # Arguments
    /// * `index` - 0..=7 in the table, 8 plus the slot in the pool.
    /// * `numbers` - The [`EMITTER_NUMBERS`] of an emitter of the pool; none leave it as it is.
    /// * `count` - The number of births. With `numbers` they replace those that wait, unless it is 0. With 0 and no `numbers`
    ///   a slot becomes free and owes nothing.
    /// * `table` - The number of emitters in the table.
    ///
    /// # Errors
    /// There is no such emitter, or a number is out of range; nothing changes.
    #[cold]
    pub fn put(&mut self, index: usize, numbers: &[f64], count: u32, table: usize) -> Result<(), ParameterError> {
        if index >= table {
            let slot = index.wrapping_sub(LIST_LIMIT);
            if slot >= POOL_LIMIT {
                return Err(error_of(index));
            }
            if self.pool.is_empty() {
                if numbers.is_empty() && count == 0 {
                    return Ok(());
                }
                self.pool = vec![Emitter::default(); POOL_LIMIT];
            }
            let emitter = &mut self.pool[slot];
            if !numbers.is_empty() {
                *emitter = emitter_from(numbers)?;
                if count > 0 {
                    self.debts[index].waiting = 0;
                }
            } else if count == 0 {
                *emitter = Emitter::default();
                self.debts[index] = Debt::default();
            } else if emitter.size <= 0.0 {
                return Err(error_of(index));
            }
        }
        let Debt { waiting, .. } = &mut self.debts[index];
        *waiting = waiting.saturating_add(u64::from(count));
        Ok(())
    }
}

impl SnapshotSection for Births {
    #[cold]
    fn write(&self, body: &mut Writer) {
        let (table, pool) = self.debts().split_at(LIST_LIMIT);
        table.iter().for_each(|debt| body.number(debt.owed));
        table.iter().for_each(|debt| body.long(debt.waiting));
        for (emitter, debt) in self.pool.iter().zip(pool) {
            let mut emitter = *emitter;
            for number in 0..EMITTER_NUMBERS {
                body.number(*value(&mut emitter, place_of(number).1));
            }
            body.number(debt.owed);
            body.long(debt.waiting);
        }
    }

    #[cold]
    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let mut births = Self::default();
        for debt in &mut births.debts[..LIST_LIMIT] {
            debt.owed = read_owed(reader)?;
        }
        for debt in &mut births.debts[..LIST_LIMIT] {
            debt.waiting = reader.long()?;
        }
        // States without a pool end here, others have all of its slots.
        let mut index = LIST_LIMIT;
        while reader.end().is_err() {
            let mut numbers = [0.0; EMITTER_NUMBERS];
            for number in &mut numbers {
                *number = reader.number()?;
            }
            // A free slot is out of the ranges of an emitter.
            let is_free = numbers == [0.0; EMITTER_NUMBERS];
            births.put(index, if is_free { &[] } else { &numbers }, 0, 0)?;
            births.debts[index].owed = read_owed(reader)?;
            births.debts[index].waiting = reader.long()?;
            index += 1;
        }
        Ok(births)
    }
}

#[cold]
#[inline(never)]
fn read_owed(reader: &mut Reader) -> Result<f64, RestoreError> {
    reader.number().map(|owed| owed.clamp(-1.0, 1.0))
}

#[cold]
fn emitter_from(numbers: &[f64]) -> Result<Emitter, ParameterError> {
    let mut emitter = Emitter::default();
    for number in 0..EMITTER_NUMBERS {
        let (meta, at) = place_of(number);
        let given = numbers.get(number).copied().unwrap_or(f64::NAN);
        let max = if meta.key == "share" { MAX_RATE } else { meta.max };
        *value(&mut emitter, at) = accept(meta.key, &Meta { max, ..*meta }, given)?;
    }
    Ok(emitter)
}

/// The parameter of number 0..[`EMITTER_NUMBERS`] of an emitter.
#[cold]
#[inline(never)]
fn place_of(number: usize) -> (&'static Meta, Slot) {
    let (mut field, mut part) = (0, number);
    loop {
        let (meta, parts) = meta::<Emitter>(field).expect("an emitter has this many numbers");
        if part < parts.len() {
            return (meta, Slot { field, part });
        }
        part -= parts.len();
        field += 1;
    }
}

#[cold]
fn error_of(index: usize) -> ParameterError {
    ParameterError::out_of_range("emitter", index as f64, 0.0, (LIST_LIMIT + POOL_LIMIT - 1) as f64)
}
