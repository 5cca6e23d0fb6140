//! The discs of a puff, or of its shadow, on the grid: what it certainly covers, and what it may show.

use wide::f32x4;

use crate::arrange::coverage::chart::{Linear, Linears, MIN_W, dot, from};
use crate::arrange::coverage::disc::{Disc, DiscGroup, Discs};
use crate::arrange::coverage::grid::CoverageGrid;
use crate::arrange::coverage::plan::{Bodies, EyePoint, Plan, PlanKind, ShadowFrame, Shadows};
use crate::arrange::coverage::polygon::{Polygon, Reaches};
use crate::arrange::coverage::solids::{Orientations, RotatedBalls, Solids};
use crate::arrange::deformation::undeformed;
use crate::arrange::row_layout::{Attributes, EROSION, NO_END};
use crate::arrange::volume::{self, NEAREST_LAMP, Relief};
use crate::math::scalar::{clamped, greater};
use crate::math::simd::positive_part;

/// In the place of an end: nothing is left of the shadow.
pub(super) const NOTHING_LEFT: u32 = NO_END + 1;
/// Single precision: a coordinate is a sum of terms as large as those of the place.
const ROUNDING: f32 = 2e-6;
/// Displacement (pixels) by a rasteriser that snaps corners to sixteenths.
const SNAP: f32 = 0.1;
/// Displacement of a volume's side by rounding, in radii and in pixels.
const EDGE_ROUNDING: f32 = 0.01;
const EDGE_PIXELS: f32 = 0.25;
/// The eye's axes in view space.
const VIEW_AXES: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const CAP_ROUNDING: f32 = 1e-3;
/// Share of its size below which a puff close to the eye covers nothing.
const MIN_COVERING_CLEARANCE: f32 = 0.05;
const CLEARANCE_TOLERANCE: f32 = 0.002;
/// Distance from the eye, in twice the greatest height of puffs, from which a stretched one certainly has its full size.
const STRETCHED_FROM: f32 = 1.5;
/// Least [`ShadowFrame::rise`] of a puff that covers: twice that of shaders/silhouettes/volumeVertex.glsl.
const LEAST_RISE: f32 = 2e-4;
/// Radii by which the chart of a lamp may move a point of a shadow that covers others.
const MAX_BEND: f32 = 0.25;

/// The discs of one row. The memory is reused.
#[derive(Debug, Default)]
pub(crate) struct Outline {
    /// Bounding disc of everything that the row may show.
    pub hull: Disc,
    /// Everything that a shadow may darken.
    pub polygon: Polygon,
    /// What the row certainly covers.
    pub inner: Discs,
    /// What a body may show.
    pub outer: Discs,
    frame: ShadowFrame,
    balls: RotatedBalls,
    projected: ProjectedPuff,
}

/// A row, projected to the grid.
#[derive(Clone, Copy, Debug, Default)]
struct ProjectedPuff {
    u: f32,
    v: f32,
    /// Cells per metre.
    density: f32,
    depth: f32,
    w: f32,
    radius: f32,
    /// Tolerance of depths (m), and of outlines (radii).
    slack: f32,
    tolerance: f32,
    /// Distance (m) by which its ring may be nearer than its lobes.
    lift: f32,
    /// Displacement of its shadow's start by the nailboard's shear (radii).
    shear: f32,
    covers: bool,
}

/// Projects rows to a grid.
#[derive(Debug)]
pub(crate) struct Outliner<'a> {
    plan: &'a Plan<'a>,
    orientations: &'a Orientations,
    /// Share by which young puffs are folded; none if all puffs have their baked shapes.
    billow: Option<f32>,
    /// Across, up, w and depth.
    lines: Linears,
    corner: f32x4,
    density: f32,
}

impl<'a> Outliner<'a> {
    pub(crate) fn new(
        plan: &'a Plan,
        grid: &CoverageGrid,
        orientations: &'a Orientations,
        billow: Option<f32>,
    ) -> Self {
        let chart = &plan.chart;
        let depth = Linear {
            normal: chart.axes[2].map(|component| -component),
            offset: 0.0,
        };
        let [left, low] = grid.corner;
        Self {
            plan,
            orientations,
            billow,
            lines: Linears::new([chart.across, chart.up, chart.w, depth]),
            corner: f32x4::new([left, low, 0.0, 0.0]),
            density: grid.density,
        }
    }

