//! Vortices: the air turns about an axis.
//!
//! Lamb-Oseen: at the distance r from the axis the air moves around it at the angular velocity
//!
//! w(r) = G m / (2 pi r^2) * (1 - exp(-r^2 / c^2)) * (1 - r^2 / R^2)^2,  and at 0 where r >= R.
//!
//! Parameters: `vortices.#.circulation` G (m2/s, counter-clockwise seen against the axis), `.coreRadius` c (m),
//! `.reach` R (m, distance from the axis at which the swirl has faded to nothing), `.position.*` (m, a point on the
//! axis), `.axis.*` (a direction of any length), `forces.vortex` m (multiplier). Inside the core the air turns like a
//! solid, outside like a free vortex; the last factor makes the end smooth. Any w(r) is free of divergence.
//!
//! A particle must not spiral out. The plain midpoint rule grows the radius by a^4 / 8 for a turn by the angle a, which
//! is 1 % after 20 turns at 5 rad/s. Here w is taken where the last step, continued, puts the middle of this one; the
//! half step turns about the axis by 2 atan(a / 4) instead of going straight, and the whole step takes the chord that
//! belongs to it. A lone vortex then keeps the radius at any speed but for rounding, only its angle lags (by a^3 / 48
//! a step), no vortex moves anything by more than twice its distance, and with other flows the rule is of second order.

use wide::f32x4;

use super::{Force, Setting, Stage, unit};
use crate::collide::space::{Frame, Vector};
use crate::parameters::LIST_LIMIT;
use crate::parameters::field::{DIRECTION, Field, PLACE, number, vector};
use crate::parameters::section::Item;
use crate::scope::{Reach, Scope};
use crate::simd::{Vector4, exp_minus, positive_part};
use crate::tile::{Columns, TILE_BLOCKS, Tile};

/// `vortices.#.*`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vortex {
    pub circulation: f64,
    pub core_radius: f64,
    pub reach: f64,
    pub position: [f64; 3],
    pub axis: [f64; 3],
    pub scope: Scope,
}

impl Item for Vortex {
    const LABEL: &'static str = "Vortex";
    const FIELDS: &'static [Field<Self>] = &[
        number("circulation", "m2/s", [-200.0, 200.0], 0.0, |v: &mut Self| {
            &mut v.circulation
        })
        .starts_at(2.0)
        .says(
            "Circulation",
            "Strength and sense of the swirl; 0 takes this vortex away.",
        ),
        number("coreRadius", "m", [0.01, 50.0], 0.25, |v: &mut Self| &mut v.core_radius)
            .says("Core", "Radius of the calm middle, where the swirl is fastest."),
        number("reach", "m", [0.05, 1000.0], 2.0, |v: &mut Self| &mut v.reach).says(
            "Reach",
            "Distance from the axis at which the swirl has faded to nothing.",
        ),
        vector("position", "m", PLACE, [0.0; 3], |v: &mut Self| &mut v.position).says("Place", "A point on the axis."),
        vector("axis", "1", DIRECTION, [0.0, 0.0, 1.0], |v: &mut Self| &mut v.axis)
            .says("Axis", "Direction of the axis."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}

/// A vortex of one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    position: Vector4,
    axis: Vector4,
    /// Angular velocity at the axis (rad/s).
    turn: f32x4,
    inverse_core_squared: f32x4,
    inverse_reach_squared: f32x4,
    /// A quarter of the step (s), and its inverse (1/s).
    quarter: f32x4,
    per_quarter: f32x4,
    scope: Reach,
}

impl Force for Vortex {
    type Kernel = Kernel;
    const STAGE: Stage = Stage::Swirl;

    fn kernel(&self, _index: usize, setting: &Setting) -> Option<Kernel> {
        let strength = setting.parameters.forces.vortex;
        if self.circulation * strength == 0.0 {
            return None;
        }
        let scope = Reach::new(&self.scope, &setting.now)?;
        let frame = setting.now.frame(&self.scope);
        Some(Kernel::new(self, strength, &frame, scope, setting.now.dt as f32))
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        if tile.is_instant {
            return add_velocities(kernels, tile);
        }
        // The common case keeps its turn in registers instead of a table.
        match kernels {
            [kernel] => add_mean_velocity(kernel, tile),
            _ => add_mean_velocities(kernels, tile),
        }
    }
}

