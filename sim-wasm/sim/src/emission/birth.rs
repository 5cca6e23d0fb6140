//! One birth.

use super::ride::Ride;
use super::shapes::Nozzle;
use super::{EmissionContext, Emitter};
use crate::collide::space::Vector;
use crate::parameters::Parameters;
use crate::particles::{Newborn, Particles};
use crate::random::Random;

/// An emitter in one step, and where its births go.
pub struct EmitterSource<'s> {
    emitter: &'s Emitter,
    nozzle: Nozzle<'s>,
    /// What it rides on; none in the world.
    ride: Option<Ride>,
    around: &'s EmissionContext<'s>,
    random: &'s mut Random,
    particles: &'s mut Particles,
}

impl<'s> EmitterSource<'s> {
    pub fn new(
        emitter: &'s Emitter,
        around: &'s EmissionContext<'s>,
        random: &'s mut Random,
        particles: &'s mut Particles,
    ) -> Self {
        Self {
            emitter,
            nozzle: Nozzle::new(emitter, around.surfaces),
            ride: around.ride(&emitter.scope),
            around,
            random,
            particles,
        }
    }

    /// Length of the step (s).
    pub fn dt(&self) -> f64 {
        self.around.dt
    }

    /// How many more can live.
    pub fn room(&self) -> usize {
        self.particles.capacity() - self.particles.alive()
    }

    /// One birth `delay` seconds after the start of the step.
    pub fn spawn(&mut self, delay: f64) {
        let emitter = self.emitter;
        let Parameters { emission, puff, .. } = self.around.parameters;
        let point = self.nozzle.birth_point(self.random);
        let speed = vary(emitter.speed, emitter.speed_variation, self.random);
        let heading = self.nozzle.heading(&point, self.random);
        let (position, slip) = self.carried(point.place, heading, speed, delay);
        let lifetime = emission.lifetime * emitter.lifetime;
        let newborn = Newborn {
            position,
            slip,
            age: -delay as f32,
            lifetime: vary(lifetime, emitter.lifetime_variation, self.random).max(self.around.dt as f32),
            size: vary(emitter.size, emitter.size_variation, self.random),
            temperature: emitter.temperature as f32,
            attributes: attributes(puff.variations as u32, emitter.tint as u32, self.random),
        };
        self.particles.push(&newborn);
    }

    /// Place and slip in the world of what leaves at `place` towards `heading`, both in the space of what it rides on.
    fn carried(&self, place: [f32; 3], heading: [f32; 3], speed: f32, delay: f64) -> ([f32; 3], [f32; 3]) {
        let Some(ride) = &self.ride else {
            return (place, heading.map(|part| part * speed));
        };
        let fraction = (delay / self.around.dt) as f32;
        let (frame, velocity) = ride.at(fraction, self.around.dt as f32, place.into());
        let place = frame.world_from_local(place.into());
        let momentum = velocity * self.emitter.inherit as f32;
        let slip: Vector = frame.rotate(heading.into()) * speed + momentum;
        (place.into(), slip.into())
    }
}

fn vary(value: f64, variation: f64, random: &mut Random) -> f32 {
    value as f32 * (1.0 + variation as f32 * random.signed())
}

/// Variation, seed byte, roll and tint, packed as [`Particles`] documents.
fn attributes(variations: u32, tint: u32, random: &mut Random) -> u32 {
    let variation = random.below(variations);
    variation | (random.bits() >> 24) << 8 | (random.bits() >> 20) << 16 | tint << 28
}
