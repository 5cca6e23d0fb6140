//! Growth by entrainment.
//!
//! Rising smoke mixes with air. The speed of the inflow is a share e of the speed of the smoke relative to the air
//! (Morton, Taylor and Turner, "Turbulent Gravitational Convection from Maintained and Instantaneous Sources", Proc. R.
//! Soc. A 234, 1956). A puff of volume 4/3 pi r^3 that takes in e |slip| through its surface 4 pi r^2 has dr/dt = e
//! |slip|: its size grows by e times its path through the air. That path is known in closed form for each step, so the
//! size is exact for straight paths at any drag.

use wide::f32x4;

use crate::layout::parameters::table::Parameters;
use crate::math::simd::{Vector4, blocks, blocks_mut, positive_part, smaller};
use crate::particles::Particles;

/// Maximum size (m) that entrainment produces. Particles born larger keep their size.
pub const MAX_SIZE: f32 = 20.0;

/// Growth by entrainment in a step.
#[derive(Clone, Copy, Debug)]
pub struct Entrainment {
    share: f32x4,
    per_step: f32x4,
}

impl Entrainment {
    /// The growth that `parameters` set for steps of `dt` seconds; none without entrainment.
    pub fn new(parameters: &Parameters, dt: f64) -> Option<Self> {
        let share = parameters.emission.entrainment;
        (share > 0.0).then(|| Self {
            share: f32x4::splat(share as f32),
            per_step: f32x4::splat((1.0 / dt) as f32),
        })
    }

    /// Grows the particles of the blocks from `first` on. `ways`: their paths through the air (m) over the step.
    pub fn act(&self, ways: &[Vector4], particles: &mut Particles, first: usize) {
        let count = first + ways.len();
        let ages = &blocks(&particles.age, count)[first..];
        let sizes = &mut blocks_mut(&mut particles.size, count)[first..];
        let most = f32x4::splat(MAX_SIZE);
        for ((way, age), size) in ways.iter().zip(ages).zip(sizes) {
            // A particle born within the step moves only for the rest of it.
            let part = smaller(f32x4::ONE + f32x4::new(*age) * self.per_step, f32x4::ONE);
            let before = f32x4::new(*size);
            let grown = before + way.dot(*way).sqrt() * positive_part(part) * self.share;
            let limit = before.simd_gt(most).select(before, most);
            *size = smaller(grown, limit).to_array();
        }
    }
}
