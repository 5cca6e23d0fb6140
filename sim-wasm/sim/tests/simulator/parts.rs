//! Emitters, forces and shedders on parts.

use std::f64::consts::TAU;

use crate::common::{LIVELY, STEP, STILL, newborn, place, simulator, slip};
use sim::Simulator;
use sim::layout::scope::parts::{FIRST_PART, MAX_PARTS, PART_FLOATS};
use sim::math::pose::{Pose, rotation_about};
use sim::math::vector::Vector;

/// The second part; the first one is out of the way.
const SECOND: f64 = FIRST_PART as f64 + 1.0;
/// Angular velocity of the part (rad/s) about z.
const RATE: f64 = 20.0;
const HUB: [f32; 3] = [1.0, 0.5, 0.0];

/// A nozzle on the second part with 600 births per second that adds no speed.
const NOZZLE: &[(&str, f64)] = &[
    ("emission.rate", 600.0),
    ("emission.lifetime", 60.0),
    ("emitters.0.lifetimeVariation", 0.0),
    ("emitters.0.speed", 0.0),
    ("emitters.0.position.x", 0.5),
    ("emitters.0.rigid", SECOND),
];

/// Pose of the part at `time` (s): it rotates about z in place.
fn propeller(time: f64) -> Pose {
    Pose {
        position: HUB.into(),
        rotation: rotation_about(Vector::new(0.0, 0.0, (RATE * time).rem_euclid(2.0 * TAU) as f32)),
    }
}

/// Pose of the part at `time` (s): it rotates and moves.
fn wheel(time: f64) -> Pose {
    Pose {
        position: Vector::new(1.5 * time as f32, 0.4, -0.3),
        rotation: rotation_about(Vector::new(0.1, 0.3, -2.0) * time as f32),
    }
}

/// Arguments of `Parts::place` for a part out of the way and one with the pose `pose`.
fn numbers(carrier: f32, step: u64, pose: impl Fn(f64) -> Pose) -> Vec<f32> {
    let flat = |pose: Pose| {
        let [x, y, z]: [f32; 3] = pose.position.into();
        let [i, j, k, w] = pose.rotation;
        [x, y, z, i, j, k, w]
    };
    let aside = flat(Pose::at(Vector::new(0.0, -50.0, 0.0)));
    let ends = [0, 1].map(|later| flat(pose((step + later) as f64 * STEP)));
    let at = |end: usize| [&[-1.0], aside.as_slice(), &[carrier], &ends[end]].concat();
    [at(0), at(1)].concat()
}

fn advance(simulator: &mut Simulator, pose: impl Fn(f64) -> Pose) {
    let numbers = numbers(-1.0, simulator.steps(), pose);
    simulator.place_parts(&numbers).unwrap();
    simulator.step();
}

fn places(simulator: &Simulator) -> Vec<[f32; 3]> {
    (0..simulator.alive()).map(|i| place(simulator, i)).collect()
}

#[test]
fn a_nozzle_on_the_tip_of_a_propeller_leaves_an_even_circle() {
    let mut simulator = simulator(4000, 1, &[STILL, NOZZLE]);
    (0..30).for_each(|_| advance(&mut simulator, propeller));
    assert_eq!(simulator.alive(), 300);
    for (number, [x, y, z]) in places(&simulator).into_iter().enumerate() {
        let [x, y] = [x - HUB[0], y - HUB[1]].map(f64::from);
        assert!(
            (x.hypot(y) - 0.5).abs() < 1e-3 && z == 0.0,
            "birth {number}: {x} {y} {z}"
        );
        let turned = RATE / 600.0 * (number as f64 + 1.0);
        let off = (y.atan2(x) - turned).rem_euclid(TAU);
        assert!(off.min(TAU - off) < 2e-3, "birth {number} is {off} rad off");
    }
}

