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

/// The columns, each of the length of those in [`Particles`].
#[derive(Clone, Debug)]
pub struct Flow {
    /// Turn as a unit quaternion x, y, z, w; angular velocity of the air (rad/s); smoothed velocity (m/s).
    pub now: [Vec<f32>; COLUMNS],
    /// Turn and smoothed velocity at the last held moment. Empty while drawing on ones.
    pub held: [Vec<f32>; HELD_COLUMNS],
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

    /// Packed turn and stretch of particle `i`, `back` seconds before the current state.
    pub fn packed(&self, particles: &Particles, i: usize, back: f32) -> [u32; 2] {
        let Some(flow) = &particles.flow else {
            return [0; 2];
        };
        let (turn, velocity) = match &particles.held {
            Some(_) => (
                std::array::from_fn(|at| flow.held[at][i]),
                std::array::from_fn(|at| flow.held[4 + at][i]),
            ),
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
        let mut now = std::array::from_fn(|_| vec![0.0; padded]);
        now[3] = vec![1.0; padded];
        Self {
            now,
            held: std::array::from_fn(|_| Vec::new()),
        }
    }

    /// All columns that are allocated.
    pub fn columns(&self) -> impl Iterator<Item = &Vec<f32>> {
        self.now.iter().chain(&self.held).filter(|column| !column.is_empty())
    }

    /// All columns that are allocated, mutable.
    pub fn columns_mut(&mut self) -> impl Iterator<Item = &mut Vec<f32>> {
        self.now
            .iter_mut()
            .chain(&mut self.held)
            .filter(|column| !column.is_empty())
    }

    /// Starts or stops holding.
    pub fn hold(&mut self, holds: bool) {
        if !holds {
            self.held = std::array::from_fn(|_| Vec::new());
        } else if self.held[0].is_empty() {
            self.held = std::array::from_fn(|at| self.now[shown(at)].clone());
        }
    }

    /// Sets particle `i` to its state at birth.
    pub fn reset(&mut self, i: usize) {
        for column in self.columns_mut() {
            column[i] = 0.0;
        }
        self.now[3][i] = 1.0;
        if let Some(w) = self.held[3].get_mut(i) {
            *w = 1.0;
        }
    }

    /// Holds the current state of particle `i`.
    pub fn hold_now(&mut self, i: usize) {
        for at in 0..HELD_COLUMNS {
            self.held[at][i] = self.now[shown(at)][i];
        }
    }

    /// Turn and smoothed velocity of particle `i`, `back` seconds before the current state.
    fn at(&self, particles: &Particles, i: usize, back: f32, share: f32) -> ([f32; 4], [f32; 3]) {
        let spin = std::array::from_fn(|at| -self.now[4 + at][i] * share * back);
        let turn = turned(std::array::from_fn(|at| self.now[at][i]), spin);
        let ways = [
            particles.x[i] - particles.px[i],
            particles.y[i] - particles.py[i],
            particles.z[i] - particles.pz[i],
        ];
        // The inverse of the smoothing over a part of a step.
        let share = back / STEP as f32 * SMOOTHING;
        let before = |at: usize| {
            let now = self.now[7 + at][i];
            now - (ways[at] / STEP as f32 - now) * (share / (1.0 - SMOOTHING))
        };
        (turn, std::array::from_fn(before))
    }
}

/// The current column of held column `at`.
fn shown(at: usize) -> usize {
    if at < 4 { at } else { at + 3 }
}

/// Share of the way to the current velocity in a step: 1 - exp(-h / [`SMOOTHING_TIME`]), rounded.
const SMOOTHING: f32 = 0.105;

/// Turns the particles of a tile over a step and smooths their velocities, after they moved. `air` adds the air velocity
/// to a tile of places; `steps` counts the steps before.
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
    if law.turn > 0.0 {
        if (first / TILE_BLOCKS) as u64 % PERIOD == steps % PERIOD {
            measure(law, particles, &mut flow, (first, len), air);
        }
        turn(law, &mut flow, (first, len));
    }
    let smoothing = f32x4::splat(SMOOTHING);
    let per_step = f32x4::splat((1.0 / STEP) as f32);
    let columns = [
        (&particles.x, &particles.px),
        (&particles.y, &particles.py),
        (&particles.z, &particles.pz),
    ];
    for (at, (now, before)) in columns.into_iter().enumerate() {
        let count = first + len;
        let velocity = &mut blocks_mut(&mut flow.now[7 + at], count)[first..];
        let (now, before) = (&blocks(now, count)[first..], &blocks(before, count)[first..]);
        for ((velocity, now), before) in velocity.iter_mut().zip(now).zip(before) {
            let smooth = f32x4::new(*velocity);
            let current = (f32x4::new(*now) - f32x4::new(*before)) * per_step;
            *velocity = (smooth + (current - smooth) * smoothing).to_array();
        }
    }
    particles.flow = Some(flow);
}

fn turn(law: &FlowLaw, flow: &mut Flow, (first, len): (usize, usize)) {
    let angle = law.turn * STEP as f32;
    for i in first * LANES..(first + len) * LANES {
        let by = [4, 5, 6].map(|at: usize| flow.now[at][i] * angle);
        let next = turned(std::array::from_fn(|at| flow.now[at][i]), by);
        for (at, component) in next.into_iter().enumerate() {
            flow.now[at][i] = component;
        }
    }
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
    for corner in CORNERS {
        let mut moved = [[[0.0; LANES]; TILE_BLOCKS]; 3];
        for axis in 0..3 {
            for block in 0..len {
                let place = f32x4::new(places[axis][block]) + extents[block] * f32x4::splat(corner[axis]);
                moved[axis][block] = place.to_array();
            }
        }
        let [x, y, z] = &moved;
        let moved = [&x[..len], &y[..len], &z[..len]];
        tile.load_places(moved, moved);
        air(&mut tile);
        let Columns { flow, .. } = tile.columns();
        let corner = Vector4::splat(corner);
        for (sum, flow) in sums.iter_mut().zip(flow) {
            *sum += corner.cross(*flow);
        }
    }
    for block in 0..len {
        let spin = sums[block] * (f32x4::splat(0.375) / extents[block]);
        for (at, component) in [spin.x, spin.y, spin.z].into_iter().enumerate() {
            blocks_mut(&mut flow.now[4 + at], count)[first + block] = component.to_array();
        }
    }
}
