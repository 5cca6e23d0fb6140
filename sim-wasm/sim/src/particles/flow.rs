//! How particles turn and stretch with the air. Only pictures read these columns: they are saved, but no step of the
//! simulation reads them and they are not part of the hash. They exist while a parameter needs them.
//!
//! Turn: a unit quaternion that follows the angular velocity of the air at the particle, half the vorticity. The
//! vorticity is measured over the particle's extent from the air velocity at the corners of a tetrahedron, which is exact
//! for a linear field, in a quarter of the tiles per step. Stretch: along the velocity, smoothed over
//! [`SMOOTHING_TIME`].

use wide::f32x4;

use crate::arrange::row_layout::{MAX_STRETCH, NO_TURN, TURN_STEPS};
use crate::layout::limits::STEP;
use crate::layout::parameters::table::Parameters;
use crate::math::scalar::greater;
use crate::math::simd::{LANES, Vector4, blocks, blocks_mut, larger};
use crate::particles::Particles;
use crate::particles::tile::{Columns, TILE_BLOCKS, Tile};

/// Time constant (s) of the velocity that stretches a puff.
pub const SMOOTHING_TIME: f32 = 0.15;
/// A puff that travels its radius in this time (s) has half of its greatest stretch.
pub const STRETCH_TIME: f32 = 0.1;
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

/// Number of columns of the current state, and of the state of held particles.
const COLUMNS: usize = 10;
const HELD_COLUMNS: usize = 7;
/// First columns of the angular velocity and of the smoothed velocity.
const SPIN: usize = 4;
const VELOCITY: usize = 7;

/// The columns, each of the length of those in [`Particles`]: turn as a unit quaternion x, y, z, w; angular velocity of the
/// air (rad/s); smoothed velocity (m/s). While held, turn and smoothed velocity at the last held moment follow.
#[derive(Clone, Debug)]
pub struct Flow {
    pub columns: Vec<Vec<f32>>,
}

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
    /// The law that `parameters` set; none if particles neither turn nor stretch.
    pub fn new(parameters: &Parameters) -> Option<Self> {
        let law = Self {
            turn: parameters.puff.turn as f32,
            stretch: parameters.puff.stretch as f32,
            puff_size: parameters.puff.size as f32,
        };
        (law.turn > 0.0 || law.stretch > 1.0).then_some(law)
    }

    // Called from several loops; inlining would repeat it in each.
    /// Packed turn and stretch of particle `i`, `back` seconds before the current state.
    #[inline(never)]
    pub fn packed(&self, particles: &Particles, i: usize, back: f32) -> [u32; 2] {
        let Some(flow) = &particles.flow else {
            return [0; 2];
        };
        let (turn, velocity) = match &particles.held {
            Some(_) => (flow.values(COLUMNS, i), flow.values(COLUMNS + 4, i)),
            None => flow.at(particles, i, back, self.turn),
        };
        let size = particles.held.as_ref().map_or(&particles.size, |held| &held.size);
        [packed_turn(turn), self.packed_stretch(velocity, size[i])]
    }

    /// Direction in an octahedral map with 8 bits for each coordinate, then the ratio of the axes.
    fn packed_stretch(&self, velocity: [f32; 3], size: f32) -> u32 {
        let speed = length(velocity);
        let pace = speed * STRETCH_TIME / greater(size * self.puff_size, 1e-6);
        let ratio = (self.stretch - 1.0) * pace / (1.0 + pace) / (MAX_STRETCH - 1.0);
        let ratio = (ratio * 255.0 + 0.5) as u32;
        if ratio == 0 {
            return 0;
        }
        let [x, y, z] = velocity.map(|component| component / greater(speed, 1e-20));
        let sum = x.abs() + y.abs() + z.abs();
        let (x, y) = (x / sum, y / sum);
        let sign = |value: f32| if value < 0.0 { -1.0 } else { 1.0 };
        let [u, v] = if z < 0.0 {
            [(1.0 - y.abs()) * sign(x), (1.0 - x.abs()) * sign(y)]
        } else {
            [x, y]
        };
        let byte = |value: f32| (value * 127.0 + 127.5) as u32;
        byte(u) | byte(v) << 8 | ratio << 16
    }
}

/// The largest component is left out and positive; its index is in the upper two bits.
fn packed_turn(turn: [f32; 4]) -> u32 {
    let mut largest = 3;
    for at in 0..3 {
        if turn[at].abs() > turn[largest].abs() {
            largest = at;
        }
    }
    let sign = if turn[largest] < 0.0 { -1.0 } else { 1.0 };
    let mut word = (largest as u32) << 30;
    for place in 0..3 {
        let component = turn[(largest + 1 + place) % 4] * sign;
        let steps = (component * TURN_STEPS + 512.5) as u32;
        word |= steps.min(1023) << (10 * place);
    }
    word ^ NO_TURN
}

