//! Rigids on the move: they push, drag along and let nothing through.
#![cfg(feature = "rigids")]

mod collide_cloud;

use collide_cloud::{Cloud, DT, excess, kinematic, random, rigid, turned};
use sim::collide::space::{Pose, Vector};
use sim::rigids::{POSE_PAIR_FLOATS, RigidDescription, RigidKind, RigidShape, Rigids, TOP_SPEED};

fn sheet() -> RigidShape {
    RigidShape::Trimesh {
        vertices: vec![[-9.0, 0.0, -9.0], [9.0, 0.0, -9.0], [9.0, 0.0, 9.0], [-9.0, 0.0, 9.0]],
        indices: vec![[0, 2, 1], [0, 3, 2]],
    }
}

fn plate() -> RigidShape {
    RigidShape::Cuboid {
        half_extents: [9.0, 0.01, 9.0],
    }
}

#[test]
fn nothing_gets_through_a_thin_plate_at_20_metres_a_second() {
    for shape in [plate(), sheet()] {
        for direction in [1.0, -1.0] {
            let mut cloud = Cloud::new(1000);
            let rigid = cloud.rigids.add(kinematic(shape.clone())).unwrap();
            for k in 0..1000 {
                let height = direction * (0.5 + 3.0 * random(k, 1).abs());
                cloud.push(
                    [random(k, 2), height, random(k, 3)],
                    [0.0; 3],
                    0.005 + 0.2 * random(k, 4).abs(),
                );
            }
            for step in 1..=60 {
                let position = Vector::Y * (direction * TOP_SPEED * DT * step as f32);
                cloud.rigids.move_to(rigid, Pose::at(position)).unwrap();
                cloud.step(0.0);
                let reached = cloud.pose(0).position.y;
                assert!((reached - position.y).abs() < 1e-3, "the plate is late: {reached}");
                for i in 0..1000 {
                    let gap = (cloud.position(i).y - reached) * direction;
                    let begin = 0.5 - 0.01;
                    assert!(gap > 0.0, "step {step}, particle {i} is through: {gap}");
                    assert!(
                        excess(gap, cloud.particles.size[i].min(begin)) <= 0.02,
                        "step {step}, {i}: {gap}"
                    );
                }
            }
        }
    }
}

#[test]
fn nothing_gets_through_a_fixed_plate_at_50_metres_a_second() {
    for shape in [plate(), sheet()] {
        for side in [1.0, -1.0] {
            let mut cloud = Cloud::new(1000);
            cloud
                .rigids
                .add(rigid(RigidKind::Fixed, shape.clone(), Pose::at(Vector::ZERO)))
                .unwrap();
            for k in 0..1000 {
                let velocity = [4.0 * random(k, 1), -50.0 * side, 4.0 * random(k, 2)];
                let height = side * (0.3 + 2.0 * random(k, 3).abs());
                cloud.push(
                    [random(k, 4), height, random(k, 5)],
                    velocity,
                    0.005 + 0.2 * random(k, 6).abs(),
                );
            }
            for step in 0..20 {
                cloud.step(0.0);
                for i in 0..1000 {
                    assert!(cloud.position(i).y * side > 0.0, "step {step}, particle {i} is through");
                }
            }
        }
    }
}

#[test]
fn a_spinning_blade_does_not_touch_what_is_beside_its_disc_and_lets_nothing_through_it() {
    let mut cloud = Cloud::new(2000);
    let blade = RigidShape::Cuboid {
        half_extents: [0.5, 0.2, 0.01],
    };
    let rigid = cloud.rigids.add(kinematic(blade)).unwrap();
    for k in 0..1000 {
        let angle = 3.2 * random(k, 1);
        // In the first thousand what the blade sweeps, in the second what lies just outside of its tips.
        let inner = 0.2 + 0.2 * random(k, 2).abs();
        cloud.push(
            [inner * angle.cos(), 0.1 * random(k, 3), inner * angle.sin()],
            [0.0; 3],
            0.01,
        );
    }
    for k in 0..1000 {
        let angle = 3.2 * random(k, 1);
        cloud.push([0.53 * angle.cos(), 0.0, 0.53 * angle.sin()], [0.0; 3], 0.01);
    }
    for step in 1..=10 {
        let angle = 39.0 * DT * step as f32;
        cloud
            .rigids
            .move_to(
                rigid,
                Pose {
                    position: Vector::ZERO,
                    rotation: turned(Vector::Y, angle),
                },
            )
            .unwrap();
        cloud.step(0.0);
    }
    let moved = (1000..2000).filter(|&i| cloud.particles.sx[i] != 0.0).count();
    assert_eq!(moved, 0, "beside the disc");
    let swept = (0..1000).filter(|&i| cloud.particles.sx[i] != 0.0).count();
    assert_eq!(swept, 1000, "in the disc");
}

