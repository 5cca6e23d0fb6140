//! Looks in saved states, takes, hashes and changes of the capacity.

use crate::common::inputs::emitter;
use crate::common::{LIVELY, simulator, steps};
use sim::Simulator;
use sim::layout::parameters::LIST_LIMIT;
use sim::simulator::take::Take;

/// Looks of the table, one of them with a tint.
const LOOKS: &[(&str, f64)] = &[
    ("emitters.0.look.drag", 2.0),
    ("emitters.0.look.style", 11.0),
    ("emitters.1.look.lifetime", 0.8),
    ("emitters.1.look.dissolve", 3.0),
    ("emitters.1.tint", 4.0),
    ("emitters.2.perMetre", 30.0),
    ("emitters.2.tint", 2.0),
];

/// A running simulator with looks of the table and of the pool, puffs of looks that no emitter has any more, and tints by
/// a collider.
fn looking() -> Simulator {
    let mut simulator = simulator(
        700,
        3,
        &[LIVELY, LOOKS, &[("colliders.1.action", 2.0), ("colliders.1.tint", 7.0)]],
    );
    let pooled = emitter(&[
        ("share", 90.0),
        ("look.buoyancy", 3.0),
        ("look.sizeCurve.0", 4e9),
        ("tint", 1.0),
    ]);
    simulator.set_emitter(LIST_LIMIT as u32 + 300, &pooled, 0).unwrap();
    for step in 0..60 {
        simulator.set("emitters.2.position.y", 0.01 * f64::from(step)).unwrap();
        simulator.step();
    }
    simulator
        .set_all(&[("emitters.0.look.style", 12.0), ("emitters.0.look.gravity", 0.0)])
        .unwrap();
    steps(&mut simulator, 5);
    simulator.set("emitters.2.position.y", 0.1).unwrap();
    let looks = (0..simulator.alive()).fold(0, |looks, i| looks | 1 << simulator.particles().look(i));
    assert_eq!(looks, 0b11111, "looks 1 to 4, and puffs without one");
    assert!((0..simulator.alive()).any(|i| simulator.particles().look(i) > 0 && simulator.particles().tint(i) == 7));
    simulator
}

#[test]
fn it_continues_from_a_state_that_was_saved_midway() {
    let mut original = looking();
    let bytes = original.save();
    let mut restored = simulator(700, 8, &[LIVELY]);
    steps(&mut restored, 9);
    restored.restore(&bytes).unwrap();
    assert_eq!(restored.hash(), original.hash());
    assert_eq!(restored.look_styles(), original.look_styles());
    assert!(restored.save() == bytes, "something was not restored");
    for round in 0..20 {
        for simulator in [&mut original, &mut restored] {
            simulator.set("emitters.1.look.style", f64::from(round % 3)).unwrap();
            steps(simulator, 7);
        }
        assert_eq!(restored.hash(), original.hash());
    }
    assert!(restored.save() == original.save());
}

#[test]
fn a_state_without_looks_ends_them() {
    let mut simulator = looking();
    let plain = crate::common::simulator(700, 8, &[LIVELY]);
    let bytes = plain.save();
    simulator.restore(&bytes).unwrap();
    assert!(!simulator.has_looks());
    assert!(simulator.save() == bytes);
}

#[test]
fn damaged_looks_are_errors_or_harmless() {
    let mut simulator = looking();
    let (good, hash) = (simulator.save(), simulator.hash());
    for place in (16..good.len()).rev().step_by(701) {
        let mut bytes = good.clone();
        bytes[place] ^= 0x51;
        assert!(simulator.restore(&bytes).is_err());
        assert_eq!(simulator.hash(), hash);
    }
}

