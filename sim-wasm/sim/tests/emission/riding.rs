//! Emitters on rigids: even trails, and inherited velocity.

use std::f64::consts::TAU;

use crate::common::{STILL, place, simulator, steps};
use sim::Simulator;
use sim::rigids::{RigidDescription, RigidKind, RigidShape, pose_of};

/// A nozzle with 600 births per second that adds no speed.
const NOZZLE: &[(&str, f64)] = &[
    ("emission.rate", 600.0),
    ("emission.lifetime", 60.0),
    ("emitters.0.lifetimeVariation", 0.0),
    ("emitters.0.speed", 0.0),
    ("emitters.0.rigid", 0.0),
];

fn riding(shape: RigidShape, settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(4000, 1, &[STILL, NOZZLE, settings]);
    let pose = pose_of(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
    let description = RigidDescription::new(RigidKind::Kinematic, shape, pose);
    simulator.rigids_mut().add(description).unwrap();
    simulator
}

/// Small enough that nothing collides with it.
const SPECK: RigidShape = RigidShape::Ball { radius: 0.001 };

/// `count` steps of a rotation about y at `rate` (rad/s).
fn spin(simulator: &mut Simulator, rate: f64, count: usize) {
    for step in 1..=count {
        let (sine, cosine) = (0.5 * rate * step as f64 / 60.0).sin_cos();
        let pose = pose_of(&[0.0, 0.0, 0.0, 0.0, sine as f32, 0.0, cosine as f32]).unwrap();
        simulator.rigids_mut().move_to(0, pose).unwrap();
        simulator.step();
    }
}

/// `count` steps at `speed` (m/s) along x.
fn sweep(simulator: &mut Simulator, speed: f64, count: usize) {
    for step in 1..=count {
        let x = (speed * step as f64 / 60.0) as f32;
        let pose = pose_of(&[x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        simulator.rigids_mut().move_to(0, pose).unwrap();
        simulator.step();
    }
}

fn places(simulator: &Simulator) -> Vec<[f64; 3]> {
    (0..simulator.alive())
        .map(|i| place(simulator, i).map(f64::from))
        .collect()
}

#[test]
fn a_sweeping_nozzle_leaves_no_clusters() {
    let mut simulator = riding(SPECK, &[("emitters.0.position.y", 5.0)]);
    sweep(&mut simulator, 40.0, 60);
    let mut along: Vec<f64> = places(&simulator).iter().map(|place| place[0]).collect();
    along.sort_by(f64::total_cmp);
    assert_eq!(along.len(), 600);
    for (number, x) in along.iter().enumerate() {
        let expected = 40.0 / 600.0 * (number as f64 + 1.0);
        assert!((x - expected).abs() < 2e-5, "birth {number} at {x}, not {expected}");
    }
    assert!(places(&simulator).iter().all(|[_, y, z]| *y == 5.0 && *z == 0.0));
}

#[test]
fn a_blade_that_turns_almost_half_a_turn_in_a_step_leaves_an_even_circle() {
    let settings = [("emitters.0.position.x", 0.5), ("emission.rate", 1200.0)];
    let mut simulator = riding(SPECK, &settings);
    // 3 rad in a step.
    spin(&mut simulator, 180.0, 30);
    assert_eq!(simulator.alive(), 600);
    // In the order of birth: no particle has died.
    for (number, [x, y, z]) in places(&simulator).into_iter().enumerate() {
        assert!((x.hypot(z) - 0.5).abs() < 1e-4 && y == 0.0);
        let turned = 180.0 / 1200.0 * (number as f64 + 1.0);
        let off = ((-z).atan2(x) - turned).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 2e-3, "birth {number} is {off} rad off");
    }
}

#[test]
fn a_fraction_of_the_velocity_is_inherited() {
    for inherit in [0.0, 0.25, 1.0] {
        let mut simulator = riding(
            SPECK,
            &[("emitters.0.position.y", 5.0), ("emitters.0.inherit", inherit)],
        );
        sweep(&mut simulator, 30.0, 20);
        let particles = simulator.particles();
        for i in 0..simulator.alive() {
            assert!(
                (f64::from(particles.sx[i]) - 30.0 * inherit).abs() < 1e-3,
                "{}",
                particles.sx[i]
            );
            assert!(particles.sy[i].abs() < 1e-4 && particles.sz[i].abs() < 1e-4);
        }
    }
}

#[test]
fn spin_is_also_inherited() {
    let settings = [("emitters.0.position.x", 0.5), ("emitters.0.inherit", 1.0)];
    let mut simulator = riding(SPECK, &settings);
    spin(&mut simulator, 20.0, 10);
    // Emitted at 10 m/s along the tangent at the point of birth.
    for (number, [x, _, z]) in places(&simulator).into_iter().enumerate() {
        let turned = 20.0 / 600.0 * (number as f64 + 1.0);
        let flown = 10.0 * (10.0 / 60.0 - (number as f64 + 1.0) / 600.0);
        let expected = [
            0.5 * turned.cos() - flown * turned.sin(),
            -0.5 * turned.sin() - flown * turned.cos(),
        ];
        let off = (x - expected[0]).hypot(z - expected[1]);
        assert!(off < 2e-3, "birth {number} is {off} m off");
    }
}

#[test]
fn directions_and_places_turn_with_the_rigid() {
    let settings = [
        ("emitters.0.speed", 3.0),
        ("emitters.0.speedVariation", 0.0),
        ("emitters.0.spread", 0.0),
        ("emitters.0.position.y", 2.0),
        ("emission.rate", 60.0),
    ];
    let mut simulator = riding(SPECK, &settings);
    // A quarter turn about x: up becomes +z.
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let turned = pose_of(&[0.0, 0.0, 0.0, half, 0.0, 0.0, half]).unwrap();
    simulator.rigids_mut().move_to(0, turned).unwrap();
    steps(&mut simulator, 3);
    let last = simulator.alive() - 1;
    let particles = simulator.particles();
    let slip = [particles.sx[last], particles.sy[last], particles.sz[last]];
    assert!(
        (slip[2] - 3.0).abs() < 1e-5 && slip[0].abs() < 1e-5 && slip[1].abs() < 1e-5,
        "{slip:?}"
    );
    assert!(
        (place(&simulator, last)[2] - 2.0).abs() < 1e-5,
        "{:?}",
        place(&simulator, last)
    );
}

#[test]
fn no_rigid_of_that_number_is_the_world() {
    let mut lost = riding(SPECK, &[("emitters.0.rigid", 7.0), ("emitters.0.position.y", 1.0)]);
    sweep(&mut lost, 40.0, 10);
    assert!(places(&lost).iter().all(|place| *place == [0.0, 1.0, 0.0]));
}
