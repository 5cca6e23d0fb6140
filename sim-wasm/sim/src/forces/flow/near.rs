//! The nearest points of a path, for a tile of particles.
//!
//! Each stage of the search is a loop of its own over the tile: a processor overlaps few turns of a loop whose chain of
//! operations is long.

use arrayvec::ArrayVec;
use wide::{f32x4, u32x4};

use crate::forces::flow::path::{FAR, Path};
use crate::math::simd::{LANES, Vector4};
use crate::particles::tile::TILE_BLOCKS;

/// The places of a tile.
pub(super) type Spots = ArrayVec<Spot, TILE_BLOCKS>;
/// The samples that are nearest to the blocks in reach.
pub(super) type Samples = ArrayVec<Samples4, TILE_BLOCKS>;

/// Four places in the frame of a path, and their cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub place: Vector4,
    cells: u32x4,
}

/// A block of a tile, and the numbers of the nearest samples.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reached {
    pub block: usize,
    nearest: [u8; LANES],
}

/// The nearest samples of four places.
#[derive(Clone, Copy, Debug)]
pub(super) struct Samples4 {
    /// From the samples.
    offset: Vector4,
    direction: Vector4,
    bend: Vector4,
    /// Distance along the path to the nearest point of it, and from there to the foot of the perpendicular.
    along: f32x4,
    beyond: f32x4,
}

/// The nearest points of a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// From the path.
    pub offset: Vector4,
    /// The part of it across the path. They differ beyond the ends.
    pub across: Vector4,
    /// Unit vector along the path.
    pub direction: Vector4,
}

impl Path {
    #[inline(always)]
    pub(super) fn spot(&self, place: Vector4) -> Spot {
        Spot {
            place,
            cells: self.cells.at(place),
        }
    }

    /// The blocks of which a place is in the path's reach.
    #[inline(always)]
    pub(super) fn reached<'r>(&self, spots: &Spots, reached: &'r mut [Reached; TILE_BLOCKS]) -> &'r [Reached] {
        let mut count = 0;
        for (block, spot) in spots.iter().enumerate() {
            let nearest = spot.cells.to_array().map(|cell| self.cells.nearest(cell));
            reached[count % TILE_BLOCKS] = Reached { block, nearest };
            // A branch would be mispredicted.
            count += usize::from(nearest != [FAR; LANES]);
        }
        &reached[..count]
    }

    #[inline(always)]
    pub(super) fn samples(&self, spots: &Spots, reached: &Reached) -> Samples4 {
        let rows = reached.nearest.map(|sample| &self.samples[usize::from(sample)]);
        let column = |row: usize| f32x4::transpose(rows.map(|sample| sample[row]));
        let [x, y, z, back] = column(0);
        let offset = spots[reached.block].place - Vector4 { x, y, z };
        let [x, y, z, ahead] = column(1);
        let direction = Vector4 { x, y, z };
        let [x, y, z, _] = column(2);
        let bend = Vector4 { x, y, z };
        // The foot of the perpendicular on the parabola, up to second order.
        let narrow = (f32x4::ONE - bend.dot(offset)).fast_max(f32x4::splat(0.25));
        let foot = direction.dot(offset) / narrow;
        // Adding 0 loses the sign of zero, which depends on the machine.
        let along = foot.fast_min(ahead).fast_max(back) + f32x4::ZERO;
        Samples4 {
            offset,
            direction,
            bend,
            along,
            beyond: foot - along,
        }
    }
}

impl Samples4 {
    /// The nearest points of the parabolas.
    #[inline(always)]
    pub(super) fn near(&self) -> Near {
        let along = self.along;
        let turn = self.bend * along;
        let offset = self.offset - (self.direction + turn * f32x4::HALF) * along;
        let direction = self.direction + turn;
        // The direction is longer than 1 by the square of the turn: a Newton step for the inverse root.
        let unit = f32x4::splat(1.5) - direction.dot(direction) * f32x4::HALF;
        let direction = direction * unit;
        Near {
            offset,
            across: offset - direction * self.beyond,
            direction,
        }
    }
}
