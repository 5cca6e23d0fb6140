//! Preparation of coverage for a view: the chart, the depths, and the geometry of puffs or shadows.

use wide::f32x4;

use crate::arrange::coverage::chart::{Chart, Linear, Linears};
use crate::arrange::coverage::solids::Solids;
use crate::arrange::coverage::start_caps::{ENTRIES, StartCaps};
use crate::arrange::view_layout::{LIFTERS_LIMIT, ViewNumbers};
use crate::math::double::{cross, dot, length, unit};

/// The coverage settings of a view.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'v> {
    pub(crate) chart: Chart,
    pub(crate) eye: EyePoint,
    /// Depths along the view of the near and the far plane.
    pub(crate) range: [f32; 2],
    /// Number of covers that hide a puff.
    pub(crate) covers: usize,
    pub(crate) kind: PlanKind<'v>,
}

/// Bodies for the eye, or shadows for the light.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PlanKind<'v> {
    Bodies(Bodies<'v>),
    Shadows(Shadows<'v>),
}

/// Lengths in particle radii unless stated otherwise.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bodies<'v> {
    pub solids: Solids<'v>,
    pub reach: f32,
    /// Tolerance of the solids: in radii, and in pixels.
    pub tolerance: f32,
    pub blur: f32,
    /// Metres per unit of clip w: a pixel, and the ring of ink.
    pub pixel: f32,
    pub pad: f32,
    /// Metres per unit of clip w by which surfaces may lift the ring, and the boxes of those surfaces.
    lift: f32,
    lifters: [[f32x4; 2]; LIFTERS_LIMIT],
    lifter_count: usize,
    /// Depth resolution: metres per unit of w squared.
    pub depth_step: f32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Shadows<'v> {
    pub solids: Solids<'v>,
    pub reach: f32,
    pub tolerance: f32,
    /// Distance from the centre to the start of volumes, without the shear.
    pub caps: StartCaps<'v>,
    /// Maximum depth behind its centre plane at which a puff is visible.
    pub depth: f32,
    pub eye: ShadowEye,
    /// The axes of the view.
    pub view_axes: [[f32; 3]; 3],
    /// The frame of all places, except with a lamp.
    pub frame: ShadowFrame,
}

/// The axes of a shadow: right and up on the chart, and towards the light.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ShadowFrame {
    pub axes: [[f32; 3]; 3],
    pub in_view: [[f32; 3]; 3],
    /// A radius over the distance of the lamp; 0 for a sun.
    pub growth: f32,
    /// The ray of the light against the middle of the chart: sine and cosine.
    pub sine: f32,
    pub cosine: f32,
}

/// The place of the eye, which puffs keep clear of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EyePoint {
    /// Right, up, and the distance along the view: clip w, or the depth if that is constant.
    pub lines: Linears,
    /// That distance at the near plane.
    near: f32,
    pub is_perspective: bool,
}

impl EyePoint {
    /// Distance from the eye beyond that of the near plane, or from the near plane of parallel rays (m).
    #[inline(always)]
    pub fn beyond_near(&self, place: [f32; 4]) -> f32 {
        let [right, up, ahead, _] = self.lines.at(place).to_array();
        if !self.is_perspective {
            return (ahead - self.near).abs();
        }
        (right * right + up * up + ahead * ahead).sqrt() - self.near
    }
}

/// The inputs of a nailboard's shear; see `volume::shear`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowEye {
    /// Minimum and maximum slope of rays relative to the view axis, to the right and up.
    pub slopes: [[f32; 2]; 2],
    pub pixel: f32,
}

