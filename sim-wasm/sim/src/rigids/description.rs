//! What a rigid is made of, and what is refused.

use crate::collide::space::{Pose, Vector};
use crate::error::ParameterError;

/// Least and greatest length (m) of a shape, and the greatest distance from the world's origin.
const LENGTHS: (f64, f64) = (1e-3, 1e3);
const PLACES: (f64, f64) = (-1e4, 1e4);
const DENSITIES: (f64, f64) = (1e-2, 1e5);
const AXES: [&str; 3] = ["x", "y", "z"];

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
}

/// A rigid as flat numbers: how it crosses a language boundary and how it is saved.
#[derive(Clone, Copy, Debug)]
pub struct RigidNumbers<'a> {
    /// 0 fixed, 1 kinematic, 2 dynamic.
    pub kind: u8,
    /// 0 ball, 1 cuboid, 2 capsule, 3 cylinder, 4 convex hull, 5 trimesh.
    pub shape: u8,
    /// Ball: radius. Cuboid: half extents. Capsule and cylinder: half height, radius. Else nothing.
    pub dimensions: &'a [f32],
    /// x, y, z of each vertex.
    pub vertices: &'a [f32],
    /// Three vertices of each triangle.
    pub indices: &'a [u32],
    /// Position x, y, z, then the quaternion x, y, z, w.
    pub pose: &'a [f32],
    pub restitution: f32,
    pub friction: f32,
    pub density: f32,
}

impl RigidDescription {
    /// Reads and checks flat numbers.
    ///
    /// # Errors
    /// Names the number that is not finite or out of range, as `rigid.*`. Whether points span a hull is judged when
    /// the rigid is added.
    pub fn from_numbers(numbers: &RigidNumbers) -> Result<Self, ParameterError> {
        Ok(Self {
            kind: kind_of(numbers.kind)?,
            shape: shape_of(numbers)?,
            pose: pose_of(numbers.pose)?,
            restitution: ranged("rigid.restitution", numbers.restitution, (0.0, 1.0))?,
            friction: ranged("rigid.friction", numbers.friction, (0.0, 1.0))?,
            density: ranged("rigid.density", numbers.density, DENSITIES)?,
        })
    }
}

/// Reads position and quaternion, which is brought to unit length.
///
/// # Errors
/// When a number is missing, not finite or too large, or the quaternion has no direction.
pub fn pose_of(numbers: &[f32]) -> Result<Pose, ParameterError> {
    let Ok([x, y, z, rotation @ ..]) = <[f32; 7]>::try_from(numbers) else {
        return Err(count_error("rigid.pose", numbers.len(), 7));
    };
    for (axis, value) in AXES.iter().zip([x, y, z]) {
        ranged(&format!("rigid.position.{axis}"), value, PLACES)?;
    }
    for (part, value) in ["x", "y", "z", "w"].iter().zip(rotation) {
        ranged(&format!("rigid.rotation.{part}"), value, (-1e3, 1e3))?;
    }
    let length = rotation.iter().map(|part| part * part).sum::<f32>().sqrt();
    ranged("rigid.rotation", length, (1e-3, 2e3))?;
    // What is a unit but for rounding stays bit for bit, or a saved pose would not come back as it was.
    let scale = if (length - 1.0).abs() < 1e-5 { 1.0 } else { length };
    Ok(Pose {
        position: Vector::new(x, y, z),
        rotation: rotation.map(|part| part / scale),
    })
}

fn kind_of(number: u8) -> Result<RigidKind, ParameterError> {
    match number {
        0 => Ok(RigidKind::Fixed),
        1 => Ok(RigidKind::Kinematic),
        2 => Ok(RigidKind::Dynamic),
        other => Err(ParameterError::out_of_range("rigid.kind", f64::from(other), 0.0, 2.0)),
    }
}

fn shape_of(numbers: &RigidNumbers) -> Result<RigidShape, ParameterError> {
    match numbers.shape {
        0 => dimensions(numbers.dimensions).map(|[radius]| RigidShape::Ball { radius }),
        1 => dimensions(numbers.dimensions).map(|half_extents| RigidShape::Cuboid { half_extents }),
        2 => dimensions(numbers.dimensions).map(|[half_height, radius]| RigidShape::Capsule { half_height, radius }),
        3 => dimensions(numbers.dimensions).map(|[half_height, radius]| RigidShape::Cylinder { half_height, radius }),
        4 => vertices_of(numbers.vertices).map(|vertices| RigidShape::ConvexHull { vertices }),
        5 => trimesh_of(numbers.vertices, numbers.indices),
        other => Err(ParameterError::out_of_range("rigid.shape", f64::from(other), 0.0, 5.0)),
    }
}

fn dimensions<const COUNT: usize>(numbers: &[f32]) -> Result<[f32; COUNT], ParameterError> {
    let Ok(lengths) = <[f32; COUNT]>::try_from(numbers) else {
        return Err(count_error("rigid.dimensions", numbers.len(), COUNT));
    };
    for (place, length) in lengths.iter().enumerate() {
        ranged(&format!("rigid.dimensions.{place}"), *length, LENGTHS)?;
    }
    Ok(lengths)
}

fn vertices_of(numbers: &[f32]) -> Result<Vec<[f32; 3]>, ParameterError> {
    let (triples, rest) = numbers.as_chunks::<3>();
    if triples.is_empty() || !rest.is_empty() {
        let message = "rigid.vertices takes three numbers for each vertex, at least one vertex".to_owned();
        return Err(shape_error("rigid.vertices", numbers.len() as f64, message));
    }
    for (place, value) in numbers.iter().enumerate() {
        ranged(
            &format!("rigid.vertices.{}.{}", place / 3, AXES[place % 3]),
            *value,
            (-LENGTHS.1, LENGTHS.1),
        )?;
    }
    Ok(triples.to_vec())
}

fn trimesh_of(vertices: &[f32], indices: &[u32]) -> Result<RigidShape, ParameterError> {
    let vertices = vertices_of(vertices)?;
    let (triples, rest) = indices.as_chunks::<3>();
    if triples.is_empty() || !rest.is_empty() {
        let message = "rigid.indices takes three indices for each triangle, at least one triangle".to_owned();
        return Err(shape_error("rigid.indices", indices.len() as f64, message));
    }
    let last = vertices.len() - 1;
    for (place, index) in indices.iter().enumerate() {
        if *index as usize > last {
            let key = format!("rigid.indices.{place}");
            return Err(ParameterError::out_of_range(&key, f64::from(*index), 0.0, last as f64));
        }
    }
    Ok(RigidShape::Trimesh {
        vertices,
        indices: triples.to_vec(),
    })
}

fn ranged(key: &str, value: f32, (min, max): (f64, f64)) -> Result<f32, ParameterError> {
    let wide = f64::from(value);
    // The bounds are compared as f32 too, so that a caller's 0.001 is not refused for being 0.00099999.
    if value.is_finite() && value >= min as f32 && value <= max as f32 {
        Ok(value)
    } else {
        Err(ParameterError::out_of_range(key, wide, min, max))
    }
}

fn count_error(key: &str, count: usize, wanted: usize) -> ParameterError {
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
