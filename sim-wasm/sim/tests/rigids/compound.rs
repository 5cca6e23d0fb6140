//! Compounds: several shapes that move as one rigid.

use crate::collide::cloud::{Cloud, DT, kinematic, random, rigid, shapes::shapes, turned};
use sim::math::pose::{Frame, Pose};
use sim::math::vector::Vector;
use sim::rigids::{POSE_PAIR_FLOATS, RigidKind, RigidPart, RigidShape, Rigids};

fn part(shape: RigidShape, position: [f32; 3], angle: f32) -> RigidPart {
    let pose = Pose {
        position: Vector::from(position),
        rotation: turned(Vector::new(1.0, 0.5, 0.2), angle),
    };
    RigidPart { shape, pose }
}

/// One part of each shape, so far apart that no particle collides with two of them.
fn scattered() -> Vec<RigidPart> {
    let place = |k: usize| [3.0 * (k % 3) as f32, 3.0 * (k / 3) as f32, 0.5 * k as f32];
    let parts = shapes().into_iter().enumerate();
    parts
        .map(|(k, (_, shape, _))| part(shape, place(k), 0.7 * k as f32))
        .collect()
}

fn within(outer: &Pose, inner: &Pose) -> Pose {
    let [a, b] = [outer.rotation, inner.rotation];
    let (u, v) = (Vector::new(a[0], a[1], a[2]), Vector::new(b[0], b[1], b[2]));
    let axis = v * a[3] + u * b[3] + u.cross(v);
    Pose {
        position: Frame::new(outer).world_from_local(inner.position),
        rotation: [axis.x, axis.y, axis.z, a[3] * b[3] - u.dot(v)],
    }
}

/// Particles around every part that fly towards it.
fn shower(cloud: &mut Cloud, outer: &Pose) {
    for k in 0..900 {
        let centre = within(outer, &scattered()[k % scattered().len()].pose).position;
        let offset = Vector::new(random(k, 1), random(k, 2), random(k, 3)).unit_or(Vector::Y) * 1.2;
        cloud.push((centre + offset).into(), (offset * -3.0).into(), 0.05);
    }
}

#[test]
fn parts_of_a_compound_meet_particles_as_rigids_of_their_own_do() {
    let outer = Pose {
        position: Vector::new(0.5, -1.0, 2.0),
        rotation: turned(Vector::new(0.3, 1.0, 0.4), 0.9),
    };
    let (mut compound, mut single) = (Cloud::new(900), Cloud::new(900));
    let shape = RigidShape::Compound { parts: scattered() };
    compound.rigids.add(rigid(RigidKind::Fixed, shape, outer)).unwrap();
    for RigidPart { shape, pose } in scattered() {
        let pose = within(&outer, &pose);
        single.rigids.add(rigid(RigidKind::Fixed, shape, pose)).unwrap();
    }
    shower(&mut compound, &outer);
    shower(&mut single, &outer);
    for _ in 0..40 {
        compound.step(0.0);
        single.step(0.0);
    }
    let moved = (0..900).filter(|&i| compound.particles.sx[i] != 0.0).count();
    assert!(moved > 800, "they hit: {moved}");
    // Rounding decides whether a particle that grazes an edge hits it.
    let apart = |i: &usize| (compound.position(*i) - single.position(*i)).length() > 5e-3;
    let differing = (0..900).filter(apart).count();
    assert!(differing < 9, "{differing} of 900 are elsewhere");
}

#[test]
fn a_compound_moves_as_one() {
    let blades = [0.0, 1.0, 2.0].map(|k: f32| {
        let angle = k * std::f32::consts::TAU / 3.0;
        RigidPart {
            shape: RigidShape::Cuboid {
                half_extents: [0.4, 0.1, 0.02],
            },
            pose: Pose {
                position: Vector::new(0.6 * angle.cos(), 0.0, -0.6 * angle.sin()),
                rotation: turned(Vector::Y, angle),
            },
        }
    });
    let mut cloud = Cloud::new(300);
    let shape = RigidShape::Compound { parts: blades.to_vec() };
    let propeller = cloud.rigids.add(kinematic(shape)).unwrap();
    for k in 0..300 {
        let angle = 3.2 * random(k, 1);
        cloud.push([0.6 * angle.cos(), 0.0, 0.6 * angle.sin()], [0.0; 3], 0.02);
    }
    for step in 1..=30 {
        let rotation = turned(Vector::Y, 0.1 * step as f32);
        let pose = Pose {
            position: Vector::ZERO,
            rotation,
        };
        cloud.rigids.move_to(propeller, pose).unwrap();
        cloud.step(0.0);
    }
    // A third of a turn of three blades sweeps the whole disc; swept particles move with the blades, about y.
    for i in 0..300 {
        let (at, slip) = (
            cloud.position(i),
            Vector::new(cloud.particles.sx[i], 0.0, cloud.particles.sz[i]),
        );
        assert!(at.cross(slip).y > 0.0, "particle {i} was swept: {at:?} {slip:?}");
    }
}

#[test]
fn a_dynamic_compound_falls_about_its_common_centre_of_mass() {
    let ball = |radius: f32, x: f32| part(RigidShape::Ball { radius }, [x, 0.0, 0.0], 0.0);
    let mut rigids = Rigids::new();
    // Masses 8 to 1: the centre of mass is a ninth of the way from the large ball to the small one.
    let shape = RigidShape::Compound {
        parts: vec![ball(0.2, 0.0), ball(0.1, 0.9)],
    };
    rigids
        .add(rigid(RigidKind::Dynamic, shape, Pose::at(Vector::Y * 1.0)))
        .unwrap();
    for _ in 0..10 {
        rigids.advance(DT);
    }
    // It falls freely so far: a parabola without rotation.
    let fallen = 1.0 - rigids.poses()[8];
    let time = 10.0 * DT;
    assert!((fallen - 0.5 * 9.81 * time * time).abs() < 0.02, "{fallen}");
    assert!(rigids.poses()[10..13].iter().all(|part| part.abs() < 1e-5));
}

#[test]
fn a_compound_is_restored() {
    let shape = RigidShape::Compound { parts: scattered() };
    let mut rigids = Rigids::new();
    rigids
        .add(rigid(RigidKind::Kinematic, shape, Pose::at(Vector::Y)))
        .unwrap();
    rigids.advance(DT);
    let bytes = rigids.save();
    let mut twin = Rigids::restore(&bytes).unwrap();
    assert!(twin.save() == bytes);
    for world in [&mut rigids, &mut twin] {
        world.move_to(0, Pose::at(Vector::Y * 3.0)).unwrap();
        (0..20).for_each(|_| world.advance(DT));
    }
    assert_eq!(rigids.poses()[..POSE_PAIR_FLOATS], twin.poses()[..POSE_PAIR_FLOATS]);
}

#[test]
fn empty_and_nested_compounds_are_errors() {
    let mut rigids = Rigids::new();
    let empty = RigidShape::Compound { parts: Vec::new() };
    let nested = RigidShape::Compound {
        parts: vec![part(empty.clone(), [0.0; 3], 0.0)],
    };
    for shape in [empty, nested] {
        let error = rigids.add(kinematic(shape)).unwrap_err();
        assert_eq!(error.key, "rigid.parts");
    }
    assert_eq!(rigids.count(), 0);
}
