//! Blows: gusts along a ray, such as the ray from the eye through the pointer.
//!
//! u = w e f(r / R)^2 a(s / R), with the peak velocity w, the level e in time (`layout::gust::Gust`), the distance r
//! from the ray, the distance s along it from its origin, and the radius R. f(x) = 1 - x^2 within the radius and 0
//! beyond. a rises as 3 x^2 - 2 x^3 from the origin and stays 1, so the flow is continuous at the origin. The velocity
//! is independent of the ray: a pointer that sweeps across the picture blows across its ray.

use arrayvec::ArrayVec;
use wide::f32x4;

use crate::forces::force::ForceContext;
use crate::layout::gust::{Gust, MAX_GUSTS};
use crate::math::simd::{Vector4, positive_part, smaller};
use crate::particles::tile::{Columns, Tile};

/// All gusts in one step.
pub type Kernels = ArrayVec<Kernel, MAX_GUSTS>;

/// A gust in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    origin: Vector4,
    ray: Vector4,
    velocity: Vector4,
    /// 1 / R (1/m).
    narrowness: f32x4,
}

/// Prepares the active gusts.
pub fn kernels(context: &ForceContext) -> Kernels {
    context.gusts.iter().map(Kernel::new).collect()
}

/// Adds the velocity of all gusts to the flow of `tile`.
pub fn act(kernels: &Kernels, tile: &mut Tile) {
    let Columns { ahead, flow, .. } = tile.columns();
    for kernel in kernels {
        for (flow, ahead) in flow.iter_mut().zip(&*ahead) {
            *flow += kernel.velocity * kernel.share(*ahead);
        }
    }
}

impl Kernel {
    fn new(gust: &Gust) -> Self {
        let level = f32x4::splat(gust.level());
        Self {
            origin: Vector4::splat(gust.blow.origin()),
            ray: Vector4::splat(gust.blow.ray()),
            velocity: Vector4::splat(gust.blow.velocity()) * level,
            narrowness: f32x4::splat(1.0 / gust.blow.radius()),
        }
    }

    /// Share of the peak velocity at a place, 0..=1.
    #[inline(always)]
    fn share(&self, place: Vector4) -> f32x4 {
        let from_origin = place - self.origin;
        let along = from_origin.dot(self.ray);
        let across = (from_origin - self.ray * along) * self.narrowness;
        let fall = positive_part(f32x4::ONE - across.dot(across));
        let onset = smaller(positive_part(along * self.narrowness), f32x4::ONE);
        fall * fall * onset * onset * (f32x4::splat(3.0) - onset - onset)
    }
}
