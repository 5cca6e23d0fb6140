//! Rigids as bytes, by postcard: descriptions, poses and targets of ours, and Rapier's world as it is, so that what
//! is taken up again goes on to the same hash.

use rapier3d::prelude::PhysicsWorld;

use super::description::{RigidDescription, pose_of};
use super::numbers::{FlatRigid, RigidNumbers};
use super::world::World;
use super::{Member, POSE_PAIR_FLOATS, Rigids, forms, pose_numbers};
use crate::collide::space::Pose;
use crate::error::RestoreError;
use crate::hash::Hash;

/// The description as flat numbers: numbers, vertices, indices.
type SavedRigid = (Vec<f32>, Vec<f32>, Vec<u32>);
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
        let rigids = self.members.iter().map(saved).collect();
        let targets = self
            .members
            .iter()
            .map(|member| member.target.as_ref().map(pose_numbers))
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

fn saved(member: &Member) -> SavedRigid {
    let FlatRigid {
        numbers,
        vertices,
        indices,
    } = member.description.to_numbers();
    (numbers, vertices, indices)
}

fn described((numbers, vertices, indices): &SavedRigid) -> Result<RigidDescription, RestoreError> {
    let flat = RigidNumbers {
        numbers,
        vertices,
        indices,
    };
    RigidDescription::from_numbers(&flat).map_err(|error| RestoreError::new(error.message))
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
