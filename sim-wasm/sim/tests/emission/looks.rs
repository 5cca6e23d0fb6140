//! The indices of looks: who has which, when one is reused, and their limit. Lifetimes of looks, and ends of bursts.

use std::collections::{BTreeMap, BTreeSet};

use crate::common::inputs::emitter;
use crate::common::{STEP, STILL, simulator, steps};
use sim::Simulator;
use sim::layout::parameters::LIST_LIMIT;

/// Only bursts emit.
const SILENT: &[(&str, f64)] = &[
    ("emission.rate", 0.0),
    ("emission.lifetime", 1.0),
    ("emitters.0.lifetimeVariation", 0.0),
];

/// The index of a slot in `set_emitter`.
fn slot(slot: u32) -> u32 {
    LIST_LIMIT as u32 + slot
}

/// Sets a slot whose puffs live for `lifetime` (s), with a style.
fn put(simulator: &mut Simulator, at: u32, style: f64, lifetime: f64, count: u32) -> Result<(), String> {
    let numbers = emitter(&[
        ("share", 0.0),
        ("lifetimeVariation", 0.0),
        ("look.style", style),
        ("look.lifetime", lifetime),
    ]);
    simulator
        .set_emitter(slot(at), &numbers, count)
        .map_err(|error| error.message)
}

/// Number of living puffs by the style of their look; 0 without a look.
fn styles(simulator: &Simulator) -> BTreeMap<u64, usize> {
    let styles = simulator.look_styles();
    let mut counts = BTreeMap::new();
    for i in 0..simulator.alive() {
        let style = match simulator.particles().look(i) as usize {
            0 => 0,
            look => styles[3 * (look - 1)] as u64,
        };
        *counts.entry(style).or_insert(0) += 1;
    }
    counts
}

/// The indices of living puffs.
fn indices(simulator: &Simulator) -> BTreeSet<u32> {
    (0..simulator.alive()).map(|i| simulator.particles().look(i)).collect()
}

#[test]
fn equal_looks_share_an_index_also_in_the_table_and_the_pool() {
    let table = [
        ("emitters.0.look.drag", 2.0),
        ("emitters.1.look.drag", 2.0),
        ("emitters.2.look.drag", 2.5),
        ("emitters.3.look.drag", 2.0),
        // The tint is a part of the look.
        ("emitters.3.tint", 1.0),
        ("emitters.4.size", 0.2),
        ("emission.rate", 500.0),
    ];
    let mut simulator = simulator(2000, 1, &[STILL, SILENT, &table]);
    simulator
        .set_emitter(slot(7), &emitter(&[("look.drag", 2.5)]), 3)
        .unwrap();
    steps(&mut simulator, 30);
    assert_eq!(indices(&simulator), BTreeSet::from([0, 1, 2, 3]));
}

#[test]
fn puffs_in_the_air_keep_the_look_of_their_birth() {
    let settings = [("emitters.0.burst.count", 5.0), ("emitters.0.look.style", 4.0)];
    let mut simulator = simulator(100, 1, &[STILL, SILENT, &settings]);
    steps(&mut simulator, 1);
    simulator.set("emitters.0.look.style", 6.0).unwrap();
    simulator.set_emitter(0, &[], 3).unwrap();
    steps(&mut simulator, 1);
    assert_eq!(styles(&simulator), BTreeMap::from([(4, 5), (6, 3)]));
    simulator.set("emitters.0.look.style", 0.0).unwrap();
    simulator.set_emitter(0, &[], 2).unwrap();
    steps(&mut simulator, 1);
    assert_eq!(styles(&simulator), BTreeMap::from([(0, 2), (4, 5), (6, 3)]));
}

