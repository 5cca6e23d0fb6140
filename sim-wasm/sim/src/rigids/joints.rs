//! Joints between two rigids.
//!
//! Flat numbers: kind (0 fixed, 1 ball, 2 hinge, 3 rope, 4 spring), the two rigids, the anchor in each (x, y, z).
//! Hinge: axis x, y, z, limited (0 or 1), the limits, motor speed, motor torque (0: no motor). Rope: length. Spring:
//! length, stiffness, damping.

use rapier3d::dynamics::{
    FixedJointBuilder, GenericJoint, JointAxis, RevoluteJointBuilder, RopeJointBuilder, SphericalJointBuilder,
    SpringJointBuilder,
};
use rapier3d::glamx::{Pose3, Quat, Vec3};

use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
use crate::math::vector::Vector;
use crate::rigids::checks::{AXES, PLACES, count_error, ranged, shape_error};
use crate::rigids::description::RigidKind;
use crate::rigids::meshes::parrys;
use crate::rigids::set::Rigids;

const LENGTHS: (f64, f64) = (1e-3, 1e3);
const COEFFICIENTS: (f64, f64) = (0.0, 1e6);
const ANGLES: (f64, f64) = (-std::f64::consts::PI, std::f64::consts::PI);
const MOTOR_SPEEDS: (f64, f64) = (-200.0, 200.0);
const MOTOR_TORQUES: (f64, f64) = (0.0, 1e6);
/// Gain of a motor (1/s), within its torque.
const MOTOR_GAIN: f32 = 1000.0;
const MAX_JOINTS: usize = 4096;

/// The degrees of freedom that a joint leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointKind {
    /// None: the current relative pose is kept.
    Fixed,
    /// All rotations about the common point.
    Ball,
    /// Rotation about `axis` (unit vector in the first rigid's space) within the `limits` (rad, -pi..pi), relative to
    /// the current pose.
    Hinge {
        axis: Vector,
        limits: Option<[f32; 2]>,
        motor: Option<Motor>,
    },
    /// All motion within a distance (m).
    Rope { length: f32 },
    /// All motion, with a spring of the rest length `length` (m), stiffness in N/m and damping in N s/m.
    Spring { length: f32, stiffness: f32, damping: f32 },
}

/// A motor that rotates the second rigid about a hinge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    /// Angular velocity, -200..=200 rad/s.
    pub speed: f32,
    /// Maximum torque (N m), above 0.
    pub torque: f32,
}

/// The description of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointDescription {
    pub kind: JointKind,
    /// Indices of two rigids, at least one of them dynamic. They do not collide with each other.
    pub rigids: [u32; 2],
    /// Anchor in each rigid's own space (m).
    pub anchors: [Vector; 2],
}

impl JointDescription {
    /// Reads and checks flat numbers. [`Rigids::add_joint`] checks the rigids.
    ///
    /// # Errors
    /// A number is missing, not finite or out of range; the key is `joint.*`.
    pub fn from_numbers(numbers: &[f32]) -> Result<Self, ParameterError> {
        let [kind, a, b, anchors @ ..] = numbers else {
            return Err(count_error("joint.numbers", numbers.len(), 9));
        };
        let Some((anchors, rest)) = anchors.split_first_chunk::<6>() else {
            return Err(count_error("joint.numbers", numbers.len(), 9));
        };
        for (place, value) in anchors.iter().enumerate() {
            let key = format!("joint.anchors.{}.{}", place / 3, AXES[place % 3]);
            ranged(&key, *value, PLACES)?;
        }
        let [x, y, z, u, v, w] = *anchors;
        Ok(Self {
            kind: kind_of(*kind, rest)?,
            rigids: [rigid("joint.rigids.0", *a)?, rigid("joint.rigids.1", *b)?],
            anchors: [Vector::new(x, y, z), Vector::new(u, v, w)],
        })
    }
}

impl Rigids {
    /// Joins two rigids at their current poses and returns the joint's index.
    ///
    /// # Errors
    /// A rigid does not exist, both are the same, none is dynamic, or there are 4096 joints already.
    pub fn add_joint(&mut self, description: &JointDescription) -> Result<u32, ParameterError> {
        let index = self.world.joint_count();
        let error = |message: &str| Err(shape_error("joint.rigids", f64::NAN, message.to_owned()));
        if index == MAX_JOINTS {
            let most = MAX_JOINTS as f64;
            return Err(ParameterError::out_of_range("joint.count", most + 1.0, 0.0, most));
        }
        let [a, b] = description.rigids;
        self.check_exists(a)?;
        self.check_exists(b)?;
        if a == b {
            return error("joint.rigids are the same; join two different rigids");
        }
        let dynamic = |rigid: u32| self.members[rigid as usize].description.kind == RigidKind::Dynamic;
        if !dynamic(a) && !dynamic(b) {
            return error("joint.rigids are neither dynamic; at least one of them must be");
        }
        let poses = [a, b].map(|rigid| self.world.pose(rigid as usize));
        self.world.join(a as usize, b as usize, rapiers(description, &poses));
        Ok(index as u32)
    }
}

