//! Descriptions of rigids.

use crate::collide::contact::Action;
use crate::math::pose::Pose;

/// How a rigid moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RigidKind {
    /// Does not move.
    Fixed,
    /// Moves as commanded.
    Kinematic,
    /// Moves by forces and contacts.
    Dynamic,
}

/// The shape of a rigid about its origin; lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum RigidShape {
    Ball {
        radius: f32,
    },
    Cuboid {
        half_extents: [f32; 3],
    },
    /// Along y; `half_height` is half of the straight part.
    Capsule {
        half_height: f32,
        radius: f32,
    },
    /// Along y.
    Cylinder {
        half_height: f32,
        radius: f32,
    },
    /// The convex hull of points.
    ConvexHull {
        vertices: Vec<[f32; 3]>,
    },
    /// A triangle mesh: solid if it is closed, else a thin sheet.
    Trimesh {
        vertices: Vec<[f32; 3]>,
        indices: Vec<[u32; 3]>,
    },
    /// 1..=64 shapes that move as one. A compound must not contain compounds.
    Compound {
        parts: Vec<RigidPart>,
    },
}

/// A shape of a compound and its pose in the rigid.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPart {
    pub shape: RigidShape,
    pub pose: Pose,
}

/// The description of a rigid.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidDescription {
    pub kind: RigidKind,
    pub shape: RigidShape,
    pub pose: Pose,
    /// Share of the normal velocity that is reflected, 0..1.
    pub restitution: f32,
    /// Share of the tangential velocity that particles lose, 0..1; Coulomb's coefficient between rigids.
    pub friction: f32,
    /// Density, 0.01..=100,000 kg/m3.
    pub density: f32,
    /// Effect on particles that touch it. Rigids collide with it regardless.
    pub action: Action,
    /// Thickness of the boundary layer in which the surface drags air along, 0..=10 m; 0: none.
    pub boundary_layer: f32,
    /// Strength of the force of smoke on a dynamic rigid, 0..=10; 0: none, 1: as air.
    pub feels_smoke: f32,
}

impl RigidDescription {
    /// Defaults for all other fields: restitution 0, friction 0.5, the density of water.
    pub fn new(kind: RigidKind, shape: RigidShape, pose: Pose) -> Self {
        Self {
            kind,
            shape,
            pose,
            restitution: 0.0,
            friction: 0.5,
            density: 1000.0,
            action: Action::Bounce,
            boundary_layer: 0.0,
            feels_smoke: 0.0,
        }
    }
}
