//! A disc on the grid: a part of a puff that it certainly covers, or that it may show.

use wide::f32x4;

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

    /// Depth of the front at a squared distance from the centre, for four cells. Outside of the disc, the depth of the
    /// centre plane.
    #[inline(always)]
    pub(crate) fn front(&self, squared: f32x4) -> f32x4 {
        if self.bulge == 0.0 {
            return f32x4::splat(self.depth);
        }
        let height = (f32x4::splat(self.radius * self.radius) - squared)
            .fast_max(f32x4::ZERO)
            .sqrt();
        f32x4::splat(self.depth) - height * f32x4::splat(self.bulge)
    }
}
