//! Vortices: the air rotates about an axis.
//!
//! Lamb-Oseen: at the distance r from the axis the air rotates at the angular velocity
//!
//! w(r) = G m / (2 pi r^2) * (1 - exp(-r^2 / c^2)) * (1 - r^2 / R^2)^2,  and at 0 where r >= R.
//!
//! Parameters: `vortices.#.circulation` G (m2/s, counter-clockwise seen against the axis), `.coreRadius` c (m),
//! `.reach` R (m, distance from the axis at which the swirl ends), `.position.*` (m, a point on the axis), `.axis.*` (a
//! direction of any length), `forces.vortex` m (multiplier). The air rotates as a solid within the core and as a free
//! vortex outside; the last factor ends it smoothly. `.profile` 1 selects the core of Rankine, an exact solid rotation:
//! 1 - exp(-r^2 / c^2) becomes min(r^2 / c^2, 1). Any w(r) is free of divergence. `.inflow` and `.updraft` (m/s) draw
//! air to the axis and along it: see `draft`.
//!
//! The integrator must not move a particle outwards. The plain midpoint rule multiplies the radius by 1 + a^4 / 8 for a
//! rotation by the angle a: 1 % after 20 revolutions at 5 rad/s. Here w is evaluated at the middle that the last step
//! predicts; the half step rotates about the axis by 2 atan(a / 4) instead of moving straight, and the whole step
//! follows its chord. A lone vortex keeps the radius at any speed except for rounding; only the angle lags (by a^3 / 48
//! per step). No vortex moves anything by more than twice its distance. Combined with other flows the rule is of second
//! order.

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

/// A vortex in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    swirl: Swirl,
    scope: Reach,
    /// Inflow and updraft, if any.
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
        // The common case keeps its rotation in registers.
        match kernels {
            [kernel] if kernel.draft.is_none() => add_mean_velocity(kernel, tile),
            _ => add_mean_velocities(kernels, tile),
        }
    }
}

/// Adds the velocities (m/s) at the current places.
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

/// Adds the mean velocity (m/s) over the step of a single vortex.
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

/// Adds the mean velocity (m/s) over the step of several vortices. Each moves the middle of the step for the others.
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
