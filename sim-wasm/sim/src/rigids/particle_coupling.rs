//! The force of smoke on light rigids.
//!
//! The particles near a rigid sample the flow past it: their mean velocity u, relative to the rigid, in a shell as wide
//! as the rigid is large. Particles close to the surface were stopped by it: at the share t of the shell the weight is
//! 16 t^2 (1 - t)^2, 0 at the surface and at the edge. The bounding box acts as three flat plates with normal forces
//! (Hoerner, 'Fluid-Dynamic Drag', 1965: the normal force of a plate is proportional to the sine of its angle to the
//! flow, with C = 1.17 for normal flow): F = sum over the axes n of C rho/2 A_n |u| (u.n) n. The component along u is
//! drag, the rest is the lift of a tilted plate. For a ball it is C rho/2 pi r2 |u| u with C = 0.47. The force acts
//! where the smoke is, off the centre. The air damps rotation at the same rate as translation.

use crate::collide::shapes::Collider;
use crate::math::bounds::Bounds;
use crate::math::pose::Frame;
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;
use crate::rigids::set::{Member, Rigids, SmokeSum};
use crate::rigids::world::Push;

/// Density of air (kg/m3).
const AIR_DENSITY: f32 = 1.2;
const PLATE_COEFFICIENT: f32 = 1.17;
const BALL_COEFFICIENT: f32 = 0.47;

impl Rigids {
    /// Measures the smoke near the rigids that feel it and applies its force for the coming step of `dt` seconds. Call
    /// it before that step.
    pub(crate) fn apply_smoke_forces(&mut self, particles: &mut Particles, radii: &RadiusLaw, dt: f32) {
        let Self {
            obstacles,
            members,
            feeling,
            sums,
            world,
            ..
        } = self;
        sums.iter_mut().for_each(|sum| *sum = SmokeSum::default());
        let bounds = |rigid: usize| {
            let member: &Member = &members[rigid];
            let own = Frame::new(&member.pose).bounds_of(&obstacles[rigid].shape.bounds());
            member.feels_smoke().then(|| own.wider(member.reach))
        };
        feeling.for_each_near(particles, radii, bounds, |particles, i, rigid| {
            let reach = members[rigid].reach;
            let place = Vector::new(particles.x[i], particles.y[i], particles.z[i]);
            let before = Vector::new(particles.px[i], particles.py[i], particles.pz[i]);
            let law = particles.radius_law(radii, i);
            let radius = law.radius(particles.size[i], particles.age[i], particles.lifetime[i]);
            let local = Frame::new(&members[rigid].pose).local_from_world(place);
            let gap = obstacles[rigid].shape.nearest(local, radius + reach).distance - radius;
            let t = (gap / reach).clamp(0.0, 1.0);
            let weight = 16.0 * t * t * (1.0 - t) * (1.0 - t);
            let sum = &mut sums[rigid];
            sum.weight += weight;
            sum.velocity = sum.velocity + (place - before) * (weight / dt);
            sum.offset = sum.offset + (place - members[rigid].pose.position) * weight;
        });
        for (index, (member, sum)) in members.iter().zip(sums.iter()).enumerate() {
            if member.feels_smoke() && sum.weight > 0.0 {
                world.blow(index, &member.push(&obstacles[index].shape, sum), dt);
            }
        }
    }
}

impl Member {
    fn push(&self, shape: &dyn Collider, sum: &SmokeSum) -> Push {
        let frame = Frame::new(&self.pose);
        let bounds = shape.bounds();
        let half = (bounds.max - bounds.min) * 0.5;
        // Little smoke exerts little force: a single puff must not act like a storm.
        let share = self.description.feels_smoke * sum.weight.min(1.0) * 0.5 * AIR_DENSITY;
        let areas = if shape.is_round() {
            let area = BALL_COEFFICIENT * std::f32::consts::PI * half.x * half.x;
            Vector::new(area, area, area)
        } else {
            Vector::new(half.y * half.z, half.z * half.x, half.x * half.y) * (4.0 * PLATE_COEFFICIENT)
        };
        Push {
            velocity: sum.velocity * (1.0 / sum.weight),
            axes: [Vector::new(1.0, 0.0, 0.0), Vector::Y, Vector::new(0.0, 0.0, 1.0)].map(|axis| frame.rotate(axis)),
            resistance: areas * share,
            point: frame.world_from_local(middle_part(&frame, &bounds, sum.offset * (1.0 / sum.weight))),
        }
    }
}

/// Transforms a world-space offset to the rigid's space, limited to the inner half of the box.
fn middle_part(frame: &Frame, bounds: &Bounds, offset: Vector) -> Vector {
    let middle = (bounds.min + bounds.max) * 0.5;
    let quarter = (bounds.max - bounds.min) * 0.25;
    let local = frame.local_from_world(frame.world_from_local(Vector::ZERO) + offset);
    local.greatest(middle - quarter).least(middle + quarter)
}
