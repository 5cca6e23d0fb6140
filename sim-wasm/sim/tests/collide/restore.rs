//! Rigids as flat numbers and saved bytes: round trips, damage, invalid numbers.

use crate::collide::cloud::{Cloud, DT, kinematic, random, rigid, shapes::shapes, turned};
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::rigids::{RigidDescription, RigidKind, RigidNumbers, RigidPart, RigidShape, Rigids};
use sim::simulator::collisions::Scratch;

/// A heap: dynamic rigids of every shape fall on the ground, and a kinematic ball moves through it.
fn heap() -> Cloud {
    let mut cloud = Cloud::new(400);
    let ground = RigidShape::Cuboid {
        half_extents: [5.0, 0.5, 5.0],
    };
    cloud
        .rigids
        .add(rigid(RigidKind::Fixed, ground, Pose::at(Vector::Y * -0.5)))
        .unwrap();
    cloud.rigids.add(kinematic(RigidShape::Ball { radius: 0.3 })).unwrap();
    for (k, (_, shape, _)) in shapes().into_iter().enumerate() {
        let pose = Pose {
            position: Vector::new(0.1 * k as f32, 1.0 + k as f32, 0.0),
            rotation: turned(Vector::Y, k as f32),
        };
        cloud.rigids.add(rigid(RigidKind::Dynamic, shape, pose)).unwrap();
    }
    for k in 0..400 {
        cloud.push([random(k, 1), 1.0 + random(k, 2), random(k, 3)], [0.0; 3], 0.05);
    }
    cloud
}

fn run_heap(cloud: &mut Cloud, steps: std::ops::Range<usize>) {
    for step in steps {
        let x = 2.0 - 0.02 * step as f32;
        cloud.rigids.move_to(1, Pose::at(Vector::new(x, 0.4, 0.0))).unwrap();
        cloud.step(1.0);
    }
}

fn hash_of(cloud: &Cloud) -> u64 {
    let mut hash = sim::math::hash::Hash::new();
    for column in cloud.particles.float_columns() {
        hash.floats(column);
    }
    cloud.rigids.hash_into(&mut hash);
    hash.finish()
}

#[test]
fn a_restored_heap_continues_to_the_same_hash() {
    let mut cloud = heap();
    run_heap(&mut cloud, 0..90);
    let bytes = cloud.rigids.save();
    let mut twin = Cloud {
        particles: cloud.particles.clone(),
        rigids: Rigids::restore(&bytes).unwrap(),
        scratch: Scratch::new(400),
        drag: 0.0,
    };
    assert_eq!(hash_of(&twin), hash_of(&cloud), "as restored");
    let again = twin.rigids.save();
    assert!(again == bytes, "saved again");
    run_heap(&mut cloud, 90..200);
    run_heap(&mut twin, 90..200);
    assert_eq!(hash_of(&twin), hash_of(&cloud), "110 steps later");
}

#[test]
fn damaged_bytes_are_errors() {
    let mut cloud = heap();
    run_heap(&mut cloud, 0..5);
    let bytes = cloud.rigids.save();
    for cut in [1, 7, 8, 9, bytes.len() / 2, bytes.len() - 1] {
        assert!(Rigids::restore(&bytes[..cut]).is_err(), "cut at {cut}");
    }
    for place in (0..bytes.len()).step_by(997) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x10;
        assert!(Rigids::restore(&damaged).is_err(), "bit at {place}");
    }
    assert!(Rigids::restore(&[]).unwrap().count() == 0);
}

/// A number that is ordinary, zero, tiny, huge or not finite.
fn odd(k: usize, salt: usize) -> f32 {
    match (random(k, salt) * 64.0) as i32 {
        0 => 0.0,
        1 => f32::NAN,
        2 => f32::INFINITY,
        3 => 1e-30,
        4 => 1e30,
        5 => -1.0,
        _ => random(k, salt + 1000),
    }
}

#[test]
fn no_description_makes_the_world_panic_or_move_to_nowhere() {
    let mut taken = 0;
    for k in 0..3000 {
        let flat = k % 5 == 0;
        let vertices: Vec<f32> = (0..3 * (k % 12))
            .map(|place| {
                if flat && place % 3 == 1 {
                    0.5
                } else {
                    odd(k, 10 + place)
                }
            })
            .collect();
        let indices: Vec<u32> = (0..k % 30)
            .map(|place| (random(k, 100 + place).abs() * 9.0) as u32)
            .collect();
        let dimensions: Vec<f32> = (0..k % 4).map(|place| odd(k, 200 + place).abs()).collect();
        let part = |shape: usize| {
            let counts = [shape, dimensions.len(), vertices.len(), indices.len()].map(|count| count as f32);
            let pose = (0..7).map(|place| random(k, 400 + place));
            counts
                .into_iter()
                .chain(pose)
                .chain(dimensions.clone())
                .collect::<Vec<f32>>()
        };
        let compound = k % 2;
        let mut numbers = vec![(k % 3) as f32];
        numbers.extend((0..7).map(|place| random(k, 300 + place)));
        numbers.extend([
            0.5,
            0.5,
            100.0,
            (k % 3) as f32,
            (1 + k % 15) as f32,
            0.1,
            1.0,
            compound as f32,
        ]);
        numbers.extend(part(k / 3 % 7));
        let numbers = RigidNumbers {
            numbers: &numbers,
            vertices: &vertices,
            indices: &indices,
        };
        let mut rigids = Rigids::new();
        let Ok(description) = RigidDescription::from_numbers(&numbers) else {
            continue;
        };
        if rigids.add(description).is_ok() {
            taken += 1;
            (0..3).for_each(|_| rigids.advance(DT));
            assert!(rigids.poses().iter().all(|number| number.is_finite()), "{numbers:?}");
        }
    }
    assert!(taken > 200, "only {taken} were ever taken");
}

#[test]
fn numbers_that_end_too_early_are_rejected() {
    let compound = RigidShape::Compound {
        parts: shapes()
            .into_iter()
            .map(|(_, shape, _)| RigidPart {
                shape,
                pose: Pose::at(Vector::Y),
            })
            .collect(),
    };
    let description = kinematic(compound);
    let flat = description.to_numbers();
    let read = |numbers: usize, vertices: usize, indices: usize| {
        RigidDescription::from_numbers(&RigidNumbers {
            numbers: &flat.numbers[..numbers],
            vertices: &flat.vertices[..vertices],
            indices: &flat.indices[..indices],
        })
    };
    let [numbers, vertices, indices] = [flat.numbers.len(), flat.vertices.len(), flat.indices.len()];
    assert_eq!(
        read(numbers, vertices, indices),
        Ok(description.clone()),
        "there and back"
    );
    for short in 0..numbers {
        assert!(read(short, vertices, indices).is_err(), "{short} numbers");
    }
    assert!(read(numbers, vertices - 1, indices).is_err());
    assert!(read(numbers, vertices, indices - 1).is_err());
}
