//! Motion of particles with looks: factors on drag, buoyancy and gravity by the index of the look.

use wide::f32x4;

use crate::forces::drag;
use crate::math::simd::LANES;
use crate::particles::looks::{INDICES, Looks, NO_LOOK, index};
use crate::particles::tile::Tile;

/// What tiles read by the index of a look; without a look the factors are 1.
#[derive(Clone, Debug)]
pub struct MotionLaws {
    /// The factors of the global drag in a step, then that on the rate of all drag.
    drag: [[f32; LANES]; INDICES],
    /// The factors on buoyancy and gravity.
    lift: [[f32; LANES]; INDICES],
}

impl MotionLaws {
    /// The laws in steps of `dt` seconds at a global rate of drag (1/s); none if no look moves otherwise than the smoke.
    #[inline(never)]
    pub fn new(looks: &Looks, rate: f64, dt: f64) -> Option<Self> {
        if looks.entries.iter().all(|(look, _)| look.moves_as_smoke()) {
            return None;
        }
        let mut laws = Self {
            drag: [[0.0; LANES]; INDICES],
            lift: [[1.0; LANES]; INDICES],
        };
        let entries = [NO_LOOK].into_iter().chain(looks.entries);
        for ((look, _), (drag, lift)) in entries.zip(laws.drag.iter_mut().zip(&mut laws.lift)) {
            let [kept, first, second] = drag::factors(rate * look.drag, dt);
            *drag = [kept, first, second, look.drag].map(|number| number as f32);
            [lift[0], lift[1], ..] = [look.buoyancy as f32, look.gravity as f32];
        }
        Some(laws)
    }

    /// Prepares a tile that was loaded with the particles of the blocks from `first` on. Returns false if none of them has
    /// a look.
    ///
    /// # Arguments
    /// * `attributes` - The packed attributes of all particles.
    #[inline(never)]
    pub fn load(&self, tile: &mut Tile, attributes: &[u32], first: usize) -> bool {
        let own = &attributes.as_chunks::<LANES>().0[first..];
        tile.has_looks = own
            .iter()
            .take(tile.len())
            .flatten()
            .any(|attributes| index(*attributes) > 0);
        if tile.has_looks {
            for (block, attributes) in own.iter().enumerate().take(tile.len()) {
                tile.looks[block] = attributes.map(|attributes| index(attributes) as u8);
                let [buoyancy, gravity, ..] = lanes(&self.lift, &tile.looks[block]);
                tile.gravity[block] = gravity;
                tile.heat[block] *= buoyancy;
            }
        }
        tile.has_looks
    }

    /// Factors of drag of four particles: the three of the global drag alone in a step, then that on the rate.
    #[inline(always)]
    pub fn drag(&self, looks: &[u8; LANES]) -> [f32x4; LANES] {
        lanes(&self.drag, looks)
    }
}

/// The rows of four looks, transposed.
#[inline(always)]
fn lanes(rows: &[[f32; LANES]; INDICES], looks: &[u8; LANES]) -> [f32x4; LANES] {
    f32x4::transpose(looks.map(|look| f32x4::new(rows[usize::from(look) % INDICES])))
}
