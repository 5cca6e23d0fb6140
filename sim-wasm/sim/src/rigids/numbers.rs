//! Flat numbers of rigids, for language boundaries and saving.
//!
//! `numbers`: kind (0 fixed, 1 kinematic, 2 dynamic); position x, y, z and quaternion x, y, z, w; restitution,
//! friction, density, action (0 bounce, 1 kill, 2 tint) and tint, boundary layer, feels smoke; the number of parts, 0
//! for a single shape. Then for each part: shape (0 ball, 1 cuboid, 2 capsule, 3 cylinder, 4 convex hull, 5 trimesh),
//! the numbers of its dimensions, vertex numbers and indices, its pose in the rigid (7, as above), and its dimensions.
//! Ball: radius. Cuboid: half extents. Capsule and cylinder: half height, radius. Hull and trimesh: none.

use crate::collide::contact::Action;
use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::math::vector::Vector;
use crate::rigids::checks::{AXES, LENGTHS, count_error, pose_under, ranged, shape_error};
use crate::rigids::description::{RigidDescription, RigidKind, RigidPart, RigidShape};

const DENSITIES: (f64, f64) = (1e-2, 1e5);
const LAYERS: (f64, f64) = (0.0, 10.0);
const FEELINGS: (f64, f64) = (0.0, 10.0);
const MAX_PARTS: usize = 64;

/// A rigid as flat numbers. See the module documentation.
#[derive(Clone, Copy, Debug)]
pub struct RigidNumbers<'a> {
    pub numbers: &'a [f32],
    /// x, y, z of each vertex, part by part.
    pub vertices: &'a [f32],
    /// Three vertices of each triangle, counted within the part; part by part.
    pub indices: &'a [u32],
}

/// Owned [`RigidNumbers`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatRigid {
    pub numbers: Vec<f32>,
    pub vertices: Vec<f32>,
    pub indices: Vec<u32>,
}

impl RigidDescription {
    /// Reads and checks flat numbers.
    ///
    /// # Errors
    /// A number is not finite or out of range; the key is `rigid.*`. Adding the rigid checks whether points span a
    /// hull.
    pub fn from_numbers(numbers: &RigidNumbers) -> Result<Self, ParameterError> {
        let mut reader = FlatReader { rest: *numbers };
        let kind = kind_of(reader.number()?)?;
        let pose = pose_under("rigid", reader.numbers(7)?)?;
        let restitution = ranged("rigid.restitution", reader.number()?, (0.0, 1.0))?;
        let friction = ranged("rigid.friction", reader.number()?, (0.0, 1.0))?;
        let density = ranged("rigid.density", reader.number()?, DENSITIES)?;
        let action = reader.action()?;
        let boundary_layer = ranged("rigid.boundaryLayer", reader.number()?, LAYERS)?;
        let feels_smoke = ranged("rigid.feelsSmoke", reader.number()?, FEELINGS)?;
        Ok(Self {
            kind,
            shape: reader.shape()?,
            pose,
            restitution,
            friction,
            density,
            action,
            boundary_layer,
            feels_smoke,
        })
    }

    /// The inverse of [`RigidDescription::from_numbers`].
    pub fn to_numbers(&self) -> FlatRigid {
        let mut flat = FlatRigid::default();
        flat.numbers.push(match self.kind {
            RigidKind::Fixed => 0.0,
            RigidKind::Kinematic => 1.0,
            RigidKind::Dynamic => 2.0,
        });
        flat.numbers.extend(self.pose.numbers());
        flat.numbers.extend([self.restitution, self.friction, self.density]);
        flat.numbers.extend(match self.action {
            Action::Bounce => [0.0, 1.0],
            Action::Kill => [1.0, 1.0],
            Action::Tint(tint) => [2.0, f32::from(tint)],
        });
        flat.numbers.extend([self.boundary_layer, self.feels_smoke]);
        match &self.shape {
            RigidShape::Compound { parts } => {
                flat.numbers.push(parts.len() as f32);
                parts.iter().for_each(|part| flat.push(&part.shape, &part.pose));
            }
            single => {
                flat.numbers.push(0.0);
                flat.push(single, &Pose::at(Vector::ZERO));
            }
        }
        flat
    }
}

