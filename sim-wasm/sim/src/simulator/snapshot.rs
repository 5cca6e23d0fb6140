//! Saving and restoring a simulation.
//!
//! The format is an envelope (kind, version, checksum) around named sections with their lengths. Each part of the state
//! implements [`SnapshotSection`] and has a row in `sections!`. Only the current version can be read.

use crate::collide::pool::ColliderPool;
use crate::emission::Births;
use crate::emission::pool::{read_look, write_look};
use crate::emission::surface::Surfaces;
use crate::forces::force::TurbulenceState;
use crate::forces::vortex_particles::VortexParticles;
use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::RestoreError;
use crate::layout::limits::CAPACITY_LIMIT;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::parameters::table::Parameters;
use crate::math::random::Random;
use crate::particles::Particles;
use crate::particles::looks::Looks;
use crate::simulator::Simulator;
use crate::simulator::take::active_inputs::ActiveInputs;

const KIND: &[u8; 4] = b"smok";
const VERSION: u32 = 1;
const NAME: &str = "saved simulation";

/// Bits of the word that says which columns follow the others.
const HOLDS: u32 = 1;
const FOLLOWS: u32 = 2;
const AGES_BY_COMPANY: u32 = 4;
const HAS_LOOKS: u32 = 8;

/// Declares the saved sections besides particles and rigids: section name, field of the simulator, type.
macro_rules! sections {
    ($($name:literal => $field:ident: $type:ty,)*) => {
        struct SavedState {
            $($field: $type,)*
        }

        impl SavedState {
            fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
                Ok(Self { $($field: reader.section($name, <$type as SnapshotSection>::read)?,)* })
            }

            fn put_into(self, simulator: &mut Simulator) {
                $(simulator.$field = self.$field;)*
            }
        }

        fn write_sections(simulator: &Simulator, body: &mut Writer) {
            $(body.section($name, |body| simulator.$field.write(body));)*
        }
    };
}

sections! {
    b"time" => steps: u64,
    b"seed" => seed: u32,
    b"rand" => random: Random,
    b"born" => births: Births,
    b"turb" => turbulence: [TurbulenceState; LIST_LIMIT + 1],
    b"hand" => active_inputs: ActiveInputs,
    b"vort" => vortex_particles: Option<Box<VortexParticles>>,
    b"para" => parameters: Parameters,
    b"surf" => surfaces: Surfaces,
}

/// Selects the capacity of a restored simulator.
#[derive(Clone, Copy, PartialEq)]
pub enum RestoredCapacity {
    /// The simulator keeps its capacity; the saved particles must fit.
    Own,
    /// The simulator takes over the saved capacity.
    Saved,
}

impl Simulator {
    /// Serialises the state and the parameters. See `snapshot`.
    pub fn save(&self) -> Vec<u8> {
        save(self)
    }

    /// Restores bytes from `save`, independent of the current seed. The living particles must fit the current capacity.
    /// Damaged bytes are an error and change nothing. The recording of a take restarts.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), RestoreError> {
        self.restore_with(bytes, true)
    }

    /// Same as `restore`. Without `obstacles` the simulator has no rigids and no colliders of the pool afterwards, so that a
    /// simulator without Rapier restores every state.
    pub fn restore_with(&mut self, bytes: &[u8], obstacles: bool) -> Result<(), RestoreError> {
        restore(self, bytes, RestoredCapacity::Own, obstacles)?;
        self.begin_take_anew();
        Ok(())
    }
}

/// Serialises `simulator`.
pub fn save(simulator: &Simulator) -> Vec<u8> {
    let mut body = Writer::default();
    write_sections(simulator, &mut body);
    body.section(b"rigi", |body| body.raw(&rigids_bytes(simulator)));
    body.section(b"room", |body| body.word(simulator.capacity() as u32));
    body.section(b"part", |body| write_particles(body, &simulator.particles));
    let mut later = Writer::default();
    simulator.births.write_later(&mut later);
    let later = later.finish();
    if !later.is_empty() {
        body.section(b"more", |body| body.raw(&later));
    }
    simulator.colliders.write(&mut body);
    body.seal(KIND, VERSION)
}

