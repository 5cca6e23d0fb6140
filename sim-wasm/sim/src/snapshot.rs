//! A simulation as bytes.
//!
//! Little-endian: the magic number, the version, a checksum of all that follows; then steps, seed, random numbers, what
//! emitters and turbulence remember, the parameters by key, the rigids as their own bytes, and the living particles
//! column by column. Another version is refused rather than guessed at.

use crate::emitter::Births;
use crate::error::RestoreError;
use crate::forces::turbulence::TurbulenceState;
use crate::hash::Hash;
use crate::parameters::{LIST_LIMIT, Parameters};
use crate::particles::Particles;
use crate::random::Random;
use crate::simulator::Simulator;

mod bytes;
use bytes::{Reader, Writer};

const MAGIC: u32 = u32::from_le_bytes(*b"smok");
const VERSION: u32 = 1;

/// All of `simulator` as bytes.
pub fn save(simulator: &Simulator) -> Vec<u8> {
    let mut body = Writer::default();
    body.long(simulator.steps);
    body.word(simulator.seed);
    body.long(simulator.random.state());
    write_memory(&mut body, &simulator.births, &simulator.turbulence);
    write_parameters(&mut body, &simulator.parameters);
    body.block(&rigids_bytes(simulator));
    write_particles(&mut body, &simulator.particles);
    let body = body.finish();
    let mut whole = Writer::default();
    whole.word(MAGIC);
    whole.word(VERSION);
    whole.long(checksum(&body));
    whole.raw(&body);
    whole.finish()
}

/// Puts what `bytes` hold into `simulator`, or refuses them and changes nothing.
pub fn restore(simulator: &mut Simulator, bytes: &[u8]) -> Result<(), RestoreError> {
    let mut reader = Reader::new(check(bytes)?);
    let (steps, seed) = (reader.long()?, reader.word()?);
    let random = Random::from_state(reader.long()?);
    let (births, turbulence) = read_memory(&mut reader)?;
    let parameters = read_parameters(&mut reader)?;
    let rigids = reader.block()?;
    let particles = read_particles(&mut reader, simulator.capacity())?;
    reader.end()?;
    // Everything has been checked but the rigids; they come first, since nothing may fail after the first change.
    restore_rigids(simulator, rigids)?;
    simulator.parameters = parameters;
    (simulator.seed, simulator.steps, simulator.random) = (seed, steps, random);
    (simulator.births, simulator.turbulence) = (births, turbulence);
    simulator.particles = particles;
    Ok(())
}

fn check(bytes: &[u8]) -> Result<&[u8], RestoreError> {
    let mut reader = Reader::new(bytes);
    if reader.word()? != MAGIC {
        return Err(RestoreError::new(
            "these bytes are not a saved simulation; give what save() returned",
        ));
    }
    let version = reader.word()?;
    if version != VERSION {
        let message = format!("the simulation was saved in format {version}, this version reads {VERSION} only");
        return Err(RestoreError::new(message));
    }
    let sum = reader.long()?;
    if checksum(reader.rest()) != sum {
        return Err(RestoreError::new(
            "the saved simulation is damaged; give all the bytes that save() returned",
        ));
    }
    Ok(reader.rest())
}

fn checksum(bytes: &[u8]) -> u64 {
    let mut hash = Hash::new();
    let (words, rest) = bytes.as_chunks::<4>();
    words.iter().for_each(|word| hash.word(u32::from_le_bytes(*word)));
    hash.bytes(rest);
    hash.finish()
}

fn write_memory(body: &mut Writer, births: &Births, turbulence: &[TurbulenceState]) {
    births.owed.iter().for_each(|owed| body.number(*owed));
    births.waiting.iter().for_each(|count| body.long(*count));
    for state in turbulence {
        state.drift.iter().for_each(|metres| body.number(*metres));
        body.number(state.phase);
    }
}

fn read_memory(reader: &mut Reader) -> Result<(Births, [TurbulenceState; LIST_LIMIT + 1]), RestoreError> {
    let mut births = Births::default();
    let mut turbulence = [TurbulenceState::default(); LIST_LIMIT + 1];
    for index in 0..LIST_LIMIT {
        births.owed[index] = reader.number()?.clamp(-1.0, 1.0);
    }
    for index in 0..LIST_LIMIT {
        births.waiting[index] = reader.long()?;
    }
    for state in &mut turbulence {
        for metres in &mut state.drift {
            *metres = reader.number()?;
        }
        state.phase = reader.number()?;
    }
    Ok((births, turbulence))
}

fn write_parameters(body: &mut Writer, parameters: &Parameters) {
    let entries = parameters.entries();
    body.word(entries.len() as u32);
    for (key, value) in entries {
        body.block(key.as_bytes());
        body.number(value);
    }
}

fn read_parameters(reader: &mut Reader) -> Result<Parameters, RestoreError> {
    let mut parameters = Parameters::default();
    for _ in 0..reader.word()? {
        let key = std::str::from_utf8(reader.block()?);
        let key = key.map_err(|_| RestoreError::new("the saved simulation names a parameter that is no text"))?;
        let value = reader.number()?;
        parameters
            .set(key, value)
            .map_err(|error| RestoreError::new(error.message))?;
    }
    Ok(parameters)
}

fn write_particles(body: &mut Writer, particles: &Particles) {
    let alive = particles.alive();
    body.word(alive as u32);
    for column in particles.float_columns() {
        column[..alive].iter().for_each(|value| body.word(value.to_bits()));
    }
    particles.look[..alive].iter().for_each(|look| body.word(*look));
}

fn read_particles(reader: &mut Reader, capacity: usize) -> Result<Particles, RestoreError> {
    let alive = reader.word()? as usize;
    if alive > capacity {
        let message = format!("{alive} particles were saved, there is room for {capacity}; make a larger simulator");
        return Err(RestoreError::new(message));
    }
    let mut particles = Particles::new(capacity);
    for column in particles.float_columns_mut() {
        column[..alive]
            .iter_mut()
            .try_for_each(|value| reader.float().map(|saved| *value = saved))?;
    }
    particles.look[..alive]
        .iter_mut()
        .try_for_each(|look| reader.word().map(|saved| *look = saved))?;
    if particles.lifetime[..alive].iter().any(|lifetime| *lifetime <= 0.0) {
        return Err(RestoreError::new(
            "the saved simulation holds a particle without a lifetime",
        ));
    }
    particles.set_alive(alive);
    Ok(particles)
}

#[cfg(feature = "rigids")]
fn rigids_bytes(simulator: &Simulator) -> Vec<u8> {
    simulator.rigids.save()
}

#[cfg(not(feature = "rigids"))]
fn rigids_bytes(_simulator: &Simulator) -> Vec<u8> {
    Vec::new()
}

#[cfg(feature = "rigids")]
fn restore_rigids(simulator: &mut Simulator, bytes: &[u8]) -> Result<(), RestoreError> {
    simulator.rigids = if bytes.is_empty() {
        crate::rigids::Rigids::new()
    } else {
        crate::rigids::Rigids::restore(bytes)?
    };
    Ok(())
}

#[cfg(not(feature = "rigids"))]
fn restore_rigids(_simulator: &mut Simulator, bytes: &[u8]) -> Result<(), RestoreError> {
    if bytes.is_empty() {
        return Ok(());
    }
    Err(RestoreError::new(
        "the saved simulation has rigids; load the simulator with physics to restore it",
    ))
}
