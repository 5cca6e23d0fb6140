//! Poses, unit quaternions and coordinate frames.
//!
//! Scalar arithmetic in a fixed order: every machine computes the same bits.

use crate::math::bounds::Bounds;
use crate::math::vector::Vector;

/// Count of the numbers of a pose: x, y, z (m) and the unit quaternion x, y, z, w.
pub const POSE_FLOATS: usize = 7;

/// Maximum distance from the origin of the world (m).
pub const MAX_COORDINATE: f32 = 1e4;

/// A position and a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// World space, metres.
    pub position: Vector,
    /// Unit quaternion x, y, z, w.
    pub rotation: [f32; 4],
}

impl Pose {
    /// Creates a pose from x, y, z (m) and the unit quaternion x, y, z, w.
    pub fn of_numbers([x, y, z, i, j, k, w]: [f32; POSE_FLOATS]) -> Self {
        Self {
            position: Vector::new(x, y, z),
            rotation: [i, j, k, w],
        }
    }

    /// x, y, z (m) and the quaternion x, y, z, w.
    pub fn numbers(&self) -> [f32; POSE_FLOATS] {
        let [x, y, z]: [f32; 3] = self.position.into();
        let [i, j, k, w] = self.rotation;
        [x, y, z, i, j, k, w]
    }

    /// A pose at `position` with the identity rotation.
    pub fn at(position: Vector) -> Self {
        Self {
            position,
            rotation: [0.0, 0.0, 0.0, 1.0],
        }
    }

    /// A pose at `position` whose y axis points along the unit vector `axis`, by the shortest rotation.
    pub fn along(position: Vector, axis: Vector) -> Self {
        // The shortest rotation to straight down is not unique: half a turn about x.
        let rotation = if axis.y < -0.999_999 {
            [1.0, 0.0, 0.0, 0.0]
        } else {
            unit([axis.z, 0.0, -axis.x, 1.0 + axis.y])
        };
        Self { position, rotation }
    }

    /// Interpolates towards `other`: linear in position, normalised linear in rotation along the shorter arc.
    pub fn towards(&self, other: &Self, fraction: f32) -> Self {
        let (a, b) = (self.rotation, other.rotation);
        let cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
        let sign = if cosine < 0.0 { -1.0 } else { 1.0 };
        let rotation = std::array::from_fn(|part| a[part] + (sign * b[part] - a[part]) * fraction);
        Self {
            position: self.position.towards(other.position, fraction),
            rotation: unit(rotation),
        }
    }

    /// The pose on the way to `goal` at which no point within `reach` (m) of the origin has moved farther than `way` (m).
    pub fn nearer(&self, goal: &Self, reach: f32, way: f32) -> Self {
        let arc = self.rotation_vector_to(goal).length() * reach;
        let share = way / ((goal.position - self.position).length() + arc).max(f32::MIN_POSITIVE);
        if share >= 1.0 { *goal } else { self.towards(goal, share) }
    }

    /// Rotation vector, axis times angle (rad), of the shorter rotation to `other` in world space.
    pub fn rotation_vector_to(&self, other: &Self) -> Vector {
        let (half, cosine) = self.half_rotation_to(other);
        let sine = half.length();
        if sine < 1e-9 {
            half * 2.0
        } else {
            half * (2.0 * libm::atan2f(sine, cosine) / sine)
        }
    }

    /// Half of the shorter rotation to `other`, in world space: axis times sine of the half angle, and its cosine.
    pub fn half_rotation_to(&self, other: &Self) -> (Vector, f32) {
        let (a, b) = (self.rotation, other.rotation);
        let (u, v) = (Vector::new(a[0], a[1], a[2]), Vector::new(b[0], b[1], b[2]));
        let w = a[3] * b[3] + u.dot(v);
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        ((v * a[3] - u * b[3] - v.cross(u)) * sign, w * sign)
    }

