//! Births.
//!
//! An emitter owes rate * share / (sum of shares) particles a second. What it owes is kept as a fraction, so that
//! counts are exact over any time. Each birth has its own moment within the step, from which on it moves (see
//! `motion::Motion::launch`). Therefore neither a fast jet nor wind shows beads. When the simulator is full, births wait and are made up as soon as there
//! is room; emitters take turns in being first, so that none starves.
//!
//! Directions are uniform over the cone about the emitter's direction, places uniform over the point, disc (normal
//! to the direction) or ball.

use crate::forces::unit;
use crate::parameters::field::{DIRECTION, Field, PLACE, SHARE, number, vector};
use crate::parameters::section::Item;
use crate::parameters::{LIST_LIMIT, Parameters};
use crate::particles::{Newborn, Particles};
use crate::random::Random;
use crate::scope::Scope;

/// `emitters.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Emitter {
    pub shape: f64,
    pub position: [f64; 3],
    pub direction: [f64; 3],
    pub radius: f64,
    pub speed: f64,
    pub speed_variation: f64,
    pub spread: f64,
    pub size: f64,
    pub size_variation: f64,
    pub lifetime_variation: f64,
    pub temperature: f64,
    pub share: f64,
    pub scope: Scope,
}

impl Item for Emitter {
    const LABEL: &'static str = "Emitter";
    const FIELDS: &'static [Field<Self>] = &[
        number("shape", "1", [0.0, 2.0], 0.0, |e: &mut Self| &mut e.shape)
            .named(&["point", "disc", "ball"])
            .says("Shape", "Where its puffs are born."),
        vector("position", "m", PLACE, [0.0; 3], |e: &mut Self| &mut e.position).says("Place", "Centre of its shape."),
        vector("direction", "1", DIRECTION, [0.0, 1.0, 0.0], |e: &mut Self| {
            &mut e.direction
        })
        .says("Direction", "Where it blows its puffs."),
        number("radius", "m", [0.0, 100.0], 0.1, |e: &mut Self| &mut e.radius).says("Radius", "Radius of its shape."),
        number("speed", "m/s", [0.0, 50.0], 0.5, |e: &mut Self| &mut e.speed)
            .says("Speed", "How fast its puffs leave, relative to the air."),
        number("speedVariation", "1", SHARE, 0.2, |e: &mut Self| &mut e.speed_variation)
            .says("Speed range", "How much faster or slower some leave, as a share."),
        number("spread", "rad", [0.0, std::f64::consts::PI], 0.3, |e: &mut Self| {
            &mut e.spread
        })
        .says("Spread", "Half angle of the cone into which they leave."),
        number("size", "m", [0.001, 20.0], 0.3, |e: &mut Self| &mut e.size)
            .says("Size", "Radius of its puffs at full density."),
        number("sizeVariation", "1", SHARE, 0.2, |e: &mut Self| &mut e.size_variation)
            .says("Size range", "How much larger or smaller some are, as a share."),
        number("lifetimeVariation", "1", SHARE, 0.2, |e: &mut Self| {
            &mut e.lifetime_variation
        })
        .says("Lifetime range", "How much longer or shorter some live, as a share."),
        number("temperature", "1", [0.0, 4.0], 1.0, |e: &mut Self| &mut e.temperature)
            .says("Temperature", "How warm its puffs are; warm smoke rises."),
        number("share", "1", [0.0, 1000.0], 1.0, |e: &mut Self| &mut e.share)
            .says("Share", "Its part of all births, relative to the other emitters."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}

/// What emitters remember from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Births {
    /// Of each emitter: the part of a particle that it owes, 0..1.
    pub owed: [f64; LIST_LIMIT],
    /// Of each emitter: how many births wait for room.
    pub waiting: [u64; LIST_LIMIT],
}

/// What a step's births depend on besides the emitter.
pub struct Surroundings<'s> {
    pub parameters: &'s Parameters,
    /// Number of the step: it decides which emitter comes first.
    pub step: u64,
    /// Length of the step (s).
    pub dt: f64,
}

impl Births {
    /// How many births wait for room.
    pub fn waiting(&self) -> u64 {
        self.waiting.iter().sum()
    }

    /// The births of one step.
    pub fn step(&mut self, around: &Surroundings, random: &mut Random, particles: &mut Particles) {
        let emitters = around.parameters.emitters.items();
        let shares: f64 = emitters.iter().map(|emitter| emitter.share).sum();
        let count = emitters.len().max(1);
        for turn in 0..emitters.len() {
            let index = (around.step as usize).wrapping_add(turn) % count;
            let rate = around.parameters.emission.rate * emitters[index].share / shares.max(f64::MIN_POSITIVE);
            let mut source = Source {
                emitter: Aim::new(&emitters[index]),
                around,
                random,
                particles,
            };
            self.make_up(index, &mut source);
            self.emit(index, rate, &mut source);
        }
    }

