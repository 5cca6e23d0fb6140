//! Boundary layers: moving rigids drag the air near them along.
//!
//! Within the layer a particle moves with the nearest point of the surface, times 1 - t^2 (3 - 2 t) for t = distance /
//! thickness: 1 at the surface, 0 with slope 0 at the edge. This is air velocity, not slip: a particle keeps none of
//! it. Rigids that pass within less than a step are followed in substeps.

use crate::collide::contact::Obstacle;
use crate::collide::shapes::Collider;
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;
use crate::rigids::set::Rigids;

/// Maximum displacement of a rigid per substep, as a share of the thickness of its layer,
const SHARE_OF_LAYER: f32 = 0.25;
/// up to this number of substeps.
const MAX_PARTS: f32 = 64.0;

impl Rigids {
    /// Moves the particles near rigids that have a boundary layer. Call it after all other motion over `dt` seconds and
    /// before collisions.
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
            (motion.is_moving() && thickness(rigid) > 0.0).then(|| bounds.wider(thickness(rigid)))
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
    /// Displacement (m) by the layer of a particle that moves from `from` to `to` in a step of `dt` seconds.
    fn drag(&self, from: Vector, to: Vector, dt: f32) -> Vector {
        let motion = &self.obstacle.motion;
        let way = motion.top_speed(self.reach) * dt;
        let parts = (way / (SHARE_OF_LAYER * self.thickness)).ceil().clamp(1.0, MAX_PARTS);
        let mut dragged = Vector::ZERO;
        let span = dt / parts;
        for part in 0..parts as u32 {
            // The midpoint rule, as for all air: circular flow must not throw particles out.
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
