//! The world without Rapier: the poses of rigids that move only as they are told.

use crate::math::hash::Hash;
use crate::math::pose::Pose;
use crate::rigids::description::RigidDescription;
use crate::rigids::forms::RapierShape;

/// Poses after the last step, or before the first. The names are those of Rapier's world.
#[derive(Default)]
pub struct World {
    poses: Vec<Pose>,
}

impl World {
    /// Creates an empty world.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a rigid at its pose.
    pub fn add(&mut self, description: &RigidDescription, _shapes: &[(Pose, RapierShape)]) {
        self.poses.push(description.pose);
    }

    /// Turns a rigid off: nothing, since the poses of others do not depend on it.
    pub fn remove(&mut self, _index: usize) {}

    /// Replaces a rigid that was turned off.
    pub fn replace(&mut self, index: usize, description: &RigidDescription, _shapes: &[(Pose, RapierShape)]) {
        self.head_for(index, &description.pose);
    }

    /// Sets the pose of a kinematic rigid after the coming step.
    pub fn head_for(&mut self, index: usize, pose: &Pose) {
        self.poses[index] = *pose;
    }

    /// The pose of a rigid.
    pub fn pose(&self, index: usize) -> Pose {
        self.poses[index]
    }

    /// Adds nothing to `hash`, which has the poses.
    pub fn hash_into(&self, _index: usize, _hash: &mut Hash) {}

    /// Number of rigids.
    pub fn count(&self) -> usize {
        self.poses.len()
    }

    /// No bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        Vec::new()
    }

    /// An empty world, also for a state with Rapier's: what is saved besides fills it.
    pub fn from_bytes(_bytes: &[u8]) -> Option<Self> {
        Some(Self::new())
    }
}
