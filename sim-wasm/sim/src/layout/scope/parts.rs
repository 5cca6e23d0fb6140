//! Parts of a scene that are no rigids, such as a propeller: nothing bumps into them, but emitters, forces and shedders
//! ride on them.
//!
//! The caller gives their poses before each step. They hold for that step only and are no state: they are neither saved
//! nor part of the hash, so a caller that gives the same poses for the same step gets the same step.

use crate::layout::error::ParameterError;
use crate::math::pose::Pose;
#[cfg(feature = "rigids")]
use crate::math::pose::{Frame, product};

/// The number of the first part where the number of a rigid is expected; rigids have smaller ones.
pub const FIRST_PART: usize = 4096;
/// Most parts of a scene.
pub const MAX_PARTS: usize = 64;
/// Numbers of a part at a moment, in [`Parts::place`].
pub const PART_FLOATS: usize = 8;

/// Farthest from the origin of the carrier or of the world (m).
const MAX_COORDINATE: f32 = 1e4;
/// How far the squared length of a quaternion may be from 1.
const LENGTH_TOLERANCE: f32 = 1e-3;

/// Where the parts are in a step.
#[derive(Debug, Default)]
pub struct Parts {
    /// As [`Parts::place`] takes them.
    numbers: Vec<f32>,
    /// Between the start and the end of a step: the poses are in the world.
    is_stepping: bool,
}

impl Parts {
    /// Gives the poses for the coming step: all parts at its start, then all parts at its end. A part has 8 numbers: the
    /// rigid that carries it, -1 for none, and its pose, x, y, z (m) and the unit quaternion x, y, z, w. Poses are meant in
    /// the space of the carrier, or in the world where there is no such rigid. In a step a part turns by less than half a
    /// turn.
    ///
    /// # Errors
    /// When there are more than 64 parts, or a pose is none; the poses given before stay.
    pub fn place(&mut self, numbers: &[f32]) -> Result<(), ParameterError> {
        let (parts, rest) = numbers.as_chunks::<PART_FLOATS>();
        let are_pairs = parts.len() % 2 == 0 && rest.is_empty();
        if parts.len() > 2 * MAX_PARTS || !are_pairs || !parts.iter().all(is_sound) {
            let count = numbers.len() as f64 / (2 * PART_FLOATS) as f64;
            return Err(ParameterError::out_of_range("parts", count, 0.0, MAX_PARTS as f64));
        }
        self.numbers.clear();
        self.numbers.extend_from_slice(numbers);
        Ok(())
    }

    /// A step begins, in which the parts are where they were placed.
    pub(crate) fn begin(&mut self) {
        self.is_stepping = true;
    }

    /// Puts the parts that rigids carry where those take them in the step that has begun.
    ///
    /// # Arguments
    /// * `rigids` - The poses of the rigids before and after the step, as [`ends_of_rigid`] reads them.
    #[cfg(feature = "rigids")]
    pub(crate) fn carry(&mut self, rigids: &[f32]) {
        let (parts, _) = self.numbers.as_chunks_mut::<PART_FLOATS>();
        let count = parts.len() / 2;
        for (index, [carrier, own @ ..]) in parts.iter_mut().enumerate() {
            let is_rigid = (0.0..FIRST_PART as f32).contains(carrier);
            if let Some(carriers) = is_rigid.then(|| ends_of_rigid(rigids, *carrier as usize)).flatten() {
                let Pose { position, rotation } = carried(&carriers[index / count], &Pose::of_numbers(*own));
                let [x, y, z]: [f32; 3] = position.into();
                let [i, j, k, w] = rotation;
                *own = [x, y, z, i, j, k, w];
            }
        }
    }

    /// Forgets the poses at the end of a step: what happens between two steps must not depend on them, because a saved
    /// state does not have them.
    pub(crate) fn end(&mut self) {
        self.numbers.clear();
        self.is_stepping = false;
    }

    /// The poses of the part that `number` means, counted from [`FIRST_PART`], at the start and at the end of the step;
    /// none between steps.
    // Once in the module, and not in each kernel.
    #[inline(never)]
    pub(crate) fn ends(&self, number: f64) -> Option<[Pose; 2]> {
        if !self.is_stepping || number < FIRST_PART as f64 {
            return None;
        }
        let index = number as usize - FIRST_PART;
        let (parts, _) = self.numbers.as_chunks::<PART_FLOATS>();
        let [_, start @ ..] = *parts.get(index)?;
        let [_, end @ ..] = *parts.get(parts.len() / 2 + index)?;
        Some([Pose::of_numbers(start), Pose::of_numbers(end)])
    }
}

/// The poses of a rigid before and after a step, among those of all rigids, 14 numbers each: x, y, z (m) and the unit
/// quaternion x, y, z, w, twice.
pub(crate) fn ends_of_rigid(poses: &[f32], rigid: usize) -> Option<[Pose; 2]> {
    let [before, after] = *poses.as_chunks::<7>().0.get(2 * rigid..2 * rigid + 2)? else {
        return None;
    };
    Some([Pose::of_numbers(before), Pose::of_numbers(after)])
}

/// The pose `own`, meant in the space of `carrier`, in the world.
#[cfg(feature = "rigids")]
fn carried(carrier: &Pose, own: &Pose) -> Pose {
    Pose {
        position: Frame::new(carrier).world_from_local(own.position),
        rotation: product(carrier.rotation, own.rotation),
    }
}

fn is_sound([_, pose @ ..]: &[f32; PART_FLOATS]) -> bool {
    let Pose { position, rotation } = Pose::of_numbers(*pose);
    let square: f32 = rotation.iter().map(|part| part * part).sum();
    position.length() <= MAX_COORDINATE && (square - 1.0).abs() <= LENGTH_TOLERANCE
}
