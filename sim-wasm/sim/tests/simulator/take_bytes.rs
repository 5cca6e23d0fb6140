//! Serialisation of takes and saved simulations: damage is an error and changes nothing.

use crate::common::inputs::{Act, perform, script};
use crate::common::{LIVELY, simulator, steps};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use sim::Simulator;
use sim::math::hash::Hash;
use sim::math::random::Random;
use sim::simulator::take::Take;

/// A take with every kind of input.
fn rich() -> Vec<u8> {
    let script = script().new_tree(&mut TestRunner::deterministic()).unwrap().current();
    let mut live = simulator(60, 3, &[LIVELY]);
    live.record();
    for (wait, act) in script.iter().chain(&script) {
        steps(&mut live, *wait);
        if !matches!(act, Act::Move(..) | Act::Drag(..) | Act::Release(_)) {
            perform(&mut live, act);
        }
    }
    live.take("the note").unwrap()
}

fn running() -> Simulator {
    let mut running = simulator(60, 8, &[LIVELY]);
    running.record();
    steps(&mut running, 20);
    running
}

/// Bytes with a recomputed envelope, as an attacker could send them.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let mut hash = Hash::new();
    let (words, rest) = bytes[16..].as_chunks::<4>();
    words.iter().for_each(|word| hash.word(u32::from_le_bytes(*word)));
    hash.bytes(rest);
    bytes[8..16].copy_from_slice(&hash.finish().to_le_bytes());
    bytes
}

#[test]
fn takes_round_trip_through_bytes() {
    let bytes = rich();
    let take = Take::parse(&bytes).unwrap();
    assert!(take.to_bytes() == bytes);
    assert_eq!(
        (take.note.as_str(), take.origin.seed, take.origin.capacity),
        ("the note", 3, 60)
    );
    assert!(take.log.len() > 10);
    assert!(sealed(bytes.clone()) == bytes, "the test seals as the product does");
}

#[test]
fn every_truncation_and_every_changed_byte_is_an_error() {
    let bytes = rich();
    for length in 0..bytes.len() {
        assert!(Take::parse(&bytes[..length]).is_err(), "the first {length} bytes");
    }
    assert!(Take::parse(&[bytes.as_slice(), &[0]].concat()).is_err());
    for place in 0..bytes.len() {
        for change in [1, 0x80, 0xff] {
            let mut damaged = bytes.clone();
            damaged[place] ^= change;
            assert!(Take::parse(&damaged).is_err(), "byte {place} changed by {change}");
        }
    }
}

#[test]
fn only_version_1_can_be_read() {
    let mut bytes = rich();
    for version in [0, 2] {
        bytes[4] = version;
        let message = Take::parse(&bytes).unwrap_err().message;
        assert_eq!(
            message,
            format!("the take has format {version}, this version reads 1 only")
        );
    }
}

#[test]
fn an_error_changes_nothing() {
    let bytes = rich();
    let mut running = running();
    let before = (running.hash(), running.inputs(), running.save());
    for length in [0, 20, 100, bytes.len() - 1] {
        assert!(running.replay(&bytes[..length]).is_err());
    }
    let save = running.save();
    assert!(running.replay(&save).is_err(), "a saved simulation is no take");
    assert!(running.restore(&bytes).is_err(), "a take is no saved simulation");
    assert!(running.rewind(Some(&bytes)).is_err());
    assert!((running.hash(), running.inputs(), running.save()) == before);
    assert!(running.take(&"x".repeat(65_537)).is_err(), "too long a note");
    assert!(simulator(5, 1, &[]).take("").is_err(), "nothing was recorded");
    assert!(simulator(5, 1, &[]).replay(&bytes).is_err(), "no start to set out from");
}

/// Damage with a valid checksum is rejected or accepted as valid data; never a panic or a partial change.
fn survive(bytes: &[u8], running: &mut Simulator) {
    let before = (running.hash(), running.steps());
    if running.replay(bytes).is_err() && running.restore(bytes).is_err() {
        assert_eq!((running.hash(), running.steps()), before);
        return;
    }
    steps(running, 3);
    let home = running.save();
    running.rewind(None).unwrap();
    running.restore(&home).unwrap();
    *running = self::running();
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn forged_bytes_never_panic(seed in any::<u32>()) {
        let mut random = Random::new(seed);
        let mut running = running();
        for good in [rich(), running.save()] {
            for _ in 0..150 {
                let mut bytes = good.clone();
                for _ in 0..=random.below(3) {
                    let place = random.below(bytes.len() as u32) as usize;
                    bytes[place] = random.bits() as u8;
                }
                if random.below(4) == 0 {
                    bytes.truncate(16 + random.below(bytes.len() as u32 - 16) as usize);
                }
                survive(&sealed(bytes), &mut running);
            }
        }
    }
}
