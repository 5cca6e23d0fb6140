//! Rigids and analytic obstacles that kill or tint particles.

use crate::collide::cloud::{kinematic, rigid};
use crate::common::{STILL, newborn, place, simulator, steps};
use sim::Simulator;
use sim::collide::contact::Action;
use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::particles::Newborn;
use sim::rigids::{RigidDescription, RigidKind, RigidShape};

/// Four particles fly towards a thin plate across y = 0, two fly past it. A tint identifies its particle.
fn with_plate(action: Option<Action>, settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(16, 1, &[STILL, settings]);
    if let Some(action) = action {
        let plate = RigidShape::Cuboid {
            half_extents: [2.0, 0.001, 2.0],
        };
        let fixed = rigid(RigidKind::Fixed, plate, Pose::at(Vector::ZERO));
        simulator
            .rigids_mut()
            .add(RigidDescription { action, ..fixed })
            .unwrap();
    }
    for k in 0..6 {
        let x = if k < 4 { 0.4 * k as f32 } else { 3.0 };
        simulator.add(&Newborn {
            slip: [0.0, -30.0, 0.0],
            size: 0.05,
            attributes: 0x0abc_1203,
            ..newborn([x, 1.0 + 0.3 * k as f32, 0.0])
        });
    }
    simulator
}

fn tints(simulator: &Simulator) -> Vec<u32> {
    let alive = simulator.alive();
    simulator.particles().attributes[..alive]
        .iter()
        .map(|attributes| attributes >> 28)
        .collect()
}

/// The plate as a rigid and as a parameter.
fn both(action: Action) -> [Simulator; 2] {
    let (number, tint) = match action {
        Action::Bounce => (0.0, 1.0),
        Action::Kill => (1.0, 1.0),
        Action::Tint(tint) => (2.0, f64::from(tint)),
    };
    let parameters = [
        ("colliders.0.shape", 2.0),
        ("colliders.0.halfExtents.x", 2.0),
        ("colliders.0.halfExtents.y", 0.001),
        ("colliders.0.halfExtents.z", 2.0),
        ("colliders.0.action", number),
        ("colliders.0.tint", tint),
    ];
    [with_plate(Some(action), &[]), with_plate(None, &parameters)]
}

#[test]
fn a_killing_plate_kills_exactly_the_touching_particles_in_that_step() {
    for mut simulator in both(Action::Kill) {
        let mut expected = 6;
        for step in 1..=8 {
            steps(&mut simulator, 1);
            // Half a metre per step: number k touches when 1 + 0.3 k - 0.5 step <= 0.051.
            let gone = (0..4)
                .filter(|k| 1.0 + 0.3 * *k as f32 - 0.5 * step as f32 <= 0.051)
                .count();
            assert!(6 - gone <= expected);
            expected = 6 - gone;
            assert_eq!(simulator.alive(), expected, "step {step}");
        }
        assert_eq!(expected, 2);
    }
}

#[test]
fn a_tinting_plate_tints_touching_particles_without_stopping_them() {
    for mut simulator in both(Action::Tint(11)) {
        steps(&mut simulator, 12);
        assert_eq!(tints(&simulator), [11, 11, 11, 11, 0, 0]);
        for k in 0..6 {
            let expected = 1.0 + 0.3 * k as f32 - 6.0;
            assert!((place(&simulator, k)[1] - expected).abs() < 1e-4, "it is not held up");
            assert_eq!(
                simulator.particles().attributes[k] & 0x0fff_ffff,
                0x0abc_1203,
                "the rest of its attributes stays"
            );
        }
    }
}

#[test]
fn a_bouncing_plate_gives_no_tint_and_a_wall_shields_a_killing_one() {
    for mut simulator in both(Action::Bounce) {
        steps(&mut simulator, 12);
        assert_eq!(tints(&simulator), [0; 6]);
        assert!(place(&simulator, 0)[1] > 0.0, "it bounced");
    }
    let ground = [("colliders.0.position.y", 0.1)];
    let mut simulator = with_plate(Some(Action::Kill), &ground);
    steps(&mut simulator, 30);
    assert_eq!(simulator.alive(), 6, "the ground above it keeps all from it");
}

#[test]
fn a_killing_rigid_sweeps_and_the_action_is_saved() {
    let mut simulator = simulator(16, 1, &[STILL]);
    simulator
        .rigids_mut()
        .add(RigidDescription {
            action: Action::Kill,
            ..kinematic(RigidShape::Ball { radius: 0.2 })
        })
        .unwrap();
    simulator.add(&newborn([1.0, 0.0, 0.0]));
    simulator.add(&newborn([1.0, 2.0, 0.0]));
    steps(&mut simulator, 1);
    let mut twin = Simulator::new(16, 2).unwrap();
    twin.restore(&simulator.save()).unwrap();
    for simulator in [&mut simulator, &mut twin] {
        // 1.9 m in one step: the particle is passed on the way.
        let pose = Pose::at(Vector::new(1.9, 0.0, 0.0));
        simulator.rigids_mut().move_to(0, pose).unwrap();
        steps(simulator, 1);
        assert_eq!(simulator.alive(), 1);
    }
    assert_eq!(simulator.hash(), twin.hash());
}
