//! Growth, ageing, cooling and death.
//!
//! radius(age) = size * puff.size * growth(age) * density(age / lifetime), exactly 0 at birth and at death. growth(age)
//! is t (2 - t) for t = age / growthTime up to 1; growth is steepest at birth, so that smoke leaves a nozzle as a stem
//! and not as a string of specks. A growth time below [`MIN_GROWTH_TIME`] is taken for that, but not by the integrator
//! `paper`, where it may be 0 and growth is 1. density(t) is 1 - t, the linear loss of density of the paper, or the
//! curve of `density.#`.
//!
//! The radius never pops: within a step of h seconds it changes by at most size * puff.size * h * (2 / growthTime +
//! slope / lifetime), the first term only where growthTime is not 0; slope is 1 for the linear law and the steepest one
//! of a curve, which is at most 50. Entrainment adds puff.size * entrainment * |slip| * h.

pub mod hold;

use wide::f32x4;

use crate::forces::buoyancy;
use crate::layout::parameters::table::Parameters;
use crate::math::simd::{LANES, Vector4, blocks, blocks_mut};
use crate::particles::Particles;
use crate::particles::tile::{TILE_BLOCKS, tiles};

/// Distance from the origin (m) beyond which a particle dies: nothing is seen there, and single precision ends.
pub const WORLD_RADIUS: f32 = 10_000.0;

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

/// Ages and cools all particles; removes those that left the world and those whose time was over at the start of the
/// step: in the step in which it ends they are still drawn on the way to radius 0.
pub fn advance(particles: &mut Particles, ageing: &Ageing) {
    for (first, len) in tiles(particles, 0).rev() {
        advance_tile(particles, ageing, first, len);
    }
}

/// The same for a tile, `len` blocks from block `first` on; the tiles behind it must have been done.
///
/// From the last block to the first: what fills a gap then comes from behind and has been aged already.
pub fn advance_tile(particles: &mut Particles, ageing: &Ageing, first: usize, len: usize) {
    let dead = age(particles, ageing, first, len);
    if dead == 0 {
        return;
    }
    for block in (0..len).rev() {
        let lanes = dead >> (block * LANES) & 0b1111;
        if lanes != 0 {
            bury(particles, (first + block) * LANES, lanes as u32);
        }
    }
}

/// Ages and cools. One bit for each lane of the tile that must go, the first lane's lowest.
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
    dead
}

/// All bits set in each lane that neither has died nor left the world. A place that is not a number is outside of it.
#[inline(always)]
fn stays(place: Vector4, age: f32x4, lifetime: f32x4) -> f32x4 {
    place.dot(place).simd_le(f32x4::splat(WORLD_RADIUS * WORLD_RADIUS)) & age.simd_lt(lifetime)
}

fn bury(particles: &mut Particles, first: usize, dead: u32) {
    for lane in (0..LANES).rev() {
        let i = first + lane;
        if dead >> lane & 1 == 1 && i < particles.alive() {
            particles.swap_remove(i);
        }
    }
}
