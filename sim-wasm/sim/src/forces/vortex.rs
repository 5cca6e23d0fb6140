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

use super::unit;
use crate::parameters::{self, LIST_LIMIT, Parameters};
use crate::simd::{Vector4, exp_minus, positive_part};

/// The vortices that turn.
#[derive(Clone, Copy, Debug)]
pub struct Vortices {
    items: [Vortex; LIST_LIMIT],
    len: usize,
}

#[derive(Clone, Copy, Debug)]
struct Vortex {
    position: Vector4,
    axis: Vector4,
    /// Angular velocity at the axis (rad/s).
    turn: f32x4,
    inverse_core_squared: f32x4,
    inverse_reach_squared: f32x4,
    /// A quarter of the step (s), and its inverse (1/s).
    quarter: f32x4,
    per_quarter: f32x4,
}

impl Vortices {
    /// The vortices of `parameters` that are not still, for steps of `dt` seconds.
    pub fn new(parameters: &Parameters, dt: f32) -> Self {
        let mut vortices = Self {
            items: [Vortex::new(&parameters::Vortex::default(), 0.0, dt); LIST_LIMIT],
            len: 0,
        };
        let strength = parameters.forces.vortex;
        for vortex in parameters
            .vortices
            .items()
            .iter()
            .filter(|vortex| vortex.circulation * strength != 0.0)
        {
            vortices.items[vortices.len] = Vortex::new(vortex, strength, dt);
            vortices.len += 1;
        }
        vortices
    }

    /// Whether nothing turns.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Velocity (m/s) at four places.
    #[inline(always)]
    pub fn velocity(&self, place: Vector4) -> Vector4 {
        let mut sum = Vector4::zero();
        for vortex in self.items() {
            sum += vortex.velocity(place);
        }
        sum
    }

    /// Mean velocity (m/s) over a step that begins at `place`. `ahead` leads to where the middle of the step is
    /// expected; `half` is what all that is no vortex adds to the first half of the step (m).
    #[inline(always)]
    pub fn mean_velocity(&self, place: Vector4, ahead: Vector4, half: Vector4) -> Vector4 {
        // The common case keeps its turn in registers instead of a table that has to be cleared for every four particles.
        if let [vortex] = self.items() {
            let turn = vortex.turn(place + ahead);
            let middle = place + half + vortex.half_step(place, &turn);
            return vortex.chord_velocity(middle, &turn);
        }
        let mut turns = [Turn {
            sine: f32x4::ZERO,
            cosine: f32x4::ZERO,
        }; LIST_LIMIT];
        let mut middle = place + half;
        for (vortex, turn) in self.items().iter().zip(&mut turns) {
            *turn = vortex.turn(place + ahead);
            middle += vortex.half_step(place, turn);
        }
        let mut sum = Vector4::zero();
        for (vortex, turn) in self.items().iter().zip(&turns) {
            sum += vortex.chord_velocity(middle, turn);
        }
        sum
    }

    #[inline(always)]
    fn items(&self) -> &[Vortex] {
        &self.items[..self.len]
    }
}

/// A turn by the angle whose half has the tangent t: t / (1 + t^2), half its sine, and t^2 / (1 + t^2), half of what
/// its cosine lacks of 1.
#[derive(Clone, Copy)]
struct Turn {
    sine: f32x4,
    cosine: f32x4,
}

impl Vortex {
    fn new(vortex: &parameters::Vortex, strength: f64, dt: f32) -> Self {
        let core_squared = (vortex.core_radius * vortex.core_radius).max(1e-12);
        let reach_squared = (vortex.reach * vortex.reach).max(1e-12);
        let turn = vortex.circulation * strength / (2.0 * std::f64::consts::PI * core_squared);
        Self {
            position: Vector4::splat(vortex.position.map(|component| component as f32)),
            axis: Vector4::splat(unit(vortex.axis)),
            turn: f32x4::splat(turn as f32),
            inverse_core_squared: f32x4::splat((1.0 / core_squared) as f32),
            inverse_reach_squared: f32x4::splat((1.0 / reach_squared) as f32),
            quarter: f32x4::splat(dt * 0.25),
            per_quarter: f32x4::splat(4.0 / dt),
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

    /// The turn of half a step.
    #[inline(always)]
    fn turn(&self, place: Vector4) -> Turn {
        let around = self.around(place);
        let (dividend, divisor) = self.angular_velocity(around.dot(around));
        let dividend = dividend * self.quarter;
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

    #[test]
    fn velocity_is_that_of_the_formula() {
        let mut parameters = Parameters::default();
        for (key, value) in [
            ("circulation", 3.0),
            ("coreRadius", 0.4),
            ("reach", 5.0),
            ("position.x", 1.0),
        ] {
            parameters.set(&format!("vortices.0.{key}"), value).unwrap();
        }
        let vortices = Vortices::new(&parameters, 1.0 / 60.0);
        for r in [1e-4_f64, 0.03, 0.05, 0.4, 1.3, 4.9, 5.0, 7.0] {
            let fade = (1.0 - r * r / 25.0).max(0.0);
            let speed = 3.0 / (2.0 * std::f64::consts::PI * r) * (1.0 - (-r * r / 0.16).exp()) * fade * fade;
            let [x, y, z] = vortices.velocity(Vector4::splat([1.0 + r as f32, 0.0, 8.0])).first();
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
