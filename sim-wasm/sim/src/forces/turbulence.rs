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
//! The wind of `forces.wind.*` carries the pattern along. `turbulence.*` acts everywhere, `turbulences.#.*` add to it, each
//! in its region.

use wide::bytemuck::cast;
use wide::{f32x4, i32x4, u32x4};

use super::{Force, Setting, Stage};
use crate::parameters::field::{Field, number};
use crate::parameters::section::Item;
use crate::parameters::{LIST_LIMIT, Parameters};
use crate::scope::{Reach, Scope};
use crate::simd::{Vector4, cell_and_fraction};
use crate::tile::{Columns, Tile};

/// Most octaves.
pub const OCTAVE_LIMIT: usize = 4;

const OCTAVE_SPEED: f64 = 0.6;
const OCTAVE_PACE: f64 = 1.5;
const STRIDE: [u32; 3] = [0x8da6_b343, 0xd816_3841, 0xcb1a_b31f];
/// Hashed components are uniform from -2^31 to 2^31: this is the mean of their squares.
const COMPONENT_VARIANCE: f64 = 4_611_686_018_427_387_904.0 / 3.0;
/// Mean over a cube of |u|^2 where the components of v have variance 1, from the formula above.
const CUBE_VARIANCE: f64 = 1.097_421;

/// `turbulence.*`: the swirls that are everywhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pattern {
    pub speed: f64,
    pub scale: f64,
    pub octaves: f64,
    pub evolution: f64,
}

impl Item for Pattern {
    const FIELDS: &'static [Field<Self>] = &[
        number("speed", "m/s", [0.0, 20.0], 0.0, |t: &mut Self| &mut t.speed),
        number("scale", "m", [0.05, 100.0], 1.0, |t: &mut Self| &mut t.scale),
        number("octaves", "1", [0.0, 4.0], 1.0, |t: &mut Self| &mut t.octaves).whole(),
        number("evolution", "1/s", [0.0, 10.0], 0.3, |t: &mut Self| &mut t.evolution),
    ];
}

/// `turbulences.#.*`: swirls in a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turbulence {
    pub pattern: Pattern,
    pub scope: Scope,
}

impl Item for Turbulence {
    const FIELDS: &'static [Field<Self>] = &[
        number("speed", "m/s", [0.0, 20.0], 0.0, |t: &mut Self| &mut t.pattern.speed).says(
            "Speed",
            "Typical (root mean square) speed of the swirls; 0 takes this turbulence away.",
        ),
        number("scale", "m", [0.05, 100.0], 1.0, |t: &mut Self| &mut t.pattern.scale)
            .says("Scale", "Size of the largest swirls."),
        number("octaves", "1", [0.0, 4.0], 1.0, |t: &mut Self| &mut t.pattern.octaves)
            .whole()
            .says("Octaves", "How many finer layers of swirls are added; 0 is still air."),
        number("evolution", "1/s", [0.0, 10.0], 0.3, |t: &mut Self| {
            &mut t.pattern.evolution
        })
        .says("Evolution", "How fast the pattern of swirls changes."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}

/// What a turbulence remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurbulenceState {
    /// How far the wind has carried the pattern (m).
    pub drift: [f64; 3],
    /// p of the first octave (rad).
    pub phase: f64,
}

/// Moves all patterns on by `dt` seconds: those of the list, then the one that is everywhere.
pub fn advance(states: &mut [TurbulenceState; LIST_LIMIT + 1], parameters: &Parameters, dt: f64) {
    let listed = parameters.lists.turbulences.items().iter();
    for (state, turbulence) in states.iter_mut().zip(listed) {
        state.advance(&turbulence.pattern, parameters, dt);
    }
    states[LIST_LIMIT].advance(&parameters.turbulence, parameters, dt);
}

impl TurbulenceState {
    fn advance(&mut self, pattern: &Pattern, parameters: &Parameters, dt: f64) {
        for (drift, wind) in self.drift.iter_mut().zip(parameters.forces.wind) {
            *drift += wind * dt;
        }
        self.phase += pattern.evolution * dt;
    }
}

impl Force for Turbulence {
    type Kernel = Kernel;
    const STAGE: Stage = Stage::Air;

    fn kernel(&self, index: usize, setting: &Setting) -> Option<Kernel> {
        let swirls = Swirls::of_setting(&self.pattern, setting, index)?;
        let reach = Some(Reach::new(&self.scope, &setting.now)?);
        Some(Kernel { swirls, reach })
    }

    fn everywhere(setting: &Setting) -> Option<Kernel> {
        let swirls = Swirls::of_setting(&setting.parameters.turbulence, setting, LIST_LIMIT)?;
        Some(Kernel { swirls, reach: None })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let Columns {
            ahead, flow, weight, ..
        } = tile.columns();
        for kernel in kernels {
            match &kernel.reach {
                Some(reach) => reach.weigh(ahead, weight),
                None => weight.fill(f32x4::ONE),
            }
            for octave in &kernel.swirls.octaves[..kernel.swirls.len] {
                octave.act(ahead, weight, flow);
            }
        }
    }
}

/// A turbulence of one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    swirls: Swirls,
    reach: Option<Reach>,
}

/// The field of one step.
#[derive(Clone, Copy, Debug)]
pub struct Swirls {
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

impl Swirls {
    /// The field of `pattern`, its speed multiplied by `strength`; none without octaves or speed.
    pub fn new(pattern: &Pattern, strength: f64, state: &TurbulenceState, seed: u32) -> Option<Self> {
        let speed = pattern.speed * strength;
        let len = pattern.octaves as usize;
        if len == 0 || speed <= 0.0 {
            return None;
        }
        let total: f64 = (0..len)
            .map(|octave| libm::pow(OCTAVE_SPEED, 2.0 * octave as f64))
            .sum();
        let first = speed / libm::sqrt(total * COMPONENT_VARIANCE * CUBE_VARIANCE);
        let octaves = std::array::from_fn(|octave| Octave::new(pattern.scale, state, seed, octave, first));
        Some(Self { octaves, len })
    }

    /// Number `index` of all turbulences of a simulation.
    fn of_setting(pattern: &Pattern, setting: &Setting, index: usize) -> Option<Self> {
        // The one that is everywhere keeps the seed as it is.
        let number = (index + 1) % (LIST_LIMIT + 1);
        let seed = setting.seed ^ (number as u32).wrapping_mul(0xc2b2_ae35);
        let strength = setting.parameters.forces.turbulence;
        Self::new(pattern, strength, &setting.turbulence[index], seed)
    }

    /// Velocity (m/s) at four places.
    pub fn velocity(&self, place: Vector4) -> Vector4 {
        let mut flow = [Vector4::zero()];
        for octave in &self.octaves[..self.len] {
            octave.act(&[place], &[f32x4::ONE], &mut flow);
        }
        flow[0]
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
    fn new(scale: f64, state: &TurbulenceState, seed: u32, octave: usize, first: f64) -> Self {
        let number = octave as f64;
        let frequency = libm::pow(2.0, number) / scale;
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

    fn act(&self, ahead: &[Vector4], weight: &[f32x4], flow: &mut [Vector4]) {
        if self.is_still {
            self.add::<false>(ahead, weight, flow);
        } else {
            self.add::<true>(ahead, weight, flow);
        }
    }

    fn add<const EVOLVES: bool>(&self, ahead: &[Vector4], weight: &[f32x4], flow: &mut [Vector4]) {
        for ((flow, ahead), weight) in flow.iter_mut().zip(ahead).zip(weight) {
            *flow += self.velocity::<EVOLVES>(*ahead) * *weight;
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
