//! Envelopes: the level of an effect over time.
//!
//! On from `start` for `duration` (0: for ever), and again every `period` (0: once). Within `fade` seconds of either
//! end the level follows the smoothstep 3 s^2 - 2 s^3. If the fades overlap, their levels are multiplied.

use crate::layout::parameters::item::Scope;

/// Minimum period (s).
const MIN_PERIOD: f64 = 0.001;

/// Level at `time` (s), 0..=1.
pub fn level(scope: &Scope, time: f64) -> f64 {
    let Some(since) = since_start(scope, time) else {
        return 0.0;
    };
    let rise = ramp(since, scope.fade);
    if scope.duration <= 0.0 {
        return rise;
    }
    rise * ramp(scope.duration - since, scope.fade)
}

/// Seconds since the latest start; none before the first.
pub fn since_start(scope: &Scope, time: f64) -> Option<f64> {
    let since = time - scope.start;
    if since < 0.0 {
        return None;
    }
    if scope.period <= 0.0 {
        return Some(since);
    }
    let period = scope.period.max(MIN_PERIOD);
    Some(since - libm::floor(since / period) * period)
}

/// Number of starts up to `time` (s).
pub fn starts_until(scope: &Scope, time: f64) -> u64 {
    let since = time - scope.start;
    if since < 0.0 {
        return 0;
    }
    if scope.period <= 0.0 {
        return 1;
    }
    libm::floor(since / scope.period.max(MIN_PERIOD)) as u64 + 1
}

fn ramp(seconds: f64, fade: f64) -> f64 {
    if seconds <= 0.0 {
        return 0.0;
    }
    if seconds >= fade {
        return 1.0;
    }
    let share = seconds / fade;
    share * share * (3.0 - 2.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scope(start: f64, duration: f64, period: f64, fade: f64) -> Scope {
        Scope {
            start,
            duration,
            period,
            fade,
            ..Scope::default()
        }
    }

    #[test]
    fn the_default_is_always_on() {
        for time in [0.001, 1.0, 1e6] {
            assert_eq!(level(&Scope::default(), time), 1.0);
        }
    }

    #[test]
    fn starts_once_or_repeatedly() {
        let once = scope(1.0, 0.5, 0.0, 0.0);
        let often = scope(1.0, 0.5, 2.0, 0.0);
        for (time, first, again) in [
            (0.9, 0.0, 0.0),
            (1.2, 1.0, 1.0),
            (1.6, 0.0, 0.0),
            (3.2, 0.0, 1.0),
            (7.6, 0.0, 0.0),
        ] {
            assert_eq!((level(&once, time), level(&often, time)), (first, again), "at {time}");
        }
        assert_eq!(
            [0.9, 1.0, 2.9, 3.0].map(|time| starts_until(&often, time)),
            [0, 1, 1, 2]
        );
    }

    #[test]
    fn fades_are_smooth_and_halfway_in_the_middle() {
        let fading = scope(0.0, 4.0, 0.0, 1.0);
        for (time, expected) in [(0.5, 0.5), (0.25, 0.15625), (2.0, 1.0), (3.5, 0.5), (4.0, 0.0)] {
            assert!((level(&fading, time) - expected).abs() < 1e-12, "at {time}");
        }
    }
}
