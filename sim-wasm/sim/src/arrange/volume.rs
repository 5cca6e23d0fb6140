//! The shadow volume of a puff, as shaders/lib/volume.glsl draws it.
//! `tests/visual/renderer/passes/volumes/volumes.spec.ts` compares the values. Lengths are in drawn radii unless stated
//! otherwise.

use wide::f32x4;

use crate::arrange::coverage::solids::BallGroup;
use crate::arrange::row_layout::{END_STEPS, NO_END};
use crate::math::scalar::{greater, lesser};
use crate::math::simd::{Vector4, positive_part};

/// A lamp counts as at least this many bounding radii away.
pub(crate) const NEAREST_LAMP: f32 = 1.2;
/// Least depth of the shear.
const NEAREST_SHEARED: f32 = 0.5;
const CAP_SLACK: f32 = 0.02;

/// Share of its size with which a puff is drawn and throws its shadow, by its distance beyond the near plane in diameters.
#[inline(always)]
pub(crate) fn clearance(beyond_near: f32) -> f32 {
    let share = beyond_near.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Sines of half the angles that bounding balls span, seen from a lamp at a distance in the same unit.
#[inline(always)]
pub(crate) fn sine(ball: f32x4, distance: f32x4) -> f32x4 {
    (ball / distance).fast_min(f32x4::splat(1.0 / NEAREST_LAMP))
}

/// Radii at their centres of the cones of rays that touch balls.
#[inline(always)]
pub(crate) fn tangent(radius: f32x4, sine: f32x4) -> f32x4 {
    radius / (f32x4::splat(1.0) - sine * sine).sqrt()
}

/// Radius of the shadow of a bounding ball at its centre. `growth`: a radius over the distance of the lamp.
#[inline(never)]
pub(crate) fn across(reach: f32, growth: f32) -> f32 {
    let sine = lesser(growth * reach, 1.0 / NEAREST_LAMP);
    tangent(f32x4::splat(reach), f32x4::splat(sine)).as_array()[0]
}

/// The discs that four lobes show to the light, on a plane across it at the centre of the puff.
pub(crate) struct LobeDiscs {
    pub x: f32x4,
    pub y: f32x4,
    /// Radii of discs that the shadow certainly contains, and of discs that contain it.
    pub inside: f32x4,
    pub outside: f32x4,
}

/// `balls` have z towards the light; `ratio` is that of the axes of the lobes.
#[inline(always)]
pub(crate) fn discs(balls: &BallGroup, ratio: f32, growth: f32) -> LobeDiscs {
    let growth = f32x4::splat(growth);
    let nearness = f32x4::splat(1.0) / (f32x4::splat(1.0) - growth * balls.z);
    let inside = balls.radius * nearness;
    LobeDiscs {
        x: balls.x * nearness,
        y: balls.y * nearness,
        inside,
        outside: tangent(inside * f32x4::splat(ratio), inside * growth),
    }
}

/// The board and the heights of a puff.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relief {
    /// Greatest height over the board, and depth of what is visible behind it.
    pub tallest: f32,
    pub depth: f32,
    pub faces_eye: bool,
}

/// Depth (m) of a puff with a radius (m) for the shear.
#[inline(always)]
pub(crate) fn sheared_depth(depth: f32, radius: f32) -> f32 {
    greater(depth, NEAREST_SHEARED * radius)
}

/// Displacement of the start by the shear of a nailboard. `travel`: of the light to the right and up; `ray`: slopes of the
/// view ray; lastly the radius and the depth (m).
#[inline(always)]
pub(crate) fn shear(relief: &Relief, travel: [f32; 2], ray: [f32; 2], [radius, ahead]: [f32; 2]) -> f32 {
    let slope = -(travel[0] * ray[0] + travel[1] * ray[1]);
    if relief.faces_eye {
        return greater(slope, 0.0);
    }
    let Relief { tallest, depth, .. } = *relief;
    let sideways = (travel[0] * travel[0] + travel[1] * travel[1]).sqrt();
    greater(tallest * slope, -depth * slope) + 0.5 * tallest * tallest * sideways * radius / ahead
}