#[test]
fn a_fraction_of_the_velocity_of_the_tip_is_inherited() {
    for inherit in [0.25, 1.0] {
        let mut simulator = simulator(4000, 1, &[STILL, NOZZLE, &[("emitters.0.inherit", inherit)]]);
        (0..10).for_each(|_| advance(&mut simulator, propeller));
        for number in 0..simulator.alive() {
            let turned = RATE / 600.0 * (number as f64 + 1.0);
            let speed = inherit * 0.5 * RATE;
            let expected = Vector::new((-speed * turned.sin()) as f32, (speed * turned.cos()) as f32, 0.0);
            let off = (Vector::from(slip(&simulator, number)) - expected).length();
            assert!(off < 0.006 * speed as f32, "birth {number} is {off} m/s off");
        }
    }
}

#[test]
fn parts_without_a_pose_are_fixed_in_the_world() {
    let in_the_world = || simulator(100, 1, &[STILL, NOZZLE]);
    let (mut unplaced, mut beyond) = (in_the_world(), in_the_world());
    beyond.set("emitters.0.rigid", SECOND + 1.0).unwrap();
    for _ in 0..5 {
        unplaced.step();
        advance(&mut beyond, propeller);
    }
    // A pose holds for one step.
    let mut once = in_the_world();
    advance(&mut once, propeller);
    let first = once.alive();
    once.step();
    for place in [places(&unplaced), places(&beyond), places(&once).split_off(first)].concat() {
        assert_eq!(place, [0.5, 0.0, 0.0]);
    }
    assert!(places(&once)[..first].iter().all(|place| *place != [0.5, 0.0, 0.0]));
}

#[test]
fn parts_affect_only_items_attached_to_them() {
    let run = |places_parts: bool| {
        let mut simulator = simulator(2000, 5, &[LIVELY]);
        for _ in 0..60 {
            if places_parts {
                advance(&mut simulator, wheel);
            } else {
                simulator.step();
            }
        }
        simulator.hash()
    };
    assert_eq!(run(true), run(false));
}

/// One item of each kind on the second part.
const RIDERS: &[(&str, f64)] = &[
    ("emission.rate", 120.0),
    ("emitters.0.rigid", SECOND),
    ("emitters.0.inherit", 0.5),
    ("emitters.1.position.x", 0.3),
    ("vortices.0.circulation", 2.0),
    ("vortices.0.rigid", SECOND),
    ("attractors.0.acceleration", 1.0),
    ("attractors.0.rigid", SECOND),
    ("flows.0.speed", 1.0),
    ("flows.0.rigid", SECOND),
    ("shapes.0.speed", 1.0),
    ("shapes.0.outline.000", 17_955_998_253_921.0),
    ("shapes.0.outline.001", 33.0),
    ("shapes.0.rigid", SECOND),
    ("shedders.0.rate", 30.0),
    ("shedders.0.strength", 0.5),
    ("shedders.0.rigid", SECOND),
];

#[test]
fn a_saved_state_continues_like_the_original() {
    let mut whole = simulator(500, 3, &[RIDERS]);
    (0..30).for_each(|_| advance(&mut whole, wheel));
    let saved = whole.save();
    (0..30).for_each(|_| advance(&mut whole, wheel));

    // Poses given for another step have no effect.
    let mut other = simulator(500, 9, &[]);
    other.place_parts(&numbers(-1.0, 400, propeller)).unwrap();
    other.restore(&saved).unwrap();
    (0..30).for_each(|_| advance(&mut other, wheel));
    assert_eq!(other.hash(), whole.hash());
}

#[test]
fn a_take_with_an_input_that_reads_the_air_replays_from_every_state() {
    let mut simulator = simulator(500, 3, &[RIDERS]);
    simulator.record();
    let mut states = Vec::new();
    for step in 0..40 {
        if step % 10 == 0 {
            states.push(simulator.save());
        }
        if step == 20 {
            // Changes the particles at once, by the air at their positions.
            simulator.input_values(&[("simulation.integrator", 1.0)]).unwrap();
        }
        advance(&mut simulator, wheel);
    }
    let expected = simulator.hash();
    for state in states.iter().map(Some).chain([None]) {
        simulator.rewind(state.map(Vec::as_slice)).unwrap();
        while simulator.steps() < 40 {
            advance(&mut simulator, wheel);
        }
        assert_eq!(simulator.hash(), expected);
    }
}

