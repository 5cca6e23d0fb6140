//! The conservative test never misses a collision of the exact one, and avoids most exact tests.

use sim::collide::contact::{Material, Obstacle, Pass, Traveller};
use sim::collide::shapes::{Ball, Capsule, Collider, Cuboid, Cylinder};
use sim::math::pose::Pose;
use sim::math::pose_motion::PoseMotion;
use sim::math::random::Random;
use sim::math::vector::Vector;

const ROUNDS: usize = 200_000;

fn vector(random: &mut Random, size: f32) -> Vector {
    Vector::new(random.signed(), random.signed(), random.signed()) * size
}

fn pose(random: &mut Random, size: f32) -> Pose {
    let axis = vector(random, 1.0).unit_or(Vector::Y);
    Pose::along(vector(random, size), axis)
}

/// Moves and rotates by up to `speed` (m and rad).
fn obstacle<C: Collider + std::fmt::Debug>(shape: C, random: &mut Random, speed: f32) -> Obstacle<C> {
    let start = pose(random, 0.2);
    let end = start.towards(&pose(random, 0.2), speed);
    let motion = PoseMotion::between(start, end, 1.0 / 60.0, shape.is_round());
    Obstacle {
        core: shape.core(),
        bounds: motion.bounds_of(&shape.bounds()),
        motion,
        material: Material {
            restitution: 0.3,
            friction: 0.2,
            roughness: 0.0,
            action: sim::collide::contact::Action::Bounce,
        },
        shape,
    }
}

/// Number of rounds that passed, and of those without contact.
fn passed_and_free<C: Collider + std::fmt::Debug>(shape: impl Fn(&mut Random) -> C, speed: f32) -> (usize, usize) {
    let mut random = Random::new(3);
    let (mut passed, mut free) = (0, 0);
    for round in 0..ROUNDS {
        let shape = shape(&mut random);
        let obstacle = obstacle(shape, &mut random, speed);
        let from = vector(&mut random, 0.7);
        let to = from + vector(&mut random, 0.1 + speed);
        let mut traveller = Traveller {
            from,
            to,
            velocity: (to - from) * 60.0,
            radius: 0.05 + 0.04 * random.signed(),
            margin: 0.0,
            began: 0.0,
        };
        let passes = obstacle
            .core
            .is_certainly_missed_by(&obstacle.motion, from, to, traveller.radius);
        let before = traveller;
        let touches = obstacle.meet(&mut traveller, Pass::First);
        assert!(!(passes && touches), "round {round}: {before:?} meets {obstacle:?}");
        passed += usize::from(passes);
        free += usize::from(!touches);
    }
    (passed, free)
}

fn check<C: Collider + std::fmt::Debug>(name: &str, shape: impl Fn(&mut Random) -> C) {
    for speed in [0.0, 0.05, 0.5] {
        let (passed, free) = passed_and_free(&shape, speed);
        assert!(free > ROUNDS / 4, "{name} leaves {free} free");
        if speed < 0.1 {
            assert!(passed as f32 > 0.9 * free as f32, "{name}: {passed} passed of {free}");
        }
    }
}

fn length(random: &mut Random) -> f32 {
    0.15 + 0.1 * random.signed()
}

#[test]
fn balls() {
    check("ball", |random| Ball { radius: length(random) });
}

#[test]
fn boxes() {
    check("cuboid", |random| Cuboid {
        half_extents: Vector::new(length(random), length(random), length(random)),
    });
}

#[test]
fn capsules() {
    check("capsule", |random| Capsule {
        half_height: length(random),
        radius: length(random),
    });
}

#[test]
fn cylinders() {
    check("cylinder", |random| Cylinder {
        half_height: length(random),
        radius: length(random),
    });
}

/// A shape without a core: its bounding box must contain it in every pose.
#[test]
fn shapes_known_by_their_box() {
    struct Aside(Ball);
    impl Collider for Aside {
        fn nearest(&self, point: Vector, limit: f32) -> sim::collide::shapes::Nearest {
            self.0.nearest(point - Vector::Y * 0.3, limit)
        }
        fn bounds(&self) -> sim::math::bounds::Bounds {
            let centre = Vector::Y * 0.3;
            sim::math::bounds::Bounds::of_way(centre, centre, self.0.radius)
        }
    }
    impl std::fmt::Debug for Aside {
        fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            self.0.fmt(formatter)
        }
    }
    let aside = |random: &mut Random| Aside(Ball { radius: length(random) });
    for speed in [0.0, 0.05, 0.5] {
        let (passed, free) = passed_and_free(aside, speed);
        assert!(passed > ROUNDS / 8 && free > passed, "{passed} passed of {free}");
    }
}
