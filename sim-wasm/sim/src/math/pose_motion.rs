//! The motion of an obstacle over one step, from a pose to a pose, split into pieces of small rotation.

use crate::math::bounds::Bounds;
use crate::math::pose::{Frame, Pose};
use crate::math::scalar::greater;
use crate::math::vector::Vector;

/// Maximum rotation (rad) per piece. In the obstacle's frame a straight path becomes an arc; each piece replaces the
/// arc by its chord, with an error of 0.5 % of the radius at this angle.
const PIECE_ANGLE: f32 = 0.2;
const MAX_PIECES: f32 = 64.0;
/// Maximum angle (rad) at which quaternions are interpolated linearly: as accurate there, and cheaper.
const MAX_BLENDED_ANGLE: f32 = 1.0;

/// The motion of an obstacle over one step.
#[derive(Clone, Copy, Debug)]
pub struct PoseMotion {
    start: Pose,
    end: Pose,
    start_frame: Frame,
    end_frame: Frame,
    velocity: Vector,
    spin: Vector,
    /// Rotation vector (rad) from start to end if the angle is large, else zero.
    rotation_vector: Vector,
    pieces: u32,
}

impl PoseMotion {
    /// No motion.
    pub fn resting(pose: Pose) -> Self {
        let frame = Frame::new(&pose);
        let (velocity, spin) = (Vector::ZERO, Vector::ZERO);
        Self {
            start: pose,
            end: pose,
            start_frame: frame,
            end_frame: frame,
            velocity,
            spin,
            rotation_vector: Vector::ZERO,
            pieces: 1,
        }
    }

    /// Moves from `start` to `end` in `dt` seconds. A `round` shape is followed without its rotation, which affects
    /// only the velocity of its surface.
    pub fn between(start: Pose, end: Pose, dt: f32, round: bool) -> Self {
        let rotation_vector = start.rotation_vector_to(&end);
        let velocity = (end.position - start.position) * (1.0 / dt);
        let (start, end) = if round {
            (Pose::at(start.position), Pose::at(end.position))
        } else {
            (start, end)
        };
        let pieces = if round {
            1.0
        } else {
            (rotation_vector.length() / PIECE_ANGLE).ceil().clamp(1.0, MAX_PIECES)
        };
        Self {
            start,
            end,
            start_frame: Frame::new(&start),
            end_frame: Frame::new(&end),
            velocity,
            spin: rotation_vector * (1.0 / dt),
            rotation_vector: if round || rotation_vector.length() < MAX_BLENDED_ANGLE {
                Vector::ZERO
            } else {
                rotation_vector
            },
            pieces: pieces as u32,
        }
    }

    /// Returns true if it moves or rotates.
    #[cfg(feature = "meshes")]
    pub fn is_moving(&self) -> bool {
        self.velocity != Vector::ZERO || self.spin != Vector::ZERO
    }

    /// Upper bound of the speed (m/s) of points within `reach` (m) of the origin.
    #[cfg(feature = "meshes")]
    pub fn top_speed(&self, reach: f32) -> f32 {
        self.velocity.length() + self.spin.length() * reach
    }

    /// Number of pieces of the motion, at least 1.
    pub fn pieces(&self) -> u32 {
        self.pieces
    }

    /// The coordinate frames at the start and at the end of the step.
    #[inline]
    pub fn ends(&self) -> (&Frame, &Frame) {
        (&self.start_frame, &self.end_frame)
    }

    /// The coordinate frame at a fraction of the step.
    pub fn frame(&self, fraction: f32) -> Frame {
        if fraction >= 1.0 {
            self.end_frame
        } else if fraction <= 0.0 {
            self.start_frame
        } else if self.rotation_vector == Vector::ZERO {
            Frame::new(&self.start.towards(&self.end, fraction))
        } else {
            let position = self.start.position.towards(self.end.position, fraction);
            let rotation = self.start.rotated_by(self.rotation_vector * fraction).rotation;
            Frame::new(&Pose { position, rotation })
        }
    }

    /// Velocity (m/s) of the obstacle at a world-space point, at a fraction of the step.
    #[inline]
    pub fn velocity_at(&self, point: Vector, fraction: f32) -> Vector {
        let origin = self.start.position.towards(self.end.position, fraction);
        self.velocity + self.spin.cross(point - origin)
    }

    /// Upper bound of the extra length (m) of a path that the obstacle's rotation bends, compared with the straight
    /// path from `from` to `to` in the obstacle's frame.
    pub fn detour(&self, from: Vector, to: Vector) -> f32 {
        if self.pieces == 1 {
            0.0
        } else {
            PIECE_ANGLE * self.pieces as f32 * greater(from.length(), to.length())
        }
    }

    /// World-space box of a shape with the box `local` during the step.
    pub fn bounds_of(&self, local: &Bounds) -> Bounds {
        let mut bounds = self.start_frame.bounds_of(local).with(&self.end_frame.bounds_of(local));
        if self.pieces > 1 {
            for piece in 1..self.pieces {
                let frame = self.frame(piece as f32 / self.pieces as f32);
                bounds = bounds.with(&frame.bounds_of(local));
            }
            bounds = bounds.wider(local.reach() * PIECE_ANGLE * PIECE_ANGLE);
        }
        bounds
    }
}
