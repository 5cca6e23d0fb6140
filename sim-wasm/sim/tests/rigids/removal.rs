//! Rigids that are removed: their indices are reused, and nothing of them remains.

use crate::collide::cloud::{kinematic, turned};
use crate::common::{LIVELY, STILL, newborn, place, simulator, steps};
use sim::Simulator;
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::particles::Newborn;
use sim::rigids::{RigidDescription, RigidKind, RigidPart, RigidShape};

const BALL: RigidShape = RigidShape::Ball { radius: 0.5 };

fn at(x: f32) -> Pose {
    Pose::at(Vector::new(x, 0.0, 0.0))
}

fn fixed(x: f32) -> RigidDescription {
    RigidDescription::new(RigidKind::Fixed, BALL, at(x))
}

fn feeling(x: f32) -> RigidDescription {
    RigidDescription {
        density: 1.0,
        feels_smoke: 2.0,
        ..RigidDescription::new(RigidKind::Dynamic, BALL, at(x))
    }
}

fn layered(x: f32) -> RigidDescription {
    RigidDescription {
        boundary_layer: 0.5,
        ..RigidDescription::new(RigidKind::Kinematic, BALL, at(x))
    }
}

/// Where a particle on the x axis is after it flew against a ball at x = 2.
fn flight(act: impl FnOnce(&mut Simulator)) -> [f32; 3] {
    let mut simulator = simulator(1, 1, &[STILL]);
    simulator.add(&Newborn {
        slip: [4.0, 0.0, 0.0],
        ..newborn([0.0; 3])
    });
    simulator.rigids_mut().add(fixed(2.0)).unwrap();
    act(&mut simulator);
    steps(&mut simulator, 60);
    place(&simulator, 0)
}

#[test]
fn smoke_passes_where_a_rigid_was_removed_and_stops_at_one_that_took_its_index() {
    let stopped = flight(|_| ());
    assert!(stopped[0] < 1.5);
    let free = flight(|simulator| simulator.rigids_mut().remove(0).unwrap());
    assert!((free[0] - 4.0).abs() < 1e-4 && free[1] == 0.0);
    let replaced = flight(|simulator| {
        let rigids = simulator.rigids_mut();
        rigids.remove(0).unwrap();
        assert_eq!(rigids.add(fixed(2.0)).unwrap(), 0);
    });
    assert_eq!(replaced, stopped);
}

#[test]
fn indices_are_reused_and_the_others_stay() {
    let mut simulator = simulator(10, 1, &[STILL]);
    let rigids = simulator.rigids_mut();
    for x in 0..4 {
        rigids.add(fixed(2.0 * x as f32)).unwrap();
    }
    rigids.remove(1).unwrap();
    rigids.remove(3).unwrap();
    let again = [rigids.add(feeling(20.0)).unwrap(), rigids.add(layered(30.0)).unwrap()];
    assert_eq!(
        (again, rigids.add(fixed(40.0)).unwrap(), rigids.count()),
        ([1, 3], 4, 5)
    );
    steps(&mut simulator, 2);
    let places: Vec<f32> = simulator.rigids().poses().chunks(14).map(|pair| pair[7]).collect();
    assert_eq!([places[0], places[2], places[4]], [0.0, 4.0, 40.0]);
}

#[test]
fn commands_to_a_removed_rigid_are_errors() {
    let mut simulator = simulator(10, 1, &[STILL]);
    let rigids = simulator.rigids_mut();
    rigids.add(layered(0.0)).unwrap();
    rigids.add(feeling(3.0)).unwrap();
    rigids.remove(0).unwrap();
    let errors = [
        rigids.remove(0).unwrap_err(),
        rigids.remove(2).unwrap_err(),
        rigids.move_to(0, at(1.0)).unwrap_err(),
        rigids.release(0).unwrap_err(),
    ];
    for error in errors {
        assert_eq!(error.key, "rigid.index");
    }
}

#[test]
fn adding_and_removing_for_a_long_time_needs_no_more_room() {
    let mut simulator = simulator(300, 1, &[LIVELY]);
    let mut size = 0;
    for round in 0..1000 {
        let rigids = simulator.rigids_mut();
        let added = [
            rigids.add(fixed(1.0)).unwrap(),
            rigids.add(layered(2.0)).unwrap(),
            rigids.add(feeling(5.0)).unwrap(),
            rigids.add(kinematic(BALL)).unwrap(),
        ];
        for (turn, rigid) in added.into_iter().enumerate() {
            simulator.rigids_mut().remove(rigid).unwrap();
            if (round + turn) % 3 == 0 {
                steps(&mut simulator, 1);
            }
        }
        steps(&mut simulator, 1);
        if round == 10 {
            size = simulator.rigids().save().len();
        }
    }
    assert_eq!(simulator.rigids().count(), 4);
    let grown = simulator.rigids().save().len();
    assert!(grown < size + 200, "the world grew from {size} to {grown} bytes");
}