#[test]
fn looks_that_no_emitter_has_do_not_change_the_hash() {
    let run = |settings: &[(&str, f64)]| {
        let silent = [("emitters.3.share", 0.0), ("emitters.2.tint", 5.0)];
        let mut simulator = simulator(700, 3, &[LIVELY, &silent, settings]);
        steps(&mut simulator, 50);
        (simulator.hash(), simulator.has_looks())
    };
    let plain = run(&[]);
    assert!(!plain.1);
    // Values that follow the smoke are no look.
    let neutral = [("emitters.0.look.drag", 1.0), ("emitters.1.look.style", 0.0)];
    assert_eq!(run(&neutral), plain);
    // A look of an emitter that never emits.
    assert_eq!(run(&[("emitters.3.look.drag", 2.0)]), (plain.0, true));
    // Each number of a look of one that does.
    let mut hashes = vec![plain.0];
    for (key, value) in [
        ("drag", 2.0),
        ("buoyancy", 2.0),
        ("gravity", 2.0),
        ("style", 2.0),
        ("style", 3.0),
        ("lifetime", 1.0),
        ("growthTime", 1.0),
        ("dissolve", 1.0),
        ("sizeCurve.0", 2e9),
        ("densityCurve.7", 2e9),
    ] {
        hashes.push(run(&[(&format!("emitters.0.look.{key}"), value)]).0);
    }
    let count = hashes.len();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), count, "two looks have the same hash");
}

#[test]
fn a_take_replays_looks_that_come_and_go_within_a_step() {
    let mut live = simulator(500, 4, &[LIVELY]);
    live.record();
    let set = |simulator: &mut Simulator, emitter: u32, style: f64| {
        let key = format!("emitters.{emitter}.look.style");
        simulator.input_values(&[(&key, style)]).unwrap();
    };
    let mut hashes = Vec::new();
    for round in 0..12_u32 {
        // A take keeps only the last input of a step: the first look must leave no trace.
        set(&mut live, 0, f64::from(100 + round));
        set(&mut live, 1, f64::from(round % 4));
        set(&mut live, 0, f64::from(round % 3));
        let burst = [
            ("share", 0.0),
            ("burst.count", 4.0),
            ("envelope.duration", 0.1),
            ("look.lifetime", 0.2 + 0.1 * f64::from(round % 2)),
        ];
        assert!(live.input_emission(&emitter(&burst), None).unwrap().is_some());
        assert!(live.input_emission(&emitter(&burst)[..30], None).unwrap().is_some());
        steps(&mut live, 9);
        hashes.push(live.hash());
    }
    let bytes = live.take("").unwrap();
    assert!(Take::parse(&bytes).unwrap().to_bytes() == bytes);
    let mut other = simulator(500, 5, &[LIVELY]);
    other.record();
    steps(&mut other, 3);
    other.replay(&bytes).unwrap();
    for hash in hashes {
        steps(&mut other, 9);
        assert_eq!(other.hash(), hash);
    }
}

#[test]
fn a_take_of_a_fresh_scene_brings_its_looks() {
    let mut live = simulator(500, 4, &[LIVELY, LOOKS]);
    live.record();
    steps(&mut live, 40);
    let bytes = live.take("").unwrap();
    let mut other = simulator(500, 5, &[LIVELY]);
    other.record();
    other.replay(&bytes).unwrap();
    steps(&mut other, 40);
    assert_eq!((other.hash(), other.look_styles()), (live.hash(), live.look_styles()));
    assert!(other.particles().flow.is_some(), "torn puffs need their motion");
}

#[test]
fn another_capacity_keeps_looks_and_tints() {
    let mut simulator = looking();
    let looks = |simulator: &Simulator| {
        let particles = simulator.particles();
        let mut all: Vec<_> = (0..simulator.alive())
            .map(|i| (particles.x[i].to_bits(), particles.look(i), particles.tint(i)))
            .collect();
        all.sort_unstable();
        all
    };
    let before = looks(&simulator);
    simulator.resize(2000).unwrap();
    assert_eq!(looks(&simulator), before);
    simulator.resize(100).unwrap();
    let after = looks(&simulator);
    assert_eq!(after.len(), 100);
    assert!(after.iter().all(|one| before.contains(one)));
}

#[test]
fn parameters_that_are_not_set_are_not_saved() {
    let plain = simulator(500, 4, &[LIVELY]);
    let entries = plain.parameters().entries();
    assert!(
        entries
            .iter()
            .all(|(key, _)| !key.contains("look.") && !key.contains("perMetre"))
    );
}
