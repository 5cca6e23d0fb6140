//! Three-vectors of four particles at a time, and the functions of SIMD lanes that kernels need.
//!
//! All functions give the same bits on x86-64 and in WASM: they use only correctly rounded operations of IEEE 754, no
//! fused multiply-add, no approximate reciprocals, and no minimum or maximum that depends on the sign of zero.

use std::ops::{Add, AddAssign, Mul, Sub};
use wide::bytemuck::cast;
use wide::{f32x4, i32x4, u32x4};

/// Particles per SIMD operation.
pub const LANES: usize = 4;

/// A three-vector of four particles.
#[derive(Clone, Copy, Debug)]
pub struct Vector4 {
    pub x: f32x4,
    pub y: f32x4,
    pub z: f32x4,
}

impl Vector4 {
    /// The zero vector in every lane.
    pub fn zero() -> Self {
        Self::splat([0.0; 3])
    }

    /// The same vector in every lane.
    pub fn splat(v: [f32; 3]) -> Self {
        Self {
            x: f32x4::splat(v[0]),
            y: f32x4::splat(v[1]),
            z: f32x4::splat(v[2]),
        }
    }

    #[inline(always)]
    pub fn length(self) -> f32x4 {
        self.dot(self).sqrt()
    }

    /// The same number in every component.
    #[inline(always)]
    pub fn diagonal(value: f32x4) -> Self {
        Self {
            x: value,
            y: value,
            z: value,
        }
    }

    /// Negates the lanes in which the highest bit of `sign` is set. All other bits of `sign` must be 0.
    #[inline(always)]
    pub fn negated_where(self, sign: u32x4) -> Self {
        let sign: f32x4 = cast(sign);
        Self {
            x: self.x ^ sign,
            y: self.y ^ sign,
            z: self.z ^ sign,
        }
    }

    /// Loads block `block` of three columns.
    #[inline(always)]
    pub fn load(x: &[[f32; LANES]], y: &[[f32; LANES]], z: &[[f32; LANES]], block: usize) -> Self {
        Self {
            x: f32x4::new(x[block]),
            y: f32x4::new(y[block]),
            z: f32x4::new(z[block]),
        }
    }

    /// The vector in the first lane.
    pub fn first(self) -> [f32; 3] {
        [self.x.to_array()[0], self.y.to_array()[0], self.z.to_array()[0]]
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> f32x4 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
}

impl Add for Vector4 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl AddAssign for Vector4 {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Vector4 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl Mul<f32x4> for Vector4 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f32x4) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}

/// A number in every lane, rounded to single precision.
#[inline(always)]
pub fn splat(value: f64) -> f32x4 {
    f32x4::splat(value as f32)
}

/// The first `blocks` blocks of [`LANES`] of a column.
#[inline(always)]
pub fn blocks(column: &[f32], blocks: usize) -> &[[f32; LANES]] {
    &column.as_chunks::<LANES>().0[..blocks]
}

/// The first `blocks` blocks of [`LANES`] of a mutable column.
#[inline(always)]
pub fn blocks_mut(column: &mut [f32], blocks: usize) -> &mut [[f32; LANES]] {
    &mut column.as_chunks_mut::<LANES>().0[..blocks]
}

/// Negative lanes become exactly +0.
#[inline(always)]
pub fn positive_part(value: f32x4) -> f32x4 {
    value.simd_gt(f32x4::ZERO) & value
}

/// The smaller of two numbers. They must not be zeros of different signs.
#[inline(always)]
pub fn smaller(a: f32x4, b: f32x4) -> f32x4 {
    a.simd_lt(b).select(a, b)
}

/// The larger of two numbers. They must not be zeros of different signs.
#[inline(always)]
pub fn larger(a: f32x4, b: f32x4) -> f32x4 {
    a.simd_gt(b).select(a, b)
}

/// The index of cell 0 in [`cell_and_fraction`].
pub const CELL_ZERO: u32 = 0x4B40_0000;

/// The cell below `value`, counted from [`CELL_ZERO`], and the position within it, 0..=1. Requires |value| < 2^22.
#[inline(always)]
pub fn cell_and_fraction(value: f32x4) -> (u32x4, f32x4) {
    let below = value.floor();
    // Next to 1.5 * 2^23 the low bits of a float are its whole part; a saturating conversion costs far more.
    (cast(below + f32x4::splat(12_582_912.0)), value - below)
}

/// exp(-x) for x >= 0, with a relative error below 3e-7 up to x = 80. Larger x give exp(-80).
///
/// Computes 2^(n + f) with n whole and |f| <= 1/2 by the Taylor series of 2^f.
#[inline(always)]
pub fn exp_minus(x: f32x4) -> f32x4 {
    // Adding 1.5 * 2^23 rounds to the nearest whole number in the low bits, on every machine alike.
    const MAGIC: f32 = 12_582_912.0;
    let y = smaller(x, f32x4::splat(80.0)) * f32x4::splat(-std::f32::consts::LOG2_E);
    let shifted = y + f32x4::splat(MAGIC);
    let f = y - (shifted - f32x4::splat(MAGIC));
    let square = f * f;
    let pair = |low: f32, high: f32| f32x4::splat(low) + f32x4::splat(high) * f;
    // Evaluated in pairs: a Horner scheme would be one dependency chain.
    let low = pair(1.0, std::f32::consts::LN_2) + square * pair(0.240_226_5, 5.550_411e-2);
    let high = pair(9.618_129e-3, 1.333_355_8e-3) + square * f32x4::splat(1.540_353e-4);
    let series = low + square * square * high;
    let exponent = cast::<f32x4, i32x4>(shifted) << 23;
    cast(cast::<f32x4, i32x4>(series) + exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exp_minus_agrees_with_the_library() {
        for i in 0..8000 {
            let x = i as f32 * 0.01;
            let ours = f64::from(exp_minus(f32x4::splat(x)).to_array()[2]);
            let exact = (-f64::from(x)).exp();
            // Half a unit in the last place of x changes exp(-x) by x * 6e-8.
            assert!(
                (ours / exact - 1.0).abs() < 3e-7 + f64::from(x) * 1.2e-7,
                "exp(-{x}): {ours} against {exact}"
            );
        }
        assert!(exp_minus(f32x4::splat(1e30)).to_array()[0] < 1e-30);
    }

    #[test]
    fn cells_lie_below_and_fractions_within() {
        for value in [-3.0_f32, -2.5, -0.1, -1e-9, 0.0, 0.3, 1.0, 1e6 + 0.5] {
            let (cell, fraction) = cell_and_fraction(f32x4::splat(value));
            let expected = (value.floor() as i32 as u32).wrapping_add(CELL_ZERO);
            assert_eq!(cell.to_array()[1], expected, "cell of {value}");
            assert!((0.0..=1.0).contains(&fraction.to_array()[1]), "fraction of {value}");
        }
    }
}