#[test]
fn invalid_poses_are_errors() {
    let mut simulator = simulator(100, 1, &[STILL, NOZZLE]);
    let good = numbers(-1.0, 0, propeller);
    simulator.place_parts(&good).unwrap();
    // The second part at the start, then the first one at the end.
    let with = |index: usize, value: f32| {
        let mut numbers = good.clone();
        numbers[PART_FLOATS + index] = value;
        numbers
    };
    for numbers in [
        with(1, f32::INFINITY),
        with(9, f32::NAN),
        with(10, -2e4),
        with(4, 1.0),
        with(15, f32::NAN),
        good[1..].to_vec(),
        good[PART_FLOATS..].to_vec(),
        good[..PART_FLOATS].repeat(2 * (MAX_PARTS + 1)),
    ] {
        assert_eq!(simulator.place_parts(&numbers).unwrap_err().key, "parts");
    }
    simulator.step();
    assert!(
        places(&simulator).iter().all(|[x, ..]| *x > 1.0),
        "the poses given before hold"
    );
    let key = "emitters.0.rigid";
    assert!(simulator.set(key, (FIRST_PART + MAX_PARTS - 1) as f64).is_ok());
    assert!(simulator.set(key, (FIRST_PART + MAX_PARTS) as f64).is_err());
}

/// Everything that reads the direction of up, in still air or in a wind across it.
const VERTICAL: &[&[(&str, f64)]] = &[
    &[("gravity.acceleration", 0.7)],
    &[("buoyancy.acceleration", 1.5)],
    &[("buoyancies.0.acceleration", 0.9), ("drag.rate", 1.0)],
    &[("wind.shear", 0.8), ("wind.height", 0.3)],
    &[("winds.0.shear", 0.6), ("winds.0.velocity.x", 0.1)],
];

/// Moves the x axis to z, y to x and z to y.
fn turned([x, y, z]: [f32; 3]) -> [f32; 3] {
    [y, z, x]
}

#[test]
fn what_is_vertical_follows_the_direction_of_up() {
    for integrator in [0.0, 1.0] {
        for settings in VERTICAL {
            let run = |is_turned: bool| {
                let integrators = [("simulation.integrator", integrator)];
                let mut simulator = simulator(20, 1, &[STILL, &integrators, settings]);
                simulator
                    .set("forces.wind.x", if is_turned { 0.0 } else { 0.5 })
                    .unwrap();
                simulator
                    .set("forces.wind.z", if is_turned { 0.5 } else { 0.0 })
                    .unwrap();
                if settings[0].0.starts_with("winds") {
                    simulator
                        .set("winds.0.velocity.x", if is_turned { 0.0 } else { 0.4 })
                        .unwrap();
                    simulator
                        .set("winds.0.velocity.z", if is_turned { 0.4 } else { 0.0 })
                        .unwrap();
                }
                for i in 0..6 {
                    let place = [0.1 * i as f32, 0.3 * i as f32 - 0.5, 0.2];
                    simulator.add(&newborn(if is_turned { turned(place) } else { place }));
                }
                for _ in 0..60 {
                    if is_turned {
                        simulator.place_parts(&[1.0, 0.0, 0.0]).unwrap();
                    }
                    simulator.step();
                }
                simulator
            };
            let (upright, tilted) = (run(false), run(true));
            for (expected, place) in places(&upright).into_iter().zip(places(&tilted)) {
                let off = (Vector::from(turned(expected)) - Vector::from(place)).length();
                assert!(off < 1e-5, "{} is {off} m off", settings[0].0);
            }
        }
    }
}

#[test]
fn a_direction_of_up_holds_for_one_step_and_is_a_unit_vector() {
    let mut simulator = simulator(1, 1, &[STILL, &[("gravity.acceleration", 2.0)]]);
    simulator.add(&newborn([0.0; 3]));
    for wrong in [
        vec![1.0],
        vec![0.0; 3],
        vec![0.0, 2.0, 0.0],
        vec![f32::NAN, 0.0, 0.0],
        vec![0.0, 1.0, 0.0, 0.0],
    ] {
        assert_eq!(simulator.place_parts(&wrong).unwrap_err().key, "parts");
    }
    simulator.place_parts(&[-1.0, 0.0, 0.0]).unwrap();
    simulator.step();
    let [x, y, _] = slip(&simulator, 0);
    assert!((f64::from(x) - 2.0 * STEP).abs() < 1e-6 && y == 0.0);
    simulator.step();
    let [after, y, _] = slip(&simulator, 0);
    assert!(after == x && (f64::from(y) + 2.0 * STEP).abs() < 1e-6);
}

