//! The density of a puff over its life: `density.#.age` and `density.#.value`.
//!
//! Without stops the density is 1 - t, the law of the paper. With stops it interpolates linearly between them, ordered
//! by age, then by index, and is constant before the first and after the last. Stops closer than [`MIN_GAP`] are moved
//! apart to the right, so that the curve never jumps; stops moved beyond the end of life are ignored. Over the last 5 %
//! of life the density is at most 20 (1 - t), so every particle dies at density 0.

use wide::f32x4;

use crate::layout::parameters::density_stop::Stop;
use crate::layout::parameters::item::LIST_LIMIT;
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
        if stops.is_empty() || is_law_of_paper(stops) {
            return None;
        }
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
        let count = stops.len() - 1;
        Some(Self { first, rises, count })
    }

    /// The density, 0..=1, at the share `worn` of life, 0 or more.
    #[inline(never)]
    pub fn density(&self, worn: f32) -> f32 {
        let mut density = self.first;
        for rise in &self.rises[..self.count] {
            density += (worn - rise.from).max(0.0).min(rise.width) * rise.slope;
        }
        let end = ((1.0 - worn) * FALL).max(0.0);
        density.max(0.0).min(end.min(1.0))
    }

    /// Same for four particles, bit for bit.
    #[inline(never)]
    pub fn densities(&self, worn: f32x4) -> f32x4 {
        let mut density = f32x4::splat(self.first);
        for rise in &self.rises[..self.count] {
            let way = smaller(positive_part(worn - f32x4::splat(rise.from)), f32x4::splat(rise.width));
            density += way * f32x4::splat(rise.slope);
        }
        let end = positive_part((f32x4::ONE - worn) * f32x4::splat(FALL));
        smaller(smaller(positive_part(density), f32x4::ONE), end)
    }
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
