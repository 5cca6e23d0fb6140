//! What a rigid is made of, and the ranges of what callers give.

use crate::collide::contact::Action;
use crate::math::pose::Pose;
use crate::rigids::path::Path;
use crate::rigids::spin::Spin;

/// How a rigid moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RigidKind {
    /// Never.
    Fixed,
    /// Where it is told.
    Kinematic,
    /// As forces and other rigids make it.
    Dynamic,
}

/// The form of a rigid about its own origin; metres.
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
    /// The hull of these points.
    ConvexHull {
        vertices: Vec<[f32; 3]>,
    },
    /// Triangles; when they close a volume it is solid, else they are a thin sheet.
    Trimesh {
        vertices: Vec<[f32; 3]>,
        indices: Vec<[u32; 3]>,
    },
    /// Several shapes that move as one, 1..=64; none of them a compound.
    Compound {
        parts: Vec<RigidPart>,
    },
}

/// A shape of a compound and where it stands in the rigid.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPart {
    pub shape: RigidShape,
    pub pose: Pose,
}

/// A rigid before it is added.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidDescription {
    pub kind: RigidKind,
    pub shape: RigidShape,
    pub pose: Pose,
    /// Share of the normal velocity that comes back, 0..1.
    pub restitution: f32,
    /// Share of the tangential velocity that a particle loses, 0..1; among rigids Coulomb's coefficient.
    pub friction: f32,
    /// kg/m3, 0.01..100,000.
    pub density: f32,
    /// What becomes of particles that touch it; other rigids bump into it all the same.
    pub action: Action,
    /// Within this distance (m) air is dragged along with the moving surface, 0..10; 0: none is.
    pub boundary_layer: f32,
    /// How strongly smoke pushes a dynamic rigid, 0..10; 0: not at all, 1: as air would.
    pub feels_smoke: f32,
    /// How a kinematic rigid spins, on top of all else that moves it.
    pub spin: Spin,
    /// Where a kinematic rigid goes by itself. It begins at `pose` all the same.
    pub path: Option<Path>,
}

impl RigidDescription {
    /// A rigid of which nothing but this is said: it does not bounce, its friction is 0.5, and it is as dense as water.
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
            spin: Spin::NONE,
            path: None,
        }
    }
}
