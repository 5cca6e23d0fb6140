//! Turbulence: small irregular vortices.
//!
//! It is a sum of octaves: random flows that are free of divergence (see `octave`). The first octave has the size
//! `turbulence.scale` (m). Each further one has half the size and 0.6 times the speed of the one before. Together
//! `turbulence.octaves` (0..4) octaves have the root mean square speed `turbulence.speed` (m/s) times
//! `forces.turbulence`.
//!
//! The pattern changes by a phase with the rate `turbulence.evolution` (rad/s), 1.5 times as fast in each further
//! octave. After a quarter turn the pattern is completely new; the speed does not change. The wind of `forces.wind.*`
//! moves the pattern.
//!
//! `turbulence.*` acts everywhere. `turbulences.#.*` add to it, each in its region; at the soft edge of a region the
//! flow is not free of divergence.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, TurbulenceState};
use crate::forces::turbulence::octave::Octave;
use crate::layout::parameters::forces::turbulence::Turbulence;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::parameters::settings::Pattern;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::Reach;
use crate::math::simd::Vector4;
use crate::particles::tile::{Columns, Tile};

pub mod octave;

/// Maximum number of octaves.
pub const OCTAVE_LIMIT: usize = 4;

const OCTAVE_SPEED: f64 = 0.6;
const OCTAVE_PACE: f64 = 1.5;

/// Advances all patterns by `dt` seconds: those of the list, then the global one.
pub fn advance(states: &mut [TurbulenceState; LIST_LIMIT + 1], parameters: &Parameters, dt: f64) {
    let listed = parameters.lists.turbulences.items().iter();
    for (state, turbulence) in states.iter_mut().zip(listed) {
        state.advance(&turbulence.pattern, parameters, dt);
    }
    states[LIST_LIMIT].advance(&parameters.turbulence, parameters, dt);
}

impl TurbulenceState {
    fn advance(&mut self, pattern: &Pattern, parameters: &Parameters, dt: f64) {
        for (drift, wind) in self.drift.iter_mut().zip(parameters.forces.wind) {
            *drift += wind * dt;
        }
        self.phase += pattern.evolution * dt;
    }
}

impl Force for Turbulence {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Kernel> {
        let swirls = Swirls::of_context(&self.pattern, context, index)?;
        let reach = Reach::new(&self.scope, &context.now)?;
        Some(Kernel { swirls, reach })
    }

    fn everywhere(context: &ForceContext) -> Option<Kernel> {
        let swirls = Swirls::of_context(&context.parameters.turbulence, context, LIST_LIMIT)?;
        Some(Kernel {
            swirls,
            reach: Reach::everywhere(),
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let Columns {
            ahead, flow, weight, ..
        } = tile.columns();
        for kernel in kernels {
            kernel.reach.weigh(ahead, weight);
            for octave in &kernel.swirls.octaves[..kernel.swirls.len] {
                octave.add(ahead, weight, flow);
            }
        }
    }
}

/// A turbulence in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    swirls: Swirls,
    reach: Reach,
}

/// The velocity field of one step.
#[derive(Clone, Copy, Debug)]
pub struct Swirls {
    octaves: [Octave; OCTAVE_LIMIT],
    len: usize,
}

impl Swirls {
    /// The field of `pattern` with its speed multiplied by `strength`; none without octaves or speed.
    pub fn new(pattern: &Pattern, strength: f64, state: &TurbulenceState, seed: u32) -> Option<Self> {
        let speed = pattern.speed * strength;
        let len = pattern.octaves as usize;
        if len == 0 || speed <= 0.0 {
            return None;
        }
        let power = |base: f64, number: usize| libm::pow(base, number as f64);
        let total: f64 = (0..len).map(|number| power(OCTAVE_SPEED * OCTAVE_SPEED, number)).sum();
        let first = speed / libm::sqrt(total);
        let octaves = std::array::from_fn(|number| {
            let (speed, pace) = (power(OCTAVE_SPEED, number), power(OCTAVE_PACE, number));
            let scale = pattern.scale / power(2.0, number);
            Octave::new(
                number as u32,
                scale,
                first * speed,
                state.drift,
                state.phase * pace,
                seed,
            )
        });
        Some(Self { octaves, len })
    }

    /// The field of turbulence `index`.
    fn of_context(pattern: &Pattern, context: &ForceContext, index: usize) -> Option<Self> {
        // The global turbulence keeps the seed unchanged.
        let number = (index + 1) % (LIST_LIMIT + 1);
        let seed = context.seed ^ (number as u32).wrapping_mul(0xc2b2_ae35);
        let strength = context.parameters.forces.turbulence;
        Self::new(pattern, strength, &context.turbulence[index], seed)
    }

    /// Velocity (m/s) at four places.
    pub fn velocity(&self, place: Vector4) -> Vector4 {
        let mut flow = [Vector4::zero()];
        for octave in &self.octaves[..self.len] {
            octave.add(&[place], &[f32x4::ONE], &mut flow);
        }
        flow[0]
    }
}
