//! Tiles: blocks of particles that stay in the first-level cache while all forces act on them.

use wide::f32x4;

use crate::layout::scope::Reach;
use crate::math::simd::{LANES, Vector4, blocks};
use crate::particles::Particles;

/// Blocks of four particles in a full tile.
pub const TILE_BLOCKS: usize = 32;

/// The values of a tile that forces read and write. Only the first `len` blocks are valid.
pub struct Tile {
    len: usize,
    /// Length of the step (s).
    pub dt: f32,
    /// Evaluate the air velocity at the current places instead of its mean over the step.
    pub is_instant: bool,
    /// True after a force wrote to `push`, which is zero otherwise.
    pub is_pushed: bool,
    /// True after a force wrote to `resistance`, which is zero otherwise.
    pub is_dragged: bool,
    /// True if particles have looks that move otherwise. Then `looks` holds their indices, `gravity` their factors on
    /// gravity, and `heat` their temperatures with their factors on buoyancy.
    pub(crate) has_looks: bool,
    pub(crate) looks: [[u8; LANES]; TILE_BLOCKS],
    pub(crate) gravity: [f32x4; TILE_BLOCKS],
    place: [Vector4; TILE_BLOCKS],
    ahead: [Vector4; TILE_BLOCKS],
    flow: [Vector4; TILE_BLOCKS],
    slip: [Vector4; TILE_BLOCKS],
    slipped: [Vector4; TILE_BLOCKS],
    push: [Vector4; TILE_BLOCKS],
    resistance: [f32x4; TILE_BLOCKS],
    pub(crate) heat: [f32x4; TILE_BLOCKS],
    weight: [f32x4; TILE_BLOCKS],
}

/// The columns of a tile, each of its length.
pub struct Columns<'t> {
    /// Position at the start of the step (m).
    pub place: &'t mut [Vector4],
    /// Expected position in the middle of the step (m).
    pub ahead: &'t mut [Vector4],
    /// Air velocity (m/s).
    pub flow: &'t mut [Vector4],
    /// Slip (m/s).
    pub slip: &'t mut [Vector4],
    /// Displacement by the slip in the step (m).
    pub slipped: &'t mut [Vector4],
    /// Acceleration (m/s2), without the global gravity and buoyancy.
    pub push: &'t mut [Vector4],
    /// Rate of drag (1/s), without the global drag.
    pub resistance: &'t mut [f32x4],
    /// Indices of looks, if the tile has looks.
    pub looks: &'t [[u8; LANES]],
    /// Factor on gravity, if the tile has looks.
    pub gravity: &'t [f32x4],
    /// Temperature.
    pub heat: &'t [f32x4],
    /// Strength of the current force, 0..=1.
    pub weight: &'t mut [f32x4],
}

impl Tile {
    /// Creates an empty tile for steps of `dt` seconds.
    pub fn new(dt: f32, is_instant: bool) -> Self {
        let vectors = [Vector4::zero(); TILE_BLOCKS];
        let numbers = [f32x4::ZERO; TILE_BLOCKS];
        Self {
            len: 0,
            dt,
            is_instant,
            is_pushed: false,
            is_dragged: false,
            has_looks: false,
            looks: [[0; LANES]; TILE_BLOCKS],
            gravity: numbers,
            place: vectors,
            ahead: vectors,
            flow: vectors,
            slip: vectors,
            slipped: vectors,
            push: vectors,
            resistance: numbers,
            heat: numbers,
            weight: numbers,
        }
    }

    /// A tile of one place in all lanes, to evaluate the air velocity there.
    pub fn at(place: [f32; 3], dt: f32) -> Self {
        let mut tile = Self::new(dt, true);
        tile.len = 1;
        tile.place[0] = Vector4::splat(place);
        tile.ahead[0] = tile.place[0];
        tile
    }

