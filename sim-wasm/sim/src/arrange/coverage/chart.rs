//! The plane of coverage: the eye's image plane at unit depth, a plane across the light of a sun, or the stereographic
//! projection of the directions from a lamp, which hardly distorts small discs.

use wide::f32x4;

use crate::math::simd::Vector4;

/// A linear function of the place: n . p + d.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Linear {
    pub normal: [f32; 3],
    pub offset: f32,
}

/// Four linear functions, by columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linears([f32x4; 4]);

impl Linears {
    pub(crate) fn new(lines: [Linear; 4]) -> Self {
        Self([0, 1, 2, 3].map(|i| f32x4::new(lines.map(|line| line.normal.get(i).copied().unwrap_or(line.offset)))))
    }

    #[inline(always)]
    pub(crate) fn at(&self, place: [f32; 4]) -> f32x4 {
        let [x, y, z, offset] = self.0;
        x * f32x4::splat(place[0]) + y * f32x4::splat(place[1]) + z * f32x4::splat(place[2]) + offset
    }
}

impl Linear {
    /// The value at a depth along `direction`, for a normal parallel to it or zero.
    pub(crate) fn at_depth(&self, depth: f32, direction: [f32; 3]) -> f32 {
        self.offset + depth * (0..3).map(|i| self.normal[i] * direction[i]).sum::<f32>()
    }

    #[inline(always)]
    fn lanes(&self, place: Vector4) -> f32x4 {
        Vector4::splat(self.normal).dot(place) + f32x4::splat(self.offset)
    }
}

/// Chart coordinates are (across / w, up / w); a metre at a place spans 1 / w.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chart {
    pub across: Linear,
    pub up: Linear,
    pub w: Linear,
    /// Unit vectors in world space: right, up, and opposite to the view direction.
    pub axes: [[f32; 3]; 3],
    /// Limits of the view: left, low, right, high.
    pub limits: [f32; 4],
    /// Place of the lamp, whose distance adds to `w`.
    pub lamp: Option<[f32; 3]>,
}

impl Chart {
    /// Depth along the view.
    #[inline(always)]
    pub(crate) fn depth(&self, place: [f32; 4]) -> f32 {
        let [x, y, z] = match self.lamp {
            None => return -dot(self.axes[2], [place[0], place[1], place[2]]),
            Some(lamp) => from(lamp, place),
        };
        (x * x + y * y + z * z).sqrt()
    }

    #[inline(always)]
    fn w_lanes(&self, place: Vector4) -> f32x4 {
        let w = self.w.lanes(place);
        self.lamp.map_or(w, |lamp| w + (place - Vector4::splat(lamp)).length())
    }
}

/// The way from a lamp to a place.
#[inline(always)]
pub(crate) fn from(lamp: [f32; 3], place: [f32; 4]) -> [f32; 3] {
    [0, 1, 2].map(|axis: usize| place[axis] - lamp[axis])
}

#[inline(always)]
pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The extent of all puffs on a chart, and their typical size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChartExtent {
    least: [f32x4; 2],
    greatest: [f32x4; 2],
    squares: f32x4,
    count: f32x4,
    largest: f32x4,
}

/// Minimum clip w: nothing is drawn nearer to the eye.
pub(crate) const MIN_W: f32 = 1e-3;

impl ChartExtent {
    pub(crate) fn new(chart: &Chart) -> Self {
        let [left, low, right, high] = chart.limits;
        Self {
            least: [f32x4::splat(f32::INFINITY); 2],
            greatest: [f32x4::splat(f32::NEG_INFINITY); 2],
            squares: f32x4::ZERO,
            count: f32x4::ZERO,
            // A puff that fills the view must not enlarge the cells of all others.
            largest: f32x4::splat(0.25 * (right - left).min(high - low)),
        }
    }

    /// Adds balls of `radius` (m) in the lanes of `kept`.
    #[inline(always)]
    pub(crate) fn add(&mut self, chart: &Chart, place: Vector4, radius: f32x4, kept: f32x4) {
        let scale = f32x4::splat(1.0) / chart.w_lanes(place).fast_max(f32x4::splat(MIN_W));
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

    /// Left, low, right and high limit of all balls with a margin, within `limits`.
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

    /// Root mean square of the radii on the chart.
    pub(crate) fn typical(&self) -> f32 {
        (self.squares.reduce_add() / self.count.reduce_add().max(1.0)).sqrt()
    }
}
