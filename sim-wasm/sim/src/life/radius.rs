//! How large a particle is at which age.

use wide::f32x4;

use super::density::Curve;
use crate::collide::space::greater;
use crate::motion::Integrator;
use crate::parameters::Parameters;
use crate::simd::{positive_part, smaller};

/// The least time (s) in which a newborn particle swells, so that none appears from one step to the next. The paper's
/// integrator keeps the paper's law: there particles may be born full.
pub const MIN_GROWTH_TIME: f32 = 0.1;

/// Radius of a particle from its size and age; numbers that hold for all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusLaw {
    /// Factor on every radius, `puff.size`.
    pub puff_size: f32,
    /// Seconds until a newborn particle has its full size; 0: from the start.
    pub growth_time: f32,
    /// How density falls over life; none: linearly.
    curve: Option<Curve>,
}

impl RadiusLaw {
    /// The law that `parameters` set.
    pub fn new(parameters: &Parameters) -> Self {
        let growth_time = parameters.emission.growth_time as f32;
        let is_paper = Integrator::from_parameter(parameters.simulation.integrator) == Integrator::Paper;
        Self {
            puff_size: parameters.puff.size as f32,
            growth_time: if is_paper {
                growth_time
            } else {
                growth_time.max(MIN_GROWTH_TIME)
            },
            curve: Curve::new(parameters.density.items()),
        }
    }

    /// The linear law of the paper, with growth.
    pub const fn linear(puff_size: f32, growth_time: f32) -> Self {
        Self {
            puff_size,
            growth_time,
            curve: None,
        }
    }

    /// Radius (m) of a particle of `size` (m) at `age` of `lifetime` (s). 0 from the moment of death on; an age
    /// below 0 counts as 0. Never more than `size` times [`RadiusLaw::puff_size`].
    pub fn radius(&self, size: f32, age: f32, lifetime: f32) -> f32 {
        let age = greater(age, 0.0);
        let worn = age / lifetime;
        let density = match &self.curve {
            None => greater(1.0 - worn, 0.0),
            Some(curve) => curve.density(worn),
        };
        self.undiminished(size, age) * density
    }

    /// What the radius (m) would be if density did not fall; `age` is not below 0.
    pub fn undiminished(&self, size: f32, age: f32) -> f32 {
        size * self.puff_size * self.growth(age)
    }

    /// The same for four particles, to the last bit.
    #[inline(always)]
    pub fn radii(&self, size: f32x4, age: f32x4, lifetime: f32x4) -> f32x4 {
        let age = positive_part(age);
        let worn = age / lifetime;
        let density = match &self.curve {
            None => positive_part(f32x4::ONE - worn),
            Some(curve) => curve.densities(worn),
        };
        let full = size * f32x4::splat(self.puff_size);
        if self.growth_time <= 0.0 {
            return full * density;
        }
        let t = smaller(age / f32x4::splat(self.growth_time), f32x4::ONE);
        full * (t * (f32x4::splat(2.0) - t)) * density
    }

    fn growth(&self, age: f32) -> f32 {
        if self.growth_time <= 0.0 {
            return 1.0;
        }
        let t = (age / self.growth_time).min(1.0);
        t * (2.0 - t)
    }
}
