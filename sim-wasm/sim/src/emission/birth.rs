//! Births from one emitter.

use crate::emission::shapes::Nozzle;
use crate::emission::surface::Surfaces;
use crate::emission::swelling;
use crate::layout::limits::TOP_SPEED;
use crate::layout::parameters::emitter::Emitter;
use crate::layout::parameters::item::Scope;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::parts::Parts;
use crate::math::pose::{Frame, Pose};
#[cfg(feature = "meshes")]
use crate::math::pose_motion::PoseMotion;
use crate::math::random::Random;
use crate::math::vector::Vector;
use crate::particles::{Newborn, Particles};

/// The inputs of a step's births besides the emitter.
pub struct EmissionContext<'s> {
    pub parameters: &'s Parameters,
    pub surfaces: &'s Surfaces,
    pub parts: &'s Parts,
    /// Motion of the rigid with this number in the step; none if there is no such rigid.
    #[cfg(feature = "meshes")]
    pub rigid: &'s dyn Fn(f64) -> Option<PoseMotion>,
    /// Seed of the simulation: selects the swelling of emitters.
    pub seed: u32,
    /// Index of the step: selects the first emitter.
    pub step: u64,
    /// Simulated time at the middle of the step (s).
    pub time: f64,
    /// Length of the step (s).
    pub dt: f64,
}

impl EmissionContext<'_> {
    /// The path of an emitter in the step: its length (m), and, in world space, the vector from its start to its end.
    ///
    /// # Arguments
    /// * `before` - The place of an emitter in world space at the end of the last step, which is updated.
    #[inline(never)]
    pub(super) fn path(&self, emitter: &Emitter, before: &mut Option<[f32; 3]>) -> (f64, Vector) {
        let place = emitter.position.map(|part| part as f32);
        let (length, way) = match self.ride(&emitter.scope) {
            None => {
                let way = Vector::from(place) - Vector::from(before.replace(place).unwrap_or(place));
                (f64::from(way.length()), way)
            }
            Some(ride) => {
                *before = None;
                let speed = |fraction| f64::from(ride.at(fraction, self.dt as f32, place.into()).1.length());
                // The rule of Simpson: a point far from the axis of a turn travels on an arc.
                let mean = (speed(0.0) + 4.0 * speed(0.5) + speed(1.0)) / 6.0;
                (mean * self.dt, Vector::ZERO)
            }
        };
        if length > f64::from(TOP_SPEED) * self.dt {
            (0.0, Vector::ZERO)
        } else {
            (length, way)
        }
    }

    /// What an emitter with this scope is attached to; none in world space.
    fn ride(&self, scope: &Scope) -> Option<Ride> {
        let part = self.parts.ends(scope.rigid).map(Ride::Part);
        #[cfg(feature = "meshes")]
        let part = part.or_else(|| (self.rigid)(scope.rigid).map(Ride::Rigid));
        part
    }
}

/// The carrier of an emitter.
#[derive(Clone, Copy, Debug)]
pub enum Ride {
    /// A rigid. It may rotate by more than pi in a step.
    #[cfg(feature = "meshes")]
    Rigid(PoseMotion),
    /// A part: its poses at the start and at the end of the step.
    Part([Pose; 2]),
}

impl Ride {
    /// Coordinate frame at a fraction of a step of `dt` seconds, and the velocity (m/s) there of the point `local`.
    pub fn at(&self, fraction: f32, dt: f32, local: Vector) -> (Frame, Vector) {
        match self {
            #[cfg(feature = "meshes")]
            Ride::Rigid(motion) => {
                let frame = motion.frame(fraction);
                let place = frame.world_from_local(local);
                (frame, motion.velocity_at(place, fraction))
            }
            Ride::Part([start, end]) => {
                let frame = Frame::new(&start.towards(end, fraction));
                // The derivative of `towards`.
                let (half, cosine) = start.half_rotation_to(end);
                let square = 1.0 - 2.0 * fraction * (1.0 - fraction) * (1.0 - cosine);
                let spin = half * (2.0 / (square * dt));
                let velocity = (end.position - start.position) * (1.0 / dt);
                (frame, velocity + spin.cross(frame.rotate(local)))
            }
        }
    }
}

