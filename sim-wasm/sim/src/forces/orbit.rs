//! Orbits: smoke circles a point or a line.
//!
//! a = -mu d / (d^2 + s^2)^(3/2) for the vector d from a point (Plummer, "On the problem of distribution in globular
//! star clusters", Monthly Notices of the Royal Astronomical Society 71, 1911), and a = -mu d / (d^2 + s^2) for the
//! vector d from a line. Parameters: `orbits.#.acceleration` (m/s2), the strength of mu at a distance of one metre
//! without a core, negative to repel; `.coreRadius` s (m); `.position.*` (m), the point, or a point on the line;
//! `.axis.*`, the direction of the line, all 0 for a point. After Sims, "Particle Animation and Rendering Using Data
//! Parallel Computation", SIGGRAPH 1990.
//!
//! At the speed sqrt(mu / r), around a line sqrt(mu), smoke without drag stays on a circle well outside of the core.
//! Leapfrog steps conserve the energy of a closed orbit. The core is at least so large that a swing through it takes
//! four pi steps.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, direction_in, place_in};
use crate::layout::parameters::forces::orbit::Orbit;
use crate::layout::scope::Reach;
use crate::math::simd::Vector4;
use crate::particles::tile::Tile;

/// The centre of an orbit in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    position: Vector4,
    /// Zero for a point.
    axis: Vector4,
    is_line: bool,
    acceleration: f32x4,
    core_squared: f32x4,
    scope: Reach,
}

impl Force for Orbit {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Push;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        if self.acceleration == 0.0 {
            return None;
        }
        let frame = context.now.frame(&self.scope);
        let is_line = self.axis != [0.0; 3];
        let core = self.core_radius.max(self.min_core(is_line, context.now.dt));
        Some(Kernel {
            position: place_in(&frame, self.position),
            axis: if is_line {
                direction_in(&frame, self.axis)
            } else {
                Vector4::zero()
            },
            is_line,
            acceleration: f32x4::splat(self.acceleration as f32),
            core_squared: f32x4::splat((core * core) as f32),
            scope: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        tile.push_by(kernels, |kernel| &kernel.scope, Kernel::acceleration);
    }
}

impl Orbit {
    /// Minimum core (m): smoke swings by half a radian per step, which is stable even for eight orbits in one place.
    fn min_core(&self, is_line: bool, dt: f64) -> f64 {
        let volume = 4.0 * self.acceleration.abs() * dt * dt;
        if is_line {
            libm::sqrt(volume)
        } else {
            libm::cbrt(volume)
        }
    }
}

impl Kernel {
    #[inline(always)]
    fn acceleration(&self, place: Vector4) -> Vector4 {
        let offset = self.position - place;
        let inwards = offset - self.axis * self.axis.dot(offset);
        let squared = inwards.dot(inwards) + self.core_squared;
        let divisor = if self.is_line {
            squared
        } else {
            squared * squared.sqrt()
        };
        inwards * (self.acceleration / divisor)
    }
}
