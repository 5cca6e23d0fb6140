//! The rigids of one simulator.

use crate::collide::broad_phase::{NearLanes, ParticleExtent, SweptBoxes};
use crate::collide::contact::{Material, Obstacle};
use crate::collide::core::Core;
use crate::collide::shapes::{Collider, Nearest};
use crate::collide::swept_particle::SweptParticle;
use crate::layout::error::ParameterError;
use crate::layout::limits::STEP;
use crate::layout::scope::parts::{FIRST_PART, ends_of_rigid};
use crate::math::bounds::Bounds;
use crate::math::hash::Hash;
use crate::math::pose::{POSE_FLOATS, Pose};
use crate::math::pose_motion::PoseMotion;
use crate::math::vector::Vector;
use crate::rigids::description::{RigidDescription, RigidKind, RigidShape};
use crate::rigids::forms;
use crate::rigids::grid::RigidGrid;
use crate::rigids::guide::Guide;
#[cfg(feature = "bench")]
use crate::rigids::meshes::{ours, parrys};
use crate::rigids::shells::Shells;
use crate::rigids::world::World;

/// Floats per rigid in [`Rigids::poses`].
pub const POSE_PAIR_FLOATS: usize = 2 * POSE_FLOATS;
const MAX_RIGIDS: usize = FIRST_PART;

/// The rigids of one simulator.
pub struct Rigids {
    pub(super) world: World,
    pub(super) members: Vec<Member>,
    pub(super) obstacles: Vec<Obstacle<Box<dyn Collider>>>,
    pub(super) poses: Vec<f32>,
    pub(super) grid: RigidGrid,
    pub(super) bounds: Bounds,
    /// Rigids with a boundary layer; rigids that feel smoke, and their measurements.
    pub(super) layered: Shells,
    #[cfg(feature = "rigids")]
    pub(super) feeling: Shells,
    #[cfg(feature = "rigids")]
    pub(super) sums: Vec<SmokeSum>,
}

/// Weighted mean of the particles near one rigid.
#[cfg(feature = "rigids")]
#[derive(Clone, Copy, Debug, Default)]
pub struct SmokeSum {
    pub(super) weight: f32,
    pub(super) velocity: Vector,
    /// Relative to the rigid's origin, world space.
    pub(super) offset: Vector,
}

pub(super) struct Member {
    pub(super) description: RigidDescription,
    pub(super) pose: Pose,
    pub(super) guide: Guide,
    /// Upper bound of the distance of the shape from its origin (m).
    pub(super) reach: f32,
    /// The next rigid may reuse its index.
    pub(super) is_removed: bool,
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
    /// Creates an empty set.
    pub fn new() -> Self {
        Self {
            world: World::new(),
            members: Vec::new(),
            obstacles: Vec::new(),
            poses: Vec::new(),
            grid: RigidGrid::default(),
            bounds: Bounds::NOTHING,
            layered: Shells::default(),
            #[cfg(feature = "rigids")]
            feeling: Shells::default(),
            #[cfg(feature = "rigids")]
            sums: Vec::new(),
        }
    }

    /// Number of indices in use, those of removed rigids included.
    pub fn count(&self) -> usize {
        self.members.len()
    }

    /// Adds a rigid and returns its index, the lowest of a removed rigid if there is one.
    ///
    /// # Errors
    /// The shape has no volume, or there are 4096 rigids already; nothing is added.
    pub fn add(&mut self, description: RigidDescription) -> Result<u32, ParameterError> {
        let free = self.members.iter().position(|member| member.is_removed);
        let index = free.unwrap_or(self.count());
        if index == MAX_RIGIDS {
            return Err(ParameterError::out_of_range(
                "rigid.count",
                index as f64 + 1.0,
                0.0,
                MAX_RIGIDS as f64,
            ));
        }
        let forms = forms::forms_of(&description)?;
        match free {
            Some(_) => self.world.replace(index, &description, &forms.rapiers),
            None => self.world.add(&description, &forms.rapiers),
        }
        let pose = self.world.pose(index);
        self.place(index, pose, description, forms.ours);
        Ok(index as u32)
    }

