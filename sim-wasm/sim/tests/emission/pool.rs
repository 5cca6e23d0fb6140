//! Emitters of the pool: their rates, bursts and slots, and that they are saved.

use crate::common::inputs::emitter;
use crate::common::{LIVELY, STILL, place, simulator, steps};
use sim::Simulator;
use sim::emission::pool::EMITTER_NUMBERS;
use sim::layout::limits::{POOL_LIMIT, STEP};
use sim::layout::parameters::LIST_LIMIT;
use sim::layout::scope::parts::{FIRST_PART, PART_FLOATS};

/// Only the pool emits, and nothing dies.
const SILENT: &[(&str, f64)] = &[("emission.rate", 0.0), ("emission.lifetime", 60.0)];

/// The index of a slot in `burst`.
fn index(slot: u32) -> u32 {
    LIST_LIMIT as u32 + slot
}

#[test]
fn an_emitter_has_the_numbers_of_the_table() {
    assert_eq!(emitter(&[]).len(), EMITTER_NUMBERS);
}

#[test]
fn its_share_is_a_rate_of_its_own_and_leaves_the_table_alone() {
    let table = [
        ("emission.rate", 90.0),
        ("emitters.0.share", 1.0),
        ("emission.lifetime", 60.0),
    ];
    let mut simulator = simulator(4000, 1, &[STILL, &table]);
    simulator
        .set_emitter(index(3), &emitter(&[("share", 30.0), ("position.x", 100.0)]), 0)
        .unwrap();
    steps(&mut simulator, 600);
    let far = (0..simulator.alive())
        .filter(|i| place(&simulator, *i)[0] > 50.0)
        .count();
    assert_eq!((simulator.alive() - far, far), (900, 300));
}

#[test]
fn a_burst_comes_in_the_next_step_at_its_place_with_its_tint() {
    let mut simulator = simulator(4000, 1, &[STILL, SILENT]);
    let at = [("position.y", 3.0), ("share", 0.0), ("tint", 5.0), ("speed", 0.0)];
    simulator.set_emitter(index(0), &emitter(&at), 0).unwrap();
    simulator.set_emitter(index(0), &[], 40).unwrap();
    assert_eq!((simulator.alive(), simulator.waiting()), (0, 40));
    steps(&mut simulator, 1);
    assert_eq!((simulator.alive(), simulator.waiting()), (40, 0));
    for i in 0..40 {
        assert_eq!(place(&simulator, i), [0.0, 3.0, 0.0]);
        assert_eq!(simulator.particles().attributes[i] >> 28, 5);
    }
    steps(&mut simulator, 60);
    assert_eq!(simulator.alive(), 40);
}

#[test]
fn a_burst_of_an_emitter_of_the_table_uses_its_shape() {
    let mut simulator = simulator(
        400,
        1,
        &[
            STILL,
            SILENT,
            &[("emitters.1.position.x", 7.0), ("emitters.1.speed", 0.0)],
        ],
    );
    simulator.set_emitter(1, &[], 12).unwrap();
    steps(&mut simulator, 1);
    assert_eq!(simulator.alive(), 12);
    assert!((0..12).all(|i| place(&simulator, i)[0] == 7.0));
}

#[test]
fn a_burst_waits_while_the_simulator_is_full() {
    let mut simulator = simulator(50, 1, &[STILL, SILENT, &[("emission.lifetime", 1.0)]]);
    let still = emitter(&[("share", 0.0), ("lifetimeVariation", 0.0)]);
    simulator.set_emitter(index(0), &still, 0).unwrap();
    simulator.set_emitter(index(0), &[], 120).unwrap();
    steps(&mut simulator, 1);
    assert_eq!((simulator.alive(), simulator.waiting()), (50, 70));
    steps(&mut simulator, 200);
    assert_eq!(simulator.waiting(), 0);
}

#[test]
fn a_burst_with_numbers_replaces_the_one_that_waits() {
    let mut simulator = simulator(50, 1, &[STILL, SILENT, &[("emission.lifetime", 1.0)]]);
    let still = emitter(&[("share", 0.0), ("lifetimeVariation", 0.0)]);
    simulator.set_emitter(index(0), &still, 120).unwrap();
    steps(&mut simulator, 1);
    assert_eq!((simulator.alive(), simulator.waiting()), (50, 70));
    simulator.set_emitter(index(0), &still, 20).unwrap();
    assert_eq!(simulator.waiting(), 20);
    simulator.set_emitter(index(0), &still, 0).unwrap();
    simulator.set_emitter(index(0), &[], 3).unwrap();
    assert_eq!(simulator.waiting(), 23);
}

