//! Regions, envelopes and lists in a simulator.

use crate::common::{STEP, STILL, alone, assert_close, newborn, place, simulator, slip, steps};

/// Slip of a particle at rest at `position` after one second.
fn pushed(settings: &[(&str, f64)], position: [f32; 3]) -> [f64; 3] {
    let mut simulator = alone(settings, position, [0.0; 3]);
    steps(&mut simulator, 60);
    slip(&simulator, 0).map(f64::from)
}

#[test]
fn gravities_add_up_each_in_its_region() {
    let settings = [
        ("gravities.0.acceleration.x", 0.5),
        ("gravities.1.acceleration.y", -0.25),
        ("gravities.1.region.shape", 2.0),
        ("gravities.1.region.position.x", 10.0),
        ("gravities.1.region.size.x", 3.0),
        ("forces.gravity", 2.0),
    ];
    assert_eq!(pushed(&settings, [0.0; 3])[1], 0.0);
    assert_close("x", pushed(&settings, [0.0; 3])[0], 1.0, 1e-5);
    let [x, y, z] = pushed(&settings, [10.0, 0.0, 0.0]);
    assert_close("x inside", x, 1.0, 1e-5);
    assert_close("y inside", y, -0.5, 1e-5);
    assert_eq!(z, 0.0);
}

#[test]
fn the_edge_of_a_region_weakens_smoothly() {
    // At the middle of a soft edge of 2 m outside a radius of 1 m the pull is one half. The particle hardly moves.
    for (distance, weight) in [
        (0.9_f32, 1.0),
        (1.5, 0.843_75),
        (2.0, 0.5),
        (2.5, 0.156_25),
        (3.001, 0.0),
    ] {
        let settings = [
            ("gravities.0.acceleration.x", 0.01),
            ("gravities.0.region.shape", 1.0),
            ("gravities.0.region.softness", 2.0),
        ];
        let speed = pushed(&settings, [0.0, distance, 0.0])[0];
        assert!((speed - 0.01 * weight).abs() < 2e-5, "{distance} m: {speed}");
    }
}

#[test]
fn buoyancies_lift_warm_smoke() {
    let settings = [
        ("buoyancies.0.acceleration", 2.0),
        ("buoyancies.1.acceleration", -0.5),
        ("buoyancy.coolingTime", 3.0),
        ("forces.buoyancy", 2.0),
    ];
    // The temperature is exp(-t / 3): its integral over a second.
    let expected = 3.0 * 3.0 * (1.0 - f64::exp(-1.0 / 3.0));
    let [x, y, _] = pushed(&settings, [0.0; 3]);
    assert_eq!(x, 0.0);
    assert_close("speed", y, expected, 6e-3);
}

#[test]
fn drags_add_up_and_a_region_can_be_thick_air() {
    let decay = |settings: &[(&str, f64)]| {
        let mut simulator = alone(settings, [0.0; 3], [0.0, 0.0, 1.0]);
        steps(&mut simulator, 60);
        f64::from(slip(&simulator, 0)[2])
    };
    let two = [("drags.0.rate", 0.5), ("drags.1.rate", 0.25), ("drag.rate", 0.25)];
    assert_close("three drags", decay(&two), f64::exp(-1.0), 1e-5);
    let fixed = [("forces.drag", 2.0)];
    assert_close(
        "doubled",
        decay(&[two.as_slice(), &fixed].concat()),
        f64::exp(-2.0),
        1e-5,
    );
    let elsewhere = [
        ("drags.0.rate", 5.0),
        ("drags.0.region.shape", 1.0),
        ("drags.0.region.position.x", 9.0),
    ];
    assert_eq!(decay(&elsewhere), 1.0);
}

#[test]
fn an_envelope_switches_a_force_on_off_and_on_again() {
    let settings = [
        ("gravities.0.acceleration.y", 6.0),
        ("gravities.0.envelope.start", 0.5),
        ("gravities.0.envelope.duration", 0.25),
        ("gravities.0.envelope.period", 1.0),
    ];
    let mut simulator = alone(&settings, [0.0; 3], [0.0; 3]);
    for step in 1..=240_u32 {
        simulator.step();
        let time = f64::from(step) * STEP;
        let whole = (time - 0.5).max(0.0).floor();
        let on = whole * 0.25 + (time - 0.5 - whole).clamp(0.0, 0.25);
        let speed = f64::from(slip(&simulator, 0)[1]);
        assert!((speed - 6.0 * on).abs() < 6.0 * STEP * 0.51, "{speed} after {time} s");
    }
}

#[test]
fn a_fading_envelope_gives_the_momentum_of_its_area() {
    let settings = [
        ("gravities.0.acceleration.y", 2.0),
        ("gravities.0.envelope.start", 0.1),
        ("gravities.0.envelope.duration", 0.8),
        ("gravities.0.envelope.fade", 0.3),
    ];
    // Each of the two ramps has half of its length as area.
    assert_close("speed", pushed(&settings, [0.0; 3])[1], 2.0 * 0.5, 2e-3);
}

#[test]
fn a_wind_that_fades_in_displaces_smoke_by_its_integral() {
    let settings = [("winds.0.velocity.x", 3.0), ("winds.0.envelope.fade", 1.0)];
    let mut simulator = alone(&settings, [0.0; 3], [0.0; 3]);
    steps(&mut simulator, 120);
    assert_close("way", f64::from(place(&simulator, 0)[0]), 3.0 * 1.5, 1e-3);
}

#[test]
fn smoke_outside_a_region_is_bit_exact() {
    let settings = [
        ("winds.0.velocity.x", 3.0),
        ("winds.0.region.shape", 3.0),
        ("winds.0.region.size.x", 0.5),
        ("winds.0.region.size.y", 2.0),
        ("winds.0.region.softness", 0.2),
    ];
    let mut simulator = simulator(2, 1, &[STILL, &settings]);
    simulator.add(&newborn([0.9, 0.0, 0.0]));
    simulator.add(&newborn([0.0, 2.6, 0.0]));
    steps(&mut simulator, 20);
    assert_eq!(place(&simulator, 0), [0.9, 0.0, 0.0]);
    assert!(place(&simulator, 1)[0] > 0.0);
}
