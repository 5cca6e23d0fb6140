//! PlanKind a view tells of coverage, made ready: chart, depths, and how puffs or their shadows lie on the chart.

use crate::arrange::coverage::chart::{Chart, Linear};
use crate::arrange::coverage::solids::Solids;
use crate::arrange::coverage::start_caps::{ENTRIES, StartCaps};
use crate::arrange::view_layout::{CAPS_FOLLOW, VIEW_LENGTH};
use crate::math::double::{cross, dot, length, unit};

/// How the rows of a view may cover each other.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'v> {
    pub(crate) chart: Chart,
    /// Depths along the view at the near and the far plane: nothing is drawn nearer or farther.
    pub(crate) range: [f32; 2],
    /// How many covers make certain.
    pub(crate) covers: usize,
    pub(crate) kind: PlanKind<'v>,
}

/// Bodies for the eye, or shadows for the light.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PlanKind<'v> {
    Bodies(Bodies<'v>),
    Shadows(Shadows<'v>),
}

/// Lengths in radii of the particle where nothing else is said.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bodies<'v> {
    pub solids: Solids<'v>,
    pub reach: f32,
    /// How far what is drawn may be from the solids: in radii, and in pixels.
    pub tolerance: f32,
    pub blur: f32,
    /// Metres for each unit of clip w: a pixel, and the ring of ink.
    pub pixel: f32,
    pub pad: f32,
    /// Metres by which surfaces may lift that ring, for each unit of clip w, and the boxes that hold those surfaces.
    lift: f32,
    lifters: &'v [[f32; 6]],
    /// Metres that cannot be told apart in depth, for each unit of w squared.
    pub depth_step: f32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Shadows<'v> {
    pub solids: Solids<'v>,
    pub reach: f32,
    pub tolerance: f32,
    /// How far behind the centre volumes start, before the shear.
    pub caps: StartCaps<'v>,
    /// How deep behind its centre plane a puff can be seen.
    pub depth: f32,
    pub eye: ShadowEye,
    /// The axes of the chart as the eye sees them.
    pub axes_in_view: [[f32; 3]; 3],
}

/// PlanKind a nailboard's shear depends on; see `shearOf` in shaders/volumes/volumes.vert.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowEye {
    pub right: Linear,
    pub up: Linear,
    pub w: Linear,
    /// The light's travel to the right and up.
    pub travel: [f32; 2],
    /// Clip w at the near plane.
    pub near: f32,
    /// Least and greatest slope of the picture's rays against the view axis, to the right and up.
    pub slopes: [[f32; 2]; 2],
    pub is_perspective: bool,
    pub pixel: f32,
}

impl<'v> Plan<'v> {
    /// From the checked numbers of a view and the solids behind them; none where nothing can be left out.
    pub(crate) fn new(numbers: &'v [f32; VIEW_LENGTH], solids: &'v [f32], direction: [f32; 3]) -> Option<Self> {
        let covers = numbers[33] as usize;
        let eye = EyeAxes::new(&numbers[4..20])?;
        let plan = |chart, range, kind| Self {
            chart,
            range,
            covers,
            kind,
        };
        match (covers, numbers[0] != 0.0) {
            (0, _) => None,
            (_, true) => {
                let chart = light_chart(direction);
                let shadows = Shadows::new(numbers, solids, &eye, &chart)?;
                let boundless = [f32::NEG_INFINITY, f32::INFINITY];
                Some(plan(chart, boundless, PlanKind::Shadows(shadows)))
            }
            (_, false) => {
                let bodies = Bodies::new(numbers, solids, &eye)?;
                let range = [
                    numbers[31],
                    bodies.farthest_certain(numbers[31], numbers[32], &eye.chart().w, direction),
                ];
                Some(plan(eye.chart(), range, PlanKind::Bodies(bodies)))
            }
        }
    }
}

