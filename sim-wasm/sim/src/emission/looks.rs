//! The looks that emitters have, and their limit.

use arrayvec::ArrayVec;

use crate::emission::Births;
use crate::layout::error::ParameterError;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::table::Parameters;
use crate::particles::Particles;
use crate::particles::looks::{INDICES, LOOK_LIMIT, PuffLook, present};

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
    let mut all = ArrayVec::<PuffLook, INDICES>::new();
    let slot = changed.map(|(slot, _)| slot);
    let mut add = |emitter: &Emitter| {
        needs.looks = true;
        needs.strands |= emitter.look.thins();
        add(&mut all, &(emitter.look, emitter.tint))
    };
    for emitter in parameters.emitters.items() {
        if emitter.has_look() {
            add(emitter)?;
        }
    }
    for (own, emitter) in births.pool().iter().enumerate() {
        if emitter.has_look() && births.is_active(own, step) && Some(own) != slot {
            add(emitter)?;
        }
    }
    if let Some((_, emitter)) = changed {
        add(emitter)?;
    }
    if let Some(looks) = particles.looks.as_ref().filter(|_| needs.looks) {
        let present = present(&particles.attributes[..particles.alive()]);
        for (place, look) in looks.entries.iter().enumerate() {
            if present >> (place + 1) & 1 == 1 {
                self::add(&mut all, look)?;
            }
        }
    }
    Ok(needs)
}

#[inline(never)]
fn add(all: &mut ArrayVec<PuffLook, INDICES>, look: &PuffLook) -> Result<(), ParameterError> {
    if !all.contains(look) {
        all.push(*look);
    }
    if all.len() > LOOK_LIMIT {
        return Err(ParameterError::too_many_looks());
    }
    Ok(())
}
