//! The balls of puffs and their orientation, as in src/renderer/puffs/bake/solids.ts and shaders/lib/orientation.glsl.

use wide::f32x4;

use crate::arrange::deformation::{across, ratio};
use crate::arrange::row_layout::{AGE, Attributes, ROLL, SEED, VARIATION};
use crate::math::scalar::clamped;
use crate::math::simd::LANES;

/// Maximum number of lobes of a puff.
const MAX_LOBES: usize = 12;
/// Maximum number of balls per puff: one for each lobe.
pub const BALLS_LIMIT: usize = MAX_LOBES;
const SEEDS: usize = 256;
/// Entries per revolution of the sine table. The tolerance of the solids covers the error between them.
const SINES: usize = 4096;
/// Rotation of the seed axes about z from one seed to the next.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;
/// See src/base/constants.ts.
const BILLOW_DEPTH: f32 = 0.6;
const BILLOW_DELAY: f32 = 0.5;
const BILLOW_STEP: f32 = 0.618_034;

/// The shapes of puffs. Lengths in particle radii.
#[derive(Clone, Copy, Debug)]
pub struct Solids<'v> {
    /// Per variation the x of all balls, then their y, z and radii. A radius of 0 marks a missing ball.
    table: &'v [f32],
    balls: usize,
    /// True if puffs face the eye and roll about the view axis; false if they are fixed in world space.
    pub faces_eye: bool,
    /// True if the balls, with their centres on the centre plane, are discs that a puff turns to the light.
    pub faces_light: bool,
}

/// The balls of one puff in view space: right, up, towards the eye. If the puff is stretched, balls that its ellipsoids
/// contain.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RotatedBalls {
    groups: [BallGroup; BALLS_LIMIT / LANES],
    /// Number of groups.
    pub count: usize,
    /// Factor on the radii of the balls that contain the ellipsoids.
    pub ratio: f32,
}

/// Four balls. A radius of 0 marks a missing ball.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BallGroup {
    pub x: f32x4,
    pub y: f32x4,
    pub z: f32x4,
    pub radius: f32x4,
}

impl RotatedBalls {
    pub(crate) fn groups(&self) -> &[BallGroup] {
        &self.groups[..self.count]
    }
}

impl<'v> Solids<'v> {
    /// `table` holds 4 * `balls` numbers per variation; `balls` is 4, 8 or 12. `faces`: see `ViewNumbers::faces_eye`.
    pub(crate) fn new(table: &'v [f32], balls: usize, faces: f32) -> Self {
        debug_assert!(balls.is_multiple_of(LANES) && balls <= BALLS_LIMIT && !table.is_empty());
        Self {
            table,
            balls,
            faces_eye: faces != 0.0,
            faces_light: faces == 2.0,
        }
    }

    /// Rotates the puff with these packed attributes by `rotation`.
    #[inline(always)]
    pub(crate) fn rotate(
        &self,
        attributes: Attributes,
        rotation: &[[f32; 3]; 3],
        billow: Option<f32>,
        into: &mut RotatedBalls,
    ) {
        let size = 4 * self.balls;
        let variation = VARIATION.of(attributes) as usize % (self.table.len() / size);
        let columns = &self.table[variation * size..(variation + 1) * size];
        let lanes = |column: usize, at: usize| {
            let start = column * self.balls + at;
            let lanes: &[f32; LANES] = columns[start..start + LANES].try_into().expect("whole blocks");
            f32x4::new(*lanes)
        };
        let billow = billow.filter(|_| !self.faces_eye);
        into.count = self.balls / LANES;
        into.ratio = billow.map_or(1.0, |_| ratio(attributes));
        let across = billow.map_or(1.0, |_| across(into.ratio));
        for (at, group) in into.groups[..into.count].iter_mut().enumerate() {
            let at = at * LANES;
            let (mut x, mut y, mut z) = (lanes(0, at), lanes(1, at), lanes(2, at));
            if let Some(billow) = billow
                && billow > 0.0
            {
                let age = AGE.of(attributes) as f32 / AGE.max as f32;
                let unfolded = unfolded(at, age, billow);
                (x, y, z) = (x * unfolded, y * unfolded, z * unfolded);
            }
            let along = |row: [f32; 3]| x * f32x4::splat(row[0]) + y * f32x4::splat(row[1]) + z * f32x4::splat(row[2]);
            *group = BallGroup {
                x: along(rotation[0]),
                y: along(rotation[1]),
                z: along(rotation[2]),
                radius: match billow {
                    None => lanes(3, at),
                    Some(_) => lanes(3, at) * f32x4::splat(across),
                },
            };
        }
    }
}

