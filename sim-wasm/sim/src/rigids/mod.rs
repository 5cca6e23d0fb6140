//! Rigid bodies of Rapier: what moves, is jointed or has any shape.
//!
//! Rapier moves the rigids; particles are none. After Rapier's step each rigid is an obstacle on its way from the pose
//! before to the pose after, and [`crate::collide`] lets the particles near it bump into that.

mod compound;
pub mod description;
mod forms;
mod grid;
mod meshes;
mod numbers;
mod save;
mod world;

use crate::collide::contact::{Material, Obstacle};
use crate::collide::motion::Motion;
use crate::collide::shapes::{Collider, Nearest};
use crate::collide::space::{Bounds, Pose, Vector};
use crate::collide::survey::{Extent, Ways};
use crate::error::ParameterError;
use crate::hash::Hash;
pub use description::{RigidDescription, RigidKind, RigidPart, RigidShape, pose_of};
use grid::Grid;
pub use numbers::{FlatRigid, RigidNumbers};
use world::World;

/// A kinematic rigid's surface never moves faster (m/s): up to here no particle can get through it.
pub const TOP_SPEED: f32 = 20.0;
/// Floats of one rigid in [`Rigids::poses`].
pub const POSE_PAIR_FLOATS: usize = 14;
const MOST_RIGIDS: usize = 4096;

/// The rigids of one simulator.
pub struct Rigids {
    world: World,
    members: Vec<Member>,
    obstacles: Vec<Obstacle<Box<dyn Collider>>>,
    poses: Vec<f32>,
    grid: Grid,
    bounds: Bounds,
}

struct Member {
    description: RigidDescription,
    pose: Pose,
    /// Where a kinematic rigid was told to go, until it is there.
    target: Option<Pose>,
    /// No point of the shape is farther from its origin (m).
    reach: f32,
}

impl Default for Rigids {
    fn default() -> Self {
        Self::new()
    }
}

impl std::fmt::Debug for Rigids {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Rigids")
            .field("count", &self.count())
            .finish_non_exhaustive()
    }
}