    /// Births that waited, spread evenly over the step.
    fn make_up(&mut self, index: usize, source: &mut Source) {
        let count = self.waiting[index].min(source.room() as u64);
        for number in 0..count {
            source.bear(source.around.dt * (number as f64 + 0.5) / count as f64);
        }
        self.waiting[index] -= count;
    }

    /// Births that fall due in this step, each at its moment.
    fn emit(&mut self, index: usize, rate: f64, source: &mut Source) {
        // Sums of decimal fractions miss whole numbers by a few units in the last place.
        const SLACK: f64 = 1e-9;
        let before = self.owed[index];
        let owed = before + rate * source.around.dt;
        let due = libm::floor(owed + SLACK);
        for number in 1..=due as u64 {
            if source.room() == 0 {
                self.waiting[index] += due as u64 + 1 - number;
                break;
            }
            source.bear(((number as f64 - before) / rate).clamp(0.0, source.around.dt));
        }
        self.owed[index] = owed - due;
    }
}

/// An emitter and where its births go.
struct Source<'s, 'a> {
    emitter: Aim<'a>,
    around: &'s Surroundings<'s>,
    random: &'s mut Random,
    particles: &'s mut Particles,
}

/// An emitter with a frame about its direction.
struct Aim<'a> {
    emitter: &'a Emitter,
    direction: [f32; 3],
    side: [f32; 3],
    other_side: [f32; 3],
}

impl<'a> Aim<'a> {
    fn new(emitter: &'a Emitter) -> Self {
        let direction = unit(emitter.direction);
        let [side, other_side] = normals(direction);
        Self {
            emitter,
            direction,
            side,
            other_side,
        }
    }

    /// The vector with these parts along the frame.
    fn vector(&self, side: f32, other_side: f32, forward: f32) -> [f32; 3] {
        std::array::from_fn(|i| side * self.side[i] + other_side * self.other_side[i] + forward * self.direction[i])
    }
}

impl Source<'_, '_> {
    fn room(&self) -> usize {
        self.particles.capacity() - self.particles.alive()
    }

    /// One birth `delay` seconds after the start of the step.
    fn bear(&mut self, delay: f64) {
        let emitter = self.emitter.emitter;
        let Parameters { emission, puff, .. } = self.around.parameters;
        let place = self.place();
        let speed = vary(emitter.speed, emitter.speed_variation, self.random);
        let slip = self.direction().map(|component| component * speed);
        let lifetime = vary(emission.lifetime, emitter.lifetime_variation, self.random).max(self.around.dt as f32);
        let newborn = Newborn {
            position: place,
            slip,
            age: -delay as f32,
            lifetime,
            size: vary(emitter.size, emitter.size_variation, self.random),
            temperature: emitter.temperature as f32,
            look: look(puff.variations as u32, self.random),
        };
        self.particles.push(&newborn);
    }

    /// A place of birth.
    fn place(&mut self) -> [f32; 3] {
        let centre = self.emitter.emitter.position.map(|component| component as f32);
        let radius = self.emitter.emitter.radius as f32;
        let offset = match self.emitter.emitter.shape as u32 {
            1 => self.on_disc(),
            2 => in_ball(self.random),
            _ => [0.0; 3],
        };
        sum(centre, offset.map(|component| component * radius))
    }

    /// A place on the disc of radius 1 across the direction.
    fn on_disc(&mut self) -> [f32; 3] {
        let distance = libm::sqrtf(self.random.unit());
        let (sine, cosine) = libm::sincosf(self.random.unit() * std::f32::consts::TAU);
        self.emitter.vector(distance * cosine, distance * sine, 0.0)
    }

    /// A direction in the cone.
    fn direction(&mut self) -> [f32; 3] {
        let cap = 1.0 - libm::cos(self.emitter.emitter.spread) as f32;
        let forward = 1.0 - self.random.unit() * cap;
        let across = libm::sqrtf((1.0 - forward * forward).max(0.0));
        let (sine, cosine) = libm::sincosf(self.random.unit() * std::f32::consts::TAU);
        self.emitter.vector(across * cosine, across * sine, forward)
    }
}

/// A place in the ball of radius 1, by rejection: no cube root, and uniform.
fn in_ball(random: &mut Random) -> [f32; 3] {
    loop {
        let place = [random.signed(), random.signed(), random.signed()];
        if place.iter().map(|component| component * component).sum::<f32>() <= 1.0 {
            return place;
        }
    }
}

fn vary(value: f64, variation: f64, random: &mut Random) -> f32 {
    value as f32 * (1.0 + variation as f32 * random.signed())
}

/// Variation, seed byte and roll, packed as [`Particles`] documents.
fn look(variations: u32, random: &mut Random) -> u32 {
    let variation = random.below(variations);
    variation | (random.bits() >> 24) << 8 | (random.bits() >> 16) << 16
}

fn sum(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|i| a[i] + b[i])
}

/// Two unit vectors normal to the unit vector `n` and to each other. Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6 (1), 2017: no case distinction but the sign.
fn normals([x, y, z]: [f32; 3]) -> [[f32; 3]; 2] {
    let sign = 1.0_f32.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
}
