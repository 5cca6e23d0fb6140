//! Turbulence: small irregular swirls.
//!
//! Space is cut into cubes with sides of `turbulence.scale` (m). Each corner c of the lattice has a hashed vector v,
//! and with the place relative to the corner d, measured in cubes, the potential is A = sum over the eight corners of
//! w(d) (v x d) / 2, with w(d) = s(|d.x|) s(|d.y|) s(|d.z|) and s the quintic that falls from 1 to 0. Its curl,
//!
//! u = sum of v (w + g.d) - d (g.v),  g = grad w / 2,
//!
//! is free of divergence by construction, smooth, costs one hash a corner and needs no differences. It is v at the
//! corner itself, so nothing stands still there, as it would with the curl of value noise. After Bridson, Hourihan and
//! Nordenstam, "Curl-Noise for Procedural Fluid Flow", SIGGRAPH 2007; the local potential v x d / 2 is ours.
//!
//! Each octave has half the size of the one before and 0.6 times its speed; `turbulence.octaves` 0..4 of them together
//! have the root mean square speed `turbulence.speed` (m/s) times `forces.turbulence`. The pattern changes because
//! v = a cos(p) + b sin(p) with two hashed vectors a, b, and p grows by `turbulence.evolution` (rad/s), 1.5 times as
//! fast in each next octave: after a quarter turn nothing is left of the old pattern, while the speed stays the same.
//! The wind carries the pattern along.

use wide::bytemuck::cast;
use wide::{f32x4, i32x4, u32x4};

use crate::parameters::Parameters;
use crate::simd::{Vector4, cell_and_fraction};

/// Most octaves.
pub const OCTAVE_LIMIT: usize = 4;

const OCTAVE_SPEED: f64 = 0.6;
const OCTAVE_PACE: f64 = 1.5;
const STRIDE: [u32; 3] = [0x8da6_b343, 0xd816_3841, 0xcb1a_b31f];
/// Hashed components are uniform from -2^31 to 2^31: this is the mean of their squares.
const COMPONENT_VARIANCE: f64 = 4_611_686_018_427_387_904.0 / 3.0;
/// Mean over a cube of |u|^2 where the components of v have variance 1, from the formula above.
const CUBE_VARIANCE: f64 = 1.097_421;

/// What turbulence remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurbulenceState {
    /// How far the wind has carried the pattern (m).
    pub drift: [f64; 3],
    /// p of the first octave (rad).
    pub phase: f64,
}

impl TurbulenceState {
    /// Moves the pattern on by `dt` seconds.
    pub fn advance(&mut self, parameters: &Parameters, dt: f64) {
        for (drift, wind) in self.drift.iter_mut().zip(parameters.forces.wind) {
            *drift += wind * dt;
        }
        self.phase += parameters.turbulence.evolution * dt;
    }
}

/// The field of one step.
#[derive(Clone, Copy, Debug)]
pub struct Turbulence {
    octaves: [Octave; OCTAVE_LIMIT],
    len: usize,
}

#[derive(Clone, Copy, Debug)]
struct Octave {
    /// Cubes in a metre.
    frequency: f32x4,
    /// Part of a cube by which the pattern has drifted.
    fraction: Vector4,
    /// Whole cubes of drift and the seed, as one number that is added to each hash.
    key: u32x4,
    /// Factors on the two hashed vectors.
    cosine: f32x4,
    sine: f32x4,
    is_still: bool,
}

impl Turbulence {
    /// The field that `parameters` describe; without octaves or speed it is empty.
    pub fn new(parameters: &Parameters, state: &TurbulenceState, seed: u32) -> Self {
        let speed = parameters.turbulence.speed * parameters.forces.turbulence;
        let len = if speed > 0.0 {
            parameters.turbulence.octaves as usize
        } else {
            0
        };
        let total: f64 = (0..len)
            .map(|octave| libm::pow(OCTAVE_SPEED, 2.0 * octave as f64))
            .sum();
        let first = speed / libm::sqrt(total.max(1.0) * COMPONENT_VARIANCE * CUBE_VARIANCE);
        let octaves = std::array::from_fn(|octave| Octave::new(parameters, state, seed, octave, first));
        Self { octaves, len }
    }