#[test]
fn the_sixteenth_look_is_an_error_and_changes_nothing() {
    let mut simulator = simulator(100, 1, &[STILL, SILENT]);
    for at in 0..15 {
        put(&mut simulator, at, f64::from(at + 1), 2.0, 1).unwrap();
    }
    // Even before births: their births wait.
    let refuse = |simulator: &mut Simulator| {
        let before = (simulator.save(), simulator.hash());
        let message = put(simulator, 20, 99.0, 2.0, 1).unwrap_err();
        assert!(
            message.contains("16 looks") && message.contains("at most 15"),
            "{message}"
        );
        let error = simulator.set("emitters.0.look.style", 99.0).unwrap_err();
        assert_eq!((error.key.as_str(), error.value, error.max), ("look", 16.0, 15.0));
        simulator.record();
        assert!(simulator.input_values(&[("emitters.0.look.style", 99.0)]).is_err());
        assert!(
            simulator
                .input_emission(&emitter(&[("look.style", 99.0)]), None)
                .is_err()
        );
        assert_eq!(simulator.inputs(), (0, 0));
        assert!((simulator.save(), simulator.hash()) == before);
    };
    refuse(&mut simulator);
    steps(&mut simulator, 30);
    assert_eq!(indices(&simulator), (1..=15).collect());
    // Now of puffs in the air.
    refuse(&mut simulator);
    // One that is known is no further one.
    put(&mut simulator, 20, 15.0, 2.0, 4).unwrap();
    steps(&mut simulator, 1);
    assert_eq!(styles(&simulator)[&15], 5);
}

#[test]
fn an_index_is_reused_when_its_last_puff_is_dead() {
    let mut simulator = simulator(100, 1, &[STILL, SILENT]);
    for at in 0..15 {
        let lifetime = if at == 6 { 0.5 } else { 4.0 };
        put(&mut simulator, at, f64::from(at + 1), lifetime, 1).unwrap();
    }
    let next = |simulator: &mut Simulator| put(simulator, 20, 99.0, 2.0, 1);
    for step in 0..31 {
        assert!(next(&mut simulator).is_err(), "after {step} steps");
        steps(&mut simulator, 1);
    }
    steps(&mut simulator, 2);
    assert_eq!(simulator.alive(), 14);
    next(&mut simulator).unwrap();
    steps(&mut simulator, 1);
    assert_eq!(indices(&simulator), (1..=15).collect());
    assert_eq!(simulator.look_styles()[18], 99.0, "it has the index that became free");
    assert!(put(&mut simulator, 21, 98.0, 2.0, 1).is_err());
    steps(&mut simulator, 300);
    assert_eq!(simulator.alive(), 0);
    for at in 0..15 {
        put(&mut simulator, at, f64::from(at + 50), 1.0, 1).unwrap();
    }
}

#[test]
fn an_emission_that_is_over_has_no_look_any_more() {
    let mut simulator = simulator(100, 1, &[STILL, SILENT]);
    for style in 1..=15 {
        let short = [
            ("share", 60.0),
            ("envelope.duration", 0.1),
            ("look.style", f64::from(style)),
            ("look.lifetime", 0.3),
            ("lifetimeVariation", 0.0),
        ];
        assert!(simulator.input_emission(&emitter(&short), None).unwrap().is_some());
    }
    assert!(
        simulator
            .input_emission(&emitter(&[("look.style", 16.0)]), None)
            .is_err()
    );
    steps(&mut simulator, 30);
    assert_eq!(simulator.alive(), 0);
    assert!(
        simulator
            .input_emission(&emitter(&[("look.style", 16.0)]), None)
            .unwrap()
            .is_some()
    );
}

#[test]
fn tints_move_to_a_column_and_colliders_change_them_alone() {
    let settings = [
        ("emission.rate", 200.0),
        ("emitters.0.tint", 5.0),
        ("emitters.1.position.x", 50.0),
        ("emitters.2.position.x", 100.0),
        ("emitters.2.tint", 9.0),
        ("colliders.0.shape", 1.0),
        ("colliders.0.position.x", 100.0),
        ("colliders.0.radius", 30.0),
        ("colliders.0.action", 2.0),
        ("colliders.0.tint", 15.0),
    ];
    let mut plain = simulator(1000, 1, &[STILL, SILENT, &settings]);
    let mut looking = simulator(1000, 1, &[STILL, SILENT, &settings]);
    for simulator in [&mut plain, &mut looking] {
        steps(simulator, 10);
    }
    assert!(!looking.has_looks());
    let hash = looking.hash();
    looking.set("emitters.2.look.style", 1.0).unwrap();
    assert!(looking.has_looks());
    assert_eq!(looking.hash(), hash, "a look acts before a birth");
    for simulator in [&mut plain, &mut looking] {
        steps(simulator, 20);
        let particles = simulator.particles();
        for i in 0..simulator.alive() {
            let expected = [5, 0, 15][(particles.x[i] / 50.0).round() as usize];
            assert_eq!(particles.tint(i), expected);
        }
    }
    assert_eq!(indices(&looking), BTreeSet::from([0, 1]));
    for i in 0..looking.alive() {
        assert!(looking.particles().look(i) == 0 || looking.particles().x[i] > 75.0);
    }
}

