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
/// Hashed components are the 32 numbers from -15.5 to 15.5: this is the mean of their squares.
const COMPONENT_VARIANCE: f64 = 85.25;
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
    /// Factors on the two hashed vectors (m/s); their sum is halved and added, since the numbers lie 0.5 too low.
    cosine: f32x4,
    sine: f32x4,
    centre: f32x4,
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

/// Of one axis, for the corner below and the one above: weight, half its slope, and the way from the corner.
struct Axis {
    weight: [f32x4; 2],
    slope: [f32x4; 2],
    way: [f32x4; 2],
}

impl Axis {
    #[inline(always)]
    fn new(fraction: f32x4) -> Self {
        let rest = f32x4::ONE - fraction;
        let square = fraction * fraction;
        let quintic = square * fraction * (fraction * (fraction * 6.0 - 15.0) + 10.0);
        let slope = square * rest * rest * 15.0;
        Self {
            weight: [f32x4::ONE - quintic, quintic],
            slope: [-slope, slope],
            way: [fraction, -rest],
        }
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
            centre: splat((cosine + sine) * amplitude * 0.5),
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
        let mut sum = Vector4::zero();
        for corner in 0..8_u32 {
            let [i, j, k] = [corner & 1, corner >> 1 & 1, corner >> 2];
            let step = [i, j, k]
                .iter()
                .zip(STRIDE)
                .fold(0_u32, |sum, (n, stride)| sum.wrapping_add(n * stride));
            let v = self.corner_vector::<EVOLVES>(mix(hash + u32x4::splat(step)));
            sum += corner_velocity([&x, &y, &z], [i as usize, j as usize, k as usize], v);
        }
        sum
    }

    /// The vector of a corner from six numbers of five bits each.
    #[inline(always)]
    fn corner_vector<const EVOLVES: bool>(&self, bits: i32x4) -> Vector4 {
        let number = |left: i32| f32x4::from_i32x4((bits << left) >> 27);
        let blend = |a: i32, b: i32| {
            let still = number(a) * self.cosine + self.centre;
            if EVOLVES { still + number(b) * self.sine } else { still }
        };
        Vector4 {
            x: blend(0, 15),
            y: blend(5, 20),
            z: blend(10, 25),
        }
    }
}

/// One corner's share of the velocity, by the formula at the head of this file.
#[inline(always)]
fn corner_velocity([x, y, z]: [&Axis; 3], [i, j, k]: [usize; 3], v: Vector4) -> Vector4 {
    let (weight_xy, weight_yz) = (x.weight[i] * y.weight[j], y.weight[j] * z.weight[k]);
    let slope = Vector4 {
        x: x.slope[i] * weight_yz,
        y: x.weight[i] * y.slope[j] * z.weight[k],
        z: weight_xy * z.slope[k],
    };
    let way = Vector4 {
        x: x.way[i],
        y: y.way[j],
        z: z.way[k],
    };
    v * (weight_xy * z.weight[k] + slope.dot(way)) - way * slope.dot(v)
}

#[inline(always)]
fn strides(cell: i32x4, axis: usize) -> u32x4 {
    cast::<i32x4, u32x4>(cell) * u32x4::splat(STRIDE[axis])
}

/// The high 30 bits are well mixed: a multiplication carries upwards, the shift before brings the high bits down.
#[inline(always)]
fn mix(hash: u32x4) -> i32x4 {
    let folded = (hash ^ (hash >> 15)) * u32x4::splat(0x2c1b_3c6d);
    cast((folded ^ (folded >> 13)) * u32x4::splat(0x297a_2d39))
}

