//! How particles turn and stretch with the air. Only pictures read these columns: they are saved, but no step of the
//! simulation reads them and they are not part of the hash. They exist while a parameter needs them.
//!
//! Turn: a unit quaternion that follows the angular velocity of the air at the particle, half the vorticity. The
//! vorticity is measured over the particle's extent from the air velocity at the corners of a tetrahedron, which is exact
//! for a linear field, in a quarter of the tiles per step. Stretch: along the velocity relative to the winds, which carry
//! all smoke alike, smoothed over [`SMOOTHING_TIME`].

use wide::f32x4;

use crate::layout::limits::STEP;
use crate::layout::parameters::table::Parameters;
use crate::math::scalar::{greater, lesser};
use crate::math::simd::{LANES, Vector4, blocks, larger};
use crate::particles::Particles;
use crate::particles::flow::{Flow, Motion};
use crate::particles::radius::RadiusLaw;
use crate::particles::tile::{Columns, TILE_BLOCKS, Tile};

/// Time constant (s) of the velocity that stretches a puff.
pub const SMOOTHING_TIME: f32 = 0.15;
/// A puff that travels its radius in this time (s) has half of its greatest stretch.
pub const STRETCH_TIME: f32 = 0.4;
/// A puff has the whole stretch of its end from this pace on, in radii per [`STRETCH_TIME`]. One that rests stays round, because
/// its motion has no direction.
const STRAND_PACE: f32 = 0.25;
/// Steps between two measurements of the vorticity.
const PERIOD: u64 = 4;
/// Distance of the corners at which the vorticity is measured, in sizes of the particle.
const EXTENT: f32 = 0.5;
const MIN_EXTENT: f32 = 1e-3;
/// Components of the unit vectors to the corners of a tetrahedron.
const CORNER: f32 = 0.577_350_26;
const CORNERS: [[f32; 3]; 4] = [
    [CORNER, CORNER, CORNER],
    [CORNER, -CORNER, -CORNER],
    [-CORNER, CORNER, -CORNER],
    [-CORNER, -CORNER, CORNER],
];

/// The parameters of turning and stretching.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowLaw {
    /// Share of the air's rotation.
    pub turn: f32,
    /// Greatest ratio of the axes, at least 1.
    pub stretch: f32,
    /// Factor on sizes.
    puff_size: f32,
}

impl FlowLaw {
    /// The law that `parameters` set.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            turn: parameters.puff.turn as f32,
            stretch: parameters.puff.stretch as f32,
            puff_size: parameters.puff.size as f32,
        }
    }

    /// Whether any particles turn or stretch.
    pub fn is_needed(&self, particles: &Particles, radii: &RadiusLaw) -> bool {
        let thin = particles.looks.as_ref().is_some_and(|looks| looks.thin());
        self.turn > 0.0 || self.stretch > 1.0 || radii.strand > 1.0 || thin
    }

    /// Turn as a unit quaternion x, y, z, w and relative velocity (m/s) with which particle `i` is shown, `back` seconds before the
    /// current state.
    pub fn shown(&self, flow: &Flow, particles: &Particles, i: usize, back: f32) -> ([f32; 4], [f32; 3]) {
        if particles.held.is_some() {
            return flow.held(i);
        }
        let motion = flow.get(i);
        let turn = turned(motion.turn, motion.spin.map(|rate| -rate * self.turn * back));
        let share = back / STEP as f32;
        let velocity = std::array::from_fn(|axis| motion.velocity[axis] - motion.change[axis] * share);
        (turn, velocity)
    }

    /// Ratio of the axes of particle `i` at a speed (m/s), by its [`RadiusLaw::dissolution`] and [`RadiusLaw::strand`].
    pub fn ratio(&self, particles: &Particles, i: usize, speed: f32, dissolution: f32, strand: f32) -> f32 {
        let size = particles.held.as_ref().map_or(&particles.size, |held| &held.size)[i];
        let pace = speed * STRETCH_TIME / greater(size * self.puff_size, 1e-6);
        let ratio = 1.0 + (self.stretch - 1.0) * pace / (1.0 + pace);
        let ending = dissolution.clamp(0.0, 1.0);
        // Squared, so that only small puffs are long.
        let share = ending * ending * lesser(pace / STRAND_PACE, 1.0);
        ratio + greater(strand - ratio, 0.0) * share
    }
}

/// The product a b of two quaternions x, y, z, w: first b, then a.
fn product(a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
    [
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
        a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
        a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
    ]
}

/// `turn`, then a rotation by the vector `by` (rad). The tangent of half the angle is a series up to the third order.
#[inline(never)]
fn turned(turn: [f32; 4], by: [f32; 3]) -> [f32; 4] {
    let square = by[0] * by[0] + by[1] * by[1] + by[2] * by[2];
    let half = 0.5 * (1.0 + square / 12.0);
    let step = [by[0] * half, by[1] * half, by[2] * half, 1.0];
    let next = product(step, turn);
    let inverse = 1.0 / next.iter().map(|component| component * component).sum::<f32>().sqrt();
    next.map(|component| component * inverse)
}

