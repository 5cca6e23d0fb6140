//! Rapier's world as bytes and back, by postcard: contacts and their history too, without which a pile of rigids would
//! go on differently. Multibodies and soft bodies are left out, since no rigid is one: what reads them would be a tenth
//! of the module.

use rapier3d::dynamics::{ImpulseJointSet, IntegrationParameters, IslandManager, RigidBodySet};
use rapier3d::geometry::{BroadPhaseBvh, ColliderSet, NarrowPhase};
use rapier3d::prelude::PhysicsWorld;

type Saved = (
    [f32; 3],
    IntegrationParameters,
    IslandManager,
    BroadPhaseBvh,
    NarrowPhase,
    RigidBodySet,
    ColliderSet,
    ImpulseJointSet,
);
/// The same, borrowed, which is all that writing needs.
type SavedRef<'a> = (
    [f32; 3],
    &'a IntegrationParameters,
    &'a IslandManager,
    &'a BroadPhaseBvh,
    &'a NarrowPhase,
    &'a RigidBodySet,
    &'a ColliderSet,
    &'a ImpulseJointSet,
);

/// All that the next step depends on.
pub fn to_bytes(world: &PhysicsWorld) -> Vec<u8> {
    let state: SavedRef = (
        world.gravity.to_array(),
        &world.integration_parameters,
        &world.islands,
        &world.broad_phase,
        &world.narrow_phase,
        &world.bodies,
        &world.colliders,
        &world.impulse_joints,
    );
    postcard::to_allocvec(&state).expect("memory takes every byte")
}

/// The world of bytes that [`to_bytes`] made. None for others, as far as that can be told: Rapier trusts its own
/// state, so bytes that somebody may have changed must not come here.
pub fn from_bytes(bytes: &[u8]) -> Option<PhysicsWorld> {
    let saved: Saved = postcard::from_bytes(bytes).ok()?;
    let (gravity, integration_parameters, islands, broad_phase, narrow_phase, bodies, colliders, impulse_joints) =
        saved;
    Some(PhysicsWorld {
        gravity: gravity.into(),
        integration_parameters,
        islands,
        broad_phase,
        narrow_phase,
        bodies,
        colliders,
        impulse_joints,
        ..PhysicsWorld::new()
    })
}
