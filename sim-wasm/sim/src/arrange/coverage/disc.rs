//! A round part of a puff on the grid: what it covers for certain, or all that it could show.

use wide::f32x4;

/// Lengths across the grid in cells, depths in metres along the view. Its front is flat, or bulges by a ball.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Disc {
    /// Centre, from the corner of the grid.
    pub u: f32,
    pub v: f32,
    pub radius: f32,
    /// Depth of its centre plane.
    pub depth: f32,
    /// Metres of bulge for each cell of height; 0 where the front is flat.
    pub bulge: f32,
    /// Radius with the ring of ink, and how near that ring may come.
    pub rim: f32,
    pub rim_depth: f32,
}

impl Disc {
    /// The same disc on a grid whose cells are `factor` times as large.
    pub(crate) fn on_coarser(&self, factor: f32) -> Self {
        Self {
            u: self.u / factor,
            v: self.v / factor,
            radius: self.radius / factor,
            bulge: self.bulge * factor,
            rim: self.rim / factor,
            ..*self
        }
    }

    /// Depth of the front at a squared distance from the centre, four cells at a time; outside, that of the centre plane.
    #[inline(always)]
    pub(crate) fn front(&self, squared: f32x4) -> f32x4 {
        let height = (f32x4::splat(self.radius * self.radius) - squared)
            .fast_max(f32x4::ZERO)
            .sqrt();
        f32x4::splat(self.depth) - height * f32x4::splat(self.bulge)
    }
}
