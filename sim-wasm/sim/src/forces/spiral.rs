//! Spirals: the air rotates about an axis like a rigid wheel, flows inwards and rises.
//!
//! r' = -i f min(1, r / c), theta' = w f, z' = v f with f = (1 - r^2 / R^2)^2, and still air where r >= R. Parameters:
//! `spirals.#.turn` w (rad/s, counter-clockwise seen against the axis), `.inward` i (m/s, negative outwards), `.along`
//! v (m/s, along the axis), `.coreRadius` c (m, within which the inward flow slows down), `.reach` R (m), `.position.*`
//! (m, a point on the axis), `.axis.*` (a direction of any length). After Sims, "Particle Animation and Rendering Using
//! Data Parallel Computation", SIGGRAPH 1990. The core of the inward flow is at least as wide as two steps of it are
//! long, so that no particle oscillates across the axis.
//!
//! The integrator must not move a particle outwards. The expected displacement of a step is that of the last step,
//! rotated by the angle a of this one. The air velocity at its middle, with w lengthened to 2 tan(a / 2) / h, then
//! moves the particle along the exact chord of its circle. Combined with other flows the rule is of second order.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, direction_in, fade, place_in};
use crate::layout::parameters::forces::spiral::Spiral;
use crate::layout::scope::Reach;
use crate::math::simd::{Vector4, larger, splat};
use crate::particles::tile::{Columns, Tile};

/// A spiral in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    position: Vector4,
    axis: Vector4,
    turn: f32x4,
    inward: f32x4,
    along: f32x4,
    core: f32x4,
    inverse_reach_squared: f32x4,
    /// Half of the step (s), and its inverse (1/s).
    half: f32x4,
    per_half: f32x4,
    scope: Reach,
}

impl Force for Spiral {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        if [self.turn, self.inward, self.along] == [0.0; 3] {
            return None;
        }
        let frame = context.now.frame(&self.scope);
        let dt = context.now.dt;
        Some(Kernel {
            position: place_in(&frame, self.position),
            axis: direction_in(&frame, self.axis),
            turn: splat(self.turn),
            inward: splat(self.inward),
            along: splat(self.along),
            core: splat(self.core_radius.max(2.0 * self.inward.abs() * dt)),
            inverse_reach_squared: splat(1.0 / (self.reach * self.reach)),
            half: splat(dt * 0.5),
            per_half: splat(2.0 / dt),
            scope: Reach::new(&self.scope, &context.now)?,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let is_instant = tile.is_instant;
        let Columns {
            place,
            ahead,
            flow,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.scope.weigh(ahead, weight);
            let places = place.iter().zip(&*ahead);
            for ((flow, (place, ahead)), weight) in flow.iter_mut().zip(places).zip(&*weight) {
                let strength = kernel.strength(*ahead) * *weight;
                let turn = kernel.turn * strength;
                let (middle, turn) = if is_instant {
                    (*place, turn)
                } else {
                    kernel.chord(*place, *ahead, turn)
                };
                *flow += kernel.velocity(middle, turn, strength);
            }
        }
    }
}

impl Kernel {
    /// The vector from the axis.
    #[inline(always)]
    fn outwards(&self, place: Vector4) -> Vector4 {
        let offset = place - self.position;
        offset - self.axis * self.axis.dot(offset)
    }

    #[inline(always)]
    fn strength(&self, place: Vector4) -> f32x4 {
        let outwards = self.outwards(place);
        fade(outwards.dot(outwards), self.inverse_reach_squared)
    }

    /// The expected middle of a step's chord at the angular velocity `turn`, and the angular velocity that moves the
    /// particle along the chord. `ahead` is half of the last displacement away.
    #[inline(always)]
    fn chord(&self, place: Vector4, ahead: Vector4, turn: f32x4) -> (Vector4, f32x4) {
        let angle = turn * self.half;
        let square = angle * angle;
        // Tangent of half the angle. The error of the series is 4e-4 at the maximum angular velocity.
        let tangent = angle * (f32x4::ONE + square * (f32x4::splat(1.0 / 3.0) + square * f32x4::splat(2.0 / 15.0)));
        let share = tangent * f32x4::splat(2.0) / (f32x4::ONE + tangent * tangent);
        let way = ahead - place;
        let across = self.axis.cross(way);
        let turned = way + across * share + self.axis.cross(across) * (share * tangent);
        (place + turned, tangent * self.per_half)
    }

    #[inline(always)]
    fn velocity(&self, place: Vector4, turn: f32x4, strength: f32x4) -> Vector4 {
        let outwards = self.outwards(place);
        let distance = outwards.dot(outwards).sqrt();
        let inward = self.inward * strength / larger(distance, self.core);
        self.axis.cross(outwards) * turn - outwards * inward + self.axis * (self.along * strength)
    }
}
