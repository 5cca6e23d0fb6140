//! Growth, ageing, cooling and death.
//!
//! radius(age) = size * puff.size * growth(age) * (1 - age / lifetime), exactly 0 at death. growth(age) is t (2 - t)
//! for t = age / growthTime up to 1, and 1 where growthTime is 0: the linear loss of density of the paper. Growth is
//! steepest at birth, so that smoke leaves a nozzle as a stem and not as a string of specks. Within a step of h seconds
//! the radius therefore changes by at most size * puff.size * h * (1 / lifetime + 2 / growthTime), the last term only
//! where growthTime is not 0.

use wide::f32x4;

use crate::forces::buoyancy;
use crate::parameters::Parameters;
use crate::particles::{LANES, Particles};
use crate::simd::{Vector4, blocks, blocks_mut, positive_part, smaller};

/// Distance from the origin (m) beyond which a particle dies: nothing is seen there, and single precision ends.
pub const WORLD_RADIUS: f32 = 10_000.0;

/// Radius of a particle from its size and age; two numbers that hold for all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusLaw {
    /// Factor on every radius, `puff.size`.
    pub puff_size: f32,
    /// Seconds until a newborn particle has its full size, `emission.growthTime`; 0: from the start.
    pub growth_time: f32,
}

impl RadiusLaw {
    /// The law that `parameters` set.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            puff_size: parameters.puff.size as f32,
            growth_time: parameters.emission.growth_time as f32,
        }
    }

    /// Radius (m) of a particle of `size` (m) at `age` of `lifetime` (s). 0 from the moment of death on; an age
    /// below 0 counts as 0.
    pub fn radius(&self, size: f32, age: f32, lifetime: f32) -> f32 {
        let age = age.max(0.0);
        let density = (1.0 - age / lifetime).max(0.0);
        size * self.puff_size * self.growth(age) * density
    }

    /// The same for four particles, to the last bit.
    #[inline(always)]
    pub fn radii(&self, size: f32x4, age: f32x4, lifetime: f32x4) -> f32x4 {
        let age = positive_part(age);
        let density = positive_part(f32x4::ONE - age / lifetime);
        let full = size * f32x4::splat(self.puff_size);
        if self.growth_time <= 0.0 {
            return full * density;
        }
        let t = smaller(age / f32x4::splat(self.growth_time), f32x4::ONE);
        full * (t * (f32x4::splat(2.0) - t)) * density
    }

    fn growth(&self, age: f32) -> f32 {
        if self.growth_time <= 0.0 {
            return 1.0;
        }
        let t = (age / self.growth_time).min(1.0);
        t * (2.0 - t)
    }
}

/// What a step's passing does to every particle.
#[derive(Clone, Copy, Debug)]
pub struct Ageing {
    dt: f32x4,
    cooling: f32x4,
}

impl Ageing {
    /// Ageing by `dt` seconds and the cooling that `parameters` set.
    pub fn new(parameters: &Parameters, dt: f64) -> Self {
        Self {
            dt: f32x4::splat(dt as f32),
            cooling: f32x4::splat(buoyancy::cooling(parameters, dt)),
        }
    }
}

/// Ages and cools all particles; removes those whose time is over and those that left the world.
///
/// From the last block to the first: what fills a gap then comes from behind and has been aged already.
pub fn advance(particles: &mut Particles, ageing: &Ageing) {
    for block in (0..particles.padded_alive() / LANES).rev() {
        age_block(particles, ageing, block);
        let dead = dead_lanes(particles, block);
        if dead != 0 {
            bury(particles, block * LANES, dead);
        }
    }
}

#[inline(always)]
fn age_block(particles: &mut Particles, ageing: &Ageing, block: usize) {
    let age = &mut blocks_mut(&mut particles.age, block + 1)[block];
    *age = (f32x4::new(*age) + ageing.dt).to_array();
    let temperature = &mut blocks_mut(&mut particles.temperature, block + 1)[block];
    *temperature = (f32x4::new(*temperature) * ageing.cooling).to_array();
}

/// One bit for each lane that must go. A place that is not a number counts as outside of the world.
#[inline(always)]
fn dead_lanes(particles: &Particles, block: usize) -> u32 {
    let column = |column| blocks(column, block + 1);
    let place = Vector4::load(column(&particles.x), column(&particles.y), column(&particles.z), block);
    let inside = place.dot(place).simd_le(f32x4::splat(WORLD_RADIUS * WORLD_RADIUS));
    let age = f32x4::new(column(&particles.age)[block]);
    let young = age.simd_lt(f32x4::new(column(&particles.lifetime)[block]));
    !(inside & young).to_bitmask() & 0b1111
}

fn bury(particles: &mut Particles, first: usize, dead: u32) {
    for lane in (0..LANES).rev() {
        let i = first + lane;
        if dead >> lane & 1 == 1 && i < particles.alive() {
            particles.swap_remove(i);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_and_single_particles_have_the_same_radius() {
        for growth_time in [0.0, 0.7] {
            let law = RadiusLaw {
                puff_size: 1.3,
                growth_time,
            };
            for step in -5..300 {
                let age = step as f32 / 60.0;
                let lanes = law.radii(f32x4::splat(0.4), f32x4::splat(age), f32x4::splat(3.1));
                assert_eq!(
                    lanes.to_array()[3].to_bits(),
                    law.radius(0.4, age, 3.1).to_bits(),
                    "at {age}"
                );
            }
            assert_eq!(law.radius(0.4, 3.1, 3.1), 0.0);
        }
    }
}