fn length([x, y, z]: [f32; 3]) -> f32 {
    (x * x + y * y + z * z).sqrt()
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

impl Flow {
    /// Columns for particles that do not turn, in columns of length `padded`.
    pub fn new(padded: usize) -> Self {
        let mut columns = vec![vec![0.0; padded]; COLUMNS];
        columns[3].fill(1.0);
        Self { columns }
    }

    /// Starts or stops holding.
    pub fn hold(&mut self, holds: bool) {
        if !holds {
            self.columns.truncate(COLUMNS);
        } else if self.columns.len() == COLUMNS {
            let held = (0..HELD_COLUMNS)
                .map(|at| self.columns[shown(at)].clone())
                .collect::<Vec<_>>();
            self.columns.extend(held);
        }
    }

    /// Sets particle `i` to its state at birth.
    pub fn reset(&mut self, i: usize) {
        for (at, column) in self.columns.iter_mut().enumerate() {
            column[i] = if at == 3 || at == COLUMNS + 3 { 1.0 } else { 0.0 };
        }
    }

    /// Holds the current state of particle `i`.
    pub fn hold_now(&mut self, i: usize) {
        for at in 0..HELD_COLUMNS {
            self.columns[COLUMNS + at][i] = self.columns[shown(at)][i];
        }
    }

    /// Values of particle `i` in the columns from `first` on.
    fn values<const N: usize>(&self, first: usize, i: usize) -> [f32; N] {
        std::array::from_fn(|at| self.columns[first + at][i])
    }

    fn set<const N: usize>(&mut self, first: usize, i: usize, values: [f32; N]) {
        for (column, value) in self.columns[first..].iter_mut().zip(values) {
            column[i] = value;
        }
    }

    /// Turn and smoothed velocity of particle `i`, `back` seconds before the current state.
    fn at(&self, particles: &Particles, i: usize, back: f32, share: f32) -> ([f32; 4], [f32; 3]) {
        let spin: [f32; 3] = self.values(SPIN, i);
        let turn = turned(self.values(0, i), spin.map(|rate| -rate * share * back));
        // The inverse of the smoothing over a part of a step.
        let share = back / STEP as f32 * (SMOOTHING / (1.0 - SMOOTHING));
        let current = velocity(particles, i);
        let mut before: [f32; 3] = self.values(VELOCITY, i);
        (0..3).for_each(|axis| before[axis] -= (current[axis] - before[axis]) * share);
        (turn, before)
    }
}

/// Velocity (m/s) of particle `i` over the last step.
fn velocity(particles: &Particles, i: usize) -> [f32; 3] {
    [
        (particles.x[i] - particles.px[i]) / STEP as f32,
        (particles.y[i] - particles.py[i]) / STEP as f32,
        (particles.z[i] - particles.pz[i]) / STEP as f32,
    ]
}

/// The current column of held column `at`.
fn shown(at: usize) -> usize {
    if at < 4 { at } else { at + 3 }
}

/// Share of the way to the current velocity in a step: 1 - exp(-h / [`SMOOTHING_TIME`]), rounded.
const SMOOTHING: f32 = 0.105;

/// Turns the particles of a tile over a step and smooths their velocities, after they moved. `air` adds the air velocity
/// to a tile of places; `steps` counts the steps before.
#[inline(never)]
pub fn follow(
    law: &FlowLaw,
    particles: &mut Particles,
    (first, len): (usize, usize),
    steps: u64,
    air: impl Fn(&mut Tile),
) {
    let Some(mut flow) = particles.flow.take() else {
        return;
    };
    if law.turn > 0.0 && (first / TILE_BLOCKS) as u64 % PERIOD == steps % PERIOD {
        measure(law, particles, &mut flow, (first, len), air);
    }
    let angle = law.turn * STEP as f32;
    for i in first * LANES..(first + len) * LANES {
        let spin: [f32; 3] = flow.values(SPIN, i);
        let turn = turned(flow.values(0, i), spin.map(|rate| rate * angle));
        flow.set(0, i, turn);
        let current = velocity(particles, i);
        let mut smooth: [f32; 3] = flow.values(VELOCITY, i);
        (0..3).for_each(|axis| smooth[axis] += (current[axis] - smooth[axis]) * SMOOTHING);
        flow.set(VELOCITY, i, smooth);
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
    let mut tile = Tile::new(STEP as f32, true);
    for corner in &CORNERS {
        load_corner(&mut tile, places, &extents, *corner);
        air(&mut tile);
        let Columns { flow, .. } = tile.columns();
        let corner = Vector4::splat(*corner);
        for (sum, flow) in sums.iter_mut().zip(flow) {
            *sum += corner.cross(*flow);
        }
    }
    for block in 0..len {
        let spin = sums[block] * (f32x4::splat(0.375) / extents[block]);
        for (column, component) in flow.columns[SPIN..].iter_mut().zip([spin.x, spin.y, spin.z]) {
            blocks_mut(column, count)[first + block] = component.to_array();
        }
    }
}