    /// Writes the bounding disc of a row. Returns false if nothing of it is drawn.
    #[inline]
    pub(crate) fn place(&self, place: [f32; 4], outline: &mut Outline) -> bool {
        match &self.plan.kind {
            PlanKind::Bodies(bodies) => self.place_body(bodies, place, outline),
            PlanKind::Shadows(shadows) => self.place_shadow(shadows, place, outline),
        }
    }

    /// Writes the discs of the row that `place` projected.
    #[inline]
    pub(crate) fn draw(&self, attributes: Attributes, outline: &mut Outline) {
        // A puff that is eroded may have holes.
        outline.projected.covers &= EROSION.of(attributes) == 0;
        match &self.plan.kind {
            PlanKind::Bodies(bodies) => self.draw_body(bodies, attributes, outline),
            PlanKind::Shadows(shadows) => self.draw_shadow(shadows, attributes, outline),
        }
    }

    /// Rows of the map from a puff's frame to the axes of the chart, for a puff fixed in world space.
    #[inline(always)]
    fn standing(&self, attributes: Attributes, axes: &[[f32; 3]; 3]) -> [[f32; 3]; 3] {
        match self.billow {
            None => self.orientations.standing(attributes, axes),
            Some(_) => self
                .orientations
                .standing(attributes, &axes.map(|row| undeformed(attributes, row))),
        }
    }

    #[inline(always)]
    fn projected(&self, place: [f32; 4]) -> ProjectedPuff {
        let chart = &self.plan.chart;
        let lines = self.lines.at(place);
        let [_, _, mut w, mut depth] = lines.to_array();
        let mut size = place[0].abs() + place[1].abs() + place[2].abs();
        if chart.lamp.is_some() {
            depth = chart.depth(place);
            w = greater(w + depth, MIN_W);
            size += depth;
        }
        let [u, v, _, _] = ((lines / f32x4::splat(w) - self.corner) * f32x4::splat(self.density)).to_array();
        ProjectedPuff {
            u,
            v,
            density: self.density / w,
            depth,
            w,
            radius: place[3],
            slack: ROUNDING * size,
            tolerance: ROUNDING * size / place[3],
            lift: 0.0,
            shear: 0.0,
            covers: true,
        }
    }

    /// The end of the shadow that was just drawn, if others continue from `depth`.
    pub(crate) fn end(&self, place: [f32; 4], depth: f32, outline: &Outline) -> u32 {
        if outline.projected.tolerance == f32::INFINITY {
            return NO_END;
        }
        if depth <= outline.polygon.depth {
            return NOTHING_LEFT;
        }
        volume::packed_end((depth - outline.projected.depth) / place[3])
    }

    #[inline(never)]
    fn place_body(&self, bodies: &Bodies, place: [f32; 4], outline: &mut Outline) -> bool {
        let stretched = self.stretched(&bodies.solids, bodies.reach);
        let Some(drawn) = Drawn::of(place, &self.plan.eye, stretched) else {
            return false;
        };
        let mut projected = self.projected(drawn.place);
        if projected.w <= 0.0 {
            return false;
        }
        // What is nearer than the near plane is drawn on it.
        let is_behind_near = projected.depth - self.plan.range[0] > bodies.reach * projected.radius;
        projected.covers = drawn.is_certain && is_behind_near;
        projected.tolerance += drawn.tolerance;
        projected.tolerance += bodies.tolerance + (bodies.blur + SNAP) * bodies.pixel * projected.w / projected.radius;
        let farthest = projected.w + bodies.reach * projected.radius;
        projected.slack += bodies.tolerance * projected.radius + bodies.depth_step * farthest * farthest;
        projected.lift = bodies.lift_of(place, projected.w);
        // Ink lies beside its lobe at the depth of the centre: a ball enlarged by the line contains it. The relief of baked
        // layers continues in the ring, at most two tolerances farther out.
        let tolerance = if bodies.solids.faces_eye { 3.0 } else { 1.0 } * projected.tolerance;
        let radius = ((bodies.reach + tolerance) * projected.radius + bodies.pad * projected.w) * projected.density;
        outline.hull = Disc {
            u: projected.u,
            v: projected.v,
            radius,
            depth: projected.depth - projected.slack - projected.lift,
            bulge: 1.0 / projected.density,
            rim: radius,
            rim_depth: f32::INFINITY,
        };
        outline.projected = projected;
        true
    }

