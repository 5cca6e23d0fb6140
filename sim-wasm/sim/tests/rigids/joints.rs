//! Joints against closed forms.

use std::f32::consts::TAU;

use crate::collide::cloud::{DT, rigid, turned};
use sim::math::pose::{Frame, Pose};
use sim::math::vector::Vector;
use sim::rigids::{
    JointDescription, JointKind, Motor, POSE_PAIR_FLOATS, RigidDescription, RigidKind, RigidPart, RigidShape, Rigids,
};

const HINGE: JointKind = JointKind::Hinge {
    axis: Vector::new(0.0, 0.0, 1.0),
    limits: None,
    motor: None,
};

fn joint(kind: JointKind, anchor: Vector) -> JointDescription {
    JointDescription {
        kind,
        rigids: [0, 1],
        anchors: [Vector::ZERO, anchor],
    }
}

/// A fixed peg at the origin and a dynamic rigid.
fn hung(shape: RigidShape, pose: Pose) -> Rigids {
    let mut rigids = Rigids::new();
    let peg = RigidShape::Ball { radius: 0.05 };
    rigids
        .add(rigid(RigidKind::Fixed, peg, Pose::at(Vector::ZERO)))
        .unwrap();
    rigids.add(rigid(RigidKind::Dynamic, shape, pose)).unwrap();
    rigids
}

fn pose(rigids: &Rigids) -> Pose {
    let numbers = &rigids.poses()[POSE_PAIR_FLOATS + 7..][..7];
    Pose {
        position: Vector::new(numbers[0], numbers[1], numbers[2]),
        rotation: [numbers[3], numbers[4], numbers[5], numbers[6]],
    }
}

/// Period (s) in the xy plane, from twelve passages through the vertical.
fn period(rigids: &mut Rigids) -> f32 {
    let mut passages = Vec::new();
    let mut before = pose(rigids).position.x;
    for step in 1..3000 {
        rigids.advance(DT);
        let now = pose(rigids).position.x;
        if before * now < 0.0 {
            passages.push((step as f32 - now / (now - before)) * DT);
        }
        before = now;
    }
    2.0 * (passages[12] - passages[0]) / 12.0
}

#[test]
fn a_pendulum_swings_with_the_period_of_the_closed_form() {
    let (radius, length) = (0.1_f32, 1.0_f32);
    let angle = 0.1_f32;
    for kind in [JointKind::Ball, HINGE] {
        let tilted = Pose {
            position: Vector::new(angle.sin(), -angle.cos(), 0.0) * length,
            rotation: turned(Vector::new(0.0, 0.0, 1.0), angle),
        };
        let mut rigids = hung(RigidShape::Ball { radius }, tilted);
        rigids.add_joint(&joint(kind, Vector::Y * length)).unwrap();
        let inertia = 0.4 * radius * radius;
        // Huygens' compound pendulum with the first correction for its amplitude.
        let closed = TAU * ((length * length + inertia) / (9.81 * length)).sqrt() * (1.0 + angle * angle / 16.0);
        let measured = period(&mut rigids);
        assert!(
            (measured / closed - 1.0).abs() < 0.01,
            "{kind:?}: {measured} for {closed}"
        );
    }
}

#[test]
fn a_compound_swings_about_its_common_centre_of_mass() {
    let ball = |radius: f32, y: f32| RigidPart {
        shape: RigidShape::Ball { radius },
        pose: Pose::at(Vector::Y * y),
    };
    // Masses 8 to 1, the large one at the peg, the small one 0.9 m below it.
    let shape = RigidShape::Compound {
        parts: vec![ball(0.2, 0.0), ball(0.1, -0.9)],
    };
    let tilted = Pose {
        position: Vector::ZERO,
        rotation: turned(Vector::new(0.0, 0.0, 1.0), 0.1),
    };
    let mut rigids = hung(shape, tilted);
    rigids.add_joint(&joint(HINGE, Vector::ZERO)).unwrap();
    let inertia = 8.0 * 0.4 * 0.04 + 0.4 * 0.01 + 0.81;
    let closed = TAU * (inertia / (9.81 * 0.9_f32)).sqrt();
    let mut passages = Vec::new();
    let mut before = 0.1;
    for step in 1..2000 {
        rigids.advance(DT);
        let now = pose(&rigids).rotation[2];
        if before * now < 0.0 {
            passages.push((step as f32 - now / (now - before)) * DT);
        }
        before = now;
    }
    let measured = 2.0 * (passages[8] - passages[0]) / 8.0;
    assert!((measured / closed - 1.0).abs() < 0.01, "{measured} for {closed}");
}

#[test]
fn a_hinge_keeps_its_axis_its_limits_and_its_motor_speed() {
    let door = || RigidShape::Cuboid {
        half_extents: [0.5, 0.8, 0.03],
    };
    let axis = Vector::new(0.2, 1.0, 0.1).unit_or(Vector::Y);
    let turn_of = |rigids: &Rigids| Pose::at(Vector::ZERO).rotation_vector_to(&pose(rigids));
    for (limits, motor) in [
        (None, None),
        (Some([-0.3, 0.5]), None),
        (
            None,
            Some(Motor {
                speed: 3.0,
                torque: 1e4,
            }),
        ),
    ] {
        let mut rigids = hung(door(), Pose::at(Vector::new(0.6, 0.0, 0.0)));
        let kind = JointKind::Hinge { axis, limits, motor };
        rigids.add_joint(&joint(kind, Vector::new(-0.6, 0.0, 0.0))).unwrap();
        let mut greatest = 0.0_f32;
        for step in 1..=300 {
            let before = pose(&rigids);
            rigids.advance(DT);
            let off = (Frame::new(&pose(&rigids)).rotate(axis) - axis).length();
            assert!(off < 0.01, "step {step}: the axis is off by {off}");
            let angle = turn_of(&rigids).dot(axis);
            greatest = greatest.max(angle.abs());
            if limits.is_some() {
                assert!(angle > -0.33 && angle < 0.53, "step {step}: {angle}");
            }
            if motor.is_some() && step > 60 {
                let speed = before.rotation_vector_to(&pose(&rigids)).dot(axis) / DT;
                assert!((speed - 3.0).abs() < 0.1, "step {step}: {speed}");
            }
        }
        assert!(greatest > 0.25, "it moved: {greatest}");
    }
}

