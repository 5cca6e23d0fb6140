//! Jets: air from a round nozzle, widening and slowing down.
//!
//! At the distance z from the nozzle and r from its axis the air moves along the axis at
//!
//! u = U min(1, sqrt(2) n / w) exp(-(max(0, r - k) / w)^2) (1 - z^2 / R^2)^2,  w = max(b z, n / 10).
//!
//! Beyond the core this is the self-similar round turbulent jet: a Gaussian profile of the width b z. Conservation of
//! momentum gives the speed U sqrt(2) n / (b z) on the axis; for the usual b = 0.113 that is 6.3 U times the diameter
//! over z, as measured (b = S / sqrt(ln 2) with S = 0.094 in Pope, "Turbulent Flows", Cambridge 2000, section 5.1;
//! Gaussian profile and core of constant speed after Albertson, Dai, Jensen and Rouse, "Diffusion of Submerged Jets",
//! Transactions of the ASCE 115, 1950). Nearer than 6.3 diameters a core of the radius k keeps the full speed: k =
//! sqrt(n^2 - (1/2 - pi/8) w^2) - sqrt(pi/8) w, again by momentum. The last factor ends the jet at its reach. Behind
//! the nozzle the air accelerates within one radius.
//!
//! Parameters: `jets.#.speed` U (m/s), `.radius` n (m), `.spread` b, `.reach` R (m), `.position.*` (m, centre of the
//! nozzle), `.direction.*` (of any length). The entrained air of a real jet is far slower and left out.

use std::f64::consts::PI;

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, direction_in, fade, place_in};
use crate::layout::parameters::forces::jet::Jet;
use crate::layout::scope::Reach;
use crate::math::simd::{Vector4, exp_minus, larger, positive_part, smaller, splat};
use crate::particles::tile::{Columns, Tile};

/// Width of the jet's edge at the nozzle, as a share of the nozzle's radius.
const EDGE: f64 = 0.1;

/// A jet in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    position: Vector4,
    direction: Vector4,
    speed: f32x4,
    /// Width at which the core ends (m).
    coreless: f32x4,
    radius_squared: f32x4,
    per_radius: f32x4,
    spread: f32x4,
    edge: f32x4,
    inverse_reach_squared: f32x4,
    scope: Reach,
}

impl Force for Jet {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        if self.speed == 0.0 {
            return None;
        }
        let frame = context.now.frame(&self.scope);
        Some(Kernel {
            position: place_in(&frame, self.position),
            direction: direction_in(&frame, self.direction),
            speed: splat(self.speed),
            coreless: splat(std::f64::consts::SQRT_2 * self.radius),
            radius_squared: splat(self.radius * self.radius),
            per_radius: splat(1.0 / self.radius),
            spread: splat(self.spread),
            edge: splat(EDGE * self.radius),
            inverse_reach_squared: splat(1.0 / (self.reach * self.reach)),
            scope: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let Columns {
            ahead, flow, weight, ..
        } = tile.columns();
        for kernel in kernels {
            kernel.scope.weigh(ahead, weight);
            for ((flow, ahead), weight) in flow.iter_mut().zip(&*ahead).zip(&*weight) {
                *flow += kernel.direction * (kernel.speed(*ahead) * *weight);
            }
        }
    }
}

impl Kernel {
    #[inline(always)]
    fn speed(&self, place: Vector4) -> f32x4 {
        let offset = place - self.position;
        let along = self.direction.dot(offset);
        let across = offset - self.direction * along;
        let width = larger(self.spread * along, self.edge);
        let beyond = positive_part(across.dot(across).sqrt() - self.core(width)) / width;
        let middle = smaller(self.coreless / width, f32x4::ONE);
        self.speed * middle * exp_minus(beyond * beyond) * self.ends(along)
    }

    /// Radius of the core (m) where the edge is `width` wide.
    #[inline(always)]
    fn core(&self, width: f32x4) -> f32x4 {
        const LOST: f32 = (0.5 - PI / 8.0) as f32;
        let kept = positive_part(self.radius_squared - width * width * f32x4::splat(LOST));
        // The square root of pi / 8.
        positive_part(kept.sqrt() - width * f32x4::splat(0.626_657_1))
    }

    /// Fade along the axis, 0..=1.
    #[inline(always)]
    fn ends(&self, along: f32x4) -> f32x4 {
        let ahead = positive_part(along);
        let begun = positive_part(f32x4::ONE + smaller(along, f32x4::ZERO) * self.per_radius);
        begun * begun * (f32x4::splat(3.0) - begun * 2.0) * fade(ahead * ahead, self.inverse_reach_squared)
    }
}
