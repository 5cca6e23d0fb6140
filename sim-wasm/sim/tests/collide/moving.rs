//! Moving rigids push, drag along and stop particles.

use crate::collide::cloud::{Cloud, DT, excess, kinematic, random, rigid, turned};
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::rigids::{POSE_PAIR_FLOATS, RigidDescription, RigidKind, RigidShape, Rigids, TOP_SPEED};

/// A pose at the origin, turned about y.
fn turned_by(angle: f32) -> Pose {
    Pose {
        position: Vector::ZERO,
        rotation: turned(Vector::Y, angle),
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
fn a_spinning_blade_leaves_particles_beside_its_disc_and_lets_none_through() {
    let mut cloud = Cloud::new(2000);
    let blade = RigidShape::Cuboid {
        half_extents: [0.5, 0.2, 0.01],
    };
    let rigid = cloud.rigids.add(kinematic(blade)).unwrap();
    for k in 0..1000 {
        let angle = 3.2 * random(k, 1);
        // The blade sweeps the first thousand; the second thousand are just outside its tips.
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
        cloud.rigids.move_to(rigid, turned_by(angle)).unwrap();
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
    cloud.rigids.move_to(rigid, turned_by(6.0 * DT)).unwrap();
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

/// A blade along x of half length `reach` that spins about y with a tip speed of 100 m/s, and particles that drift
/// through its disc. Beside it a sweep in closed form: in the disc's plane a blade passes over each particle within
/// half a turn, so one that needs longer to drift through must have been hit.
fn tip_at_100_metres_a_second(reach: f32) {
    const COUNT: usize = 600;
    let (height, drift) = (0.1, 2.0);
    let rate = 100.0 / reach;
    let blade = RigidShape::Cuboid {
        half_extents: [reach, height, 0.01],
    };
    let mut cloud = Cloud::new(2 * COUNT);
    let rigid = cloud.rigids.add(kinematic(blade)).unwrap();
    for k in 0..COUNT {
        let (angle, out) = (3.2 * random(k, 1), reach * (0.1 + 0.85 * random(k, 2).abs()));
        let start = -height - 0.05 - 0.3 * random(k, 3).abs();
        let (x, z) = (out * angle.cos(), out * angle.sin());
        cloud.push([x, start, z], [0.0, drift, 0.0], 0.01);
        // The second particle drifts just outside the disc.
        let outside = (reach + 0.03) / out;
        cloud.push([x * outside, start, z * outside], [0.0, drift, 0.0], 0.01);
    }
    let crossing = 2.0 * height / drift;
    assert!(crossing > std::f32::consts::PI / rate, "slow enough for half a turn");
    let mut hit = vec![false; 2 * COUNT];
    for step in 1..=40 {
        cloud.rigids.move_to(rigid, turned_by(rate * DT * step as f32)).unwrap();
        cloud.step(0.0);
        for (i, hit) in hit.iter_mut().enumerate() {
            *hit |= cloud.particles.sx[i] != 0.0 || cloud.particles.sz[i] != 0.0;
            let through = cloud.position(i).y > height + 0.011;
            assert!(
                i % 2 == 1 || *hit || !through,
                "step {step}, particle {i}, reach {reach}: not deflected"
            );
        }
    }
    assert!(
        hit.iter().step_by(2).all(|hit| *hit),
        "all that was in the disc was swept"
    );
    // Particles that the blade threw outwards cannot affect these: particles do not collide with each other.
    assert!(
        hit.iter().skip(1).step_by(2).all(|hit| !hit),
        "nothing beside the disc was touched"
    );
}

#[test]
fn a_propeller_tip_at_100_metres_a_second_deflects_all_swept_particles() {
    // A smaller one would turn by more than half a turn in a step, which poses cannot tell.
    for reach in [0.6, 1.0, 1.5] {
        tip_at_100_metres_a_second(reach);
    }
}

#[test]
fn a_blade_hits_within_one_step_exactly_the_particles_of_its_closed_form_sweep() {
    let (reach, rate) = (0.5, 100.0);
    let turn = rate * DT;
    let half_width = 0.02;
    for offset in 0..8 {
        let blade = RigidShape::Cuboid {
            half_extents: [reach, 0.2, half_width],
        };
        let mut cloud = Cloud::new(720);
        let rigid = cloud.rigids.add(kinematic(blade)).unwrap();
        for step in 1..=offset {
            cloud.rigids.move_to(rigid, turned_by(step as f32 * turn)).unwrap();
            cloud.rigids.advance(DT);
        }
        let radius = 0.005;
        for k in 0..720 {
            let angle = k as f32 * std::f32::consts::TAU / 720.0;
            cloud.push([0.4 * angle.cos(), 0.0, -0.4 * angle.sin()], [0.0; 3], radius);
        }
        cloud
            .rigids
            .move_to(rigid, turned_by((offset + 1) as f32 * turn))
            .unwrap();
        cloud.step(0.0);
        let margin = ((half_width + radius) / 0.4_f32).asin();
        for k in 0..720 {
            // Angle of the nearer half of the blade from the start of the step until its middle is here.
            let angle = k as f32 * std::f32::consts::TAU / 720.0 - offset as f32 * turn;
            let ahead = angle.rem_euclid(std::f32::consts::PI);
            let inside = ahead < turn + margin;
            let near = [turn + margin, std::f32::consts::PI - margin];
            let touched = cloud.particles.sx[k] != 0.0 || cloud.position(k).y != 0.0 || cloud.particles.sz[k] != 0.0;
            // The blade does not hit particles that it contains at the start.
            let within = ahead < margin || ahead > std::f32::consts::PI - margin;
            let close = within || near.iter().any(|edge| (ahead - edge).abs() < 0.02);
            assert!(
                touched == inside || close,
                "after {offset} steps, {ahead} of {turn}: {touched}"
            );
        }
    }
}

#[test]
fn a_blade_that_turns_by_almost_half_a_turn_in_one_step_hits_its_whole_ring_and_throws_it_in_its_direction() {
    let blade = RigidShape::Cuboid {
        half_extents: [0.299, 0.2, 0.005],
    };
    let mut cloud = Cloud::new(360);
    let rigid = cloud.rigids.add(kinematic(blade)).unwrap();
    // Its two halves sweep the ring.
    cloud.rigids.move_to(rigid, turned_by(3.1)).unwrap();
    let places: Vec<Vector> = (0..360)
        .map(|k| k as f32 * std::f32::consts::TAU / 360.0)
        .map(|angle| Vector::new(0.25 * angle.cos(), 0.0, -0.25 * angle.sin()))
        .collect();
    for place in &places {
        cloud.push((*place).into(), [0.0; 3], 0.005);
    }
    cloud.step(0.0);
    for (k, place) in places.iter().enumerate() {
        let slip = Vector::new(cloud.particles.sx[k], cloud.particles.sy[k], cloud.particles.sz[k]);
        // The blade does not hit particles that it contains at the start.
        let within = place.z.abs() < 0.02;
        assert!(
            within || place.cross(slip).y > 0.0,
            "particle {k} at {place:?}: {slip:?}"
        );
    }
}

#[test]
fn a_dynamic_rigid_is_put_somewhere_at_rest_and_sweeps_nothing_on_its_way() {
    let mut cloud = Cloud::new(40);
    let ball = RigidShape::Ball { radius: 0.5 };
    let index = cloud
        .rigids
        .add(rigid(RigidKind::Dynamic, ball, Pose::at(Vector::ZERO)))
        .unwrap();
    for k in 0..40 {
        cloud.push([0.8 + 0.1 * k as f32, -0.2, 0.0], [0.0; 3], 0.01);
    }
    (0..30).for_each(|_| cloud.rigids.advance(DT));
    let place = Pose {
        position: Vector::new(6.0, 2.0, 0.0),
        rotation: turned(Vector::Y, 0.5),
    };
    cloud.rigids.move_to(index, place).unwrap();
    cloud.step(0.0);
    let [start, end] = cloud.rigids.poses().as_chunks::<7>().0 else {
        panic!("one rigid has two poses");
    };
    assert_eq!(start[..3], [6.0, 2.0, 0.0], "its way begins where it was put");
    let fall = 9.81 * DT * DT;
    // Rapier takes substeps, in which it falls by less than in one step.
    assert!(
        end[1] < 2.0 && end[1] > 2.0 - 1.01 * fall,
        "it falls from rest: {end:?}"
    );
    assert!(cloud.particles.sx.iter().all(|speed| *speed == 0.0));
    let before = cloud.pose(0).position.y;
    cloud.step(0.0);
    assert!(cloud.pose(0).position.y < before, "told once, it is put once");
}

#[test]
fn a_fixed_rigid_cannot_be_moved() {
    let mut rigids = sim::rigids::Rigids::new();
    let ball = RigidShape::Ball { radius: 0.5 };
    let index = rigids
        .add(rigid(RigidKind::Fixed, ball, Pose::at(Vector::ZERO)))
        .unwrap();
    let place = Pose::at(Vector::ZERO);
    assert_eq!(rigids.move_to(index, place).unwrap_err().key, "rigid.index");
    assert_eq!(rigids.move_to(index + 1, place).unwrap_err().key, "rigid.index");
}
