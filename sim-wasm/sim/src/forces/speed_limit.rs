//! Speed limits.
//!
//! If air and slip would move a particle farther than L h in a step, its displacement and its slip are scaled by the
//! same factor f: a hard limit without effect below it. At the region's weight w the factor is 1 - w (1 - f).
//! Parameter: `speedLimits.#.speed` L (m/s). After Sims, "Particle Animation and Rendering Using Data Parallel
//! Computation", SIGGRAPH 1990.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::layout::parameters::forces::speed_limit::SpeedLimit;
use crate::layout::scope::Reach;
use crate::math::simd::Vector4;
use crate::particles::tile::{Columns, Tile};

/// A speed limit in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    speed: f32x4,
    reach: Reach,
}

impl Force for SpeedLimit {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Limit;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        Some(Kernel {
            speed: f32x4::splat(self.speed as f32),
            reach: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let is_instant = tile.is_instant;
        let per_dt = f32x4::splat(1.0 / tile.dt);
        let Columns {
            ahead,
            flow,
            slip,
            slipped,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.reach.weigh(ahead, weight);
            for (block, weight) in weight.iter().enumerate() {
                // The integrator `paper` has one velocity, stored as slip.
                let velocity = if is_instant {
                    slip[block]
                } else {
                    flow[block] + slipped[block] * per_dt
                };
                let factor = kernel.factor(velocity, *weight);
                flow[block] = flow[block] * factor;
                slipped[block] = slipped[block] * factor;
                slip[block] = slip[block] * factor;
            }
        }
    }
}

impl Kernel {
    #[inline(always)]
    fn factor(&self, velocity: Vector4, weight: f32x4) -> f32x4 {
        let speed = velocity.dot(velocity).sqrt();
        let is_fast = speed.simd_gt(self.speed);
        let kept = is_fast.select(self.speed / speed, f32x4::ONE);
        f32x4::ONE - weight * (f32x4::ONE - kept)
    }
}
