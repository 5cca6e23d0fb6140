//! The starts of a puff's shadow, by the direction of the light, as tabulated in src/renderer/puffs/bake/startCaps.ts.

use std::f32::consts::{FRAC_PI_2, PI};

use wide::f32x4;

use crate::arrange::coverage::solids::{BallGroup, RotatedBalls};
use crate::arrange::row_layout::{Attributes, VARIATION};
use crate::math::scalar::{greater, lesser};

/// Azimuths and polar angles of a variation's table.
const CAP_COLUMNS: usize = 64;
const CAP_ROWS: usize = 32;
/// Entries per variation.
pub(crate) const ENTRIES: usize = CAP_COLUMNS * CAP_ROWS;
/// Tolerance of a direction in cells: the error of the sine table and of the short series.
const DOUBT: f32 = 0.03;

/// Tables of all variations. Without tables the range applies to each.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StartCaps<'v> {
    table: &'v [f32],
    /// Minimum and maximum distance behind the centre (radii).
    pub range: [f32; 2],
}

impl<'v> StartCaps<'v> {
    pub(crate) fn new(table: &'v [f32], range: [f32; 2]) -> Self {
        debug_assert!(table.len().is_multiple_of(ENTRIES));
        Self { table, range }
    }

    /// The same for a deformed puff: the farthest lit point of a lobe is at least as far as its centre, and farther by at
    /// most the difference of the semi-axes of the ellipsoid. `balls` have z towards the light.
    pub(crate) fn behind(&self, balls: &RotatedBalls) -> [f32; 2] {
        [0.0, balls.ratio - 1.0].map(|excess| {
            let farthest = |ball: &BallGroup| {
                let behind = ball.radius * f32x4::splat(excess) - ball.z;
                let present = ball.radius.simd_gt(f32x4::ZERO) & behind;
                present.to_array().into_iter().fold(0.0, greater)
            };
            greater(balls.groups().iter().map(farthest).fold(0.0, greater), self.range[0])
        })
    }

    /// Minimum and maximum that the renderer may read for packed attributes, by the direction towards the light in the
    /// puff's frame.
    pub(crate) fn of(&self, attributes: Attributes, [x, y, z]: [f32; 3]) -> [f32; 2] {
        if self.table.is_empty() {
            return self.range;
        }
        let first = VARIATION.of(attributes) as usize % (self.table.len() / ENTRIES) * ENTRIES;
        let table = &self.table[first..first + ENTRIES];
        let across = (x * x + y * y).sqrt();
        let row = angle(z, across) / PI * CAP_ROWS as f32;
        let column = (angle(x, y) / (2.0 * PI) + 0.5) * CAP_COLUMNS as f32;
        let doubt = lesser(DOUBT / greater(across, 1e-6), CAP_COLUMNS as f32 / 2.0);
        let (low, high) = (
            greater(row - DOUBT, 0.0) as usize,
            ((row + DOUBT) as usize).min(CAP_ROWS - 1),
        );
        let (left, right) = (column - doubt + CAP_COLUMNS as f32, column + doubt + CAP_COLUMNS as f32);
        let mut bounds = [f32::INFINITY, f32::NEG_INFINITY];
        for row in low.min(CAP_ROWS - 1)..=high {
            for column in left as usize..=right as usize {
                let cap = table[row * CAP_COLUMNS + column % CAP_COLUMNS];
                bounds = [lesser(bounds[0], cap), greater(bounds[1], cap)];
            }
        }
        bounds.map(|cap| greater(cap, self.range[0]))
    }
}

/// The angle from x to (x, y), -pi..pi, with an error of at most 0.0005.
#[inline(always)]
fn angle(x: f32, y: f32) -> f32 {
    let (least, most) = (lesser(x.abs(), y.abs()), greater(x.abs(), y.abs()));
    let tangent = least / greater(most, 1e-20);
    let square = tangent * tangent;
    let eighth = ((-0.046_496_475 * square + 0.159_314_22) * square - 0.327_622_76) * square * tangent + tangent;
    let quarter = if y.abs() > x.abs() { FRAC_PI_2 - eighth } else { eighth };
    let half = if x < 0.0 { PI - quarter } else { quarter };
    half.copysign(y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Random;

    #[test]
    fn angles_are_right_to_a_fraction_of_a_cell() {
        let mut random = Random::new(2);
        for _ in 0..2000 {
            let (x, y) = (random.signed(), random.signed());
            let exact = libm::atan2(f64::from(y), f64::from(x));
            assert!((f64::from(angle(x, y)) - exact).abs() < 5e-4, "({x}, {y})");
        }
    }

    #[test]
    fn the_entry_that_the_shader_reads_lies_within() {
        let mut random = Random::new(3);
        let table: Vec<f32> = (0..2 * ENTRIES).map(|_| random.unit()).collect();
        let caps = StartCaps::new(&table, [0.1, 1.0]);
        let mut single = 0;
        for number in 0..2000 {
            let at: [f64; 3] = std::array::from_fn(|_| f64::from(random.signed()));
            let length = at.iter().map(|c| c * c).sum::<f64>().sqrt();
            let [x, y, z] = at.map(|c| c / length);
            let column = ((libm::atan2(y, x) / std::f64::consts::TAU + 0.5) * CAP_COLUMNS as f64) as usize;
            let row = (libm::acos(z) / std::f64::consts::PI * CAP_ROWS as f64) as usize;
            let variation = number % 2;
            let entry =
                table[variation * ENTRIES + row.min(CAP_ROWS - 1) * CAP_COLUMNS + column.min(CAP_COLUMNS - 1)].max(0.1);
            let [least, most] = caps.of([0, variation as u32, 0, 0], [x, y, z].map(|c| c as f32));
            assert!(least <= entry && entry <= most);
            single += usize::from(least == most);
        }
        assert!(single > 1400, "only {single} of 2000 are certain");
    }
}
