//! Emitters outside of the table, for objects that come and go while the simulation runs.
//!
//! A slot holds the parameters of `emitters.#`; its `share` is its rate in particles per second. The caller chooses the
//! slots, or starts emissions: each takes a slot until it is over. The first one allocates the memory of all. A free slot
//! has an emitter of size 0 and rate 0. Slots are saved; as of all emitters, only what they owe is part of the hash.

use std::ops::Range;
use std::slice::from_mut;

use crate::emission::{Births, Debt, looks};
use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::limits::{POOL_LIMIT, STEP};
use crate::layout::parameters::accept;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::field::Meta;
use crate::layout::parameters::item::{self as items, Item, LIST_LIMIT};
use crate::layout::parameters::table::Parameters;
use crate::layout::quantise::within;
use crate::particles::Particles;
use crate::particles::looks::PuffLook;

/// Numbers of an emitter: its parameters in the order of the table, three for a vector.
pub const EMITTER_NUMBERS: usize = 54;
/// The first of them, which all versions have; the others have defaults without effect.
const FIRST_NUMBERS: usize = 30;
/// Largest share, which is a rate here (particles/s): the range of `emission.rate`.
const MAX_RATE: f64 = 20_000.0;
/// Latest start of an emitter (s): no simulation lasts as long.
const LATEST: f64 = 1e12;

/// A slot of the pool as an emission sets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Emission {
    pub(crate) slot: u16,
    pub(crate) emitter: Emitter,
}

impl Emission {
    /// A number that no other emission of a run has: its step and its slot.
    pub fn number(&self) -> u64 {
        step_of(&self.emitter) * POOL_LIMIT as u64 + u64::from(self.slot)
    }

    /// The emitter that it sets.
    pub(crate) fn emitter(&self) -> (usize, &Emitter) {
        (usize::from(self.slot), &self.emitter)
    }

    /// Whether it has more than the first numbers.
    pub(crate) fn is_long(&self) -> bool {
        has_later(&self.emitter)
    }

    pub(crate) fn write(&self, body: &mut Writer) {
        body.short(self.slot);
        let end = if self.is_long() { EMITTER_NUMBERS } else { FIRST_NUMBERS };
        write_emitter(body, &self.emitter, 0..end);
    }

    pub(crate) fn read(reader: &mut Reader, is_long: bool) -> Result<Self, RestoreError> {
        let slot = within(reader.short()?, 0, POOL_LIMIT as u16 - 1)?;
        let end = if is_long { EMITTER_NUMBERS } else { FIRST_NUMBERS };
        let mut numbers = [0.0; EMITTER_NUMBERS];
        read_numbers(reader, &mut numbers[..end])?;
        let emitter = emitter_from(&numbers[..end], &Emitter::default())?;
        Ok(Self { slot, emitter })
    }
}

impl Births {
    /// Sets an emitter of the pool and adds births to those that an emitter makes in the next step.
    ///
    /// # Arguments
    /// * `index` - 0..=7 in the table, 8 plus the slot in the pool.
    /// * `numbers` - The [`EMITTER_NUMBERS`] of an emitter of the pool, or the first 30; none leave it as it is.
    /// * `count` - The number of births. With `numbers` they replace those that wait, unless it is 0. With 0 and no `numbers`
    ///   a slot becomes free and owes nothing.
    /// * `around` - The parameters and the particles before a step, and the number of that step; none for states that
    ///   were saved without a table.
    ///
    /// # Errors
    /// There is no such emitter, a number is out of range, or there would be too many looks; nothing changes.
    #[cold]
    pub fn put(
        &mut self,
        index: usize,
        numbers: &[f64],
        count: u32,
        around: Option<(&Parameters, &Particles, u64)>,
    ) -> Result<(), ParameterError> {
        if around.is_none_or(|(parameters, ..)| index >= parameters.emitters.items().len()) {
            let slot = index.wrapping_sub(LIST_LIMIT);
            if slot >= POOL_LIMIT {
                return Err(error_of(index));
            }
            if self.pool.is_empty() && numbers.is_empty() && count == 0 {
                return Ok(());
            }
            let mut emitter = self.pool.get(slot).copied().unwrap_or_default();
            if !numbers.is_empty() {
                emitter = emitter_from(numbers, &Emitter::default())?;
            } else if count == 0 {
                emitter = Emitter::default();
                self.debts[index] = Debt::default();
            } else if emitter.size <= 0.0 {
                return Err(error_of(index));
            }
            if let Some((parameters, particles, step)) = around.filter(|_| emitter.has_look()) {
                looks::needs(parameters, self, particles, step, Some((slot, &emitter)))?;
            }
            self.allocated()[slot] = emitter;
            if !numbers.is_empty() && count > 0 {
                self.debts[index].waiting = 0;
            }
        }
        self.debts[index].wait(u64::from(count));
        Ok(())
    }