type Corners<'a> = &'a [[f32; 3]];
type Triangles<'a> = &'a [[u32; 3]];

impl FlatRigid {
    fn push(&mut self, shape: &RigidShape, pose: &Pose) {
        let (number, dimensions, vertices, indices): (f32, &[f32], Corners, Triangles) = match shape {
            RigidShape::Ball { radius } => (0.0, &[*radius], &[], &[]),
            RigidShape::Cuboid { half_extents } => (1.0, half_extents, &[], &[]),
            RigidShape::Capsule { half_height, radius } => (2.0, &[*half_height, *radius], &[], &[]),
            RigidShape::Cylinder { half_height, radius } => (3.0, &[*half_height, *radius], &[], &[]),
            RigidShape::ConvexHull { vertices } => (4.0, &[], vertices, &[]),
            RigidShape::Trimesh { vertices, indices } => (5.0, &[], vertices, indices),
            RigidShape::Compound { .. } => (6.0, &[], &[], &[]),
        };
        let counts = [dimensions.len(), vertices.len() * 3, indices.len() * 3];
        self.numbers.push(number);
        self.numbers.extend(counts.map(|count| count as f32));
        self.numbers.extend(pose.numbers());
        self.numbers.extend(dimensions);
        self.vertices.extend(vertices.as_flattened());
        self.indices.extend(indices.as_flattened());
    }
}

struct FlatReader<'a> {
    rest: RigidNumbers<'a>,
}

impl<'a> FlatReader<'a> {
    fn numbers(&mut self, count: usize) -> Result<&'a [f32], ParameterError> {
        take(&mut self.rest.numbers, count, "rigid.numbers")
    }

    fn number(&mut self) -> Result<f32, ParameterError> {
        self.numbers(1).map(|numbers| numbers[0])
    }

    /// Reads a count.
    fn count(&mut self, key: &str, most: usize) -> Result<usize, ParameterError> {
        let count = ranged(key, self.number()?, (0.0, most as f64))?;
        if count.fract() != 0.0 {
            return Err(ParameterError::not_whole(key, f64::from(count), 0.0, most as f64));
        }
        Ok(count as usize)
    }

    fn action(&mut self) -> Result<Action, ParameterError> {
        let action = self.count("rigid.action", 2)?;
        let tint = self.count("rigid.tint", 15)?;
        if tint == 0 {
            return Err(ParameterError::out_of_range("rigid.tint", 0.0, 1.0, 15.0));
        }
        Ok(Action::from_numbers(action as u8, tint as u8))
    }

    fn shape(&mut self) -> Result<RigidShape, ParameterError> {
        let count = self.count("rigid.parts", MAX_PARTS)?;
        if count == 0 {
            return self.part("rigid").map(|part| part.shape);
        }
        let parts = (0..count)
            .map(|index| self.part(&format!("rigid.parts.{index}")))
            .collect::<Result<_, _>>()?;
        Ok(RigidShape::Compound { parts })
    }

    fn part(&mut self, name: &str) -> Result<RigidPart, ParameterError> {
        let number = self.number()?;
        let dimension_count = self.count(&format!("{name}.dimensions"), usize::from(u16::MAX))?;
        let vertex_count = self.count(&format!("{name}.vertices"), 1 << 24)?;
        let index_count = self.count(&format!("{name}.indices"), 1 << 24)?;
        let pose = pose_under(name, self.numbers(7)?)?;
        let lengths = Lengths {
            name,
            dimensions: self.numbers(dimension_count)?,
            vertices: take(&mut self.rest.vertices, vertex_count, "rigid.vertices")?,
            indices: take(&mut self.rest.indices, index_count, "rigid.indices")?,
        };
        let shape = lengths.shape(number)?;
        Ok(RigidPart { shape, pose })
    }
}

