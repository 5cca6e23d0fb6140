//! Surfaces of meshes as emitters.
//!
//! Births pick a triangle by its area and a uniform point on it (Turk, "Generating Random Points in Triangles",
//! Graphics Gems, 1990). Surfaces are inputs: they are saved but not part of the hash. They are not drawn, and
//! particles do not collide with them.

use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::parameters::emitter::MAX_SURFACES;
use crate::math::hash::Hash;
use crate::math::random::Random;
use crate::math::vector::Vector;

/// Maximum number of vertices, and of triangles, of a surface.
pub const MAX_ELEMENTS: usize = 1_000_000;
/// Maximum absolute coordinate of a vertex (m).
pub const MAX_COORDINATE: f32 = 1000.0;

/// A mesh prepared for births.
#[derive(Clone, Debug)]
pub struct Surface {
    vertices: Vec<f32>,
    indices: Vec<u32>,
    /// Cumulative area of the triangles (m2).
    areas: Vec<f64>,
}

impl Surface {
    /// Creates a surface from `vertices` (m), three numbers each, and `indices`, three per triangle, counter-clockwise
    /// as seen from outside. Particles leave outwards.
    ///
    /// # Errors
    /// `surface.vertices`: empty, not a multiple of three, too many, not finite or beyond 1000 m. `surface.indices`:
    /// empty, not a multiple of three, too many, or out of range. `surface.area`: all triangles are degenerate.
    pub fn new(vertices: &[f32], indices: &[u32]) -> Result<Self, ParameterError> {
        check_count("surface.vertices", vertices.len())?;
        check_count("surface.indices", indices.len())?;
        for (number, metres) in vertices.iter().enumerate() {
            if !(-MAX_COORDINATE..=MAX_COORDINATE).contains(metres) {
                return Err(range_error(
                    &format!("surface.vertices.{number}"),
                    f64::from(*metres),
                    -1e3,
                    1e3,
                ));
            }
        }
        let last = vertices.len() as u32 / 3 - 1;
        for (number, vertex) in indices.iter().enumerate() {
            if *vertex > last {
                let key = format!("surface.indices.{number}");
                return Err(range_error(&key, f64::from(*vertex), 0.0, f64::from(last)));
            }
        }
        Self::measured(vertices.to_vec(), indices.to_vec())
    }

    fn measured(vertices: Vec<f32>, indices: Vec<u32>) -> Result<Self, ParameterError> {
        let mut surface = Self {
            areas: Vec::with_capacity(indices.len() / 3),
            vertices,
            indices,
        };
        let mut area = 0.0;
        for triangle in 0..surface.indices.len() / 3 {
            area += f64::from(normal(&surface.corners(triangle)).length()) / 2.0;
            surface.areas.push(area);
        }
        if area > 0.0 {
            return Ok(surface);
        }
        let message = "surface.area is 0; give at least one triangle whose corners lie on no line".to_owned();
        Err(malformed("surface.area", area, message))
    }

    /// Picks a point (m), uniform by area, and its unit normal.
    pub fn pick(&self, random: &mut Random) -> ([f32; 3], [f32; 3]) {
        let total = self.areas[self.areas.len() - 1];
        let sought = total * f64::from(random.bits()) / 4_294_967_296.0;
        let corners = self.corners(self.areas.partition_point(|area| *area <= sought));
        let [a, b, c] = corners;
        let (root, along) = (libm::sqrtf(random.unit()), random.unit());
        let place = a + (b - a) * (root * (1.0 - along)) + (c - a) * (root * along);
        (place.into(), normal(&corners).unit_or(Vector::Y).into())
    }

    fn corners(&self, triangle: usize) -> [Vector; 3] {
        std::array::from_fn(|corner| {
            let at = 3 * self.indices[3 * triangle + corner] as usize;
            Vector::new(self.vertices[at], self.vertices[at + 1], self.vertices[at + 2])
        })
    }
}

/// The surfaces of one simulator by index.
#[derive(Clone, Debug, Default)]
pub struct Surfaces(Vec<Surface>);

impl Surfaces {
    /// Adds a surface and returns its index.
    ///
    /// # Errors
    /// `surface.count`: there are [`MAX_SURFACES`] already.
    pub fn add(&mut self, surface: Surface) -> Result<u32, ParameterError> {
        let count = self.0.len();
        if count == MAX_SURFACES {
            return Err(range_error(
                "surface.count",
                count as f64 + 1.0,
                0.0,
                MAX_SURFACES as f64,
            ));
        }
        self.0.push(surface);
        Ok(count as u32)
    }

    /// Number of surfaces.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The surface at an index.
    pub fn get(&self, number: usize) -> Option<&Surface> {
        self.0.get(number)
    }

    /// Adds all meshes to `hash`.
    pub fn hash_into(&self, hash: &mut Hash) {
        for Surface { vertices, indices, .. } in &self.0 {
            hash.floats(vertices);
            indices.iter().for_each(|index| hash.word(*index));
        }
    }
}

impl SnapshotSection for Surfaces {
    fn write(&self, body: &mut Writer) {
        body.word(self.0.len() as u32);
        for Surface { vertices, indices, .. } in &self.0 {
            body.word(vertices.len() as u32);
            vertices.iter().for_each(|metres| body.word(metres.to_bits()));
            body.word(indices.len() as u32);
            indices.iter().for_each(|index| body.word(*index));
        }
    }

    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let mut surfaces = Self::default();
        for _ in 0..reader.word()? {
            let vertices = read_all(reader, Reader::float)?;
            let indices = read_all(reader, Reader::word)?;
            let surface = Surface::new(&vertices, &indices).map_err(RestoreError::from)?;
            surfaces.add(surface).map_err(RestoreError::from)?;
        }
        Ok(surfaces)
    }
}

/// Reads a count and that many values. Memory grows with the bytes read, whatever the count claims.
fn read_all<'b, T>(
    reader: &mut Reader<'b>,
    read: fn(&mut Reader<'b>) -> Result<T, RestoreError>,
) -> Result<Vec<T>, RestoreError> {
    let count = reader.word()?;
    let mut values = Vec::new();
    for _ in 0..count {
        values.push(read(reader)?);
    }
    Ok(values)
}

/// The normal of a triangle, counter-clockwise, with the length of twice its area (m2).
fn normal([a, b, c]: &[Vector; 3]) -> Vector {
    (*b - *a).cross(*c - *a)
}

fn check_count(key: &str, count: usize) -> Result<(), ParameterError> {
    if count.is_multiple_of(3) && (3..=3 * MAX_ELEMENTS).contains(&count) {
        return Ok(());
    }
    let most = 3 * MAX_ELEMENTS;
    let message = format!("{key} are {count} numbers; give three for each, at most {most}");
    Err(malformed(key, count as f64, message))
}

/// An error without a range.
fn malformed(key: &str, value: f64, message: String) -> ParameterError {
    ParameterError {
        message,
        ..range_error(key, value, f64::NAN, f64::NAN)
    }
}

fn range_error(key: &str, value: f64, min: f64, max: f64) -> ParameterError {
    ParameterError::out_of_range(key, value, min, max)
}
