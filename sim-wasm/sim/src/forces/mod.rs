//! The six forces. Three of them say how the air moves - wind, vortices, turbulence -, three act on a particle's
//! slip, which is its velocity relative to the air - gravity, buoyancy, drag. What each does stands in its own file;
//! how they move a particle stands in `motion`.

pub mod buoyancy;
pub mod drag;
pub mod gravity;
pub mod turbulence;
pub mod vortex;
pub mod wind;

use wide::f32x4;

use crate::parameters::Parameters;
use crate::simd::Vector4;
use turbulence::{Turbulence, TurbulenceState};
use vortex::Vortices;

/// How the air moves during one step, ready for the lanes. What is absent is empty and skipped for whole blocks.
#[derive(Clone, Copy, Debug)]
pub struct Air {
    pub wind: Vector4,
    pub vortices: Vortices,
    pub turbulence: Turbulence,
}

impl Air {
    /// The air that `parameters` describe, for steps of `dt` seconds; `seed` chooses the pattern of turbulence.
    pub fn new(parameters: &Parameters, state: &TurbulenceState, seed: u32, dt: f32) -> Self {
        Self {
            wind: Vector4::splat(wind::velocity(parameters)),
            vortices: Vortices::new(parameters, dt),
            turbulence: Turbulence::new(parameters, state, seed),
        }
    }

    /// Velocity (m/s) of the air at four places.
    #[inline(always)]
    pub fn velocity(&self, place: Vector4) -> Vector4 {
        self.wind + self.turbulence.velocity(place) + self.vortices.velocity(place)
    }

    /// Velocity (m/s) of the air at one place.
    pub fn velocity_at(&self, place: [f32; 3]) -> [f32; 3] {
        self.velocity(Vector4::splat(place)).first()
    }
}

/// The accelerations that act on slip: all are vertical, so that one number a particle is enough.
#[derive(Clone, Copy, Debug)]
pub struct Lift {
    gravity: f32x4,
    buoyancy: f32x4,
}

impl Lift {
    /// Gravity and buoyancy as `parameters` have them.
    pub fn new(parameters: &Parameters) -> Self {
        Self {
            gravity: f32x4::splat(gravity::acceleration(parameters)),
            buoyancy: f32x4::splat(buoyancy::acceleration_per_temperature(parameters)),
        }
    }

    /// Upward acceleration (m/s2) at these temperatures.
    #[inline(always)]
    pub fn acceleration(&self, temperature: f32x4) -> f32x4 {
        self.buoyancy * temperature - self.gravity
    }
}

/// `v` with length 1; straight up where it has no length.
pub fn unit(v: [f64; 3]) -> [f32; 3] {
    let length = libm::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if length < 1e-9 {
        return [0.0, 1.0, 0.0];
    }
    v.map(|component| (component / length) as f32)
}
