//! Ink where smoke touches surfaces: raised rings, and lines along seams.

use glam::{DVec2, DVec3};

use crate::ray::Camera;

/// Slope by which a surface may rise beside the silhouette and still count as behind the puff.
pub const STEEPEST: f64 = 8.0;
/// Maximum slope: puffs are too steep beside their silhouette.
const FLATTEST: f64 = 0.1;
/// Depth steps between a raised ring and its surface.
const LIFT_STEPS: f64 = 3.0;
const LIFT: f64 = LIFT_STEPS / 16_777_216.0;

/// Window depths of surfaces and their lines, row by row from the bottom.
pub struct Ground<'a> {
    pub camera: &'a Camera,
    pub width: usize,
    pub depths: Vec<f64>,
}

/// A ring of ink: its height without and with sinking (view z, m), its distance from the silhouette (m), and the
/// direction to it (pixels).
pub struct Ring {
    pub rim: f64,
    pub sunken: f64,
    pub outside: f64,
    pub inward: DVec2,
}

impl Ground<'_> {
    /// View z of the surface in a pixel; outside of the picture that of depth 0.
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

    /// Returns true if a point of a puff is within `reach` pixels of a seam.
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
