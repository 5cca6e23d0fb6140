//! A flow in one step, on a tile of particles.

use std::sync::Arc;

use wide::f32x4;

use crate::forces::flow::near::{Near, Reached, Samples, Spots};
use crate::forces::flow::path::Path;
use crate::forces::force::{Force, ForceContext, Phase, fade, place_in, vector_in};
use crate::layout::parameters::forces::flow::Flow;
use crate::layout::scope::Reach;
use crate::math::simd::{Vector4, splat};
use crate::particles::tile::{Columns, TILE_BLOCKS, Tile};

/// 25 sqrt(5) / 16: the inverse of the greatest value of x (1 - x^2)^2.
const PEAK: f64 = 3.493_856;

/// A flow in one step. Its path is in units of `scale` metres: sides of its cells.
#[derive(Clone, Debug)]
pub struct Kernel {
    path: Arc<Path>,
    /// Origin of the path.
    origin: Vector4,
    /// Axes of the path's frame in world space; none if they are those of the world.
    axes: Option<[Vector4; 3]>,
    per_scale: f32x4,
    scale: f32x4,
    speed: f32x4,
    /// Angular velocity (rad/s).
    swirl: f32x4,
    is_swirling: bool,
    /// Speed to the path, per distance from it in units of `scale` (m/s).
    inflow: f32x4,
    inverse_radius_squared: f32x4,
    scope: Reach,
}

impl Force for Flow {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Kernel> {
        if [self.speed, self.swirl, self.inflow] == [0.0; 3] {
            return None;
        }
        let path = context.prepared.paths[index].clone()?;
        let scope = Reach::new(&self.scope, &context.now)?;
        let frame = context.now.frame(&self.scope);
        let is_riding = context.now.ride(&self.scope, 0.5).is_some();
        let side = f64::from(path.side);
        let (scale, radius) = (self.scale * side, self.radius / side);
        let origin: [f32; 3] = path.origin.into();
        let origin = std::array::from_fn(|axis| self.position[axis] + self.scale * f64::from(origin[axis]));
        // No more than half of the way to the stroke in a step.
        let most = 0.5 * scale / context.now.dt;
        let inflow = (PEAK * self.inflow / radius).clamp(-most, most);
        Some(Kernel {
            path,
            origin: place_in(&frame, origin),
            axes: is_riding
                .then(|| [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| vector_in(&frame, axis))),
            per_scale: splat(1.0 / scale),
            scale: splat(scale),
            speed: splat(self.speed),
            swirl: splat(self.swirl),
            is_swirling: self.swirl != 0.0,
            inflow: splat(inflow),
            inverse_radius_squared: splat(1.0 / (radius * radius)),
            scope,
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let dt = if tile.is_instant { 0.0 } else { tile.dt };
        let Columns {
            place,
            ahead,
            flow,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.scope.weigh(ahead, weight);
            let mut spots = Spots::new_const();
            spots.extend(ahead.iter().map(|ahead| kernel.path.spot(kernel.local(*ahead))));
            let mut reached = [Reached::default(); TILE_BLOCKS];
            let reached = kernel.path.reached(&spots, &mut reached);
            let mut samples = Samples::new_const();
            samples.extend(reached.iter().map(|reached| kernel.path.samples(&spots, reached)));
            for (&Reached { block, .. }, samples) in reached.iter().zip(&samples) {
                let way = || kernel.local(place[block]) - spots[block].place;
                flow[block] += kernel.world(kernel.velocity(&samples.near(), way, weight[block], dt));
            }
        }
    }
}

impl Kernel {
    /// A place in the path's frame.
    #[inline(always)]
    fn local(&self, place: Vector4) -> Vector4 {
        let offset = (place - self.origin) * self.per_scale;
        match &self.axes {
            None => offset,
            Some([x, y, z]) => Vector4 {
                x: x.dot(offset),
                y: y.dot(offset),
                z: z.dot(offset),
            },
        }
    }

    /// A velocity of the path's frame in world space.
    #[inline(always)]
    fn world(&self, velocity: Vector4) -> Vector4 {
        match &self.axes {
            None => velocity,
            Some([x, y, z]) => *x * velocity.x + *y * velocity.y + *z * velocity.z,
        }
    }

    /// Velocity (m/s) in the path's frame. `way`: returns that from the middle of a step of `dt` seconds back to its start.
    #[inline(always)]
    fn velocity(&self, near: &Near, way: impl Fn() -> Vector4, weight: f32x4, dt: f32) -> Vector4 {
        let Near {
            offset,
            across,
            direction,
        } = *near;
        let strength = fade(offset.dot(offset), self.inverse_radius_squared) * weight;
        let along = (direction * self.speed - across * self.inflow) * strength;
        if !self.is_swirling {
            return along;
        }
        let way = way();
        let start = across + way - direction * direction.dot(way);
        along + self.swirl(direction, start, strength, dt)
    }

    /// Velocity (m/s) of the rotation about `direction` of a particle that is `start` away from it at the start of a step.
    #[inline(always)]
    fn swirl(&self, direction: Vector4, start: Vector4, strength: f32x4, dt: f32) -> Vector4 {
        let turn = self.swirl * strength;
        let tangent = turn * f32x4::splat(0.5 * dt);
        let share = turn * self.scale / (f32x4::ONE + tangent * tangent);
        let around = direction.cross(start);
        (around - start * tangent) * share
    }
}
