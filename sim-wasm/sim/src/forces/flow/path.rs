//! The stroke of a flow: a spline through points, and what finds its nearest point fast.
//!
//! The spline is a centripetal Catmull-Rom spline (Yuksel, Schaefer and Keyser, "Parameterization and applications of
//! Catmull-Rom curves", Computer-Aided Design 43, 2011): it has no cusps and no loops within a span. Samples of it have a
//! position, a direction and a bend. A grid of cells has the nearest sample of each cell, so that a particle costs the
//! same for any number of points.

use arrayvec::ArrayVec;
use wide::bytemuck::cast;
use wide::{f32x4, u32x4};

use crate::layout::parameters::field::{MAX_POINTS, POINT_RANGE};
use crate::layout::parameters::forces::flow::Flow;
use crate::math::simd::Vector4;
use crate::math::vector::Vector;

/// Maximum number of samples: a cell has the number of one in a byte.
const MAX_SAMPLES: usize = 254;
/// The number of no sample.
pub(super) const FAR: u8 = 255;
/// Number of values of a byte: with them as an index, the code of a particle has no checks.
const NUMBERS: usize = 256;
/// Maximum number of cells, a power of two.
const MAX_CELLS: usize = 32_768;
/// Millimetres of a point's coordinate that stand for 0.
const MIDDLE: f64 = POINT_RANGE / 2.0;
/// The stroke of a flow without points.
const INITIAL: [Vector; 2] = [Vector::ZERO, Vector::Y];

/// A stroke in its own frame, in which the centres of cells have whole coordinates.
#[derive(Debug)]
pub(crate) struct Path {
    of: Flow,
    /// Centre of the first cell in the frame of the points.
    pub(super) origin: Vector,
    /// Side of a cell in the frame of the points.
    pub(super) side: f32,
    /// Position and how far back along the path its parabola counts, direction and how far ahead, bend: the derivative of
    /// the direction by the distance. The one of [`FAR`] is far away from everything.
    pub(super) samples: Box<[[f32x4; 3]; NUMBERS]>,
    pub(super) cells: Cells,
}

/// The nearest sample of each cell of a box.
#[derive(Debug)]
pub(super) struct Cells {
    nearest: Box<[u8; MAX_CELLS]>,
    /// The last cell along each axis.
    last: Vector4,
    /// Distance in `nearest` between neighbours along y and z.
    rows: f32x4,
    layers: f32x4,
}

/// A sample before it is packed.
#[derive(Clone, Copy)]
struct Sample {
    position: Vector,
    direction: Vector,
    bend: Vector,
    /// Distance to the sample before and to the one after it; 0 at an end.
    gaps: [f32; 2],
}

impl Path {
    /// The path of `flow`; none if it has no length.
    pub fn new(flow: &Flow) -> Option<Self> {
        let radius = flow.radius as f32;
        let samples = samples_of(&points_of(flow)?, flow.closed == 1.0, radius);
        let (cells, low, side) = Cells::new(&samples, radius);
        let origin = low + Vector::new(0.5, 0.5, 0.5) * side;
        Some(Self {
            of: *flow,
            origin,
            side,
            samples: packed(&samples, origin, side),
            cells,
        })
    }

    /// Returns true if it is the path of `flow`.
    pub fn is_of(&self, flow: &Flow) -> bool {
        let shape = |flow: &Flow| (flow.points, flow.closed, flow.radius);
        shape(&self.of) == shape(flow)
    }
}

/// The points of a flow, without those in the place of the one before; none if fewer than two are left.
fn points_of(flow: &Flow) -> Option<ArrayVec<Vector, MAX_POINTS>> {
    let packed = flow.points.iter().filter(|packed| **packed > 0.0);
    let mut points = ArrayVec::new();
    for point in packed.map(|packed| unpacked(*packed)) {
        if points.last() != Some(&point) {
            points.push(point);
        }
    }
    if points.is_empty() {
        points.extend(INITIAL);
    }
    if flow.closed == 1.0 && points.len() > 2 && points.first() == points.last() {
        points.pop();
    }
    (points.len() > 1).then_some(points)
}

fn unpacked(packed: f64) -> Vector {
    let range = POINT_RANGE as u64;
    let packed = packed as u64;
    let parts = [packed % range, packed / range % range, packed / range / range];
    Vector::from(parts.map(|part| ((part as f64 - MIDDLE) / 1000.0) as f32))
}

