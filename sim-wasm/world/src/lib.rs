//! Serialisation of Rapier's world by postcard, including contacts and their history, without which a pile of rigids
//! would not continue identically. Joints, multibodies and soft bodies are omitted, since there are none: reading
//! multibodies and soft bodies would be a tenth of the module.

use rapier3d::dynamics::{IntegrationParameters, IslandManager, RigidBodySet};
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
);
/// The same, borrowed, for writing.
type SavedRef<'a> = (
    [f32; 3],
    &'a IntegrationParameters,
    &'a IslandManager,
    &'a BroadPhaseBvh,
    &'a NarrowPhase,
    &'a RigidBodySet,
    &'a ColliderSet,
);

/// Everything that the next step depends on.
pub fn to_bytes(world: &PhysicsWorld) -> Vec<u8> {
    let state: SavedRef = (
        world.gravity.to_array(),
        &world.integration_parameters,
        &world.islands,
        &world.broad_phase,
        &world.narrow_phase,
        &world.bodies,
        &world.colliders,
    );
    postcard::to_allocvec(&state).expect("memory takes every byte")
}

/// Restores the bytes of [`to_bytes`]; none for other bytes, as far as that can be detected. Rapier trusts its own
/// state: bytes that may have been modified must not be passed.
pub fn from_bytes(bytes: &[u8]) -> Option<PhysicsWorld> {
    let saved: Saved = postcard::from_bytes(bytes).ok()?;
    let (gravity, integration_parameters, islands, broad_phase, narrow_phase, bodies, colliders) = saved;
    Some(PhysicsWorld {
        gravity: gravity.into(),
        integration_parameters,
        islands,
        broad_phase,
        narrow_phase,
        bodies,
        colliders,
        ..PhysicsWorld::new()
    })
}
