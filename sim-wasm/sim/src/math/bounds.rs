//! Axis-aligned boxes.

use wide::f32x4;

use crate::math::vector::Vector;

/// An axis-aligned box (m) in two SIMD registers, for many tests without branches.
#[derive(Clone, Copy, Debug)]
pub struct WideBounds {
    /// x, y, z and 0.
    min: f32x4,
    max: f32x4,
}

impl WideBounds {
    /// The box of a sphere of radius `reach` that moves from `from` to `to`.
    #[inline]
    pub fn of_way(from: Vector, to: Vector, reach: f32) -> Self {
        let (from, to, reach) = (four(from), four(to), f32x4::new([reach, reach, reach, 0.0]));
        Self {
            min: from.fast_min(to) - reach,
            max: from.fast_max(to) + reach,
        }
    }

    /// Returns true if the boxes overlap or touch.
    #[inline]
    pub fn touches(&self, other: &Self) -> bool {
        (self.min.simd_le(other.max) & self.max.simd_ge(other.min)).to_bitmask() == 0b1111
    }
}

impl From<&Bounds> for WideBounds {
    fn from(bounds: &Bounds) -> Self {
        Self {
            min: four(bounds.min),
            max: four(bounds.max),
        }
    }
}

#[inline]
fn four(vector: Vector) -> f32x4 {
    f32x4::new([vector.x, vector.y, vector.z, 0.0])
}

/// An axis-aligned box (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub min: Vector,
    pub max: Vector,
}

impl Bounds {
    /// The empty box.
    pub const NOTHING: Bounds = Bounds {
        min: Vector::new(f32::INFINITY, f32::INFINITY, f32::INFINITY),
        max: Vector::new(f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY),
    };
    /// The unbounded box.
    pub const EVERYTHING: Bounds = Bounds {
        min: Self::NOTHING.max,
        max: Self::NOTHING.min,
    };

    /// The box of a sphere of radius `reach` that moves from `from` to `to`.
    pub fn of_way(from: Vector, to: Vector, reach: f32) -> Self {
        Self {
            min: from.least(to),
            max: from.greatest(to),
        }
        .wider(reach)
    }

    /// The box, extended by `margin` on all sides.
    pub fn wider(&self, margin: f32) -> Self {
        let margin = Vector::new(margin, margin, margin);
        Self {
            min: self.min - margin,
            max: self.max + margin,
        }
    }

    /// The box around both.
    pub fn with(&self, other: &Self) -> Self {
        Self {
            min: self.min.least(other.min),
            max: self.max.greatest(other.max),
        }
    }

    /// Maximum distance of a point of the box from the origin (m).
    pub fn reach(&self) -> f32 {
        self.min.abs().greatest(self.max.abs()).length()
    }

    /// Returns true if the boxes overlap or touch.
    pub fn touches(&self, other: &Self) -> bool {
        self.min.x <= other.max.x
            && self.max.x >= other.min.x
            && self.min.y <= other.max.y
            && self.max.y >= other.min.y
            && self.min.z <= other.max.z
            && self.max.z >= other.min.z
    }
}