impl<'v> Plan<'v> {
    /// Reads the checked numbers of a view and its solids. None if coverage is off or impossible.
    pub(crate) fn new(numbers: &ViewNumbers, solids: &'v [f32], direction: [f32; 3]) -> Option<Self> {
        let covers = numbers.covers as usize;
        let eye = EyeAxes::new(&numbers.clip_from_world)?;
        let point = eye.point(numbers.nearest);
        let plan = |chart, range, kind| Self {
            chart,
            eye: point,
            range,
            covers,
            kind,
        };
        match (covers, numbers.purpose != 0.0) {
            (0, _) => None,
            (_, true) => {
                let chart = light_chart(direction, numbers.place_of_lamp());
                let shadows = Shadows::new(numbers, solids, &eye, &chart)?;
                let boundless = [f32::NEG_INFINITY, f32::INFINITY];
                Some(plan(chart, boundless, PlanKind::Shadows(shadows)))
            }
            (_, false) => {
                let bodies = Bodies::new(numbers, solids, &eye)?;
                let ViewNumbers { nearest, farthest, .. } = *numbers;
                let farthest = bodies.farthest_certain(nearest, farthest, &eye.chart().w, direction);
                Some(plan(eye.chart(), [nearest, farthest], PlanKind::Bodies(bodies)))
            }
        }
    }
}

impl Plan<'_> {
    /// Factor on a particle's radius for its extent on the chart, without lines and tolerances in pixels.
    pub(crate) fn radius_factor(&self) -> f32 {
        match &self.kind {
            PlanKind::Bodies(bodies) => bodies.reach + bodies.tolerance,
            PlanKind::Shadows(shadows) => WIDENING * shadows.reach,
        }
    }

    /// Returns true if shadows may end where others continue; not with several covers.
    pub(crate) fn has_ends(&self) -> bool {
        self.covers == 1 && matches!(self.kind, PlanKind::Shadows(_))
    }

    /// Extent of lines and tolerances in pixels on the chart.
    pub(crate) fn margin(&self) -> f32 {
        match &self.kind {
            PlanKind::Bodies(bodies) => bodies.pad + (bodies.blur + 1.0) * bodies.pixel,
            PlanKind::Shadows(_) => 0.0,
        }
    }
}

/// Number of start-cap entries in `tables` numbers behind a view. The entries follow the balls of all variations.
fn caps_length(numbers: &ViewNumbers, tables: usize) -> usize {
    let balls = 4 * numbers.balls as usize;
    if numbers.caps_follow != 0.0 {
        tables / (balls + ENTRIES) * ENTRIES
    } else {
        0
    }
}

impl<'v> Bodies<'v> {
    fn new(numbers: &ViewNumbers, solids: &'v [f32], eye: &EyeAxes) -> Option<Self> {
        let solids = &solids[..solids.len() - caps_length(numbers, solids.len())];
        (!solids.is_empty()).then(|| Self {
            solids: Solids::new(solids, numbers.balls as usize, numbers.faces_eye),
            reach: numbers.reach,
            tolerance: numbers.tolerance,
            blur: numbers.blur,
            pixel: numbers.pixel,
            pad: numbers.pad,
            lift: numbers.lift,
            // Without limits in the place of the radius.
            lifters: numbers.lifter_boxes.map(|[left, low, back, right, high, front]| {
                [
                    [left, low, back, f32::NEG_INFINITY],
                    [right, high, front, f32::INFINITY],
                ]
                .map(f32x4::new)
            }),
            lifter_count: numbers.lifters as usize,
            depth_step: eye.depth_step(),
        })
    }

    /// Distance (m) by which a surface may lift the ring of a puff; 0 unless a surface is near.
    pub(crate) fn lift_of(&self, place: [f32; 4], w: f32) -> f32 {
        let lift = self.lift * w;
        let (at, reach) = (
            f32x4::new(place),
            f32x4::splat(self.reach * place[3] + self.pad * w + lift),
        );
        let is_near = |[low, high]: &&[f32x4; 2]| ((*low - reach).simd_le(at) & at.simd_le(*high + reach)).all();
        self.lifters[..self.lifter_count]
            .iter()
            .find(is_near)
            .map_or(0.0, |_| lift)
    }