    #[inline(never)]
    fn draw_body(&self, bodies: &Bodies, attributes: Attributes, outline: &mut Outline) {
        let projected = outline.projected;
        outline.inner.count = 0;
        if !projected.covers {
            outline.outer.set(&outline.hull);
            return;
        }
        let rotation = if bodies.solids.faces_eye {
            self.orientations.facing(attributes, &VIEW_AXES)
        } else {
            self.standing(attributes, &self.plan.chart.axes)
        };
        bodies
            .solids
            .rotate(attributes, &rotation, self.billow, &mut outline.balls);
        let cells = f32x4::splat(projected.radius * projected.density);
        let line = bodies.pad * projected.w * projected.density;
        let [radius, tolerance, slack] = [projected.radius, projected.tolerance, projected.slack].map(f32x4::splat);
        let centre = f32x4::splat(projected.depth);
        for (group, ball) in outline.balls.groups().iter().enumerate() {
            let is_present = ball.radius.simd_gt(f32x4::ZERO);
            let depth = centre - ball.z * radius;
            let widest = ball.radius * f32x4::splat(outline.balls.ratio);
            let (inside, outside) = ((ball.radius - tolerance) * cells, (widest + tolerance) * cells);
            let inside = is_present & positive_part(inside);
            let disc = DiscGroup {
                u: f32x4::splat(projected.u) + ball.x * cells,
                v: f32x4::splat(projected.v) + ball.y * cells,
                radius: inside,
                depth: depth + f32x4::splat(bodies.tolerance) * radius,
                rim: inside,
                rim_depth: f32x4::splat(f32::INFINITY),
            };
            outline.inner.groups[group] = disc;
            // Baked layers extend the relief of the last texel into the ring.
            let rise = match bodies.solids.faces_eye {
                true => (f32x4::splat(4.0) * ball.radius * tolerance).sqrt() * radius,
                false => f32x4::ZERO,
            };
            outline.outer.groups[group] = DiscGroup {
                radius: outside,
                depth: depth - slack,
                rim: is_present & (outside + f32x4::splat(line)),
                rim_depth: match line > 0.0 {
                    true => depth - rise - f32x4::splat(projected.lift) - slack,
                    false => disc.rim_depth,
                },
                ..disc
            };
        }
        let count = outline.balls.count;
        (outline.inner.count, outline.outer.count) = (count, count);
        let bulge = 1.0 / projected.density;
        (outline.inner.bulge, outline.outer.bulge) = (bulge, bulge);
    }

    #[inline(never)]
    fn place_shadow(&self, shadows: &Shadows, place: [f32; 4], outline: &mut Outline) -> bool {
        let stretched = self.stretched(&shadows.solids, shadows.reach);
        let Some(drawn) = Drawn::of(place, &self.plan.eye, stretched) else {
            return false;
        };
        let place = drawn.place;
        let mut projected = self.projected(place);
        let frame = match self.plan.chart.lamp {
            None => shadows.frame,
            Some(lamp) => shadows.frame_at(lamp, place, projected.depth),
        };
        let [eye_w, shear] = shadows.seen(&self.plan.eye, place, stretched.unwrap_or(1.0), &frame);
        projected.shear = shear;
        let bend = frame.bend(shadows.reach);
        let is_ahead = eye_w > place[3] || !self.plan.eye.is_perspective;
        projected.covers = drawn.is_certain && is_ahead && bend < MAX_BEND;
        projected.tolerance += drawn.tolerance + shadows.tolerance + EDGE_ROUNDING + bend;
        projected.tolerance += EDGE_PIXELS * shadows.eye.pixel * greater(eye_w, 0.0) / place[3];
        projected.slack += (CAP_ROUNDING + shadows.tolerance) * place[3];
        let start = if projected.covers {
            projected.depth + volume::start(shadows.caps.range[0], shear) * place[3]
        } else {
            // Less than all depths, but not than those outside of the grid.
            f32::MIN
        };
        let radius = (volume::across(shadows.reach, frame.growth) + projected.tolerance) * place[3];
        outline.hull = flat(&projected, radius, start - projected.slack);
        (outline.projected, outline.frame) = (projected, frame);
        true
    }

    /// Greatest height of puffs over their nailboards (radii), if they may be stretched.
    fn stretched(&self, solids: &Solids, reach: f32) -> Option<f32> {
        self.billow.filter(|_| !solids.faces_eye).map(|_| reach)
    }

