//! Colliders outside of the table.

use crate::common::{STILL, newborn, place, simulator, slip, steps};
use sim::Simulator;
use sim::math::pose::{POSE_FLOATS, Pose, rotation_about};
use sim::math::vector::Vector;
use sim::particles::Newborn;

const ORIGIN: Pose = Pose {
    position: Vector::ZERO,
    rotation: [0.0, 0.0, 0.0, 1.0],
};
const PLANE: f32 = 0.0;
const BALL: f32 = 1.0;
const BOX: f32 = 2.0;
const CAPSULE: f32 = 3.0;

/// A collider of half extents 0.4, 0.3, 0.2 m and radius 0.3 m.
fn collider(shape: f32, restitution: f32, friction: f32, pose: &Pose) -> Vec<f32> {
    let own = [shape, 0.4, 0.3, 0.2, 0.3, restitution, friction, 0.0, 1.0];
    [&own[..], &pose.numbers()].concat()
}

/// Still air with a weightless particle of radius 0.1 m at rest at each place.
fn still(places: &[[f32; 3]]) -> Simulator {
    let mut simulator = simulator(100, 1, &[STILL]);
    for place in places {
        assert!(simulator.add(&Newborn {
            // It has grown.
            age: 1.0,
            size: 0.1,
            ..newborn(*place)
        }));
    }
    simulator
}

fn assert_near(found: [f32; 3], expected: [f32; 3], tolerance: f32) {
    let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance);
    assert!(is_near, "{found:?} is not {expected:?}");
}

#[test]
fn a_particle_takes_the_velocity_of_the_collider_that_pushes_it() {
    // Each collider reaches 0.15 m from the particle along its way, and moves on by 0.1 m in a step, at 6 m/s.
    let starts = [(PLANE, 0.15), (BALL, 0.45), (BOX, 0.45), (CAPSULE, 0.75)];
    for (shape, height) in starts {
        for restitution in [0.0, 0.5, 1.0] {
            let mut simulator = still(&[[0.0; 3]]);
            let below = |height: f32| Pose::at(Vector::new(0.0, -height, 0.0));
            let start = collider(shape, restitution, 0.0, &below(height));
            simulator.set_collider(3, &start).unwrap();
            simulator.step();
            assert_eq!(slip(&simulator, 0), [0.0; 3], "at rest it touches nothing");
            simulator.set_collider(3, &below(height - 0.1).numbers()).unwrap();
            simulator.step();
            assert_near(slip(&simulator, 0), [0.0, 6.0 * (1.0 + restitution), 0.0], 1e-3);
            // After half of the step it is hit at a distance of 0.1 m and stays at that, or runs ahead.
            assert_near(place(&simulator, 0), [0.0, 0.05 + 0.05 * restitution, 0.0], 3e-3);
        }
    }
}

#[test]
fn friction_drags_a_particle_along_a_surface_that_turns() {
    // A ball that turns about y by 0.1 rad in a step, at 6 rad/s, and moves so that its equator touches the particle.
    let mut simulator = still(&[[0.4, 0.0, 0.0]]);
    let turned = |angle: f32, x: f32| Pose {
        position: Vector::new(x, 0.0, 0.0),
        rotation: rotation_about(Vector::Y * angle),
    };
    simulator
        .set_collider(0, &collider(BALL, 0.0, 1.0, &turned(0.0, 0.0)))
        .unwrap();
    simulator.set_collider(0, &turned(0.1, 0.01).numbers()).unwrap();
    simulator.step();
    // At the centre of the particle, 0.39 m from that of the ball.
    assert_near(slip(&simulator, 0), [0.6, 0.0, -6.0 * 0.39], 1e-3);
}

#[test]
fn it_arrives_later_where_its_surface_would_be_faster_than_120_metres_a_second() {
    let heights = [1.5, 3.5, 4.5, 5.5];
    let mut simulator = still(&heights.map(|y| [0.0, y, 0.0]));
    simulator.set_collider(0, &collider(PLANE, 0.0, 0.0, &ORIGIN)).unwrap();
    let target = Pose::at(Vector::new(0.0, 5.0, 0.0));
    simulator.set_collider(0, &target.numbers()).unwrap();
    // 2 m in a step. A saved state remembers where it goes.
    for hit in [1, 2, 3, 3] {
        simulator.step();
        let speeds = [0, 1, 2, 3].map(|i| slip(&simulator, i)[1]);
        assert_eq!(speeds.iter().filter(|speed| **speed > 0.0).count(), hit, "{speeds:?}");
        simulator = clone(&simulator);
    }
}

