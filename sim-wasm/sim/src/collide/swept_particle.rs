//! One particle as the search for obstacles sees it.

use crate::collide::contact::Obstacle;
use crate::collide::survey::GridLocation;
use crate::math::bounds::WideBounds;
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;

/// A particle that may pass obstacles by.
pub(crate) struct SweptParticle {
    /// The box around its way.
    pub(crate) bounds: WideBounds,
    /// Where to look for rigids.
    #[cfg_attr(not(feature = "rigids"), expect(dead_code, reason = "there are none"))]
    pub(crate) location: GridLocation,
    from: Vector,
    to: Vector,
    /// Its radius is never greater (m).
    reach: f32,
    /// Its way takes the whole step.
    is_whole: bool,
}

impl SweptParticle {
    /// Particle `i` after it has moved.
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

    /// True when it surely does not touch the obstacle.
    #[inline]
    pub(crate) fn certainly_misses<C>(&self, obstacle: &Obstacle<C>) -> bool {
        let Obstacle { core, motion, .. } = obstacle;
        self.is_whole & core.is_certainly_missed_by(motion, self.from, self.to, self.reach)
    }
}

/// From where to where particle `i` has moved in the step (m).
#[inline]
pub(crate) fn way(particles: &Particles, i: usize) -> (Vector, Vector) {
    let from = Vector::new(particles.px[i], particles.py[i], particles.pz[i]);
    let to = Vector::new(particles.x[i], particles.y[i], particles.z[i]);
    (from, to)
}
