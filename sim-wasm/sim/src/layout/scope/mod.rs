//! Scopes: a region of space, an envelope in time, and the rigid or part that an effect is attached to.

pub mod envelope;
pub mod parts;
pub mod region;

use wide::f32x4;

use crate::layout::parameters::item::Scope;
use crate::layout::scope::parts::{Parts, ends_of_rigid};
use crate::layout::scope::region::Shape;
use crate::math::pose::{Frame, Pose};
use crate::math::simd::Vector4;
use crate::math::vector::Vector;

/// Time of a step, and the poses of rigids and parts in it.
#[derive(Clone, Copy, Debug)]
pub struct StepTime<'r> {
    /// Simulated time at the middle of the step (s).
    pub time: f64,
    /// Length of the step (s).
    pub dt: f64,
    /// Poses of all rigids before and after the step, 14 numbers each. See `rigids::Rigids::poses`.
    pub poses: &'r [f32],
    /// Parts of the scene.
    pub parts: &'r Parts,
}

impl StepTime<'_> {
    /// Pose of the rigid or part of `scope` at `fraction` of the step; none if there is no such rigid or part.
    pub fn ride(&self, scope: &Scope, fraction: f32) -> Option<Pose> {
        let rigid = || {
            (scope.rigid >= 0.0)
                .then(|| ends_of_rigid(self.poses, scope.rigid as usize))
                .flatten()
        };
        let [before, after] = self.parts.ends(scope.rigid).or_else(rigid)?;
        Some(before.towards(&after, fraction))
    }

    /// Coordinate frame of `scope` in the middle of the step.
    pub fn frame(&self, scope: &Scope) -> Frame {
        Frame::new(&self.ride(scope, 0.5).unwrap_or(Pose::at(Vector::ZERO)))
    }
}

/// A scope prepared for SIMD lanes.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    level: f32x4,
    shape: Shape,
}

impl Reach {
    /// Prepares `scope` for this step; none while its level is 0.
    pub fn new(scope: &Scope, now: &StepTime) -> Option<Self> {
        let level = envelope::level(scope, now.time);
        (level > 0.0).then(|| Self {
            level: f32x4::splat(level as f32),
            shape: Shape::new(scope, &now.frame(scope)),
        })
    }

    /// Full strength everywhere and always.
    pub fn everywhere() -> Self {
        Self {
            level: f32x4::ONE,
            shape: Shape::All,
        }
    }

    /// Writes the strength at each place, 0..=1.
    #[inline(always)]
    pub fn weigh(&self, places: &[Vector4], weights: &mut [f32x4]) {
        self.shape.weigh(places, self.level, weights);
    }
}
