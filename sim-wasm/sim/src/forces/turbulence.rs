//! Turbulence: small irregular swirls.
//!
//! It is the sum of octaves, random flows that are free of divergence (see `octave`). Each octave has half the size of
//! the one before, which has `turbulence.scale` (m), and 0.6 times its speed; `turbulence.octaves` 0..4 of them
//! together have the root mean square speed `turbulence.speed` (m/s) times `forces.turbulence`. The pattern changes by
//! a phase that grows by `turbulence.evolution` (rad/s), 1.5 times as fast in each next octave: after a quarter turn
//! nothing is left of the old pattern, while the speed stays the same. The wind of `forces.wind.*` carries the pattern
//! along. `turbulence.*` acts everywhere, `turbulences.#.*` add to it, each in its region, at whose soft edge the flow
//! is not free of divergence.

use wide::f32x4;

use super::{Force, ForceContext, Phase};
use crate::parameters::field::{Field, number};
use crate::parameters::section::Item;
use crate::parameters::{LIST_LIMIT, Parameters};
use crate::scope::{Reach, Scope};
use crate::simd::Vector4;
use crate::tile::{Columns, Tile};

pub mod octave;
use octave::Octave;

/// Most octaves.
pub const OCTAVE_LIMIT: usize = 4;

const OCTAVE_SPEED: f64 = 0.6;
const OCTAVE_PACE: f64 = 1.5;
/// `turbulence.*`: the swirls that are everywhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pattern {
    pub speed: f64,
    pub scale: f64,
    pub octaves: f64,
    pub evolution: f64,
}

impl Item for Pattern {
    const FIELDS: &'static [Field<Self>] = &[
        number("speed", "m/s", [0.0, 20.0], 0.0, |t: &mut Self| &mut t.speed),
        number("scale", "m", [0.05, 100.0], 1.0, |t: &mut Self| &mut t.scale),
        number("octaves", "1", [0.0, 4.0], 1.0, |t: &mut Self| &mut t.octaves).whole(),
        number("evolution", "1/s", [0.0, 10.0], 0.3, |t: &mut Self| &mut t.evolution),
    ];
}

/// `turbulences.#.*`: swirls in a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turbulence {
    pub pattern: Pattern,
    pub scope: Scope,
}

impl Item for Turbulence {
    const LABEL: &'static str = "Turbulence";
    const FIELDS: &'static [Field<Self>] = &[
        number("speed", "m/s", [0.0, 20.0], 0.0, |t: &mut Self| &mut t.pattern.speed)
            .starts_at(0.5)
            .says(
                "Speed",
                "Typical (root mean square) speed of the swirls; 0 takes this turbulence away.",
            ),
        number("scale", "m", [0.05, 100.0], 1.0, |t: &mut Self| &mut t.pattern.scale)
            .says("Scale", "Size of the largest swirls."),
        number("octaves", "1", [0.0, 4.0], 1.0, |t: &mut Self| &mut t.pattern.octaves)
            .whole()
            .says("Octaves", "How many finer layers of swirls are added; 0 is still air."),
        number("evolution", "1/s", [0.0, 10.0], 0.3, |t: &mut Self| {
            &mut t.pattern.evolution
        })
        .says("Evolution", "How fast the pattern of swirls changes."),
    ];

    fn scope(&mut self) -> Option<&mut Scope> {
        Some(&mut self.scope)
    }
}

/// What a turbulence remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurbulenceState {
    /// How far the wind has carried the pattern (m).
    pub drift: [f64; 3],
    /// p of the first octave (rad).
    pub phase: f64,
}

/// Moves all patterns on by `dt` seconds: those of the list, then the one that is everywhere.
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

/// A turbulence of one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    swirls: Swirls,
    reach: Reach,
}

/// The field of one step.
#[derive(Clone, Copy, Debug)]
pub struct Swirls {
    octaves: [Octave; OCTAVE_LIMIT],
    len: usize,
}

impl Swirls {
    /// The field of `pattern`, its speed multiplied by `strength`; none without octaves or speed.
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

    /// Number `index` of all turbulences of a simulation.
    fn of_context(pattern: &Pattern, context: &ForceContext, index: usize) -> Option<Self> {
        // The one that is everywhere keeps the seed as it is.
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
