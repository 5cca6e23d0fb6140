//! The rotation of air by a vortex, for four particles.

use std::f64::consts::PI;

use wide::f32x4;

use crate::forces::force::{direction_in, fade, place_in};
use crate::layout::parameters::forces::vortex::Vortex;
use crate::math::pose::Frame;
use crate::math::simd::{Vector4, larger, positive_part, splat};

/// The swirl of a vortex in one step.
#[derive(Clone, Copy, Debug)]
pub struct Swirl {
    position: Vector4,
    pub(super) axis: Vector4,
    /// Angular velocity at the axis (rad/s).
    angular_velocity: f32x4,
    inverse_core_squared: f32x4,
    inverse_reach_squared: f32x4,
    is_rankine: bool,
    /// A quarter of the step (s), and its inverse (1/s).
    quarter: f32x4,
    per_quarter: f32x4,
}

/// A rotation by the angle whose half has the tangent t. `sine` is t / (1 + t^2), half the sine of the angle; `cosine`
/// is t^2 / (1 + t^2), half of 1 minus its cosine.
#[derive(Clone, Copy)]
pub struct HalfRotation {
    pub(super) sine: f32x4,
    pub(super) cosine: f32x4,
}

impl HalfRotation {
    /// The identity rotation.
    pub const IDENTITY: Self = Self {
        sine: f32x4::ZERO,
        cosine: f32x4::ZERO,
    };
}

/// Returns true if the core of `vortex` rotates as a solid.
pub(super) fn is_rankine(vortex: &Vortex) -> bool {
    vortex.profile == 1.0
}

/// Profile of the swirl at a distance from the axis: the fade at the reach, 0..=1, and the divisor of the angular
/// velocity at the axis, 1 or more.
#[derive(Clone, Copy)]
pub(super) struct Profile {
    /// Squared distance in core radii.
    pub q: f32x4,
    pub fade: f32x4,
    pub divisor: f32x4,
}

impl Swirl {
    /// The swirl of `vortex` in `frame`, with all velocities multiplied by `strength`, for steps of `dt` seconds.
    pub(super) fn new(vortex: &Vortex, strength: f64, frame: &Frame, dt: f32) -> Self {
        let core_squared = vortex.core_radius * vortex.core_radius;
        let angular_velocity = vortex.circulation * strength / (2.0 * PI * core_squared);
        Self {
            position: place_in(frame, vortex.position),
            axis: direction_in(frame, vortex.axis),
            angular_velocity: splat(angular_velocity),
            inverse_core_squared: splat(1.0 / core_squared),
            inverse_reach_squared: splat(1.0 / (vortex.reach * vortex.reach)),
            is_rankine: is_rankine(vortex),
            quarter: f32x4::splat(dt * 0.25),
            per_quarter: f32x4::splat(4.0 / dt),
        }
    }

    /// The tangential vector: as long as the distance from the axis.
    #[inline(always)]
    pub(super) fn around(&self, place: Vector4) -> Vector4 {
        self.axis.cross(place - self.position)
    }

    /// The vector to the axis, from the tangential vector.
    #[inline(always)]
    pub(super) fn inwards(&self, around: Vector4) -> Vector4 {
        self.axis.cross(around)
    }

    /// The profile at a squared distance from the axis (m2). One division by the divisor serves all uses.
    #[inline(always)]
    pub(super) fn profile(&self, squared: f32x4) -> Profile {
        let q = squared * self.inverse_core_squared;
        let divisor = if self.is_rankine {
            larger(q, f32x4::ONE)
        } else {
            q + bernoulli(q)
        };
        Profile {
            q,
            fade: fade(squared, self.inverse_reach_squared),
            divisor,
        }
    }

    /// Velocity (m/s) at four places.
    #[inline(always)]
    pub(super) fn velocity(&self, place: Vector4) -> Vector4 {
        let around = self.around(place);
        let profile = self.profile(around.dot(around));
        around * (self.angular_velocity * profile.fade / profile.divisor)
    }

