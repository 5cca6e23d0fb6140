//! Regions of space.
//!
//! The weight is 1 within the shape and falls to 0 over `softness` metres outside, by the smoothstep 3 s^2 - 2 s^3.
//! Boxes and capsules are upright in the world, or rotate with the rigid that carries them.

use wide::f32x4;

use crate::layout::parameters::item::Scope;
use crate::math::pose::Frame;
use crate::math::simd::{Vector4, positive_part, smaller};
use crate::math::vector::Vector;

/// Minimum softness (m): visually a hard edge.
const HARD: f64 = 1e-6;

/// The shape of a region, prepared for SIMD lanes.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    All,
    Sphere(Placed),
    Box(Placed),
    Capsule(Placed),
}

/// A shape in its own coordinate frame.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    origin: Vector4,
    axes: [Vector4; 3],
    size: Vector4,
    per_softness: f32x4,
}

impl Shape {
    /// Prepares the region of `scope`, given in `frame`.
    pub fn new(scope: &Scope, frame: &Frame) -> Self {
        let placed = || Placed::new(scope, frame);
        match scope.shape as u32 {
            1 => Self::Sphere(placed()),
            2 => Self::Box(placed()),
            3 => Self::Capsule(placed()),
            _ => Self::All,
        }
    }

    /// Writes `level` times the weight at each place.
    pub fn weigh(&self, places: &[Vector4], level: f32x4, weights: &mut [f32x4]) {
        match self {
            Self::All => weights.fill(level),
            Self::Sphere(sphere) => sphere.weigh(places, level, weights, Placed::beyond_sphere),
            Self::Box(cuboid) => cuboid.weigh(places, level, weights, Placed::beyond_box),
            Self::Capsule(capsule) => capsule.weigh(places, level, weights, Placed::beyond_capsule),
        }
    }
}

impl Placed {
    fn new(scope: &Scope, frame: &Frame) -> Self {
        let axis = |x, y, z| Vector4::splat(frame.rotate(Vector::new(x, y, z)).into());
        let centre = scope.position.map(|metres| metres as f32);
        Self {
            origin: Vector4::splat(frame.world_from_local(centre.into()).into()),
            axes: [axis(1.0, 0.0, 0.0), axis(0.0, 1.0, 0.0), axis(0.0, 0.0, 1.0)],
            size: Vector4::splat(scope.size.map(|metres| metres as f32)),
            per_softness: f32x4::splat((1.0 / scope.softness.max(HARD)) as f32),
        }
    }

    #[inline(always)]
    fn weigh(&self, places: &[Vector4], level: f32x4, weights: &mut [f32x4], distance: fn(&Self, Vector4) -> f32x4) {
        for (place, weight) in places.iter().zip(weights) {
            let offset = *place - self.origin;
            let local = Vector4 {
                x: self.axes[0].dot(offset),
                y: self.axes[1].dot(offset),
                z: self.axes[2].dot(offset),
            };
            let left = positive_part(f32x4::ONE - positive_part(distance(self, local)) * self.per_softness);
            *weight = level * left * left * (f32x4::splat(3.0) - left * 2.0);
        }
    }

    fn beyond_sphere(&self, local: Vector4) -> f32x4 {
        local.dot(local).sqrt() - self.size.x
    }

    fn beyond_box(&self, local: Vector4) -> f32x4 {
        let beyond = |place: f32x4, half: f32x4| positive_part(place.abs() - half);
        let outside = Vector4 {
            x: beyond(local.x, self.size.x),
            y: beyond(local.y, self.size.y),
            z: beyond(local.z, self.size.z),
        };
        outside.dot(outside).sqrt()
    }

    fn beyond_capsule(&self, local: Vector4) -> f32x4 {
        let along = smaller(local.y.abs(), self.size.y);
        let beyond = local.y.abs() - along;
        (local.x * local.x + beyond * beyond + local.z * local.z).sqrt() - self.size.x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::pose::Pose;

    fn weight(shape: f64, softness: f64, place: [f32; 3]) -> f32 {
        let scope = Scope {
            shape,
            softness,
            position: [1.0, 0.0, 0.0],
            size: [0.5, 1.0, 0.25],
            ..Scope::default()
        };
        let shape = Shape::new(&scope, &Frame::new(&Pose::at(Vector::new(0.0, 10.0, 0.0))));
        let mut weights = [f32x4::ZERO];
        shape.weigh(&[Vector4::splat(place)], f32x4::splat(0.8), &mut weights);
        weights[0].to_array()[2]
    }

    #[test]
    fn weights_follow_the_distance_from_the_shape() {
        // Shape, place, distance from the shape.
        let cases = [
            (0.0, [9.0, 9.0, 9.0], 0.0),
            (1.0, [1.0, 10.5, 0.0], 0.0),
            (1.0, [1.0, 10.7, 0.0], 0.2),
            (2.0, [1.4, 10.9, -0.2], 0.0),
            (2.0, [1.8, 11.4, 0.0], 0.5),
            (3.0, [1.0, 9.0, 0.4], 0.0),
            (3.0, [1.0, 12.5, 0.8], 1.2),
        ];
        for (shape, place, distance) in cases {
            let left = (1.0_f32 - distance / 2.0).max(0.0);
            let expected = 0.8 * left * left * (3.0 - 2.0 * left);
            let got = weight(shape, 2.0, place);
            assert!(
                (got - expected).abs() < 1e-5,
                "shape {shape} at {place:?}: {got}, not {expected}"
            );
        }
    }

    #[test]
    fn a_hard_edge_has_nothing_beyond_it() {
        assert_eq!(weight(1.0, 0.0, [1.0, 10.501, 0.0]), 0.0);
        assert_eq!(weight(1.0, 0.0, [1.0, 10.499, 0.0]), 0.8);
    }
}
