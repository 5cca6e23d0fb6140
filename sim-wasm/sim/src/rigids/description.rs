//! What a rigid is made of, and the ranges of what callers give.

use super::path::Path;
use crate::collide::contact::Action;
use crate::collide::space::{Pose, Vector};
use crate::error::ParameterError;

/// Least and greatest length (m) of a shape, and the greatest distance from the world's origin.
pub(super) const LENGTHS: (f64, f64) = (1e-3, 1e3);
pub(super) const PLACES: (f64, f64) = (-1e4, 1e4);
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

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

/// A steady spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// Unit vector in the rigid's own space.
    pub axis: Vector,
    /// rad/s, at most so much that no point of the surface is faster than [`super::TOP_SPEED`]; 0: none.
    pub rate: f32,
}

impl Spin {
    /// No spin.
    pub const NONE: Spin = Spin {
        axis: Vector::Y,
        rate: 0.0,
    };
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

/// Reads position and quaternion, which is brought to unit length.
///
/// # Errors
/// When a number is missing, not finite or too large, or the quaternion has no direction.
pub fn pose_of(numbers: &[f32]) -> Result<Pose, ParameterError> {
    pose_under("rigid", numbers)
}

/// The same, of the thing called `name`.
pub(super) fn pose_under(name: &str, numbers: &[f32]) -> Result<Pose, ParameterError> {
    let Ok([x, y, z, rotation @ ..]) = <[f32; 7]>::try_from(numbers) else {
        return Err(count_error(&format!("{name}.pose"), numbers.len(), 7));
    };
    for (axis, value) in AXES.iter().zip([x, y, z]) {
        ranged(&format!("{name}.position.{axis}"), value, PLACES)?;
    }
    for (part, value) in ["x", "y", "z", "w"].iter().zip(rotation) {
        ranged(&format!("{name}.rotation.{part}"), value, (-1e3, 1e3))?;
    }
    let length = rotation.iter().map(|part| part * part).sum::<f32>().sqrt();
    ranged(&format!("{name}.rotation"), length, (1e-3, 2e3))?;
    // What is a unit but for rounding stays bit for bit, or a saved pose would not come back as it was.
    let scale = if (length - 1.0).abs() < 1e-5 { 1.0 } else { length };
    Ok(Pose {
        position: Vector::new(x, y, z),
        rotation: rotation.map(|part| part / scale),
    })
}

/// A number that must be finite and within a range.
pub(super) fn ranged(key: &str, value: f32, (min, max): (f64, f64)) -> Result<f32, ParameterError> {
    let wide = f64::from(value);
    // The bounds are compared as f32 too, so that a caller's 0.001 is not refused for being 0.00099999.
    if value.is_finite() && value >= min as f32 && value <= max as f32 {
        Ok(value)
    } else {
        Err(ParameterError::out_of_range(key, wide, min, max))
    }
}

/// A refusal of a list that has not the length that it must have.
pub(super) fn count_error(key: &str, count: usize, wanted: usize) -> ParameterError {
    shape_error(
        key,
        count as f64,
        format!("{key} takes {wanted} numbers and was given {count}"),
    )
}

/// A refusal that no range explains.
pub fn shape_error(key: &str, value: f64, message: String) -> ParameterError {
    ParameterError {
        key: key.to_owned(),
        value,
        min: f64::NAN,
        max: f64::NAN,
        message,
    }
}
