//! Places and vectors of a frame, in all lanes.

use crate::math::double::direction;
use crate::math::pose::Frame;
use crate::math::simd::Vector4;
use crate::math::vector::Vector;

/// Transforms a place (m) from `frame` to world space, in all lanes.
pub(crate) fn place_in(frame: &Frame, place: [f64; 3]) -> Vector4 {
    let local = Vector::from(place.map(|metres| metres as f32));
    Vector4::splat(frame.world_from_local(local).into())
}

/// Rotates a vector from `frame` to world space, in all lanes.
pub(crate) fn vector_in(frame: &Frame, vector: [f32; 3]) -> Vector4 {
    Vector4::splat(frame.rotate(Vector::from(vector)).into())
}

/// The unit vector of a direction, rotated from `frame` to world space, in all lanes.
pub(crate) fn direction_in(frame: &Frame, axis: [f64; 3]) -> Vector4 {
    vector_in(frame, self::direction(axis))
}
