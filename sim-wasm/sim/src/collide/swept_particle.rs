//! A particle in the broad phase.

use crate::collide::broad_phase::GridLocation;
use crate::collide::contact::Obstacle;
use crate::math::bounds::WideBounds;
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;

/// A particle and its path over the step.
pub(crate) struct SweptParticle {
    /// Box of its path.
    pub(crate) bounds: WideBounds,
    /// Location in the grid of rigids.
    #[cfg_attr(not(feature = "meshes"), expect(dead_code, reason = "there are none"))]
    pub(crate) location: GridLocation,
    from: Vector,
    to: Vector,
    /// Upper bound of its radius (m).
    reach: f32,
    /// True if its path takes the whole step.
    is_whole: bool,
}

impl SweptParticle {
    /// Particle `i` after its motion.
    #[inline]
    pub(crate) fn new(particles: &Particles, i: usize, radii: &RadiusLaw, location: GridLocation) -> Self {
        let (from, to) = way(particles, i);
        let reach = particles.size[i] * radii.puff_size;
        Self {
            bounds: WideBounds::of_way(from, to, reach),
            location,
            from,
            to,
            reach,
            is_whole: particles.age[i] >= 0.0,
        }
    }

    /// Returns true if the particle certainly does not touch the obstacle.
    #[inline]
    pub(crate) fn certainly_misses<C>(&self, obstacle: &Obstacle<C>) -> bool {
        let Obstacle { core, motion, .. } = obstacle;
        self.is_whole & core.is_certainly_missed_by(motion, self.from, self.to, self.reach)
    }
}

/// Start and end of the path of particle `i` in the step (m).
#[inline]
pub(crate) fn way(particles: &Particles, i: usize) -> (Vector, Vector) {
    let from = Vector::new(particles.px[i], particles.py[i], particles.pz[i]);
    let to = Vector::new(particles.x[i], particles.y[i], particles.z[i]);
    (from, to)
}
