//! Three-vectors of single precision.
//!
//! Scalar arithmetic in a fixed order: every machine computes the same bits.

use std::ops::{Add, Mul, Neg, Sub};

use crate::math::scalar::{greater, lesser};

/// A three-vector.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector {
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

impl Vector {
    /// The zero vector.
    pub const ZERO: Vector = Vector::new(0.0, 0.0, 0.0);
    /// The up direction.
    pub const Y: Vector = Vector::new(0.0, 1.0, 0.0);

    /// Creates a vector from its components.
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Self { x, y, z }
    }

    /// The dot product.
    pub fn dot(self, other: Self) -> f32 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The cross product.
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// The Euclidean length.
    pub fn length(self) -> f32 {
        self.dot(self).sqrt()
    }

    /// The unit vector; `fallback` for the zero vector.
    pub fn unit_or(self, fallback: Self) -> Self {
        let length = self.length();
        if length > 1e-20 {
            self * (1.0 / length)
        } else {
            fallback
        }
    }

    /// Component-wise minimum.
    pub fn least(self, other: Self) -> Self {
        Self::new(
            lesser(self.x, other.x),
            lesser(self.y, other.y),
            lesser(self.z, other.z),
        )
    }

    /// Component-wise maximum.
    pub fn greatest(self, other: Self) -> Self {
        Self::new(
            greater(self.x, other.x),
            greater(self.y, other.y),
            greater(self.z, other.z),
        )
    }

    /// Component-wise absolute value.
    pub fn abs(self) -> Self {
        Self::new(self.x.abs(), self.y.abs(), self.z.abs())
    }

    /// Linear interpolation to `other`.
    pub fn towards(self, other: Self, fraction: f32) -> Self {
        self + (other - self) * fraction
    }
}

impl From<[f32; 3]> for Vector {
    fn from([x, y, z]: [f32; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl From<Vector> for [f32; 3] {
    fn from(vector: Vector) -> Self {
        [vector.x, vector.y, vector.z]
    }
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<f32> for Vector {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl Neg for Vector {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}
