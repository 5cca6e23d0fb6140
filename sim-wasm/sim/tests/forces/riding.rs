//! Forces on moving and rotating rigids.

use crate::common::{STEP, STILL, newborn, place, simulator, slip, steps};
use sim::Simulator;
use sim::math::pose::{Frame, Pose};
use sim::math::vector::Vector;
use sim::rigids::{RigidDescription, RigidKind, RigidShape};

/// Pose of the rigid at `time` (s): it rotates about z at 1 rad/s and moves along x at 2 m/s.
fn pose(time: f64) -> Pose {
    let half = (0.5 * time) as f32;
    Pose {
        position: Vector::new(2.0 * time as f32, 0.0, 0.0),
        rotation: [0.0, 0.0, half.sin(), half.cos()],
    }
}

/// A simulator with a first rigid out of the way and a second one with the pose `pose`.
fn rigged(settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(8, 1, &[STILL, settings]);
    let shape = RigidShape::Ball { radius: 0.001 };
    for place in [Pose::at(Vector::new(0.0, -50.0, 0.0)), pose(0.0)] {
        let description = RigidDescription::new(RigidKind::Kinematic, shape.clone(), place);
        simulator.rigids_mut().add(description).unwrap();
    }
    simulator
}

fn advance(simulator: &mut Simulator) {
    let end = (simulator.steps() + 1) as f64 * STEP;
    simulator.rigids_mut().move_to(1, pose(end)).unwrap();
    simulator.step();
}

/// The middle of the last step, at which `air_velocity` knows the rigids.
fn frame(simulator: &Simulator) -> Frame {
    Frame::new(&pose((simulator.steps() as f64 - 0.5) * STEP))
}

fn assert_near(what: &str, ours: [f32; 3], expected: Vector, tolerance: f32) {
    let off = (Vector::from(ours) - expected).length();
    assert!(off < tolerance, "{what}: {ours:?}, expected {expected:?}");
}

#[test]
fn vortices_jets_spirals_flows_and_shapes_move_and_rotate_with_their_rigid() {
    let own = [
        ("vortices.0.circulation", 3.0),
        ("vortices.0.position.y", 0.5),
        ("vortices.0.axis.x", 1.0),
        ("vortices.0.axis.z", 0.0),
        ("jets.0.speed", 2.0),
        ("jets.0.position.x", 0.3),
        ("spirals.0.turn", 2.0),
        ("spirals.0.axis.x", 0.4),
        ("flows.0.speed", 1.0),
        ("flows.0.swirl", 2.0),
        ("flows.0.position.x", 0.2),
        ("shapes.0.speed", 1.0),
        ("shapes.0.outline.000", 17_955_998_253_921.0),
        ("shapes.0.outline.001", 33.0),
        ("shapes.0.facing.x", 0.5),
    ];
    let fixed = simulator(1, 1, &[STILL, &own]);
    let attached = [
        ("vortices.0.rigid", 1.0),
        ("jets.0.rigid", 1.0),
        ("spirals.0.rigid", 1.0),
        ("flows.0.rigid", 1.0),
        ("shapes.0.rigid", 1.0),
    ];
    let mut riding = rigged(&[own.as_slice(), &attached].concat());
    for _ in 0..45 {
        advance(&mut riding);
        let frame = frame(&riding);
        for local in [[0.0, 0.9, 0.2], [0.3, 0.6, -0.1], [1.0, -0.4, 0.5], [0.25, 0.8, 0.0]] {
            let world = frame.world_from_local(local.into());
            let expected = frame.rotate(fixed.air_velocity(local).into());
            assert_near("air", riding.air_velocity(world.into()), expected, 2e-3);
        }
    }
}

#[test]
fn the_region_of_a_wind_moves_and_rotates_with_its_rigid() {
    let settings = [
        ("winds.0.velocity.y", 1.5),
        ("winds.0.rigid", 1.0),
        ("winds.0.region.shape", 2.0),
        ("winds.0.region.position.x", 1.0),
        ("winds.0.region.size.x", 0.2),
        ("winds.0.region.size.y", 0.6),
        ("winds.0.region.softness", 0.0),
    ];
    let mut riding = rigged(&settings);
    for _ in 0..45 {
        advance(&mut riding);
        let frame = frame(&riding);
        let air = |x, y| riding.air_velocity(frame.world_from_local(Vector::new(x, y, 0.0)).into());
        let blowing = frame.rotate(Vector::new(0.0, 1.5, 0.0));
        assert_near("inside", air(1.0, 0.0), blowing, 1e-4);
        assert_near("near an end", air(1.15, 0.55), blowing, 1e-4);
        assert_near("beside", air(1.25, 0.0), Vector::ZERO, 1e-9);
        assert_near("beyond the end", air(1.0, 0.65), Vector::ZERO, 1e-9);
    }
}

#[test]
fn a_pull_turns_with_its_rigid() {
    let settings = [("gravities.0.acceleration.x", 2.0), ("gravities.0.rigid", 1.0)];
    let mut riding = rigged(&settings);
    riding.add(&newborn([0.0, 3.0, 0.0]));
    for step in 1..=60 {
        advance(&mut riding);
        // The integral of 2 (cos t, sin t).
        let t = f64::from(step) * STEP;
        let expected = Vector::new(2.0 * t.sin() as f32, 2.0 * (1.0 - t.cos()) as f32, 0.0);
        assert_near("slip", slip(&riding, 0), expected, 1e-4);
    }
}

#[test]
fn an_attractor_an_orbit_and_an_explosion_stand_where_their_rigid_is() {
    for (strength, list) in [
        ("acceleration", "attractors"),
        ("acceleration", "orbits"),
        ("impulse", "explosions"),
    ] {
        let [rigid, strength] = ["rigid", strength].map(|end| format!("{list}.0.{end}"));
        let mut riding = rigged(&[(&rigid, 1.0), (&strength, 1.0)]);
        (0..30).for_each(|_| advance(&mut riding));
        let at = riding.steps() as f64 * STEP;
        if list == "explosions" {
            riding.set("explosions.0.envelope.start", at).unwrap();
        }
        let centre = pose(at).position;
        riding.add(&newborn((centre + Vector::new(0.0, 0.6, 0.0)).into()));
        riding.add(&newborn((centre + Vector::new(0.0, -0.6, 0.0)).into()));
        (0..4).for_each(|_| advance(&mut riding));
        let [above, below] = [0, 1].map(|i| slip(&riding, i));
        assert!(above[1].abs() > 0.02, "{list} does nothing: {above:?}");
        assert!(
            (above[1] + below[1]).abs() < 1e-4,
            "{list} is not between them: {above:?} {below:?}"
        );
        assert!((above[0] - below[0]).abs() < 1e-4);
    }
}

#[test]
fn effects_without_a_rigid_are_fixed_in_the_world() {
    let settings = [("jets.0.speed", 2.0), ("jets.0.rigid", 77.0)];
    let (mut there, mut nowhere) = (rigged(&settings), rigged(&settings[..1]));
    for simulator in [&mut there, &mut nowhere] {
        simulator.add(&newborn([0.0, 0.2, 0.0]));
        steps(simulator, 30);
    }
    assert_eq!(place(&there, 0), place(&nowhere, 0));
}
