//! Boundary layers: air near a moving rigid is dragged along.
//!
//! Within the layer a particle goes with the surface point nearest to it, times 1 - t^2 (3 - 2 t), t = distance /
//! thickness: 1 at the surface, 0 and flat at the edge. This is air, not slip: nothing of it is kept when the rigid has
//! passed. What passes within less than a step is followed in parts of a step.

use crate::collide::contact::Obstacle;
use crate::collide::shapes::Collider;
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;
use crate::rigids::set::Rigids;

/// A rigid goes no farther than this share of its layer's thickness in one part of a step ...
const SHARE_OF_LAYER: f32 = 0.25;
/// ... where that does not need more parts than this.
const MAX_PARTS: f32 = 64.0;

impl Rigids {
    /// Moves the particles near rigids that have a boundary layer; to be called after all else has moved them over
    /// `dt` seconds and before they meet obstacles.
    pub(crate) fn drag_air(&mut self, particles: &mut Particles, radii: &RadiusLaw, dt: f32) {
        let Self {
            obstacles,
            members,
            layered,
            ..
        } = self;
        let thickness = |rigid: usize| members[rigid].description.boundary_layer;
        let bounds = |rigid: usize| {
            let Obstacle { motion, bounds, .. } = &obstacles[rigid];
            motion.is_moving().then(|| bounds.wider(thickness(rigid)))
        };
        layered.for_each_near(particles, radii, bounds, |particles, i, rigid| {
            let born = (particles.age[i] / dt).min(0.0) + 1.0;
            let from = Vector::new(particles.px[i], particles.py[i], particles.pz[i]);
            let to = Vector::new(particles.x[i], particles.y[i], particles.z[i]);
            let layer = Layer {
                obstacle: &obstacles[rigid],
                thickness: thickness(rigid),
                reach: members[rigid].reach,
            };
            let dragged = to + layer.drag(from, to, dt) * born.max(0.0);
            [particles.x[i], particles.y[i], particles.z[i]] = dragged.into();
        });
    }
}

struct Layer<'a> {
    obstacle: &'a Obstacle<Box<dyn Collider>>,
    thickness: f32,
    reach: f32,
}

impl Layer<'_> {
    /// How far (m) the layer takes a particle that goes from `from` to `to` in a step of `dt` seconds.
    fn drag(&self, from: Vector, to: Vector, dt: f32) -> Vector {
        let motion = &self.obstacle.motion;
        let way = motion.top_speed(self.reach) * dt;
        let parts = (way / (SHARE_OF_LAYER * self.thickness)).ceil().clamp(1.0, MAX_PARTS);
        let mut dragged = Vector::ZERO;
        let span = dt / parts;
        for part in 0..parts as u32 {
            // The midpoint rule, as for all air: what goes in circles shall not be thrown out of them.
            let fraction = (part as f32 + 0.5) / parts;
            let place = from.towards(to, fraction) + dragged;
            let half = self.velocity(place, fraction) * (0.5 * span);
            if half != Vector::ZERO {
                dragged = dragged + self.velocity(place + half, fraction) * span;
            }
        }
        dragged
    }

    fn velocity(&self, place: Vector, fraction: f32) -> Vector {
        let Obstacle { shape, motion, .. } = self.obstacle;
        let frame = motion.frame(fraction);
        let nearest = shape.nearest(frame.local_from_world(place), self.thickness);
        let t = (nearest.distance / self.thickness).max(0.0);
        if t >= 1.0 {
            return Vector::ZERO;
        }
        let surface = place - frame.rotate(nearest.normal) * nearest.distance;
        motion.velocity_at(surface, fraction) * (1.0 - t * t * (3.0 - 2.0 * t))
    }
}
