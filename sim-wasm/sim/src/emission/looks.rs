//! The looks that emitters have, and their limit.

use arrayvec::ArrayVec;

use crate::emission::Births;
use crate::layout::error::ParameterError;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::table::Parameters;
use crate::particles::Particles;
use crate::particles::looks::{LOOK_LIMIT, PuffLook, present};

/// What emitters need for their looks.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Needs {
    /// Whether any emitter has a look.
    pub looks: bool,
    /// Whether puffs of any of them end as strands.
    pub strands: bool,
}

/// What the emitters need that may emit from step `step` on.
///
/// # Arguments
/// * `changed` - A slot of the pool, and its next emitter.
///
/// # Errors
/// These looks and those of living particles are more than [`LOOK_LIMIT`].
#[inline(never)]
pub(crate) fn needs(
    parameters: &Parameters,
    births: &Births,
    particles: &Particles,
    step: u64,
    changed: Option<(usize, &Emitter)>,
) -> Result<Needs, ParameterError> {
    let mut needs = Needs::default();
    let mut all = ArrayVec::new();
    let (table, pool) = (parameters.emitters.items(), births.pool());
    let is_kept = |slot: usize| births.is_active(slot, step) && changed.is_none_or(|(own, _)| own != slot);
    // One loop: code for each kind of emitter would take more space.
    for number in 0..=table.len() + pool.len() {
        let emitter = match number.checked_sub(table.len()) {
            None => &table[number],
            Some(slot) if slot < pool.len() => &pool[slot],
            Some(_) => match changed {
                None => break,
                Some((_, emitter)) => emitter,
            },
        };
        let slot = number.wrapping_sub(table.len());
        if emitter.has_look() && (slot >= pool.len() || is_kept(slot)) {
            needs.looks = true;
            needs.strands |= emitter.look.thins();
            add(&mut all, &(emitter.look, emitter.tint))?;
        }
    }
    if let Some(looks) = particles.looks.as_ref().filter(|_| needs.looks) {
        let present = present(&particles.attributes[..particles.alive()]);
        for (place, look) in looks.entries.iter().enumerate() {
            if present >> (place + 1) & 1 == 1 {
                add(&mut all, look)?;
            }
        }
    }
    Ok(needs)
}

#[inline(never)]
fn add(all: &mut ArrayVec<PuffLook, LOOK_LIMIT>, look: &PuffLook) -> Result<(), ParameterError> {
    if all.contains(look) || all.try_push(*look).is_ok() {
        return Ok(());
    }
    Err(ParameterError::too_many_looks())
}
