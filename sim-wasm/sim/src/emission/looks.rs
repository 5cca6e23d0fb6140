//! The looks that emitters have, and their limit.

use arrayvec::ArrayVec;

use crate::emission::Births;
use crate::layout::error::ParameterError;
use crate::layout::parameters::emitter::{Emitter, Look};
use crate::layout::parameters::table::Parameters;
use crate::particles::Particles;
use crate::particles::looks::{INDICES, LOOK_LIMIT, PuffLook, present};

/// The looks of the emitters that may emit from step `step` on, with their tints.
///
/// # Arguments
/// * `changed` - A slot of the pool, and its next emitter.
pub(crate) fn of_emitters<'e>(
    parameters: &'e Parameters,
    births: &'e Births,
    step: u64,
    changed: Option<(usize, &'e Emitter)>,
) -> impl Iterator<Item = PuffLook> {
    let table = parameters.emitters.items().iter();
    let slot = changed.map(|(slot, _)| slot);
    let others = births.active(step).filter(move |(own, _)| Some(*own) != slot);
    table
        .chain(others.chain(changed).map(|(_, emitter)| emitter))
        .filter(|emitter| emitter.look != Look::NONE)
        .map(|emitter| (emitter.look, emitter.tint))
}

/// Checks that looks and those of living particles are at most [`LOOK_LIMIT`].
#[inline(never)]
pub(crate) fn check(wanted: impl Iterator<Item = PuffLook>, particles: &Particles) -> Result<(), ParameterError> {
    let mut all = ArrayVec::<PuffLook, INDICES>::new();
    for entry in wanted {
        add(&mut all, &entry)?;
    }
    let Some(looks) = particles.looks.as_ref().filter(|_| !all.is_empty()) else {
        return Ok(());
    };
    let present = present(&particles.attributes[..particles.alive()]);
    let living = |place: &usize| present >> (place + 1) & 1 == 1;
    (0..LOOK_LIMIT)
        .filter(living)
        .try_for_each(|place| add(&mut all, &looks.entries[place]))
}

fn add(all: &mut ArrayVec<PuffLook, INDICES>, entry: &PuffLook) -> Result<(), ParameterError> {
    if !all.contains(entry) {
        all.push(*entry);
    }
    if all.len() > LOOK_LIMIT {
        return Err(ParameterError::too_many_looks());
    }
    Ok(())
}
