//! Inflow and updraft of a vortex.
//!
//! Inflow: at the distance r the air moves towards the axis at I m c s(r) / s(c), with s(r) = r times the profile of
//! the angular velocity. Like the swirl it is 0 at the axis, `inflow` I (m/s) at the core radius c and falls with 1 / r
//! outside, so the air spirals in at a constant angle. Updraft: along the axis at W m (1 - (r / c)^4)^2 with `updraft`
//! W (m/s), 0 from the core radius on. Both fade at the reach as the swirl does.
//!
//! The updraft is free of divergence. So is the inflow outside the core, except for the fade: the core acts as a sink.
//! The vortex of Burgers, u_r = -a r, u_z = 2 a z, would be free of divergence, but its updraft grows without bound
//! along the axis.
//!
//! In a step h a particle that rotates by 2 p approaches the axis by the factor exp(-2 j), where j is half of h times
//! the rate of the inflow. From the position x over the middle M = exp(-j) R(p) x to the end its displacement is
//!
//! 2 (cosh j sin p (axis x M) - sinh j cos p M),
//!
//! which is the chord of a spiral. j is limited to 1/2, where the series below is accurate to 3e-4: the distance
//! shrinks by at most the factor e per step.

use wide::f32x4;

use crate::forces::vortex::swirl::{HalfRotation, Profile, Swirl, is_rankine};
use crate::layout::parameters::forces::vortex::Vortex;
use crate::math::simd::{Vector4, larger, positive_part, smaller};

/// Inflow and updraft of a vortex.
#[derive(Clone, Copy, Debug)]
pub struct Draft {
    /// Rate of the inflow at the axis (1/s).
    inflow: f32x4,
    /// Velocity at the axis (m/s).
    updraft: f32x4,
    /// Half of the step (s), and twice its inverse (1/s).
    half: f32x4,
    per_half: f32x4,
}

/// The draft at a place: the exponent j of half a step, and the velocity along the axis (m/s).
struct Pull {
    exponent: f32x4,
    lift: f32x4,
}

impl Draft {
    /// The draft of `vortex` times `strength` for steps of `dt` seconds; none without inflow and updraft.
    pub(super) fn new(vortex: &Vortex, strength: f64, dt: f32) -> Option<Self> {
        let at_core = if is_rankine(vortex) { 1.0 } else { -libm::expm1(-1.0) };
        let inflow = vortex.inflow * strength / (vortex.core_radius * at_core);
        let updraft = vortex.updraft * strength;
        (inflow != 0.0 || updraft != 0.0).then(|| Self {
            inflow: f32x4::splat(inflow as f32),
            updraft: f32x4::splat(updraft as f32),
            half: f32x4::splat(dt * 0.5),
            per_half: f32x4::splat(2.0 / dt),
        })
    }

    /// Velocity (m/s) at four places.
    #[inline(always)]
    pub(super) fn velocity(&self, swirl: &Swirl, place: Vector4) -> Vector4 {
        let around = swirl.around(place);
        let profile = swirl.profile(around.dot(around));
        let rate = self.inflow * profile.fade / profile.divisor;
        swirl.inwards(around) * rate + swirl.axis * self.lift(&profile)
    }

    /// Displacement (m) of half a step, in addition to that by `rotation`. `ahead` is the expected middle.
    #[inline(always)]
    pub(super) fn half_step(
        &self,
        swirl: &Swirl,
        place: Vector4,
        ahead: Vector4,
        rotation: &HalfRotation,
        weight: f32x4,
    ) -> Vector4 {
        let Pull { exponent, lift } = self.pull(swirl, ahead, weight);
        let around = swirl.around(place);
        let turned = swirl.inwards(around) - swirl.half_step(place, rotation);
        let (sinh, cosh) = hyperbolic(exponent);
        turned * (sinh - cosh) + swirl.axis * (lift * self.half)
    }

    /// Velocity (m/s) along the chord, in addition to that of `rotation`. `middle` is exact: the expected middle lies
    /// outside of the circle of a fast vortex.
    #[inline(always)]
    pub(super) fn chord_velocity(
        &self,
        swirl: &Swirl,
        middle: Vector4,
        rotation: &HalfRotation,
        weight: f32x4,
    ) -> Vector4 {
        let Pull { exponent, lift } = self.pull(swirl, middle, weight);
        let around = swirl.around(middle);
        let (sinh, cosh) = hyperbolic(exponent);
        let (sine, cosine) = (
            rotation.sine + rotation.sine,
            f32x4::ONE - (rotation.cosine + rotation.cosine),
        );
        (around * (cosh * sine) + swirl.inwards(around) * (sinh * cosine)) * self.per_half + swirl.axis * lift
    }

    #[inline(always)]
    fn pull(&self, swirl: &Swirl, place: Vector4, weight: f32x4) -> Pull {
        let around = swirl.around(place);
        let profile = swirl.profile(around.dot(around));
        let exponent = self.inflow * profile.fade * (self.half * weight) / profile.divisor;
        Pull {
            exponent: larger(smaller(exponent, f32x4::HALF), -f32x4::HALF),
            lift: self.lift(&profile) * weight,
        }
    }

    #[inline(always)]
    fn lift(&self, profile: &Profile) -> f32x4 {
        let inside = positive_part(f32x4::ONE - profile.q * profile.q);
        self.updraft * profile.fade * (inside * inside)
    }
}

/// sinh(j), and cosh(j) - 1, for |j| <= 1/2.
#[inline(always)]
fn hyperbolic(j: f32x4) -> (f32x4, f32x4) {
    let square = j * j;
    let sixth = f32x4::splat(1.0 / 6.0);
    (
        j + j * (square * sixth),
        square * (f32x4::HALF + square * f32x4::splat(1.0 / 24.0)),
    )
}