    /// Maximum depth that is drawn distinct from the far plane.
    fn farthest_certain(&self, near: f32, far: f32, w: &Linear, direction: [f32; 3]) -> f32 {
        let (first, last) = (w.at_depth(near, direction), w.at_depth(far, direction));
        if last <= first {
            return far - self.depth_step;
        }
        // The resolution is proportional to w squared. Where it exceeds w, all depths are one step.
        let w = last.min(0.5 / self.depth_step);
        near + (w - first) - self.depth_step * w * w
    }
}

impl<'v> Shadows<'v> {
    fn new(numbers: &ViewNumbers, tables: &'v [f32], eye: &EyeAxes, chart: &Chart) -> Option<Self> {
        let (solids, caps) = tables.split_at(tables.len() - caps_length(numbers, tables.len()));
        (!solids.is_empty()).then(|| Self {
            solids: Solids::new(solids, numbers.balls as usize, numbers.faces_eye),
            reach: numbers.reach,
            tolerance: numbers.tolerance,
            caps: StartCaps::new(caps, numbers.cap_range),
            depth: numbers.depth,
            eye: eye.of_shadows(numbers.pixel),
            view_axes: eye.axes(),
            frame: ShadowFrame {
                axes: chart.axes,
                in_view: chart.axes.map(|axis| eye.in_view(axis)),
                ..ShadowFrame::default()
            },
        })
    }
}

/// Allowance for the tolerance of most shadows.
const WIDENING: f32 = 1.02;
/// Depth steps between a hidden puff and the one that hides it: rounding of both, and the margin of bodies to the ends
/// of the range.
const DEPTH_STEPS: f64 = 12.0;
const DEPTH_STEP: f64 = 1.0 / 16_777_216.0;

/// A row of a matrix stored by columns.
type Row = [f64; 4];

/// The axes of a view, derived from its matrix.
pub(crate) struct EyeAxes {
    rows: [Row; 4],
    forward: [f64; 3],
    scale: [f64; 2],
    sides: [[f64; 3]; 2],
}

impl EyeAxes {
    /// None for a skewed projection, which no camera has.
    pub(crate) fn new(columns: &[f32]) -> Option<Self> {
        let rows: [Row; 4] = std::array::from_fn(|row| std::array::from_fn(|i| f64::from(columns[4 * i + row])));
        let w = [rows[3][0], rows[3][1], rows[3][2]];
        let forward = if length(w) > 1e-9 {
            unit(w)
        } else {
            // Orthographic: the view direction is orthogonal to both sides of the picture.
            unit(cross([0, 1, 2].map(|i| rows[1][i]), [0, 1, 2].map(|i| rows[0][i])))
        };
        let beside = [0, 1].map(|row: usize| {
            let row = [rows[row][0], rows[row][1], rows[row][2]];
            let along = dot(row, forward);
            std::array::from_fn(|i| row[i] - along * forward[i])
        });
        let scale = beside.map(self::length);
        if scale[0] < 1e-9 || scale[1] < 1e-9 {
            return None;
        }
        let sides = [0, 1].map(|axis: usize| beside[axis].map(|component| component / scale[axis]));
        (dot(sides[0], sides[1]).abs() < 1e-4).then_some(Self {
            rows,
            forward,
            scale,
            sides,
        })
    }

    /// A world-space direction in view space: right, up, towards the eye.
    fn in_view(&self, direction: [f32; 3]) -> [f32; 3] {
        let direction = direction.map(f64::from);
        let [right, up] = self.sides.map(|side| dot(side, direction) as f32);
        [right, up, -dot(self.forward, direction) as f32]
    }

    pub(crate) fn is_perspective(&self) -> bool {
        length([self.rows[3][0], self.rows[3][1], self.rows[3][2]]) > 1e-9
    }

