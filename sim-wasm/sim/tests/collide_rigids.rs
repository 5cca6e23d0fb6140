//! Particles among moving rigids: pushed, never inside, never through.
#![cfg(feature = "rigids")]

use sim::collide::space::{Frame, Pose, Vector};
use sim::collide::{Scratch, resolve};
use sim::life::RadiusLaw;
use sim::particles::{Newborn, Particles};
use sim::rigids::{POSE_PAIR_FLOATS, RigidDescription, RigidKind, RigidShape, Rigids, TOP_SPEED};

const DT: f32 = 1.0 / 60.0;
const RADII: RadiusLaw = RadiusLaw {
    puff_size: 1.0,
    growth_time: 0.0,
};
const LIFETIME: f32 = 1e9;

/// A cloud in still air, with the velocity of each particle in its slip.
struct Cloud {
    particles: Particles,
    rigids: Rigids,
    scratch: Scratch,
    /// 1/s.
    drag: f32,
}

impl Cloud {
    fn new(count: usize) -> Self {
        Self {
            particles: Particles::new(count),
            rigids: Rigids::new(),
            scratch: Scratch::new(count),
            drag: 0.0,
        }
    }

    fn push(&mut self, position: [f32; 3], slip: [f32; 3], size: f32) {
        let newborn = Newborn {
            position,
            slip,
            age: 0.0,
            lifetime: LIFETIME,
            size,
            temperature: 0.0,
            look: 0,
        };
        assert!(self.particles.push(&newborn));
    }

    /// `pull`: a constant acceleration (m/s2) towards the first rigid.
    fn step(&mut self, pull: f32) {
        let centre = self.pose(0).position;
        self.rigids.advance(DT);
        let p = &mut self.particles;
        for i in 0..p.alive() {
            let at = Vector::new(p.x[i], p.y[i], p.z[i]);
            let change = (centre - at).unit_or(Vector::Y) * (pull * DT);
            [p.px[i], p.py[i], p.pz[i]] = at.into();
            let keep = 1.0 - self.drag * DT;
            (p.sx[i], p.sy[i], p.sz[i]) = (
                p.sx[i] * keep + change.x,
                p.sy[i] * keep + change.y,
                p.sz[i] * keep + change.z,
            );
            (p.x[i], p.y[i], p.z[i]) = (at.x + p.sx[i] * DT, at.y + p.sy[i] * DT, at.z + p.sz[i] * DT);
        }
        resolve(p, &RADII, &[], &mut self.rigids, DT, &mut self.scratch);
    }

    fn position(&self, i: usize) -> Vector {
        Vector::new(self.particles.x[i], self.particles.y[i], self.particles.z[i])
    }

    fn pose(&self, rigid: usize) -> Pose {
        let floats = &self.rigids.poses()[rigid * POSE_PAIR_FLOATS + 7..][..7];
        Pose {
            position: Vector::new(floats[0], floats[1], floats[2]),
            rotation: [floats[3], floats[4], floats[5], floats[6]],
        }
    }
}

fn rigid(kind: RigidKind, shape: RigidShape, pose: Pose) -> RigidDescription {
    RigidDescription {
        kind,
        shape,
        pose,
        restitution: 0.1,
        friction: 0.2,
        density: 500.0,
    }
}

fn kinematic(shape: RigidShape) -> RigidDescription {
    rigid(RigidKind::Kinematic, shape, Pose::at(Vector::ZERO))
}

/// Numbers in -1..1 without a pattern.
fn random(k: usize, salt: usize) -> f32 {
    let mixed = (k as u32).wrapping_mul(0x9e37_79b9) ^ (salt as u32).wrapping_mul(0x85eb_ca6b);
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2c1b_3c6d);
    (mixed >> 8) as f32 / 8_388_608.0 - 1.0
}

fn turned(axis: Vector, angle: f32) -> [f32; 4] {
    let axis = axis.unit_or(Vector::Y) * (angle / 2.0).sin();
    [axis.x, axis.y, axis.z, (angle / 2.0).cos()]
}

fn box_vertices(centre: [f32; 3], half: [f32; 3]) -> Vec<[f32; 3]> {
    (0..8)
        .map(|corner| {
            std::array::from_fn(|axis| {
                centre[axis]
                    + if corner >> axis & 1 == 1 {
                        half[axis]
                    } else {
                        -half[axis]
                    }
            })
        })
        .collect()
}

const BOX_TRIANGLES: [[u32; 3]; 12] = [
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
];

