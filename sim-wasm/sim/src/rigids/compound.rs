//! Several shapes as one obstacle.

use crate::collide::shapes::{Collider, Nearest};
use crate::math::bounds::Bounds;
use crate::math::pose::{Frame, Pose};
use crate::math::vector::Vector;
use crate::rigids::meshes::distance_to_box;

/// The union of its parts.
pub struct Compound {
    parts: Vec<CompoundPart>,
    bounds: Bounds,
}

struct CompoundPart {
    frame: Frame,
    /// In the compound's space.
    bounds: Bounds,
    shape: Box<dyn Collider>,
}

impl Compound {
    /// The union of shapes, each at its pose; there is at least one.
    pub fn new(shapes: impl Iterator<Item = (Pose, Box<dyn Collider>)>) -> Self {
        let parts: Vec<CompoundPart> = shapes.map(|(pose, shape)| CompoundPart::new(&pose, shape)).collect();
        let bounds = parts.iter().fold(Bounds::NOTHING, |all, part| all.with(&part.bounds));
        Self { parts, bounds }
    }
}

impl CompoundPart {
    fn new(pose: &Pose, shape: Box<dyn Collider>) -> Self {
        let frame = Frame::new(pose);
        let bounds = frame.bounds_of(&shape.bounds());
        Self { frame, bounds, shape }
    }

    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        let nearest = self.shape.nearest(self.frame.local_from_world(point), limit);
        Nearest {
            distance: nearest.distance,
            normal: self.frame.rotate(nearest.normal),
        }
    }
}

impl Collider for Compound {
    /// Inside of several parts the deepest counts: its surface is the farthest way out.
    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        let mut best = Nearest {
            distance: f32::INFINITY,
            normal: Vector::Y,
        };
        for part in &self.parts {
            let away = distance_to_box(&part.bounds, point);
            // Within a box nothing is known of the depth, so the part is always asked.
            if away > 0.0 && away >= best.distance {
                continue;
            }
            let limit = if best.distance > 0.0 {
                limit.min(best.distance)
            } else {
                limit
            };
            let nearest = part.nearest(point, limit);
            if nearest.distance < best.distance {
                best = nearest;
            }
        }
        best
    }

    fn bounds(&self) -> Bounds {
        self.bounds
    }
}
