//! Serialisation of rigids by postcard: descriptions, poses, guidance and Rapier's world. Restored rigids continue to
//! the same hash.

use crate::layout::error::{ParameterError, RestoreError};
use crate::math::hash::Hash;
use crate::math::pose::Pose;
use crate::rigids::checks::pose_of;
use crate::rigids::description::RigidDescription;
use crate::rigids::forms;
use crate::rigids::grab::Grab;
use crate::rigids::guide::Guide;
use crate::rigids::numbers::{FlatRigid, RigidNumbers};
use crate::rigids::set::{Member, POSE_PAIR_FLOATS, Rigids, removed};
use crate::rigids::world::World;

/// Flat numbers of a description: numbers, vertices, indices. All are empty for a removed rigid.
type SavedRigid = (Vec<f32>, Vec<f32>, Vec<u32>);
/// Guidance of a rigid: base, velocity, target, grab.
type SavedGuide = ([f32; 7], [f32; 3], Option<[f32; 7]>, Option<[f32; 7]>);
/// Rigids, poses, guidance, and the world as the crate `world` writes it; no bytes of it without Rapier.
type Saved = (Vec<SavedRigid>, Vec<f32>, Vec<SavedGuide>, Vec<u8>);
/// The same, borrowed, for writing.
type SavedRef<'a> = (Vec<SavedRigid>, &'a [f32], Vec<SavedGuide>, Vec<u8>);

const DIGEST_BYTES: usize = 8;

impl Rigids {
    /// Serialises the rigids; empty without rigids.
    pub fn save(&self) -> Vec<u8> {
        if self.count() == 0 {
            return Vec::new();
        }
        let rigids = self.members.iter().map(saved).collect();
        let guides = self.members.iter().map(|member| saved_guide(&member.guide)).collect();
        let state: SavedRef = (rigids, &self.poses, guides, self.world.to_bytes());
        let mut bytes = postcard::to_allocvec(&state).expect("memory takes every byte");
        bytes.extend_from_slice(&digest(&bytes));
        bytes
    }

    /// Restores rigids from the bytes of `save`.
    ///
    /// # Errors
    /// The bytes are not exactly what `save` wrote.
    pub fn restore(bytes: &[u8]) -> Result<Self, RestoreError> {
        if bytes.is_empty() {
            return Ok(Self::new());
        }
        // Rapier trusts its own state: modified bytes must not reach it.
        let split = bytes.len().checked_sub(DIGEST_BYTES).ok_or_else(corrupt)?;
        let (state, checked) = bytes.split_at(split);
        if digest(state) != checked {
            return Err(corrupt());
        }
        let saved: Saved = postcard::from_bytes(state).map_err(|_| corrupt())?;
        Self::of_saved(saved)
    }

    fn of_saved((rigids, poses, guides, physics): Saved) -> Result<Self, RestoreError> {
        let count = rigids.len();
        let world = World::from_bytes(&physics).ok_or_else(corrupt)?;
        let has_world = world.count() > 0;
        if poses.len() != count * POSE_PAIR_FLOATS || guides.len() != count || has_world && world.count() != count {
            return Err(corrupt());
        }
        let mut restored = Self::new();
        restored.world = world;
        for (index, (rigid, guide)) in rigids.iter().zip(guides).enumerate() {
            let base = pose_of(&guide.0).map_err(error_of)?;
            let is_removed = rigid.0.is_empty();
            let mut description = if is_removed { removed(base) } else { described(rigid)? };
            let forms = forms::forms_of(&description).map_err(error_of)?;
            if !has_world {
                // Without Rapier's world they are all fixed or kinematic, and are where their guidance has led them.
                let first = std::mem::replace(&mut description.pose, base);
                restored.world.add(&description, &forms.rapiers);
                description.pose = first;
            }
            if is_removed {
                restored.world.remove(index);
                restored.place_removed(index, base);
                continue;
            }
            restored.place(index, restored.world.pose(index), description, forms.ours);
            let member = restored.members.last_mut().expect("one was just placed");
            restore_guide(&mut member.guide, guide).map_err(error_of)?;
        }
        restored.poses = poses;
        Ok(restored)
    }
}

fn saved_guide(guide: &Guide) -> SavedGuide {
    (
        guide.base.numbers(),
        guide.velocity.into(),
        guide.target.as_ref().map(Pose::numbers),
        guide.grab.as_ref().map(Grab::numbers),
    )
}

fn restore_guide(guide: &mut Guide, (base, velocity, target, grab): SavedGuide) -> Result<(), ParameterError> {
    guide.base = pose_of(&base)?;
    guide.velocity = velocity.into();
    guide.target = target.map(|numbers| pose_of(&numbers)).transpose()?;
    guide.grab = grab
        .map(|[a, b, c, x, y, z, stiffness]| Grab::from_numbers([a, b, c], [x, y, z], stiffness))
        .transpose()?;
    Ok(())
}

fn saved(member: &Member) -> SavedRigid {
    if member.is_removed {
        return SavedRigid::default();
    }
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
    RigidDescription::from_numbers(&flat).map_err(error_of)
}

fn error_of(error: ParameterError) -> RestoreError {
    RestoreError::new(error.message)
}

fn digest(bytes: &[u8]) -> [u8; DIGEST_BYTES] {
    let mut hash = Hash::new();
    hash.bytes(bytes);
    hash.finish().to_le_bytes()
}

fn corrupt() -> RestoreError {
    RestoreError::new("the saved rigids are damaged or not of this version")
}
