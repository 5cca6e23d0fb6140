//! Attractors and orbits against their closed forms.

use std::f64::consts::{PI, TAU};

use crate::common::{STEP, alone, assert_close, place, slip, steps};

#[test]
fn within_its_core_an_attractor_is_a_spring() {
    let settings = [
        ("attractors.0.acceleration", 8.0),
        ("attractors.0.coreRadius", 2.0),
        ("attractors.0.reach", 1000.0),
        ("attractors.0.position.x", 1.0),
    ];
    let mut simulator = alone(&settings, [2.5, 0.0, 0.0], [0.0; 3]);
    // Angular frequency sqrt(8 / 2) = 2 rad/s.
    for step in 1..=600 {
        simulator.step();
        let expected = 1.0 + 1.5 * (2.0 * f64::from(step) * STEP).cos();
        let x = f64::from(place(&simulator, 0)[0]);
        assert!((x - expected).abs() < 2e-3, "step {step}: {x}, expected {expected}");
    }
}

#[test]
fn outside_its_core_an_attractor_pulls_equally_at_every_distance() {
    for acceleration in [3.0, -3.0] {
        let settings = [
            ("attractors.0.acceleration", acceleration),
            ("attractors.0.reach", 1000.0),
        ];
        let mut simulator = alone(&settings, [0.0, -4.0, 3.0], [0.0; 3]);
        steps(&mut simulator, 60);
        let [x, y, z] = place(&simulator, 0).map(f64::from);
        assert_close("distance", x.hypot(y).hypot(z), 5.0 - 0.5 * acceleration, 1e-3);
        assert_close("direction", y / z, -4.0 / 3.0, 1e-4);
    }
}

#[test]
fn an_attractor_fades_to_nothing_at_its_reach() {
    let settings = [("attractors.0.acceleration", 3.0), ("attractors.0.reach", 2.0)];
    for r in [0.5_f32, 1.0, 1.7, 2.0, 2.1] {
        let mut simulator = alone(&settings, [r, 0.0, 0.0], [0.0; 3]);
        simulator.step();
        let fade = (1.0 - f64::from(r * r) / 4.0).max(0.0).powi(2);
        let speed = f64::from(slip(&simulator, 0)[0]);
        assert!((speed + 3.0 * fade * STEP).abs() < 1e-6, "at {r}: {speed}");
    }
}

/// Minimum and maximum distance from the y axis over `turns` revolutions, and their mean period (s).
fn circled(settings: &[(&str, f64)], r: f32, speed: f32, turns: f64) -> (f64, f64, f64) {
    let mut simulator = alone(settings, [r, 0.5, 0.0], [0.0, 0.0, speed]);
    let (mut least, mut greatest, mut angle, mut before) = (f64::MAX, 0.0_f64, 0.0, 0.0);
    while angle < turns * TAU {
        simulator.step();
        let [x, _, z] = place(&simulator, 0).map(f64::from);
        let (distance, now) = (x.hypot(z), z.atan2(x));
        angle += (now - before).rem_euclid(TAU);
        before = now;
        (least, greatest) = (least.min(distance), greatest.max(distance));
        assert!(simulator.steps() < 100_000, "hardly turns");
    }
    (least, greatest, simulator.steps() as f64 * STEP * TAU / angle)
}

#[test]
fn a_circular_orbit_stays_one_for_20_turns() {
    let core = 0.02_f64;
    for (r, acceleration) in [(1.0_f64, 1.0), (1.0, 4.0), (2.0, 20.0), (0.5, 1.0)] {
        let point = [
            ("orbits.0.acceleration", acceleration),
            ("orbits.0.coreRadius", core),
            ("orbits.0.position.y", 0.5),
        ];
        let min_core = (4.0 * acceleration * STEP * STEP).cbrt().max(core);
        let speed = r * (acceleration / (r * r + min_core * min_core).powf(1.5)).sqrt();
        let (least, greatest, period) = circled(&point, r as f32, speed as f32, 20.0);
        assert!(
            least > r * 0.997 && greatest < r * 1.003,
            "point: {least} to {greatest}"
        );
        assert_close("period around a point", period, TAU * r / speed, 3e-3);

        let line = [point.as_slice(), &[("orbits.0.axis.y", 0.4)]].concat();
        let min_core = (4.0 * acceleration).sqrt() * STEP;
        let core = min_core.max(core);
        let speed = r * (acceleration / (r * r + core * core)).sqrt();
        let (least, greatest, period) = circled(&line, r as f32, speed as f32, 20.0);
        assert!(least > r * 0.997 && greatest < r * 1.003, "line: {least} to {greatest}");
        assert_close("period around a line", period, TAU * r / speed, 3e-3);
    }
}