fn key(drift: [f64; 3], seed: u32, octave: u32) -> u32 {
    let of_seed = seed.wrapping_mul(0x9e37_79b9) ^ octave.wrapping_mul(0x85eb_ca6b);
    drift.iter().zip(STRIDE).fold(of_seed, |sum, (cubes, stride)| {
        let whole = libm::floor(*cubes) as i64 as u32;
        sum.wrapping_sub(whole.wrapping_mul(stride))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn parameters(octaves: f64, evolution: f64) -> Parameters {
        let mut parameters = Parameters::default();
        for (key, value) in [
            ("speed", 2.0),
            ("scale", 0.8),
            ("octaves", octaves),
            ("evolution", evolution),
        ] {
            parameters.set(&format!("turbulence.{key}"), value).unwrap();
        }
        parameters
    }

    fn field(octaves: f64, phase: f64) -> Turbulence {
        let state = TurbulenceState { drift: [0.0; 3], phase };
        Turbulence::new(&parameters(octaves, 0.0), &state, 5)
    }

    fn places(count: usize) -> impl Iterator<Item = [f32; 3]> {
        let mut random = Random::new(3);
        (0..count).map(move |_| std::array::from_fn(|_| random.signed() * 20.0))
    }

    fn at(field: &Turbulence, place: [f32; 3]) -> [f64; 3] {
        field.velocity(Vector4::splat(place)).first().map(f64::from)
    }

    /// Central difference of component `of` along `along`; the step is a power of two, so that places are exact.
    fn slope(field: &Turbulence, place: [f32; 3], of: usize, along: usize) -> f64 {
        const STEP: f32 = 1.0 / 512.0;
        let place = place.map(|component| (component * 512.0).round() / 512.0);
        let moved = |sign: f32| std::array::from_fn(|i| if i == along { place[i] + sign * STEP } else { place[i] });
        (at(field, moved(1.0))[of] - at(field, moved(-1.0))[of]) / f64::from(2.0 * STEP)
    }

    #[test]
    fn divergence_is_zero_and_vorticity_is_not() {
        for phase in [0.0, 0.8] {
            let field = field(1.0, phase);
            let (mut divergence, mut gradient) = (0.0, 0.0);
            for place in places(2000) {
                let diagonal: [f64; 3] = std::array::from_fn(|i| slope(&field, place, i, i));
                divergence += diagonal.iter().sum::<f64>().powi(2);
                gradient += diagonal.iter().map(|slope| slope * slope).sum::<f64>();
            }
            let share = (divergence / gradient).sqrt();
            assert!(
                gradient > 1000.0 && share < 2e-3,
                "phase {phase}: divergence is {share} of the gradient"
            );
        }
    }

    #[test]
    fn speed_is_the_root_mean_square_whatever_octaves_and_phase() {
        for (octaves, phase) in [(1.0, 0.0), (1.0, 0.8), (2.0, 1.6), (4.0, 2.9)] {
            let field = field(octaves, phase);
            let mean: f64 = places(20_000)
                .map(|place| at(&field, place).map(|u| u * u).iter().sum::<f64>())
                .sum();
            let speed = (mean / 20_000.0).sqrt();
            assert!((speed - 2.0).abs() < 0.08, "octaves {octaves}, phase {phase}: {speed}");
        }
    }

    #[test]
    fn no_direction_is_favoured() {
        let field = field(1.0, 0.4);
        let mut mean = [0.0; 3];
        for place in places(20_000) {
            let velocity = at(&field, place);
            mean.iter_mut().zip(velocity).for_each(|(sum, u)| *sum += u / 20_000.0);
        }
        assert!(mean.iter().all(|component| component.abs() < 0.06), "{mean:?}");
    }

    #[test]
    fn velocity_is_continuous_across_cubes() {
        let field = field(1.0, 0.4);
        for place in places(500) {
            let edge = [((place[0] / 0.8).floor() + 0.37) * 0.8, place[1], place[2]];
            let beside = |sign: f32| at(&field, [edge[0] + sign * 2e-5, edge[1], edge[2]]);
            let (left, right) = (beside(-1.0), beside(1.0));
            let jump = left.iter().zip(right).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(jump < 2e-3, "a jump of {jump} at {edge:?}");
        }
    }

    #[test]
    fn a_quarter_turn_of_the_phase_forgets_the_pattern() {
        let (early, late) = (field(1.0, 0.0), field(1.0, std::f64::consts::FRAC_PI_2));
        let product = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mean: f64 = places(20_000)
            .map(|place| product(at(&early, place), at(&late, place)))
            .sum::<f64>()
            / 20_000.0;
        assert!(mean.abs() < 0.1 * 4.0, "correlation {mean}");
    }

    #[test]
    fn wind_carries_the_pattern_along() {
        let mut parameters = parameters(2.0, 0.0);
        parameters.set("forces.wind.x", 3.0).unwrap();
        let (mut state, still) = (
            TurbulenceState::default(),
            Turbulence::new(&parameters, &TurbulenceState::default(), 5),
        );
        state.advance(&parameters, 2.5);
        let moved = Turbulence::new(&parameters, &state, 5);
        for place in places(200) {
            let (before, after) = (at(&still, place), at(&moved, [place[0] + 7.5, place[1], place[2]]));
            let difference = before.iter().zip(after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(difference < 1e-3, "at {place:?}: {before:?} and {after:?}");
        }
    }
}
