//! The physics world of Rapier. Gravity is 9.81 m/s2.

use rapier3d::glamx::{Mat3, Pose3, Quat, Vec3};
use rapier3d::parry::shape::SharedShape;
use rapier3d::prelude::{
    ColliderBuilder, PhysicsWorld, RigidBody, RigidBodyBuilder, RigidBodyHandle, RigidBodyMassProps, RigidBodyType,
};

use crate::math::hash::Hash;
use crate::math::pose::Pose;
use crate::math::vector::Vector;
use crate::rigids::description::{RigidDescription, RigidKind};
use crate::rigids::grab::Grab;
use crate::rigids::meshes::{ours, parrys};

const GRAVITY: f32 = -9.81;
/// Angular damping during a drag, as a share of the spring's stiffness.
const SWING_DAMPING: f32 = 0.5;

/// Rapier's world. Bodies have the indices of their rigids. None is ever removed: a removed rigid is a disabled body,
/// which the next rigid of its index takes over with its colliders. Rapier's own removal would add 15 kB for soft bodies
/// and multibodies.
pub struct World {
    physics: PhysicsWorld,
}

/// The force of air on a rigid.
pub struct Push {
    /// Air velocity (m/s).
    pub velocity: Vector,
    /// The rigid's axes in world space.
    pub axes: [Vector; 3],
    /// Force per squared relative velocity along each axis (kg/m).
    pub resistance: Vector,
    /// Point of application in world space (m).
    pub point: Vector,
}

impl World {
    /// Creates an empty world.
    pub fn new() -> Self {
        let mut physics = PhysicsWorld::new();
        physics.gravity = Vec3::new(0.0, GRAVITY, 0.0);
        Self { physics }
    }

    /// Sets the unit vector against which gravity acts. A change wakes all rigids.
    pub fn turn(&mut self, up: Vector) {
        let gravity = parrys(up) * GRAVITY;
        if gravity == self.physics.gravity {
            return;
        }
        self.physics.gravity = gravity;
        for (_, body) in self.physics.bodies.iter_mut() {
            body.wake_up(true);
        }
    }

    /// Adds a rigid with at least one shape, each at its pose in the rigid.
    pub fn add(&mut self, description: &RigidDescription, shapes: &[(Pose, SharedShape)]) {
        let index = self.count();
        let body =
            RigidBodyBuilder::new(body_type(description.kind)).ccd_enabled(description.kind == RigidKind::Dynamic);
        self.physics.insert_body(body.pose(rapiers(&description.pose)));
        for (pose, shape) in shapes {
            self.insert_collider(index, description, pose, shape);
        }
    }

    fn insert_collider(&mut self, index: usize, description: &RigidDescription, pose: &Pose, shape: &SharedShape) {
        let collider = ColliderBuilder::new(shape.clone())
            .position(rapiers(pose))
            .restitution(description.restitution)
            .friction(description.friction)
            .density(description.density);
        self.physics.insert_collider(collider, Some(handle(index)));
    }

    /// Turns a rigid off.
    pub fn remove(&mut self, index: usize) {
        self.physics.bodies[handle(index)].set_enabled(false);
    }

    /// Replaces a rigid that was turned off.
    pub fn replace(&mut self, index: usize, description: &RigidDescription, shapes: &[(Pose, SharedShape)]) {
        let body = &mut self.physics.bodies[handle(index)];
        body.set_enabled(true);
        body.set_body_type(body_type(description.kind), true);
        body.enable_ccd(description.kind == RigidKind::Dynamic);
        let colliders = body.colliders().to_vec();
        self.put(index, &description.pose);
        self.clear_forces(index);
        for (number, (pose, shape)) in shapes.iter().enumerate() {
            let Some(known) = colliders.get(number) else {
                self.insert_collider(index, description, pose, shape);
                continue;
            };
            let collider = &mut self.physics.colliders[*known];
            collider.set_enabled(true);
            collider.set_shape(shape.clone());
            collider.set_position_wrt_parent(rapiers(pose));
            collider.set_restitution(description.restitution);
            collider.set_friction(description.friction);
            collider.set_density(description.density);
        }
        for unused in colliders.iter().skip(shapes.len()) {
            self.physics.colliders[*unused].set_enabled(false);
        }
    }

    /// Sets the pose of a kinematic rigid after the coming step.
    pub fn head_for(&mut self, index: usize, pose: &Pose) {
        self.physics.bodies[handle(index)].set_next_kinematic_position(rapiers(pose));
    }

    /// Teleports a rigid, at rest and awake.
    pub fn put(&mut self, index: usize, pose: &Pose) {
        let body = &mut self.physics.bodies[handle(index)];
        body.set_position(rapiers(pose), true);
        body.set_linvel(Vec3::ZERO, true);
        body.set_angvel(Vec3::ZERO, true);
    }