fn take<'a, T>(rest: &mut &'a [T], count: usize, key: &str) -> Result<&'a [T], ParameterError> {
    let (taken, left) = rest
        .split_at_checked(count)
        .ok_or_else(|| count_error(key, rest.len(), count))?;
    *rest = left;
    Ok(taken)
}

fn kind_of(number: f32) -> Result<RigidKind, ParameterError> {
    match number {
        0.0 => Ok(RigidKind::Fixed),
        1.0 => Ok(RigidKind::Kinematic),
        2.0 => Ok(RigidKind::Dynamic),
        other => Err(ParameterError::out_of_range("rigid.kind", f64::from(other), 0.0, 2.0)),
    }
}

/// Dimensions and geometry of one part. `name` starts the keys of errors.
struct Lengths<'a> {
    name: &'a str,
    dimensions: &'a [f32],
    vertices: &'a [f32],
    indices: &'a [u32],
}

impl Lengths<'_> {
    fn shape(&self, number: f32) -> Result<RigidShape, ParameterError> {
        match number {
            0.0 => self.take().map(|[radius]| RigidShape::Ball { radius }),
            1.0 => self.take().map(|half_extents| RigidShape::Cuboid { half_extents }),
            2.0 => self
                .take()
                .map(|[half_height, radius]| RigidShape::Capsule { half_height, radius }),
            3.0 => self
                .take()
                .map(|[half_height, radius]| RigidShape::Cylinder { half_height, radius }),
            4.0 => self.points().map(|vertices| RigidShape::ConvexHull { vertices }),
            5.0 => self.trimesh(),
            other => {
                let key = self.key("shape");
                Err(ParameterError::out_of_range(&key, f64::from(other), 0.0, 5.0))
            }
        }
    }

    fn key(&self, what: &str) -> String {
        format!("{}.{what}", self.name)
    }

    fn take<const COUNT: usize>(&self) -> Result<[f32; COUNT], ParameterError> {
        let key = self.key("dimensions");
        let Ok(lengths) = <[f32; COUNT]>::try_from(self.dimensions) else {
            return Err(count_error(&key, self.dimensions.len(), COUNT));
        };
        for (place, length) in lengths.iter().enumerate() {
            ranged(&format!("{key}.{place}"), *length, LENGTHS)?;
        }
        Ok(lengths)
    }

    fn points(&self) -> Result<Vec<[f32; 3]>, ParameterError> {
        let key = self.key("vertices");
        let (triples, rest) = self.vertices.as_chunks::<3>();
        if triples.is_empty() || !rest.is_empty() {
            let message = format!("{key} takes three numbers for each vertex, at least one vertex");
            return Err(shape_error(&key, self.vertices.len() as f64, message));
        }
        for (place, value) in self.vertices.iter().enumerate() {
            let key = format!("{key}.{}.{}", place / 3, AXES[place % 3]);
            ranged(&key, *value, (-LENGTHS.1, LENGTHS.1))?;
        }
        Ok(triples.to_vec())
    }

    fn trimesh(&self) -> Result<RigidShape, ParameterError> {
        let vertices = self.points()?;
        let key = self.key("indices");
        let (triples, rest) = self.indices.as_chunks::<3>();
        if triples.is_empty() || !rest.is_empty() {
            let message = format!("{key} takes three indices for each triangle, at least one triangle");
            return Err(shape_error(&key, self.indices.len() as f64, message));
        }
        let last = vertices.len() - 1;
        for (place, index) in self.indices.iter().enumerate() {
            if *index as usize > last {
                let key = format!("{key}.{place}");
                return Err(ParameterError::out_of_range(&key, f64::from(*index), 0.0, last as f64));
            }
        }
        Ok(RigidShape::Trimesh {
            vertices,
            indices: triples.to_vec(),
        })
    }
}