    /// The emitters of the pool by slot.
    pub(crate) fn pool(&self) -> &[Emitter] {
        &self.pool
    }

    /// Whether the emitter of a slot may emit in step `step` or later.
    pub(crate) fn is_active(&self, slot: usize, step: u64) -> bool {
        let emitter = &self.pool[slot];
        let is_idle = emitter.share + emitter.per_metre + emitter.burst_count == 0.0;
        let waits = self.debts[LIST_LIMIT + slot].waiting > 0;
        (waits || !is_idle) && !self.is_over(slot, step)
    }

    /// Writes what [`Births::write`] leaves out, which older states do not have: the later numbers of emitters of the
    /// pool, and places. Nothing without either.
    #[cold]
    pub(crate) fn write_later(&self, body: &mut Writer) {
        let free = Emitter::default();
        for (index, debt) in self.debts.iter().enumerate() {
            let emitter = self.pool.get(index.wrapping_sub(LIST_LIMIT)).unwrap_or(&free);
            if debt.place.is_some() || has_later(emitter) {
                body.short(index as u16);
                write_emitter(body, emitter, FIRST_NUMBERS..EMITTER_NUMBERS);
                let place = debt.place.unwrap_or([NO_PLACE; 3]);
                place.iter().for_each(|part| body.word(part.to_bits()));
            }
        }
    }

    /// Reads what [`Births::write_later`] wrote.
    #[cold]
    pub(crate) fn read_later(&mut self, reader: &mut Reader) -> Result<(), RestoreError> {
        while reader.end().is_err() {
            let index = within(usize::from(reader.short()?), 0, LIST_LIMIT + POOL_LIMIT - 1)?;
            let mut spare = UNNAMED;
            let emitter = self.pool.get_mut(index.wrapping_sub(LIST_LIMIT));
            let emitter = emitter.filter(|emitter| emitter.size > 0.0).unwrap_or(&mut spare);
            read_later_numbers(reader, emitter)?;
            let mut place = [0.0; 3];
            for part in &mut place {
                *part = reader.float()?;
            }
            self.debts[index].place = (place != [NO_PLACE; 3]).then_some(place);
        }
        Ok(())
    }

    /// The emission that starts in a slot that is free before step `step`, or a changed one. None if all slots are taken, or
    /// if the emission `changed` is over.
    ///
    /// # Arguments
    /// * `numbers` - The [`EMITTER_NUMBERS`] of an emitter, or the first 30. Its envelope starts that long after the step. NaN leaves a
    ///   number of a changed emission as it is.
    /// * `changed` - The number of an emission.
    ///
    /// # Errors
    /// A number is out of range.
    #[cold]
    pub fn emission(
        &self,
        numbers: &[f64],
        changed: Option<u64>,
        step: u64,
    ) -> Result<Option<Emission>, ParameterError> {
        let is_free = |slot: usize| self.pool.get(slot).is_none_or(|_| self.is_over(slot, step));
        let slot = match changed {
            Some(number) => Some((number % POOL_LIMIT as u64) as usize)
                .filter(|slot| !is_free(*slot) && step_of(&self.pool[*slot]) == number / POOL_LIMIT as u64),
            None => (0..POOL_LIMIT).find(|slot| is_free(*slot)),
        };
        let Some(slot) = slot else {
            return Ok(None);
        };
        let before = changed.map_or(Emitter::default(), |_| self.pool[slot]);
        let mut emitter = emitter_from(numbers, &before)?;
        if changed.is_none() {
            emitter.scope.start += step as f64 * STEP;
        }
        let slot = slot as u16;
        Ok(Some(Emission { slot, emitter }))
    }

    /// Starts or changes an emission.
    #[cold]
    pub(crate) fn emit(&mut self, Emission { slot, emitter }: &Emission) {
        let slot = usize::from(*slot);
        let before = std::mem::replace(&mut self.allocated()[slot], *emitter);
        if before.scope.start != emitter.scope.start || before.size <= 0.0 {
            self.debts[LIST_LIMIT + slot] = Debt::default();
        }
    }

    /// Returns true if a slot emits nothing any more before step `step`: it is free, or its emission has ended.
    fn is_over(&self, slot: usize, step: u64) -> bool {
        let Emitter { size, scope, .. } = &self.pool[slot];
        let ends = scope.duration > 0.0 && scope.period <= 0.0;
        let is_past = scope.start + scope.duration < (step as f64 - 0.5) * STEP;
        *size <= 0.0 || (ends && is_past && self.debts[LIST_LIMIT + slot].waiting == 0)
    }

    fn allocated(&mut self) -> &mut [Emitter] {
        if self.pool.is_empty() {
            self.pool = vec![Emitter::default(); POOL_LIMIT];
        }
        &mut self.pool
    }
}