impl Plan<'_> {
    /// Factor on a particle's radius that makes what it may cover of the chart, lines and tolerances in pixels apart.
    pub(crate) fn radius_factor(&self) -> f32 {
        match &self.kind {
            PlanKind::Bodies(bodies) => bodies.reach + bodies.tolerance,
            PlanKind::Shadows(shadows) => WIDENING * shadows.reach,
        }
    }

    /// Whether shadows may end where others go on: not where covers are counted.
    pub(crate) fn has_ends(&self) -> bool {
        self.covers == 1 && matches!(self.kind, PlanKind::Shadows(_))
    }

    /// Those lines and tolerances, on the chart.
    pub(crate) fn margin(&self) -> f32 {
        match &self.kind {
            PlanKind::Bodies(bodies) => bodies.pad + (bodies.blur + 1.0) * bodies.pixel,
            PlanKind::Shadows(_) => 0.0,
        }
    }
}

/// How many of so many numbers behind a view are start caps: with each variation's balls stand the entries of its table,
/// where the view says so.
fn caps_length(numbers: &[f32; VIEW_LENGTH], tables: usize) -> usize {
    let balls = 4 * numbers[41] as usize;
    if numbers[CAPS_FOLLOW] != 0.0 {
        tables / (balls + ENTRIES) * ENTRIES
    } else {
        0
    }
}

impl<'v> Bodies<'v> {
    fn new(numbers: &'v [f32; VIEW_LENGTH], solids: &'v [f32], eye: &EyeAxes) -> Option<Self> {
        let balls = numbers[41] as usize;
        let (boxes, _) = numbers[43..CAPS_FOLLOW].as_chunks();
        let solids = &solids[..solids.len() - caps_length(numbers, solids.len())];
        (!solids.is_empty()).then(|| Self {
            solids: Solids::new(solids, balls, numbers[36] != 0.0),
            reach: numbers[23],
            tolerance: numbers[34],
            blur: numbers[35],
            pixel: numbers[30],
            pad: numbers[3],
            lift: numbers[37],
            lifters: &boxes[..numbers[42] as usize],
            depth_step: eye.depth_step(),
        })
    }

    /// Metres by which a surface may lift the ring of a puff: none where no surface comes near its board.
    pub(crate) fn lift_of(&self, place: [f32; 4], w: f32) -> f32 {
        let lift = self.lift * w;
        let reach = self.reach * place[3] + self.pad * w + lift;
        let is_near =
            |lifter: &&[f32; 6]| (0..3).all(|i| lifter[i] - reach <= place[i] && place[i] <= lifter[3 + i] + reach);
        self.lifters.iter().find(is_near).map_or(0.0, |_| lift)
    }

    /// A depth that is certainly not drawn as the far end, nor as any other one beyond: from the depths of both planes.
    fn farthest_certain(&self, near: f32, far: f32, w: &Linear, direction: [f32; 3]) -> f32 {
        let (first, last) = (w.at_depth(near, direction), w.at_depth(far, direction));
        if last <= first {
            return far - self.depth_step;
        }
        // Steps grow with the square of w; where they grow faster than w itself, all is one step.
        let w = last.min(0.5 / self.depth_step);
        near + (w - first) - self.depth_step * w * w
    }
}

impl<'v> Shadows<'v> {
    fn new(numbers: &[f32; VIEW_LENGTH], tables: &'v [f32], eye: &EyeAxes, chart: &Chart) -> Option<Self> {
        let travel = chart.axes[2].map(|component| -component);
        let (solids, caps) = tables.split_at(tables.len() - caps_length(numbers, tables.len()));
        (!solids.is_empty()).then(|| Self {
            solids: Solids::new(solids, numbers[41] as usize, numbers[36] != 0.0),
            reach: numbers[23],
            tolerance: numbers[34],
            caps: StartCaps::new(caps, [numbers[38], numbers[39]]),
            depth: numbers[40],
            eye: eye.of_shadows(travel, numbers[30], numbers[31]),
            axes_in_view: chart.axes.map(|axis| eye.in_view(axis)),
        })
    }
}

/// Room for the tolerance of shadows, for most of them.
const WIDENING: f32 = 1.02;
/// Depth steps between what is certainly hidden and what hides it: rounding of both, and the margin by which bodies stay
/// off the ends of the range.
const DEPTH_STEPS: f64 = 12.0;
const DEPTH_STEP: f64 = 1.0 / 16_777_216.0;

