//! Broad phase over all particles, four at a time.

use wide::f32x4;

use crate::math::bounds::Bounds;
use crate::math::simd::LANES;
#[cfg(feature = "meshes")]
use crate::math::vector::Vector;
use crate::particles::Particles;
use crate::particles::radius::RadiusLaw;

/// Distribution of particles: their bounds, and the size of their swept boxes.
#[cfg(feature = "meshes")]
#[derive(Clone, Copy, Debug)]
pub struct ParticleExtent {
    /// Box of the centres of the sampled swept boxes.
    pub middles: Bounds,
    /// Maximum and mean half extent (m) of the swept boxes, radius included.
    pub greatest_reach: f32,
    pub mean_reach: f32,
}

/// The boxes that four particles sweep in a step, radius included.
pub(crate) struct SweptBoxes {
    min: [f32x4; 3],
    max: [f32x4; 3],
}

impl SweptBoxes {
    #[inline]
    fn load(particles: &Particles, radii: &RadiusLaw, first: usize) -> Self {
        // An upper bound of the radius law that needs neither age nor lifetime.
        let reach = four(&particles.size, first) * f32x4::splat(radii.puff_size);
        let columns = [
            (&particles.x, &particles.px),
            (&particles.y, &particles.py),
            (&particles.z, &particles.pz),
        ];
        let ends = columns.map(|(now, before)| (four(now, first), four(before, first)));
        Self {
            min: ends.map(|(now, before)| now.fast_min(before) - reach),
            max: ends.map(|(now, before)| now.fast_max(before) + reach),
        }
    }

    /// Bit k is set if box k touches `bounds`.
    #[inline]
    pub(crate) fn touching(&self, bounds: &Bounds) -> u32 {
        let (least, most): ([f32; 3], [f32; 3]) = (bounds.min.into(), bounds.max.into());
        let mut all = f32x4::splat(f32::from_bits(u32::MAX));
        for axis in 0..3 {
            all &= self.min[axis].simd_le(f32x4::splat(most[axis])) & self.max[axis].simd_ge(f32x4::splat(least[axis]));
        }
        all.to_bitmask()
    }

    /// Centres of the boxes.
    #[cfg(feature = "meshes")]
    #[inline]
    pub(crate) fn middles(&self) -> [f32x4; 3] {
        std::array::from_fn(|axis| (self.min[axis] + self.max[axis]) * f32x4::splat(0.5))
    }

    /// Half of the longest side of each box.
    #[cfg(feature = "meshes")]
    #[inline]
    pub(crate) fn reaches(&self) -> f32x4 {
        let [x, y, z] = std::array::from_fn(|axis| self.max[axis] - self.min[axis]);
        x.fast_max(y).fast_max(z) * f32x4::splat(0.5)
    }
}

fn four(column: &[f32], first: usize) -> f32x4 {
    let lanes: &[f32; LANES] = column[first..first + LANES]
        .try_into()
        .expect("columns are padded to whole blocks");
    f32x4::from(*lanes)
}

/// Broad-phase result of a block of four particles.
#[derive(Clone, Copy, Default)]
pub(crate) struct NearLanes {
    /// Bit k is set if particle k may be near an obstacle.
    pub(crate) lanes: u32,
    /// Grid location of each particle.
    pub(crate) locations: [GridLocation; LANES],
}

/// Location of a particle in the grid of rigids.
#[derive(Clone, Copy, Default)]
pub(crate) struct GridLocation {
    #[cfg(feature = "meshes")]
    pub(crate) cell: u32,
    /// True if the particle is too large for one cell.
    #[cfg(feature = "meshes")]
    pub(crate) is_large: bool,
}

/// Blocks per batch. Separate loops for search and collision help branch prediction.
const BATCH: usize = 64;

/// Calls `meet` for each living particle that `look` selects from a block of four, with its index and its grid
/// location.
pub(crate) fn for_each_near(
    particles: &mut Particles,
    radii: &RadiusLaw,
    look: impl Fn(&SweptBoxes) -> NearLanes,
    mut meet: impl FnMut(&mut Particles, usize, GridLocation),
) {
    let alive = particles.alive();
    let mut picked = [(0, GridLocation::default()); BATCH * LANES];
    for begin in (0..alive).step_by(BATCH * LANES) {
        let mut count = 0;
        for first in (begin..alive.min(begin + BATCH * LANES)).step_by(LANES) {
            let near_lanes = look(&SweptBoxes::load(particles, radii, first));
            if near_lanes.lanes == 0 {
                continue;
            }
            for (lane, location) in near_lanes.locations.into_iter().enumerate() {
                picked[count] = (first + lane, location);
                count += (near_lanes.lanes >> lane & 1) as usize;
            }
        }
        for &(i, location) in &picked[..count] {
            if i < alive {
                meet(particles, i, location);
            }
        }
    }
}

/// One block in so many is sampled. The grid must suit most particles; its result is exact for all.
#[cfg(feature = "meshes")]
const BLOCKS_PER_LOOK: usize = 8;

/// Samples the living particles.
#[cfg(feature = "meshes")]
pub fn extent(particles: &Particles, radii: &RadiusLaw) -> ParticleExtent {
    let mut least = [f32x4::splat(f32::INFINITY); 3];
    let mut most = [f32x4::splat(f32::NEG_INFINITY); 3];
    let mut greatest_reach = f32x4::splat(0.0);
    let mut sum = f32x4::splat(0.0);
    let firsts = (0..particles.alive()).step_by(LANES * BLOCKS_PER_LOOK);
    let looks = firsts.len();
    for first in firsts {
        let swept_boxes = SweptBoxes::load(particles, radii, first);
        let middles = swept_boxes.middles();
        for axis in 0..3 {
            least[axis] = least[axis].fast_min(middles[axis]);
            most[axis] = most[axis].fast_max(middles[axis]);
        }
        let reaches = swept_boxes.reaches();
        greatest_reach = greatest_reach.fast_max(reaches);
        sum += reaches;
    }
    let vector = |lanes: [f32x4; 3], pick: fn(f32, f32) -> f32| {
        let [x, y, z] = lanes.map(|lane| lane.to_array().into_iter().reduce(pick).expect("four lanes"));
        Vector::new(x, y, z)
    };
    ParticleExtent {
        middles: Bounds {
            min: vector(least, f32::min),
            max: vector(most, f32::max),
        },
        greatest_reach: greatest_reach.to_array().into_iter().fold(0.0, f32::max),
        mean_reach: sum.to_array().iter().sum::<f32>() / (looks * LANES).max(1) as f32,
    }
}
