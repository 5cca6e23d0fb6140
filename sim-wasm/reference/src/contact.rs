//! Ink where smoke touches surfaces: rings that are lifted before what a puff rests on, lines along seams.

use glam::{DVec2, DVec3};

use crate::ray::Camera;

/// A surface may come nearer by so much for each unit beside the silhouette and is still what lies behind the puff.
pub const STEEPEST: f64 = 8.0;
/// Puffs turn away so steeply beside their silhouette that a slope says nothing there.
const FLATTEST: f64 = 0.1;
/// Steps of the depth buffer by which a lifted ring stays before its surface.
const LIFT: f64 = 3.0 / 16_777_216.0;

/// The window depths that surfaces and their lines have left, row by row from the bottom.
pub struct Ground<'a> {
    pub camera: &'a Camera,
    pub width: usize,
    pub depths: Vec<f64>,
}

/// A ring of ink: its height were it not sunk, its height as it is (view z, m), how far it lies beside the silhouette
/// (m), and the way to there (pixels).
pub struct Ring {
    pub rim: f64,
    pub sunken: f64,
    pub outside: f64,
    pub inward: DVec2,
}

impl Ground<'_> {
    /// View z of the surface in a pixel; beyond the picture as the depth 0.
    pub fn z(&self, [x, y]: [i64; 2]) -> f64 {
        -self.camera.depth_of(self.depth([x, y]))
    }

    fn depth(&self, [x, y]: [i64; 2]) -> f64 {
        let inside = x >= 0 && y >= 0 && (x as usize) < self.width;
        let index = y * self.width as i64 + x;
        let found = usize::try_from(index).ok().filter(|_| inside);
        found.and_then(|index| self.depths.get(index)).copied().unwrap_or(0.0)
    }

    fn slope(&self, at: [i64; 2], step: [i64; 2]) -> f64 {
        let here = self.z(at);
        let ahead = self.z([at[0] + step[0], at[1] + step[1]]) - here;
        let behind = here - self.z([at[0] - step[0], at[1] - step[1]]);
        if ahead.abs() < behind.abs() { ahead } else { behind }
    }

    /// Whether a point of a puff lies within `reach` pixels of a seam.
    pub fn is_seam(&self, at: [i64; 2], z: f64, normal: DVec3, pixel: f64, reach: f64) -> bool {
        let gap = z - self.z(at);
        if reach <= 0.0 || gap > (STEEPEST + 1.0 / FLATTEST) * reach * pixel {
            return false;
        }
        let own = -normal.truncate() / normal.z.max(FLATTEST) * pixel;
        let slope = own - DVec2::new(self.slope(at, [1, 0]), self.slope(at, [0, 1]));
        gap < reach * slope.length()
    }

    /// View depth of a ring.
    pub fn ring_depth(&self, at: [i64; 2], ring: &Ring) -> f64 {
        let rows = self.depths.len() / self.width;
        let target = DVec2::new(at[0] as f64, at[1] as f64) + 0.5 + ring.inward;
        let rim_pixel = [
            (target.x as i64).clamp(0, self.width as i64 - 1),
            (target.y as i64).clamp(0, rows as i64 - 1),
        ];
        let here = self.depth(at);
        let is_before = self.depth(rim_pixel) > self.camera.window_depth(-ring.rim);
        let is_slope = here > self.camera.window_depth(-(ring.rim + STEEPEST * ring.outside));
        if is_before && is_slope {
            return self.camera.depth_of(here - LIFT).min(-ring.sunken);
        }
        -ring.sunken
    }
}
