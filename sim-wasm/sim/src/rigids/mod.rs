//! Rigid bodies: moving or arbitrarily shaped obstacles.
//!
//! Rapier moves the rigids, not the particles. After its step each rigid is an obstacle that moves from its previous
//! pose to its new one; particles collide with it as in [`crate::collide`]. Without Rapier, with the feature `meshes`
//! only, all rigids are fixed or kinematic.

pub mod checks;
pub(crate) mod commands;
pub(crate) mod compound;
pub mod description;
pub(crate) mod forms;
pub(crate) mod grab;
pub(crate) mod grid;
pub(crate) mod guide;
#[cfg(feature = "rigids")]
pub(crate) mod hulls;
pub(crate) mod layer;
pub(crate) mod meshes;
pub(crate) mod numbers;
#[cfg(feature = "rigids")]
pub(crate) mod particle_coupling;
pub(crate) mod save;
pub(crate) mod set;
pub(crate) mod shells;
#[cfg(feature = "rigids")]
pub(crate) mod world;
#[cfg(not(feature = "rigids"))]
#[path = "guided_world.rs"]
pub(crate) mod world;

pub use crate::layout::limits::TOP_SPEED;
pub use checks::pose_of;
pub use description::{RigidDescription, RigidKind, RigidPart, RigidShape};
pub use grab::Grab;
pub use numbers::{FlatRigid, RigidNumbers};
pub use set::{POSE_PAIR_FLOATS, Rigids};
