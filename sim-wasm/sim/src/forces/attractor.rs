//! Attractors: a point attracts or repels smoke.
//!
//! a = -A (1 - r^2 / R^2)^2 (p - c) / max(r, s) for the distance r of the position p from the centre c, and 0 where
//! r >= R. The strength is constant except for the fade, and linear within the core, so that smoke swings through the
//! centre as on a spring. Parameters: `attractors.#.acceleration` A (m/s2, negative to repel), `.coreRadius` s (m),
//! `.reach` R (m), `.position.*` c (m). The core is at least 4 A h^2 for the step h: the minimum that a step can
//! resolve, even with all attractors of the list in one place.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, fade, place_in};
use crate::layout::parameters::forces::attractor::Attractor;
use crate::layout::scope::Reach;
use crate::math::simd::{Vector4, larger};
use crate::particles::tile::Tile;

/// An attractor in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    position: Vector4,
    acceleration: f32x4,
    core: f32x4,
    inverse_reach_squared: f32x4,
    scope: Reach,
}

impl Force for Attractor {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Push;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        if self.acceleration == 0.0 {
            return None;
        }
        let dt = context.now.dt;
        let core = self.core_radius.max(4.0 * self.acceleration.abs() * dt * dt);
        Some(Kernel {
            position: place_in(&context.now.frame(&self.scope), self.position),
            acceleration: f32x4::splat(self.acceleration as f32),
            core: f32x4::splat(core as f32),
            inverse_reach_squared: f32x4::splat((1.0 / (self.reach * self.reach)) as f32),
            scope: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        tile.push_by(kernels, |kernel| &kernel.scope, Kernel::acceleration);
    }
}

impl Kernel {
    #[inline(always)]
    fn acceleration(&self, place: Vector4) -> Vector4 {
        let inwards = self.position - place;
        let squared = inwards.dot(inwards);
        let strength = self.acceleration * fade(squared, self.inverse_reach_squared);
        inwards * (strength / larger(squared.sqrt(), self.core))
    }
}
