//! One octave of turbulence: a random flow, free of divergence by construction.
//!
//! Space is divided into equal tetrahedra with corners on a body-centred cubic lattice, as in simplex noise. The axes
//! are skewed by s(x) = x + (x.x + x.y + x.z) / 3, so that corners have whole coordinates: the cell below gives the
//! first corner, the order of the three fractions the path from there to the last one. After Perlin, "Noise hardware",
//! SIGGRAPH 2001 course notes; Gustavson, "Simplex noise demystified", 2005.
//!
//! With d from a corner to the place, in units in which a corner is sqrt(3) from the opposite face, the corner's hashed
//! vector v, its weight t = max(0, 3 - d.d), and e = 1 on one of the two cubic lattices, -1 on the other, the potential
//! is
//!
//! A = sum over the corners of t^3 (v x d / 12 - e v / 6).
//!
//! The first part circulates around the corner's vector like a vortex ring, the second rotates about it. Their curls,
//! from curl(f v x d) = grad f x (v x d) + 2 f v, curl(g v) = grad g x v and grad t = -2 d, are
//!
//! u = sum of t^2 (v (1/2 - 2/3 d.d) + d (d.v) / 2 + e d x v).
//!
//! As a curl, u is free of divergence. A weight ends at the opposite face, so nothing is cut off between tetrahedra;
//! t^2 ends with slope 0, so u has continuous first derivatives. Four corners with one hash each are the minimum of any
//! subdivision. Rings alone are strong near corners, where rotations vanish. The relative strength of the two makes the
//! root mean square speed even, within a factor of 1.39 between any two places of a tetrahedron (2.4 with rings on
//! cubes). The two signs e cancel any handedness. After Bridson, Hourihan and Nordenstam, "Curl-Noise for Procedural
//! Fluid Flow", SIGGRAPH 2007; the local potential is ours.
//!
//! A component of v is a triangle wave of its hashed phase plus the octave's phase. The phases are uniform at any time,
//! so the speed is constant; after a quarter of the period nothing remains of the old pattern.

use std::f64::consts::TAU;

use wide::bytemuck::cast;
use wide::{f32x4, u32x4};

use crate::math::simd::{CELL_ZERO, Vector4, cell_and_fraction, positive_part, splat};

/// Lattice cells per `turbulence.scale`. Makes the ratio of vorticity to speed equal to that of Perlin's quintic noise
/// on cubes of that scale.
pub const CELLS: f64 = 0.765;

const STRIDE: [u32; 3] = [0x8da6_b343, 0xd816_3841, 0xcb1a_b31f];
/// Mean square of hashed components, which are uniform in -2^30..2^30.
const COMPONENT_VARIANCE: f64 = 1_152_921_504_606_846_976.0 / 3.0;
/// Spatial mean of |u|^2 for components of v of variance 1, from the formula above.
const CELL_VARIANCE: f64 = 46.017_793;
/// Cell size in the units of d: the square root of 6.
const SIDE: f32 = 2.449_489_7;
/// Squared reach of a corner, in the units of d.
const REACH_SQUARED: f32 = 3.0;

/// The flow in one step.
#[derive(Clone, Copy, Debug)]
pub struct Octave {
    /// Cells per metre.
    frequency: f32x4,
    /// Fractional drift of the pattern in cells, on skewed axes.
    fraction: Vector4,
    /// Whole cells of drift and the seed, combined to one number that is added to each hash.
    key: u32x4,
    /// Sum of the whole cells of drift over all axes.
    parity: u32x4,
    /// Phase of the vectors, with the period 2^32.
    phase: u32x4,
    /// Speed (m/s) per unit of the hashed vectors.
    amplitude: f32x4,
}

/// Sums over the corners of a tetrahedron: rings, and rotations of the lattices e = 1 and e = -1.
struct Sums {
    ring: Vector4,
    swirl: [Vector4; 2],
}

impl Octave {
    /// Octave `number` with vortices of size `scale` (m) and root mean square `speed` (m/s), displaced by `drift` (m).
    /// `phase` (rad) evolves the pattern.
    pub fn new(number: u32, scale: f64, speed: f64, drift: [f64; 3], phase: f64, seed: u32) -> Self {
        let frequency = CELLS / scale;
        // The shift keeps the lattices of the octaves, and the world's origin, apart.
        let shift = 0.37 * (f64::from(number) + 1.0);
        let drift = skewed(drift.map(|metres| metres * frequency)).map(|cells| cells + shift);
        let whole = drift.map(|cells| libm::floor(cells) as i64 as u32);
        let turns = phase / TAU;
        Self {
            frequency: splat(frequency),
            fraction: Vector4::splat(drift.map(|cells| (cells - libm::floor(cells)) as f32)),
            key: u32x4::splat(key(whole, seed ^ number.wrapping_mul(0x85eb_ca6b))),
            parity: u32x4::splat(whole.iter().fold(0_u32, |sum, cells| sum.wrapping_sub(*cells))),
            phase: u32x4::splat(((turns - libm::floor(turns)) * 4_294_967_296.0) as u64 as u32),
            amplitude: splat(speed / libm::sqrt(COMPONENT_VARIANCE * CELL_VARIANCE)),
        }
    }

    /// Adds the velocity (m/s) at `places`, times `weight`, to `flow`.
    pub fn add(&self, places: &[Vector4], weight: &[f32x4], flow: &mut [Vector4]) {
        for ((flow, place), weight) in flow.iter_mut().zip(places).zip(weight) {
            *flow += self.flow(*place) * (self.amplitude * *weight);
        }
    }

