//! Ageing by company.

use crate::common::{LIVELY, STEP, STILL, assert_close, newborn, simulator, steps};
use sim::Simulator;
use sim::life::company::{ALONE_PACE, GROUP_PACE, LATE, LATE_SPAN, PERIOD};
use sim::particles::Newborn;

const LIFETIME: f64 = 8.0;
/// Puffs keep their radius, so that a group stays one until its end.
const EVEN: &[(&str, f64)] = &[
    ("emission.rate", 0.0),
    ("density.0.age", 0.0),
    ("density.0.value", 1.0),
    ("density.1.age", 1.0),
    ("density.1.value", 1.0),
];

fn still(company: f64) -> Simulator {
    simulator(2000, 1, &[STILL, EVEN, &[("emission.company", company)]])
}

fn add(simulator: &mut Simulator, position: [f32; 3]) {
    simulator.add(&Newborn {
        lifetime: LIFETIME as f32,
        ..newborn(position)
    });
}

/// A ball of puffs as far apart as their size.
fn add_group(simulator: &mut Simulator, centre: [f32; 3]) {
    let at = |number: i32| number as f32 * 0.2;
    for (x, y, z) in (-5..=5).flat_map(|x| (-5..=5).flat_map(move |y| (-5..=5).map(move |z| (x, y, z)))) {
        if x * x + y * y + z * z <= 25 {
            add(simulator, [centre[0] + at(x), centre[1] + at(y), centre[2] + at(z)]);
        }
    }
}

/// Seconds until no more than `rest` particles are alive.
fn seconds_until(simulator: &mut Simulator, rest: usize) -> f64 {
    let mut count = 0;
    while simulator.alive() > rest {
        simulator.step();
        count += 1;
    }
    f64::from(count) * STEP
}

/// The solution of dw/dt = (1 + pace s(w)) / lifetime for the share w of life, where s rises from 0 at LATE to 1.
fn life_with(pace: f32) -> f64 {
    let (pace, late, span) = (f64::from(pace), f64::from(LATE), f64::from(LATE_SPAN));
    LIFETIME * (late + span * (1.0 + pace).ln() / pace + (1.0 - late - span) / (1.0 + pace))
}

#[test]
fn a_lone_puff_ends_after_the_time_of_the_closed_form() {
    for company in [0.3, 1.0] {
        let mut simulator = still(company);
        add(&mut simulator, [0.3, -0.7, 1.1]);
        let expected = life_with(company as f32 * ALONE_PACE);
        let tolerance = PERIOD as f64 * STEP / expected;
        assert_close("lone life", seconds_until(&mut simulator, 0), expected, tolerance);
    }
}

#[test]
fn the_middle_of_a_group_outlives_its_time_as_the_closed_form_says() {
    let mut simulator = still(1.0);
    add_group(&mut simulator, [-20.0, 0.0, 3.0]);
    let expected = life_with(-GROUP_PACE);
    assert_close("life in a group", seconds_until(&mut simulator, 20), expected, 0.03);
}

#[test]
fn stragglers_end_first_and_nothing_ends_late_alone() {
    let mut simulator = still(1.0);
    add_group(&mut simulator, [0.0; 3]);
    let grouped = simulator.alive();
    add(&mut simulator, [3.0, 0.0, 0.0]);
    steps(&mut simulator, (LIFETIME * 0.6 / STEP) as usize);
    let furthest = |simulator: &Simulator| {
        let x = &simulator.particles().x[..simulator.alive()];
        x.iter().copied().fold(f32::MIN, f32::max)
    };
    assert!(furthest(&simulator) < 2.0, "the straggler is alive");
    assert!(simulator.alive() > grouped / 3, "{} of {grouped}", simulator.alive());
}

#[test]
fn a_restored_state_ages_alike_and_the_pace_of_ageing_is_part_of_the_hash() {
    let company = [("emission.company", 0.7), ("emission.sizeSpread", 0.8)];
    let mut original = simulator(500, 3, &[LIVELY, &company]);
    steps(&mut original, 107);
    let extra_ageing = &original.particles().company.as_ref().unwrap().extra_ageing[..original.alive()];
    assert!(
        extra_ageing.iter().any(|extra_ageing| *extra_ageing > 0.0)
            && extra_ageing.iter().any(|extra_ageing| *extra_ageing < 0.0)
    );
    let mut restored = Simulator::new(500, 9).unwrap();
    restored.restore(&original.save()).unwrap();
    assert_eq!(restored.hash(), original.hash());
    steps(&mut original, 60);
    steps(&mut restored, 60);
    assert_eq!(restored.hash(), original.hash());
    let before = original.hash();
    original.set("emission.company", 0.0).unwrap();
    assert_ne!(original.hash(), before);
}

#[test]
fn without_company_nothing_is_kept() {
    let mut simulator = simulator(500, 3, &[LIVELY]);
    assert!(simulator.particles().company.is_none());
    simulator.set("emission.company", 1.0).unwrap();
    steps(&mut simulator, 90);
    simulator.resize(700).unwrap();
    assert!(simulator.particles().company.is_some());
    simulator.set("emission.company", 0.0).unwrap();
    assert!(simulator.particles().company.is_none());
}
