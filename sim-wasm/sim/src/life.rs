//! Growth, ageing, cooling and death.
//!
//! radius(age) = size * puff.size * growth(age) * density(age / lifetime), exactly 0 at birth and at death. growth(age)
//! is t (2 - t) for t = age / growthTime up to 1; growth is steepest at birth, so that smoke leaves a nozzle as a stem
//! and not as a string of specks. A growth time below [`SHORTEST_GROWTH`] is taken for that, but not by the integrator
//! `paper`, where it may be 0 and growth is 1. density(t) is 1 - t, the linear loss of density of the paper, or the
//! curve of `density.#`.
//!
//! The radius never pops: within a step of h seconds it changes by at most size * puff.size * h * (2 / growthTime +
//! slope / lifetime), the first term only where growthTime is not 0; slope is 1 for the linear law and the steepest one
//! of a curve, which is at most 50. Entrainment adds puff.size * entrainment * |slip| * h.

pub mod density;
pub mod entrainment;
pub mod radius;

use wide::f32x4;

use crate::forces::buoyancy;
use crate::parameters::Parameters;
use crate::particles::{LANES, Particles};
use crate::simd::{Vector4, blocks, blocks_mut};
pub use radius::{RadiusLaw, SHORTEST_GROWTH};

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
///
/// From the last block to the first: what fills a gap then comes from behind and has been aged already.
pub fn advance(particles: &mut Particles, ageing: &Ageing) {
    for block in (0..particles.padded_alive() / LANES).rev() {
        let dead = dead_lanes(particles, block);
        age_block(particles, ageing, block);
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

/// One bit for each lane that must go, before it ages. A place that is not a number counts as outside of the world.
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

    fn law(stops: &[[f64; 2]], growth_time: f64, integrator: f64) -> RadiusLaw {
        let mut parameters = Parameters::default();
        let mut set = |key: &str, value| parameters.set(key, value).expect("a test's values are in range");
        for (index, [age, value]) in stops.iter().enumerate() {
            set(&format!("density.{index}.age"), *age);
            set(&format!("density.{index}.value"), *value);
        }
        set("puff.size", 1.3);
        set("emission.growthTime", growth_time);
        set("simulation.integrator", integrator);
        RadiusLaw::new(&parameters)
    }

    #[test]
    fn lanes_and_single_particles_have_the_same_radius() {
        let curves: [&[[f64; 2]]; 4] = [
            &[],
            &[[0.3, 0.6]],
            &[[0.7, 0.1], [0.1, 0.33], [0.4, 1.0]],
            &[
                [0.0, 0.0],
                [0.0, 1.0],
                [0.2, 0.3],
                [0.2, 0.7],
                [0.5, 0.0],
                [0.6, 0.1],
                [0.9, 1.0],
                [1.0, 1.0],
            ],
        ];
        for (stops, (growth_time, integrator)) in curves
            .iter()
            .flat_map(|curve| [(0.0, 1.0), (0.7, 0.0)].map(|rest| (curve, rest)))
        {
            let law = law(stops, growth_time, integrator);
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