/// Factors on the centres of four lobes from `index` on at `age`, a fraction of the lifetime: lobes unfold one after
/// another over the first half of life. As in shaders/lib/orientation.glsl.
#[inline(never)]
fn unfolded(index: usize, age: f32, billow: f32) -> f32x4 {
    let factor = |lane: usize| {
        let phase = ((index + lane) as f32 * BILLOW_STEP).fract();
        let share = clamped((2.0 * age - BILLOW_DELAY * phase) / (1.0 - BILLOW_DELAY), 0.0, 1.0);
        1.0 - BILLOW_DEPTH * billow * (1.0 - share * share * (3.0 - 2.0 * share))
    };
    f32x4::new(std::array::from_fn(factor))
}

/// The sine table, and the rotation axes of the seeds.
#[derive(Debug)]
pub(crate) struct Orientations {
    sines: Box<[f32; SINES]>,
    axes: Box<[[f32; 3]; SEEDS]>,
}

impl Orientations {
    pub(crate) fn new() -> Self {
        let mut orientations = Self {
            sines: Box::new([0.0; SINES]),
            axes: Box::new([[0.0; 3]; SEEDS]),
        };
        for (index, sine) in orientations.sines.iter_mut().enumerate() {
            *sine = libm::sin(index as f64 * std::f64::consts::TAU / SINES as f64) as f32;
        }
        for (seed, axis) in orientations.axes.iter_mut().enumerate() {
            let z = 1.0 - (2.0 * seed as f64 + 1.0) / SEEDS as f64;
            let (reach, angle) = (libm::sqrt(1.0 - z * z), seed as f64 * GOLDEN_ANGLE);
            *axis = [reach * libm::cos(angle), reach * libm::sin(angle), z].map(|component| component as f32);
        }
        orientations
    }

    /// Sine and cosine of the roll in packed attributes.
    #[inline(always)]
    fn roll(&self, attributes: Attributes) -> (f32, f32) {
        let index = (ROLL.of(attributes) as usize * SINES + 0x8000) >> 16;
        (self.sines[index % SINES], self.sines[(index + SINES / 4) % SINES])
    }

    /// Rows of the rotation from a puff's frame to `axes`, for a puff fixed in world space.
    #[inline(always)]
    pub(crate) fn standing(&self, attributes: Attributes, axes: &[[f32; 3]; 3]) -> [[f32; 3]; 3] {
        let (sine, cosine) = self.roll(attributes);
        let axis = self.axes[SEED.of(attributes) as usize];
        axes.map(|row| {
            let across = [
                row[1] * axis[2] - row[2] * axis[1],
                row[2] * axis[0] - row[0] * axis[2],
                row[0] * axis[1] - row[1] * axis[0],
            ];
            let share = (1.0 - cosine) * (row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2]);
            std::array::from_fn(|i| cosine * row[i] + sine * across[i] + share * axis[i])
        })
    }

    /// Same for a puff that faces the eye and rolls, with axes in view space.
    #[inline(always)]
    pub(crate) fn facing(&self, attributes: Attributes, axes_in_view: &[[f32; 3]; 3]) -> [[f32; 3]; 3] {
        let (sine, cosine) = self.roll(attributes);
        axes_in_view.map(|[right, up, back]| [right * cosine + up * sine, up * cosine - right * sine, back])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    }

    #[test]
    fn a_puff_rolls_about_the_axis_of_its_seed() {
        let orientations = Orientations::new();
        let world = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for seed in 0..SEEDS {
            let z = 1.0 - (2.0 * seed as f64 + 1.0) / SEEDS as f64;
            let (reach, angle) = ((1.0 - z * z).sqrt(), seed as f64 * GOLDEN_ANGLE);
            let axis = [reach * angle.cos(), reach * angle.sin(), z];
            let beside = cross(axis, [0.0, 0.6, 0.8]);
            let ahead = cross(axis, beside);
            for roll in [0u32, 4096, 20_000, 65_535] {
                let rows = orientations.standing([roll, (seed as u32) << 8, 0, 0], &world);
                let rotated = |v: [f64; 3]| rows.map(|row| (0..3).map(|i| f64::from(row[i]) * v[i]).sum::<f64>());
                let (sine, cosine) = (f64::from(roll) / 65_536.0 * std::f64::consts::TAU).sin_cos();
                for (i, (along, across)) in rotated(axis).into_iter().zip(rotated(beside)).enumerate() {
                    assert!((along - axis[i]).abs() < 1e-5, "seed {seed}, roll {roll}");
                    let expected = cosine * beside[i] + sine * ahead[i];
                    // Half a step of the sine table.
                    assert!((across - expected).abs() < 1e-3, "seed {seed}, roll {roll}");
                }
            }
        }
    }
}