    /// Registers a rigid that the world already contains, under a new index or that of a removed rigid.
    pub(super) fn place(&mut self, index: usize, pose: Pose, description: RigidDescription, shape: Box<dyn Collider>) {
        let own = shape.bounds();
        let material = Material {
            restitution: description.restitution,
            friction: description.friction,
            roughness: 0.0,
            action: description.action,
        };
        let motion = PoseMotion::resting(pose);
        let bounds = motion.bounds_of(&own);
        if index == self.count() {
            self.grid.add(bounds);
            self.poses.extend_from_slice(&[0.0; POSE_PAIR_FLOATS]);
            #[cfg(feature = "rigids")]
            self.sums.push(SmokeSum::default());
        }
        self.grid.place(index, bounds);
        self.bounds = self.grid.bounds();
        let obstacle = Obstacle {
            core: shape.core(),
            shape,
            motion,
            material,
            bounds,
        };
        put(&mut self.obstacles, index, obstacle);
        let member = Member {
            description,
            pose,
            guide: Guide::new(pose),
            reach: own.reach(),
            is_removed: false,
        };
        // An index is never unregistered: a rigid without these effects is skipped.
        if member.description.boundary_layer > 0.0 {
            self.layered.add(index);
        }
        #[cfg(feature = "rigids")]
        if member.feels_smoke() {
            self.feeling.add(index);
        }
        put(&mut self.members, index, member);
        self.poses[index * POSE_PAIR_FLOATS..][..POSE_PAIR_FLOATS].copy_from_slice(&pair(&pose, &pose));
    }

    /// Removes a rigid. A later rigid reuses its index. What is attached to the index stays at its last pose.
    ///
    /// # Errors
    /// The rigid does not exist.
    pub fn remove(&mut self, index: u32) -> Result<(), ParameterError> {
        self.check_exists(index)?;
        let index = index as usize;
        self.world.remove(index);
        self.place_removed(index, self.members[index].pose);
        Ok(())
    }

    /// Registers an index without a rigid, which nothing collides with.
    pub(super) fn place_removed(&mut self, index: usize, pose: Pose) {
        let description = removed(pose);
        let forms = forms::forms_of(&description).expect("a ball has a volume");
        self.place(index, pose, description, forms.ours);
        self.members[index].is_removed = true;
        self.obstacles[index].bounds = Bounds::NOTHING;
        self.grid.place(index, Bounds::NOTHING);
        self.bounds = self.grid.bounds();
    }

    /// Poses of each rigid before and after the last step: x, y, z (m) and the quaternion x, y, z, w, twice.
    pub fn poses(&self) -> &[f32] {
        &self.poses
    }

    /// Moves all rigids over `dt` seconds and stores their poses at the start and at the end.
    pub fn advance(&mut self, dt: f32) {
        self.step_world(dt);
        self.follow_world(dt);
    }

    /// Sets the unit vector against which gravity acts.
    #[cfg(feature = "rigids")]
    pub(crate) fn turn(&mut self, up: Vector) {
        self.world.turn(up);
    }

    /// First half of [`Rigids::advance`]: the step of the world.
    pub(crate) fn step_world(&mut self, dt: f32) {
        if self.members.is_empty() {
            return;
        }
        for (index, member) in self
            .members
            .iter_mut()
            .enumerate()
            .filter(|(_, member)| !member.is_removed)
        {
            #[cfg(feature = "rigids")]
            member.put(index, &mut self.world);
            member.lead(index, &mut self.world, dt);
        }
        #[cfg(feature = "rigids")]
        self.world.step(dt);
        #[cfg(feature = "rigids")]
        for (index, member) in self.members.iter().enumerate() {
            if member.description.kind == RigidKind::Dynamic {
                self.world.clear_forces(index);
            }
        }
    }

    /// Second half of [`Rigids::advance`]: each rigid becomes a moving obstacle.
    pub(crate) fn follow_world(&mut self, dt: f32) {
        for index in 0..self.count() {
            if self.members[index].is_removed {
                continue;
            }
            let start = self.members[index].pose;
            let end = self.world.pose(index);
            self.members[index].pose = end;
            self.follow(index, start, end, dt);
        }
        self.bounds = self.grid.bounds();
    }

    fn follow(&mut self, index: usize, start: Pose, end: Pose, dt: f32) {
        let obstacle = &mut self.obstacles[index];
        obstacle.motion = if start == end {
            PoseMotion::resting(end)
        } else {
            PoseMotion::between(start, end, dt, obstacle.shape.is_round())
        };
        obstacle.bounds = obstacle.motion.bounds_of(&obstacle.shape.bounds());
        self.grid.place(index, obstacle.bounds);
        self.poses[index * POSE_PAIR_FLOATS..][..POSE_PAIR_FLOATS].copy_from_slice(&pair(&start, &end));
    }

    /// Motion of the rigid with this number in the step, including the rotation of round ones; none if there is no such
    /// rigid.
    pub(crate) fn ride(&self, number: f64) -> Option<PoseMotion> {
        let index = (number >= 0.0).then_some(number as usize)?;
        let [start, end] = ends_of_rigid(&self.poses, index)?;
        Some(PoseMotion::between(start, end, STEP as f32, false))
    }