#[cfg(feature = "rigids")]
mod on_rigids {
    use super::*;
    use sim::math::pose::product;
    use sim::rigids::{RigidDescription, RigidKind, RigidShape};

    /// Small enough that nothing collides with it.
    const SPECK: RigidShape = RigidShape::Ball { radius: 0.001 };
    const FAR: [f32; 3] = [0.0, -50.0, 0.0];

    /// A rigid that is out of the way, and one with the pose `pose`.
    fn rigged(settings: &[&[(&str, f64)]], pose: impl Fn(f64) -> Pose) -> Simulator {
        let mut simulator = simulator(1000, 1, settings);
        for pose in [Pose::at(FAR.into()), pose(0.0)] {
            let description = RigidDescription::new(RigidKind::Kinematic, SPECK, pose);
            simulator.rigids_mut().add(description).unwrap();
        }
        simulator
    }

    fn move_rigid(simulator: &mut Simulator, pose: impl Fn(f64) -> Pose) {
        let end = (simulator.steps() + 1) as f64 * STEP;
        simulator.rigids_mut().move_to(1, pose(end)).unwrap();
    }

    /// One item of each kind that shows at once whether it follows its carrier.
    const KINDS: &[&[(&str, f64)]] = &[
        &[
            ("emitters.0.position.x", 0.3),
            ("emitters.0.inherit", 0.7),
            ("emission.rate", 60.0),
        ],
        &[("vortices.0.circulation", 2.0), ("vortices.0.axis.x", 1.0)],
        &[
            ("winds.0.velocity.y", 1.0),
            ("winds.0.region.shape", 2.0),
            ("winds.0.region.size.x", 0.4),
        ],
        &[("jets.0.speed", 2.0)],
        &[("gravities.0.acceleration.x", 1.0)],
        &[("attractors.0.acceleration", 1.0)],
        &[("orbits.0.acceleration", 1.0)],
        &[("explosions.0.impulse", 1.0), ("explosions.0.envelope.start", 0.2)],
        &[("spirals.0.turn", 2.0)],
        &[
            ("shedders.0.rate", 30.0),
            ("shedders.0.extent.y", 0.2),
            ("shedders.0.alternate", 1.0),
        ],
    ];

    /// The largest distance (m) between two particles of the same index.
    fn farthest(ours: &Simulator, expected: &Simulator) -> f32 {
        assert_eq!(ours.alive(), expected.alive());
        let pairs = places(ours).into_iter().zip(places(expected));
        pairs
            .map(|(a, b)| (Vector::from(a) - Vector::from(b)).length())
            .fold(0.0, f32::max)
    }

    /// The settings, and the key that attaches them.
    fn with_smoke(kind: &[(&str, f64)], rigid: f64) -> Simulator {
        let list = kind[0].0.split('.').next().unwrap();
        let key = format!("{list}.0.rigid");
        let mut simulator = rigged(&[STILL, kind, &[(&key, rigid)]], wheel);
        for x in 0..5 {
            for y in 0..3 {
                simulator.add(&newborn([0.25 * x as f32, 0.2 + 0.2 * y as f32, -0.25]));
            }
        }
        simulator
    }

    #[test]
    fn each_kind_follows_a_part_as_a_rigid_on_the_same_path() {
        for kind in KINDS {
            let runs = [1.0, SECOND, -1.0].map(|rigid| {
                let mut simulator = with_smoke(kind, rigid);
                for _ in 0..30 {
                    move_rigid(&mut simulator, wheel);
                    advance(&mut simulator, wheel);
                }
                simulator
            });
            let [on_rigid, on_part, nowhere] = &runs;
            let off = farthest(on_part, on_rigid);
            assert!(off < 2e-4, "{}: {off} m off", kind[0].0);
            let moved = farthest(nowhere, on_rigid);
            assert!(moved > 2e-3, "{} moves hardly anything: {moved} m", kind[0].0);
        }
    }