/// Restores `bytes` into `simulator`. On error nothing changes.
pub fn restore(
    simulator: &mut Simulator,
    bytes: &[u8],
    room: RestoredCapacity,
    obstacles: bool,
) -> Result<(), RestoreError> {
    let mut reader = Reader::open(bytes, KIND, VERSION, NAME)?;
    let mut saved_state = SavedState::read(&mut reader)?;
    let rigids = reader.section(b"rigi", |reader| Ok(reader.rest()))?;
    let saved = reader.section(b"room", read_capacity)?;
    let capacity = if room == RestoredCapacity::Saved {
        saved
    } else {
        simulator.capacity()
    };
    let particles = reader.section(b"part", |reader| read_particles(reader, capacity))?;
    if reader.is_at(b"more") {
        reader.section(b"more", |reader| saved_state.births.read_later(reader))?;
    }
    // States without colliders of the pool end here.
    let colliders = ColliderPool::read(&mut reader)?;
    // Rigids are restored first: they are the last step that can fail.
    restore_rigids(simulator, rigids, obstacles)?;
    saved_state.put_into(simulator);
    simulator.colliders = if obstacles { colliders } else { ColliderPool::default() };
    simulator.put_particles(particles);
    simulator.take_over_parameters();
    Ok(())
}

impl SnapshotSection for Random {
    fn write(&self, body: &mut Writer) {
        body.long(self.state());
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        reader.long().map(Random::from_state)
    }
}

impl<const N: usize> SnapshotSection for [TurbulenceState; N] {
    fn write(&self, body: &mut Writer) {
        for TurbulenceState { drift, phase } in self {
            drift.iter().chain([phase]).for_each(|number| body.number(*number));
        }
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let mut states = [TurbulenceState::default(); N];
        for TurbulenceState { drift, phase } in &mut states {
            for number in drift.iter_mut().chain([phase]) {
                *number = reader.number()?;
            }
        }
        Ok(states)
    }
}

impl SnapshotSection for Parameters {
    fn write(&self, body: &mut Writer) {
        let entries = self.entries();
        body.word(entries.len() as u32);
        for (key, value) in entries {
            body.text(&key);
            body.number(value);
        }
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let mut parameters = Self::default();
        for _ in 0..reader.word()? {
            let (key, value) = (reader.text()?, reader.number()?);
            parameters.set(key, value).map_err(RestoreError::from)?;
        }
        Ok(parameters)
    }
}

fn read_capacity(reader: &mut Reader) -> Result<usize, RestoreError> {
    let capacity = reader.word()?;
    if (1..=CAPACITY_LIMIT).contains(&capacity) {
        return Ok(capacity as usize);
    }
    Err(RestoreError::new(
        "the saved simulation has no capacity that a simulator can have",
    ))
}

fn write_column(body: &mut Writer, column: &[f32]) {
    column.iter().for_each(|value| body.word(value.to_bits()));
}

fn read_column(reader: &mut Reader, column: &mut [f32]) -> Result<(), RestoreError> {
    let mut values = column.iter_mut();
    values.try_for_each(|value| reader.float().map(|saved| *value = saved))
}

fn read_words(reader: &mut Reader, words: &mut [u32]) -> Result<(), RestoreError> {
    let mut words = words.iter_mut();
    words.try_for_each(|word| reader.word().map(|saved| *word = saved))
}