/// Two boxes as one mesh of two closed parts, which do not touch.
fn two_boxes() -> RigidShape {
    let mut vertices = box_vertices([-0.5, 0.0, 0.0], [0.2, 0.3, 0.4]);
    vertices.extend(box_vertices([0.6, 0.1, 0.0], [0.25, 0.15, 0.3]));
    let mut indices = BOX_TRIANGLES.to_vec();
    indices.extend(BOX_TRIANGLES.map(|triangle| triangle.map(|corner| corner + 8)));
    RigidShape::Trimesh { vertices, indices }
}

type Measure = fn(Vector) -> f32;

/// Each shape with its distance outside, by formulas that share nothing with the simulator's.
fn shapes() -> [(&'static str, RigidShape, Measure); 6] {
    fn gap(part: f32, half: f32) -> f32 {
        (part.abs() - half).max(0.0)
    }
    fn box_gap(p: Vector, centre: [f32; 3], half: [f32; 3]) -> f32 {
        Vector::new(
            gap(p.x - centre[0], half[0]),
            gap(p.y - centre[1], half[1]),
            gap(p.z - centre[2], half[2]),
        )
        .length()
    }
    [
        ("ball", RigidShape::Ball { radius: 0.5 }, |p| p.length() - 0.5),
        (
            "cuboid",
            RigidShape::Cuboid {
                half_extents: [0.7, 0.2, 0.4],
            },
            |p| box_gap(p, [0.0; 3], [0.7, 0.2, 0.4]),
        ),
        (
            "capsule",
            RigidShape::Capsule {
                half_height: 0.6,
                radius: 0.2,
            },
            |p| Vector::new(p.x, gap(p.y, 0.6), p.z).length() - 0.2,
        ),
        (
            "cylinder",
            RigidShape::Cylinder {
                half_height: 0.3,
                radius: 0.5,
            },
            |p| Vector::new(gap((p.x * p.x + p.z * p.z).sqrt(), 0.5), gap(p.y, 0.3), 0.0).length(),
        ),
        (
            "hull",
            RigidShape::ConvexHull {
                vertices: box_vertices([0.0; 3], [0.5, 0.6, 0.3]),
            },
            |p| box_gap(p, [0.0; 3], [0.5, 0.6, 0.3]),
        ),
        ("trimesh", two_boxes(), |p| {
            box_gap(p, [-0.5, 0.0, 0.0], [0.2, 0.3, 0.4]).min(box_gap(p, [0.6, 0.1, 0.0], [0.25, 0.15, 0.3]))
        }),
    ]
}

/// How far a particle is inside beyond what is allowed: 5 % of its radius or 1 mm.
fn excess(distance: f32, radius: f32) -> f32 {
    radius - distance - (0.05 * radius).max(0.001)
}

#[test]
fn none_of_5000_particles_is_ever_inside_a_moving_rigid() {
    for (name, shape, distance) in shapes() {
        let mut cloud = Cloud {
            drag: 3.0,
            ..Cloud::new(5000)
        };
        let rigid = cloud.rigids.add(kinematic(shape)).unwrap();
        while cloud.particles.alive() < 5000 {
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
            for i in 0..5000 {
                let radius = cloud.particles.size[i];
                let gap = distance(frame.local_from_world(cloud.position(i)));
                assert!(
                    excess(gap, radius) <= 0.0,
                    "{name}, step {step}, particle {i}: {gap} of {radius}"
                );
                touches += u32::from(gap < radius * 1.01);
            }
        }
        assert!(touches > 50_000, "{name} was hardly touched: {touches}");
    }
}

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

/// A heap: every shape, dynamic, falls on the ground; a kinematic ball goes through it.
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
    let mut hash = sim::hash::Hash::new();
    for column in cloud.particles.float_columns() {
        hash.floats(column);
    }
    cloud.rigids.hash_into(&mut hash);
    hash.finish()
}

#[test]
fn a_restored_heap_goes_on_to_the_same_hash() {
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
    eprintln!(
        "DBG {} {} {:?}",
        again.len(),
        bytes.len(),
        again
            .iter()
            .zip(&bytes)
            .enumerate()
            .filter(|(_, (a, b))| a != b)
            .map(|(i, (a, b))| (i, *a, *b))
            .take(40)
            .collect::<Vec<_>>()
    );
    assert!(again == bytes, "saved again");
    run_heap(&mut cloud, 90..200);
    run_heap(&mut twin, 90..200);
    assert_eq!(hash_of(&twin), hash_of(&cloud), "110 steps later");
}

#[test]
fn damaged_bytes_are_refused() {
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

#[test]
fn what_is_near_does_not_depend_on_how_it_is_found() {
    // One giant among the particles makes the grid's margin too small for itself, and a huge rigid fills every cell.
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