impl SnapshotSection for Births {
    #[cold]
    fn write(&self, body: &mut Writer) {
        let (table, pool) = self.debts().split_at(LIST_LIMIT);
        table.iter().for_each(|debt| body.number(debt.owed));
        table.iter().for_each(|debt| body.long(debt.waiting));
        for (emitter, debt) in self.pool.iter().zip(pool) {
            write_emitter(body, emitter, 0..FIRST_NUMBERS);
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
            let mut numbers = [0.0; FIRST_NUMBERS];
            read_numbers(reader, &mut numbers)?;
            // A free slot is out of the ranges of an emitter.
            let is_free = numbers == [0.0; FIRST_NUMBERS];
            births.put(index, if is_free { &[] } else { &numbers }, 0, None)?;
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
#[inline(never)]
fn write_emitter(body: &mut Writer, emitter: &Emitter, numbers: Range<usize>) {
    let mut emitter = *emitter;
    for number in numbers {
        let (.., place) = number_of(number);
        body.number(items::numbers(from_mut(&mut emitter))[place]);
    }
}

#[cold]
#[inline(never)]
fn read_numbers(reader: &mut Reader, numbers: &mut [f64]) -> Result<(), RestoreError> {
    for number in numbers {
        *number = reader.number()?;
    }
    Ok(())
}

/// Whether an emitter differs from those of older states.
#[inline(never)]
fn has_later(emitter: &Emitter) -> bool {
    emitter.per_metre > 0.0 || emitter.has_look()
}

/// The place of an emitter without one.
const NO_PLACE: f32 = f32::MAX;
/// An emitter that is not free, of which only some numbers matter.
const UNNAMED: Emitter = Emitter {
    size: 1.0,
    ..Emitter::FREE
};

/// Writes a look and the tint of its emitter.
#[cold]
pub(crate) fn write_look(body: &mut Writer, (look, tint): &PuffLook) {
    body.byte(*tint as u8);
    let emitter = Emitter { look: *look, ..UNNAMED };
    write_emitter(body, &emitter, FIRST_NUMBERS..EMITTER_NUMBERS);
}

/// Reads what [`write_look`] wrote.
#[cold]
pub(crate) fn read_look(reader: &mut Reader) -> Result<PuffLook, RestoreError> {
    let tint = reader.byte()? & 15;
    let mut emitter = UNNAMED;
    read_later_numbers(reader, &mut emitter)?;
    Ok((emitter.look, f64::from(tint)))
}

#[cold]
#[inline(never)]
fn read_later_numbers(reader: &mut Reader, emitter: &mut Emitter) -> Result<(), RestoreError> {
    let mut numbers = [f64::NAN; EMITTER_NUMBERS];
    read_numbers(reader, &mut numbers[FIRST_NUMBERS..])?;
    *emitter = emitter_from(&numbers, emitter)?;
    Ok(())
}

/// An emitter with these numbers, of which the later ones may be missing. NaN keeps that of `before`, unless that is a
/// free slot: then NaN is an error.
#[cold]
fn emitter_from(numbers: &[f64], before: &Emitter) -> Result<Emitter, ParameterError> {
    let mut emitter = *before;
    let is_changed = before.size > 0.0;
    for number in 0..EMITTER_NUMBERS {
        let (meta, part, place) = number_of(number);
        let given = match numbers.get(number) {
            Some(given) => *given,
            None if number < FIRST_NUMBERS || is_changed => f64::NAN,
            None => meta.default(part),
        };
        let max = match meta.key {
            "share" => MAX_RATE,
            "envelope.start" => LATEST,
            _ => meta.max,
        };
        let value = &mut items::numbers(from_mut(&mut emitter))[place];
        if !(is_changed && given.is_nan()) {
            *value = accept(meta.key, &Meta { max, ..*meta }, given)?;
        }
    }
    Ok(emitter)
}

/// The step in which an emission starts.
fn step_of(emitter: &Emitter) -> u64 {
    libm::round(emitter.scope.start / STEP) as u64
}

/// The parameter of number 0..[`EMITTER_NUMBERS`] of an emitter, the index of the number within it, and its place among
/// the numbers of an emitter in memory.
#[cold]
#[inline(never)]
fn number_of(number: usize) -> (&'static Meta, usize, usize) {
    let mut part = number;
    for (field, place) in items::fields(&Emitter::GROUPS) {
        if part < field.parts.len() {
            return (&field.meta, part, place + part);
        }
        part -= field.parts.len();
    }
    unreachable!("an emitter has this many numbers");
}

#[cold]
fn error_of(index: usize) -> ParameterError {
    ParameterError::out_of_range("emitter", index as f64, 0.0, (LIST_LIMIT + POOL_LIMIT - 1) as f64)
}