/// Distance from the centre to the start.
#[inline(always)]
pub(crate) fn start(cap: f32, shear: f32) -> f32 {
    cap + shear + CAP_SLACK
}

/// The packed end of a shadow that may end at a distance behind the centre.
pub(crate) fn packed_end(distance: f32) -> u32 {
    let steps = distance * END_STEPS + 1.0;
    if steps < NO_END as f32 {
        greater(steps, 0.0) as u32
    } else {
        NO_END
    }
}

/// The path of a shadow: from the caster along the light to the exit from the receivers' box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sweep {
    pub direction: Vector4,
    /// The face of the box through which each component exits.
    face: Vector4,
    /// 1 / direction, or 0 for a component close to 0, whose exit time is then `never`.
    inverse: Vector4,
    never: Vector4,
}

/// The paths of the shadows of a lamp.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LampSweep {
    pub place: Vector4,
    /// Distances to the faces of the receivers' box in the positive and in the negative directions, and to its farthest
    /// corner.
    ahead: Vector4,
    behind: Vector4,
    farthest: f32x4,
}

/// Lengths in metres.
pub(crate) struct LampPath {
    /// From the lamp.
    pub distance: f32x4,
    /// Radius of the shadow at the caster.
    pub radius: f32x4,
    /// Distance of the end from the lamp over that of the caster.
    pub growth: f32x4,
}

impl LampSweep {
    pub(crate) fn new(receivers: [f32; 6], place: [f32; 3]) -> Self {
        let ahead = [0, 1, 2].map(|axis: usize| receivers[3 + axis] - place[axis]);
        let behind = [0, 1, 2].map(|axis: usize| place[axis] - receivers[axis]);
        let corner = Vector4::splat([0, 1, 2].map(|axis: usize| greater(ahead[axis].abs(), behind[axis].abs())));
        Self {
            place: Vector4::splat(place),
            ahead: Vector4::splat(ahead),
            behind: Vector4::splat(behind),
            farthest: corner.length(),
        }
    }

    /// The paths of the shadows of balls (m).
    #[inline(always)]
    pub(crate) fn path(&self, place: Vector4, ball: f32x4) -> LampPath {
        let way = place - self.place;
        let distance = way.length().fast_max(f32x4::splat(1e-6));
        // A disc at the caster spans the same angle as the ball, and one at the end of the shadow, too.
        let radius = tangent(ball, sine(ball, distance));
        let mut growth = self.farthest / distance;
        let [x, y, z] = [
            (way.x, self.ahead.x, self.behind.x),
            (way.y, self.ahead.y, self.behind.y),
            (way.z, self.ahead.z, self.behind.z),
        ];
        for (way, ahead, behind) in [x, y, z] {
            let face = way.simd_gt(f32x4::ZERO).select(ahead, behind);
            let least = way.abs() - radius;
            growth = least.simd_gt(f32x4::ZERO).select(growth.fast_min(face / least), growth);
        }
        LampPath {
            distance,
            radius,
            growth: growth.fast_max(f32x4::splat(1.0)),
        }
    }
}

impl Sweep {
    pub(crate) fn new(receivers: [f32; 6], direction: [f32; 3]) -> Self {
        let moves = direction.map(|component| component.abs() > 1e-6);
        let axes = [0, 1, 2];
        Self {
            direction: Vector4::splat(direction),
            face: Vector4::splat(axes.map(|i| receivers[if direction[i] > 0.0 { 3 + i } else { i }])),
            inverse: Vector4::splat(axes.map(|i| if moves[i] { 1.0 / direction[i] } else { 0.0 })),
            never: Vector4::splat(axes.map(|i| if moves[i] { 0.0 } else { 1e30 })),
        }
    }

    /// Distance to the exit (m); 0 behind the box.
    #[inline(always)]
    pub(crate) fn length(&self, place: Vector4) -> f32x4 {
        let way = self.face - place;
        let exit = Vector4 {
            x: way.x * self.inverse.x + self.never.x,
            y: way.y * self.inverse.y + self.never.y,
            z: way.z * self.inverse.z + self.never.z,
        };
        positive_part(exit.x.fast_min(exit.y).fast_min(exit.z))
    }
}