#[test]
fn a_free_slot_emits_nothing_more_and_its_next_user_starts_anew() {
    let mut simulator = simulator(4000, 1, &[STILL, SILENT]);
    simulator
        .set_emitter(index(2), &emitter(&[("share", 90.0)]), 0)
        .unwrap();
    steps(&mut simulator, 61);
    simulator.set_emitter(index(2), &[], 500).unwrap();
    simulator.set_emitter(index(2), &[], 0).unwrap();
    let born = simulator.alive();
    steps(&mut simulator, 60);
    assert_eq!((simulator.alive(), simulator.waiting()), (born, 0));
    // 1.5 particles a step: a fraction that the last user owed would come a step early.
    simulator
        .set_emitter(index(2), &emitter(&[("share", 90.0)]), 0)
        .unwrap();
    steps(&mut simulator, 1);
    assert_eq!(simulator.alive(), born + 1);
}

#[test]
fn it_rides_on_a_part_and_inherits_its_velocity() {
    let mut simulator = simulator(4000, 1, &[STILL, SILENT]);
    let riding = [
        ("share", 600.0),
        ("rigid", FIRST_PART as f64 + 1.0),
        ("speed", 0.0),
        ("inherit", 1.0),
    ];
    simulator.set_emitter(index(0), &emitter(&riding), 0).unwrap();
    let part = |x: f32| [-1.0, x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let resting: [f32; PART_FLOATS] = part(-5.0);
    for step in 0..30 {
        let [start, end] = [step, step + 1].map(|step| part(0.5 * step as f32));
        simulator.place_parts(&[resting, start, resting, end].concat()).unwrap();
        simulator.step();
    }
    assert_eq!(simulator.alive(), 300);
    for i in 0..300 {
        assert!((simulator.particles().sx[i] - 0.5 / STEP as f32).abs() < 1e-3);
    }
    // Even in space: each birth at its own time, with the speed of the part from then on.
    let xs: Vec<f32> = (0..300).map(|i| place(&simulator, i)[0]).collect();
    assert!(xs.iter().all(|x| (x - 15.0).abs() < 0.01), "{xs:?}");
}

#[test]
fn equal_calls_give_equal_hashes_and_a_pool_changes_them() {
    let run = |slot: Option<u32>| {
        let mut simulator = simulator(900, 4, &[LIVELY]);
        steps(&mut simulator, 20);
        if let Some(slot) = slot {
            simulator
                .set_emitter(index(slot), &emitter(&[("share", 50.0)]), 0)
                .unwrap();
            simulator.set_emitter(index(slot), &[], 30).unwrap();
        }
        steps(&mut simulator, 20);
        simulator.hash()
    };
    assert_eq!(run(Some(7)), run(Some(7)));
    assert_ne!(run(Some(7)), run(None));
}

#[test]
fn slots_are_saved_and_restored() {
    let mut original = simulator(500, 3, &[LIVELY]);
    original
        .set_emitter(index(5), &emitter(&[("share", 70.5), ("position.z", 2.0)]), 0)
        .unwrap();
    original
        .set_emitter(index(9), &emitter(&[("share", 0.0), ("tint", 3.0)]), 0)
        .unwrap();
    steps(&mut original, 100);
    original.set_emitter(index(9), &[], 77).unwrap();
    let bytes = original.save();
    let mut restored = simulator(500, 99, &[STILL]);
    restored
        .set_emitter(index(380), &emitter(&[("share", 900.0)]), 0)
        .unwrap();
    restored.restore(&bytes).unwrap();
    assert!(restored.save() == bytes, "something was not restored");
    assert_eq!(restored.hash(), original.hash());
    for _ in 0..20 {
        steps(&mut original, 5);
        steps(&mut restored, 5);
        assert_eq!(restored.hash(), original.hash());
    }
}

#[test]
fn a_state_without_a_pool_has_no_bytes_of_it() {
    let mut simulator = simulator(100, 3, &[LIVELY]);
    let bytes = simulator.save();
    let section = bytes.windows(4).position(|name| name == b"born").unwrap();
    let length = u32::from_le_bytes(bytes[section + 4..section + 8].try_into().unwrap());
    assert_eq!(length as usize, 16 * LIST_LIMIT);
    simulator.set_emitter(index(0), &emitter(&[]), 0).unwrap();
    assert!(simulator.save().len() > bytes.len());
}

#[test]
fn what_is_out_of_range_is_an_error_and_changes_nothing() {
    let mut simulator = simulator(100, 3, &[STILL, SILENT, &[("emitters.0.speed", 1.0)]]);
    simulator.set_emitter(index(1), &emitter(&[("share", 1.0)]), 0).unwrap();
    let before = simulator.save();
    let rejects = |simulator: &mut Simulator, index: u32, numbers: &[f64]| {
        simulator.set_emitter(index, numbers, 1).unwrap_err().key
    };
    assert_eq!(rejects(&mut simulator, index(0), &emitter(&[("speed", 51.0)])), "speed");
    assert_eq!(
        rejects(&mut simulator, index(0), &emitter(&[("size", f64::NAN)])),
        "size"
    );
    assert_eq!(rejects(&mut simulator, index(0), &emitter(&[("tint", 1.5)])), "tint");
    assert_eq!(rejects(&mut simulator, index(0), &emitter(&[])[..29]), "rigid");
    assert_eq!(
        rejects(&mut simulator, index(POOL_LIMIT as u32), &emitter(&[])),
        "emitter"
    );
    for missing in [1, 7, index(2), u32::MAX] {
        assert_eq!(rejects(&mut simulator, missing, &[]), "emitter");
    }
    assert!(simulator.save() == before);
}

#[test]
fn it_has_bursts_at_each_start_and_rates_up_to_that_of_all_smoke() {
    let mut simulator = simulator(8000, 1, &[STILL, SILENT]);
    let puffs = [
        ("share", 0.0),
        ("burst.count", 7.0),
        ("envelope.period", 0.5),
        ("envelope.duration", 0.1),
    ];
    simulator.set_emitter(index(2), &emitter(&puffs), 0).unwrap();
    steps(&mut simulator, 59);
    assert_eq!(simulator.alive(), 14);
    simulator
        .set_emitter(index(2), &emitter(&[("share", 20_000.0)]), 0)
        .unwrap();
    steps(&mut simulator, 15);
    assert_eq!(simulator.alive(), 14 + 5000);
    assert!(
        simulator
            .set_emitter(index(2), &emitter(&[("share", 20_001.0)]), 0)
            .is_err()
    );
}

#[test]
fn to_free_a_slot_of_an_empty_pool_changes_nothing() {
    let mut simulator = simulator(100, 1, &[STILL]);
    let hash = simulator.hash();
    simulator.set_emitter(index(2), &[], 0).unwrap();
    assert_eq!(simulator.hash(), hash);
}

/// Three steps long, 45 particles after 0.1 s.
const PASSING: &[(&str, f64)] = &[
    ("share", 900.0),
    ("envelope.start", 0.1),
    ("envelope.duration", 3.0 * STEP),
    ("lifetime", 20.0),
];

#[test]
fn an_emission_starts_and_ends_by_itself_with_an_exact_count() {
    for before in [0, 7, 250_000] {
        let mut simulator = simulator(4000, 1, &[STILL, SILENT]);
        steps(&mut simulator, before);
        simulator.input_emission(&emitter(PASSING), None).unwrap();
        steps(&mut simulator, 6);
        assert_eq!(simulator.alive(), 0);
        steps(&mut simulator, 1);
        assert_eq!(simulator.alive(), 15);
        steps(&mut simulator, 60);
        assert_eq!(simulator.alive(), 45, "after {before} steps");
    }
}

#[test]
fn emissions_take_the_slots_that_are_over() {
    let mut simulator = simulator(40, 1, &[STILL, SILENT]);
    let begin = |simulator: &mut Simulator| simulator.input_emission(&emitter(PASSING), None).unwrap();
    let numbers: Vec<_> = (0..=POOL_LIMIT).map(|_| begin(&mut simulator)).collect();
    assert_eq!(
        numbers[..2],
        [Some(6 * POOL_LIMIT as u64), Some(6 * POOL_LIMIT as u64 + 1)]
    );
    assert_eq!(numbers[POOL_LIMIT], None);
    steps(&mut simulator, 20);
    assert_eq!(begin(&mut simulator), None, "births of each wait for capacity");
    simulator.input_clear().unwrap();
    assert_eq!(begin(&mut simulator), Some(26 * POOL_LIMIT as u64));
}

#[test]
fn a_change_moves_an_emission_until_it_is_over() {
    let mut simulator = simulator(4000, 1, &[STILL, SILENT]);
    let number = simulator.input_emission(&emitter(PASSING), None).unwrap();
    steps(&mut simulator, 8);
    let mut moved = [f64::NAN; EMITTER_NUMBERS];
    moved[1] = 50.0;
    assert_eq!(simulator.input_emission(&moved, number).unwrap(), number);
    steps(&mut simulator, 12);
    let far = (0..simulator.alive()).filter(|i| place(&simulator, *i)[0] > 40.0);
    assert_eq!((far.count(), simulator.alive()), (15, 45));
    assert_eq!(simulator.input_emission(&moved, number).unwrap(), None);
    let next = simulator.input_emission(&emitter(PASSING), None).unwrap();
    assert_ne!(next, number);
    assert_eq!(
        simulator.input_emission(&moved, number).unwrap(),
        None,
        "its slot is another's"
    );
    moved[1] = 1e9;
    assert_eq!(simulator.input_emission(&moved, next).unwrap_err().key, "position");
}