#[test]
fn a_kinematic_ball_pushes() {
    let mut cloud = Cloud::new(1);
    let rigid = cloud
        .rigids
        .add(RigidDescription {
            restitution: 0.0,
            ..kinematic(RigidShape::Ball { radius: 0.5 })
        })
        .unwrap();
    cloud.push([0.65, 0.0, 0.0], [0.0; 3], 0.1);
    for step in 1..=10 {
        cloud
            .rigids
            .move_to(rigid, Pose::at(Vector::new(0.05 * step as f32, 0.0, 0.0)))
            .unwrap();
        cloud.step(0.0);
    }
    assert!(
        (cloud.particles.sx[0] - 3.0).abs() < 1e-3,
        "as fast as the ball: {}",
        cloud.particles.sx[0]
    );
    assert!(
        (cloud.position(0).x - 1.1).abs() < 2e-3,
        "on its surface: {:?}",
        cloud.position(0)
    );
}

#[test]
fn a_spinning_ball_drags_along_by_friction() {
    let mut cloud = Cloud::new(1);
    let ball = RigidDescription {
        friction: 1.0,
        ..kinematic(RigidShape::Ball { radius: 0.5 })
    };
    let rigid = cloud.rigids.add(ball).unwrap();
    cloud.push([0.6, 0.0, 0.0], [-1.0, 0.0, 0.0], 0.1);
    cloud
        .rigids
        .move_to(
            rigid,
            Pose {
                position: Vector::ZERO,
                rotation: turned(Vector::Y, 6.0 * DT),
            },
        )
        .unwrap();
    cloud.step(0.0);
    // About y by 6 rad/s: at a point 0.6 m along x (the particle's centre) the velocity is 3.6 m/s along -z.
    assert!((cloud.particles.sz[0] + 3.6).abs() < 0.1, "{}", cloud.particles.sz[0]);
}

#[test]
fn a_kinematic_rigid_never_moves_faster_than_its_limit() {
    let mut cloud = Cloud::new(1);
    let rigid = cloud.rigids.add(kinematic(RigidShape::Ball { radius: 0.5 })).unwrap();
    cloud
        .rigids
        .move_to(rigid, Pose::at(Vector::new(3.0, 0.0, 0.0)))
        .unwrap();
    let mut before = 0.0;
    for _ in 0..9 {
        cloud.rigids.advance(DT);
        let now = cloud.pose(0).position.x;
        assert!(now - before <= TOP_SPEED * DT * 1.0001, "{before} to {now}");
        before = now;
    }
    assert!((before - 3.0).abs() < 1e-5, "it arrives: {before}");
}

#[test]
fn dynamic_rigids_fall_with_closed_form_and_rest_on_fixed_ones() {
    let mut rigids = Rigids::new();
    let ground = RigidShape::Cuboid {
        half_extents: [5.0, 0.5, 5.0],
    };
    rigids
        .add(rigid(RigidKind::Fixed, ground, Pose::at(Vector::Y * -0.5)))
        .unwrap();
    rigids
        .add(rigid(
            RigidKind::Dynamic,
            RigidShape::Ball { radius: 0.2 },
            Pose::at(Vector::Y * 3.0),
        ))
        .unwrap();
    for _ in 0..30 {
        rigids.advance(DT);
    }
    let fallen = 3.0 - rigids.poses()[POSE_PAIR_FLOATS + 8];
    assert!((fallen - 0.5 * 9.81 * 0.25).abs() < 0.05, "{fallen}");
    for _ in 0..300 {
        rigids.advance(DT);
    }
    let height = rigids.poses()[POSE_PAIR_FLOATS + 8];
    assert!((height - 0.2).abs() < 0.01, "{height}");
}