fn rapiers(description: &JointDescription, poses: &[Pose; 2]) -> GenericJoint {
    let [a, b] = description.anchors.map(parrys);
    let rotations = poses.map(|pose| Quat::from_array(pose.rotation));
    // A frame of the first rigid in the second one, so that the current poses satisfy the joint.
    let seen = |frame: Quat| rotations[1].inverse() * rotations[0] * frame;
    let mut joint: GenericJoint = match description.kind {
        JointKind::Fixed => FixedJointBuilder::new()
            .local_frame1(Pose3::from_parts(a, Quat::IDENTITY))
            .local_frame2(Pose3::from_parts(b, seen(Quat::IDENTITY)))
            .into(),
        JointKind::Ball => SphericalJointBuilder::new().local_anchor1(a).local_anchor2(b).into(),
        JointKind::Rope { length } => RopeJointBuilder::new(length).local_anchor1(a).local_anchor2(b).into(),
        JointKind::Spring {
            length,
            stiffness,
            damping,
        } => SpringJointBuilder::new(length, stiffness, damping)
            .local_anchor1(a)
            .local_anchor2(b)
            .into(),
        JointKind::Hinge { axis, limits, motor } => {
            let frame = Quat::from_rotation_arc(Vec3::X, parrys(axis));
            let mut joint: GenericJoint = RevoluteJointBuilder::new(Vec3::X).into();
            joint.set_local_frame1(Pose3::from_parts(a, frame));
            joint.set_local_frame2(Pose3::from_parts(b, seen(frame)));
            if let Some(limits) = limits {
                joint.set_limits(JointAxis::AngX, limits);
            }
            if let Some(Motor { speed, torque }) = motor {
                joint.set_motor_velocity(JointAxis::AngX, speed, MOTOR_GAIN);
                joint.set_motor_max_force(JointAxis::AngX, torque);
            }
            joint
        }
    };
    joint.set_contacts_enabled(false);
    joint
}

fn rigid(key: &str, number: f32) -> Result<u32, ParameterError> {
    let number = ranged(key, number, (0.0, 4095.0))?;
    if number.fract() != 0.0 {
        return Err(ParameterError::not_whole(key, f64::from(number), 0.0, 4095.0));
    }
    Ok(number as u32)
}

fn kind_of(kind: f32, numbers: &[f32]) -> Result<JointKind, ParameterError> {
    match (kind, numbers) {
        (0.0, []) => Ok(JointKind::Fixed),
        (1.0, []) => Ok(JointKind::Ball),
        (2.0, &[x, y, z, limited, least, most, speed, torque]) => Ok(JointKind::Hinge {
            axis: axis_of([x, y, z])?,
            limits: if limited == 1.0 {
                Some(limits_of(least, most)?)
            } else {
                None
            },
            motor: motor_of(speed, torque)?,
        }),
        (3.0, &[length]) => Ok(JointKind::Rope {
            length: ranged("joint.length", length, LENGTHS)?,
        }),
        (4.0, &[length, stiffness, damping]) => Ok(JointKind::Spring {
            length: ranged("joint.length", length, (0.0, LENGTHS.1))?,
            stiffness: ranged("joint.stiffness", stiffness, COEFFICIENTS)?,
            damping: ranged("joint.damping", damping, COEFFICIENTS)?,
        }),
        (0.0 | 1.0 | 2.0 | 3.0 | 4.0, _) => Err(shape_error(
            "joint.numbers",
            numbers.len() as f64,
            "joint.numbers has not the numbers of its kind".to_owned(),
        )),
        _ => Err(ParameterError::out_of_range("joint.kind", f64::from(kind), 0.0, 4.0)),
    }
}

fn axis_of(axis: [f32; 3]) -> Result<Vector, ParameterError> {
    for (name, value) in AXES.iter().zip(axis) {
        ranged(&format!("joint.axis.{name}"), value, (-1e3, 1e3))?;
    }
    let axis = Vector::from(axis);
    ranged("joint.axis", axis.length(), (1e-3, 2e3))?;
    Ok(axis.unit_or(Vector::Y))
}

fn limits_of(least: f32, most: f32) -> Result<[f32; 2], ParameterError> {
    let least = ranged("joint.limits.0", least, ANGLES)?;
    let most = ranged("joint.limits.1", most, (f64::from(least), ANGLES.1))?;
    Ok([least, most])
}

fn motor_of(speed: f32, torque: f32) -> Result<Option<Motor>, ParameterError> {
    let speed = ranged("joint.motor.speed", speed, MOTOR_SPEEDS)?;
    let torque = ranged("joint.motor.torque", torque, MOTOR_TORQUES)?;
    Ok((torque > 0.0).then_some(Motor { speed, torque }))
}