    #[inline(always)]
    fn flow(&self, place: Vector4) -> Vector4 {
        let skew = (place.x + place.y + place.z) * f32x4::splat(1.0 / 3.0);
        let cells = (place + Vector4::diagonal(skew)) * self.frequency - self.fraction;
        let (cell_x, x) = cell_and_fraction(cells.x);
        let (cell_y, y) = cell_and_fraction(cells.y);
        let (cell_z, z) = cell_and_fraction(cells.z);
        let lowest = self.key + strided(cell_x, 0) + strided(cell_y, 1) + strided(cell_z, 2);
        let odd = (cell_x + cell_y + cell_z + self.parity) << 31;
        let sums = self.corners(Vector4 { x, y, z }, lowest);
        sums.ring + (sums.swirl[0] - sums.swirl[1]).negated_where(odd)
    }

    /// Sums over the tetrahedron that contains `fraction`, in the cube whose lowest corner has the hash `lowest`. The
    /// second corner is one step along the axis of the largest fraction, the third lacks the step along the axis of the
    /// smallest.
    #[inline(always)]
    fn corners(&self, fraction: Vector4, lowest: u32x4) -> Sums {
        let Vector4 { x, y, z } = fraction;
        let (xy, yz, xz) = (x.simd_ge(y), y.simd_ge(z), x.simd_ge(z));
        let greatest = [xy & xz, yz & !xy, !(xz | yz)];
        let least = [!(xy | xz), xy & !yz, xz & yz];
        let straight = |skewed: f32x4| Vector4::diagonal(skewed * f32x4::splat(SIDE / 6.0));
        let first = fraction * f32x4::splat(SIDE) - straight(x + y + z);
        let highest = lowest + u32x4::splat(STRIDE[0].wrapping_add(STRIDE[1]).wrapping_add(STRIDE[2]));
        let mut sums = Sums {
            ring: Vector4::zero(),
            swirl: [Vector4::zero(); 2],
        };
        self.corner(first, lowest, 0, &mut sums);
        let second = first + straight(f32x4::ONE) - step(greatest);
        self.corner(second, lowest + stride(greatest), 1, &mut sums);
        let last = first - straight(f32x4::splat(3.0));
        let third = last - straight(f32x4::ONE) + step(least);
        self.corner(third, highest - stride(least), 0, &mut sums);
        self.corner(last, highest, 1, &mut sums);
        sums
    }

    /// Adds the corner with the hash `hash`; `d` is the vector from it to the place.
    #[inline(always)]
    fn corner(&self, d: Vector4, hash: u32x4, lattice: usize, sums: &mut Sums) {
        let squared = d.dot(d);
        let t = positive_part(f32x4::splat(REACH_SQUARED) - squared);
        let v = self.vector(hash) * (t * t);
        let along = d.dot(v) * f32x4::HALF;
        sums.ring += v * (f32x4::HALF - squared * f32x4::splat(2.0 / 3.0)) + d * along;
        sums.swirl[lattice] += d.cross(v);
    }

    /// The vector of a corner. Its components are the mixed bits from bit 31, 20 and 9 downwards; bits below the first
    /// ten of each only add detail.
    #[inline(always)]
    fn vector(&self, hash: u32x4) -> Vector4 {
        let bits = mix(hash);
        let wave = |bits: u32x4| {
            let saw = f32x4::from_i32x4(cast(bits + self.phase));
            saw.abs() - f32x4::splat(1_073_741_824.0)
        };
        Vector4 {
            x: wave(bits),
            y: wave(bits << 11),
            z: wave(bits << 22),
        }
    }
}

/// One step on skewed axes along the `chosen` one, in the units of d, without the part common to all axes.
#[inline(always)]
fn step(chosen: [f32x4; 3]) -> Vector4 {
    let side = f32x4::splat(SIDE);
    Vector4 {
        x: chosen[0] & side,
        y: chosen[1] & side,
        z: chosen[2] & side,
    }
}

/// Hash difference of one step along the `chosen` axis.
#[inline(always)]
fn stride(chosen: [f32x4; 3]) -> u32x4 {
    let of = |axis: usize| cast::<f32x4, u32x4>(chosen[axis]) & u32x4::splat(STRIDE[axis]);
    of(0) | of(1) | of(2)
}

#[inline(always)]
fn strided(cell: u32x4, axis: usize) -> u32x4 {
    cell * u32x4::splat(STRIDE[axis])
}

/// A multiplication carries only upwards: the shifts before and after it bring high bits down.
#[inline(always)]
fn mix(hash: u32x4) -> u32x4 {
    let carried = (hash ^ (hash >> 15)) * u32x4::splat(0x2c1b_3c6d);
    carried ^ (carried >> 15)
}

fn skewed(place: [f64; 3]) -> [f64; 3] {
    let skew = (place[0] + place[1] + place[2]) / 3.0;
    place.map(|component| component + skew)
}

fn key(whole: [u32; 3], seed: u32) -> u32 {
    let of_seed = seed.wrapping_mul(0x9e37_79b9);
    whole.iter().zip(STRIDE).fold(of_seed, |sum, (cells, stride)| {
        sum.wrapping_sub(cells.wrapping_add(CELL_ZERO).wrapping_mul(stride))
    })
}