/// A row of a matrix in columns.
type Row = [f64; 4];

/// The view's own axes, taken from its matrix.
pub(crate) struct EyeAxes {
    rows: [Row; 4],
    forward: [f64; 3],
    scale: [f64; 2],
    sides: [[f64; 3]; 2],
}

impl EyeAxes {
    /// None where the matrix squeezes the picture askew, which no camera does.
    pub(crate) fn new(columns: &[f32]) -> Option<Self> {
        let rows: [Row; 4] = std::array::from_fn(|row| std::array::from_fn(|i| f64::from(columns[4 * i + row])));
        let w = [rows[3][0], rows[3][1], rows[3][2]];
        let forward = if length(w) > 1e-9 {
            unit(w)
        } else {
            // Parallel rays run across both sides of the picture.
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

    /// A direction of the world as right, up and towards the eye.
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
            axes: [self.sides[0], self.sides[1], self.forward.map(|c| -c)].map(|axis| axis.map(|c| c as f32)),
            limits: [-width, -height, width, height],
        }
    }

    /// Metres for each unit of clip w squared that a step of a 24-bit depth buffer spans, with a margin.
    pub(crate) fn depth_step(&self) -> f32 {
        let depth = |row: &Row| dot([row[0], row[1], row[2]], self.forward);
        // Along the view clip z = a t + b and clip w = c t + e at depth t.
        let (a, c) = (depth(&self.rows[2]), depth(&self.rows[3]));
        let slope = (a * self.rows[3][3] - self.rows[2][3] * c).abs();
        (2.0 * DEPTH_STEPS * DEPTH_STEP / slope.max(1e-12)) as f32
    }

    /// The eye as the shear of its nailboards needs it. `near`: depth along its own direction at the near plane.
    pub(crate) fn of_shadows(&self, travel: [f32; 3], pixel: f32, near: f32) -> ShadowEye {
        let along = |row: &Row| dot([row[0], row[1], row[2]], self.forward);
        let beside = |axis: usize| {
            let w_share = if self.is_perspective() {
                along(&self.rows[axis])
            } else {
                0.0
            };
            linear(std::array::from_fn(|i| {
                (self.rows[axis][i] - w_share * self.rows[3][i]) / self.scale[axis]
            }))
        };
        let travel = travel.map(f64::from);
        ShadowEye {
            right: beside(0),
            up: beside(1),
            w: linear(self.rows[3]),
            travel: self.sides.map(|side| dot(side, travel) as f32),
            near: (along(&self.rows[3]) * f64::from(near) + self.rows[3][3]) as f32,
            slopes: [0, 1]
                .map(|axis: usize| [-1.0, 1.0].map(|end| ((end - along(&self.rows[axis])) / self.scale[axis]) as f32)),
            is_perspective: self.is_perspective(),
            pixel,
        }
    }
}

/// A chart across the light; `direction` has unit length.
pub(crate) fn light_chart(direction: [f32; 3]) -> Chart {
    let d = direction.map(f64::from);
    let least = (0..3).min_by(|a, b| d[*a].abs().total_cmp(&d[*b].abs())).unwrap_or(0);
    let mut side: [f64; 3] = std::array::from_fn(|i| if i == least { 1.0 } else { 0.0 });
    let along = d[least];
    side = std::array::from_fn(|i| side[i] - along * d[i]);
    let side = unit(side);
    let up = cross(d, side);
    let line = |axis: [f64; 3]| linear([axis[0], axis[1], axis[2], 0.0]);
    Chart {
        across: line(side),
        up: line(up),
        w: linear([0.0, 0.0, 0.0, 1.0]),
        axes: [side, up, d.map(|c| -c)].map(|axis| axis.map(|c| c as f32)),
        limits: [-1e9, -1e9, 1e9, 1e9],
    }
}

fn linear(row: Row) -> Linear {
    Linear {
        normal: [row[0] as f32, row[1] as f32, row[2] as f32],
        offset: row[3] as f32,
    }
}
