//! Where, when and on what a force acts: a region of space, an envelope in time, and the rigid or part it rides on.

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

/// The moment of a step, and where the rigids and parts are in it.
#[derive(Clone, Copy, Debug)]
pub struct StepTime<'r> {
    /// Simulated seconds at the middle of the step.
    pub time: f64,
    /// Length of the step (s).
    pub dt: f64,
    /// Of each rigid its pose before and after the step, 14 numbers as `rigids::Rigids::poses` has them.
    pub poses: &'r [f32],
    /// The parts in this step.
    pub parts: &'r Parts,
}

impl StepTime<'_> {
    /// Where the rigid or part that `scope` rides on is at `fraction` of the step; none where it rides on none that
    /// exists.
    pub fn ride(&self, scope: &Scope, fraction: f32) -> Option<Pose> {
        let rigid = || {
            (scope.rigid >= 0.0)
                .then(|| ends_of_rigid(self.poses, scope.rigid as usize))
                .flatten()
        };
        let [before, after] = self.parts.ends(scope.rigid).or_else(rigid)?;
        Some(before.towards(&after, fraction))
    }

    /// The frame in which the positions and directions of what has this `scope` are meant, in the middle of the step.
    pub fn frame(&self, scope: &Scope) -> Frame {
        Frame::new(&self.ride(scope, 0.5).unwrap_or(Pose::at(Vector::ZERO)))
    }
}

/// A scope made ready for the lanes.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    level: f32x4,
    shape: Shape,
}

impl Reach {
    /// How `scope` acts in this step; none while it is switched off.
    pub fn new(scope: &Scope, now: &StepTime) -> Option<Self> {
        let level = envelope::level(scope, now.time);
        (level > 0.0).then(|| Self {
            level: f32x4::splat(level as f32),
            shape: Shape::new(scope, &now.frame(scope)),
        })
    }

    /// Acts fully, at all places and all the time.
    pub fn everywhere() -> Self {
        Self {
            level: f32x4::ONE,
            shape: Shape::All,
        }
    }

    /// How strongly it acts at each place, 0..=1.
    #[inline(always)]
    pub fn weigh(&self, places: &[Vector4], weights: &mut [f32x4]) {
        self.shape.weigh(places, self.level, weights);
    }
}