    /// Loads the particles of `len` blocks from `first` on, with still air.
    #[inline(never)]
    pub fn load(&mut self, particles: &Particles, first: usize, len: usize) {
        self.clear(len);
        let half = if self.is_instant { f32x4::ZERO } else { f32x4::HALF };
        let column = |column| &blocks(column, first + len)[first..];
        let vector = |x, y, z| column(x).iter().zip(column(y)).zip(column(z)).map(vector4);
        let places = vector(&particles.x, &particles.y, &particles.z);
        let before = vector(&particles.px, &particles.py, &particles.pz);
        let slips = vector(&particles.sx, &particles.sy, &particles.sz);
        let heats = column(&particles.temperature);
        let own = self.place[..len]
            .iter_mut()
            .zip(&mut self.ahead[..len])
            .zip(self.slip[..len].iter_mut().zip(&mut self.heat[..len]));
        let theirs = places.zip(before).zip(slips.zip(heats));
        for (((place, ahead), (slip, heat)), ((now, before), (its_slip, its_heat))) in own.zip(theirs) {
            *place = now;
            *ahead = now + (now - before) * half;
            *slip = its_slip;
            *heat = f32x4::new(*its_heat);
        }
    }

    /// Number of blocks.
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// Resets the tile to `len` blocks, with still air and without pushes.
    #[inline(always)]
    fn clear(&mut self, len: usize) {
        self.len = len;
        self.has_looks = false;
        if self.is_pushed {
            self.push = [Vector4::zero(); TILE_BLOCKS];
            self.is_pushed = false;
        }
        if self.is_dragged {
            self.resistance = [f32x4::ZERO; TILE_BLOCKS];
            self.is_dragged = false;
        }
        self.flow[..len].fill(Vector4::zero());
    }

    /// Loads places without slip: the positions at the start of the step and the expected ones in its middle (m), with
    /// still air.
    pub fn load_places(&mut self, place: [&[[f32; LANES]]; 3], ahead: [&[[f32; LANES]]; 3]) {
        self.clear(place[0].len());
        for block in 0..self.len {
            self.place[block] = Vector4::load(place[0], place[1], place[2], block);
            self.ahead[block] = Vector4::load(ahead[0], ahead[1], ahead[2], block);
        }
    }

    /// The columns.
    #[inline(always)]
    pub fn columns(&mut self) -> Columns<'_> {
        let len = self.len.min(TILE_BLOCKS);
        Columns {
            place: &mut self.place[..len],
            ahead: &mut self.ahead[..len],
            flow: &mut self.flow[..len],
            slip: &mut self.slip[..len],
            slipped: &mut self.slipped[..len],
            push: &mut self.push[..len],
            resistance: &mut self.resistance[..len],
            looks: &self.looks[..len],
            gravity: &self.gravity[..len],
            heat: &self.heat[..len],
            weight: &mut self.weight[..len],
        }
    }

    /// Adds the accelerations (m/s2) of `kernels` at the positions after half a step of air and slip. For
    /// position-dependent accelerations this is a leapfrog step, which conserves the energy of an orbit. The
    /// displacement by vortices is not known yet.
    #[inline(always)]
    pub fn push_by<K>(
        &mut self,
        kernels: &[K],
        reach: impl Fn(&K) -> &Reach,
        acceleration: impl Fn(&K, Vector4) -> Vector4,
    ) {
        self.is_pushed = true;
        let half = f32x4::splat(if self.is_instant { 0.0 } else { self.dt * 0.5 });
        let Columns {
            place,
            ahead,
            flow,
            slip,
            push,
            weight,
            ..
        } = self.columns();
        for kernel in kernels {
            reach(kernel).weigh(ahead, weight);
            for (block, push) in push.iter_mut().enumerate() {
                let middle = place[block] + (flow[block] + slip[block]) * half;
                *push += acceleration(kernel, middle) * weight[block];
            }
        }
    }
}

#[inline(always)]
fn vector4(((x, y), z): ((&[f32; LANES], &[f32; LANES]), &[f32; LANES])) -> Vector4 {
    Vector4 {
        x: f32x4::new(*x),
        y: f32x4::new(*y),
        z: f32x4::new(*z),
    }
}

/// Splits the blocks of `particles` from `first` on into tiles: first block and number of blocks.
pub fn tiles(particles: &Particles, first: usize) -> impl DoubleEndedIterator<Item = (usize, usize)> + use<> {
    let end = particles.padded_alive() / LANES;
    (first..end)
        .step_by(TILE_BLOCKS)
        .map(move |from| (from, TILE_BLOCKS.min(end - from)))
}