#[test]
fn a_state_with_removed_rigids_continues_to_the_same_hash() {
    let mut original = simulator(500, 3, &[LIVELY]);
    for x in 0..4 {
        let rigids = original.rigids_mut();
        rigids.add(feeling(x as f32)).unwrap();
        rigids.add(layered(0.3 * x as f32 - 0.6)).unwrap();
        rigids.add(fixed(x as f32 + 9.0)).unwrap();
    }
    steps(&mut original, 30);
    for rigid in [7, 2, 3, 10] {
        original.rigids_mut().remove(rigid).unwrap();
    }
    original.rigids_mut().add(layered(0.5)).unwrap();
    original.rigids_mut().add(feeling(-0.5)).unwrap();
    // On its way when the state is saved.
    let moving = original.rigids_mut().add(layered(9.5)).unwrap();
    original.rigids_mut().move_to(moving, at(200.0)).unwrap();
    // Layers that overlap, and of which the lowest index was registered last.
    let turn = |simulator: &mut Simulator, count: usize| {
        for _ in 0..count {
            let angle = 0.15 * simulator.steps() as f32;
            for (rigid, x) in [(1, -0.6), (2, 0.5), (4, -0.3)] {
                let rotation = turned(Vector::Y, angle);
                let pose = Pose { rotation, ..at(x) };
                simulator.rigids_mut().move_to(rigid, pose).unwrap();
            }
            simulator.step();
        }
    };
    for wait in [0, 1, 9] {
        turn(&mut original, wait);
        let bytes = original.save();
        let mut restored = simulator(500, 9, &[STILL]);
        restored.rigids_mut().add(fixed(0.0)).unwrap();
        restored.restore(&bytes).unwrap();
        assert!(restored.save() == bytes, "something was not restored");
        for simulator in [&mut original, &mut restored] {
            simulator.rigids_mut().add(feeling(2.5)).unwrap();
            turn(simulator, 40);
        }
        assert_eq!(restored.hash(), original.hash(), "after {wait} steps");
    }
}

#[test]
fn a_removed_rigid_with_a_layer_or_in_smoke_leaves_no_trace() {
    // Stale entries of the layers and of the smoke's forces must not act on the next rigid of the index.
    let run = |first: Option<fn(f32) -> RigidDescription>| {
        let mut simulator = simulator(300, 2, &[LIVELY]);
        if let Some(description) = first {
            simulator.rigids_mut().add(description(0.0)).unwrap();
            simulator.rigids_mut().remove(0).unwrap();
        }
        simulator.rigids_mut().add(kinematic(BALL)).unwrap();
        for step in 0..60 {
            simulator.rigids_mut().move_to(0, at(0.02 * step as f32)).unwrap();
            simulator.step();
        }
        simulator.hash()
    };
    assert_eq!(run(Some(layered)), run(None));
    assert_eq!(run(Some(feeling)), run(None));
}

#[test]
fn other_rigids_meet_the_shapes_of_the_new_rigid_only() {
    let speck = RigidShape::Ball { radius: 0.01 };
    let slab = |x: f32| RigidPart {
        shape: RigidShape::Cuboid {
            half_extents: [1.0, 0.5, 1.0],
        },
        pose: at(x),
    };
    let both = RigidShape::Compound {
        parts: vec![slab(0.0), slab(10.0)],
    };
    // Heights at which balls come to rest, or fall past, over both slabs.
    let rest = |shapes: &[RigidShape]| {
        let mut simulator = simulator(10, 1, &[STILL]);
        let rigids = simulator.rigids_mut();
        for (turn, shape) in shapes.iter().enumerate() {
            if turn > 0 {
                rigids.remove(0).unwrap();
            }
            let kind = [RigidKind::Dynamic, RigidKind::Fixed][usize::from(turn + 1 == shapes.len())];
            rigids.add(RigidDescription::new(kind, shape.clone(), at(0.0))).unwrap();
        }
        for x in [0.0, 10.0] {
            let above = Pose::at(Vector::new(x, 1.5, 0.0));
            rigids
                .add(RigidDescription::new(RigidKind::Dynamic, BALL, above))
                .unwrap();
        }
        steps(&mut simulator, 120);
        [1, 2].map(|rigid| simulator.rigids().poses()[14 * rigid + 8] > 0.9)
    };
    assert_eq!(rest(&[speck.clone(), both.clone()]), [true, true]);
    assert_eq!(rest(&[speck.clone(), slab(0.0).shape]), [true, false]);
    assert_eq!(rest(&[both.clone(), slab(0.0).shape]), [true, false]);
    assert_eq!(rest(&[both.clone(), speck.clone(), both]), [true, true]);
}

#[test]
fn other_rigids_fall_where_one_was_removed() {
    let mut simulator = simulator(10, 1, &[STILL]);
    let rigids = simulator.rigids_mut();
    rigids.add(fixed(0.0)).unwrap();
    let above = Pose::at(Vector::new(0.0, 1.5, 0.0));
    rigids
        .add(RigidDescription::new(RigidKind::Dynamic, BALL, above))
        .unwrap();
    steps(&mut simulator, 20);
    simulator.rigids_mut().remove(0).unwrap();
    steps(&mut simulator, 60);
    assert!(simulator.rigids().poses()[14 + 8] < -1.0);
}