/// The samples of the spline through `points`.
fn samples_of(points: &[Vector], is_closed: bool, radius: f32) -> Vec<Sample> {
    let is_closed = is_closed && points.len() > 2;
    let count = points.len();
    let spans = if is_closed { count } else { count - 1 };
    let most = MAX_SAMPLES / (spans + 1);
    let mut samples = Vec::with_capacity(MAX_SAMPLES);
    for span in 0..spans {
        let curve = Span::new(points, span, is_closed);
        let wanted = libm::ceilf(3.0 * curve.chord / radius) as usize;
        let parts = wanted.clamp(4.min(most), most);
        for part in 0..parts {
            samples.push(curve.sample(part as f32 / parts as f32));
        }
        if !is_closed && span + 1 == spans {
            samples.push(curve.sample(1.0));
        }
    }
    // A bend within the radius would have its centre within reach.
    let most = 1.0 / radius;
    for sample in &mut samples {
        let bend = sample.bend.length();
        if bend > most {
            sample.bend = sample.bend * (most / bend);
        }
    }
    measure(&mut samples, is_closed);
    samples
}

/// Sets the gaps between samples.
fn measure(samples: &mut [Sample], is_closed: bool) {
    let count = samples.len();
    for index in 0..count {
        let next = (index + 1) % count;
        let is_gap = is_closed || next > 0;
        let gap = if is_gap {
            (samples[next].position - samples[index].position).length()
        } else {
            0.0
        };
        samples[index].gaps[1] = gap;
        samples[next].gaps[0] = gap;
    }
}

/// A cubic between two points.
struct Span {
    ends: [Vector; 2],
    slopes: [Vector; 2],
    chord: f32,
}

impl Span {
    fn new(points: &[Vector], span: usize, is_closed: bool) -> Self {
        let count = points.len();
        let at = |index: usize| points[index % count];
        let (from, to) = (at(span), at(span + 1));
        // Beyond an end the stroke goes on straight.
        let before = if is_closed || span > 0 {
            at(span + count - 1)
        } else {
            from + from - to
        };
        let after = if is_closed || span + 2 < count {
            at(span + 2)
        } else {
            to + to - from
        };
        let knot = |a: Vector, b: Vector| libm::sqrtf((b - a).length());
        let [first, middle, last] = [knot(before, from), knot(from, to), knot(to, after)];
        let slope = |a: Vector, b: Vector, c: Vector, ab: f32, bc: f32| {
            (b - a) * (1.0 / ab) - (c - a) * (1.0 / (ab + bc)) + (c - b) * (1.0 / bc)
        };
        Self {
            ends: [from, to],
            slopes: [
                slope(before, from, to, first, middle) * middle,
                slope(from, to, after, middle, last) * middle,
            ],
            chord: (to - from).length(),
        }
    }

    /// The sample at a share 0..=1 of the span.
    fn sample(&self, u: f32) -> Sample {
        let ([a, b], [m, n]) = (self.ends, self.slopes);
        let square = (b - a) * 3.0 - m * 2.0 - n;
        let cube = (a - b) * 2.0 + m + n;
        let position = a + (m + (square + cube * u) * u) * u;
        let velocity = m + (square * 2.0 + cube * (3.0 * u)) * u;
        let acceleration = square * 2.0 + cube * (6.0 * u);
        let direction = velocity.unit_or((b - a).unit_or(Vector::Y));
        let speed_squared = velocity.dot(velocity).max(1e-12);
        let bend = (acceleration - direction * acceleration.dot(direction)) * (1.0 / speed_squared);
        Sample {
            position,
            direction,
            bend,
            gaps: [0.0; 2],
        }
    }
}

/// Packs samples into the frame of cells of this side, of which the first has its centre at `origin`. The parabola of a
/// sample reaches over a cell.
fn packed(samples: &[Sample], origin: Vector, side: f32) -> Box<[[f32x4; 3]; NUMBERS]> {
    let total: f32 = samples.iter().map(|sample| sample.gaps[1]).sum();
    let is_closed = samples[0].gaps[0] > 0.0;
    let mut length = 0.0;
    let mut rows = Box::new([[f32x4::splat(1e9), f32x4::ZERO, f32x4::ZERO]; NUMBERS]);
    for (row_of, sample) in rows.iter_mut().zip(samples) {
        let [before, after] = sample.gaps;
        let within = |reach: f32, limit: f32| if is_closed { reach } else { reach.min(limit) };
        let [back, ahead] = [
            within(before.max(side), length),
            within(after.max(side), (total - length).max(0.0)),
        ];
        length += after;
        let row = |v: Vector, w: f32| f32x4::new([v.x, v.y, v.z, w]);
        *row_of = [
            row((sample.position - origin) * (1.0 / side), 0.0 - back / side),
            row(sample.direction, ahead / side),
            row(sample.bend * side, 0.0),
        ];
    }
    rows
}

