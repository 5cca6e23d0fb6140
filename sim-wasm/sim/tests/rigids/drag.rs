//! Dragging by a spring: the closed form of its step response, for every mass.

use crate::collide::cloud::{Cloud, DT, kinematic, rigid};
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::rigids::{Grab, RigidDescription, RigidKind, RigidShape, Rigids};

const STIFFNESS: f32 = 20.0;

/// The remaining fraction of the path after `steps` steps from rest.
fn left(steps: i32) -> f32 {
    let a = STIFFNESS * DT;
    (1.0 + steps as f32 * a / (1.0 + a)) / (1.0 + a).powi(steps)
}

fn grab(anchor: [f32; 3], target: [f32; 3]) -> Grab {
    Grab::from_numbers(anchor, target, STIFFNESS).unwrap()
}

#[test]
fn a_kinematic_rigid_follows_the_closed_form_and_never_jumps() {
    let mut cloud = Cloud::new(1);
    cloud.rigids.add(kinematic(RigidShape::Ball { radius: 0.3 })).unwrap();
    cloud.rigids.drag(0, grab([0.0, 0.2, 0.0], [3.0, 0.2, 0.0])).unwrap();
    for step in 1..=90 {
        cloud.step(0.0);
        let at = cloud.pose(0).position;
        assert!((3.0 - at.x - 3.0 * left(step)).abs() < 1e-4, "step {step}: {at:?}");
        assert!(at.y.abs() < 1e-5, "the anchor goes to the target: {at:?}");
        assert!(at.x <= 3.0 + 1e-5, "no overshoot: {at:?}");
    }
    cloud.rigids.release(0).unwrap();
    let released = cloud.pose(0);
    cloud.step(0.0);
    assert_eq!(cloud.pose(0), released);
}

/// A ball of 0.1 m radius that weighs `mass` kg, dragged by its centre: its displacement at each step.
fn response(mass: f32) -> Vec<f32> {
    let volume = 4.0 / 3.0 * std::f32::consts::PI * 1e-3;
    let mut rigids = Rigids::new();
    rigids
        .add(RigidDescription {
            density: mass / volume,
            ..rigid(
                RigidKind::Dynamic,
                RigidShape::Ball { radius: 0.1 },
                Pose::at(Vector::ZERO),
            )
        })
        .unwrap();
    rigids.drag(0, grab([0.0; 3], [0.0; 3])).unwrap();
    rigids.advance(DT);
    rigids.drag(0, grab([0.0; 3], [1.0, 0.5, 0.0])).unwrap();
    (0..180)
        .map(|_| {
            rigids.advance(DT);
            let [x, y] = [rigids.poses()[7], rigids.poses()[8]];
            assert!((y - 0.5 * x).abs() < 0.01, "straight, gravity or not: {x} {y}");
            x
        })
        .collect()
}

#[test]
fn a_dynamic_rigid_reaches_the_target_without_overshoot_whatever_its_mass() {
    let (light, heavy) = (response(0.05), response(400.0));
    for (step, (light, heavy)) in light.iter().zip(&heavy).enumerate() {
        assert!((light - heavy).abs() < 1e-3, "step {step}: {light} {heavy}");
        assert!(*light < 1.02, "overshoot at step {step}: {light}");
        // Rapier adds the force in parts over the step, which lags a little behind the closed form.
        let expected = 1.0 - left(step as i32 + 1);
        assert!((light - expected).abs() < 0.06, "step {step}: {light} for {expected}");
    }
    assert!((light[179] - 1.0).abs() < 1e-3, "{}", light[179]);
}

#[test]
fn a_rigid_grabbed_by_its_end_hangs_from_it() {
    let mut rigids = Rigids::new();
    let rod = RigidShape::Cuboid {
        half_extents: [0.5, 0.03, 0.03],
    };
    rigids
        .add(rigid(RigidKind::Dynamic, rod, Pose::at(Vector::ZERO)))
        .unwrap();
    rigids.advance(DT);
    rigids.drag(0, grab([0.5, 0.0, 0.0], [0.5, 2.0, 0.0])).unwrap();
    for step in 0..1200 {
        rigids.advance(DT);
        let pose = &rigids.poses()[7..14];
        assert!(
            pose.iter().all(|number| number.is_finite() && number.abs() < 5.0),
            "step {step}: {pose:?}"
        );
        if step > 150 {
            let at = Pose {
                position: Vector::new(pose[0], pose[1], pose[2]),
                rotation: [pose[3], pose[4], pose[5], pose[6]],
            };
            let end = sim::math::pose::Frame::new(&at).world_from_local(Vector::new(0.5, 0.0, 0.0));
            let off = (end - Vector::new(0.5, 2.0, 0.0)).length();
            assert!(off < 0.05, "step {step}: {off}");
            let hangs = (at.position - Vector::new(0.5, 1.5, 0.0)).length();
            assert!(step < 600 || hangs < 0.02, "step {step}: {at:?}");
        }
    }
}

#[test]
fn a_drag_is_restored_and_invalid_drags_are_errors() {
    let mut rigids = Rigids::new();
    let ball = RigidShape::Ball { radius: 0.2 };
    for (k, kind) in [RigidKind::Kinematic, RigidKind::Dynamic, RigidKind::Fixed]
        .into_iter()
        .enumerate()
    {
        rigids
            .add(rigid(kind, ball.clone(), Pose::at(Vector::Y * k as f32)))
            .unwrap();
    }
    for index in 0..2 {
        rigids.drag(index, grab([0.1, 0.0, 0.0], [2.0, 1.0, 0.0])).unwrap();
    }
    (0..7).for_each(|_| rigids.advance(DT));
    let mut twin = Rigids::restore(&rigids.save()).unwrap();
    (0..20).for_each(|_| rigids.advance(DT));
    (0..20).for_each(|_| twin.advance(DT));
    assert!(rigids.save() == twin.save());
    for (anchor, target, stiffness, key) in [
        ([f32::NAN, 0.0, 0.0], [0.0; 3], 1.0, "rigid.drag.anchor.x"),
        ([0.0; 3], [0.0, 0.0, 1e9], 1.0, "rigid.drag.target.z"),
        ([0.0; 3], [0.0; 3], 0.0, "rigid.drag.stiffness"),
    ] {
        assert_eq!(Grab::from_numbers(anchor, target, stiffness).unwrap_err().key, key);
    }
    let grab = grab([0.0; 3], [0.0; 3]);
    assert_eq!(rigids.drag(2, grab).unwrap_err().key, "rigid.index");
    assert_eq!(rigids.drag(9, grab).unwrap_err().key, "rigid.index");
    assert_eq!(rigids.release(9).unwrap_err().key, "rigid.index");
}
