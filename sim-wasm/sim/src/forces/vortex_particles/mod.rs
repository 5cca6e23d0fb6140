//! Vortex particles: small swirls that a rigid sheds, after Selle, Rasmussen and Fedkiw, "A Vortex Particle Method for
//! Smoke, Water and Explosions", SIGGRAPH 2005. They drift with the air and with each other, spread, die, and stir the
//! smoke near them. How one moves the air stands in `field`, how it spreads and dies in `swarm`, how they are shed in
//! `shedder`.
//!
//! Theirs is the velocity form: each adds a velocity to the air, as all that makes air here does. There is no grid of
//! the air whose lost vorticity they would give back by forces. Their axes keep their directions: stretching by the
//! gradient of the velocity is left out, since without a pressure that answers it, it grows without bound.
//!
//! A step ends with their own: all drift by the midpoint rule of `motion`, as smoke does, die or are shed, and are then
//! sorted for the middle of the coming step.

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

/// All vortex particles of a simulation. Its memory is taken when the first shedder is described.
pub struct VortexParticles {
    swarm: Swarm,
    shedding: Shedding,
    field: VortexField,
}

impl VortexParticles {
    /// None yet; `seed` starts their random numbers, which are no others'.
    pub fn new(seed: u32) -> Self {
        Self::of(Swarm::new(), Shedding::new(seed))
    }

    fn of(swarm: Swarm, shedding: Shedding) -> Self {
        let mut field = VortexField::new();
        field.sort(&swarm);
        Self { swarm, shedding, field }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.swarm.count()
    }

    /// Number `index` of them, in the order in which they were shed.
    pub fn get(&self, index: usize) -> Option<VortexParticle> {
        (index < self.count()).then(|| self.swarm.get(index))
    }

    /// Adds one that no shedder made. False, and nothing changed, when it is not sound.
    pub fn add(&mut self, particle: &VortexParticle) -> bool {
        if !particle.is_sound() {
            return false;
        }
        self.swarm.make_room(1);
        self.swarm.push(particle);
        self.field.sort(&self.swarm);
        true
    }

    /// Adds their velocity (m/s), times `strength`, to the air at the particles of `tile`.
    pub fn act(&self, strength: f32, tile: &mut Tile) {
        if !self.field.is_empty() {
            self.field.act(strength, tile);
        }
    }

    /// Adds them, and what shedders remember, to `hash`.
    pub fn hash_into(&self, hash: &mut Hash) {
        self.swarm.hash_into(hash);
        self.shedding.hash_into(hash);
    }
}
