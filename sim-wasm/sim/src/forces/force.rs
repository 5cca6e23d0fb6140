//! What a force is, and what it is made ready from.

use wide::f32x4;

use crate::layout::gust::Gust;
use crate::layout::parameters::item::{Item, LIST_LIMIT};
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::StepTime;
use crate::math::double::direction;
use crate::math::pose::Frame;
use crate::math::simd::{Vector4, positive_part};
use crate::math::vector::Vector;
use crate::particles::tile::Tile;

/// When in a step a force has its turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Adds to the air's velocity, evaluated where the middle of the step is expected.
    Air,
    /// Adds accelerations and drag, or changes the slip.
    Push,
    /// Turns the air, once all else that moves the particle is known.
    Swirl,
    /// Limits the way of the step.
    Limit,
}

/// What forces are made ready from.
#[derive(Clone, Copy, Debug)]
pub struct ForceContext<'s> {
    pub parameters: &'s Parameters,
    pub now: StepTime<'s>,
    /// Chooses the patterns of chance.
    pub seed: u32,
    /// Of each turbulence of the list, then of the one that is everywhere.
    pub turbulence: &'s [TurbulenceState; LIST_LIMIT + 1],
    /// What people blow.
    pub gusts: &'s [Gust],
}

/// A kind of force, described by what one item of its list holds.
pub trait Force: Item {
    /// An item made ready for the lanes of one step.
    type Kernel;

    /// Its turn in a step.
    const PHASE: Phase;

    /// Makes item `index` ready; none where it does nothing in this step.
    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Self::Kernel>;

    /// The force that acts everywhere by parameters of its own, beside the list.
    fn everywhere(_setting: &ForceContext) -> Option<Self::Kernel> {
        None
    }

    /// Lets all that are ready act on the particles of `tile`.
    fn act(kernels: &[Self::Kernel], tile: &mut Tile);
}

/// What a turbulence remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurbulenceState {
    /// How far the wind has carried the pattern (m).
    pub drift: [f64; 3],
    /// p of the first octave (rad).
    pub phase: f64,
}

/// A place (m) of `frame` in the world, in every lane.
pub(crate) fn place_in(frame: &Frame, place: [f64; 3]) -> Vector4 {
    let local = Vector::from(place.map(|metres| metres as f32));
    Vector4::splat(frame.world_from_local(local).into())
}

/// A vector of `frame` in the world, in every lane.
pub(crate) fn vector_in(frame: &Frame, vector: [f32; 3]) -> Vector4 {
    Vector4::splat(frame.rotate(Vector::from(vector)).into())
}

/// A direction of `frame` in the world with length 1, in every lane.
pub(crate) fn direction_in(frame: &Frame, axis: [f64; 3]) -> Vector4 {
    vector_in(frame, self::direction(axis))
}

/// (1 - r^2 / R^2)^2 for the squared distance r^2 and the inverse of R^2; 0 where r >= R.
#[inline(always)]
pub(crate) fn fade(squared: f32x4, inverse_reach_squared: f32x4) -> f32x4 {
    let left = positive_part(f32x4::ONE - squared * inverse_reach_squared);
    left * left
}
