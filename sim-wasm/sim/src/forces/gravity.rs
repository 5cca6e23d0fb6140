//! Gravity: smoke heavier than air sinks.
//!
//! a = -g m up. Parameters: `gravity.acceleration` g (m/s2, downward: the net weight in air, not 9.81 for smoke),
//! `forces.gravity` m (multiplier). `gravities.#.*` pull in any direction in their regions.

use crate::forces::force::{Force, ForceContext, Phase, vector_in};
use crate::layout::parameters::forces::gravity::Gravity;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::Reach;
use crate::math::simd::Vector4;
use crate::particles::tile::{Columns, Tile};

/// A pull in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    acceleration: Vector4,
    reach: Reach,
}

impl Force for Gravity {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Push;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        let strength = context.parameters.forces.gravity;
        let acceleration = self.acceleration.map(|component| (component * strength) as f32);
        if acceleration == [0.0; 3] {
            return None;
        }
        let frame = context.now.frame(&self.scope);
        Some(Kernel {
            acceleration: vector_in(&frame, acceleration),
            reach: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn everywhere(context: &ForceContext) -> Option<Kernel> {
        // Upright gravity costs less in `particle_motion`.
        let up = context.now.parts.up?;
        let acceleration = acceleration(context.parameters);
        (acceleration > 0.0).then(|| Kernel {
            acceleration: Vector4::splat((up * -acceleration).into()),
            reach: Reach::everywhere(),
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        tile.is_pushed = true;
        let has_looks = tile.has_looks;
        let Columns {
            ahead,
            push,
            gravity,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.reach.weigh(ahead, weight);
            if has_looks {
                weight.iter_mut().zip(gravity).for_each(|(weight, own)| *weight *= *own);
            }
            for (push, weight) in push.iter_mut().zip(&*weight) {
                *push += kernel.acceleration * *weight;
            }
        }
    }
}

/// Global downward acceleration (m/s2).
pub fn acceleration(parameters: &Parameters) -> f32 {
    (parameters.gravity.acceleration * parameters.forces.gravity) as f32
}
