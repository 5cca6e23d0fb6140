//! Collision of all particles with all obstacles of a step.

use crate::collide::analytic::AnalyticShape;
use crate::collide::broad_phase::{self, NearLanes, SweptBoxes};
use crate::collide::contact::{Action, Obstacle, Pass, Traveller};
use crate::collide::swept_particle::{self, SweptParticle};
use crate::math::bounds::WideBounds;
use crate::math::scalar::greater;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;
#[cfg(feature = "meshes")]
use crate::rigids::set::Rigids;

/// Rounds of pushing a particle out of one obstacle and possibly into the next. A right corner needs two. In an acute
/// corner each round leaves a share of the overlap: the squared cosine of the angle.
const PASSES: [Pass; 8] = {
    let mut passes = [Pass::Again; 8];
    passes[0] = Pass::First;
    passes
};
const MAX_COLLIDERS: usize = 8;
/// Shortest share of a step over which the displacement of a newborn particle defines a velocity.
const MIN_STEP_FRACTION: f32 = 1e-3;
/// Largest seed byte of a particle.
const MAX_SEED: f32 = 255.0;

/// Scratch memory of [`resolve`]. Allocated once; its size does not depend on the number of particles.
#[derive(Debug)]
pub struct Scratch {
    obstacles: Vec<Obstacle<AnalyticShape>>,
    near: Vec<u32>,
}

impl Scratch {
    /// Creates the scratch memory for `capacity` particles.
    pub fn new(_capacity: usize) -> Self {
        Self {
            obstacles: Vec::with_capacity(MAX_COLLIDERS),
            near: Vec::with_capacity(64),
        }
    }
}

/// All obstacles of a step.
struct Obstacles<'a> {
    analytic: &'a [Obstacle<AnalyticShape>],
    #[cfg(feature = "meshes")]
    rigids: &'a Rigids,
}

/// Moves particles out of colliders and rigids. Call it after motion and before ageing, while `px`, `py` and `pz` still
/// hold the positions at the start of the step. `dt` is in seconds; `radii.radius(..)` is the collision radius (m).
/// Allocates only for more obstacles than before.
pub fn resolve(
    particles: &mut Particles,
    radii: &RadiusLaw,
    colliders: impl Iterator<Item = Obstacle<AnalyticShape>>,
    #[cfg(feature = "meshes")] rigids: &mut Rigids,
    dt: f32,
    scratch: &mut Scratch,
) {
    scratch.obstacles.clear();
    scratch.obstacles.extend(colliders);
    #[cfg(feature = "meshes")]
    if rigids.count() > 0 {
        rigids.prepare(&broad_phase::extent(particles, radii));
        scratch.near.reserve(rigids.count() + scratch.obstacles.len());
    }
    let obstacles = Obstacles {
        analytic: &scratch.obstacles,
        #[cfg(feature = "meshes")]
        rigids,
    };
    if obstacles.are_none() {
        return;
    }
    let look = |swept_boxes: &SweptBoxes| obstacles.look(swept_boxes);
    broad_phase::for_each_near(particles, radii, look, |particles, i, location| {
        let swept_particle = SweptParticle::new(particles, i, radii, location);
        if !obstacles.find_near(&swept_particle, &mut scratch.near) {
            // Colliders are found in their order, rigids are not.
            #[cfg(feature = "meshes")]
            scratch.near.sort_unstable();
            resolve_one(particles, i, radii, &obstacles, dt, &scratch.near);
        }
    });
}

fn resolve_one(particles: &mut Particles, i: usize, radii: &RadiusLaw, obstacles: &Obstacles, dt: f32, near: &[u32]) {
    let traveller = traveller(particles, i, radii, dt);
    let mut pushed = traveller;
    let touched = obstacles.meet(&mut pushed, near);
    obstacles.sense(
        particles,
        i,
        &Traveller {
            to: pushed.to,
            ..traveller
        },
        near,
    );
    if touched {
        [particles.x[i], particles.y[i], particles.z[i]] = pushed.to.into();
        if traveller.began <= 1.0 - MIN_STEP_FRACTION {
            let change = pushed.velocity - traveller.velocity;
            particles.sx[i] += change.x;
            particles.sy[i] += change.y;
            particles.sz[i] += change.z;
        }
    }
}