    /// Whether the air is smooth.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Velocity (m/s) at four places.
    #[inline(always)]
    pub fn velocity(&self, place: Vector4) -> Vector4 {
        let mut sum = Vector4::zero();
        for octave in &self.octaves[..self.len] {
            sum += if octave.is_still {
                octave.velocity::<false>(place)
            } else {
                octave.velocity::<true>(place)
            };
        }
        sum
    }
}

/// Of one axis, for the corner below and the one above: weight, half its slope, slope times the way from the corner,
/// and the sum of weight and that product.
struct Axis {
    fraction: f32x4,
    weight: [f32x4; 2],
    slope: [f32x4; 2],
    product: [f32x4; 2],
    sum: [f32x4; 2],
}

impl Axis {
    #[inline(always)]
    fn new(fraction: f32x4) -> Self {
        let rest = f32x4::ONE - fraction;
        let square = fraction * fraction;
        let upper = square * fraction * (fraction * (fraction * 6.0 - 15.0) + 10.0);
        let slope = square * rest * rest * 15.0;
        let (weight, product) = ([f32x4::ONE - upper, upper], [-slope * fraction, -slope * rest]);
        Self {
            fraction,
            weight,
            slope: [-slope, slope],
            product,
            sum: [weight[0] + product[0], weight[1] + product[1]],
        }
    }
}

/// Factors of the four edges of a cube along x, for the one at corner `j` of y and `k` of z.
struct Edge {
    weight: f32x4,
    slope_y: f32x4,
    slope_z: f32x4,
    product: f32x4,
}

impl Edge {
    #[inline(always)]
    fn new(y: &Axis, z: &Axis, j: usize, k: usize) -> Self {
        Self {
            weight: y.weight[j] * z.weight[k],
            slope_y: y.slope[j] * z.weight[k],
            slope_z: y.weight[j] * z.slope[k],
            product: y.product[j] * z.weight[k] + y.weight[j] * z.product[k],
        }
    }

    /// Of the corner `i` of x with the vector `v`: adds v (w + g.d) to `flow` and returns g.v.
    #[inline(always)]
    fn corner(&self, x: &Axis, i: usize, v: Vector4, flow: &mut Vector4) -> f32x4 {
        *flow += v * (self.weight * x.sum[i] + x.weight[i] * self.product);
        x.slope[i] * (self.weight * v.x) + x.weight[i] * (self.slope_y * v.y + self.slope_z * v.z)
    }
}

impl Octave {
    fn new(parameters: &Parameters, state: &TurbulenceState, seed: u32, octave: usize, first: f64) -> Self {
        let number = octave as f64;
        let frequency = libm::pow(2.0, number) / parameters.turbulence.scale;
        // The shift keeps the corners of the octaves, and the world's origin, from falling on each other.
        let drift = state.drift.map(|metres| metres * frequency + 0.37 * (number + 1.0));
        let (sine, cosine) = libm::sincos(state.phase * libm::pow(OCTAVE_PACE, number));
        let amplitude = first * libm::pow(OCTAVE_SPEED, number);
        let splat = |value: f64| f32x4::splat(value as f32);
        Self {
            frequency: splat(frequency),
            fraction: Vector4::splat(drift.map(|cubes| (cubes - libm::floor(cubes)) as f32)),
            key: u32x4::splat(key(drift, seed, octave as u32)),
            cosine: splat(cosine * amplitude),
            sine: splat(sine * amplitude),
            is_still: sine == 0.0,
        }
    }

