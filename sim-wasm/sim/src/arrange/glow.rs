//! Lamps at the glowing parts of smoke, which light other objects.
//!
//! Each particle shares its light among three lamps by the inverse fourth power of the distance, and lamps move to the mean
//! of their shares: [`PASSES`] passes of k-means with soft borders, from the mean of all light and small steps in directions
//! that lie in no plane of symmetry of a scene; the lowest is the first, since fire rises. Lamps are a continuous function of
//! the particles, which fade in at birth and out at death, so they change little from step to step. With hard borders, or
//! starts at single particles, they would jump. They depend on no lamps of the step before, which a saved state does not have.
//!
//! Only + - * /, in the order of particles: equal in every engine.

use std::hint::black_box;

use wide::f32x4;

use crate::arrange::rows::RowSampler;
use crate::math::scalar::lesser;
use crate::particles::Particles;

/// Number of lamps.
pub const LAMPS: usize = 3;
/// Floats of a lamp: mean place and mean radius (m), then the sums of red, green and blue light and luminance (m2).
pub const LAMP_FLOATS: usize = 8;
/// Intervals of temperature from 0 to 1.
pub const HEATS: usize = 64;
/// Numbers of the colours of smoke, or of a look.
const COLOR_FLOATS: usize = 4 * (HEATS + 1);

const PASSES: usize = 13;
/// Steps from the mean to where lamps start (m). Their sum is 0.
const STARTS: [[f32; 4]; LAMPS] = [
    [0.55, -0.6, 0.2, 0.0],
    [-0.35, 0.05, -0.55, 0.0],
    [-0.2, 0.55, 0.35, 0.0],
];
/// Least squared distance (m2). Smaller, lamps would follow single puffs.
const NEAREST: f32 = 1e-2;

/// Place and radius, then light and luminance, of a particle; or sums of them, the first weighted by luminance.
type Light = [f32x4; 2];

/// A lamp during a pass: its place, its light in the last pass, sums of this one, and its nearness to a particle. Without
/// gaps, zeros take least space.
type Lamp = [f32x4; 5];

/// The lamps of the particles as they are drawn. `colors`: linear red, green and blue light and its luminance for each of
/// [`HEATS`] + 1 temperatures from 0 to 1, of a puff of radius 1 m. The same of each look from 1 on may follow; puffs of
/// other looks have the first colours. [`LAMP_FLOATS`] numbers of each lamp; the light is 0 where nothing glows.
pub fn lamps(particles: &Particles, sampler: &RowSampler, colors: &[f32]) -> Vec<f32> {
    let mut lights: Vec<Light> = Vec::new();
    // Sums of coordinates far from the origin would lose precision.
    let origin = f32x4::new(sampler.place(particles, 0));
    for (i, heat) in particles.temperature.iter().enumerate().take(particles.alive()) {
        let place = f32x4::new(sampler.place(particles, i));
        let radius = last(place);
        let own = colors.chunks_exact(COLOR_FLOATS).nth(particles.look(i) as usize);
        let light = color_at(*heat, own.unwrap_or(colors)) * f32x4::splat(radius * radius);
        // Particles with a tint have its colour instead of that of heat.
        if last(light) > 0.0 && particles.tint(i) == 0 {
            lights.push([place - origin, light]);
        }
    }
    let mut lamps = [Lamp::default(); LAMPS];
    // Of an unknown number, they are visited by loops, which take less space than code for each.
    let lamps = black_box(&mut lamps[..]);
    if !lights.is_empty() {
        gather(&lights, lamps);
    }
    let mut numbers = Vec::new();
    for [place, light, ..] in lamps {
        numbers.extend_from_slice(&(*place + origin).to_array());
        numbers.extend_from_slice(&light.to_array());
    }
    numbers
}

/// Moves lamps from one place to where light is.
fn gather(lights: &[Light], lamps: &mut [Lamp]) {
    // The first pass moves all to the mean.
    let mut starts = black_box(&STARTS[..]);
    for _ in 0..PASSES {
        for [place, light] in lights {
            let mut all = f32x4::ZERO;
            for lamp in lamps.iter_mut() {
                let way = *place - lamp[0];
                let [x, y, z, _] = (way * way).to_array();
                let square = f32x4::splat(x + y + z + NEAREST);
                lamp[4] = f32x4::ONE / (square * square);
                all += lamp[4];
            }
            for lamp in lamps.iter_mut() {
                let share = *light * (lamp[4] / all);
                lamp[2] += *place * f32x4::splat(last(share));
                lamp[3] += share;
            }
        }
        for lamp in lamps.iter_mut() {
            lamp[1] = lamp[3];
            lamp[0] = lamp[2] / f32x4::splat(last(lamp[1]));
            [lamp[2], lamp[3]] = Light::default();
            if let [start, rest @ ..] = starts {
                lamp[0] += f32x4::new(*start);
                starts = rest;
            }
        }
    }
}

/// Light at a temperature, of a radius of 1 m.
fn color_at(heat: f32, colors: &[f32]) -> f32x4 {
    let heat = lesser(heat, 1.0) * HEATS as f32;
    let low = heat as usize;
    let [first, second] = [low, low + 1].map(|at| {
        // Beyond the last one, which counts in full there.
        let color = colors.get(4 * at..4 * at + 4).unwrap_or(&[0.0; 4]);
        f32x4::new([color[0], color[1], color[2], color[3]])
    });
    first + (second - first) * f32x4::splat(heat - low as f32)
}

/// The radius or the luminance.
fn last(vector: f32x4) -> f32 {
    vector.to_array()[3]
}
