//! Analytic colliders outside of the table, for objects that come and go and move while the simulation runs.
//!
//! The caller chooses the slots. A collider turns and moves as a kinematic rigid of the same shape does, without Rapier:
//! from the pose of the last step to the pose that it was given, no faster than [`TOP_SPEED`]. Its velocity follows from
//! both poses. These are saved and part of the hash; the pose given for the coming step is saved only.

use crate::collide::analytic::{self, AnalyticCollider, AnalyticShape};
use crate::collide::contact::{Action, Obstacle};
use crate::collide::shapes::Collider;
use crate::layout::bytes::{Reader, SnapshotSection, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::limits::{COLLIDER_LIMIT, STEP, TOP_SPEED};
use crate::math::hash::Hash;
use crate::math::pose::{MAX_COORDINATE, POSE_FLOATS, Pose, normalise};

/// Least and greatest of the numbers that describe a collider: shape, half extents x, y, z and radius (m), restitution,
/// friction, action and tint.
const LEAST: [f32; 9] = [0.0, 1e-3, 1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0, 1.0];
const GREATEST: [f32; 9] = [3.0, 1e3, 1e3, 1e3, 1e3, 1.0, 1.0, 2.0, 15.0];

/// Numbers of a new collider: those that describe it, and its pose.
pub const COLLIDER_NUMBERS: usize = LEAST.len() + POSE_FLOATS;

/// Description, then the poses before and after the last step, and the pose that it goes to. Free slots are 0.
type Slot = [f32; LEAST.len() + 3 * POSE_FLOATS];

const START: usize = LEAST.len();
const NOW: usize = START + POSE_FLOATS;
const TARGET: usize = NOW + POSE_FLOATS;
const FREE: Slot = [0.0; LEAST.len() + 3 * POSE_FLOATS];

/// The colliders of one simulator. The first one allocates the memory of all.
#[derive(Clone, Debug, Default)]
pub struct ColliderPool(Vec<Slot>);

impl ColliderPool {
    /// Sets, moves or removes a collider.
    ///
    /// # Arguments
    /// * `index` - The slot, below [`COLLIDER_LIMIT`].
    /// * `numbers` - [`COLLIDER_NUMBERS`] place a collider at rest: shape (0 plane, 1 ball, 2 box, 3 capsule), half
    ///   extents x, y, z and radius (m), restitution, friction, action (0 bounce, 1 kill, 2 tint), tint, then the pose x, y, z
    ///   (m) and the quaternion x, y, z, w. A plane is the half space below y = 0. A capsule extends along y, its half
    ///   extent y is that of its straight part. The seven numbers of a pose send the collider there in the coming step, or
    ///   later at [`TOP_SPEED`]. No numbers remove it.
    ///
    /// # Errors
    /// There is no such slot or no collider in it, or a number is out of range; nothing changes.
    #[cold]
    pub fn put(&mut self, index: u32, numbers: &[f32]) -> Result<(), ParameterError> {
        let mut next = self.0.get(index as usize).copied().unwrap_or(FREE);
        match numbers.len() {
            0 => next = FREE,
            POSE_FLOATS if is_used(&next) => next[TARGET..].copy_from_slice(numbers),
            COLLIDER_NUMBERS => {
                next[..NOW].copy_from_slice(numbers);
                next.copy_within(START..NOW, NOW);
                next.copy_within(START..NOW, TARGET);
            }
            _ => return Err(error_of(index as f32, 0.0, -1.0)),
        }
        self.set(index, next)
    }

    /// Checks a slot and sets it.
    #[cold]
    #[inline(never)]
    fn set(&mut self, index: u32, mut slot: Slot) -> Result<(), ParameterError> {
        if index as usize >= COLLIDER_LIMIT {
            return Err(error_of(index as f32, 0.0, COLLIDER_LIMIT as f32 - 1.0));
        }
        if slot != FREE {
            for (number, (min, max)) in slot.iter().zip(LEAST.into_iter().zip(GREATEST)) {
                if !(min..=max).contains(number) {
                    return Err(error_of(*number, min, max));
                }
            }
            for pose in slot[START..].as_chunks_mut().0 {
                if !normalise(pose) {
                    return Err(error_of(pose[0], -MAX_COORDINATE, MAX_COORDINATE));
                }
            }
        }
        if self.0.is_empty() {
            self.0 = vec![FREE; COLLIDER_LIMIT];
        }
        self.0[index as usize] = slot;
        Ok(())
    }

    /// Returns true if there is no collider.
    pub(crate) fn is_empty(&self) -> bool {
        !self.0.iter().any(is_used)
    }

    /// Moves the colliders by a step.
    pub(crate) fn advance(&mut self) {
        for slot in self.0.iter_mut().filter(|slot| is_used(slot)) {
            let reach = collider(slot).own_shape().bounds().reach();
            // A plane has no end: only its origin is slow enough.
            let reach = if reach < f32::INFINITY { reach } else { 0.0 };
            slot.copy_within(NOW..TARGET, START);
            let next = pose(slot, NOW).nearer(&pose(slot, TARGET), reach, TOP_SPEED * STEP as f32);
            slot[NOW..TARGET].copy_from_slice(&next.numbers());
        }
    }

    /// The obstacles of the step.
    pub(crate) fn obstacles(&self) -> impl Iterator<Item = Obstacle<AnalyticShape>> {
        let used = self.0.iter().filter(|slot| is_used(slot));
        used.map(|slot| collider(slot).moving(pose(slot, START), pose(slot, NOW)))
    }

    /// Adds the poses before and after the last step to `hash`; nothing without colliders.
    pub(crate) fn hash_into(&self, hash: &mut Hash) {
        for (index, slot) in self.0.iter().enumerate().filter(|(_, slot)| is_used(slot)) {
            hash.word(index as u32);
            hash.floats(&slot[START..TARGET]);
        }
    }
}

impl SnapshotSection for ColliderPool {
    #[cold]
    fn write(&self, body: &mut Writer) {
        for (index, slot) in self.0.iter().enumerate().filter(|(_, slot)| is_used(slot)) {
            body.word(index as u32);
            slot.iter().for_each(|number| body.word(number.to_bits()));
        }
    }

    #[cold]
    fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let mut pool = Self::default();
        while reader.end().is_err() {
            let (index, mut slot) = (reader.word()?, FREE);
            for number in &mut slot {
                *number = reader.float()?;
            }
            pool.set(index, slot)?;
        }
        Ok(pool)
    }
}

fn is_used(slot: &Slot) -> bool {
    let [.., radius] = slot.first_chunk::<5>().expect("it has a radius");
    *radius > 0.0
}

fn pose(slot: &Slot, at: usize) -> Pose {
    Pose::of_numbers(*slot[at..].first_chunk().expect("it has three poses"))
}

fn collider(slot: &Slot) -> AnalyticCollider {
    let [shape, x, y, z, radius, restitution, friction, action, tint, ..] = *slot;
    AnalyticCollider {
        shape: analytic::shape(shape as u32),
        position: [0.0; 3],
        axis: [0.0, 1.0, 0.0],
        half_extents: [x, y, z],
        radius,
        restitution,
        friction,
        roughness: 0.0,
        action: Action::from_numbers(action as u8, tint as u8),
    }
}

#[cold]
fn error_of(value: f32, min: f32, max: f32) -> ParameterError {
    ParameterError::out_of_range("collide.shape", f64::from(value), f64::from(min), f64::from(max))
}