#[test]
fn actions_kill_and_tint() {
    for (action, alive) in [(1.0, 0), (2.0, 1)] {
        let mut simulator = still(&[[0.0, 0.05, 0.0]]);
        let mut ground = collider(PLANE, 0.0, 0.0, &ORIGIN);
        ground[7] = action;
        ground[8] = 5.0;
        simulator.set_collider(0, &ground).unwrap();
        simulator.step();
        assert_eq!(simulator.alive(), alive);
        assert!(alive == 0 || simulator.particles().attributes[0] >> 28 == 5);
    }
}

/// A simulator in the saved state of another.
fn clone(simulator: &Simulator) -> Simulator {
    let mut other = self::simulator(100, 9, &[]);
    other.restore(&simulator.save()).unwrap();
    assert_eq!(other.hash(), simulator.hash());
    assert!(other.save() == simulator.save());
    other
}

#[test]
fn hash_and_saved_state_hold_the_poses_before_and_after_the_last_step() {
    let places = [[0.0, 0.35, 0.0], [0.35, 0.0, 0.0]];
    let mut simulator = still(&places);
    let mut without = still(&places);
    let (empty, saved) = (simulator.hash(), simulator.save());
    simulator
        .set_collider(200, &collider(CAPSULE, 0.3, 0.3, &ORIGIN))
        .unwrap();
    assert_ne!(simulator.hash(), empty);
    for step in 1..40 {
        let before = simulator.hash();
        let pose = Pose {
            position: Vector::new(0.0, 0.02 * step as f32, 0.0),
            rotation: rotation_about(Vector::new(0.3, 0.1, 0.2) * step as f32),
        };
        simulator.set_collider(200, &pose.numbers()).unwrap();
        assert_eq!(simulator.hash(), before, "a pose for the coming step is an input");
        let mut twin = clone(&simulator);
        twin.step();
        simulator.step();
        assert_eq!(twin.hash(), simulator.hash());
    }
    assert_ne!(slip(&simulator, 0), [0.0; 3]);
    simulator.restore(&saved).unwrap();
    assert_eq!(simulator.hash(), empty);
    simulator.set_collider(7, &collider(BALL, 0.0, 0.0, &ORIGIN)).unwrap();
    simulator.set_collider(7, &[]).unwrap();
    steps(&mut simulator, 3);
    steps(&mut without, 3);
    assert_eq!(simulator.hash(), without.hash(), "nothing remains of a removed one");
    assert!(simulator.save() == without.save());
}

#[test]
fn takes_hold_colliders_and_need_the_same_ones() {
    let with = |y: f32| {
        let mut simulator = still(&[]);
        simulator.set("emission.rate", 60.0).unwrap();
        let pose = Pose::at(Vector::new(0.0, y, 0.0));
        simulator.set_collider(0, &collider(BALL, 0.0, 0.5, &pose)).unwrap();
        simulator.record();
        simulator
    };
    let mut original = with(1.0);
    steps(&mut original, 90);
    let take = original.take("").unwrap();
    let mut same = with(1.0);
    steps(&mut same, 20);
    same.replay(&take).unwrap();
    steps(&mut same, 90);
    assert_eq!(same.hash(), original.hash());
    assert!(with(1.1).replay(&take).is_err(), "another scene");

    original.record();
    steps(&mut original, 60);
    let mut elsewhere = still(&[]);
    elsewhere.record();
    elsewhere.replay(&original.take("").unwrap()).unwrap();
    steps(&mut elsewhere, 60);
    assert_eq!(elsewhere.hash(), original.hash());
}