/// Adds the velocities (m/s) at the places.
fn add_velocities(kernels: &[Kernel], tile: &mut Tile) {
    let Columns {
        place, flow, weight, ..
    } = tile.columns();
    for kernel in kernels {
        kernel.scope.weigh(place, weight);
        for ((flow, place), weight) in flow.iter_mut().zip(&*place).zip(&*weight) {
            *flow += kernel.velocity(*place) * *weight;
        }
    }
}

/// Adds the mean velocity (m/s) over the step where there is one vortex.
fn add_mean_velocity(kernel: &Kernel, tile: &mut Tile) {
    let dt = f32x4::splat(tile.dt);
    let Columns {
        place,
        ahead,
        flow,
        slipped,
        weight,
        ..
    } = tile.columns();
    kernel.scope.weigh(ahead, weight);
    let rest = ahead.iter().zip(&*slipped).zip(&*weight);
    for ((flow, place), ((ahead, slipped), weight)) in flow.iter_mut().zip(&*place).zip(rest) {
        let turn = kernel.turn(*ahead, *weight);
        let half = (*flow * dt + *slipped) * f32x4::HALF;
        let middle = *place + half + kernel.half_step(*place, &turn);
        *flow += kernel.chord_velocity(middle, &turn);
    }
}

/// Adds the mean velocity (m/s) over the step of several vortices, each of which moves the middle for the others.
fn add_mean_velocities(kernels: &[Kernel], tile: &mut Tile) {
    let dt = f32x4::splat(tile.dt);
    let still = Turn {
        sine: f32x4::ZERO,
        cosine: f32x4::ZERO,
    };
    let mut turns = [[still; TILE_BLOCKS]; LIST_LIMIT];
    let mut middles = [Vector4::zero(); TILE_BLOCKS];
    let Columns {
        place,
        ahead,
        flow,
        slipped,
        weight,
        ..
    } = tile.columns();
    for (((middle, place), slipped), flow) in middles.iter_mut().zip(&*place).zip(&*slipped).zip(&*flow) {
        *middle = *place + (*flow * dt + *slipped) * f32x4::HALF;
    }
    for (kernel, turns) in kernels.iter().zip(&mut turns) {
        kernel.scope.weigh(ahead, weight);
        for (block, turn) in turns[..place.len()].iter_mut().enumerate() {
            *turn = kernel.turn(ahead[block], weight[block]);
            middles[block] += kernel.half_step(place[block], turn);
        }
    }
    for (kernel, turns) in kernels.iter().zip(&turns) {
        for ((flow, middle), turn) in flow.iter_mut().zip(&middles).zip(turns) {
            *flow += kernel.chord_velocity(*middle, turn);
        }
    }
}

/// A turn by the angle whose half has the tangent t: t / (1 + t^2), half its sine, and t^2 / (1 + t^2), half of what
/// its cosine lacks of 1.
#[derive(Clone, Copy)]
struct Turn {
    sine: f32x4,
    cosine: f32x4,
}

impl Kernel {
    fn new(vortex: &Vortex, strength: f64, frame: &Frame, scope: Reach, dt: f32) -> Self {
        let core_squared = (vortex.core_radius * vortex.core_radius).max(1e-12);
        let reach_squared = (vortex.reach * vortex.reach).max(1e-12);
        let turn = vortex.circulation * strength / (2.0 * std::f64::consts::PI * core_squared);
        let position = frame.world_from_local(vortex.position.map(|component| component as f32).into());
        Self {
            position: Vector4::splat(position.into()),
            axis: Vector4::splat(frame.turned(Vector::from(unit(vortex.axis))).into()),
            turn: f32x4::splat(turn as f32),
            inverse_core_squared: f32x4::splat((1.0 / core_squared) as f32),
            inverse_reach_squared: f32x4::splat((1.0 / reach_squared) as f32),
            quarter: f32x4::splat(dt * 0.25),
            per_quarter: f32x4::splat(4.0 / dt),
            scope,
        }
    }

