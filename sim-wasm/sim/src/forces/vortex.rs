//! Vortices: the air rotations about an axis.
//!
//! Lamb-Oseen: at the distance r from the axis the air moves around it at the angular velocity
//!
//! w(r) = G m / (2 pi r^2) * (1 - exp(-r^2 / c^2)) * (1 - r^2 / R^2)^2,  and at 0 where r >= R.
//!
//! Parameters: `vortices.#.circulation` G (m2/s, counter-clockwise seen against the axis), `.coreRadius` c (m),
//! `.reach` R (m, distance from the axis at which the swirl has faded to nothing), `.position.*` (m, a point on the
//! axis), `.axis.*` (a direction of any length), `forces.vortex` m (multiplier). Inside the core the air rotations like a
//! solid, outside like a free vortex; the last factor makes the end smooth. `.profile` 1 is the core of Rankine
//! instead, which rotations exactly like a solid: 1 - exp(-r^2 / c^2) becomes the smaller of r^2 / c^2 and 1. Any w(r) is
//! free of divergence. `.inflow` and `.updraft` (m/s) draw air to the axis and along it: see `draft`.
//!
//! A particle must not spiral out. The plain midpoint rule grows the radius by a^4 / 8 for a turn by the angle a, which
//! is 1 % after 20 rotations at 5 rad/s. Here w is taken where the last step, continued, puts the middle of this one; the
//! half step rotations about the axis by 2 atan(a / 4) instead of going straight, and the whole step takes the chord that
//! belongs to it. A lone vortex then keeps the radius at any speed but for rounding, only its angle lags (by a^3 / 48
//! a step), no vortex moves anything by more than twice its distance, and with other flows the rule is of second order.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::forces::vortex::draft::Draft;
use crate::forces::vortex::swirl::{HalfRotation, Swirl};
use crate::layout::parameters::forces::vortex::Vortex;
use crate::layout::parameters::item::LIST_LIMIT;
use crate::layout::scope::Reach;
use crate::math::simd::Vector4;
use crate::particles::tile::{Columns, TILE_BLOCKS, Tile};

pub(crate) mod draft;
pub(crate) mod swirl;

impl Vortex {
    fn is_still(&self) -> bool {
        self.circulation == 0.0 && self.inflow == 0.0 && self.updraft == 0.0
    }
}

/// A vortex of one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    swirl: Swirl,
    scope: Reach,
    /// Inflow and updraft, where there are any.
    draft: Option<Draft>,
}

impl Force for Vortex {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Swirl;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        let strength = context.parameters.forces.vortex;
        if strength == 0.0 || self.is_still() {
            return None;
        }
        let scope = Reach::new(&self.scope, &context.now)?;
        let frame = context.now.frame(&self.scope);
        let dt = context.now.dt as f32;
        Some(Kernel {
            swirl: Swirl::new(self, strength, &frame, dt),
            scope,
            draft: Draft::new(self, strength, dt),
        })
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        if tile.is_instant {
            return add_velocities(kernels, tile);
        }
        // The common case keeps its turn in registers instead of a table.
        match kernels {
            [kernel] if kernel.draft.is_none() => add_mean_velocity(kernel, tile),
            _ => add_mean_velocities(kernels, tile),
        }
    }
}

/// Adds the velocities (m/s) at the places.
fn add_velocities(kernels: &[Kernel], tile: &mut Tile) {
    let Columns {
        place, flow, weight, ..
    } = tile.columns();
    for kernel in kernels {
        kernel.scope.weigh(place, weight);
        for ((flow, place), weight) in flow.iter_mut().zip(&*place).zip(&*weight) {
            *flow += kernel.swirl.velocity(*place) * *weight;
            if let Some(draft) = &kernel.draft {
                *flow += draft.velocity(&kernel.swirl, *place) * *weight;
            }
        }
    }
}

/// Adds the mean velocity (m/s) over the step where there is one vortex.
fn add_mean_velocity(kernel: &Kernel, tile: &mut Tile) {
    let dt = f32x4::splat(tile.dt);
    let Columns {
        place,
        ahead,
        flow,
        slipped,
        weight,
        ..
    } = tile.columns();
    kernel.scope.weigh(ahead, weight);
    let rest = ahead.iter().zip(&*slipped).zip(&*weight);
    for ((flow, place), ((ahead, slipped), weight)) in flow.iter_mut().zip(&*place).zip(rest) {
        let rotation = kernel.swirl.rotation(*ahead, *weight);
        let half = (*flow * dt + *slipped) * f32x4::HALF;
        let middle = *place + half + kernel.swirl.half_step(*place, &rotation);
        *flow += kernel.swirl.chord_velocity(middle, &rotation);
    }
}

/// Adds the mean velocity (m/s) over the step of several vortices, each of which moves the middle for the others.
fn add_mean_velocities(kernels: &[Kernel], tile: &mut Tile) {
    let dt = f32x4::splat(tile.dt);
    let mut rotations = [[HalfRotation::IDENTITY; TILE_BLOCKS]; LIST_LIMIT];
    let mut middles = [Vector4::zero(); TILE_BLOCKS];
    let Columns {
        place,
        ahead,
        flow,
        slipped,
        weight,
        ..
    } = tile.columns();
    for (((middle, place), slipped), flow) in middles.iter_mut().zip(&*place).zip(&*slipped).zip(&*flow) {
        *middle = *place + (*flow * dt + *slipped) * f32x4::HALF;
    }
    for (kernel, rotations) in kernels.iter().zip(&mut rotations) {
        kernel.scope.weigh(ahead, weight);
        for (block, rotation) in rotations[..place.len()].iter_mut().enumerate() {
            *rotation = kernel.swirl.rotation(ahead[block], weight[block]);
            let mut half = kernel.swirl.half_step(place[block], rotation);
            if let Some(draft) = &kernel.draft {
                half += draft.half_step(&kernel.swirl, place[block], ahead[block], rotation, weight[block]);
            }
            middles[block] += half;
        }
    }
    for (kernel, rotations) in kernels.iter().zip(&rotations) {
        for ((flow, middle), rotation) in flow.iter_mut().zip(&middles).zip(rotations) {
            *flow += kernel.swirl.chord_velocity(*middle, rotation);
        }
        let Some(draft) = &kernel.draft else { continue };
        kernel.scope.weigh(ahead, weight);
        for (block, flow) in flow.iter_mut().enumerate() {
            *flow += draft.chord_velocity(&kernel.swirl, middles[block], &rotations[block], weight[block]);
        }
    }
}
