//! Vortex particles: small vortices that shedders emit, after Selle, Rasmussen and Fedkiw, "A Vortex Particle Method
//! for Smoke, Water and Explosions", SIGGRAPH 2005. They drift with the air and with each other, spread, die, and move
//! the smoke near them. `field` computes their velocity, `swarm` their spread and death, `shedder` their emission.
//!
//! This is the velocity form: each vortex particle adds a velocity to the air. There is no grid whose lost vorticity
//! would be restored by forces. Axes keep their directions: without a pressure, stretching by the velocity gradient
//! would grow without bound.
//!
//! At the end of a step vortex particles drift by the midpoint rule of `particle_motion`, die, are shed, and are sorted
//! for the middle of the coming step.

pub(crate) mod field;
pub(crate) mod save;
pub mod shedder;
pub(crate) mod shedding;
pub(crate) mod step;
pub(crate) mod swarm;

use crate::forces::vortex_particles::field::VortexField;
use crate::forces::vortex_particles::shedding::Shedding;
use crate::forces::vortex_particles::swarm::Swarm;
use crate::math::hash::Hash;
use crate::particles::tile::Tile;

pub use swarm::{MAX_VORTEX_PARTICLES, VortexParticle};

/// All vortex particles of a simulation. Allocated when the first shedder is set.
pub struct VortexParticles {
    swarm: Swarm,
    shedding: Shedding,
    field: VortexField,
}

impl VortexParticles {
    /// Creates an empty set; `seed` starts its own stream of random numbers.
    pub fn new(seed: u32) -> Self {
        Self::of(Swarm::new(), Shedding::new(seed))
    }

    fn of(swarm: Swarm, shedding: Shedding) -> Self {
        let mut field = VortexField::new();
        field.sort(&swarm);
        Self { swarm, shedding, field }
    }

    /// Number of vortex particles.
    pub fn count(&self) -> usize {
        self.swarm.count()
    }

    /// Vortex particle `index`, in the order of shedding.
    pub fn get(&self, index: usize) -> Option<VortexParticle> {
        (index < self.count()).then(|| self.swarm.get(index))
    }

    /// Adds a vortex particle. Returns false and changes nothing if it is invalid.
    pub fn add(&mut self, particle: &VortexParticle) -> bool {
        if !particle.is_sound() {
            return false;
        }
        self.swarm.make_room(1);
        self.swarm.push(particle);
        self.field.sort(&self.swarm);
        true
    }

    /// Adds the velocity (m/s), times `strength`, to the flow of `tile`.
    pub fn act(&self, strength: f32, tile: &mut Tile) {
        if !self.field.is_empty() {
            self.field.act(strength, tile);
        }
    }

    /// Adds the vortex particles and the state of the shedders to `hash`.
    pub fn hash_into(&self, hash: &mut Hash) {
        self.swarm.hash_into(hash);
        self.shedding.hash_into(hash);
    }
}
