//! Looks: how puffs of some emitters differ from the rest of the smoke.
//!
//! A look is `emitters.#.look.*` and the tint of the emitter. Particles store its index, 1..=[`LOOK_LIMIT`], in the bits
//! of the tint (see [`Particles::attributes`]), and their tints in a column. An emitter gets an index with its first
//! birth: that of an equal look, else the first of which no particle lives. So the indices depend only on births, and
//! not on when parameters were set. Parameters that a look does not set are those of the smoke, also while its
//! particles live.

use arrayvec::ArrayVec;
use wide::f32x4;

use crate::emission::{Births, pool};
use crate::forces::drag;
use crate::layout::bytes::{Reader, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::limits::STEP;
use crate::layout::parameters::emitter::{Emitter, Look};
use crate::layout::parameters::table::Parameters;
use crate::layout::quantise::within;
use crate::math::hash::Hash;
use crate::math::simd::LANES;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;
use crate::particles::tile::Tile;

/// Maximum number of looks at a time.
pub const LOOK_LIMIT: usize = 15;
/// The indices: 0 for no look, then those of looks.
const INDICES: usize = LOOK_LIMIT + 1;
/// Position of the index in packed attributes, and their other bits.
const SHIFT: u32 = 28;
pub(crate) const OTHER_BITS: u32 = (1 << SHIFT) - 1;

const MAX_TINT: u8 = 15;

/// A look and the tint of its emitter.
pub type Entry = (Look, f64);

/// No look, in the table of looks.
pub const NO_ENTRY: Entry = (Look::NONE, 0.0);

/// What particles and kernels know of looks.
#[derive(Clone, Debug)]
pub struct Looks {
    /// Tint of each particle; 0 for those with a look, unless a collider has tinted them.
    pub tints: Vec<u8>,
    /// The looks of the indices from 1 on; [`NO_ENTRY`] for those that no particle has had.
    pub(crate) entries: [Entry; LOOK_LIMIT],
    laws: Laws,
}

/// The laws of motion and size by index.
#[derive(Clone, Debug)]
pub struct Laws {
    radii: [RadiusLaw; INDICES],
    /// The factors of the global drag in a step, then that on all drag.
    drag: [[f32; LANES]; INDICES],
    /// Factors on buoyancy and gravity.
    lift: [[f32; LANES]; INDICES],
    /// Whether any look moves otherwise than the smoke.
    are_different: bool,
}

/// Index of a look in packed attributes.
pub(crate) fn index(attributes: u32) -> usize {
    (attributes >> SHIFT) as usize
}

impl Looks {
    /// No particle of columns of length `padded` has a look or a tint.
    pub fn new(padded: usize) -> Self {
        let parameters = Parameters::default();
        let mut looks = Self {
            tints: vec![0; padded],
            entries: [NO_ENTRY; LOOK_LIMIT],
            laws: Laws {
                radii: [RadiusLaw::new(&parameters); INDICES],
                drag: [[0.0; LANES]; INDICES],
                lift: [[1.0; LANES]; INDICES],
                are_different: false,
            },
        };
        looks.prepare(&parameters);
        looks
    }

    /// Prepares the laws for changed parameters.
    pub fn prepare(&mut self, parameters: &Parameters) {
        (0..INDICES).for_each(|index| self.prepare_one(index, parameters));
        let moves = |(look, _): &Entry| [look.drag, look.buoyancy, look.gravity] != [1.0; 3];
        self.laws.are_different = self.entries.iter().any(moves);
    }

    fn prepare_one(&mut self, index: usize, parameters: &Parameters) {
        let look = match index {
            0 => Look::NONE,
            _ => self.entries[index - 1].0,
        };
        let Laws { radii, drag, lift, .. } = &mut self.laws;
        radii[index] = RadiusLaw::of_look(parameters, &look);
        let [kept, first, second] = drag::factors(drag::rate(parameters) * look.drag, STEP);
        drag[index] = [kept, first, second, look.drag].map(|number| number as f32);
        lift[index][..2].copy_from_slice(&[look.buoyancy as f32, look.gravity as f32]);
    }

    /// Style and tint of each look, two numbers each.
    pub fn styles(&self) -> Vec<f64> {
        self.entries
            .iter()
            .flat_map(|(look, tint)| [look.style, *tint])
            .collect()
    }

    /// Whether puffs of any look are eroded.
    pub fn erode(&self) -> bool {
        self.laws.radii.iter().any(RadiusLaw::erodes)
    }

    /// Whether puffs of any look end as strands.
    pub fn thin(&self) -> bool {
        self.laws.radii.iter().any(|law| law.strand > 1.0)
    }

    /// The law of a particle by its packed attributes.
    pub(crate) fn radius_law(&self, attributes: u32) -> &RadiusLaw {
        &self.laws.radii[index(attributes)]
    }

    /// [`RadiusLaw::radii`] for particles with these packed attributes.
    #[inline(never)]
    pub(crate) fn radii(&self, attributes: &[u32; LANES], size: f32x4, age: f32x4, lifetime: f32x4) -> f32x4 {
        let first = index(attributes[0]);
        if attributes.iter().all(|attributes| index(*attributes) == first) {
            return self.laws.radii[first].radii(size, age, lifetime);
        }
        let [size, age, lifetime] = [size, age, lifetime].map(|lanes| lanes.to_array());
        let radius = |lane: usize| {
            let law = self.radius_law(attributes[lane]);
            law.radius(size[lane], age[lane], lifetime[lane])
        };
        f32x4::new(std::array::from_fn(radius))
    }

    /// Prepares a loaded tile for the forces. Returns the laws if any of its particles moves by its own.
    #[inline]
    pub(crate) fn load(&self, tile: &mut Tile, attributes: &[u32], first: usize) -> Option<&Laws> {
        self.laws
            .are_different
            .then(|| self.load_into(tile, attributes, first))
            .flatten()
    }

    #[inline(never)]
    fn load_into(&self, tile: &mut Tile, attributes: &[u32], first: usize) -> Option<&Laws> {
        let own = &attributes.as_chunks::<LANES>().0[first..];
        tile.has_looks = own
            .iter()
            .take(tile.len())
            .flatten()
            .any(|attributes| index(*attributes) > 0);
        if !tile.has_looks {
            return None;
        }
        for (block, attributes) in own.iter().enumerate().take(tile.len()) {
            tile.looks[block] = attributes.map(|attributes| index(attributes) as u8);
            let [buoyancy, gravity, ..] = lanes(&self.laws.lift, &tile.looks[block]);
            tile.gravity[block] = gravity;
            tile.heat[block] *= buoyancy;
        }
        Some(&self.laws)
    }

    fn write_entries(&self, body: &mut Writer) {
        self.entries.iter().for_each(|entry| pool::write_look(body, entry));
    }

    /// Writes the looks and the tints of the first `alive` particles.
    #[cold]
    pub(crate) fn write(&self, body: &mut Writer, alive: usize) {
        self.write_entries(body);
        body.raw(&self.tints[..alive]);
    }

    /// Reads what [`Looks::write`] wrote.
    #[cold]
    pub(crate) fn read(&mut self, reader: &mut Reader, alive: usize) -> Result<(), RestoreError> {
        for entry in &mut self.entries {
            *entry = pool::read_look(reader)?;
        }
        for tint in &mut self.tints[..alive] {
            *tint = within(reader.byte()?, 0, MAX_TINT)?;
        }
        Ok(())
    }

    /// Adds what affects the future to `hash`; nothing before the first look. The attributes hold the index of each
    /// particle besides.
    pub(crate) fn hash_into(&self, attributes: &[u32], hash: &mut Hash) {
        if self.entries == [NO_ENTRY; LOOK_LIMIT] {
            return;
        }
        attributes.iter().for_each(|attributes| hash.word(attributes >> SHIFT));
        let mut body = Writer::default();
        self.write_entries(&mut body);
        hash.bytes(&body.finish());
    }
}

/// The looks that emitters have, with the tints of the emitters.
///
/// # Arguments
/// * `steps` - The number of steps made; emitters that are over by then have none.
/// * `changed` - A slot of the pool, and its next emitter.
pub(crate) fn of_emitters<'e>(
    parameters: &'e Parameters,
    births: &'e Births,
    steps: u64,
    changed: Option<(usize, &'e Emitter)>,
) -> impl Iterator<Item = (&'e Look, f64)> {
    let table = parameters.emitters.items().iter();
    let others = births
        .active(steps)
        .filter(move |(slot, _)| changed.is_none_or(|(own, _)| own != *slot));
    table
        .chain(others.chain(changed).map(|(_, emitter)| emitter))
        .map(|emitter| (&emitter.look, emitter.tint))
        .filter(|(look, _)| **look != Look::NONE)
}

/// Checks that these looks and those of living particles are at most [`LOOK_LIMIT`].
#[cold]
pub(crate) fn check<'e>(
    wanted: impl Iterator<Item = (&'e Look, f64)>,
    particles: &Particles,
) -> Result<(), ParameterError> {
    let mut all = ArrayVec::<Entry, INDICES>::new();
    let mut add = |entry: Entry| {
        if !all.contains(&entry) {
            // One more than the limit fits; beyond it the number does not matter.
            let _ = all.try_push(entry);
        }
        all.len() <= LOOK_LIMIT
    };
    let mut is_within = wanted
        .map(|(look, tint)| add((*look, tint)))
        .fold(true, |all, one| all && one);
    if let Some(looks) = particles.looks.as_ref().filter(|_| is_within) {
        let living = particles.living_looks();
        for (place, entry) in looks.entries.iter().enumerate() {
            if living >> (place + 1) & 1 == 1 {
                is_within &= add(*entry);
            }
        }
    }
    if is_within {
        Ok(())
    } else {
        Err(ParameterError::too_many_looks())
    }
}

impl Particles {
    /// The index of the look of the births of `emitter`; 0 without one, and if particles with 15 others live.
    pub(crate) fn look_of_births(&mut self, emitter: &Emitter, parameters: &Parameters) -> u32 {
        let entry = (emitter.look, emitter.tint);
        let Some(looks) = self.looks.as_mut().filter(|_| entry.0 != Look::NONE) else {
            return 0;
        };
        let known = looks.entries.iter().position(|known| *known == entry);
        known.map_or_else(|| self.add_look(entry, parameters), |place| place as u32 + 1)
    }

    #[cold]
    fn add_look(&mut self, entry: Entry, parameters: &Parameters) -> u32 {
        let living = self.living_looks();
        let free = (1..INDICES).find(|index| living >> index & 1 == 0);
        let (Some(index), Some(looks)) = (free, &mut self.looks) else {
            return 0;
        };
        looks.entries[index - 1] = entry;
        looks.prepare(parameters);
        index as u32
    }

    /// Bit i is set if a particle with look i lives.
    pub(crate) fn living_looks(&self) -> u32 {
        let living = self.attributes[..self.alive()].iter();
        living.fold(0, |looks, attributes| looks | 1 << index(*attributes))
    }

    /// Allocates the memory of looks and tells tints and looks apart, unless that is so already.
    pub(crate) fn allow_looks(&mut self, parameters: &Parameters) {
        if self.looks.is_none() {
            let mut looks = Box::new(Looks::new(self.x.len()));
            for (tint, attributes) in looks.tints.iter_mut().zip(&mut self.attributes) {
                *tint = index(*attributes) as u8;
                *attributes &= OTHER_BITS;
            }
            looks.prepare(parameters);
            self.looks = Some(looks);
        }
    }

    /// The look of particle `i`; 0 for none.
    pub fn look(&self, i: usize) -> u32 {
        self.looks.as_ref().map_or(0, |_| self.attributes[i] >> SHIFT)
    }

    /// The tint of particle `i`; 0 for none.
    pub fn tint(&self, i: usize) -> u32 {
        match &self.looks {
            None => self.attributes[i] >> SHIFT,
            Some(looks) => u32::from(looks.tints[i]),
        }
    }

    /// Sets the tint, 0..=15, of particle `i`.
    pub(crate) fn set_tint(&mut self, i: usize, tint: u8) {
        match &mut self.looks {
            None => self.attributes[i] = self.attributes[i] & OTHER_BITS | u32::from(tint & 15) << SHIFT,
            Some(looks) => looks.tints[i] = tint & 15,
        }
    }
}

impl Laws {
    /// Factors of drag of four particles: the three of the global drag alone in a step, then that on all drag.
    #[inline(always)]
    pub(crate) fn drag(&self, looks: &[u8; LANES]) -> [f32x4; LANES] {
        lanes(&self.drag, looks)
    }
}

/// The rows of four looks, transposed.
#[inline(always)]
fn lanes(rows: &[[f32; LANES]; INDICES], looks: &[u8; LANES]) -> [f32x4; LANES] {
    f32x4::transpose(looks.map(|look| f32x4::new(rows[usize::from(look) % INDICES])))
}
