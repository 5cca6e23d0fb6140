//! Guidance of a kinematic rigid: a target pose, a path or a drag, plus a spin.

use crate::math::hash::Hash;
use crate::math::pose::{Frame, Pose, product, rotation_about};
use crate::math::vector::Vector;
use crate::rigids::checks::{TOP_SPEED, pose_numbers};
use crate::rigids::grab::Grab;
use crate::rigids::spin::Spin;
use crate::rigids::track::Track;

/// The guidance of one rigid.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Pose without the spin.
    pub base: Pose,
    /// Velocity (m/s) of the base during a drag, and until the step after it.
    pub velocity: Vector,
    /// Angle of the spin (rad), 0..2 pi.
    pub angle: f64,
    /// Target pose until it is reached; a dynamic rigid is teleported there.
    pub target: Option<Pose>,
    pub track: Option<Track>,
    pub grab: Option<Grab>,
}

impl Guide {
    /// No guidance.
    pub fn new(base: Pose) -> Self {
        Self {
            base,
            velocity: Vector::ZERO,
            angle: 0.0,
            target: None,
            track: None,
            grab: None,
        }
    }

    /// Advances by `dt` seconds, up to `time` (s), for a rigid of `reach` (m). None without guidance.
    pub fn next(&mut self, time: f64, dt: f32, reach: f32, spin: &Spin) -> Option<Pose> {
        // Not on release: that is an input of this step and must not change the hash before it.
        if self.grab.is_none() {
            self.velocity = Vector::ZERO;
        }
        let led = self.grab.is_some() || self.track.is_some() || self.target.is_some();
        if !led && spin.rate == 0.0 {
            return None;
        }
        if let Some(goal) = self.goal(time, dt) {
            self.go_to(&goal, dt, reach);
        }
        let turned = self.angle + f64::from(spin.rate) * f64::from(dt);
        self.angle = turned - libm::floor(turned / std::f64::consts::TAU) * std::f64::consts::TAU;
        Some(self.pose(spin))
    }

    /// The base pose with the spin applied.
    pub fn pose(&self, spin: &Spin) -> Pose {
        if spin.rate == 0.0 && self.angle == 0.0 {
            return self.base;
        }
        Pose {
            position: self.base.position,
            rotation: product(self.base.rotation, rotation_about(spin.axis * self.angle as f32)),
        }
    }

    /// Rotation vector (rad, world space) of the spin in `dt` seconds.
    pub fn rotation_vector(&self, spin: &Spin, dt: f32) -> Vector {
        Frame::new(&self.base).rotate(spin.axis) * (spin.rate * dt)
    }

    fn goal(&mut self, time: f64, dt: f32) -> Option<Pose> {
        if let Some(grab) = &self.grab {
            let anchor = Frame::new(&self.base).rotate(grab.anchor);
            self.velocity = grab.spring(self.base.position, self.velocity, grab.target - anchor, dt);
            return Some(Pose {
                position: self.base.position + self.velocity * dt,
                ..self.base
            });
        }
        if let Some(track) = &self.track {
            return Some(track.pose(time, self.base.rotation));
        }
        self.target
    }

    /// Moves towards `goal` as far as [`TOP_SPEED`] allows.
    fn go_to(&mut self, goal: &Pose, dt: f32, reach: f32) {
        let way = (goal.position - self.base.position).length();
        let arc = self.base.rotation_vector_to(goal).length() * reach;
        let share = TOP_SPEED * dt / (way + arc).max(f32::MIN_POSITIVE);
        if share >= 1.0 {
            self.target = None;
            self.base = *goal;
        } else {
            self.base = self.base.towards(goal, share);
        }
    }

    /// Adds the motion to `hash`; nothing without guidance. The target is an input and not part of the state.
    pub fn hash_into(&self, hash: &mut Hash) {
        if self.angle != 0.0 {
            hash.floats(&pose_numbers(&self.base));
            hash.long(self.angle.to_bits());
        }
        if self.velocity != Vector::ZERO {
            hash.floats(&<[f32; 3]>::from(self.velocity));
        }
    }
}
