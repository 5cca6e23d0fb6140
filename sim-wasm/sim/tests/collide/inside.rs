//! Particles among moving rigids of every shape never end up inside one.

use crate::collide::cloud::{Cloud, DT, excess, kinematic, random, rigid, shapes::shapes, turned};
use sim::math::pose::{Frame, Pose};
use sim::math::vector::Vector;
use sim::rigids::{RigidKind, RigidShape};

#[test]
fn none_of_1000_particles_is_ever_inside_a_moving_rigid() {
    expect_none_inside(1000);
}

#[test]
#[ignore = "takes half a minute"]
fn none_of_5000_particles_is_ever_inside_a_moving_rigid() {
    expect_none_inside(5000);
}

fn expect_none_inside(count: usize) {
    for (name, shape, distance) in shapes() {
        let mut cloud = Cloud {
            drag: 3.0,
            ..Cloud::new(count)
        };
        let rigid = cloud.rigids.add(kinematic(shape)).unwrap();
        while cloud.particles.alive() < count {
            let k = cloud.particles.alive() * 3;
            let place = Vector::new(random(k, 1), random(k, 2), random(k, 3)).unit_or(Vector::Y)
                * (1.2 + 1.5 * random(k, 4).abs());
            cloud.push(
                place.into(),
                [random(k, 5), random(k, 6), random(k, 7)],
                0.02 + 0.1 * random(k, 8).abs(),
            );
        }
        let mut touches = 0;
        for step in 0..600 {
            let time = step as f32 * DT;
            let position = Vector::new((2.0 * time).sin(), 0.8 * (3.1 * time).sin(), 1.2 * (1.3 * time).sin()) * 1.5;
            let rotation = turned(Vector::new(1.0, 0.5, 0.2 * time), 4.0 * time);
            cloud.rigids.move_to(rigid, Pose { position, rotation }).unwrap();
            cloud.step(40.0);
            let frame = Frame::new(&cloud.pose(0));
            for i in 0..count {
                let radius = cloud.particles.size[i];
                let gap = distance(frame.local_from_world(cloud.position(i)));
                assert!(
                    excess(gap, radius) <= 0.0,
                    "{name}, step {step}, particle {i}: {gap} of {radius}"
                );
                touches += usize::from(gap < radius * 1.01);
            }
        }
        assert!(touches > 10 * count, "{name} was hardly touched: {touches}");
    }
}

#[test]
fn the_grid_does_not_affect_the_result() {
    // One giant particle exceeds the margin of the grid, and a huge rigid fills every cell.
    let mut cloud = Cloud::new(301);
    for k in 0..100 {
        let pose = Pose::at(Vector::new(3.0 * random(k, 1), 3.0 * random(k, 2), 3.0 * random(k, 3)));
        cloud
            .rigids
            .add(rigid(RigidKind::Fixed, RigidShape::Ball { radius: 0.2 }, pose))
            .unwrap();
    }
    cloud
        .rigids
        .add(rigid(
            RigidKind::Fixed,
            RigidShape::Cuboid {
                half_extents: [50.0, 1.0, 50.0],
            },
            Pose::at(Vector::Y * -4.0),
        ))
        .unwrap();
    for k in 0..300 {
        cloud.push(
            [3.0 * random(k, 4), 3.0 * random(k, 5), 3.0 * random(k, 6)],
            [0.0; 3],
            0.05,
        );
    }
    cloud.push([0.0, 20.0, 0.0], [0.0, -40.0, 0.0], 2.0);
    for _ in 0..60 {
        cloud.step(2.0);
    }
    for i in 0..300 {
        let at = cloud.position(i);
        let overlap = |rigid: usize| 0.25 - (at - cloud.pose(rigid).position).length();
        let pinched = (0..100).filter(|&rigid| overlap(rigid) > -0.01).count() > 1 || at.y < -2.9;
        let deepest = (0..100).map(overlap).fold(f32::MIN, f32::max);
        assert!(pinched || deepest <= 0.0025, "{i}: {deepest}");
        assert!(at.y > -3.0, "{i} went into the ground");
    }
}
