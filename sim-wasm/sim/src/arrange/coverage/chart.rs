//! The plane that puffs are laid out on: the eye's image plane at unit depth, or a plane across the light.

use wide::f32x4;

use crate::math::simd::Vector4;

/// A quantity linear in the place: n . p + d.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Linear {
    pub normal: [f32; 3],
    pub offset: f32,
}

impl Linear {
    #[inline(always)]
    pub(crate) fn at(&self, place: [f32; 4]) -> f32 {
        self.normal[0] * place[0] + self.normal[1] * place[1] + self.normal[2] * place[2] + self.offset
    }

    /// The value at a depth along `direction`, to which the quantity is parallel or which it does not depend on.
    pub(crate) fn at_depth(&self, depth: f32, direction: [f32; 3]) -> f32 {
        self.offset + depth * (0..3).map(|i| self.normal[i] * direction[i]).sum::<f32>()
    }

    #[inline(always)]
    fn lanes(&self, place: Vector4) -> f32x4 {
        Vector4::splat(self.normal).dot(place) + f32x4::splat(self.offset)
    }
}

/// Chart coordinates are (across / w, up / w); a metre beside a place is 1 / w wide.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chart {
    pub across: Linear,
    pub up: Linear,
    pub w: Linear,
    /// Unit vectors in world space: right, up, and against the direction of the view.
    pub axes: [[f32; 3]; 3],
    /// PlanKind can be seen: left, low, right, high.
    pub limits: [f32; 4],
}

/// Where on a chart puffs lie, and how large they are there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChartExtent {
    least: [f32x4; 2],
    greatest: [f32x4; 2],
    squares: f32x4,
    count: f32x4,
    largest: f32x4,
}

/// Nearer to the eye nothing is drawn.
const MIN_W: f32 = 1e-3;

impl ChartExtent {
    pub(crate) fn new(chart: &Chart) -> Self {
        let [left, low, right, high] = chart.limits;
        Self {
            least: [f32x4::splat(f32::INFINITY); 2],
            greatest: [f32x4::splat(f32::NEG_INFINITY); 2],
            squares: f32x4::ZERO,
            count: f32x4::ZERO,
            // One that fills the view must not make the cells of all others large.
            largest: f32x4::splat(0.25 * (right - left).min(high - low)),
        }
    }

    /// Adds balls of `radius` metres in the lanes of `kept`.
    #[inline(always)]
    pub(crate) fn add(&mut self, chart: &Chart, place: Vector4, radius: f32x4, kept: f32x4) {
        let scale = f32x4::splat(1.0) / chart.w.lanes(place).fast_max(f32x4::splat(MIN_W));
        let size = radius * scale;
        for (axis, line) in [chart.across, chart.up].iter().enumerate() {
            let middle = line.lanes(place) * scale;
            let (low, high) = (middle - size, middle + size);
            self.least[axis] = kept.select(low.fast_min(self.least[axis]), self.least[axis]);
            self.greatest[axis] = kept.select(high.fast_max(self.greatest[axis]), self.greatest[axis]);
        }
        let limited = size.fast_min(self.largest);
        self.squares += kept & (limited * limited);
        self.count += kept & f32x4::splat(1.0);
    }

    /// Left, low, right and high end of all with a margin, within the limits.
    pub(crate) fn box_within(&self, limits: &[f32; 4], margin: f32) -> [f32; 4] {
        let least = |lanes: f32x4| lanes.to_array().into_iter().fold(f32::INFINITY, f32::min);
        let greatest = |lanes: f32x4| lanes.to_array().into_iter().fold(f32::NEG_INFINITY, f32::max);
        let [left, low] = self.least.map(least);
        let [right, high] = self.greatest.map(greatest);
        let (left, low) = ((left - margin).max(limits[0]), (low - margin).max(limits[1]));
        let (right, high) = ((right + margin).min(limits[2]), (high + margin).min(limits[3]));
        if left <= right && low <= high {
            [left, low, right, high]
        } else {
            [0.0; 4]
        }
    }

    /// Root of the mean square of the radii on the chart: what their areas are measured by.
    pub(crate) fn typical(&self) -> f32 {
        (self.squares.reduce_add() / self.count.reduce_add().max(1.0)).sqrt()
    }
}
