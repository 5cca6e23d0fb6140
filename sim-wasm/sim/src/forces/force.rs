//! The interface of forces, and their inputs.

use wide::f32x4;

pub(crate) use crate::forces::frames::{direction_in, place_in, vector_in};
use crate::forces::prepared::Prepared;
use crate::layout::gust::Gust;
use crate::layout::parameters::item::{Item, LIST_LIMIT};
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::StepTime;
use crate::math::simd::{Vector4, positive_part};
use crate::particles::tile::Tile;

/// The phase of a step in which a force acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Adds air velocity, evaluated at the expected middle of the step.
    Air,
    /// Adds accelerations and drag, or changes the slip.
    Push,
    /// Rotates the air, once all other motion of the particle is known.
    Swirl,
    /// Limits the displacement of the step.
    Limit,
}

/// The inputs of all forces in a step.
#[derive(Clone, Copy)]
pub struct ForceContext<'s> {
    pub parameters: &'s Parameters,
    pub now: StepTime<'s>,
    /// Selects the random patterns.
    pub seed: u32,
    /// State of each turbulence of the list, then of the global one.
    pub turbulence: &'s [TurbulenceState; LIST_LIMIT + 1],
    /// The active gusts.
    pub gusts: &'s [Gust],
    /// What rare forces derive from the parameters.
    #[cfg_attr(not(feature = "rare"), allow(dead_code, reason = "only rare forces read it"))]
    pub(crate) prepared: &'s Prepared,
}

/// A kind of force, with the parameters of one item as `Self`.
pub trait Force: Item {
    /// An item prepared for the SIMD lanes of one step.
    type Kernel;

    /// The phase in which it acts.
    const PHASE: Phase;

    /// Prepares item `index`; none if it has no effect in this step.
    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Self::Kernel>;

    /// The global force of this kind, which has parameters of its own.
    fn everywhere(_setting: &ForceContext) -> Option<Self::Kernel> {
        None
    }

    /// Applies all `kernels` to the particles of `tile`.
    fn act(kernels: &[Self::Kernel], tile: &mut Tile);
}

/// State of a turbulence between steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurbulenceState {
    /// Displacement of the pattern by the wind (m).
    pub drift: [f64; 3],
    /// Phase of the first octave (rad).
    pub phase: f64,
}

/// The direction of the world's up in all lanes; none for y.
pub(crate) fn up_in(context: &ForceContext) -> Option<Vector4> {
    context.now.parts.up.map(|up| Vector4::splat(up.into()))
}

/// The fade (1 - r^2 / R^2)^2 for the squared distance r^2 and the inverse of R^2; 0 where r >= R.
#[inline(always)]
pub(crate) fn fade(squared: f32x4, inverse_reach_squared: f32x4) -> f32x4 {
    let left = positive_part(f32x4::ONE - squared * inverse_reach_squared);
    left * left
}