    #[inline(always)]
    fn velocity<const EVOLVES: bool>(&self, place: Vector4) -> Vector4 {
        let in_cubes = place * self.frequency - self.fraction;
        let (cell_x, fraction_x) = cell_and_fraction(in_cubes.x);
        let (cell_y, fraction_y) = cell_and_fraction(in_cubes.y);
        let (cell_z, fraction_z) = cell_and_fraction(in_cubes.z);
        let hash = self.key + strides(cell_x, 0) + strides(cell_y, 1) + strides(cell_z, 2);
        let (x, y, z) = (Axis::new(fraction_x), Axis::new(fraction_y), Axis::new(fraction_z));
        let mut flow = Vector4::zero();
        let mut edge = |j: usize, k: usize| {
            let edge = Edge::new(&y, &z, j, k);
            let mut corner = |i: usize| edge.corner(&x, i, self.vector::<EVOLVES>(hash, [i, j, k]), &mut flow);
            [corner(0), corner(1)]
        };
        // Written out: a loop would not be unrolled, and the tables of the axes would go through memory.
        let (a, b, c, d) = (edge(0, 0), edge(1, 0), edge(0, 1), edge(1, 1));
        // The sum of d (g.v): the way from the upper corner is the one from the lower less 1.
        let (upper_x, lower_x) = (a[1] + b[1] + c[1] + d[1], a[0] + b[0] + c[0] + d[0]);
        let (upper_y, upper_z) = (b[0] + b[1] + d[0] + d[1], c[0] + c[1] + d[0] + d[1]);
        let all = upper_x + lower_x;
        let back = Vector4 {
            x: x.fraction * all - upper_x,
            y: y.fraction * all - upper_y,
            z: z.fraction * all - upper_z,
        };
        flow - back
    }

    /// The vector of a corner of the cube whose lowest corner has the hash `lowest`.
    ///
    /// Its components are the mixed bits read as integers from bit 31, 20 and 9 downwards; what stands below the first
    /// ten bits of each is only fine detail. The second vector is the first with its components exchanged in turn,
    /// and with a random sign, without which all corners would turn the same way.
    #[inline(always)]
    fn vector<const EVOLVES: bool>(&self, lowest: u32x4, corner: [usize; 3]) -> Vector4 {
        let step = corner
            .iter()
            .zip(STRIDE)
            .fold(0_u32, |sum, (n, stride)| sum.wrapping_add(*n as u32 * stride));
        let bits = mix(lowest + u32x4::splat(step));
        let (x, y, z) = (from_bits(bits), from_bits(bits << 11), from_bits(bits << 22));
        if !EVOLVES {
            return Vector4 { x, y, z } * self.cosine;
        }
        let sign: f32x4 = cast((bits << 19) & u32x4::splat(1 << 31));
        let sine = self.sine ^ sign;
        Vector4 {
            x: x * self.cosine + y * sine,
            y: y * self.cosine + z * sine,
            z: z * self.cosine + x * sine,
        }
    }
}

#[inline(always)]
fn from_bits(bits: u32x4) -> f32x4 {
    f32x4::from_i32x4(cast(bits))
}

#[inline(always)]
fn strides(cell: i32x4, axis: usize) -> u32x4 {
    cast::<i32x4, u32x4>(cell) * u32x4::splat(STRIDE[axis])
}

/// A multiplication carries upwards only: the shifts before and after it bring the high bits down.
#[inline(always)]
fn mix(hash: u32x4) -> u32x4 {
    let carried = (hash ^ (hash >> 15)) * u32x4::splat(0x2c1b_3c6d);
    carried ^ (carried >> 15)
}

fn key(drift: [f64; 3], seed: u32, octave: u32) -> u32 {
    let of_seed = seed.wrapping_mul(0x9e37_79b9) ^ octave.wrapping_mul(0x85eb_ca6b);
    drift.iter().zip(STRIDE).fold(of_seed, |sum, (cubes, stride)| {
        let whole = libm::floor(*cubes) as i64 as u32;
        sum.wrapping_sub(whole.wrapping_mul(stride))
    })
}
