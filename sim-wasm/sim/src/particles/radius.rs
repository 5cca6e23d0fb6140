//! The radius of a particle over its life.
//!
//! radius(age) = size * puff.size * growth(age) * density(age / lifetime), exactly 0 at birth and at death. growth(age)
//! is t (2 - t) for t = age / growthTime up to 1. Growth is steepest at birth, so that smoke leaves a nozzle as a stem
//! instead of a string of specks. Growth times below [`MIN_GROWTH_TIME`] are raised to it, except for the integrator
//! `paper`, where 0 means growth 1. density(t) is 1 - t, the linear law of the paper, or the curve of `density.#`. With
//! `emission.dissolve` `erode` or `tear`, a puff keeps its radius and is eroded instead, until the density is [`ERODED_DENSITY`]; the
//! factor is then density / [`ERODED_DENSITY`]. A look replaces growthTime, which is at most a quarter of its lifetime,
//! density and dissolve, and may have a curve of size over life as another factor.
//!
//! The radius never jumps: within a step of h seconds it changes by at most size * puff.size * h * (2 / growthTime +
//! slope / lifetime), the first term only for growthTime above 0. The slope is 1 for the linear law and the steepest
//! slope of a curve otherwise, at most 50, and 1 / [`ERODED_DENSITY`] times as much for eroded puffs. The slope of a curve
//! of size adds to it. Entrainment adds puff.size * entrainment * |slip| * h.

use wide::f32x4;

use crate::layout::limits::MAX_STRETCH;
use crate::layout::parameters::emitter::Look;
use crate::layout::parameters::settings::{Dissolve, Integrator};
use crate::layout::parameters::table::Parameters;
use crate::math::scalar::{greater, lesser};
use crate::math::simd::{positive_part, smaller};
use crate::particles::density::{Curve, unpacked};

/// Minimum growth time (s), so that no particle appears at full size from one step to the next. Does not apply to the
/// integrator `paper`, which keeps the law of the paper.
pub const MIN_GROWTH_TIME: f32 = 0.1;

/// Density from which an eroded puff shrinks, so that its last piece vanishes without a jump.
pub const ERODED_DENSITY: f32 = 0.25;
/// Density at which a puff begins to dissolve; this is complete at [`ERODED_DENSITY`].
pub const DISSOLVING_DENSITY: f32 = 0.75;

/// Ratio of the axes of a torn puff at its end. A puff that thins ends with [`MAX_STRETCH`].
const TORN_STRETCH: f32 = 2.4;
/// Maximum growth time of a look with a lifetime, as a share of it.
pub const GROWING_SHARE: f32 = 0.25;

/// The radius of a particle as a function of size and age.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusLaw {
    /// Factor on every radius, `puff.size`.
    pub puff_size: f32,
    /// Time until a particle has its full size (s); 0: full at birth.
    pub growth_time: f32,
    /// Density over life; none: linear.
    curve: Option<Curve>,
    /// Factor on the size over life; none: 1.
    size: Option<Curve>,
    /// Ratio of the axes of a puff at its end; 1 if puffs keep their stretch.
    pub strand: f32,
    /// Whether puffs do more than shrink as their density falls.
    dissolves: bool,
    /// Factor on the density, which is at most 1 after it; more than 1 if puffs are eroded before they shrink.
    gain: f32,
}

impl RadiusLaw {
    /// The law that `parameters` set.
    pub fn new(parameters: &Parameters) -> Self {
        Self::of_look(parameters, &Look::NONE)
    }

    /// The law of a look.
    pub fn of_look(parameters: &Parameters, look: &Look) -> Self {
        let or = |own: f64, common: f64| if own > 0.0 { own } else { common };
        let growth_time = or(look.growth_time, parameters.emission.growth_time) as f32;
        let dissolve = Dissolve::from_parameter(or(look.dissolve, parameters.emission.dissolve + 1.0) - 1.0);
        let [(densities, own_stops), (sizes, size_stops)] = [&look.density_curve, &look.size_curve].map(unpacked);
        let is_paper = Integrator::from_parameter(parameters.simulation.integrator) == Integrator::Paper;
        let growth_time = if is_paper {
            growth_time
        } else {
            growth_time.max(MIN_GROWTH_TIME)
        };
        Self {
            puff_size: parameters.puff.size as f32,
            growth_time: if look.lifetime > 0.0 {
                growth_time.min(look.lifetime as f32 * GROWING_SHARE)
            } else {
                growth_time
            },
            curve: Curve::new(if own_stops == 0 {
                parameters.density.items()
            } else {
                &densities[..own_stops]
            }),
            size: Curve::through(&sizes[..size_stops]),
            strand: match dissolve {
                Dissolve::Shrink | Dissolve::Erode => 1.0,
                Dissolve::Tear => TORN_STRETCH,
                Dissolve::Thin => MAX_STRETCH,
            },
            dissolves: dissolve != Dissolve::Shrink,
            gain: if dissolve.erodes() { 1.0 / ERODED_DENSITY } else { 1.0 },
        }
    }

