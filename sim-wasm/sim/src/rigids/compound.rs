//! Compound shapes.

use crate::collide::shapes::{Collider, Nearest};
use crate::math::bounds::Bounds;
use crate::math::pose::{Frame, Pose};
use crate::math::vector::Vector;
use crate::rigids::meshes::distance_to_box;

/// The union of several shapes.
pub struct Compound {
    parts: Vec<CompoundPart>,
    bounds: Bounds,
}

struct CompoundPart {
    frame: Frame,
    /// In the space of the compound.
    bounds: Bounds,
    shape: Box<dyn Collider>,
}

impl Compound {
    /// The union of at least one shape, each at its pose.
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
    /// Inside of several parts the deepest one counts: its surface is the farthest.
    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        let mut best = Nearest {
            distance: f32::INFINITY,
            normal: Vector::Y,
        };
        for part in &self.parts {
            let away = distance_to_box(&part.bounds, point);
            // Inside a part's box the depth is unknown: the part must be tested.
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