#[test]
fn a_fixed_joint_a_rope_and_a_spring_hold() {
    let ball = RigidShape::Ball { radius: 0.1 };
    let below = |distance: f32| Pose::at(Vector::Y * -distance);
    let mut held = hung(ball.clone(), Pose::at(Vector::new(0.5, 0.0, 0.0)));
    held.add_joint(&joint(JointKind::Fixed, Vector::new(-0.5, 0.0, 0.0)))
        .unwrap();
    let mut roped = hung(ball.clone(), below(0.4));
    roped
        .add_joint(&joint(JointKind::Rope { length: 0.7 }, Vector::ZERO))
        .unwrap();
    // At 500 kg/m3 it weighs 20.55 N, which extends 100 N/m by 0.2055 m.
    let mut sprung = hung(ball, below(0.5));
    let spring = JointKind::Spring {
        length: 0.5,
        stiffness: 100.0,
        damping: 10.0,
    };
    sprung.add_joint(&joint(spring, Vector::ZERO)).unwrap();
    for _ in 0..600 {
        for rigids in [&mut held, &mut roped, &mut sprung] {
            rigids.advance(DT);
        }
    }
    assert!((pose(&held).position - Vector::new(0.5, 0.0, 0.0)).length() < 0.01);
    assert!((pose(&roped).position.y + 0.7).abs() < 0.01, "{:?}", pose(&roped));
    assert!((pose(&sprung).position.y + 0.7055).abs() < 0.005, "{:?}", pose(&sprung));
}

#[test]
fn joints_are_restored() {
    let mut rigids = hung(RigidShape::Ball { radius: 0.1 }, Pose::at(Vector::new(1.0, 0.0, 0.0)));
    rigids
        .add_joint(&joint(JointKind::Ball, Vector::new(-1.0, 0.0, 0.0)))
        .unwrap();
    (0..20).for_each(|_| rigids.advance(DT));
    let mut twin = Rigids::restore(&rigids.save()).unwrap();
    (0..90).for_each(|_| rigids.advance(DT));
    (0..90).for_each(|_| twin.advance(DT));
    assert!(rigids.save() == twin.save());
    assert_eq!(twin.add_joint(&joint(JointKind::Fixed, Vector::ZERO)), Ok(1));
}

#[test]
fn invalid_numbers_are_errors_with_their_key() {
    let anchors = [0.0; 6];
    let numbers = |kind: f32, rigids: [f32; 2], rest: &[f32]| -> Vec<f32> {
        [kind]
            .into_iter()
            .chain(rigids)
            .chain(anchors)
            .chain(rest.iter().copied())
            .collect()
    };
    let hinge = [0.0, 1.0, 0.0, 1.0, -1.0, 1.0, 0.0, 0.0];
    let with = |place: usize, value: f32| {
        let mut hinge = hinge;
        hinge[place] = value;
        numbers(2.0, [0.0, 1.0], &hinge)
    };
    for (numbers, key) in [
        (vec![0.0; 5], "joint.numbers"),
        (numbers(5.0, [0.0, 1.0], &[]), "joint.kind"),
        (numbers(3.0, [0.0, 1.0], &[]), "joint.numbers"),
        (numbers(3.0, [0.0, 1.0], &[-1.0]), "joint.length"),
        (numbers(4.0, [0.0, 1.0], &[1.0, f32::NAN, 0.0]), "joint.stiffness"),
        (numbers(1.0, [0.5, 1.0], &[]), "joint.rigids.0"),
        (numbers(1.0, [0.0, -1.0], &[]), "joint.rigids.1"),
        (with(1, 0.0), "joint.axis"),
        (with(4, -7.0), "joint.limits.0"),
        (with(5, -2.0), "joint.limits.1"),
        (with(6, 1e4), "joint.motor.speed"),
        (with(7, -1.0), "joint.motor.torque"),
    ] {
        assert_eq!(JointDescription::from_numbers(&numbers).unwrap_err().key, key);
    }
    assert!(JointDescription::from_numbers(&numbers(2.0, [0.0, 1.0], &hinge)).is_ok());
    let mut rigids = hung(RigidShape::Ball { radius: 0.1 }, Pose::at(Vector::Y));
    let still = RigidDescription::new(
        RigidKind::Kinematic,
        RigidShape::Ball { radius: 0.1 },
        Pose::at(Vector::ZERO),
    );
    rigids.add(still).unwrap();
    for (pair, key) in [
        ([0, 9], "rigid.index"),
        ([1, 1], "joint.rigids"),
        ([0, 2], "joint.rigids"),
    ] {
        let description = JointDescription {
            rigids: pair,
            ..joint(JointKind::Ball, Vector::ZERO)
        };
        assert_eq!(rigids.add_joint(&description).unwrap_err().key, key);
    }
}