/// The path of particle `i` over the step just made. Its age is the age at the start of the step, below 0 if it was
/// born within the step. Its radius is the larger of the radius now and after ageing, so that growth does not put it
/// into a wall.
fn traveller(particles: &Particles, i: usize, radii: &RadiusLaw, dt: f32) -> Traveller {
    let (from, to) = swept_particle::way(particles, i);
    let radii = particles.radius_law(radii, i);
    let (size, age, lifetime) = (particles.size[i], particles.age[i], particles.lifetime[i]);
    let began = (-age / dt).clamp(0.0, 1.0);
    let span = dt * greater(1.0 - began, MIN_STEP_FRACTION);
    let radius = greater(
        radii.radius(size, age, lifetime),
        radii.radius(size, age + dt, lifetime),
    );
    // The radius that a particle has lost may become distance, which keeps its reach that of a full one.
    let full = radii.undiminished(size, greater(age, 0.0), lifetime);
    Traveller {
        from,
        to,
        velocity: (to - from) * (1.0 / span),
        radius,
        margin: greater(full - radius, 0.0) * seed_share(particles.attributes[i]),
        began,
    }
}

/// The seed byte of a particle, scaled to 0..1.
fn seed_share(attributes: u32) -> f32 {
    (attributes >> 8 & 0xff) as f32 / MAX_SEED
}

impl Obstacles<'_> {
    fn are_none(&self) -> bool {
        #[cfg(feature = "meshes")]
        if self.rigids.count() > 0 {
            return false;
        }
        self.analytic.is_empty()
    }

    /// Finds which of four particles may be near an obstacle.
    #[inline]
    fn look(&self, swept_boxes: &SweptBoxes) -> NearLanes {
        let lanes = self
            .analytic
            .iter()
            .fold(0, |lanes, obstacle| lanes | swept_boxes.touching(&obstacle.bounds));
        #[cfg(feature = "meshes")]
        if self.rigids.count() > 0 {
            let rigids = self.rigids.look(swept_boxes);
            return NearLanes {
                lanes: lanes | rigids.lanes,
                ..rigids
            };
        }
        NearLanes {
            lanes,
            ..NearLanes::default()
        }
    }

    /// Writes the indices of the obstacles whose boxes the particle's box touches. Returns true if the particle
    /// certainly misses them all.
    #[inline]
    fn find_near(&self, swept_particle: &SweptParticle, near: &mut Vec<u32>) -> bool {
        near.clear();
        let mut misses = true;
        for (index, obstacle) in self.analytic.iter().enumerate() {
            if WideBounds::from(&obstacle.bounds).touches(&swept_particle.bounds) {
                near.push(index as u32);
                misses &= swept_particle.certainly_misses(obstacle);
            }
        }
        #[cfg(feature = "meshes")]
        if self.rigids.count() > 0 {
            misses &= self.rigids.find_near(swept_particle, self.analytic.len() as u32, near);
        }
        misses
    }

    /// Returns true if the traveller touched any of `near`.
    fn meet(&self, traveller: &mut Traveller, near: &[u32]) -> bool {
        let mut touched = false;
        for pass in PASSES {
            let mut again = false;
            for &index in near {
                let bounces = self.action(index as usize) == Action::Bounce;
                again |= bounces && self.meet_one(index as usize, traveller, pass);
            }
            if !again {
                break;
            }
            touched = true;
        }
        touched
    }

    /// Kills or tints particle `i` if its path, bent by bounces, touches an obstacle that does so.
    fn sense(&self, particles: &mut Particles, i: usize, traveller: &Traveller, near: &[u32]) {
        for &index in near {
            let index = index as usize;
            let action = self.action(index);
            if action == Action::Bounce || !self.meet_one(index, &mut { *traveller }, Pass::First) {
                continue;
            }
            match action {
                Action::Tint(tint) => particles.set_tint(i, tint),
                // Ageing removes particles past their lifetime.
                _ => particles.age[i] = particles.lifetime[i],
            }
        }
    }

    fn action(&self, index: usize) -> Action {
        match self.analytic.get(index) {
            Some(obstacle) => obstacle.material.action,
            #[cfg(feature = "meshes")]
            None => self.rigids.obstacle(index - self.analytic.len()).material.action,
            #[cfg(not(feature = "meshes"))]
            None => unreachable!("only analytic colliders are found near"),
        }
    }

    fn meet_one(&self, index: usize, traveller: &mut Traveller, pass: Pass) -> bool {
        match self.analytic.get(index) {
            Some(obstacle) => obstacle.meet(traveller, pass),
            #[cfg(feature = "meshes")]
            None => self.rigids.obstacle(index - self.analytic.len()).meet(traveller, pass),
            #[cfg(not(feature = "meshes"))]
            None => unreachable!("only analytic colliders are found near"),
        }
    }
}
