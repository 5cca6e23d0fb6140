//! The grid is built from a sample of the particles; all of them find their rigids.

use crate::collide::cloud::{Cloud, kinematic, rigid};
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::rigids::{RigidKind, RigidShape};

const RADIUS: f32 = 0.05;

fn ball(x: f32) -> sim::rigids::RigidDescription {
    let pose = Pose::at(Vector::new(x, 0.0, 0.0));
    rigid(RigidKind::Fixed, RigidShape::Ball { radius: 0.2 }, pose)
}

/// Four of every 32 particles are far from the rest, at each possible offset from the sample.
#[test]
fn particles_outside_of_the_sample_are_pushed_out_too() {
    for odd_block in 0..8 {
        let mut cloud = Cloud::new(320);
        cloud.rigids.add(kinematic(RigidShape::Ball { radius: 0.2 })).unwrap();
        for x in [5.0, 40.0] {
            cloud.rigids.add(ball(x)).unwrap();
        }
        for i in 0..320 {
            let x = if i / 4 % 8 == odd_block { 40.0 } else { 5.0 };
            let height = 0.1 + 1e-4 * i as f32;
            cloud.push([x, height, 0.0], [0.0; 3], RADIUS);
        }
        cloud.step(0.0);
        for i in 0..320 {
            let Vector { x, y, .. } = cloud.position(i);
            let place = if x > 20.0 { x - 40.0 } else { x - 5.0 };
            let distance = (place * place + y * y).sqrt() - 0.2;
            assert!((distance - RADIUS).abs() < 1e-3, "particle {i} at {x}, {y}: {distance}");
        }
    }
}
