//! Errors of invalid input: their keys, and that nothing changes.

use crate::common::{LIVELY, simulator};
use sim::Simulator;
use sim::layout::parameters::Parameters;
use sim::layout::parameters::{describe, rows};

#[test]
fn every_parameter_rejects_nan_and_values_out_of_range() {
    let mut simulator = simulator(100, 1, &[LIVELY]);
    let before = *simulator.parameters();
    for row in rows() {
        let key = row.key.replace('#', "7");
        let below = row.meta.min - 0.001_f64.max(row.meta.min.abs() * 1e-9);
        let above = row.meta.max + 0.001_f64.max(row.meta.max.abs() * 1e-9);
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, below, above, 1e300, -1e300] {
            let error = simulator.set(&key, value).unwrap_err();
            assert_eq!(
                (error.key.as_str(), error.min, error.max),
                (key.as_str(), row.meta.min, row.meta.max)
            );
            assert!(
                error.value.to_bits() == value.to_bits() && error.message.contains(&key),
                "{error:?}"
            );
            assert_eq!(
                *simulator.parameters(),
                before,
                "{key} = {value} was refused and still changed something"
            );
        }
    }
}

#[test]
fn every_parameter_takes_its_ends_and_its_default() {
    let mut simulator = Simulator::new(100, 1).unwrap();
    for row in rows() {
        for value in [row.meta.min, row.meta.max, row.default] {
            let key = row.key.replace('#', "0");
            simulator.set(&key, value).unwrap();
            let entries = simulator.parameters().entries();
            let is_left_out = row.meta.rare && value == row.default;
            assert!(
                is_left_out || entries.contains(&(key.clone(), value)),
                "{key} = {value} is not among the entries"
            );
        }
    }
}

#[test]
fn fractions_are_errors_for_whole_parameters() {
    for row in rows().iter().filter(|row| row.meta.whole) {
        let error = Parameters::default()
            .set(&row.key.replace('#', "0"), row.meta.min + 0.5)
            .unwrap_err();
        assert!(error.message.contains("whole"), "{error}");
    }
}

#[test]
fn unknown_keys_are_errors_with_the_key() {
    let keys = [
        "",
        "emission",
        "emission.rat",
        "emission.rate ",
        "emitters.8.size",
        "emitters.-1.size",
        "emitters.00.size",
        "emitters..size",
        "emitters.+1.size",
        "emitters.#.size",
        "emitters.0.sizes",
        "vortices.0",
        "__proto__",
    ];
    for key in keys {
        let error = Parameters::default().set(key, 1.0).unwrap_err();
        assert_eq!(error.key, key);
        assert!(
            error.message.contains(key) && error.message.contains("no parameter"),
            "{error}"
        );
    }
}

#[test]
fn a_set_of_values_is_applied_completely_or_not_at_all() {
    let mut simulator = Simulator::new(100, 1).unwrap();
    let before = *simulator.parameters();
    let bundle = [
        ("emission.rate", 5.0),
        ("vortices.2.reach", 1.0),
        ("puff.size", f64::NAN),
    ];
    assert_eq!(simulator.set_all(&bundle).unwrap_err().key, "puff.size");
    assert_eq!(*simulator.parameters(), before);
    simulator.set_all(&bundle[..2]).unwrap();
    assert_eq!(simulator.parameters().emission.rate, 5.0);
    assert_eq!(simulator.parameters().lists.vortices.items().len(), 3);
}

#[test]
fn capacities_have_a_range() {
    for capacity in [0, 1_000_001, u32::MAX] {
        let error = Simulator::new(capacity, 1).err().unwrap();
        assert_eq!(
            (error.key.as_str(), error.min, error.max),
            ("simulation.maxParticles", 1.0, 1e6)
        );
    }
}

#[test]
fn the_description_has_a_line_for_each_key() {
    let text = describe();
    assert_eq!(text.lines().count(), rows().len());
    assert!(text.contains("emission.rate 0 20000 28 real particles/s\n"), "{text}");
}