/// Velocity (m/s) of particle `i` over the last step.
fn velocity(particles: &Particles, i: usize) -> [f32; 3] {
    [
        (particles.x[i] - particles.px[i]) / STEP as f32,
        (particles.y[i] - particles.py[i]) / STEP as f32,
        (particles.z[i] - particles.pz[i]) / STEP as f32,
    ]
}

/// Share of the way to the current velocity in a step: 1 - exp(-h / [`SMOOTHING_TIME`]), rounded.
const SMOOTHING: f32 = 0.105;

/// Turns the particles of a tile over a step and smooths their velocities, after they moved. `air` adds the air velocity
/// to a tile of places, `winds` that of the winds alone; `steps` counts the steps before.
#[inline(never)]
pub fn follow(
    law: &FlowLaw,
    particles: &mut Particles,
    (first, len): (usize, usize),
    steps: u64,
    air: impl Fn(&mut Tile),
    winds: impl Fn(&mut Tile),
) {
    let Some(mut flow) = particles.flow.take() else {
        return;
    };
    let mut tile = Tile::new(STEP as f32, true);
    if law.turn > 0.0 && (first / TILE_BLOCKS) as u64 % PERIOD == steps % PERIOD {
        measure(law, particles, &mut flow, (first, len), &mut tile, air);
    }
    tile.load(particles, first, len);
    winds(&mut tile);
    let angle = law.turn * STEP as f32;
    for (block, winds) in tile.columns().flow.iter().enumerate() {
        let winds = [winds.x.to_array(), winds.y.to_array(), winds.z.to_array()];
        for lane in 0..LANES {
            let i = (first + block) * LANES + lane;
            let wind = winds.map(|component| component[lane]);
            let mut motion = flow.get(i);
            motion.turn = turned(motion.turn, motion.spin.map(|rate| rate * angle));
            let current = velocity(particles, i);
            for axis in 0..3 {
                let change = (current[axis] - wind[axis] - motion.velocity[axis]) * SMOOTHING;
                motion.change[axis] = change;
                motion.velocity[axis] += change;
            }
            flow.set(i, &motion);
        }
    }
    particles.flow = Some(flow);
}

/// Loads the places of particles, moved by their extents along a vector.
#[inline(never)]
fn load_corner(tile: &mut Tile, places: [&[[f32; LANES]]; 3], extents: &[f32x4; TILE_BLOCKS], corner: [f32; 3]) {
    let mut moved = [[[0.0; LANES]; TILE_BLOCKS]; 3];
    for (axis, moved) in moved.iter_mut().enumerate() {
        for ((moved, place), extent) in moved.iter_mut().zip(places[axis]).zip(extents) {
            *moved = (f32x4::new(*place) + *extent * f32x4::splat(corner[axis])).to_array();
        }
    }
    let len = places[0].len();
    let moved = [&moved[0][..len], &moved[1][..len], &moved[2][..len]];
    tile.load_places(moved, moved);
}

/// Angular velocity of the air: 3 / (8 d) times the sum of t x v(p + d t) over the corners t of a tetrahedron.
fn measure(
    law: &FlowLaw,
    particles: &Particles,
    flow: &mut Flow,
    (first, len): (usize, usize),
    tile: &mut Tile,
    air: impl Fn(&mut Tile),
) {
    let count = first + len;
    let column = |column| &blocks(column, count)[first..];
    let places = [column(&particles.x), column(&particles.y), column(&particles.z)];
    let mut extents = [f32x4::ZERO; TILE_BLOCKS];
    for (extent, size) in extents.iter_mut().zip(column(&particles.size)) {
        *extent = larger(
            f32x4::new(*size) * f32x4::splat(EXTENT * law.puff_size),
            f32x4::splat(MIN_EXTENT),
        );
    }
    let mut sums = [Vector4::zero(); TILE_BLOCKS];
    for corner in &CORNERS {
        load_corner(tile, places, &extents, *corner);
        air(tile);
        let Columns { flow, .. } = tile.columns();
        let corner = Vector4::splat(*corner);
        for (sum, flow) in sums.iter_mut().zip(flow) {
            *sum += corner.cross(*flow);
        }
    }
    for block in 0..len {
        let spin = sums[block] * (f32x4::splat(0.375) / extents[block]);
        let spin = [spin.x.to_array(), spin.y.to_array(), spin.z.to_array()];
        for lane in 0..LANES {
            let i = (first + block) * LANES + lane;
            let motion = Motion {
                spin: spin.map(|component| component[lane]),
                ..flow.get(i)
            };
            flow.set(i, &motion);
        }
    }
}
