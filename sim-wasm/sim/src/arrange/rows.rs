//! Rows for a renderer: 24 bytes per drawn particle.
//!
//! `place`, four f32: x, y, z in world space (m), radius (m), blended between the steps.
//! `attributes`, two u32:
//! - word 0, bits 0-15: roll, as a fraction of a turn times 65,536, with a slow spin by age.
//! - word 0, bits 16-31: age / lifetime times 65,535. In rows for the light: the earliest end of the shadow in 256ths
//!   of a radius behind the centre, 65,535 for none.
//! - word 1: variation (bits 0-7), seed byte (8-15), temperature (16-23, 255 means 4), tint (24-31, 0 means none).

use crate::particles::Particles;
use crate::particles::held::Held;
use crate::particles::radius::RadiusLaw;

/// Maximum spin (revolutions per second). The seed byte selects a spin between minus this and this.
pub const MAX_SPIN: f32 = 0.04;

const MAX_TEMPERATURE: f32 = 4.0;

/// Samples rows from particles at a time between two steps.
#[derive(Clone, Copy, Debug)]
pub struct RowSampler {
    pub radii: RadiusLaw,
    /// Elapsed share of the step, 0..1.
    pub blend: f32,
    /// Length of the step (s).
    pub dt: f32,
}

impl RowSampler {
    /// Age (s) of particle `i`; negative before birth.
    pub fn age(&self, particles: &Particles, i: usize) -> f32 {
        let age = particles.held.as_ref().map_or(&particles.age, |held| &held.age);
        age[i] - (1.0 - self.blend) * self.dt
    }

    /// Place and radius of particle `i`. The radius is 0 before birth.
    pub fn place(&self, particles: &Particles, i: usize) -> [f32; 4] {
        if let Some(held) = &particles.held {
            return self.held_place(held, particles.lifetime[i], i);
        }
        let mix = |before: f32, now: f32| before * (1.0 - self.blend) + now * self.blend;
        let age = self.age(particles, i);
        let radius = self.radii.radius(particles.size[i], age, particles.lifetime[i]);
        [
            mix(particles.px[i], particles.x[i]),
            mix(particles.py[i], particles.y[i]),
            mix(particles.pz[i], particles.z[i]),
            if age < 0.0 { 0.0 } else { radius },
        ]
    }

    fn held_place(&self, held: &Held, lifetime: f32, i: usize) -> [f32; 4] {
        let radius = self.radii.radius(held.size[i], held.age[i], lifetime);
        let is_born = held.age[i] >= 0.0;
        [held.x[i], held.y[i], held.z[i], if is_born { radius } else { 0.0 }]
    }

    /// The part of the packed attributes that determines the orientation of particle `i`: roll, variation and seed.
    pub fn orientation(&self, particles: &Particles, i: usize) -> [u32; 2] {
        let attributes = particles.attributes[i];
        [roll(attributes, self.age(particles, i)), attributes & 0xffff]
    }

    /// The packed attributes of particle `i`.
    pub fn attributes(&self, particles: &Particles, i: usize) -> [u32; 2] {
        let attributes = particles.attributes[i];
        let age = self.age(particles, i);
        let roll = roll(attributes, age);
        let worn = fraction(age / particles.lifetime[i], 65_535.0);
        let heat = fraction(particles.temperature[i] / MAX_TEMPERATURE, 255.0);
        [
            roll | worn << 16,
            attributes & 0xffff | heat << 16 | attributes >> 28 << 24,
        ]
    }
}

fn roll(attributes: u32, age: f32) -> u32 {
    (attributes >> 12 & 0xfff0).wrapping_add(spin(attributes, age)) & 0xffff
}

/// Roll by `age` seconds of spin, in 65,536ths of a revolution.
fn spin(attributes: u32, age: f32) -> u32 {
    let pace = ((attributes >> 8 & 0xff) as f32 - 127.5) / 127.5 * MAX_SPIN;
    (age * pace * 65_536.0) as i32 as u32
}

fn fraction(value: f32, scale: f32) -> u32 {
    (value.clamp(0.0, 1.0) * scale + 0.5) as u32
}