    /// The rotation of half a step at the strength `weight`.
    #[inline(always)]
    pub(super) fn rotation(&self, place: Vector4, weight: f32x4) -> HalfRotation {
        let around = self.around(place);
        let Profile { fade, divisor, .. } = self.profile(around.dot(around));
        let dividend = self.angular_velocity * fade * (self.quarter * weight);
        let share = dividend / (divisor * divisor + dividend * dividend);
        HalfRotation {
            sine: divisor * share,
            cosine: dividend * share,
        }
    }

    /// Displacement (m) by a rotation.
    #[inline(always)]
    pub(super) fn half_step(&self, place: Vector4, rotation: &HalfRotation) -> Vector4 {
        let around = self.around(place);
        (around * rotation.sine + self.inwards(around) * rotation.cosine) * f32x4::splat(2.0)
    }

    /// Mean velocity (m/s) of two such rotations about their middle `middle`: along the chord.
    #[inline(always)]
    pub(super) fn chord_velocity(&self, middle: Vector4, rotation: &HalfRotation) -> Vector4 {
        self.around(middle) * (rotation.sine * self.per_quarter)
    }
}

/// q / (exp(q) - 1) for q >= 0. (1 - exp(-q)) / q = 1 / (q + bernoulli(q)) then needs no exponential and is regular at
/// the axis. The error is at most 5e-5 of q + bernoulli(q).
///
/// A minimax polynomial by Lawson's weights, 0 with all its derivatives from q = 12.75 on.
#[inline(always)]
fn bernoulli(q: f32x4) -> f32x4 {
    let left = positive_part(f32x4::ONE - q * f32x4::splat(1.0 / 12.75));
    let square = left * left;
    let power = square * square * square;
    let c = |value: f32| f32x4::splat(value);
    power * (c(1.0) + q * (c(-0.029_029_946) + q * (c(-0.024_458_74) + q * c(0.003_442_862_4))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::parameters::Parameters;
    use crate::layout::scope::StepTime;
    use crate::layout::scope::parts::Parts;

    fn swirl(vortex: &Vortex) -> Swirl {
        let now = StepTime {
            time: 0.5,
            dt: 1.0 / 60.0,
            poses: &[],
            parts: &Parts::default(),
        };
        Swirl::new(vortex, 1.0, &now.frame(&vortex.scope), 1.0 / 60.0)
    }

    fn assert_velocity(vortex: &Vortex, r: f64, expected: f64) {
        let place = Vector4::splat([1.0 + r as f32, 0.0, 8.0]);
        let [x, y, z] = swirl(vortex).velocity(place).first();
        // The place itself is rounded to 1.2e-7 at x = 1.
        assert!(
            (f64::from(y) - expected).abs() < expected * (1e-4 + 2e-7 / r) + 1e-6,
            "at {r}: {y} against {expected}"
        );
        assert!(
            x.abs() < 1e-5 && z.abs() < 1e-5,
            "swirl along or towards the axis: {x} {z}"
        );
    }

    #[test]
    fn velocity_follows_the_formula() {
        let mut parameters = Parameters::default();
        parameters.set("vortices.0.circulation", 3.0).unwrap();
        let vortex = Vortex {
            core_radius: 0.4,
            reach: 5.0,
            position: [1.0, 0.0, 0.0],
            ..parameters.lists.vortices.items()[0]
        };
        let rankine = Vortex { profile: 1.0, ..vortex };
        for r in (0..60).map(|i| 1e-4 * 1.21_f64.powi(i)) {
            let fade = (1.0 - r * r / 25.0).max(0.0).powi(2);
            let free = 3.0 / (2.0 * PI * r);
            assert_velocity(&vortex, r, free * (1.0 - (-r * r / 0.16).exp()) * fade);
            assert_velocity(&rankine, r, free * (r * r / 0.16).min(1.0) * fade);
        }
    }

    #[test]
    fn bernoulli_agrees_with_the_closed_form() {
        for q in (1..4000).map(|i| f64::from(i) * 0.005) {
            let ours = f64::from(bernoulli(f32x4::splat(q as f32)).to_array()[1]);
            let exact = q / q.exp_m1();
            assert!(
                (ours - exact).abs() < 5e-5 * (q + exact),
                "at {q}: {ours} against {exact}"
            );
        }
        assert_eq!(bernoulli(f32x4::ZERO).to_array()[0], 1.0);
        assert_eq!(bernoulli(f32x4::splat(1e10)).to_array()[0], 0.0);
    }
}