#[test]
fn invalid_colliders_are_errors_and_change_nothing() {
    let mut simulator = still(&[]);
    let good = collider(BOX, 0.0, 0.0, &ORIGIN);
    simulator.set_collider(0, &good).unwrap();
    let before = simulator.save();
    let mut rejects = |index: u32, numbers: &[f32]| {
        let error = simulator.set_collider(index, numbers).unwrap_err();
        assert_eq!(error.key, "collide.shape");
        assert!(simulator.save() == before, "{numbers:?}");
    };
    rejects(256, &good);
    rejects(1, &ORIGIN.numbers());
    rejects(0, &good[..15]);
    rejects(0, &[0.0; POSE_FLOATS]);
    for (place, values) in [
        (0, [-1.0, 4.0, f32::NAN]),
        (2, [0.0, 1e-4, 2e3]),
        (4, [0.0, -0.3, f32::NAN]),
        (5, [-0.1, 1.1, f32::NAN]),
        (8, [0.0, 16.0, f32::INFINITY]),
        (10, [1.1e4, -1.1e4, f32::NAN]),
        (15, [0.0, 2e3, f32::NAN]),
    ] {
        for value in values {
            let mut numbers = good.clone();
            numbers[place] = value;
            rejects(0, &numbers);
        }
    }
}

/// The same shape as a rigid of Rapier.
#[cfg(feature = "rigids")]
mod beside_rigids {
    use super::*;
    use sim::rigids::{RigidDescription, RigidKind, RigidShape};

    const STEPS: usize = 300;
    const DT: f32 = 1.0 / 60.0;

    /// Turbulent smoke that rises past the origin.
    fn smoke() -> Simulator {
        let settings = [
            ("emission.rate", 200.0),
            ("emission.lifetime", 3.0),
            ("emitters.0.position.y", -0.8),
            ("emitters.0.shape", 1.0),
            ("emitters.0.radius", 0.3),
            ("emitters.0.speed", 1.0),
            ("emitters.0.size", 0.1),
            ("turbulence.speed", 0.4),
            ("turbulence.octaves", 2.0),
        ];
        simulator(1000, 5, &[&settings])
    }

    fn rigid_of(shape: f32) -> RigidShape {
        match shape {
            BALL => RigidShape::Ball { radius: 0.3 },
            BOX => RigidShape::Cuboid {
                half_extents: [0.4, 0.3, 0.2],
            },
            _ => RigidShape::Capsule {
                half_height: 0.3,
                radius: 0.3,
            },
        }
    }

    #[test]
    fn they_agree_within_a_millimetre_over_five_seconds() {
        for shape in [BALL, BOX, CAPSULE] {
            let (mut analytic, mut rapier) = (smoke(), smoke());
            let numbers = collider(shape, 0.2, 0.5, &ORIGIN);
            analytic.set_collider(0, &numbers).unwrap();
            let rigid = RigidDescription {
                restitution: 0.2,
                friction: 0.5,
                ..RigidDescription::new(RigidKind::Kinematic, rigid_of(shape), ORIGIN)
            };
            rapier.rigids_mut().add(rigid).unwrap();
            let mut touched = 0;
            for step in 0..STEPS {
                let pose = path(step as f32 * DT);
                analytic.set_collider(0, &pose.numbers()).unwrap();
                rapier.rigids_mut().move_to(0, pose).unwrap();
                analytic.step();
                rapier.step();
                assert_eq!(analytic.alive(), rapier.alive());
                for i in 0..analytic.alive() {
                    assert_near(place(&analytic, i), place(&rapier, i), 1e-3);
                    assert_near(slip(&analytic, i), slip(&rapier, i), 1e-2);
                }
                touched += usize::from(slip(&analytic, 0) != [0.0; 3]);
            }
            assert!(analytic.alive() > 500 && touched > 50, "{touched}");
        }
    }

    /// A way to and fro and up and down, with turns about all axes; once a second it jumps by 4 m.
    fn path(time: f32) -> Pose {
        let jump = if time % 1.0 > 0.9 { 4.0 } else { 0.0 };
        Pose {
            position: Vector::new(
                0.3 * (3.0 * time).sin() + jump,
                0.2 * (2.0 * time).cos(),
                0.1 * time.sin(),
            ),
            rotation: rotation_about(Vector::new(2.0 * time, 1.0, 0.7 * time * time)),
        }
    }
}
