//! A step of the vortex particles.

use crate::forces::force::ForceContext;
use crate::forces::particle_motion::ParticleMotion;
use crate::forces::vortex_particles::VortexParticles;
use crate::particles::tile::{Columns, TILE_BLOCKS, Tile};

impl VortexParticles {
    /// Advances by one step. `motion` belongs to `context`.
    pub fn step(&mut self, motion: &ParticleMotion, context: &ForceContext) {
        self.drift(motion, context.now.dt as f32);
        self.swarm.age(context.now.dt as f32);
        self.shedding.step(motion, context, &mut self.swarm);
        self.field.sort(&self.swarm);
    }

    fn drift(&mut self, motion: &ParticleMotion, dt: f32) {
        let mut tile = Tile::new(dt, false);
        let blocks = self.swarm.blocks();
        for first in (0..blocks).step_by(TILE_BLOCKS) {
            let len = TILE_BLOCKS.min(blocks - first);
            let (place, ahead) = self.swarm.places(first, len);
            tile.load_places(place, ahead);
            motion.blow(&mut tile, Some(self));
            let Columns { flow, .. } = tile.columns();
            self.swarm.follow(first, flow, dt);
        }
    }
}