impl Rigids {
    /// No rigids.
    pub fn new() -> Self {
        Self {
            world: World::new(),
            members: Vec::new(),
            obstacles: Vec::new(),
            poses: Vec::new(),
            grid: Grid::default(),
            bounds: Bounds::NOTHING,
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.members.len()
    }

    /// Puts a rigid into the world and returns its number.
    ///
    /// # Errors
    /// When the shape has no volume, or there are 4096 rigids already; nothing was added then.
    pub fn add(&mut self, description: RigidDescription) -> Result<u32, ParameterError> {
        let index = self.count();
        if index == MOST_RIGIDS {
            return Err(ParameterError::out_of_range(
                "rigid.count",
                index as f64 + 1.0,
                0.0,
                MOST_RIGIDS as f64,
            ));
        }
        let forms = forms::forms_of(&description)?;
        self.world.add(&description, &forms.rapiers);
        self.place(description, forms.ours);
        Ok(index as u32)
    }

    /// Takes up a rigid that stands in the world already.
    fn place(&mut self, description: RigidDescription, shape: Box<dyn Collider>) {
        let pose = self.world.pose(self.count());
        let own = shape.bounds();
        let material = Material {
            restitution: description.restitution,
            friction: description.friction,
        };
        let motion = Motion::resting(pose);
        let bounds = motion.bounds_of(&own);
        self.grid.add(bounds);
        self.bounds = self.grid.bounds();
        self.obstacles.push(Obstacle {
            shape,
            motion,
            material,
            bounds,
        });
        let reach = own.min.abs().greatest(own.max.abs()).length();
        self.members.push(Member {
            description,
            pose,
            target: None,
            reach,
        });
        self.poses.extend_from_slice(&pair(&pose, &pose));
    }

    /// Sends a kinematic rigid to a pose: it is there after the coming step, or after more when its surface would have
    /// to move faster than [`TOP_SPEED`].
    ///
    /// # Errors
    /// When there is no such rigid or it is not kinematic.
    pub fn move_to(&mut self, index: u32, pose: Pose) -> Result<(), ParameterError> {
        self.check_kinematic(index)?;
        self.members[index as usize].target = Some(pose);
        Ok(())
    }

    /// Refuses a rigid that does not exist or cannot be told where to go.
    pub(crate) fn check_kinematic(&self, index: u32) -> Result<(), ParameterError> {
        let Some(member) = self.members.get(index as usize) else {
            let last = self.count() as f64 - 1.0;
            return Err(ParameterError::out_of_range("rigid.index", f64::from(index), 0.0, last));
        };
        if member.description.kind != RigidKind::Kinematic {
            let message = format!("rigid {index} is not kinematic; only kinematic rigids can be told where to go");
            return Err(description::shape_error("rigid.index", f64::from(index), message));
        }
        Ok(())
    }

    /// For each rigid its pose before and after the last step: x, y, z (m) and the quaternion x, y, z, w, twice.
    pub fn poses(&self) -> &[f32] {
        &self.poses
    }

    /// Moves every rigid over `dt` seconds; keeps the poses at the start and at the end.
    pub fn advance(&mut self, dt: f32) {
        if self.members.is_empty() {
            return;
        }
        for (index, member) in self.members.iter_mut().enumerate() {
            if let Some(next) = member.next_pose(dt) {
                self.world.head_for(index, &next);
            }
        }
        self.world.step(dt);
        for index in 0..self.count() {
            let start = self.members[index].pose;
            let end = self.world.pose(index);
            self.members[index].pose = end;
            self.follow(index, start, end, dt);
        }
        self.bounds = self.grid.bounds();
    }

    fn follow(&mut self, index: usize, start: Pose, end: Pose, dt: f32) {
        let obstacle = &mut self.obstacles[index];
        let still = start == end;
        obstacle.motion = if still {
            Motion::resting(end)
        } else {
            Motion::between(start, end, dt, obstacle.shape.is_round())
        };
        obstacle.bounds = obstacle.motion.bounds_of(&obstacle.shape.bounds());
        self.grid.place(index, obstacle.bounds);
        self.poses[index * POSE_PAIR_FLOATS..][..POSE_PAIR_FLOATS].copy_from_slice(&pair(&start, &end));
    }

    /// Makes ready for [`Rigids::find_near`], given where the particles are.
    pub(crate) fn prepare(&mut self, extent: &Extent) {
        // A few particles that are far larger or faster than the rest shall not make the cells of all others too full.
        let margin = extent.greatest_reach.min(3.0 * extent.mean_reach);
        self.grid.lay(&extent.middles, margin);
    }

    /// Bit k is set when the k-th of four particles may be near a rigid.
    pub(crate) fn may_touch(&self, ways: &Ways) -> u32 {
        match ways.touching(&self.bounds) {
            0 => 0,
            lanes => lanes & self.grid.occupied(ways),
        }
    }

    /// Appends the numbers, raised by `first`, of the rigids whose box touches `way`.
    pub(crate) fn find_near(&self, way: &Bounds, first: u32, near: &mut Vec<u32>) {
        if self.count() > 0 {
            self.grid.find_near(way, first, near);
        }
    }

    /// A rigid on its way through the step.
    pub(crate) fn obstacle(&self, index: usize) -> &Obstacle<Box<dyn Collider>> {
        &self.obstacles[index]
    }

    /// Adds the rigids' state to `hash`; adds nothing when there are none.
    pub fn hash_into(&self, hash: &mut Hash) {
        hash.floats(&self.poses);
        for (index, member) in self.members.iter().enumerate() {
            self.world.hash_into(index, hash);
            if let Some(target) = &member.target {
                hash.floats(&pose_numbers(target));
            }
        }
    }
}

impl Member {
    /// How far towards its target this rigid gets in `dt` seconds.
    fn next_pose(&mut self, dt: f32) -> Option<Pose> {
        let target = self.target?;
        let way = (target.position - self.pose.position).length();
        let arc = self.pose.turn_to(&target).length() * self.reach;
        let share = TOP_SPEED * dt / (way + arc).max(f32::MIN_POSITIVE);
        if share >= 1.0 {
            self.target = None;
            Some(target)
        } else {
            Some(self.pose.towards(&target, share))
        }
    }
}

impl Collider for Box<dyn Collider> {
    fn nearest(&self, point: Vector, limit: f32) -> Nearest {
        self.as_ref().nearest(point, limit)
    }

    fn bounds(&self) -> Bounds {
        self.as_ref().bounds()
    }

    fn is_round(&self) -> bool {
        self.as_ref().is_round()
    }
}

fn pose_numbers(pose: &Pose) -> [f32; 7] {
    let [x, y, z]: [f32; 3] = pose.position.into();
    let [i, j, k, w] = pose.rotation;
    [x, y, z, i, j, k, w]
}

fn pair(start: &Pose, end: &Pose) -> [f32; POSE_PAIR_FLOATS] {
    let mut floats = [0.0; POSE_PAIR_FLOATS];
    floats[..7].copy_from_slice(&pose_numbers(start));
    floats[7..].copy_from_slice(&pose_numbers(end));
    floats
}