fn write_particles(body: &mut Writer, particles: &Particles) {
    let alive = particles.alive();
    body.word(alive as u32);
    for column in particles.float_columns() {
        write_column(body, &column[..alive]);
    }
    particles.attributes[..alive]
        .iter()
        .for_each(|attributes| body.word(*attributes));
    let optional = [
        (particles.held.is_some(), HOLDS),
        (particles.flow.is_some(), FOLLOWS),
        (particles.company.is_some(), AGES_BY_COMPANY),
        (particles.looks.is_some(), HAS_LOOKS),
    ];
    body.word(optional.iter().map(|(is_there, bit)| u32::from(*is_there) * bit).sum());
    for column in particles.held.iter().flat_map(|held| held.columns()) {
        write_column(body, &column[..alive]);
    }
    for column in particles.flow.iter().flat_map(|flow| &flow.columns) {
        column[..alive].iter().for_each(|word| body.word(*word));
    }
    if let Some(company) = &particles.company {
        write_column(body, &company.extra_ageing[..alive]);
    }
    if let Some(looks) = &particles.looks {
        looks.entries.iter().for_each(|entry| write_look(body, entry));
        body.raw(&looks.tints[..alive]);
    }
}

fn read_particles(reader: &mut Reader, capacity: usize) -> Result<Particles, RestoreError> {
    let alive = reader.word()? as usize;
    if alive > capacity {
        let message = format!("{alive} particles were saved, there is room for {capacity}; make a larger simulator");
        return Err(RestoreError::new(message));
    }
    let mut particles = Particles::new(capacity);
    for column in particles.float_columns_mut() {
        read_column(reader, &mut column[..alive])?;
    }
    read_words(reader, &mut particles.attributes[..alive])?;
    if particles.lifetime[..alive].iter().any(|lifetime| *lifetime <= 0.0) {
        return Err(RestoreError::new(
            "the saved simulation holds a particle without a lifetime",
        ));
    }
    let columns = reader.word()?;
    particles.hold(columns & HOLDS != 0);
    particles.follow(columns & FOLLOWS != 0);
    particles.keep_company(columns & AGES_BY_COMPANY != 0);
    for column in particles.held_columns_mut() {
        read_column(reader, &mut column[..alive])?;
    }
    for column in particles.flow.iter_mut().flat_map(|flow| &mut flow.columns) {
        read_words(reader, &mut column[..alive])?;
    }
    if let Some(company) = &mut particles.company {
        read_column(reader, &mut company.extra_ageing[..alive])?;
    }
    if columns & HAS_LOOKS != 0 {
        let mut looks = Box::new(Looks::new(particles.x.len()));
        for entry in &mut looks.entries {
            *entry = read_look(reader)?;
        }
        for tint in &mut looks.tints[..alive] {
            *tint = reader.byte()? & 15;
        }
        particles.looks = Some(looks);
    }
    particles.set_alive(alive);
    Ok(particles)
}

#[cfg(feature = "meshes")]
fn rigids_bytes(simulator: &Simulator) -> Vec<u8> {
    simulator.rigids.save()
}

#[cfg(not(feature = "meshes"))]
fn rigids_bytes(_simulator: &Simulator) -> Vec<u8> {
    Vec::new()
}

#[cfg(feature = "meshes")]
fn restore_rigids(simulator: &mut Simulator, bytes: &[u8], are_kept: bool) -> Result<(), RestoreError> {
    let restored = crate::rigids::Rigids::restore(bytes);
    // Without Rapier there may be rigids in the state that only Rapier can move.
    let is_needed = are_kept || cfg!(feature = "rigids");
    let mut rigids = if is_needed {
        restored?
    } else {
        restored.unwrap_or_default()
    };
    if !are_kept {
        // Those that the next ones replace: a new body in Rapier has another hash than one that has moved.
        for index in 0..rigids.count() as u32 {
            let _ = rigids.remove(index);
        }
    }
    simulator.rigids = rigids;
    Ok(())
}

#[cfg(not(feature = "meshes"))]
fn restore_rigids(_simulator: &mut Simulator, bytes: &[u8], are_kept: bool) -> Result<(), RestoreError> {
    if bytes.is_empty() || !are_kept {
        return Ok(());
    }
    Err(RestoreError::new(
        "the saved simulation has rigids; load the simulator with physics to restore it",
    ))
}
