//! Drag between smoke and air.
//!
//! s' = a - k s for the slip s, with k = m (`rate` + `quadratic` |s|) and m = `forces.drag`. For an acceleration a and
//! a rate k that are constant over the step h the solution is exact and stable for every k, zero included:
//!
//! s(h) = e s + p a,  displacement = p s + q a,  with e = exp(-k h), p = (1 - e) / k, q = (h - p) / k.
//!
//! The terminal velocity is a / k; with quadratic drag it solves m (r + c s) s = a. Without drag p = h and q = h^2 / 2:
//! a parabola. `drag.rate` (1/s) and `drag.quadratic` (1/m) act everywhere, `drags.#.*` add to them in their regions.

use wide::f32x4;

use crate::forces::force::{Force, ForceContext, Phase};
use crate::layout::parameters::forces::drag::Drag;
use crate::layout::parameters::table::Parameters;
use crate::layout::scope::Reach;
use crate::math::simd::exp_minus;
use crate::particles::tile::{Columns, Tile};

/// A drag in one step.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    rate: f32x4,
    quadratic: f32x4,
    reach: Reach,
}

impl Force for Drag {
    type Kernel = Kernel;
    const PHASE: Phase = Phase::Push;

    fn kernel(&self, _index: usize, context: &ForceContext) -> Option<Kernel> {
        let reach = Reach::new(&self.scope, &context.now)?;
        Kernel::new(self.rate, self.quadratic, reach, context.parameters)
    }

    /// Only the quadratic part: the linear part is the same for all particles, see [`Factors::new`].
    fn everywhere(context: &ForceContext) -> Option<Kernel> {
        Kernel::new(
            0.0,
            context.parameters.drag.quadratic,
            Reach::everywhere(),
            context.parameters,
        )
    }

    fn act(kernels: &[Kernel], tile: &mut Tile) {
        tile.is_dragged = true;
        let Columns {
            ahead,
            slip,
            resistance,
            weight,
            ..
        } = tile.columns();
        for kernel in kernels {
            kernel.reach.weigh(ahead, weight);
            for ((resistance, slip), weight) in resistance.iter_mut().zip(&*slip).zip(&*weight) {
                *resistance += (kernel.rate + kernel.quadratic * slip.dot(*slip).sqrt()) * *weight;
            }
        }
    }
}

impl Kernel {
    fn new(rate: f64, quadratic: f64, reach: Reach, parameters: &Parameters) -> Option<Self> {
        let [rate, quadratic] = [rate, quadratic].map(|value| (value * parameters.forces.drag) as f32);
        (rate > 0.0 || quadratic > 0.0).then(|| Self {
            rate: f32x4::splat(rate),
            quadratic: f32x4::splat(quadratic),
            reach,
        })
    }
}

/// The factors of a step under drag.
#[derive(Clone, Copy, Debug)]
pub struct Factors {
    /// Share of the slip after the step.
    pub kept: f32x4,
    /// Slip to displacement, and acceleration to slip (s).
    pub first: f32x4,
    /// Acceleration to displacement (s2).
    pub second: f32x4,
}

impl Factors {
    /// Factors of a step of `dt` seconds at a rate of drag (1/s).
    pub fn new(rate: f64, dt: f64) -> Self {
        let [kept, first, second] = factors(rate, dt).map(|value| f32x4::splat(value as f32));
        Self { kept, first, second }
    }

    /// Factors of four particles with individual rates of drag (1/s).
    #[inline(always)]
    pub fn of_rates(rates: f32x4, dt: f32) -> Self {
        let dt = f32x4::splat(dt);
        let x = rates * dt;
        // Below 0.5 the closed forms lose digits. The omitted terms of the series are below 1e-7 there.
        let is_small = x.simd_lt(f32x4::HALF);
        let divisor = is_small.select(f32x4::ONE, x);
        let kept = exp_minus(x);
        let first = is_small.select(series(x, 1.0), (f32x4::ONE - kept) / divisor);
        let second = is_small.select(series(x, 2.0), (f32x4::ONE - first) / divisor);
        Self {
            kept,
            first: first * dt,
            second: second * dt * dt,
        }
    }
}

/// The sum of (-x)^n k! / (n + k)! divided by k!: (1 - exp(-x)) / x for k = 1, one integral further for k = 2.
#[inline(always)]
fn series(x: f32x4, k: f32) -> f32x4 {
    const TERMS: u8 = 7;
    let nested = (1..TERMS).rev().fold(f32x4::ONE, |sum, n| {
        f32x4::ONE - x * f32x4::splat(1.0 / (f32::from(n) + k)) * sum
    });
    nested * f32x4::splat(1.0 / k)
}

/// Global rate of drag (1/s).
pub fn rate(parameters: &Parameters) -> f64 {
    parameters.drag.rate * parameters.forces.drag
}

/// The numbers of [`Factors`] of a step of `dt` seconds at a rate of drag (1/s).
pub(crate) fn factors(rate: f64, dt: f64) -> [f64; 3] {
    let x = rate * dt;
    if x < 1e-3 {
        // The closed forms lose digits here. The omitted terms of the series are below 1e-13.
        let first = dt * (1.0 - x / 2.0 + x * x / 6.0 - x * x * x / 24.0);
        let second = dt * dt * (0.5 - x / 6.0 + x * x / 24.0 - x * x * x / 120.0);
        return [libm::exp(-x), first, second];
    }
    let first = -libm::expm1(-x) / rate;
    [libm::exp(-x), first, (dt - first) / rate]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_form_meet() {
        let dt = 1.0 / 60.0;
        let below = factors(0.999_999e-3 / dt, dt);
        let above = factors(1.000_001e-3 / dt, dt);
        for (a, b) in below.iter().zip(above) {
            assert!((a / b - 1.0).abs() < 1e-8, "{below:?} and {above:?}");
        }
        assert_eq!(factors(0.0, dt), [1.0, dt, dt * dt * 0.5]);
    }

    #[test]
    fn lanes_agree_with_the_exact_factors() {
        let dt = 1.0 / 60.0;
        for rate in [0.0, 0.01, 1.0, 5.9, 6.1, 30.0, 1000.0, 60_000.0] {
            let exact = factors(rate, dt);
            let lanes = Factors::of_rates(f32x4::splat(rate as f32), dt as f32);
            for (lane, exact) in [lanes.kept, lanes.first, lanes.second].iter().zip(exact) {
                let lane = f64::from(lane.to_array()[1]);
                assert!(
                    (lane - exact).abs() <= 2e-6 * exact + 1e-30,
                    "rate {rate}: {lane}, not {exact}"
                );
            }
        }
    }
}
