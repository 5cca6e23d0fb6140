//! Spirals and jets against their closed forms.

use crate::common::{STEP, alone, assert_close, place, simulator, steps};

const WIDE: (&str, f64) = ("spirals.0.reach", 1000.0);

#[test]
fn a_spiral_turns_draws_in_and_rises_at_constant_speeds() {
    let settings = [
        WIDE,
        ("spirals.0.turn", 3.0),
        ("spirals.0.inward", 0.5),
        ("spirals.0.along", 0.25),
        ("spirals.0.position.x", 1.0),
    ];
    let mut simulator = alone(&settings, [4.0, 0.0, 0.0], [0.0; 3]);
    for step in 1..=300 {
        simulator.step();
        let t = f64::from(step) * STEP;
        let [x, y, z] = place(&simulator, 0).map(f64::from);
        let (r, angle) = (3.0 - 0.5 * t, 3.0 * t);
        // Counter-clockwise seen against y: from x towards -z.
        let off = (x - 1.0 - r * angle.cos()).hypot(z + r * angle.sin());
        // The first step of a new particle has no previous displacement, which costs half of the squared rotation.
        assert!(off < 0.006 * r, "{off} m off after {t} s");
        assert!((y - 0.25 * t).abs() < 1e-4, "height {y} after {t} s");
    }
}

#[test]
fn a_spiral_without_inflow_keeps_the_distance_over_20_turns() {
    for turn in [-1.0, 2.0, 8.0, 30.0, 50.0] {
        let mut simulator = alone(&[WIDE, ("spirals.0.turn", turn)], [0.0, 1.0, 2.0], [0.0; 3]);
        let distance = |simulator: &sim::Simulator| {
            let [x, _, z] = place(simulator, 0).map(f64::from);
            x.hypot(z)
        };
        steps(&mut simulator, 30);
        let first = distance(&simulator);
        steps(
            &mut simulator,
            (20.0 * std::f64::consts::TAU / f64::abs(turn) / STEP) as usize,
        );
        assert_close("distance", distance(&simulator), first, 1e-3);
    }
}

#[test]
fn the_angle_of_a_spiral_is_right_at_every_turn() {
    for (turn, tolerance) in [(1.0, 2e-4), (8.0, 2e-4), (50.0, 2e-3)] {
        let mut simulator = alone(&[WIDE, ("spirals.0.turn", turn)], [2.0, 0.0, 0.0], [0.0; 3]);
        let (mut angle, mut before) = (0.0, 0.0);
        // The first step is straight.
        steps(&mut simulator, 1);
        for step in 0..=240 {
            let [x, _, z] = place(&simulator, 0).map(f64::from);
            let now = (-z).atan2(x);
            if step > 0 {
                angle += (now - before).rem_euclid(std::f64::consts::TAU);
            }
            before = now;
            simulator.step();
        }
        assert_close("angle", angle, turn * 240.0 * STEP, tolerance);
    }
}

#[test]
fn a_spiral_and_wind_follow_the_true_path() {
    let settings = [
        ("spirals.0.turn", 4.0),
        ("spirals.0.inward", 0.4),
        ("spirals.0.along", -0.3),
        ("spirals.0.reach", 5.0),
        ("spirals.0.axis.x", 0.5),
        ("forces.wind.x", 0.5),
        ("forces.wind.z", -0.3),
    ];
    let mut simulator = alone(&settings, [1.0, 0.2, 0.5], [0.0; 3]);
    steps(&mut simulator, 120);
    let velocity = |p: [f64; 3]| simulator.air_velocity(p.map(|c| c as f32)).map(f64::from);
    let shifted = |p: [f64; 3], v: [f64; 3], h: f64| std::array::from_fn(|i| p[i] + v[i] * h);
    let (mut p, h) = ([1.0, 0.2_f32.into(), 0.5], STEP / 10.0);
    for _ in 0..1200 {
        let half = shifted(p, velocity(p), h / 2.0);
        p = shifted(p, velocity(half), h);
    }
    let ours = place(&simulator, 0).map(f64::from);
    let off = (0..3).map(|i| (ours[i] - p[i]).powi(2)).sum::<f64>().sqrt();
    assert!(off < 0.01, "{off} m beside the true path after 2 s");
}

#[test]
fn inflow_keeps_particles_at_the_axis() {
    let settings = [
        WIDE,
        ("spirals.0.turn", 5.0),
        ("spirals.0.inward", 20.0),
        ("spirals.0.coreRadius", 0.01),
    ];
    let mut simulator = alone(&settings, [1.0, 0.0, 0.0], [0.0; 3]);
    steps(&mut simulator, 60);
    for _ in 0..60 {
        simulator.step();
        let [x, _, z] = place(&simulator, 0);
        assert!(x.hypot(z) < 1e-3, "thrown across the axis to {x}, {z}");
    }
}

#[test]
fn a_spiral_fades_and_slows_within_its_core() {
    let settings = [
        ("spirals.0.turn", 2.0),
        ("spirals.0.inward", 0.6),
        ("spirals.0.along", 0.3),
        ("spirals.0.coreRadius", 0.5),
        ("spirals.0.reach", 2.0),
        ("spirals.0.axis.y", 0.0),
        ("spirals.0.axis.z", 1.0),
    ];
    let simulator = simulator(1, 1, &[crate::common::STILL, &settings]);
    for r in [0.0_f64, 0.1, 0.5, 1.0, 1.9, 2.0, 3.0] {
        let fade = (1.0 - r * r / 4.0).max(0.0).powi(2);
        let expected = [-0.6 * fade * (r / 0.5).min(1.0), 2.0 * r * fade, 0.3 * fade];
        let velocity = simulator.air_velocity([r as f32, 0.0, 9.0]).map(f64::from);
        for (ours, expected) in velocity.iter().zip(expected) {
            assert!((ours - expected).abs() < 1e-5, "at {r}: {velocity:?}");
        }
    }
}
