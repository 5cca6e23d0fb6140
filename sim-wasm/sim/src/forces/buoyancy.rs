//! Buoyancy: warm smoke rises and cools.
//!
//! a = b m T up, and T' = -T / tau. Parameters: `buoyancy.acceleration` b (m/s2 upward at temperature 1),
//! `forces.buoyancy` m (multiplier), `buoyancy.coolingTime` tau (s). The cooling of a step is exact. `buoyancies.#.*`
//! add to b in their regions; they may be negative.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, up_in};
use crate::layout::parameters::forces::buoyancy::Buoyancy;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::Reach;
use crate::math::simd::Vector4;
use crate::particles::tile::{Columns, Tile};

/// A buoyancy in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    acceleration: f32x4,
    /// The direction of up; none for y.
    up: Option<Vector4>,
    reach: Reach,
}

impl Force for Buoyancy {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Push;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        let acceleration = (self.acceleration * context.parameters.forces.buoyancy) as f32;
        if acceleration == 0.0 {
            return None;
        }
        Some(Kernel {
            acceleration: f32x4::splat(acceleration),
            up: up_in(context),
            reach: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn everywhere(context: &ForceContext) -> Option<Kernel> {
        // Upright buoyancy costs less in `particle_motion`.
        let up = up_in(context)?;
        let acceleration = acceleration_per_temperature(context.parameters);
        (acceleration > 0.0).then(|| Kernel {
            acceleration: f32x4::splat(acceleration),
            up: Some(up),
            reach: Reach::everywhere(),
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        tile.is_pushed = true;
        let Columns {
            ahead,
            push,
            heat,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.reach.weigh(ahead, weight);
            for ((push, heat), weight) in push.iter_mut().zip(heat).zip(&*weight) {
                let lift = kernel.acceleration * *heat * *weight;
                match kernel.up {
                    None => push.y += lift,
                    Some(up) => *push += up * lift,
                }
            }
        }
    }
}

/// Global upward acceleration (m/s2) at temperature 1.
pub fn acceleration_per_temperature(parameters: &Parameters) -> f32 {
    (parameters.buoyancy.acceleration * parameters.forces.buoyancy) as f32
}

/// Factor on the temperature after `dt` seconds, 0..1.
pub fn cooling(parameters: &Parameters, dt: f64) -> f32 {
    libm::exp(-dt / parameters.buoyancy.cooling_time) as f32
}