    /// The pose, rotated about its position by a rotation vector (rad) in world space.
    pub fn rotated_by(&self, rotation_vector: Vector) -> Self {
        Self {
            position: self.position,
            rotation: product(rotation_about(rotation_vector), self.rotation),
        }
    }
}

/// The unit quaternion x, y, z, w of a rotation vector, axis times angle (rad).
pub fn rotation_about(rotation_vector: Vector) -> [f32; 4] {
    let (sine, cosine) = libm::sincosf(rotation_vector.length() * 0.5);
    let axis = rotation_vector.unit_or(Vector::ZERO) * sine;
    [axis.x, axis.y, axis.z, cosine]
}

/// The product of two unit quaternions x, y, z, w: rotates by `b`, then by `a`.
pub fn product(a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
    let (u, v) = (Vector::new(a[0], a[1], a[2]), Vector::new(b[0], b[1], b[2]));
    let axis = v * a[3] + u * b[3] + u.cross(v);
    unit([axis.x, axis.y, axis.z, a[3] * b[3] - u.dot(v)])
}

/// Gives the quaternion of a pose unit length. Returns false and changes nothing if it is 0 or if a coordinate is beyond
/// [`MAX_COORDINATE`].
pub fn normalise(pose: &mut [f32; POSE_FLOATS]) -> bool {
    let (position, rotation) = pose.split_at_mut(3);
    let length = rotation.iter().map(|part| part * part).sum::<f32>().sqrt();
    let is_near = position.iter().all(|place| place.abs() <= MAX_COORDINATE);
    if !is_near || !(1e-3..=1e3).contains(&length) {
        return false;
    }
    // A quaternion of unit length up to rounding stays bit for bit: saving and restoring must not change a pose.
    if (length - 1.0).abs() >= 1e-5 {
        rotation.iter_mut().for_each(|part| *part /= length);
    }
    true
}

fn unit(q: [f32; 4]) -> [f32; 4] {
    let scale = 1.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
    q.map(|part| part * scale)
}

/// A coordinate frame: the axes and the origin of a pose, for the transformation of many points.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    origin: Vector,
    axes: [Vector; 3],
}

impl Frame {
    /// The coordinate frame of a pose.
    pub fn new(pose: &Pose) -> Self {
        let [x, y, z, w] = pose.rotation;
        Self {
            origin: pose.position,
            axes: [
                Vector::new(
                    1.0 - 2.0 * (y * y + z * z),
                    2.0 * (x * y + w * z),
                    2.0 * (x * z - w * y),
                ),
                Vector::new(
                    2.0 * (x * y - w * z),
                    1.0 - 2.0 * (x * x + z * z),
                    2.0 * (y * z + w * x),
                ),
                Vector::new(
                    2.0 * (x * z + w * y),
                    2.0 * (y * z - w * x),
                    1.0 - 2.0 * (x * x + y * y),
                ),
            ],
        }
    }

    /// Transforms a point from world space to this frame.
    #[inline]
    pub fn local_from_world(&self, point: Vector) -> Vector {
        let offset = point - self.origin;
        Vector::new(
            self.axes[0].dot(offset),
            self.axes[1].dot(offset),
            self.axes[2].dot(offset),
        )
    }

    /// Transforms a point of this frame to world space.
    #[inline]
    pub fn world_from_local(&self, point: Vector) -> Vector {
        self.origin + self.rotate(point)
    }

    /// Rotates a direction of this frame to world space.
    pub fn rotate(&self, direction: Vector) -> Vector {
        self.axes[0] * direction.x + self.axes[1] * direction.y + self.axes[2] * direction.z
    }

    /// The world-space box around a box of this frame.
    pub fn bounds_of(&self, local: &Bounds) -> Bounds {
        let centre = self.world_from_local((local.min + local.max) * 0.5);
        let half = (local.max - local.min) * 0.5;
        let reach = self.axes[0].abs() * half.x + self.axes[1].abs() * half.y + self.axes[2].abs() * half.z;
        Bounds {
            min: centre - reach,
            max: centre + reach,
        }
    }
}