    /// The linear law of the paper, with growth.
    pub const fn linear(puff_size: f32, growth_time: f32) -> Self {
        Self {
            puff_size,
            growth_time,
            curve: None,
            size: None,
            strand: 1.0,
            dissolves: false,
            gain: 1.0,
        }
    }

    /// Radius (m) of a particle of `size` (m) at `age` of `lifetime` (s), at most `size` times
    /// [`RadiusLaw::puff_size`]. 0 from death on. A negative age counts as 0.
    pub fn radius(&self, size: f32, age: f32, lifetime: f32) -> f32 {
        let age = greater(age, 0.0);
        let share = lesser(self.density(age / lifetime) * self.gain, 1.0);
        self.undiminished(size, age, lifetime) * share
    }

    /// Whether puffs are eroded before they shrink.
    pub fn erodes(&self) -> bool {
        self.gain > 1.0
    }

    /// Erosion of a particle by its [`RadiusLaw::dissolution`]; 0 if puffs only shrink.
    pub fn erosion(&self, dissolution: f32) -> f32 {
        if self.erodes() { dissolution } else { 0.0 }
    }

    /// How far a particle is dissolved at `age` of `lifetime` (s); this has not begun up to 0 and is complete from 1 on.
    /// 0 if puffs only shrink.
    pub fn dissolution(&self, age: f32, lifetime: f32) -> f32 {
        if !self.dissolves {
            return 0.0;
        }
        let lost = DISSOLVING_DENSITY - self.density(greater(age, 0.0) / lifetime);
        lost / (DISSOLVING_DENSITY - ERODED_DENSITY)
    }

    // Inlined twice, the curve would take more space.
    #[inline(never)]
    fn density(&self, worn: f32) -> f32 {
        match &self.curve {
            None => greater(1.0 - worn, 0.0),
            Some(curve) => curve.density(worn),
        }
    }

    /// Radius (m) at density 1; `age` is 0 or more.
    #[inline(always)]
    pub fn undiminished(&self, size: f32, age: f32, lifetime: f32) -> f32 {
        let full = size * self.puff_size * self.growth(age);
        match &self.size {
            None => full,
            Some(curve) => full * curve.value(age / lifetime),
        }
    }

    /// Same for four particles, bit for bit.
    #[inline(always)]
    pub fn radii(&self, size: f32x4, age: f32x4, lifetime: f32x4) -> f32x4 {
        let age = positive_part(age);
        let worn = age / lifetime;
        let density = match &self.curve {
            None => positive_part(f32x4::ONE - worn),
            Some(curve) => curve.densities(worn),
        };
        let density = smaller(density * f32x4::splat(self.gain), f32x4::ONE);
        let mut full = size * f32x4::splat(self.puff_size);
        if self.growth_time > 0.0 {
            let t = smaller(age / f32x4::splat(self.growth_time), f32x4::ONE);
            full *= t * (f32x4::splat(2.0) - t);
        }
        if let Some(curve) = &self.size {
            full *= curve.values(worn);
        }
        full * density
    }

    fn growth(&self, age: f32) -> f32 {
        if self.growth_time <= 0.0 {
            return 1.0;
        }
        let t = (age / self.growth_time).min(1.0);
        t * (2.0 - t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(stops: &[[f64; 2]], growth_time: f64, integrator: f64, dissolve: f64) -> RadiusLaw {
        let mut parameters = Parameters::default();
        let mut set = |key: &str, value| parameters.set(key, value).expect("a test's values are in range");
        for (index, [age, value]) in stops.iter().enumerate() {
            set(&format!("density.{index}.age"), *age);
            set(&format!("density.{index}.value"), *value);
        }
        set("puff.size", 1.3);
        set("emission.growthTime", growth_time);
        set("simulation.integrator", integrator);
        set("emission.dissolve", dissolve);
        RadiusLaw::new(&parameters)
    }

    #[test]
    fn lanes_and_single_particles_have_the_same_radius() {
        let curves: [&[[f64; 2]]; 4] = [
            &[],
            &[[0.3, 0.6]],
            &[[0.7, 0.1], [0.1, 0.33], [0.4, 1.0]],
            &[
                [0.0, 0.0],
                [0.0, 1.0],
                [0.2, 0.3],
                [0.2, 0.7],
                [0.5, 0.0],
                [0.6, 0.1],
                [0.9, 1.0],
                [1.0, 1.0],
            ],
        ];
        for (stops, (growth_time, integrator, dissolve)) in curves
            .iter()
            .flat_map(|curve| [(0.0, 1.0, 0.0), (0.7, 0.0, 0.0), (0.7, 0.0, 1.0)].map(|rest| (curve, rest)))
        {
            let law = law(stops, growth_time, integrator, dissolve);
            for step in -5..300 {
                let age = step as f32 / 60.0;
                let lanes = law.radii(f32x4::splat(0.4), f32x4::splat(age), f32x4::splat(3.1));
                assert_eq!(
                    lanes.to_array()[3].to_bits(),
                    law.radius(0.4, age, 3.1).to_bits(),
                    "at {age}"
                );
            }
            assert_eq!(law.radius(0.4, 3.1, 3.1), 0.0);
        }
    }
}
