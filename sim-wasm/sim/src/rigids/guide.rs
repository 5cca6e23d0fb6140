//! Guidance of a kinematic rigid: a target pose or a drag.

use crate::layout::limits::TOP_SPEED;
use crate::math::hash::Hash;
use crate::math::pose::{Frame, Pose};
use crate::math::vector::Vector;
use crate::rigids::grab::Grab;

/// The guidance of one rigid.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Pose of a kinematic rigid.
    pub base: Pose,
    /// Velocity (m/s) of the base during a drag, and until the step after it.
    pub velocity: Vector,
    /// Target pose until it is reached; a dynamic rigid is teleported there.
    pub target: Option<Pose>,
    pub grab: Option<Grab>,
}

impl Guide {
    /// No guidance.
    pub fn new(base: Pose) -> Self {
        Self {
            base,
            velocity: Vector::ZERO,
            target: None,
            grab: None,
        }
    }

    /// Advances by `dt` seconds, for a rigid of `reach` (m). None without guidance.
    pub fn next(&mut self, dt: f32, reach: f32) -> Option<Pose> {
        // Not on release: that is an input of this step and must not change the hash before it.
        if self.grab.is_none() {
            self.velocity = Vector::ZERO;
        }
        let goal = self.goal(dt)?;
        self.base = self.base.nearer(&goal, reach, TOP_SPEED * dt);
        if self.base == goal {
            self.target = None;
        }
        Some(self.base)
    }

    fn goal(&mut self, dt: f32) -> Option<Pose> {
        let Some(grab) = &self.grab else {
            return self.target;
        };
        let anchor = Frame::new(&self.base).rotate(grab.anchor);
        self.velocity = grab.spring(self.base.position, self.velocity, grab.target - anchor, dt);
        Some(Pose {
            position: self.base.position + self.velocity * dt,
            ..self.base
        })
    }

    /// Adds the motion to `hash`; nothing without guidance. The target is an input and not part of the state.
    pub fn hash_into(&self, hash: &mut Hash) {
        if self.velocity != Vector::ZERO {
            hash.floats(&<[f32; 3]>::from(self.velocity));
        }
    }
}