/// Position and velocity in a plane after one fine fourth-order Runge-Kutta step about a softened mass of 1 m3/s2.
fn fine_step(state: [f64; 4], core_squared: f64, h: f64) -> [f64; 4] {
    let rate = |[x, y, u, v]: [f64; 4]| {
        let strength = (x * x + y * y + core_squared).powf(-1.5);
        [u, v, -x * strength, -y * strength]
    };
    let shifted = |by: [f64; 4], h: f64| std::array::from_fn(|i| state[i] + by[i] * h);
    let a = rate(state);
    let b = rate(shifted(a, h / 2.0));
    let c = rate(shifted(b, h / 2.0));
    let d = rate(shifted(c, h));
    std::array::from_fn(|i| state[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
}

#[test]
fn an_ellipse_keeps_its_energy_and_its_path() {
    let settings = [("orbits.0.acceleration", 1.0), ("orbits.0.coreRadius", 0.2)];
    let core_squared = 0.04;
    let mut simulator = alone(&settings, [1.0, 0.0, 0.0], [0.0, 0.8, 0.0]);
    let energy = |simulator: &sim::Simulator| {
        let [x, y, _] = place(simulator, 0).map(f64::from);
        let [u, v, _] = slip(simulator, 0).map(f64::from);
        0.5 * (u * u + v * v) - 1.0 / (x * x + y * y + core_squared).sqrt()
    };
    let first = energy(&simulator);
    let mut exact = [1.0, 0.0, 0.0, 0.8];
    // Twenty revolutions.
    for step in 0..20 * 250 {
        simulator.step();
        let now = energy(&simulator);
        assert!((now / first - 1.0).abs() < 1e-3, "energy {now}, at first {first}");
        if step < 500 {
            exact = (0..10).fold(exact, |state, _| fine_step(state, core_squared, STEP / 10.0));
            let [x, y, _] = place(&simulator, 0).map(f64::from);
            let off = (x - exact[0]).hypot(y - exact[1]);
            assert!(off < 5e-3, "step {step}: {off} m beside the true path");
        }
    }
}

#[test]
fn a_line_pulls_towards_itself_only() {
    let settings = [
        ("orbits.0.acceleration", 2.0),
        ("orbits.0.coreRadius", 0.3),
        ("orbits.0.axis.x", 1.0),
        ("orbits.0.axis.y", 1.0),
    ];
    let mut simulator = alone(&settings, [7.0, 7.0, 0.4], [0.0; 3]);
    simulator.step();
    let [x, y, z] = slip(&simulator, 0).map(f64::from);
    assert!(x.abs() < 1e-6 && y.abs() < 1e-6, "pulled along the line: {x}, {y}");
    assert_close("pull", z, -2.0 * 0.4 / (0.16 + 0.09) * STEP, 1e-4);
}

#[test]
fn smoke_at_rest_falls_through_the_softened_point_and_comes_back() {
    let settings = [("orbits.0.acceleration", 1.0), ("orbits.0.coreRadius", 1.0)];
    // Small swings in a core of 1 m: angular frequency sqrt(mu / s^3) = 1 rad/s.
    let mut simulator = alone(&settings, [0.02, 0.0, 0.0], [0.0; 3]);
    steps(&mut simulator, (2.0 * PI / STEP).round() as usize);
    assert_close("after a period", f64::from(place(&simulator, 0)[0]), 0.02, 2e-3);
}
