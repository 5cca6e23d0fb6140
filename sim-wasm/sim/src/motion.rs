//! How particles move in one step.
//!
//! Air and slip: a particle goes with the air at its place, and in addition with its slip, on which lift and drag act.
//! The slip has a closed form (see `forces::drag`). The air is followed by a midpoint rule. Wind is everywhere the same.
//! Turbulence and the speed of vortices, by far the dearest, are evaluated once, half of the last step's displacement
//! ahead: that is the middle of this step up to second order, since velocities hardly change within a step, at half the
//! cost of a trial step, and unlike a value at the start it does not throw particles out of the swirls. The direction
//! in which a vortex moves a particle is that of the middle, found by a half step (see `forces::vortex`).
//!
//! Paper: forward Euler on one inertial velocity v, as published: x += v h, v += k h (u - v) + a h. The air acts only
//! through drag, and vortices fling particles outwards.

use wide::f32x4;

use crate::forces::drag::Drag;
use crate::forces::{Air, Lift};
use crate::particles::{LANES, Particles};
use crate::simd::{Vector4, blocks, blocks_mut};

/// The rule by which particles move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// The air's velocity by the midpoint rule plus slip in closed form.
    AirAndSlip,
    /// Forward Euler on one inertial velocity, as published.
    Paper,
}

impl Integrator {
    /// The rule that `simulation.integrator` names: 0 air and slip, 1 paper.
    pub fn from_parameter(value: f64) -> Self {
        if value == 1.0 { Self::Paper } else { Self::AirAndSlip }
    }
}

/// All that moves particles in one step.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub integrator: Integrator,
    pub air: Air,
    pub lift: Lift,
    pub drag: Drag,
    /// Length of the step (s).
    pub dt: f32,
}

/// What a step makes of a block: places and slips at its end.
type Moved = (Vector4, Vector4);

/// Moves every particle by one step; `px`, `py`, `pz` become the places at its start.
pub fn advance(particles: &mut Particles, motion: &Motion) {
    match motion.integrator {
        Integrator::AirAndSlip => for_each_block(particles, |block| motion.air_and_slip(block)),
        Integrator::Paper => for_each_block(particles, |block| motion.paper(block)),
    }
}

/// Turns what the particles keep from slip into velocity, or back, so that a change of the integrator does not jerk.
pub fn change_integrator(particles: &mut Particles, air: &Air, to: Integrator) {
    let sign = f32x4::splat(if to == Integrator::Paper { 1.0 } else { -1.0 });
    let count = particles.padded_alive() / LANES;
    let (x, y, z) = (
        blocks(&particles.x, count),
        blocks(&particles.y, count),
        blocks(&particles.z, count),
    );
    let sx = blocks_mut(&mut particles.sx, count);
    let sy = blocks_mut(&mut particles.sy, count);
    let sz = blocks_mut(&mut particles.sz, count);
    for block in 0..count {
        let velocity = air.velocity(Vector4::load(x, y, z, block)) * sign;
        let slip = Vector4::load(sx, sy, sz, block) + velocity;
        store(slip, sx, sy, sz, block);
    }
}

/// State of four particles at the start of a step.
struct Block {
    place: Vector4,
    previous: Vector4,
    slip: Vector4,
    temperature: f32x4,
}

impl Motion {
    #[inline(always)]
    fn air_and_slip(&self, block: Block) -> Moved {
        let (slip, slipped) = self.slip(&block);
        let dt = f32x4::splat(self.dt);
        let ahead = (block.place - block.previous) * f32x4::HALF;
        let mut flow = self.air.wind;
        if !self.air.turbulence.is_empty() {
            flow += self.air.turbulence.velocity(block.place + ahead);
        }
        if !self.air.vortices.is_empty() {
            let half = (flow * dt + slipped) * f32x4::HALF;
            flow += self.air.vortices.mean_velocity(block.place, ahead, half);
        }
        (block.place + flow * dt + slipped, slip)
    }

    /// Slip after the step, and the displacement that it brings.
    #[inline(always)]
    fn slip(&self, block: &Block) -> (Vector4, Vector4) {
        let lift = self.lift.acceleration(block.temperature);
        let mut slip = block.slip * self.drag.kept;
        slip.y += lift * self.drag.first;
        let mut slipped = block.slip * self.drag.first;
        slipped.y += lift * self.drag.second;
        (slip, slipped)
    }

    #[inline(always)]
    fn paper(&self, block: Block) -> Moved {
        let dt = f32x4::splat(self.dt);
        let air = self.air.velocity(block.place);
        let mut velocity = block.slip + (air - block.slip) * self.drag.euler;
        velocity.y += self.lift.acceleration(block.temperature) * dt;
        (block.place + block.slip * dt, velocity)
    }
}

#[inline(always)]
fn for_each_block(particles: &mut Particles, rule: impl Fn(Block) -> Moved) {
    let count = particles.padded_alive() / LANES;
    let x = blocks_mut(&mut particles.x, count);
    let y = blocks_mut(&mut particles.y, count);
    let z = blocks_mut(&mut particles.z, count);
    let px = blocks_mut(&mut particles.px, count);
    let py = blocks_mut(&mut particles.py, count);
    let pz = blocks_mut(&mut particles.pz, count);
    let sx = blocks_mut(&mut particles.sx, count);
    let sy = blocks_mut(&mut particles.sy, count);
    let sz = blocks_mut(&mut particles.sz, count);
    for (block, temperature) in blocks(&particles.temperature, count).iter().enumerate() {
        let place = Vector4::load(x, y, z, block);
        let (moved, slip) = rule(Block {
            place,
            previous: Vector4::load(px, py, pz, block),
            slip: Vector4::load(sx, sy, sz, block),
            temperature: f32x4::new(*temperature),
        });
        store(place, px, py, pz, block);
        store(moved, x, y, z, block);
        store(slip, sx, sy, sz, block);
    }
}

#[inline(always)]
fn store(value: Vector4, x: &mut [[f32; LANES]], y: &mut [[f32; LANES]], z: &mut [[f32; LANES]], block: usize) {
    x[block] = value.x.to_array();
    y[block] = value.y.to_array();
    z[block] = value.z.to_array();
}