/// An emitter in one step, and the destination of its births.
pub struct EmitterSource<'s> {
    emitter: &'s Emitter,
    number: usize,
    nozzle: Nozzle<'s>,
    /// The carrier; none in world space.
    ride: Option<Ride>,
    around: &'s EmissionContext<'s>,
    /// What an emitter in world space travels in the step (m).
    way: Vector,
    /// Index of its look; none before the first birth.
    look: Option<u32>,
    random: &'s mut Random,
    particles: &'s mut Particles,
}

impl<'s> EmitterSource<'s> {
    pub fn new(
        (number, emitter): (usize, &'s Emitter),
        way: Vector,
        around: &'s EmissionContext<'s>,
        random: &'s mut Random,
        particles: &'s mut Particles,
    ) -> Self {
        Self {
            emitter,
            number,
            nozzle: Nozzle::new(emitter, around.surfaces),
            ride: around.ride(&emitter.scope),
            around,
            way,
            look: None,
            random,
            particles,
        }
    }

    /// Length of the step (s).
    pub fn dt(&self) -> f64 {
        self.around.dt
    }

    /// Number of particles that can still be added.
    pub fn room(&self) -> usize {
        self.particles.capacity() - self.particles.alive()
    }

    /// Adds one particle, born `delay` seconds after the start of the step. Returns the time from there to its end (s).
    pub fn spawn(&mut self, delay: f64) -> f64 {
        let emitter = self.emitter;
        let look = match self.look {
            Some(look) => look,
            None => self
                .particles
                .look_for(&(emitter.look, emitter.tint), self.around.parameters),
        };
        self.look = Some(look);
        let Parameters { emission, puff, .. } = self.around.parameters;
        let point = self.nozzle.birth_point(self.random);
        let speed = vary(emitter.speed, emitter.speed_variation, self.random);
        let heading = self.nozzle.heading(&point, self.random);
        let (position, slip) = self.carried(point.place, heading, speed, delay);
        let lifetime = if emitter.look.lifetime > 0.0 {
            emitter.look.lifetime
        } else {
            emission.lifetime * emitter.lifetime
        };
        let mut newborn = Newborn {
            position,
            slip,
            age: -delay as f32,
            lifetime: vary(lifetime, emitter.lifetime_variation, self.random).max(self.around.dt as f32),
            size: vary(emitter.size, emitter.size_variation, self.random),
            temperature: emitter.temperature as f32,
            attributes: attributes(puff.variations as u32, look, self.random),
        };
        if emission.size_spread > 0.0 {
            let time = self.around.step as f64 * self.around.dt + delay;
            let level = swelling::level(self.around.seed, self.number, time);
            let factor = swelling::factor(emission.size_spread as f32, level, self.random.unit());
            newborn.size *= factor;
            newborn.lifetime = swelling::lifetime(newborn.lifetime, factor);
        }
        self.particles.push(&newborn);
        if look == 0 && emitter.tint > 0.0 {
            self.particles.set_tint(self.particles.alive() - 1, emitter.tint as u8);
        }
        delay + f64::from(newborn.lifetime)
    }

    /// World-space position and slip of a birth at `place` towards `heading`, both given in the space of the carrier.
    fn carried(&self, place: [f32; 3], heading: [f32; 3], speed: f32, delay: f64) -> ([f32; 3], [f32; 3]) {
        let fraction = (delay / self.around.dt) as f32;
        let Some(ride) = &self.ride else {
            let slip = heading.map(|part| part * speed);
            if self.way == Vector::ZERO {
                return (place, slip);
            }
            let place = Vector::from(place) + self.way * (fraction - 1.0);
            return (place.into(), slip);
        };
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

/// Variation, seed byte, roll and look, packed as documented in [`Particles`].
fn attributes(variations: u32, look: u32, random: &mut Random) -> u32 {
    let variation = random.below(variations);
    variation | (random.bits() >> 24) << 8 | (random.bits() >> 20) << 16 | look << 28
}
