//! The density of a puff over its life: `density.#.age` and `density.#.value`.
//!
//! Without stops the density is 1 - t, the law of the paper. With stops it interpolates linearly between them, ordered
//! by age, then by index, and is constant before the first and after the last. Stops closer than [`MIN_GAP`] are moved
//! apart to the right, so that the curve never jumps; stops moved beyond the end of life are ignored. Over the last 5 %
//! of life the density is at most 20 (1 - t), so every particle dies at density 0.

use wide::f32x4;

use crate::layout::parameters::density_stop::Stop;
use crate::layout::parameters::field::{STOP_STEPS, STOP_VALUE, Stops};
use crate::layout::parameters::item::LIST_LIMIT;
use crate::math::scalar::{clamped, greater, lesser};
use crate::math::simd::{positive_part, smaller};

/// Minimum distance between stops, as a share of life.
pub const MIN_GAP: f32 = 0.02;
/// Slope of the limit at the end of life.
pub const FALL: f32 = 20.0;

/// A prepared density curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    first: f32,
    rises: [Rise; LIST_LIMIT - 1],
    count: usize,
}

/// Returns true if the stops describe the law of the paper.
fn is_law_of_paper(stops: &[Stop]) -> bool {
    let reaches = |age: f64| stops.iter().any(|stop| stop.age == age);
    reaches(0.0) && reaches(1.0) && stops.iter().all(|stop| stop.value == 1.0 - stop.age)
}

/// A linear piece: from the age `from`, over `width`, the density changes by `slope` per life.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Rise {
    from: f32,
    width: f32,
    slope: f32,
}

impl Curve {
    /// The curve through `stops`; none if there are none or they describe the law of the paper.
    pub fn new(stops: &[Stop]) -> Option<Self> {
        if is_law_of_paper(stops) {
            return None;
        }
        Self::through(stops)
    }

    /// The curve through `stops`, at most [`LIST_LIMIT`]; none if there are none.
    pub fn through(stops: &[Stop]) -> Option<Self> {
        let mut sorted = [Stop::default(); LIST_LIMIT];
        let sorted = &mut sorted[..stops.len()];
        sorted.copy_from_slice(stops);
        sort(sorted);
        let first = sorted.first()?.value as f32;
        let mut rises = [Rise::default(); LIST_LIMIT - 1];
        let mut from = sorted[0].age as f32;
        for (rise, pair) in rises.iter_mut().zip(sorted.windows(2)) {
            let width = (pair[1].age as f32 - from).max(MIN_GAP);
            let slope = (pair[1].value - pair[0].value) as f32 / width;
            *rise = Rise { from, width, slope };
            from += width;
        }
        let count = sorted.len() - 1;
        Some(Self { first, rises, count })
    }

    /// The density, 0..=1, at the share `worn` of life, 0 or more.
    pub fn density(&self, worn: f32) -> f32 {
        let end = ((1.0 - worn) * FALL).max(0.0);
        self.value(worn).min(end)
    }

    /// Same for four particles, bit for bit.
    pub fn densities(&self, worn: f32x4) -> f32x4 {
        let end = positive_part((f32x4::ONE - worn) * f32x4::splat(FALL));
        smaller(self.values(worn), end)
    }

    /// The curve, 0..=1, without the limit at the end of life.
    #[inline(never)]
    pub fn value(&self, worn: f32) -> f32 {
        let mut value = self.first;
        for rise in &self.rises[..self.count] {
            value += (worn - rise.from).max(0.0).min(rise.width) * rise.slope;
        }
        lesser(greater(value, 0.0), 1.0)
    }

    /// Same for four particles, bit for bit.
    #[inline(never)]
    pub fn values(&self, worn: f32x4) -> f32x4 {
        let mut value = f32x4::splat(self.first);
        for rise in &self.rises[..self.count] {
            let way = smaller(positive_part(worn - f32x4::splat(rise.from)), f32x4::splat(rise.width));
            value += way * f32x4::splat(rise.slope);
        }
        smaller(positive_part(value), f32x4::ONE)
    }
}

/// The stops of a curve that is packed, see [`crate::layout::parameters::field::stops`], and their number.
#[inline(never)]
pub fn unpacked(packed: &Stops) -> ([Stop; LIST_LIMIT], usize) {
    let (mut stops, mut count) = ([Stop::default(); LIST_LIMIT], 0);
    for packed in packed {
        if *packed > 0.0 {
            let rest = packed - 1.0;
            let value = libm::floor(rest / STOP_VALUE);
            let age = (rest - value * STOP_VALUE) / STOP_STEPS;
            stops[count] = Stop {
                age: clamped(age, 0.0, 1.0),
                value: value / STOP_STEPS,
            };
            count += 1;
        }
    }
    (stops, count)
}

/// Stable insertion sort by age: enough for eight stops, and far smaller code than the library's sort.
fn sort(stops: &mut [Stop]) {
    for end in 1..stops.len() {
        let mut at = end;
        while at > 0 && stops[at - 1].age > stops[at].age {
            stops.swap(at - 1, at);
            at -= 1;
        }
    }
}
