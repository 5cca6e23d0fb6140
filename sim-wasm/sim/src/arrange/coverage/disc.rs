//! Discs on the grid: parts of a puff that it certainly covers, or that it may show.

use wide::f32x4;

use crate::arrange::coverage::solids::BALLS_LIMIT;
use crate::math::simd::LANES;

/// Lengths across the grid in cells, depths in metres along the view. The front is flat or spherical.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Disc {
    /// Centre, relative to the corner of the grid.
    pub u: f32,
    pub v: f32,
    pub radius: f32,
    /// Depth of the centre plane (m).
    pub depth: f32,
    /// Metres per cell of the front's height; 0 for a flat front.
    pub bulge: f32,
    /// Radius with the ring of ink, and the minimum depth of the ring.
    pub rim: f32,
    pub rim_depth: f32,
}

impl Disc {
    /// The same disc on a grid with cells `factor` times as large.
    #[inline(always)]
    pub(crate) fn on_coarser(&self, factor: f32) -> Self {
        let share = 1.0 / factor;
        Self {
            u: self.u * share,
            v: self.v * share,
            radius: self.radius * share,
            bulge: self.bulge * factor,
            rim: self.rim * share,
            ..*self
        }
    }

    /// A mask of the cells, of four at these squared distances, that a disc without a rim touches and where it is not
    /// behind the depth.
    #[inline(always)]
    pub(crate) fn shows(&self, squared: f32x4, cells: f32x4) -> u32 {
        let [depth, radius] = [self.depth, self.radius].map(f32x4::splat);
        is_within(depth, radius, self.bulge, squared, cells)
    }

    /// Depth of the front at a squared distance from the centre, for four cells. Outside of the disc, the depth of the
    /// centre plane.
    #[inline(always)]
    pub(crate) fn front(&self, squared: f32x4) -> f32x4 {
        let radius = f32x4::splat(self.radius);
        front(f32x4::splat(self.depth), radius, self.bulge, squared)
    }
}

/// The discs of one puff, four in each group. A disc that is absent has the radius and rim 0.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Discs {
    pub groups: [DiscGroup; BALLS_LIMIT / LANES],
    pub count: usize,
    /// As in [`Disc`], for all.
    pub bulge: f32,
}

/// Four discs, see [`Disc`].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct DiscGroup {
    pub u: f32x4,
    pub v: f32x4,
    pub radius: f32x4,
    pub depth: f32x4,
    pub rim: f32x4,
    pub rim_depth: f32x4,
}

impl Discs {
    /// Makes `disc` the only one.
    pub(crate) fn set(&mut self, disc: &Disc) {
        let only = |value: f32| f32x4::new([value, 0.0, 0.0, 0.0]);
        self.groups[0] = DiscGroup {
            u: only(disc.u),
            v: only(disc.v),
            radius: only(disc.radius),
            depth: only(disc.depth),
            rim: only(disc.rim),
            rim_depth: only(disc.rim_depth),
        };
        (self.count, self.bulge) = (1, disc.bulge);
    }

    pub(crate) fn groups(&self) -> &[DiscGroup] {
        &self.groups[..self.count]
    }

    /// The disc in lane `number` of all groups.
    #[inline(always)]
    pub(crate) fn get(&self, number: usize) -> Disc {
        let (group, lane) = (&self.groups[number / LANES], number % LANES);
        let value = |lanes: &f32x4| lanes.as_array()[lane];
        Disc {
            u: value(&group.u),
            v: value(&group.v),
            radius: value(&group.radius),
            depth: value(&group.depth),
            bulge: self.bulge,
            rim: value(&group.rim),
            rim_depth: value(&group.rim_depth),
        }
    }

    /// The disc with the greatest radius.
    pub(crate) fn largest(&self) -> Disc {
        let all = (0..self.count * LANES).map(|number| self.get(number));
        all.fold(Disc::default(), |largest, disc| {
            if disc.radius >= largest.radius { disc } else { largest }
        })
    }
}

impl DiscGroup {
    /// A mask of the discs that touch a block at these squared distances and are not behind its depth.
    #[inline(always)]
    pub(crate) fn shows(&self, bulge: f32, squared: f32x4, block: f32x4) -> u32 {
        let touched = squared.simd_lt(self.rim * self.rim);
        let front = front(self.depth, self.radius, bulge, squared).fast_min(self.rim_depth);
        (touched & block.simd_ge(front)).to_bitmask()
    }

    /// The same without rims.
    #[inline(always)]
    pub(crate) fn covers(&self, bulge: f32, squared: f32x4, block: f32x4) -> u32 {
        is_within(self.depth, self.radius, bulge, squared, block)
    }
}

/// Depth of a front at a squared distance from its centre.
#[inline(always)]
pub(crate) fn front(depth: f32x4, radius: f32x4, bulge: f32, squared: f32x4) -> f32x4 {
    let height = (radius * radius - squared).fast_max(f32x4::ZERO).sqrt();
    depth - height * f32x4::splat(bulge)
}

/// A mask of the lanes where a disc is not behind `depths`. Beyond its radius the root is NaN and the comparison false.
#[inline(always)]
fn is_within(depth: f32x4, radius: f32x4, bulge: f32, squared: f32x4, depths: f32x4) -> u32 {
    let height = (radius * radius - squared).sqrt();
    depths.simd_ge(depth - height * f32x4::splat(bulge)).to_bitmask()
}
