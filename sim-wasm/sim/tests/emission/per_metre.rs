//! Births by the path of an emitter.

use std::f64::consts::TAU;

use crate::common::inputs::emitter;
use crate::common::{STILL, place, simulator, steps};
use proptest::prelude::*;
use sim::Simulator;
use sim::layout::parameters::LIST_LIMIT;
use sim::layout::scope::parts::FIRST_PART;

/// Nothing is emitted but by the path, and nothing dies.
const BY_PATH: &[(&str, f64)] = &[
    ("emission.rate", 0.0),
    ("emission.lifetime", 60.0),
    ("emitters.0.perMetre", 7.0),
    ("emitters.0.speed", 0.0),
    ("emitters.0.shape", 0.0),
];

fn trail(settings: &[(&str, f64)]) -> Simulator {
    simulator(4000, 1, &[STILL, BY_PATH, settings])
}

/// Puts the emitter at a place and makes a step.
fn go(simulator: &mut Simulator, place: [f64; 3]) {
    for (axis, value) in ["x", "y", "z"].into_iter().zip(place) {
        simulator.set(&format!("emitters.0.position.{axis}"), value).unwrap();
    }
    simulator.step();
}

/// Makes a step in which part 0 turns about y from `from` to `to` (rad) at a distance from the axis, and moves up.
fn turn(simulator: &mut Simulator, [from, to]: [f64; 2], height: [f64; 2]) {
    let part = |angle: f64, height: f64| {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        [-1.0, 0.0, height as f32, 0.0, 0.0, sine as f32, 0.0, cosine as f32]
    };
    simulator
        .place_parts(&[part(from, height[0]), part(to, height[1])].concat())
        .unwrap();
    simulator.step();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_path_has_the_same_count_at_any_speed_and_any_turn(speeds in prop::collection::vec(0.01..1.9_f64, 20..60), bend in 0.1..3.0_f64) {
        // A polygon of 12 m, whose corners are steps, at any length of the sides.
        let mut simulator = trail(&[]);
        let (mut place, mut left) = ([0.0; 3], 12.0_f64);
        go(&mut simulator, place);
        for (index, speed) in speeds.iter().cycle().enumerate() {
            let side = speed.min(left);
            let angle = bend * index as f64;
            place = [place[0] + side * angle.cos(), place[1], place[2] + side * angle.sin()];
            go(&mut simulator, place);
            left -= side;
            if left <= 0.0 {
                break;
            }
        }
        // Positions are of single precision: the last one may be missing.
        prop_assert!((83..=84).contains(&simulator.alive()), "{}", simulator.alive());
    }

    #[test]
    fn a_carrier_has_the_same_count_at_any_speed_and_any_turn(angles in prop::collection::vec(0.001..0.6_f64, 5..30)) {
        // An arc of 12 m about an axis 2 m away, at 24 m of which it rises besides.
        for (rise, metres) in [(0.0, 12.0), (0.75, 15.0)] {
            let mut simulator = trail(&[("emitters.0.rigid", FIRST_PART as f64), ("emitters.0.position.x", 2.0)]);
            let end = 12.0 / 2.0;
            let mut angle = 0.0;
            for step in angles.iter().cycle() {
                let next = f64::min(angle + step, end);
                turn(&mut simulator, [angle, next], [angle, next].map(|angle| angle * 2.0 * rise));
                angle = next;
                if angle >= end {
                    break;
                }
            }
            let expected = 7.0 * metres;
            prop_assert!((simulator.alive() as f64 - expected).abs() <= 1.0, "{} for {metres} m", simulator.alive());
        }
    }
}

#[test]
fn puffs_lie_evenly_on_the_path() {
    let mut simulator = trail(&[]);
    for step in 0..=40 {
        go(&mut simulator, [f64::from(step) * 0.25, 0.0, 0.0]);
    }
    let mut along: Vec<f32> = (0..simulator.alive()).map(|i| place(&simulator, i)[0]).collect();
    along.sort_by(f32::total_cmp);
    assert_eq!(along.len(), 70);
    for (index, x) in along.iter().enumerate() {
        assert!((x - (index + 1) as f32 / 7.0).abs() < 1e-3, "puff {index} at {x}");
    }
}

#[test]
fn an_emitter_at_rest_emits_at_its_rate_and_a_moving_one_adds_to_it() {
    let rate = [("emission.rate", 60.0)];
    let mut simulator = trail(&rate);
    steps(&mut simulator, 60);
    assert_eq!(simulator.alive(), 60);
    for step in 1..=60 {
        go(&mut simulator, [0.0, f64::from(step) * 0.1, 0.0]);
    }
    assert_eq!(simulator.alive(), 60 + 60 + 42);
}

#[test]
fn a_jump_a_pause_and_the_start_leave_no_trail() {
    let mut simulator = trail(&[("emitters.0.position.x", 300.0), ("emitters.0.envelope.duration", 1.0)]);
    steps(&mut simulator, 2);
    go(&mut simulator, [0.0, 0.0, 0.0]);
    assert_eq!(simulator.alive(), 0, "a jump");
    go(&mut simulator, [1.0, 0.0, 0.0]);
    assert_eq!(simulator.alive(), 7);
    steps(&mut simulator, 60);
    go(&mut simulator, [2.0, 0.0, 0.0]);
    assert_eq!(simulator.alive(), 7, "after its envelope");
}

#[test]
fn emitters_of_the_pool_follow_paths_too() {
    let mut simulator = simulator(4000, 1, &[STILL, BY_PATH]);
    let at = |x: f64| emitter(&[("share", 0.0), ("perMetre", 20.0), ("position.x", x)]);
    for step in 0..=30 {
        simulator
            .set_emitter(LIST_LIMIT as u32 + 5, &at(f64::from(step) * 0.1), 0)
            .unwrap();
        simulator.step();
    }
    assert_eq!(simulator.alive(), 60);
    // A slot that becomes free forgets its place.
    simulator.set_emitter(LIST_LIMIT as u32 + 5, &[], 0).unwrap();
    simulator.set_emitter(LIST_LIMIT as u32 + 5, &at(4.5), 0).unwrap();
    simulator.step();
    assert_eq!(simulator.alive(), 60);
}

#[test]
fn a_path_continues_from_a_saved_state() {
    let mut original = trail(&[]);
    for step in 0..10 {
        go(&mut original, [f64::from(step) * 0.11, 0.0, 0.0]);
    }
    let mut restored = simulator(4000, 9, &[]);
    restored.restore(&original.save()).unwrap();
    assert_eq!(restored.hash(), original.hash());
    for simulator in [&mut original, &mut restored] {
        go(simulator, [1.6, 0.0, 0.0]);
    }
    assert_eq!((restored.hash(), restored.alive()), (original.hash(), 11));
    assert!(restored.save() == original.save());
}

#[test]
fn a_whole_turn_far_from_the_axis_is_an_arc() {
    // Seven steps for a turn: the chords are 3.3 % shorter than the arc.
    let settings = [
        ("emitters.0.perMetre", 100.0),
        ("emitters.0.rigid", FIRST_PART as f64),
        ("emitters.0.position.x", 1.5),
    ];
    let mut simulator = trail(&settings);
    for step in 0..7 {
        turn(
            &mut simulator,
            [f64::from(step), f64::from(step + 1)].map(|step| step * TAU / 7.0),
            [0.0; 2],
        );
    }
    let expected = 100.0 * TAU * 1.5;
    assert!(
        (simulator.alive() as f64 - expected).abs() < 0.002 * expected,
        "{} of {expected}",
        simulator.alive()
    );
}
