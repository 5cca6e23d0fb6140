//! A conservative test of one particle against one obstacle: most pairs with overlapping boxes do not touch.

use wide::f32x4;

use crate::math::bounds::Bounds;
use crate::math::pose_motion::PoseMotion;
use crate::math::vector::Vector;

/// A bounding solid: all points within `radius` of a box or of an upright cylinder.
#[derive(Clone, Copy, Debug)]
pub struct Core {
    centre: Vector,
    /// Half extents (m). For a cylinder x is the radius and z is 0.
    half: f32x4,
    /// Radius (m).
    radius: f32,
    /// True for a cylinder along y.
    about_y: bool,
    /// Tolerance (m) of rounding between this test and the exact one.
    slack: f32,
}

impl Core {
    /// The box `bounds`.
    pub fn of(bounds: &Bounds) -> Self {
        Self {
            centre: (bounds.min + bounds.max) * 0.5,
            ..Self::around((bounds.max - bounds.min) * 0.5, 0.0)
        }
    }

    /// All points within `radius` of a box about the origin.
    pub fn around(half: Vector, radius: f32) -> Self {
        Self {
            centre: Vector::ZERO,
            half: f32x4::new([half.x, half.y, half.z, 0.0]),
            radius,
            about_y: false,
            slack: 1e-5 * (half.length() + radius),
        }
    }

    /// An upright cylinder about the origin.
    pub fn upright(half_height: f32, radius: f32) -> Self {
        Self {
            about_y: true,
            ..Self::around(Vector::new(radius, half_height, 0.0), 0.0)
        }
    }

    /// Returns true if a sphere of `radius` that moves from `from` to `to` (m, world space) over a whole step certainly
    /// misses the solid. Then [`super::contact::Obstacle::meet`] changes nothing.
    #[inline]
    pub fn is_certainly_missed_by(&self, motion: &PoseMotion, from: Vector, to: Vector, radius: f32) -> bool {
        let (start, end) = motion.ends();
        let (from, to) = (start.local_from_world(from), end.local_from_world(to));
        let way = (to - from).length() + motion.detour(from, to);
        let (first, last) = (self.distance(from), self.distance(to));
        // The margin covers rounding: no particle may pass that the exact test would stop.
        let radius = radius * 1.001 + self.slack;
        (last >= radius) & (first + last >= way * 1.001 + 2.0 * radius)
    }

    /// A lower bound of the distance to the shape; inside of the box or cylinder at least minus the radius.
    #[inline]
    fn distance(&self, point: Vector) -> f32 {
        let Vector { x, y, z } = point - self.centre;
        let offset = if self.about_y {
            [(x * x + z * z).sqrt(), y, 0.0, 0.0]
        } else {
            [x, y, z, 0.0]
        };
        let outside = (f32x4::new(offset).abs() - self.half).fast_max(f32x4::ZERO);
        let [x, y, z, _] = (outside * outside).to_array();
        (x + y + z).sqrt() - self.radius
    }
}
