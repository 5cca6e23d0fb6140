//! Looks: how puffs of some emitters differ from the rest of the smoke.
//!
//! A look is `emitters.#.look.*` and the tint of the emitter. Particles store its index, 1..=[`LOOK_LIMIT`], in the bits
//! of the tint, and their tints in a column. An emitter gets an index with its first birth: that of an equal look, else
//! the first of which no particle lives. So the indices depend only on births, and not on when parameters were set.
//! Parameters that a look does not set are those of the smoke, also while its particles live.

use wide::f32x4;

use crate::layout::parameters::emitter::Look;
use crate::layout::parameters::table::Parameters;
use crate::math::simd::LANES;
use crate::particles::radius::RadiusLaw;

/// Maximum number of looks at a time.
pub const LOOK_LIMIT: usize = 15;
/// The indices: 0 for no look, then those of looks.
pub const INDICES: usize = LOOK_LIMIT + 1;
/// Position of the index in packed attributes, and their other bits.
const SHIFT: u32 = 28;
pub(crate) const OTHER_BITS: u32 = (1 << SHIFT) - 1;

/// A look and the tint of its emitter.
pub type PuffLook = (Look, f64);

/// No look.
pub const NO_LOOK: PuffLook = (Look::NONE, 0.0);

/// What particles know of looks.
#[derive(Clone, Debug)]
pub struct Looks {
    /// Tint of each particle; 0 for those with a look, unless a collider has tinted them.
    pub tints: Vec<u8>,
    /// The looks of the indices from 1 on; [`NO_LOOK`] for those that no particle has had.
    pub entries: [PuffLook; LOOK_LIMIT],
    /// The laws by index.
    radii: [RadiusLaw; INDICES],
}

/// Index of a look, or a tint without looks, in packed attributes.
pub(crate) fn index(attributes: u32) -> usize {
    (attributes >> SHIFT) as usize
}

/// Bit i is set if one of these particles has look i.
pub(crate) fn present(attributes: &[u32]) -> u32 {
    attributes
        .iter()
        .fold(0, |looks, attributes| looks | 1 << index(*attributes))
}

impl Looks {
    /// No particle of columns of length `padded` has a look or a tint.
    pub fn new(padded: usize) -> Self {
        Self {
            tints: vec![0; padded],
            entries: [NO_LOOK; LOOK_LIMIT],
            radii: [RadiusLaw::linear(1.0, 0.0); INDICES],
        }
    }

    /// Prepares the laws for changed parameters.
    pub fn prepare(&mut self, parameters: &Parameters) {
        let looks = [NO_LOOK].into_iter().chain(self.entries);
        for (law, (look, _)) in self.radii.iter_mut().zip(looks) {
            *law = RadiusLaw::of_look(parameters, &look);
        }
    }

    /// The index of a look for births; that of no look if particles with 15 others live.
    ///
    /// # Arguments
    /// * `living` - The packed attributes of the living particles.
    pub fn index_for(&mut self, entry: &PuffLook, living: &[u32], parameters: &Parameters) -> u32 {
        if entry.0 == Look::NONE {
            return 0;
        }
        let known = self.entries.iter().position(|known| known == entry);
        let place = known.or_else(|| {
            let present = present(living);
            let free = (0..LOOK_LIMIT).find(|place| present >> (place + 1) & 1 == 0)?;
            self.entries[free] = *entry;
            self.prepare(parameters);
            Some(free)
        });
        place.map_or(0, |place| place as u32 + 1)
    }

    /// Style, tint and dissolution of each look, three numbers each as in the table.
    pub fn styles(&self) -> Vec<f64> {
        let mut styles = vec![0.0; 3 * LOOK_LIMIT];
        for (three, (look, tint)) in styles.as_chunks_mut().0.iter_mut().zip(&self.entries) {
            *three = [look.style, *tint, look.dissolve];
        }
        styles
    }

    /// Whether puffs of any look are eroded.
    pub fn erode(&self) -> bool {
        self.radii.iter().any(RadiusLaw::erodes)
    }

    /// Whether puffs of any look end as strands.
    pub fn thin(&self) -> bool {
        self.radii.iter().any(|law| law.strand > 1.0)
    }

    /// The law of a particle by its packed attributes.
    pub(super) fn radius_law(&self, attributes: u32) -> &RadiusLaw {
        &self.radii[index(attributes)]
    }

    /// [`RadiusLaw::radii`] for particles with these packed attributes.
    #[inline(never)]
    pub(super) fn radii(&self, attributes: &[u32; LANES], size: f32x4, age: f32x4, lifetime: f32x4) -> f32x4 {
        let first = index(attributes[0]);
        if attributes.iter().all(|attributes| index(*attributes) == first) {
            return self.radii[first].radii(size, age, lifetime);
        }
        let [size, age, lifetime] = [size, age, lifetime].map(|lanes| lanes.to_array());
        let radius = |lane: usize| {
            let law = self.radius_law(attributes[lane]);
            law.radius(size[lane], age[lane], lifetime[lane])
        };
        f32x4::new(std::array::from_fn(radius))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::parameters::field::STOP_STEPS;

    #[test]
    fn lanes_of_any_looks_have_the_radii_of_single_particles() {
        let parameters = Parameters::default();
        let mut looks = Looks::new(4);
        let large = 1.0 + STOP_STEPS * 131_072.0;
        looks.entries[0].0.size_curve = [large / 2.0, 3e9 + 40_000.0, 0.0, 2e9 + 50_000.0, 0.0, 0.0, 0.0, 0.0];
        looks.entries[1].0.density_curve[0] = large;
        looks.entries[14].0.growth_time = 3.0;
        looks.prepare(&parameters);
        for own in [[1, 1, 1, 1], [2, 2, 2, 2], [0, 1, 2, 15], [15, 15, 0, 0]] {
            let attributes = own.map(|look: u32| look << SHIFT | 0x0123_4567);
            for step in -5..300 {
                let ages = [0.0, 0.2, 0.4, 0.6].map(|more| step as f32 / 60.0 + more);
                let [size, lifetime] = [0.4, 3.1].map(f32x4::splat);
                let radii = looks.radii(&attributes, size, f32x4::new(ages), lifetime).to_array();
                for (lane, radius) in radii.into_iter().enumerate() {
                    let single = looks.radius_law(attributes[lane]).radius(0.4, ages[lane], 3.1);
                    assert_eq!(
                        radius.to_bits(),
                        single.to_bits(),
                        "look {} at {}",
                        own[lane],
                        ages[lane]
                    );
                }
            }
        }
    }
}
