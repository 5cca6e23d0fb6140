//! Saving, restoring and resizing.

use crate::common::{LIVELY, STILL, newborn, simulator, steps};
use sim::Simulator;
use sim::math::random::Random;
use sim::particles::Newborn;

/// A running simulator: full, with waiting births.
fn busy() -> Simulator {
    let mut simulator = simulator(500, 3, &[LIVELY]);
    steps(&mut simulator, 100);
    assert!(simulator.waiting() > 0 && simulator.alive() > 450);
    simulator
}

#[test]
fn it_continues_from_a_restored_state_to_the_same_hash() {
    let mut original = busy();
    let bytes = original.save();
    // Another seed, capacity, parameters and particles, none of which may remain.
    let mut restored = simulator(
        900,
        99,
        &[STILL, &[("forces.wind.z", 4.0), ("vortices.5.circulation", 9.0)]],
    );
    restored.add(&newborn([0.0; 3]));
    steps(&mut restored, 7);
    restored.restore(&bytes).unwrap();
    assert_eq!(
        (restored.hash(), restored.steps(), restored.waiting()),
        (original.hash(), 100, original.waiting())
    );
    assert_eq!(restored.parameters(), original.parameters());
    // The larger one has more room for waiting particles: continue with the same capacity.
    restored.resize(500).unwrap();
    assert!(restored.save() == bytes, "something was not restored");
    for _ in 0..60 {
        steps(&mut original, 5);
        steps(&mut restored, 5);
        assert_eq!(restored.hash(), original.hash());
    }
}

#[test]
fn damaged_bytes_are_errors_and_change_nothing() {
    let mut simulator = busy();
    let good = simulator.save();
    steps(&mut simulator, 3);
    let before = (simulator.hash(), *simulator.parameters());
    let mut random = Random::new(5);
    let mut rejects = |bytes: &[u8], what: &str| {
        let error = simulator.restore(bytes).expect_err(what);
        assert!(!error.message.is_empty());
        assert_eq!(
            (simulator.hash(), *simulator.parameters()),
            before,
            "{what} changed something"
        );
    };
    for length in [0, 1, 7, 15, 16, 17, 100, good.len() / 2, good.len() - 1] {
        rejects(&good[..length], &format!("the first {length} bytes"));
    }
    rejects(&[good.as_slice(), &[0]].concat(), "a byte more");
    for _ in 0..300 {
        let (place, bit) = (random.below(good.len() as u32) as usize, random.below(8));
        let mut bytes = good.clone();
        bytes[place] ^= 1 << bit;
        rejects(&bytes, &format!("bit {bit} of byte {place} turned"));
    }
    simulator.restore(&good).unwrap();
}

#[test]
fn exceeding_the_capacity_is_an_error() {
    let busy = busy();
    let mut small = Simulator::new(busy.alive() as u32 - 1, 1).unwrap();
    let error = small.restore(&busy.save()).unwrap_err();
    assert!(error.message.contains(&busy.alive().to_string()), "{error}");
    assert_eq!((small.alive(), small.steps()), (0, 0));
}

#[test]
fn a_larger_capacity_keeps_all_living_particles() {
    let mut simulator = busy();
    let (hash, waiting) = (simulator.hash(), simulator.waiting());
    simulator.resize(2000).unwrap();
    assert_eq!((simulator.hash(), simulator.capacity()), (hash, 2000));
    simulator.step();
    assert!(
        simulator.waiting() < waiting && simulator.alive() > 500,
        "what waited uses the new room"
    );
}

#[test]
fn a_smaller_capacity_keeps_the_particles_with_the_longest_remaining_life() {
    let mut simulator = simulator(100, 1, &[STILL]);
    for i in 0..100 {
        let age = (i * 37 % 100) as f32 * 0.01;
        simulator.add(&Newborn {
            age,
            lifetime: 1.0,
            ..newborn([age, 0.0, 0.0])
        });
    }
    simulator.resize(30).unwrap();
    assert_eq!((simulator.alive(), simulator.capacity()), (30, 30));
    let particles = simulator.particles();
    for i in 0..30 {
        assert!(particles.age[i] < 0.295, "one of age {} was kept", particles.age[i]);
        assert_eq!(particles.x[i], particles.age[i], "columns of slot {i} got mixed up");
    }
    assert!(simulator.resize(0).is_err());
    assert_eq!(simulator.capacity(), 30);
}