#[test]
fn a_lifetime_of_a_look_is_in_seconds_and_varies() {
    let settings = [
        ("emission.rate", 0.0),
        ("emission.lifetime", 7.0),
        ("emitters.0.lifetime", 3.0),
        ("emitters.0.lifetimeVariation", 0.5),
        ("emitters.0.look.lifetime", 2.0),
        ("emitters.0.burst.count", 400.0),
    ];
    let mut simulator = simulator(400, 1, &[STILL, &settings]);
    steps(&mut simulator, 1);
    let lifetimes = &simulator.particles().lifetime[..400];
    assert!(lifetimes.iter().all(|lifetime| (1.0..=3.0).contains(lifetime)));
    let mean = lifetimes.iter().sum::<f32>() / 400.0;
    assert!((mean - 2.0).abs() < 0.1, "{mean}");
    assert!(lifetimes.iter().any(|lifetime| *lifetime > 2.8));
}

#[test]
fn a_burst_ends_with_its_longest_lifetime() {
    let mut simulator = simulator(500, 1, &[STILL, SILENT, &[("emission.lifetime", 2.0)]]);
    let numbers = emitter(&[("share", 0.0), ("lifetimeVariation", 0.5)]);
    assert_eq!(simulator.burst_end(slot(3)), None);
    simulator.set_emitter(slot(3), &numbers, 40).unwrap();
    assert_eq!(simulator.burst_end(slot(3)), None, "no puff is born");
    steps(&mut simulator, 1);
    let end = simulator.burst_end(slot(3)).unwrap();
    let longest = simulator.particles().lifetime[..40].iter().copied().fold(0.0, f32::max);
    assert!(
        (end as f64 * STEP - f64::from(longest)).abs() < 2.0 * STEP,
        "{end} for {longest} s"
    );
    // It does not matter which puffs are drawn.
    while simulator.steps() + 1 < end {
        steps(&mut simulator, 1);
        assert_eq!(simulator.burst_end(slot(3)), Some(end));
    }
    let left = |simulator: &Simulator| {
        let particles = simulator.particles();
        (0..simulator.alive())
            .filter(|i| particles.age[*i] < particles.lifetime[*i])
            .count()
    };
    assert_eq!(left(&simulator), 1, "a step too early");
    steps(&mut simulator, 1);
    assert_eq!(left(&simulator), 0, "at its end");
    // The next one has its own.
    simulator.set_emitter(slot(3), &[], 1).unwrap();
    assert_eq!(simulator.burst_end(slot(3)), None);
    steps(&mut simulator, 1);
    assert!(simulator.burst_end(slot(3)).unwrap() > end);
    simulator.input_clear().unwrap();
    assert_eq!(simulator.burst_end(slot(3)), None);
    assert_eq!(simulator.burst_end(4_000_000), None);
}

#[test]
fn a_burst_that_waits_for_capacity_has_no_end_yet() {
    let mut simulator = simulator(50, 1, &[STILL, SILENT]);
    let numbers = emitter(&[("share", 0.0), ("lifetimeVariation", 0.0), ("look.lifetime", 0.5)]);
    simulator.set_emitter(slot(0), &numbers, 80).unwrap();
    steps(&mut simulator, 20);
    assert_eq!((simulator.burst_end(slot(0)), simulator.waiting()), (None, 30));
    steps(&mut simulator, 15);
    assert_eq!(simulator.waiting(), 0);
    let end = simulator.burst_end(slot(0)).unwrap();
    assert!((60..=64).contains(&end), "{end}");
}
