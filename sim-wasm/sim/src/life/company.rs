//! Ageing by company: `emission.company`.
//!
//! In the later part of its life, a particle without smoke around it ages faster, and one inside a group more slowly, so that
//! stragglers end first and groups end together. Every [`PERIOD`] steps the volumes of the puffs are summed in the cells
//! of a grid. A cell is twice as long as the mean size, and the grid repeats after [`SIDE`] cells. The smoke around a
//! particle is interpolated linearly between the eight nearest cells, without the particle's own volume.
//!
//! With s from 0 at the share [`LATE`] of life to 1 at [`LATE`] + [`LATE_SPAN`], and q = min(1, (share of space filled by
//! other puffs) / [`CROWD`]), a particle ages 1 + company s ([`ALONE_PACE`] (1 - q) - [`GROUP_PACE`] q) times as fast.

use wide::f32x4;

use crate::layout::limits::STEP;
use crate::layout::parameters::table::Parameters;
use crate::math::scalar::{greater, lesser};
use crate::math::simd::{LANES, blocks, blocks_mut, cell_and_fraction, positive_part, smaller};
use crate::particles::Particles;
use crate::particles::company::{Company, SIDE};
use crate::particles::radius::RadiusLaw;

/// Steps between two updates.
pub const PERIOD: u64 = 32;
/// Share of life at which company begins to matter, and the share over which it reaches its full effect.
pub const LATE: f32 = 0.35;
pub const LATE_SPAN: f32 = 0.25;
/// Additional pace of ageing without company.
pub const ALONE_PACE: f32 = 4.0;
/// Reduction of the pace of ageing inside a group.
pub const GROUP_PACE: f32 = 0.35;
/// Share of space that smoke fills inside a group.
pub const CROWD: f32 = 0.5;
/// Minimum length of a cell (m), so that cells can be counted in the whole world.
const MIN_CELL: f32 = 0.01;
/// Volume of a ball of radius 1.
const BALL: f32 = 4.188_790_3;

/// Determines anew how fast each particle ages, if `emission.company` is above 0.
#[inline(never)]
pub fn update(particles: &mut Particles, parameters: &Parameters) {
    let Some(mut company) = particles.company.take() else {
        return;
    };
    let alive = particles.alive();
    let Company { extra_ageing, cells } = &mut *company;
    let radii = RadiusLaw::new(parameters);
    let mean = particles.size[..alive].iter().sum::<f32>() / greater(alive as f32, 1.0);
    let length = greater(2.0 * mean * radii.puff_size, MIN_CELL);
    let blocks = Blocks::new(particles, radii, length);
    cells.fill(0.0);
    for block in 0..blocks.count() {
        let ([x, y, z], _) = blocks.cells(block, 0.0);
        let volumes = blocks.volumes(block);
        for lane in 0..LANES.min(alive - block * LANES) {
            cells[index([x[lane], y[lane], z[lane]])] += volumes[lane];
        }
    }
    let full = parameters.emission.company as f32 * STEP as f32;
    let per_volume = BALL / (CROWD * length * length * length);
    for (block, extra_ageing) in blocks_mut(extra_ageing, blocks.count()).iter_mut().enumerate() {
        let late = blocks.late(block);
        *extra_ageing = [0.0; LANES];
        if late == *extra_ageing {
            continue;
        }
        let (corners, shares) = blocks.cells(block, -0.5);
        let volumes = blocks.volumes(block);
        for lane in 0..LANES {
            if late[lane] > 0.0 {
                let corner = corners.map(|cell| cell[lane]);
                let share = shares.map(|share| share[lane]);
                let around = around(cells, corner, share, volumes[lane]);
                let crowd = lesser(around * per_volume, 1.0);
                extra_ageing[lane] = full * late[lane] * (ALONE_PACE * (1.0 - crowd) - GROUP_PACE * crowd);
            }
        }
    }
    particles.company = Some(company);
}

/// What the update reads of particles, in blocks.
struct Blocks<'p> {
    particles: &'p Particles,
    places: [&'p [[f32; LANES]]; 3],
    life: [&'p [[f32; LANES]]; 3],
    radii: RadiusLaw,
    per_length: f32x4,
}

impl<'p> Blocks<'p> {
    fn new(particles: &'p Particles, radii: RadiusLaw, length: f32) -> Self {
        let column = |column: &'p Vec<f32>| blocks(column, particles.padded_alive() / LANES);
        Self {
            particles,
            places: [&particles.x, &particles.y, &particles.z].map(column),
            life: [&particles.size, &particles.age, &particles.lifetime].map(column),
            radii,
            per_length: f32x4::splat(1.0 / length),
        }
    }

    fn count(&self) -> usize {
        self.places[0].len()
    }

    /// The cells below the places, moved by `shift` cells along each axis, and the positions within them, 0..=1.
    #[inline(always)]
    fn cells(&self, block: usize, shift: f32) -> ([[u32; LANES]; 3], [[f32; LANES]; 3]) {
        let [x, y, z] = self
            .places
            .map(|column| cell_and_fraction(f32x4::new(column[block]) * self.per_length + f32x4::splat(shift)));
        let cells = [x.0, y.0, z.0].map(|cell| cell.to_array());
        (cells, [x.1, y.1, z.1].map(|share| share.to_array()))
    }

    /// The cubes of the radii.
    #[inline(always)]
    fn volumes(&self, block: usize) -> [f32; LANES] {
        let life = self.life.map(|column| f32x4::new(column[block]));
        let radius = self.particles.radii(&self.radii, block, life);
        (radius * radius * radius).to_array()
    }

    /// How far company matters by now, 0..=1.
    #[inline(always)]
    fn late(&self, block: usize) -> [f32; LANES] {
        let [_, age, lifetime] = self.life.map(|column| f32x4::new(column[block]));
        let share = (age / lifetime - f32x4::splat(LATE)) * f32x4::splat(1.0 / LATE_SPAN);
        smaller(positive_part(share), f32x4::ONE).to_array()
    }
}

/// The sum of the eight cells from `corner` on by their weights at `share` of the way between their centres, without the part
/// of `own`, which is in the cell of the greatest weight.
#[inline(always)]
fn around(cells: &[f32], corner: [u32; 3], share: [f32; 3], own: f32) -> f32 {
    let mut sum = 0.0;
    let mut greatest = 0.0;
    for number in 0..8 {
        let step = [number & 1, number >> 1 & 1, number >> 2];
        let weight = |axis: usize| {
            if step[axis] == 1 {
                share[axis]
            } else {
                1.0 - share[axis]
            }
        };
        let weight = weight(0) * weight(1) * weight(2);
        sum += cells[index(std::array::from_fn(|axis| corner[axis].wrapping_add(step[axis])))] * weight;
        greatest = greater(greatest, weight);
    }
    greater(sum - own * greatest, 0.0)
}

/// The index of a cell in the grid.
#[inline(always)]
fn index(cell: [u32; 3]) -> usize {
    let [x, y, z] = cell.map(|along| along & (SIDE - 1));
    (x + SIDE * (y + SIDE * z)) as usize
}
