//! Jets against their profile and their momentum.

use crate::common::{STILL, alone, assert_close, place, simulator, steps};
use sim::Simulator;

const SPEED: f64 = 10.0;
const RADIUS: f64 = 0.05;
const SPREAD: f64 = 0.113;
const REACH: f64 = 1000.0;

fn jet() -> Simulator {
    let settings = [
        ("jets.0.speed", SPEED),
        ("jets.0.radius", RADIUS),
        ("jets.0.spread", SPREAD),
        ("jets.0.reach", REACH),
        ("jets.0.position.y", 1.0),
        ("jets.0.direction.x", 1.0),
        ("jets.0.direction.y", 0.0),
    ];
    simulator(1, 1, &[STILL, &settings])
}

/// Speed along the jet at the distance `z` from the nozzle and `r` from the axis.
fn speed(simulator: &Simulator, z: f64, r: f64) -> f64 {
    let [x, y, across] = simulator.air_velocity([z as f32, 1.0 - 0.6 * r as f32, 0.8 * r as f32]);
    assert_eq!([y, across], [0.0, 0.0], "blows across");
    f64::from(x)
}

#[test]
fn far_from_the_nozzle_the_profile_is_the_self_similar_one() {
    let simulator = jet();
    for z in [0.7, 1.0, 3.0, 10.0, 40.0] {
        let middle = SPEED * 2.0_f64.sqrt() * RADIUS / (SPREAD * z);
        for share in [0.0, 0.3, 1.0, 2.0] {
            let fade = (1.0 - z * z / REACH / REACH).powi(2);
            let expected = middle * f64::exp(-share * share) * fade;
            assert_close(
                &format!("at {z} m, {share} widths off"),
                speed(&simulator, z, share * SPREAD * z),
                expected,
                1e-3,
            );
        }
    }
}

#[test]
fn measured_jets_have_the_same_speed_and_width() {
    let simulator = jet();
    let diameters = 40.0;
    let z = diameters * 2.0 * RADIUS;
    let middle = speed(&simulator, z, 0.0);
    // Pope, "Turbulent Flows", table 5.1: decay constant 5.8 to 6.1, half the speed at 0.094 to 0.102 z.
    let decay = middle / SPEED * diameters;
    assert!((5.7..6.4).contains(&decay), "decay constant {decay}");
    assert_close("half width", speed(&simulator, z, 0.094 * z), middle / 2.0, 0.01);
}

#[test]
fn near_the_nozzle_there_is_a_core_of_full_speed() {
    let simulator = jet();
    for z in [0.001, 0.1, 0.3, 0.6] {
        assert_close("on the axis", speed(&simulator, z, 0.0), SPEED, 1e-4);
    }
    assert!(speed(&simulator, 0.7, 0.0) < 0.95 * SPEED, "the core has no end");
    assert!(
        speed(&simulator, 0.001, 1.4 * RADIUS) < 0.01 * SPEED,
        "wider than the nozzle"
    );
    assert_eq!(speed(&simulator, -RADIUS * 1.001, 0.0), 0.0, "blows backwards");
}

#[test]
fn the_momentum_is_the_same_in_every_section() {
    let simulator = jet();
    let nozzle = SPEED * SPEED * RADIUS * RADIUS / 2.0;
    for z in [0.02, 0.1, 0.2, 0.4, 0.6, 0.7, 1.0, 2.0, 5.0] {
        let width = (SPREAD * z).max(0.005) + RADIUS;
        let dr = width / 2000.0;
        let flux: f64 = (0..10_000)
            .map(|i| (f64::from(i) + 0.5) * dr)
            .map(|r| speed(&simulator, z, r).powi(2) * r * dr)
            .sum();
        assert_close(&format!("momentum at {z} m"), flux, nozzle, 1e-3);
    }
}

#[test]
fn smoke_in_the_core_moves_with_the_jet() {
    let settings = [("jets.0.speed", 2.0), ("jets.0.radius", 0.5), ("jets.0.reach", 1000.0)];
    let mut simulator = alone(&settings, [0.1, 0.0, 0.0], [0.0; 3]);
    steps(&mut simulator, 60);
    let [x, y, _] = place(&simulator, 0).map(f64::from);
    assert_close("way", y, 2.0, 1e-4);
    assert_eq!(x, f64::from(0.1_f32));
}

#[test]
fn a_jet_ends_at_its_reach() {
    let settings = [("jets.0.speed", 2.0), ("jets.0.radius", 0.5), ("jets.0.reach", 4.0)];
    let simulator = simulator(1, 1, &[STILL, &settings]);
    for z in [0.0_f64, 1.0, 3.0, 4.0, 5.0] {
        let expected = 2.0 * (1.0 - z * z / 16.0).max(0.0).powi(2);
        let ours = f64::from(simulator.air_velocity([0.0, z as f32, 0.0])[1]);
        assert!((ours - expected).abs() < 1e-5, "at {z}: {ours}, expected {expected}");
    }
}