    /// The way around the axis: as long as the distance from it, and across.
    #[inline(always)]
    fn around(&self, place: Vector4) -> Vector4 {
        self.axis.cross(place - self.position)
    }

    /// Angular velocity (rad/s) at the distance whose square is given, as dividend and divisor: one division is enough
    /// for all that follows from it.
    #[inline(always)]
    fn angular_velocity(&self, squared: f32x4) -> (f32x4, f32x4) {
        let fade = positive_part(f32x4::ONE - squared * self.inverse_reach_squared);
        let q = squared * self.inverse_core_squared;
        // (1 - exp(-q)) / q; near the axis the difference has no digits left, and at the axis it would be 0 / 0.
        let near = q.simd_lt(f32x4::splat(0.01));
        let series = f32x4::ONE - q * (f32x4::HALF - q * f32x4::splat(1.0 / 6.0));
        let dividend = near.select(series, f32x4::ONE - exp_minus(q));
        (dividend * (self.turn * fade * fade), near.select(f32x4::ONE, q))
    }

    #[inline(always)]
    fn velocity(&self, place: Vector4) -> Vector4 {
        let around = self.around(place);
        let (dividend, divisor) = self.angular_velocity(around.dot(around));
        around * (dividend / divisor)
    }

    /// The turn of half a step where the vortex acts with the strength `weight`.
    #[inline(always)]
    fn turn(&self, place: Vector4, weight: f32x4) -> Turn {
        let around = self.around(place);
        let (dividend, divisor) = self.angular_velocity(around.dot(around));
        let dividend = dividend * (self.quarter * weight);
        let share = dividend / (divisor * divisor + dividend * dividend);
        Turn {
            sine: divisor * share,
            cosine: dividend * share,
        }
    }

    /// Displacement (m) by a turn.
    #[inline(always)]
    fn half_step(&self, place: Vector4, turn: &Turn) -> Vector4 {
        let around = self.around(place);
        // The axis across the way around points back to the axis.
        let inwards = self.axis.cross(around);
        (around * turn.sine + inwards * turn.cosine) * f32x4::splat(2.0)
    }

    /// Velocity (m/s) along the chord of two such turns whose middle is `middle`.
    #[inline(always)]
    fn chord_velocity(&self, middle: Vector4, turn: &Turn) -> Vector4 {
        self.around(middle) * (turn.sine * self.per_quarter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::section::item;
    use crate::scope::Now;

    #[test]
    fn velocity_is_that_of_the_formula() {
        let vortex = Vortex {
            circulation: 3.0,
            core_radius: 0.4,
            reach: 5.0,
            position: [1.0, 0.0, 0.0],
            ..item()
        };
        let now = Now {
            time: 0.5,
            dt: 1.0 / 60.0,
            poses: &[],
        };
        let scope = Reach::new(&vortex.scope, &now).unwrap();
        let kernel = Kernel::new(&vortex, 1.0, &now.frame(&vortex.scope), scope, 1.0 / 60.0);
        for r in [1e-4_f64, 0.03, 0.05, 0.4, 1.3, 4.9, 5.0, 7.0] {
            let fade = (1.0 - r * r / 25.0).max(0.0);
            let speed = 3.0 / (2.0 * std::f64::consts::PI * r) * (1.0 - (-r * r / 0.16).exp()) * fade * fade;
            let [x, y, z] = kernel.velocity(Vector4::splat([1.0 + r as f32, 0.0, 8.0])).first();
            // The place itself is rounded to 1.2e-7 beside the axis at x = 1.
            assert!(
                (f64::from(y) - speed).abs() < speed * (2e-4 + 2e-7 / r) + 1e-6,
                "at {r}: {y} against {speed}"
            );
            assert!(
                x.abs() < 1e-5 && z.abs() < 1e-5,
                "swirl along or towards the axis: {x} {z}"
            );
        }
    }
}