impl Cells {
    /// The cells, the lowest corner of the first one, and their side.
    fn new(samples: &[Sample], radius: f32) -> (Self, Vector, f32) {
        let (mut low, mut high) = (samples[0].position, samples[0].position);
        for sample in samples {
            // Between samples the path is no farther away than the gaps are long.
            let slack = sample.gaps[0].max(sample.gaps[1]) * 0.25;
            let slack = Vector::new(slack, slack, slack);
            low = low.least(sample.position - slack);
            high = high.greatest(sample.position + slack);
        }
        let mut side = radius * 0.5;
        let (low, counts) = loop {
            // Around all cells that are in reach is a layer of others.
            let margin = radius + 2.2 * side;
            let margin = Vector::new(margin, margin, margin);
            let low = low - margin;
            let size = high + margin - low;
            let counts = [size.x, size.y, size.z].map(|length| libm::ceilf(length / side) as usize);
            if counts.iter().product::<usize>() <= MAX_CELLS {
                break (low, counts);
            }
            side *= 1.1;
        };
        let mut cells = Self {
            nearest: Box::new([FAR; MAX_CELLS]),
            last: Vector4::splat(counts.map(|count| count as f32 - 1.0)),
            rows: f32x4::splat(counts[0] as f32),
            layers: f32x4::splat((counts[0] * counts[1]) as f32),
        };
        cells.stamp(samples, radius, side, low, counts);
        (cells, low, side)
    }

    /// Enters the nearest sample into all cells from which the path is in reach.
    fn stamp(&mut self, samples: &[Sample], radius: f32, side: f32, low: Vector, counts: [usize; 3]) {
        // Half of a cell's diagonal, and half of the distance between two of the points below.
        let reach = radius + 1.12 * side;
        let mut distances = vec![reach * reach; counts.iter().product()];
        for (number, sample) in samples.iter().enumerate() {
            let [before, after] = sample.gaps.map(|gap| libm::ceilf(gap / side) as i32);
            for part in -before..=after {
                let gap = if part < 0 { sample.gaps[0] } else { sample.gaps[1] };
                let parts = if part < 0 { before } else { after }.max(1);
                let along = 0.5 * gap * part as f32 / parts as f32;
                let point = sample.position + (sample.direction + sample.bend * (0.5 * along)) * along - low;
                let range = |place: f32, count: usize| {
                    let first = libm::floorf((place - reach) / side).max(0.0) as usize;
                    let end = libm::ceilf((place + reach) / side).max(0.0) as usize;
                    first..end.min(count)
                };
                for z in range(point.z, counts[2]) {
                    for y in range(point.y, counts[1]) {
                        for x in range(point.x, counts[0]) {
                            let centre = Vector::new(x as f32 + 0.5, y as f32 + 0.5, z as f32 + 0.5) * side;
                            let offset = centre - point;
                            let cell = x + counts[0] * (y + counts[1] * z);
                            if offset.dot(offset) < distances[cell] {
                                distances[cell] = offset.dot(offset);
                                self.nearest[cell] = number as u8;
                            }
                        }
                    }
                }
            }
        }
    }

    /// The cells of four places, in the low bits.
    #[inline(always)]
    pub(super) fn at(&self, place: Vector4) -> u32x4 {
        // Adding 1.5 * 2^23 rounds to the nearest whole number, which is then in the low bits.
        let magic = f32x4::splat(12_582_912.0);
        // The sign of zero is lost, so that these are the same on every machine.
        let shifted = |place: f32x4, last: f32x4| place.fast_max(f32x4::ZERO).fast_min(last) + magic;
        let row = (shifted(place.y, self.last.y) - magic) * self.rows;
        let layer = (shifted(place.z, self.last.z) - magic) * self.layers;
        cast(shifted(place.x, self.last.x) + (row + layer))
    }

    /// The number of the nearest sample at a cell, [`FAR`] if it is out of reach.
    #[inline(always)]
    pub(super) fn nearest(&self, cell: u32) -> u8 {
        self.nearest[cell as usize % MAX_CELLS]
    }
}