    /// The discs of all lobes of a shadow are certain. The area between them depends on the eye, so the polygon around
    /// them bounds what it may darken; around the bounding disc if they are only discs within a silhouette.
    #[inline(never)]
    fn draw_shadow(&self, shadows: &Shadows, attributes: Attributes, outline: &mut Outline) {
        let (projected, frame) = (outline.projected, outline.frame);
        let radius = projected.radius;
        let rotation = if shadows.solids.faces_eye {
            self.orientations.facing(attributes, &frame.in_view)
        } else {
            self.standing(attributes, &frame.axes)
        };
        let shown = match shadows.solids.faces_light {
            true => self.orientations.facing(attributes, &frame.facing_light()),
            false => rotation,
        };
        shadows
            .solids
            .rotate(attributes, &shown, self.billow, &mut outline.balls);
        let caps = match self.billow {
            Some(_) if !shadows.solids.faces_eye => shadows.caps.behind(&outline.balls),
            _ => shadows.caps.of(attributes, rotation[2]),
        };
        let starts = caps.map(|cap| projected.depth + volume::start(cap, projected.shear) * radius);
        let cells = radius * projected.density;
        let nearest = if projected.covers {
            starts[0] - projected.slack
        } else {
            f32::NEG_INFINITY
        };
        // The starts are planes across the light; the rays of a lamp that are beside the middle reach them farther on.
        let edge = volume::across(shadows.reach, frame.growth) * frame.growth;
        let start = starts[1] * (1.0 + edge * edge).sqrt();
        let mut reaches = Reaches::new();
        let lanes = f32x4::splat;
        for (group, ball) in outline.balls.groups().iter().enumerate() {
            let discs = volume::discs(ball, outline.balls.ratio, frame.growth);
            let (x, y) = (discs.x * lanes(cells), discs.y * lanes(cells));
            let outside = (discs.outside + lanes(projected.tolerance)) * lanes(cells);
            let is_present = ball.radius.simd_gt(f32x4::ZERO);
            reaches.add(x, y, is_present.select(outside, lanes(f32::NEG_INFINITY)));
            let certain = is_present & positive_part((discs.inside - lanes(projected.tolerance)) * lanes(cells));
            outline.inner.groups[group] = DiscGroup {
                u: lanes(projected.u) + x,
                v: lanes(projected.v) + y,
                radius: certain,
                depth: lanes(start + projected.slack),
                rim: certain,
                rim_depth: lanes(f32::INFINITY),
            };
        }
        if shadows.solids.faces_light {
            let outside = lanes((shadows.reach + projected.tolerance) * cells);
            reaches.add(f32x4::ZERO, f32x4::ZERO, outside);
        }
        outline.polygon = Polygon::at(projected.u, projected.v, nearest);
        outline.polygon.extend(&reaches);
        let covers = projected.covers && (!shadows.solids.faces_light || frame.rise() > LEAST_RISE);
        outline.inner.count = if covers { outline.balls.count } else { 0 };
        outline.inner.bulge = 0.0;
        if self.plan.covers > 1 {
            // Discs of one puff must not count as several covers.
            let largest = outline.inner.largest();
            outline.inner.set(&largest);
        }
    }
}

/// A puff as it is drawn and throws its shadow: smaller near the eye, see shaders/lib/clearance.glsl.
struct Drawn {
    /// With the drawn radius, or with a greater one unless that is certain.
    place: [f32; 4],
    is_certain: bool,
    tolerance: f32,
}

impl Drawn {
    /// None if nothing is drawn. `stretched`: greatest height (radii) of puffs that may be stretched.
    fn of(place: [f32; 4], eye: &EyePoint, stretched: Option<f32>) -> Option<Self> {
        let [x, y, z, radius] = place;
        let share = eye.beyond_near(place) / (2.0 * radius);
        let clearance = volume::clearance(share);
        let is_certain = match stretched {
            Some(reach) => share > STRETCHED_FROM * reach,
            None => clearance > MIN_COVERING_CLEARANCE,
        };
        let drawn = if is_certain { clearance * radius } else { radius };
        (radius > 0.0 && clearance > 0.0).then_some(Self {
            place: [x, y, z, drawn],
            is_certain,
            tolerance: if share < 1.0 { CLEARANCE_TOLERANCE } else { 0.0 },
        })
    }
}

/// A disc with a flat front; `radius` in metres.
fn flat(projected: &ProjectedPuff, radius: f32, depth: f32) -> Disc {
    let radius = radius * projected.density;
    Disc {
        u: projected.u,
        v: projected.v,
        radius,
        depth,
        bulge: 0.0,
        rim: radius,
        rim_depth: f32::INFINITY,
    }
}