    /// Drags a point of a dynamic rigid: applies the force that gives the point the velocity of the spring after `dt`
    /// seconds, against gravity and for any mass. Damps the rotation about the point.
    pub fn pull(&mut self, index: usize, grab: &Grab, dt: f32) {
        let gravity = self.physics.gravity;
        let body = &mut self.physics.bodies[handle(index)];
        let point = body.position().transform_point(parrys(grab.anchor));
        let velocity = body.velocity_at_point(point);
        let wanted = grab.spring(ours(point), ours(velocity), grab.target, dt);
        let change = parrys(wanted) - velocity - gravity * dt;
        let force = mass_at(body.mass_properties(), point) * change / dt;
        body.add_force_at_point(force, point, true);
        body.set_angular_damping(SWING_DAMPING * grab.stiffness);
    }

    /// Applies the force of air to a dynamic rigid. It uses the relative velocity at the end of the step, so it never
    /// throws back a light rigid and is exact in equilibrium with gravity.
    pub fn blow(&mut self, index: usize, push: &Push, dt: f32) {
        let gravity = self.physics.gravity;
        let body = &mut self.physics.bodies[handle(index)];
        let mass = body.mass();
        if mass <= 0.0 {
            return;
        }
        let relative = parrys(push.velocity) - body.linvel();
        let coming = relative - gravity * dt;
        let rates = push.resistance * (relative.length() / mass);
        let mut force = Vec3::ZERO;
        for (axis, rate) in push.axes.into_iter().zip(<[f32; 3]>::from(rates)) {
            let normal = parrys(axis);
            force += normal * (mass * rate / (1.0 + rate * dt) * coming.dot(normal));
        }
        body.add_force_at_point(force, parrys(push.point), true);
        let damping = body.angular_damping() + rates.x.max(rates.y).max(rates.z);
        body.set_angular_damping(damping);
    }

    /// Clears the forces of the last step.
    pub fn clear_forces(&mut self, index: usize) {
        let body = &mut self.physics.bodies[handle(index)];
        body.reset_forces(false);
        body.reset_torques(false);
        body.set_angular_damping(0.0);
    }

    /// Advances by `dt` seconds.
    pub fn step(&mut self, dt: f32) {
        self.physics.integration_parameters.dt = dt;
        self.physics.step();
    }

    /// The pose of a rigid.
    pub fn pose(&self, index: usize) -> Pose {
        let pose = self.body(index).position();
        Pose {
            position: ours(pose.translation),
            rotation: pose.rotation.to_array(),
        }
    }

    /// Adds the state of a rigid to `hash`.
    pub fn hash_into(&self, index: usize, hash: &mut Hash) {
        let body = self.body(index);
        let pose = body.position();
        hash.floats(&pose.translation.to_array());
        hash.floats(&pose.rotation.to_array());
        hash.floats(&body.linvel().to_array());
        hash.floats(&body.angvel().to_array());
        hash.word(u32::from(body.is_sleeping()));
    }

    fn body(&self, index: usize) -> &RigidBody {
        &self.physics.bodies[handle(index)]
    }

    /// Number of rigids.
    pub fn count(&self) -> usize {
        self.physics.bodies.len()
    }

    /// Rapier's own world, for comparison.
    #[cfg(feature = "bench")]
    pub fn physics(&self) -> &PhysicsWorld {
        &self.physics
    }

    /// Serialises the world.
    pub fn to_bytes(&self) -> Vec<u8> {
        world::to_bytes(&self.physics)
    }

    /// Restores a saved world; an empty one from no bytes, none for invalid bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        if bytes.is_empty() {
            return Some(Self::new());
        }
        world::from_bytes(bytes).map(|physics| Self { physics })
    }
}

/// Effective mass at a point (kg): the inverse of 1/m - [r] I^-1 [r]. Zero before the first step, in which Rapier
/// computes masses.
fn mass_at(properties: &RigidBodyMassProps, point: Vec3) -> Mat3 {
    let arm = point - properties.world_com;
    let column = |axis: Vec3| {
        let turned = properties.effective_world_inv_inertia.mul_vec(arm.cross(axis));
        properties.effective_inv_mass * axis + turned.cross(arm)
    };
    let mobility = Mat3::from_cols(column(Vec3::X), column(Vec3::Y), column(Vec3::Z));
    if mobility.determinant() > 0.0 {
        mobility.inverse()
    } else {
        Mat3::ZERO
    }
}

fn body_type(kind: RigidKind) -> RigidBodyType {
    match kind {
        RigidKind::Fixed => RigidBodyType::Fixed,
        RigidKind::Kinematic => RigidBodyType::KinematicPositionBased,
        RigidKind::Dynamic => RigidBodyType::Dynamic,
    }
}

fn handle(index: usize) -> RigidBodyHandle {
    RigidBodyHandle::from_raw_parts(index as u32, 0)
}

fn rapiers(pose: &Pose) -> Pose3 {
    Pose3::from_parts(parrys(pose.position), Quat::from_array(pose.rotation))
}
