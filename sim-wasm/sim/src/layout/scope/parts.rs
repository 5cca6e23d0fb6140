//! Parts of a scene, such as a propeller. Particles do not collide with them; emitters, forces and shedders can be
//! attached to them.
//!
//! The caller sets their poses before each step. Poses hold for that step only: they are inputs, neither saved nor
//! hashed. The direction of the world's up is another such input, for smoke whose space is not upright.

use crate::layout::error::ParameterError;
#[cfg(feature = "meshes")]
use crate::math::pose::{Frame, product};
use crate::math::pose::{MAX_COORDINATE, POSE_FLOATS, Pose};
use crate::math::vector::Vector;

/// Number of the first part where a rigid's number is expected. Rigids have smaller numbers.
pub const FIRST_PART: usize = 4096;
/// Maximum number of parts.
pub const MAX_PARTS: usize = 256;
/// Floats per part in [`Parts::place`].
pub const PART_FLOATS: usize = 8;

/// Tolerance of the squared length of a quaternion or a direction.
const LENGTH_TOLERANCE: f32 = 1e-3;

/// Poses of the parts in a step.
#[derive(Debug, Default)]
pub struct Parts {
    /// The layout of [`Parts::place`].
    numbers: Vec<f32>,
    /// The direction of the world's up in this step; none for y.
    pub(crate) up: Option<Vector>,
    /// True between the start and the end of a step: the poses are in world space.
    is_stepping: bool,
}

impl Parts {
    /// Sets the poses for the coming step: all parts at its start, then all parts at its end. Each part has 8 numbers:
    /// the rigid that carries it (-1: none), x, y, z (m) and the unit quaternion x, y, z, w. A pose is relative to the
    /// carrier, or to the world without one. Within a step a part rotates by less than pi. Three more numbers are the
    /// unit vector against which gravity acts in this step, and along which smoke rises; y without them.
    ///
    /// # Errors
    /// More than [`MAX_PARTS`] parts, or an invalid pose; the previous poses stay.
    pub fn place(&mut self, numbers: &[f32]) -> Result<(), ParameterError> {
        let (parts, rest) = numbers.as_chunks::<PART_FLOATS>();
        let up = rest.as_array::<3>().map(|up| Vector::from(*up));
        let are_pairs = parts.len() % 2 == 0 && (rest.is_empty() || up.is_some_and(|up| is_unit(up.dot(up))));
        if parts.len() > 2 * MAX_PARTS || !are_pairs || !parts.iter().all(is_sound) {
            let count = numbers.len() as f64 / (2 * PART_FLOATS) as f64;
            return Err(ParameterError::out_of_range("parts", count, 0.0, MAX_PARTS as f64));
        }
        self.numbers.clear();
        self.numbers.extend_from_slice(parts.as_flattened());
        self.up = up;
        Ok(())
    }

    /// Starts a step.
    pub(crate) fn begin(&mut self) {
        self.is_stepping = true;
    }

    /// Transforms the poses of carried parts to world space.
    ///
    /// # Arguments
    /// * `rigids` - The poses of the rigids before and after the step, as [`ends_of_rigid`] reads them.
    #[cfg(feature = "meshes")]
    pub(crate) fn carry(&mut self, rigids: &[f32]) {
        let (parts, _) = self.numbers.as_chunks_mut::<PART_FLOATS>();
        let count = parts.len() / 2;
        for (index, [carrier, own @ ..]) in parts.iter_mut().enumerate() {
            let is_rigid = (0.0..FIRST_PART as f32).contains(carrier);
            if let Some(carriers) = is_rigid.then(|| ends_of_rigid(rigids, *carrier as usize)).flatten() {
                *own = carried(&carriers[index / count], &Pose::of_numbers(*own)).numbers();
            }
        }
    }

    /// Clears the poses at the end of a step. A saved state does not hold them, so nothing between steps may depend on
    /// them.
    pub(crate) fn end(&mut self) {
        self.numbers.clear();
        self.up = None;
        self.is_stepping = false;
    }

    /// Poses of part `number`, counted from [`FIRST_PART`], at the start and at the end of the step; none between
    /// steps.
    // Not inlined: every kernel would hold a copy.
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

/// Poses of a rigid before and after a step. `poses` holds both for each rigid.
pub(crate) fn ends_of_rigid(poses: &[f32], rigid: usize) -> Option<[Pose; 2]> {
    let [before, after] = *poses.as_chunks::<POSE_FLOATS>().0.get(2 * rigid..2 * rigid + 2)? else {
        return None;
    };
    Some([Pose::of_numbers(before), Pose::of_numbers(after)])
}

/// Transforms `own` from the space of `carrier` to world space.
#[cfg(feature = "meshes")]
fn carried(carrier: &Pose, own: &Pose) -> Pose {
    Pose {
        position: Frame::new(carrier).world_from_local(own.position),
        rotation: product(carrier.rotation, own.rotation),
    }
}

fn is_sound([_, pose @ ..]: &[f32; PART_FLOATS]) -> bool {
    let Pose { position, rotation } = Pose::of_numbers(*pose);
    let square: f32 = rotation.iter().map(|part| part * part).sum();
    position.length() <= MAX_COORDINATE && is_unit(square)
}

fn is_unit(square: f32) -> bool {
    (square - 1.0).abs() <= LENGTH_TOLERANCE
}