impl ShadowFrame {
    /// 1 plus the cosine between the light and the direction towards the eye, without its rounding.
    fn rise(&self) -> f32 {
        let [x, y, back] = self.in_view[2];
        if back < 0.0 {
            (x * x + y * y) / (1.0 - back)
        } else {
            1.0 + back
        }
    }

    /// The axes in the view space of a picture that faces the eye, which then turns to the light the shortest way.
    #[inline(never)]
    fn facing_light(&self) -> [[f32; 3]; 3] {
        let [x, y, _] = self.in_view[2];
        let rise = greater(self.rise(), LEAST_RISE);
        let turned = |[right, up, back]: [f32; 3]| [right - back / rise * x, up - back / rise * y, 0.0];
        [turned(self.in_view[0]), turned(self.in_view[1]), [0.0, 0.0, 1.0]]
    }

    /// Distance (radii) by which the chart of a lamp moves a point of a puff's shadow, against a plane at its centre.
    #[inline(never)]
    fn bend(&self, reach: f32) -> f32 {
        if self.growth == 0.0 {
            return 0.0;
        }
        let across = volume::across(reach, self.growth);
        let edge = across * self.growth;
        let w = 1.0 + self.cosine - edge * self.sine;
        if w > 0.0 && self.growth * reach * NEAREST_LAMP < 1.0 {
            across * edge * (self.sine + edge) / w
        } else {
            f32::INFINITY
        }
    }
}

