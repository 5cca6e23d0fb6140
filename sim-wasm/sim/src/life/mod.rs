//! Ageing, cooling and death.

pub mod company;
pub mod hold;

use wide::f32x4;

use crate::forces::buoyancy;
use crate::layout::parameters::table::Parameters;
use crate::math::simd::{LANES, Vector4, blocks, blocks_mut};
use crate::particles::Particles;
use crate::particles::tile::{TILE_BLOCKS, tiles};

/// Distance from the origin (m) beyond which a particle dies: it is not visible there, and single precision is
/// exhausted.
pub const WORLD_RADIUS: f32 = 10_000.0;

/// Ageing and cooling of a step.
#[derive(Clone, Copy, Debug)]
pub struct Ageing {
    dt: f32x4,
    cooling: f32x4,
}

impl Ageing {
    /// Ageing by `dt` seconds, and the cooling that `parameters` set.
    pub fn new(parameters: &Parameters, dt: f64) -> Self {
        Self {
            dt: f32x4::splat(dt as f32),
            cooling: f32x4::splat(buoyancy::cooling(parameters, dt)),
        }
    }
}

/// Ages and cools all particles. Removes those that left the world, and those whose life was over at the start of the
/// step: in the step in which it ends they still shrink to radius 0.
pub fn advance(particles: &mut Particles, ageing: &Ageing) {
    for (first, len) in tiles(particles, 0).rev() {
        advance_tile(particles, ageing, first, len);
    }
}

/// Same for a tile of `len` blocks from block `first` on. The tiles behind it must be done already.
///
/// From the last block to the first: a particle that fills a gap comes from behind and was aged already.
pub fn advance_tile(particles: &mut Particles, ageing: &Ageing, first: usize, len: usize) {
    let dead = age(particles, ageing, first, len);
    if dead == 0 {
        return;
    }
    for block in (0..len).rev() {
        let lanes = dead >> (block * LANES) & 0b1111;
        if lanes != 0 {
            remove_dead(particles, (first + block) * LANES, lanes as u32);
        }
    }
}

/// Ages and cools. Returns one bit per lane of particles to remove, the first lane lowest.
#[inline(always)]
fn age(particles: &mut Particles, ageing: &Ageing, first: usize, len: usize) -> u128 {
    const { assert!(TILE_BLOCKS * LANES <= 128, "a tile has a bit for each lane") };
    let Particles {
        x,
        y,
        z,
        age,
        lifetime,
        temperature,
        company,
        ..
    } = particles;
    let column = |column| &blocks(column, first + len)[first..];
    let places = column(x).iter().zip(column(y)).zip(column(z));
    let lifetimes = column(lifetime);
    let ages = &mut blocks_mut(age, first + len)[first..];
    let temperatures = &mut blocks_mut(temperature, first + len)[first..];
    let lives = ages.iter_mut().zip(temperatures).zip(lifetimes);
    let mut dead = 0;
    for (block, (((age, temperature), lifetime), ((x, y), z))) in lives.zip(places).enumerate() {
        let place = Vector4 {
            x: f32x4::new(*x),
            y: f32x4::new(*y),
            z: f32x4::new(*z),
        };
        let old = f32x4::new(*age);
        let leaving = !stays(place, old, f32x4::new(*lifetime)).to_bitmask() & 0b1111;
        dead |= u128::from(leaving) << (block * LANES);
        *age = (old + ageing.dt).to_array();
        *temperature = (f32x4::new(*temperature) * ageing.cooling).to_array();
    }
    if let Some(company) = company {
        let extra_ageing = &blocks(&company.extra_ageing, first + len)[first..];
        for (age, extra_ageing) in blocks_mut(age, first + len)[first..].iter_mut().zip(extra_ageing) {
            *age = (f32x4::new(*age) + f32x4::new(*extra_ageing)).to_array();
        }
    }
    dead
}

/// All bits set in lanes that stay. A position of NaN is outside of the world.
#[inline(always)]
fn stays(place: Vector4, age: f32x4, lifetime: f32x4) -> f32x4 {
    place.dot(place).simd_le(f32x4::splat(WORLD_RADIUS * WORLD_RADIUS)) & age.simd_lt(lifetime)
}

fn remove_dead(particles: &mut Particles, first: usize, dead: u32) {
    for lane in (0..LANES).rev() {
        let i = first + lane;
        if dead >> lane & 1 == 1 && i < particles.alive() {
            particles.swap_remove(i);
        }
    }
}
