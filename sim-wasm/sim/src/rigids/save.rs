//! Rigids as bytes, by postcard: descriptions, poses and targets of ours, and Rapier's world as it is, so that what
//! is taken up again goes on to the same hash.

use rapier3d::prelude::PhysicsWorld;

use super::description::{RigidDescription, RigidKind, RigidNumbers, RigidShape, pose_of};
use super::world::World;
use super::{POSE_PAIR_FLOATS, Rigids, forms, numbers};
use crate::collide::space::Pose;
use crate::error::RestoreError;
use crate::hash::Hash;

/// kind, shape, dimensions, vertices, indices, pose at creation, and restitution, friction, density.
type SavedRigid = (u8, u8, Vec<f32>, Vec<f32>, Vec<u32>, [f32; 7], [f32; 3]);
type Saved = (Vec<SavedRigid>, Vec<f32>, Vec<Option<[f32; 7]>>, PhysicsWorld);
/// The same, borrowed, which is all that writing needs.
type SavedRef<'a> = (Vec<SavedRigid>, &'a [f32], Vec<Option<[f32; 7]>>, &'a PhysicsWorld);

const DIGEST_BYTES: usize = 8;

impl Rigids {
    /// The rigids' state as bytes; empty when there are none.
    pub fn save(&self) -> Vec<u8> {
        if self.count() == 0 {
            return Vec::new();
        }
        let rigids = self.members.iter().map(|member| saved(&member.description)).collect();
        let targets = self
            .members
            .iter()
            .map(|member| member.target.as_ref().map(numbers))
            .collect();
        let state: SavedRef = (rigids, &self.poses, targets, self.world.physics());
        let mut bytes = postcard::to_allocvec(&state).expect("memory takes every byte");
        bytes.extend_from_slice(&digest(&bytes));
        bytes
    }

    /// Rigids from bytes that `save` made; refuses corrupt ones.
    ///
    /// # Errors
    /// When the bytes are not exactly what `save` made.
    pub fn restore(bytes: &[u8]) -> Result<Self, RestoreError> {
        if bytes.is_empty() {
            return Ok(Self::new());
        }
        // Rapier trusts its own state: bytes that were changed must not reach it.
        let split = bytes.len().checked_sub(DIGEST_BYTES).ok_or_else(corrupt)?;
        let (state, checked) = bytes.split_at(split);
        if digest(state) != checked {
            return Err(corrupt());
        }
        let saved: Saved = postcard::from_bytes(state).map_err(|_| corrupt())?;
        Self::of_saved(saved)
    }

    fn of_saved((rigids, poses, targets, physics): Saved) -> Result<Self, RestoreError> {
        let count = rigids.len();
        if poses.len() != count * POSE_PAIR_FLOATS || targets.len() != count || physics.bodies.len() != count {
            return Err(corrupt());
        }
        let mut restored = Self::new();
        restored.world = World::of(physics);
        for (rigid, target) in rigids.iter().zip(targets) {
            let description = described(rigid)?;
            let forms = forms::forms_of(&description).map_err(|error| RestoreError::new(error.message))?;
            restored.place(description, forms.ours);
            restored.members.last_mut().expect("one was just placed").target = read_target(target)?;
        }
        restored.poses = poses;
        Ok(restored)
    }
}

fn saved(description: &RigidDescription) -> SavedRigid {
    let kind = match description.kind {
        RigidKind::Fixed => 0,
        RigidKind::Kinematic => 1,
        RigidKind::Dynamic => 2,
    };
    let none = (Vec::new(), Vec::new());
    let (shape, dimensions, (vertices, indices)) = match &description.shape {
        RigidShape::Ball { radius } => (0, vec![*radius], none),
        RigidShape::Cuboid { half_extents } => (1, half_extents.to_vec(), none),
        RigidShape::Capsule { half_height, radius } => (2, vec![*half_height, *radius], none),
        RigidShape::Cylinder { half_height, radius } => (3, vec![*half_height, *radius], none),
        RigidShape::ConvexHull { vertices } => (4, Vec::new(), (vertices.concat(), Vec::new())),
        RigidShape::Trimesh { vertices, indices } => (5, Vec::new(), (vertices.concat(), indices.concat())),
    };
    let surface = [description.restitution, description.friction, description.density];
    (
        kind,
        shape,
        dimensions,
        vertices,
        indices,
        numbers(&description.pose),
        surface,
    )
}

fn described(rigid: &SavedRigid) -> Result<RigidDescription, RestoreError> {
    let (kind, shape, dimensions, vertices, indices, pose, [restitution, friction, density]) = rigid;
    let numbers = RigidNumbers {
        kind: *kind,
        shape: *shape,
        dimensions,
        vertices,
        indices,
        pose,
        restitution: *restitution,
        friction: *friction,
        density: *density,
    };
    RigidDescription::from_numbers(&numbers).map_err(|error| RestoreError::new(error.message))
}

fn read_target(target: Option<[f32; 7]>) -> Result<Option<Pose>, RestoreError> {
    target
        .map(|floats| pose_of(&floats))
        .transpose()
        .map_err(|error| RestoreError::new(error.message))
}

fn digest(bytes: &[u8]) -> [u8; DIGEST_BYTES] {
    let mut hash = Hash::new();
    hash.bytes(bytes);
    hash.finish().to_le_bytes()
}

fn corrupt() -> RestoreError {
    RestoreError::new("the saved rigids are damaged or not of this version")
}