impl Shadows<'_> {
    /// The frame of a place in the light of a lamp, turned from the middle of the chart the shortest way.
    #[inline(never)]
    fn frame_at(&self, lamp: [f32; 3], place: [f32; 4], distance: f32) -> ShadowFrame {
        let ray = from(lamp, place).map(|component| component / distance);
        let [right, up, back] = self.frame.axes;
        let middle = back.map(|component| -component);
        let cosine = dot(ray, middle);
        let turned = |axis: [f32; 3]| {
            let share = dot(axis, ray) / greater(1.0 + cosine, 1e-3);
            std::array::from_fn(|i| axis[i] - share * (middle[i] + ray[i]))
        };
        let axes = [turned(right), turned(up), ray.map(|component| -component)];
        ShadowFrame {
            axes,
            in_view: axes.map(|axis| self.view_axes.map(|side| dot(side, axis))),
            growth: place[3] / distance,
            sine: greater(1.0 - cosine * cosine, 0.0).sqrt(),
            cosine,
        }
    }

    /// Clip w of a place, and the displacement of the volume's start by the nailboard's shear (radii), for
    /// puffs of a height `tallest` (radii).
    #[inline(never)]
    fn seen(&self, point: &EyePoint, place: [f32; 4], tallest: f32, frame: &ShadowFrame) -> [f32; 2] {
        if !point.is_perspective {
            return [1.0, 0.0];
        }
        let eye = &self.eye;
        let lines = point.lines.at(place);
        let [_, _, w, _] = lines.to_array();
        let ahead = volume::sheared_depth(w, place[3]);
        let ray = (lines / f32x4::splat(ahead)).to_array();
        let ray = [0, 1].map(|axis: usize| clamped(ray[axis], eye.slopes[axis][0], eye.slopes[axis][1]));
        let travel = [-frame.in_view[2][0], -frame.in_view[2][1]];
        let relief = Relief {
            tallest,
            depth: self.depth,
            faces_eye: self.solids.faces_eye,
        };
        [w, volume::shear(&relief, travel, ray, [place[3], ahead])]
    }
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;
    use std::path::Path;

    use super::*;
    use crate::arrange::row_layout::{ROLL, SEED};
    use crate::arrange::view_layout::ViewNumbers;
    use crate::math::random::Random;

    /// The lobe of the puff, its reach, and its visible depth.
    const LOBE: [f32; 4] = [0.3, -0.2, 0.25, 0.7];
    const REACH: f32 = 1.138_748_2;
    const DEPTH: f32 = 0.8;

    /// The line of a puff in the file: place, roll, seed, light, and the values of its volume.
    fn line(place: [f32; 4], attributes: Attributes, light: [f32; 4]) -> String {
        let [x, y, z, is_lamp] = light;
        let numbers = ViewNumbers {
            purpose: 1.0 + is_lamp,
            cull: 1.0,
            // A camera at the origin with a near plane at 0.1 and a far plane at 100.
            clip_from_world: [
                2.0,
                0.0,
                0.0,
                0.0,
                0.0,
                2.0,
                0.0,
                0.0,
                0.0,
                0.0,
                -1.002_002,
                -1.0,
                0.0,
                0.0,
                -0.200_200_2,
                0.0,
            ],
            reach: REACH,
            nearest: 0.1,
            farthest: 100.0,
            covers: 1.0,
            cap_range: [0.0, REACH],
            depth: DEPTH,
            balls: 4.0,
            lamp: [x, y, z],
            ..ViewNumbers::default()
        };
        let direction = if is_lamp > 0.0 { [0.0, -1.0, 0.0] } else { [-x, -y, -z] };
        let table = LOBE.map(|value| [value, 0.0, 0.0, 0.0]);
        let plan = Plan::new(&numbers, table.as_flattened(), direction).expect("a plan");
        let (grid, orientations) = (CoverageGrid::new(1), Orientations::new());
        let outliner = Outliner::new(&plan, &grid, &orientations, None);
        let mut outline = Outline::default();
        assert!(
            outliner.place(place, &mut outline) && outline.projected.covers,
            "{place:?}"
        );
        outliner.draw(attributes, &mut outline);
        let Outline {
            frame,
            projected,
            balls,
            ..
        } = &outline;
        let disc = volume::discs(&balls.groups()[0], balls.ratio, frame.growth);
        let [u, v, radius] = [disc.x, disc.y, disc.outside].map(|lanes| lanes.to_array()[0]);
        let values = [
            projected.radius,
            frame.growth,
            volume::across(REACH, frame.growth),
            (u * u + v * v).sqrt(),
            radius,
            volume::start(0.0, projected.shear),
        ];
        let packed = [ROLL.of(attributes), SEED.of(attributes)].map(|value| value as f32);
        let all = [&place[..], &packed, &light, &values].concat();
        all.iter().map(f32::to_string).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn a_picture_turns_to_the_light_the_shortest_way() {
        let mut random = Random::new(38);
        for _ in 0..200 {
            let z = 1.99 * random.unit() - 0.99;
            let angle = random.unit() * std::f32::consts::TAU;
            let sine = (1.0 - z * z).sqrt();
            let light = [sine * angle.cos(), sine * angle.sin(), z];
            // About the axis across the light, from the direction towards the eye to it.
            let across = [-angle.sin(), angle.cos(), 0.0];
            let along = [-light[2] * across[1], light[2] * across[0], sine];
            let frame = ShadowFrame {
                in_view: [across, along, light],
                ..ShadowFrame::default()
            };
            let [right, up, _] = frame.facing_light();
            for (axis, expected) in [(right, across), (up, [-across[1], across[0], 0.0])] {
                assert!(
                    (0..3).all(|i| (axis[i] - expected[i]).abs() < 1e-4),
                    "{axis:?} {expected:?}"
                );
            }
        }
    }

    /// `npm run generate` writes the file. `tests/visual/renderer/passes/volumes/volumes.spec.ts` compares it with the
    /// shader.
    #[test]
    fn shadow_volumes_are_those_of_the_file() {
        let mut random = Random::new(11);
        let mut expected = String::new();
        for number in 0..24 {
            let depth = 0.45 + 3.0 * random.unit();
            let place = [0.4 * depth * random.signed(), 0.4 * depth * random.signed(), -depth];
            let radius = 0.15 + 0.6 * random.unit();
            let towards = [random.signed(), 0.4 + random.unit(), random.signed()];
            let length = dot(towards, towards).sqrt();
            let light = match number % 2 {
                0 => [0, 1, 2, 3].map(|i| towards.get(i).map_or(0.0, |c| c / length)),
                _ => [0, 1, 2, 3].map(|i| towards.get(i).map_or(1.0, |c| place[i] + 4.0 * c / length)),
            };
            let attributes = [4096 * (number % 16), (number * 37 % 256) << 8, 0, 0];
            let [x, y, z] = place;
            writeln!(expected, "{}", line([x, y, z, radius], attributes, light)).unwrap();
        }
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/visual/renderer/passes/volumes/volumes.txt");
        if std::env::var_os("GENERATE").is_some() {
            std::fs::write(&file, &expected).unwrap();
        }
        let found = std::fs::read_to_string(&file).unwrap();
        assert!(found == expected, "volumes.txt is stale: run npm run generate");
    }
}
