//! Construction of a shape's two forms: Rapier's, and the collider of particles.

use parry3d::glamx::Vec3;
use parry3d::shape::{SharedShape, TriMesh, TriMeshFlags};

use crate::collide::shapes::{Ball, Capsule, Collider, Cuboid, Cylinder};
use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::math::vector::Vector;
use crate::rigids::checks::{MIN_HALF_EXTENT, shape_error};
use crate::rigids::compound::Compound;
use crate::rigids::description::{RigidDescription, RigidKind, RigidShape};
use crate::rigids::meshes::{Mesh, oriented};

/// A shape in Rapier's world; nothing without Rapier.
#[cfg(feature = "rigids")]
pub type RapierShape = SharedShape;
#[cfg(not(feature = "rigids"))]
pub type RapierShape = ();

#[cfg(feature = "rigids")]
fn rapiers(shape: impl FnOnce() -> SharedShape) -> RapierShape {
    shape()
}

#[cfg(not(feature = "rigids"))]
fn rapiers(_shape: impl FnOnce() -> SharedShape) -> RapierShape {}

/// Both forms of a rigid's shape.
pub struct Forms {
    /// Each with its pose in the rigid.
    pub rapiers: Vec<(Pose, RapierShape)>,
    pub ours: Box<dyn Collider>,
}

/// Both forms of a single shape.
struct Form {
    rapiers: RapierShape,
    ours: Box<dyn Collider>,
}

/// Creates both forms of a description.
///
/// # Errors
/// The points span no volume, no triangle has an area, or a dynamic rigid is a sheet, which has no mass.
pub fn forms_of(description: &RigidDescription) -> Result<Forms, ParameterError> {
    #[cfg(not(feature = "rigids"))]
    if description.kind == RigidKind::Dynamic {
        let message = "rigid.kind is dynamic, which only the simulator with physics can move".to_owned();
        return Err(shape_error("rigid.kind", 2.0, message));
    }
    let RigidShape::Compound { parts } = &description.shape else {
        let Form { rapiers, ours } = form_of(&description.shape, description.kind)?;
        let rapiers = vec![(Pose::at(Vector::ZERO), rapiers)];
        return Ok(Forms { rapiers, ours });
    };
    if parts.is_empty() {
        let message = "rigid.parts is empty; give a compound at least one part".to_owned();
        return Err(shape_error("rigid.parts", 0.0, message));
    }
    let forms = parts
        .iter()
        .map(|part| form_of(&part.shape, description.kind))
        .collect::<Result<Vec<_>, _>>()?;
    let (rapiers, ours): (Vec<_>, Vec<_>) = forms
        .into_iter()
        .zip(parts)
        .map(|(form, part)| ((part.pose, form.rapiers), (part.pose, form.ours)))
        .unzip();
    let ours = Box::new(Compound::new(ours.into_iter()));
    Ok(Forms { rapiers, ours })
}

fn form_of(shape: &RigidShape, kind: RigidKind) -> Result<Form, ParameterError> {
    Ok(match shape {
        &RigidShape::Ball { radius } => Form {
            rapiers: rapiers(|| SharedShape::ball(radius)),
            ours: Box::new(Ball { radius }),
        },
        &RigidShape::Cuboid {
            half_extents: [x, y, z],
        } => Form {
            rapiers: rapiers(|| SharedShape::cuboid(x, y, z)),
            ours: Box::new(Cuboid {
                half_extents: Vector::new(x, y, z),
            }),
        },
        &RigidShape::Capsule { half_height, radius } => Form {
            rapiers: rapiers(|| SharedShape::capsule_y(half_height, radius)),
            ours: Box::new(Capsule { half_height, radius }),
        },
        &RigidShape::Cylinder { half_height, radius } => Form {
            rapiers: rapiers(|| SharedShape::cylinder(half_height, radius)),
            ours: Box::new(Cylinder { half_height, radius }),
        },
        RigidShape::ConvexHull { vertices } => hull(vertices)?,
        RigidShape::Trimesh { vertices, indices } => trimesh(vertices, indices, kind)?,
        RigidShape::Compound { .. } => {
            let message = "rigid.parts holds a compound; give its parts instead".to_owned();
            return Err(shape_error("rigid.parts", 6.0, message));
        }
    })
}

#[cfg(feature = "rigids")]
fn hull(vertices: &[[f32; 3]]) -> Result<Form, ParameterError> {
    let (rapiers, hull) = crate::rigids::hulls::hull(vertices)?;
    let ours = Box::new(hull);
    Ok(Form { rapiers, ours })
}

#[cfg(not(feature = "rigids"))]
fn hull(vertices: &[[f32; 3]]) -> Result<Form, ParameterError> {
    let message = "rigid.vertices are those of a hull, which only the simulator with physics has".to_owned();
    Err(shape_error("rigid.vertices", vertices.len() as f64, message))
}

fn trimesh(vertices: &[[f32; 3]], indices: &[[u32; 3]], kind: RigidKind) -> Result<Form, ParameterError> {
    let points: Vec<Vec3> = vertices.iter().map(|vertex| Vec3::from(*vertex)).collect();
    let flags = TriMeshFlags::MERGE_DUPLICATE_VERTICES | TriMeshFlags::DELETE_DEGENERATE_TRIANGLES;
    let merged = TriMesh::with_flags(points, indices.to_vec(), flags).ok();
    let merged = merged
        .filter(|mesh| area_of(mesh) > MIN_HALF_EXTENT * MIN_HALF_EXTENT)
        .ok_or_else(|| {
            let message = "rigid.indices make no triangle with an area".to_owned();
            shape_error("rigid.indices", indices.len() as f64, message)
        })?;
    let (corners, triangles) = (merged.vertices().to_vec(), outward(&merged));
    let solid = if is_closed(&triangles) {
        oriented(corners, triangles)
    } else {
        None
    };
    match solid {
        Some(mesh) => Ok(Form {
            rapiers: rapiers(|| SharedShape::new(mesh.clone())),
            ours: Box::new(Mesh::new(mesh, true)),
        }),
        None if kind == RigidKind::Dynamic => {
            let message = "rigid.shape is an open mesh, which has no mass; close it or make the rigid kinematic";
            Err(shape_error("rigid.shape", 5.0, message.to_owned()))
        }
        None => Ok(Form {
            rapiers: rapiers(|| SharedShape::new(merged.clone())),
            ours: Box::new(Mesh::new(merged, false)),
        }),
    }
}

fn area_of(mesh: &TriMesh) -> f32 {
    mesh.triangles()
        .map(|triangle| triangle.scaled_normal().length() * 0.5)
        .sum()
}

/// The triangles, all flipped if they face inwards.
fn outward(mesh: &TriMesh) -> Vec<[u32; 3]> {
    let origin = mesh.vertices()[0];
    let volume: f32 = mesh
        .triangles()
        .map(|triangle| (triangle.a - origin).dot((triangle.b - origin).cross(triangle.c - origin)))
        .sum();
    let turned = |[a, b, c]: [u32; 3]| if volume < 0.0 { [a, c, b] } else { [a, b, c] };
    mesh.indices().iter().map(|triangle| turned(*triangle)).collect()
}

/// Returns true if each edge occurs once in each direction.
fn is_closed(triangles: &[[u32; 3]]) -> bool {
    let mut edges: Vec<(u32, u32)> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
        .collect();
    edges.sort_unstable();
    let once = edges.windows(2).all(|pair| pair[0] != pair[1]);
    once && edges.iter().all(|&(from, to)| edges.binary_search(&(to, from)).is_ok())
}
