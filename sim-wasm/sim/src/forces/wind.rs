//! Wind: the air moves as a whole.
//!
//! u = w max(0, 1 + s (y - h)) + d g(t), for the height y, the mean velocity w (m/s), the shear s (1/m) about the height h (m), and
//! gusts g along the direction d of the mean wind. The shear never reverses the wind.
//!
//! Gusts have the root mean square speed `gusts`. Their spectrum is flat up to the frequency 1 / `gustTime` and falls
//! with the power -5/3 above, as in Kaimal et al., "Spectral characteristics of surface-layer turbulence", Quarterly
//! Journal of the Royal Meteorological Society 98, 1972. They are a sum of sixteen waves, the same at all positions.
//! The seed selects the phases. Still air has no direction; its gusts blow along x.
//!
//! `forces.wind.*` with `wind.*` acts everywhere and moves the pattern of turbulence. `winds.#.*` act in their regions.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase, up_in, vector_in};
use crate::layout::parameters::forces::wind::Wind;
use crate::layout::parameters::item::Scope;
use crate::layout::parameters::settings::Weather;
use crate::layout::scope::Reach;
use crate::math::double::direction;
use crate::math::pose::Frame;
use crate::math::random::Random;
use crate::math::simd::{Vector4, positive_part};
use crate::particles::tile::{Columns, Tile};

const WAVES: u32 = 16;
/// Ratio of consecutive wave frequencies: sixteen waves span a factor of 300.
const FREQUENCY_RATIO: f64 = 1.46;
/// Lowest frequency, as a share of 1 / `gustTime`.
const SLOWEST: f64 = 0.1;

/// A wind in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    mean: Vector4,
    gust: Vector4,
    shear: f32x4,
    height: f32x4,
    /// The direction of up; none for y.
    up: Option<Vector4>,
    reach: Reach,
}

impl Force for Wind {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Air;

    fn kernel(&self, index: usize, context: &ForceContext) -> Option<Kernel> {
        self.blowing(index as u32 + 1, context)
    }

    fn everywhere(context: &ForceContext) -> Option<Kernel> {
        let wind = Wind {
            velocity: context.parameters.forces.wind,
            weather: context.parameters.wind,
            scope: Scope {
                rigid: crate::layout::parameters::item::WORLD,
                ..Scope::default()
            },
        };
        wind.blowing(0, context)
    }

    // Called from two places; inlining would repeat it.
    #[inline(never)]
    fn act(kernels: &[Kernel], tile: &mut Tile) {
        let Columns {
            ahead, flow, weight, ..
        } = tile.columns();
        for kernel in kernels {
            kernel.reach.weigh(ahead, weight);
            for ((flow, ahead), weight) in flow.iter_mut().zip(&*ahead).zip(&*weight) {
                let height = kernel.up.map_or(ahead.y, |up| up.dot(*ahead));
                let factor = positive_part(f32x4::ONE + kernel.shear * (height - kernel.height));
                *flow += (kernel.mean * factor + kernel.gust) * *weight;
            }
        }
    }
}

impl Wind {
    /// Prepares the wind; `number` selects the random phases of its gusts.
    fn blowing(&self, number: u32, context: &ForceContext) -> Option<Kernel> {
        if self.velocity == [0.0; 3] && self.weather.gusts == 0.0 {
            return None;
        }
        let reach = Reach::new(&self.scope, &context.now)?;
        let frame = context.now.frame(&self.scope);
        Some(self.blow(&frame, reach, number, context))
    }

    fn blow(&self, frame: &Frame, reach: Reach, number: u32, context: &ForceContext) -> Kernel {
        let along = if self.velocity == [0.0; 3] {
            [1.0, 0.0, 0.0]
        } else {
            direction(self.velocity)
        };
        let speed = gust(&self.weather, context.now.time, context.seed ^ number) as f32;
        Kernel {
            mean: vector_in(frame, self.velocity.map(|component| component as f32)),
            gust: vector_in(frame, along.map(|component| component * speed)),
            shear: f32x4::splat(self.weather.shear as f32),
            height: f32x4::splat(self.weather.height as f32),
            up: up_in(context),
            reach,
        }
    }
}

/// Speed of the gusts (m/s) at `time` (s).
pub fn gust(weather: &Weather, time: f64, seed: u32) -> f64 {
    if weather.gusts == 0.0 {
        return 0.0;
    }
    let mut random = Random::new(seed ^ 0x9d2c_5680);
    let (mut sum, mut power) = (0.0, 0.0);
    for wave in 0..WAVES {
        let share = SLOWEST * libm::pow(FREQUENCY_RATIO, f64::from(wave));
        let phase = f64::from(random.unit());
        let density = libm::pow(1.0 + share, -5.0 / 3.0);
        // Frequencies have equal ratios, so each wave represents a band as wide as its frequency.
        let amplitude = libm::sqrt(density * share);
        let cycles = share / weather.gust_time * time + phase;
        sum += amplitude * libm::sin(2.0 * std::f64::consts::PI * (cycles - libm::floor(cycles)));
        power += 0.5 * amplitude * amplitude;
    }
    weather.gusts * sum / libm::sqrt(power)
}
