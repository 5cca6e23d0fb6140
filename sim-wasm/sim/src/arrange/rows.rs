//! Rows for a renderer. `row_layout` documents their numbers.

use crate::arrange::deformation;
use crate::arrange::row_layout::{
    AGE, Attributes, Bits, CASTER_AGE, END, EROSION, LOOK, MAX_TEMPERATURE, PLACE_FLOATS, ROLL, SEED, TEMPERATURE,
    TINT, VARIATION,
};
use crate::particles::Particles;
use crate::particles::following::FlowLaw;
use crate::particles::held::Held;
use crate::particles::radius::RadiusLaw;

/// Maximum spin (revolutions per second). The seed byte selects a spin between minus this and this.
pub const MAX_SPIN: f32 = 0.04;

/// Samples rows from particles at a time between two steps.
#[derive(Clone, Copy, Debug)]
pub struct RowSampler {
    pub radii: RadiusLaw,
    /// How particles turn and stretch; none if they do not.
    pub flow: Option<FlowLaw>,
    /// Share by which young puffs are folded, see `coverage::solids`.
    pub billow: f32,
    /// Elapsed share of the step, 0..1.
    pub blend: f32,
    /// Length of the step (s).
    pub dt: f32,
    /// Sides of each variation, at least 1.
    pub sides: u32,
    /// Share of the roll that is left out, 0..1.
    pub upright: f32,
}

impl RowSampler {
    /// Whether puffs differ from their baked shapes.
    pub fn is_deformed(&self) -> bool {
        self.flow.is_some() || self.billow > 0.0
    }

    /// Age (s) of particle `i`; negative before birth.
    pub fn age(&self, particles: &Particles, i: usize) -> f32 {
        let age = particles.held.as_ref().map_or(&particles.age, |held| &held.age);
        let extra_ageing = particles
            .company
            .as_ref()
            .map_or(0.0, |company| company.extra_ageing[i]);
        age[i] - (1.0 - self.blend) * (self.dt + extra_ageing)
    }

    /// Place and radius of particle `i`. The radius is 0 before birth.
    // Called in two loops, as the next one.
    #[inline(never)]
    pub fn place(&self, particles: &Particles, i: usize) -> [f32; PLACE_FLOATS] {
        if let Some(held) = &particles.held {
            return held_place(held, particles.radius_law(&self.radii, i), particles.lifetime[i], i);
        }
        let mix = |before: f32, now: f32| before * (1.0 - self.blend) + now * self.blend;
        let age = self.age(particles, i);
        let law = particles.radius_law(&self.radii, i);
        let radius = law.radius(particles.size[i], age, particles.lifetime[i]);
        [
            mix(particles.px[i], particles.x[i]),
            mix(particles.py[i], particles.y[i]),
            mix(particles.pz[i], particles.z[i]),
            if age < 0.0 { 0.0 } else { radius },
        ]
    }

    /// The part of the packed attributes that determines the shape of particle `i`: roll, age, variation, seed, turn,
    /// stretch and erosion.
    // Called in two loops; inlining would repeat it in each.
    #[inline(never)]
    pub fn shape(&self, particles: &Particles, i: usize) -> Attributes {
        let attributes = particles.attributes[i];
        let age = self.age(particles, i);
        let worn = AGE.packed(fraction(age / particles.lifetime[i], AGE));
        let law = particles.radius_law(&self.radii, i);
        let dissolution = law.dissolution(age, particles.lifetime[i]);
        let [turn, stretch] = self.flow(particles, i, dissolution, law.strand);
        let erosion = fraction(law.erosion(dissolution), EROSION);
        [
            ROLL.packed(self.roll(attributes, age)) | worn,
            constant(attributes, self.sides),
            turn,
            stretch | EROSION.packed(erosion),
        ]
    }

    /// Roll at birth and by `age` seconds of spin, in 65,536ths of a revolution. The highest bits mean nothing.
    fn roll(&self, attributes: u32, age: f32) -> u32 {
        // Between half a revolution to the left and to the right, so that a share of it is as far from upright.
        let at_birth = (attributes >> 12 & 0xfff0) as u16 as i16;
        let roll = i32::from(at_birth).wrapping_add(spin(attributes, age));
        if self.upright == 0.0 {
            return roll as u32;
        }
        (roll as f32 * (1.0 - self.upright)) as i32 as u32
    }

    fn flow(&self, particles: &Particles, i: usize, dissolution: f32, strand: f32) -> [u32; 2] {
        let back = (1.0 - self.blend) * self.dt;
        self.flow.map_or([0; 2], |law| {
            deformation::packed(&law, particles, i, back, dissolution, strand)
        })
    }

    /// The packed attributes of particle `i` for the eye, by its [`RowSampler::shape`].
    pub fn body(&self, particles: &Particles, i: usize, [shape, constant, turn, stretch]: Attributes) -> Attributes {
        let heat = TEMPERATURE.packed(fraction(particles.temperature[i] / MAX_TEMPERATURE, TEMPERATURE));
        let own = particles.attributes[i] >> 28;
        let tint = match &particles.looks {
            None => TINT.packed(own),
            Some(looks) => TINT.packed(u32::from(looks.tints[i])) | LOOK.packed(own),
        };
        [shape, constant | heat | tint, turn, stretch]
    }
}

fn held_place(held: &Held, law: &RadiusLaw, lifetime: f32, i: usize) -> [f32; PLACE_FLOATS] {
    let radius = law.radius(held.size[i], held.age[i], lifetime);
    let is_born = held.age[i] >= 0.0;
    [held.x[i], held.y[i], held.z[i], if is_born { radius } else { 0.0 }]
}

/// The packed attributes for the light, by the [`RowSampler::shape`] of a particle and the end of its shadow.
pub fn caster(shape: Attributes, end: u32) -> Attributes {
    let [roll, constant, turn, stretch] = shape;
    [
        ROLL.packed(roll) | END.packed(end),
        constant | CASTER_AGE.packed(AGE.of(shape)),
        turn,
        stretch,
    ]
}

/// Number of the side among those of all variations, and seed, which no step changes.
fn constant(attributes: u32, sides: u32) -> u32 {
    let seed = attributes >> 8;
    VARIATION.packed((attributes & 0xff) * sides + (seed & 0xff) % sides) | SEED.packed(seed)
}

/// Roll by `age` seconds of spin, in 65,536ths of a revolution.
fn spin(attributes: u32, age: f32) -> i32 {
    let pace = ((attributes >> 8 & 0xff) as f32 - 127.5) / 127.5 * MAX_SPIN;
    (age * pace * 65_536.0) as i32
}

fn fraction(value: f32, bits: Bits) -> u32 {
    (value.clamp(0.0, 1.0) * bits.max as f32 + 0.5) as u32
}
