//! Drag: the air takes smoke along.
//!
//! s' = a - k s for the slip s, with k = `drag.rate` (1/s) times `forces.drag`. Under an acceleration a that is
//! constant over the step h the solution is exact and stable for every k, zero included:
//!
//! s(h) = e s + p a,  displacement = p s + q a,  with e = exp(-k h), p = (1 - e) / k, q = (h - p) / k.
//!
//! Terminal velocity a / k; without drag p = h and q = h^2 / 2, which is the parabola.

use wide::f32x4;

use crate::parameters::Parameters;

/// The three factors of a step, the same for all particles.
#[derive(Clone, Copy, Debug)]
pub struct Drag {
    /// Share of the slip that is left after the step.
    pub kept: f32x4,
    /// Seconds: slip to displacement, and acceleration to slip.
    pub first: f32x4,
    /// Seconds squared: acceleration to displacement.
    pub second: f32x4,
    /// Share of the difference to the air that the explicit Euler step removes, k h; at most 1, where Euler would
    /// begin to swing, so that the integrator `paper` is stable too.
    pub euler: f32x4,
}

impl Drag {
    /// The factors for steps of `dt` seconds.
    pub fn new(parameters: &Parameters, dt: f64) -> Self {
        let rate = parameters.drag_rate * parameters.forces.drag;
        let [kept, first, second] = factors(rate, dt);
        let splat = |value: f64| f32x4::splat(value as f32);
        Self {
            kept: splat(kept),
            first: splat(first),
            second: splat(second),
            euler: splat((rate * dt).min(1.0)),
        }
    }
}

fn factors(rate: f64, dt: f64) -> [f64; 3] {
    let x = rate * dt;
    if x < 1e-3 {
        // The closed forms lose their digits here; the next terms of the series are below 1e-13.
        let first = dt * (1.0 - x / 2.0 + x * x / 6.0 - x * x * x / 24.0);
        let second = dt * dt * (0.5 - x / 6.0 + x * x / 24.0 - x * x * x / 120.0);
        return [libm::exp(-x), first, second];
    }
    let first = -libm::expm1(-x) / rate;
    [libm::exp(-x), first, (dt - first) / rate]
}

#[cfg(test)]
mod tests {
    use super::factors;

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
}
