//! Explosions: a spherical front that accelerates particles as it passes.
//!
//! At each start of its envelope a front leaves the centre at a constant speed. In the step after it passes a particle,
//! the particle's slip changes once by j (1 - r^2 / R^2)^2 outwards, less the drag of that step, for the distance r
//! from the centre. Parameters: `explosions.#.impulse` j (m/s, negative inwards), `.speed` of the front (m/s), `.reach`
//! R (m), `.position.*` (m). The front ends with its envelope; the next start replaces a running front. A particle that
//! is born within the front, or overtakes it, waits for the next front.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, fade, place_in};
use crate::layout::parameters::forces::explosion::Explosion;
use crate::layout::scope::Reach;
use crate::layout::scope::envelope::since_start;
use crate::math::simd::Vector4;
use crate::particles::tile::{Columns, Tile};

/// Distance from the centre (m) below which there is no outward direction.
const NOWHERE: f32 = 1e-12;

/// A front in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    position: Vector4,
    impulse: f32x4,
    /// Radius (m) one step before the start of this step, at its start and at its end; below 0 before the front starts.
    fronts: [f32x4; 3],
    inverse_reach_squared: f32x4,
    scope: Reach,
}

impl Force for Explosion {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Push;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        if self.impulse == 0.0 {
            return None;
        }
        let dt = context.now.dt;
        let since = since_start(&self.scope, context.now.time + dt * 0.5)?;
        let front = |steps: f64| self.speed * (since - steps * dt);
        if front(2.0) > self.reach {
            return None;
        }
        Some(Kernel {
            position: place_in(&context.now.frame(&self.scope), self.position),
            impulse: f32x4::splat(self.impulse as f32),
            fronts: [2.0, 1.0, 0.0].map(|steps| f32x4::splat(front(steps) as f32)),
            inverse_reach_squared: f32x4::splat((1.0 / (self.reach * self.reach)) as f32),
            scope: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        tile.is_pushed = true;
        let is_instant = tile.is_instant;
        let dt = f32x4::splat(tile.dt);
        let per_dt = f32x4::splat(1.0 / tile.dt);
        let Columns {
            place,
            ahead,
            slip,
            push,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.scope.weigh(ahead, weight);
            for (block, push) in push.iter_mut().enumerate() {
                let place = place[block];
                // Uses the last displacement if it is known, else that of this step, which is straight.
                let thrown = if is_instant {
                    kernel.throw(place, place, place + slip[block] * dt, 1)
                } else {
                    kernel.throw(place, place - (ahead[block] - place) * f32x4::splat(2.0), place, 0)
                };
                *push += thrown * (weight[block] * per_dt);
            }
        }
    }
}

impl Kernel {
    /// Velocity change (m/s) of a particle at `place` if the front passes it between `from` and `to`, a step that
    /// starts with front number `first`.
    #[inline(always)]
    fn throw(&self, place: Vector4, from: Vector4, to: Vector4, first: usize) -> Vector4 {
        let distance = |place: Vector4| {
            let outwards = place - self.position;
            outwards.dot(outwards).sqrt()
        };
        let before = distance(from).simd_ge(self.fronts[first]);
        let after = distance(to).simd_lt(self.fronts[first + 1]);
        let outwards = place - self.position;
        let squared = outwards.dot(outwards);
        let speed = self.impulse * fade(squared, self.inverse_reach_squared);
        outwards * (before & after & (speed / (squared.sqrt() + f32x4::splat(NOWHERE))))
    }
}
