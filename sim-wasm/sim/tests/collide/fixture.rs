//! The scenario of `collide_fixture.txt`, natively; WASM must produce the same hashes.

use sim::Simulator;

const FIXTURE: &str = include_str!("../collide_fixture.txt");

fn lines(word: &str) -> impl Iterator<Item = &'static str> {
    FIXTURE
        .lines()
        .filter_map(move |line| line.strip_prefix(word))
        .map(str::trim)
}

fn number<T: std::str::FromStr<Err: std::fmt::Debug>>(word: &str) -> T {
    lines(word).next().unwrap().parse().unwrap()
}

fn simulator() -> Simulator {
    let mut simulator = Simulator::new(number("capacity"), number("seed")).unwrap();
    for line in lines("set ") {
        let (key, value) = line.split_once(' ').unwrap();
        simulator.set(key, value.parse().unwrap()).unwrap();
    }
    simulator
}

fn expected(which: &str) -> &'static str {
    lines("hash ").find_map(|line| line.strip_prefix(which)).unwrap().trim()
}

fn check(simulator: &Simulator, which: &str) {
    assert!(
        simulator.alive() > 1000,
        "a scenario with smoke in it: {}",
        simulator.alive()
    );
    assert_eq!(format!("{:016x}", simulator.hash()), expected(which), "{which}");
}

/// Runs in both builds, with the feature `rigids` and without: an unused Rapier changes nothing.
#[test]
fn hash_without_rigids() {
    let mut simulator = simulator();
    (0..number("steps")).for_each(|_: u32| simulator.step());
    check(&simulator, "without rigids");
}

/// Runs in both builds.
#[test]
fn hash_with_colliders() {
    let mut simulator = simulator();
    for (index, line) in (0..).zip(lines("collider ")) {
        let numbers: Vec<f32> = line.split(' ').map(|number| number.parse().unwrap()).collect();
        simulator.set_collider(index, &numbers).unwrap();
    }
    for step in 0..number::<u16>("steps") {
        let x = f32::from(step) / 128.0;
        for index in 0..3 {
            let height = 0.75 + index as f32 * 0.5;
            simulator
                .set_collider(index, &[x - 1.0, height, 0.0, x, 0.5, 0.25, 1.0])
                .unwrap();
        }
        simulator.step();
    }
    check(&simulator, "with colliders");
}

#[cfg(feature = "rigids")]
#[test]
fn hash_with_rigids() {
    use sim::rigids::{RigidDescription, RigidKind, pose_of};

    let floats = |text: &str| -> Vec<f32> { text.split([' ', ',']).map(|part| part.parse().unwrap()).collect() };
    let mut simulator = simulator();
    for line in lines("rigid ") {
        let (form, pose) = line.split_once(" | ").unwrap();
        let parts: Vec<&str> = form.split(' ').collect();
        let (sizes, pose) = (floats(parts[2]), floats(pose));
        let kind = match parts[0] {
            "0" => RigidKind::Fixed,
            "1" => RigidKind::Kinematic,
            _ => RigidKind::Dynamic,
        };
        let description = RigidDescription {
            restitution: 0.1,
            friction: 0.3,
            density: 500.0,
            ..RigidDescription::new(kind, shape(parts[1], &sizes), pose_of(&pose).unwrap())
        };
        simulator.rigids_mut().add(description).unwrap();
    }
    for step in 0..number::<u16>("steps") {
        // A power of two is exact in every number format on the way.
        let x = -1.0 + f32::from(step) / 128.0;
        let pose = pose_of(&[x, 0.75, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        simulator.rigids_mut().move_to(0, pose).unwrap();
        simulator.step();
    }
    check(&simulator, "with rigids");
}

/// A closed mesh with a boundary layer, and a sheet. Restored without them, the state has the same hash with Rapier and
/// without: in WASM the variant `meshes` has none.
#[cfg(feature = "rigids")]
#[test]
fn hash_with_meshes() {
    use sim::rigids::{RigidDescription, RigidKind, RigidShape, pose_of};

    let floats = |text: &str| -> Vec<f32> { text.split(' ').map(|part| part.parse().unwrap()).collect() };
    let mut simulator = simulator();
    for line in lines("mesh ") {
        let (layer, corners) = line.split_once(" | ").unwrap();
        let (corners, triangles) = corners.split_once(" | ").unwrap();
        let indices: Vec<u32> = triangles.split(' ').map(|part| part.parse().unwrap()).collect();
        let shape = RigidShape::Trimesh {
            vertices: floats(corners).as_chunks().0.to_vec(),
            indices: indices.as_chunks().0.to_vec(),
        };
        let description = RigidDescription {
            boundary_layer: layer.parse().unwrap(),
            ..RigidDescription::new(
                RigidKind::Kinematic,
                shape,
                pose_of(&[-1.0, 0.75, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap(),
            )
        };
        simulator.rigids_mut().add(description).unwrap();
    }
    for step in 0..number::<u16>("steps") {
        let x = f32::from(step) / 128.0;
        for index in 0..2 {
            let height = 0.75 + index as f32 * 0.5;
            let pose = pose_of(&[x - 1.0, height, 0.0, x, 0.5, 0.25, 1.0]).unwrap();
            simulator.rigids_mut().move_to(index, pose).unwrap();
        }
        simulator.step();
    }
    simulator.restore_with(&simulator.save(), false).unwrap();
    check(&simulator, "with meshes");
}

#[cfg(feature = "rigids")]
fn shape(number: &str, sizes: &[f32]) -> sim::rigids::RigidShape {
    use sim::rigids::RigidShape;

    match number {
        "0" => RigidShape::Ball { radius: sizes[0] },
        "1" => RigidShape::Cuboid {
            half_extents: [sizes[0], sizes[1], sizes[2]],
        },
        "2" => RigidShape::Capsule {
            half_height: sizes[0],
            radius: sizes[1],
        },
        _ => RigidShape::Cylinder {
            half_height: sizes[0],
            radius: sizes[1],
        },
    }
}