    /// The chart of the image plane at unit depth.
    pub(crate) fn chart(&self) -> Chart {
        let line = |axis: usize| linear(self.rows[axis].map(|value| value / self.scale[axis]));
        let [width, height] = self.scale.map(|scale| (1.0 / scale) as f32);
        Chart {
            across: line(0),
            up: line(1),
            w: linear(self.rows[3]),
            axes: self.axes(),
            limits: [-width, -height, width, height],
            lamp: None,
        }
    }

    /// Unit vectors: right, up, towards the eye.
    fn axes(&self) -> [[f32; 3]; 3] {
        [self.sides[0], self.sides[1], self.forward.map(|c| -c)].map(|axis| axis.map(|c| c as f32))
    }

    /// Metres per unit of clip w squared of one step of a 24-bit depth buffer, with a margin.
    pub(crate) fn depth_step(&self) -> f32 {
        let depth = |row: &Row| dot([row[0], row[1], row[2]], self.forward);
        // At depth t along the view clip z = a t + b and clip w = c t + e.
        let (a, c) = (depth(&self.rows[2]), depth(&self.rows[3]));
        let slope = (a * self.rows[3][3] - self.rows[2][3] * c).abs();
        (2.0 * DEPTH_STEPS * DEPTH_STEP / slope.max(1e-12)) as f32
    }

    fn along(&self, row: &Row) -> f64 {
        dot([row[0], row[1], row[2]], self.forward)
    }

    /// `near`: depth of the near plane along the view.
    fn point(&self, near: f32) -> EyePoint {
        let beside = |axis: usize| {
            let w_share = if self.is_perspective() {
                self.along(&self.rows[axis])
            } else {
                0.0
            };
            linear(std::array::from_fn(|i| {
                (self.rows[axis][i] - w_share * self.rows[3][i]) / self.scale[axis]
            }))
        };
        let is_perspective = self.is_perspective();
        let [x, y, z] = self.forward;
        let ahead = if is_perspective { self.rows[3] } else { [x, y, z, 0.0] };
        EyePoint {
            lines: Linears::new([beside(0), beside(1), linear(ahead), Linear::default()]),
            near: (self.along(&ahead) * f64::from(near) + ahead[3]) as f32,
            is_perspective,
        }
    }

    /// The inputs of the shear.
    pub(crate) fn of_shadows(&self, pixel: f32) -> ShadowEye {
        let slopes = [0, 1]
            .map(|axis: usize| [-1.0, 1.0].map(|end| ((end - self.along(&self.rows[axis])) / self.scale[axis]) as f32));
        ShadowEye { slopes, pixel }
    }
}

/// A chart across the light of a sun, or around the light of a lamp; `direction` is a unit vector.
pub(crate) fn light_chart(direction: [f32; 3], lamp: Option<[f32; 3]>) -> Chart {
    let d = direction.map(f64::from);
    let least = (0..3).min_by(|a, b| d[*a].abs().total_cmp(&d[*b].abs())).unwrap_or(0);
    let mut side: [f64; 3] = std::array::from_fn(|i| if i == least { 1.0 } else { 0.0 });
    let along = d[least];
    side = std::array::from_fn(|i| side[i] - along * d[i]);
    let side = unit(side);
    let up = cross(d, side);
    let line = |axis: [f64; 3]| {
        let offset = lamp.map_or(0.0, |lamp| -dot(axis, lamp.map(f64::from)));
        linear([axis[0], axis[1], axis[2], offset])
    };
    Chart {
        across: line(side),
        up: line(up),
        w: lamp.map_or(linear([0.0, 0.0, 0.0, 1.0]), |_| line(d)),
        axes: [side, up, d.map(|c| -c)].map(|axis| axis.map(|c| c as f32)),
        limits: [-1e9, -1e9, 1e9, 1e9],
        lamp,
    }
}

fn linear(row: Row) -> Linear {
    Linear {
        normal: [row[0] as f32, row[1] as f32, row[2] as f32],
        offset: row[3] as f32,
    }
}
