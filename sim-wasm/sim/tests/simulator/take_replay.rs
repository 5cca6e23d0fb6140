//! Replays equal the live run to the last bit.

use crate::common::inputs::{Act, perform, script};
use crate::common::{LIVELY, simulator, steps};
use proptest::prelude::*;
use sim::Simulator;
use sim::layout::blow::BlowNumbers;
use sim::simulator::take::Take;

const CAPACITY: u32 = 400;

/// The scene of all these takes: lively smoke and, with rigids, a ball that the user moves.
fn scene(seed: u32) -> Simulator {
    #[cfg_attr(not(feature = "rigids"), allow(unused_mut))]
    let mut scene = simulator(CAPACITY, seed, &[LIVELY]);
    #[cfg(feature = "rigids")]
    {
        use sim::rigids::{RigidDescription, RigidKind, RigidShape, pose_of};
        for (kind, y) in [(RigidKind::Kinematic, 0.5), (RigidKind::Dynamic, 2.5)] {
            let pose = pose_of(&[0.2, y, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
            let ball = RigidDescription::new(kind, RigidShape::Ball { radius: 0.4 }, pose);
            scene.rigids_mut().add(ball).unwrap();
        }
    }
    scene
}

fn recording(seed: u32) -> Simulator {
    let mut scene = scene(seed);
    scene.record();
    scene
}

/// Plays a script and returns steps and hash after each of its inputs and at the end.
fn play(simulator: &mut Simulator, script: &[(usize, Act)]) -> Vec<(u64, u64)> {
    let mut moments = Vec::new();
    for (wait, act) in script {
        steps(simulator, *wait);
        let before = simulator.hash();
        perform(simulator, act);
        if !matches!(
            act,
            Act::Clear | Act::Emit(..) | Act::Resize(_) | Act::Set("simulation.integrator", _)
        ) {
            assert_eq!(simulator.hash(), before, "{act:?} acts before its step");
        }
        moments.push((simulator.steps(), simulator.hash()));
    }
    steps(simulator, 25);
    moments.push((simulator.steps(), simulator.hash()));
    moments
}

/// Asserts the hashes at the same steps, without inputs. Of several inputs in one step, the hash after the last one counts.
fn follow(simulator: &mut Simulator, moments: &[(u64, u64)]) {
    for (index, (step, hash)) in moments.iter().enumerate() {
        if moments.get(index + 1).is_some_and(|(next, _)| next == step) {
            continue;
        }
        let missing = step - simulator.steps();
        steps(simulator, missing as usize);
        assert_eq!(simulator.hash(), *hash, "after {step} steps");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_replay_reaches_the_same_hashes(script in script(), seed in 0_u32..100) {
        let mut live = recording(seed);
        let moments = play(&mut live, &script);
        let bytes = live.take("").unwrap();
        // Another seed, other values and a running simulation: a take replaces all of it.
        let mut other = recording(seed + 1);
        other.input_values(&[("forces.drag", 3.0)]).unwrap();
        steps(&mut other, 10);
        other.replay(&bytes).unwrap();
        prop_assert_eq!(other.steps(), 0);
        follow(&mut other, &moments);
        prop_assert_eq!(other.parameters(), live.parameters());
        prop_assert_eq!(other.capacity(), live.capacity());
        prop_assert!(other.take("").unwrap() == bytes);
    }

    #[test]
    fn seeking_back_and_forth_reaches_the_same_hashes(script in script(), kept in 1_u64..200, twice in 0..2) {
        let mut live = recording(5);
        let mut states = Vec::new();
        let mut moments = Vec::new();
        for (wait, act) in &script {
            for _ in 0..*wait {
                live.step();
                if live.steps().is_multiple_of(kept) {
                    states.push(live.save());
                }
            }
            perform(&mut live, act);
            moments.push((live.steps(), live.hash()));
        }
        for _ in 0..=twice {
            live.rewind(None).unwrap();
            follow(&mut live, &moments);
            for state in states.iter().rev() {
                live.rewind(Some(state)).unwrap();
                let from = live.steps();
                let later: Vec<_> = moments.iter().copied().filter(|(step, _)| *step >= from).collect();
                follow(&mut live, &later);
            }
        }
    }

    #[test]
    fn a_take_can_start_in_a_running_simulation(script in script(), first in 1_usize..80) {
        let mut live = scene(9);
        steps(&mut live, first);
        live.record();
        let moments = play(&mut live, &script);
        let bytes = live.take("").unwrap();
        let mut other = Simulator::new(7, 1).unwrap();
        other.replay(&bytes).unwrap();
        prop_assert_eq!(other.steps(), first as u64);
        follow(&mut other, &moments);
        prop_assert!(other.take("").unwrap() == bytes);
    }
}

#[test]
fn a_new_input_drops_the_rest_of_the_log() {
    let mut live = recording(1);
    for step in 0..10 {
        live.input_values(&[("emission.rate", 100.0 * f64::from(step))])
            .unwrap();
        steps(&mut live, 10);
    }
    assert_eq!(live.inputs(), (10, 10));
    live.rewind(None).unwrap();
    steps(&mut live, 35);
    assert_eq!((live.inputs(), live.end()), ((4, 10), 100));
    live.input_steer(0, 0.5).unwrap();
    assert_eq!((live.inputs(), live.end()), ((5, 5), 35));
    steps(&mut live, 65);
    assert_eq!(live.parameters().emission.rate, 300.0);
    let hash = live.hash();
    live.rewind(None).unwrap();
    steps(&mut live, 100);
    assert_eq!(live.hash(), hash);
}

#[test]
fn several_moves_in_a_step_are_recorded_once() {
    let mut live = recording(1);
    for i in 0..50 {
        live.input_steer(3, f64::from(i) / 50.0).unwrap();
        live.input_values(&[("forces.drag", f64::from(i) / 10.0)]).unwrap();
        live.input_blow(&puff(f64::from(i) / 25.0)).unwrap();
    }
    assert_eq!(live.inputs(), (3, 3));
    live.step();
    live.input_steer(3, 1.0).unwrap();
    assert_eq!(live.inputs(), (4, 4));
    assert_eq!(live.control(3), 1.0);
}

#[test]
fn a_full_log_is_reported_and_inputs_still_act() {
    let mut live = simulator(4, 1, &[]);
    live.record();
    let most = sim::simulator::take::log::MAX_INPUTS as u32;
    for i in 0..most + 5 {
        assert_eq!(live.is_truncated(), i > most);
        live.input_steer(0, f64::from(i % 100) / 100.0).unwrap();
        live.step();
    }
    assert_eq!(live.inputs().1, most);
    assert!(
        (live.control(0) - 0.04).abs() < 1e-4,
        "the last input acts though it is not kept"
    );
    let take = Take::parse(&live.take("").unwrap()).unwrap();
    assert!(take.log.is_truncated());
    assert_eq!(take.log.len(), most as usize);
}

#[test]
fn invalid_inputs_are_errors_with_their_key() {
    let mut live = recording(1);
    let before = (live.hash(), live.inputs());
    let errors = [
        (live.input_steer(8, 0.0), "steer.channel"),
        (live.input_steer(0, 1.5), "steer.value"),
        (live.input_steer(0, f64::NAN), "steer.value"),
        (
            live.input_values(&[("forces.drag", 1.0), ("emission.rate", -1.0)]),
            "emission.rate",
        ),
        (live.input_capacity(0), "simulation.maxParticles"),
        (
            live.input_blow(&BlowNumbers {
                seconds: 11.0,
                ..puff(1.0)
            }),
            "blow.seconds",
        ),
        (
            live.input_blow(&BlowNumbers {
                radius: 0.0,
                ..puff(1.0)
            }),
            "blow.radius",
        ),
        (
            live.input_blow(&BlowNumbers {
                ray: [0.0; 3],
                ..puff(1.0)
            }),
            "blow.ray",
        ),
        (live.input_blow(&puff(60.0)), "blow.velocity.y"),
        (
            live.input_blow(&BlowNumbers {
                origin: [0.0, 0.0, 1e9],
                ..puff(1.0)
            }),
            "blow.origin.z",
        ),
    ];
    for (result, key) in errors {
        assert_eq!(result.unwrap_err().key, key);
    }
    assert_eq!((live.hash(), live.inputs()), before);
}

/// A gust across the plume at a speed (m/s).
fn puff(speed: f64) -> BlowNumbers {
    BlowNumbers {
        origin: [0.0, 1.0, 5.0],
        ray: [0.0, 0.0, -2.0],
        velocity: [0.0, speed, 0.0],
        radius: 0.5,
        seconds: 0.3,
    }
}

#[test]
fn clear_removes_particles_and_waiting_births_and_nothing_else() {
    let mut live = recording(3);
    live.input_values(&[("emission.rate", 4000.0)]).unwrap();
    steps(&mut live, 30);
    assert!(live.alive() > 300 && live.waiting() > 0);
    live.input_clear().unwrap();
    assert_eq!((live.alive(), live.waiting(), live.steps()), (0, 0, 30));
    live.step();
    assert!(live.alive() > 50);
    let hash = live.hash();
    live.rewind(None).unwrap();
    steps(&mut live, 31);
    assert_eq!(live.hash(), hash);
}

#[test]
fn several_clears_in_a_step_are_recorded_once() {
    let mut live = recording(1);
    for _ in 0..5 {
        live.input_clear().unwrap();
        live.input_steer(0, 0.5).unwrap();
    }
    assert_eq!(live.inputs(), (2, 2));
}