    /// Pose of the part on its carrier at `time` (s).
    fn on_carrier(time: f64) -> Pose {
        Pose {
            position: Vector::new(0.2, 0.3 * time as f32, 0.1),
            rotation: rotation_about(Vector::new(3.0, 0.0, 0.5) * time as f32),
        }
    }

    /// Pose of the part in the world when its carrier has the pose of `wheel`.
    fn carried(time: f64) -> Pose {
        let (carrier, own) = (wheel(time), on_carrier(time));
        // The sandwich product, written out.
        let [x, y, z, w] = carrier.rotation;
        let axis = Vector::new(x, y, z);
        let twice = axis.cross(own.position) * 2.0;
        Pose {
            position: carrier.position + own.position + twice * w + axis.cross(twice),
            rotation: product(carrier.rotation, own.rotation),
        }
    }

    #[test]
    fn each_kind_follows_a_part_on_a_rigid() {
        for kind in KINDS {
            let run = |carrier: f32, pose: fn(f64) -> Pose| {
                let mut simulator = with_smoke(kind, SECOND);
                for _ in 0..30 {
                    move_rigid(&mut simulator, wheel);
                    let numbers = numbers(carrier, simulator.steps(), pose);
                    simulator.place_parts(&numbers).unwrap();
                    simulator.step();
                }
                simulator
            };
            let off = farthest(&run(1.0, on_carrier), &run(-1.0, carried));
            assert!(off < 2e-4, "{}: {off} m off", kind[0].0);
            let alone = farthest(&run(-1.0, on_carrier), &run(-1.0, carried));
            assert!(alone > 1e-3, "{} does not need its carrier: {alone} m", kind[0].0);
        }
    }

    #[test]
    fn a_carrier_that_does_not_exist_is_the_world() {
        let run = |carrier: f32| {
            let mut simulator = rigged(&[STILL, NOZZLE], wheel);
            for step in 0..5 {
                simulator.place_parts(&numbers(carrier, step, propeller)).unwrap();
                simulator.step();
            }
            simulator.hash()
        };
        for nowhere in [77.0, 4095.0, f32::MAX, f32::NAN] {
            assert_eq!(run(nowhere), run(-1.0));
        }
        assert_ne!(run(0.0), run(-1.0));
    }

    #[test]
    fn rigids_fall_against_the_direction_of_up() {
        let mut simulator = simulator(1, 1, &[]);
        let description = RigidDescription::new(RigidKind::Dynamic, SPECK, Pose::at(Vector::new(0.0, 2.0, 0.0)));
        simulator.rigids_mut().add(description).unwrap();
        for _ in 0..30 {
            simulator.place_parts(&[0.0, 0.0, 1.0]).unwrap();
            simulator.step();
        }
        let [x, y, z] = <[f32; 3]>::try_from(&simulator.rigids().poses()[7..10]).unwrap();
        // Half a second, to the first order of Rapier's time step.
        let fallen = 9.81 * 0.5 * 0.5 / 2.0;
        assert!(x == 0.0 && y == 2.0 && (z + fallen).abs() < 0.03, "{x} {y} {z}");
    }

    #[test]
    fn a_saved_state_continues_on_a_moving_carrier() {
        let run = |simulator: &mut Simulator, count: usize| {
            for _ in 0..count {
                move_rigid(simulator, wheel);
                let numbers = numbers(1.0, simulator.steps(), on_carrier);
                simulator.place_parts(&numbers).unwrap();
                simulator.step();
            }
        };
        let mut whole = rigged(&[RIDERS], wheel);
        run(&mut whole, 20);
        let saved = whole.save();
        run(&mut whole, 20);
        let mut other = rigged(&[], wheel);
        other.place_parts(&numbers(1.0, 400, propeller)).unwrap();
        other.restore(&saved).unwrap();
        run(&mut other, 20);
        assert_eq!(other.hash(), whole.hash());
    }
}