    /// Prepares [`Rigids::find_near`] for the distribution of the particles.
    pub(crate) fn prepare(&mut self, extent: &ParticleExtent) {
        self.grid.rebuild(extent);
    }

    /// Broad-phase result of four particles.
    #[inline]
    pub(crate) fn look(&self, swept_boxes: &SweptBoxes) -> NearLanes {
        self.grid.look(swept_boxes, &self.bounds)
    }

    /// Appends the rigids whose box the particle's box touches; `first` is added to their indices. Returns true if the
    /// particle certainly misses all of them.
    #[inline]
    pub(crate) fn find_near(&self, swept_particle: &SweptParticle, first: u32, near: &mut Vec<u32>) -> bool {
        let begin = near.len();
        self.grid
            .find_touching(&swept_particle.bounds, swept_particle.location, first, near);
        let mut misses = true;
        for index in &near[begin..] {
            misses &= swept_particle.certainly_misses(&self.obstacles[(index - first) as usize]);
        }
        misses
    }

    /// A rigid as an obstacle of the step.
    pub(crate) fn obstacle(&self, index: usize) -> &Obstacle<Box<dyn Collider>> {
        &self.obstacles[index]
    }

    /// Adds the state of the rigids to `hash`; nothing without rigids.
    pub fn hash_into(&self, hash: &mut Hash) {
        hash.floats(&self.poses);
        for (index, member) in self.members.iter().enumerate().filter(|(_, member)| !member.is_removed) {
            self.world.hash_into(index, hash);
            member.guide.hash_into(hash);
        }
    }
}

/// Reference answers for measurements.
#[cfg(feature = "bench")]
impl Rigids {
    /// Returns true if the box that a rigid swept in the last step touches `bounds`.
    pub(crate) fn any_touches(&self, bounds: &Bounds) -> bool {
        self.obstacles.iter().any(|obstacle| obstacle.bounds.touches(bounds))
    }

    /// Appends the signed distance (m) from each point to the nearest rigid, by Rapier's query pipeline.
    pub(crate) fn project(&self, points: impl Iterator<Item = Vector>, limit: f32, distances: &mut Vec<f32>) {
        let pipeline = self.world.physics().query_pipeline();
        distances.extend(
            points.map(|point| match pipeline.project_point(parrys(point), limit, false) {
                Some((_, projection)) => {
                    let distance = (ours(projection.point) - point).length();
                    if projection.is_inside { -distance } else { distance }
                }
                None => limit,
            }),
        );
    }
}

impl Member {
    /// Returns true if smoke pushes this rigid.
    #[cfg(feature = "rigids")]
    pub(super) fn feels_smoke(&self) -> bool {
        self.description.kind == RigidKind::Dynamic && self.description.feels_smoke > 0.0
    }

    /// Applies the guidance for the coming step.
    fn lead(&mut self, index: usize, world: &mut World, dt: f32) {
        match (self.description.kind, &self.guide.grab) {
            (RigidKind::Kinematic, _) => {
                if let Some(next) = self.guide.next(dt, self.reach) {
                    world.head_for(index, &next);
                }
            }
            #[cfg(feature = "rigids")]
            (RigidKind::Dynamic, Some(grab)) => world.pull(index, grab, dt),
            _ => {}
        }
    }

    /// Teleports a dynamic rigid to its target. Its motion over the step starts there.
    #[cfg(feature = "rigids")]
    fn put(&mut self, index: usize, world: &mut World) {
        if self.description.kind != RigidKind::Dynamic {
            return;
        }
        if let Some(pose) = self.guide.target.take() {
            world.put(index, &pose);
            self.pose = pose;
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

    fn core(&self) -> Core {
        self.as_ref().core()
    }

    fn is_round(&self) -> bool {
        self.as_ref().is_round()
    }
}

/// What stands for a removed rigid.
pub(super) fn removed(pose: Pose) -> RigidDescription {
    RigidDescription::new(RigidKind::Fixed, RigidShape::Ball { radius: 1.0 }, pose)
}

/// Sets element `index`, which may be the next one.
fn put<T>(all: &mut Vec<T>, index: usize, value: T) {
    if index == all.len() {
        all.push(value);
    } else {
        all[index] = value;
    }
}

fn pair(start: &Pose, end: &Pose) -> [f32; POSE_PAIR_FLOATS] {
    let mut floats = [0.0; POSE_PAIR_FLOATS];
    floats[..7].copy_from_slice(&start.numbers());
    floats[7..].copy_from_slice(&end.numbers());
    floats
}
