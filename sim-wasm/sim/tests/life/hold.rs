//! Drawing on twos, threes and fours: rows change at held moments only, and nothing else changes.

use crate::common::{LIVELY, STILL, newborn, simulator, steps};
use sim::Simulator;
use sim::arrange::row_layout::Attributes;
use sim::arrange::view_layout::{VIEW_LENGTH, ViewNumbers};
use sim::particles::Newborn;

const COUNT: u32 = 64;

/// Everything, in the middle between two steps.
fn view(blend: f32) -> [f32; VIEW_LENGTH] {
    let mut view = ViewNumbers {
        blend,
        direction: [0.0, 0.0, -1.0],
        reach: 1.0,
        receivers: [-99.0, -99.0, -99.0, 99.0, 99.0, 99.0],
        ..ViewNumbers::default()
    };
    let clip = &mut view.clip_from_world;
    (clip[0], clip[5], clip[10], clip[15]) = (0.01, 0.01, -0.01, 1.0);
    view.to_array()
}

/// Particles side by side, each with a different seed, in a steady wind.
fn procession(hold: f64) -> Simulator {
    let settings = [("forces.wind.x", 1.0), ("drag.rate", 1000.0), ("style.hold", hold)];
    let mut simulator = simulator(COUNT, 1, &[STILL, &settings]);
    for i in 0..COUNT {
        let attributes = (i * 256 / COUNT) << 8;
        simulator.add(&Newborn {
            attributes,
            ..newborn([0.0, 0.0, -(i as f32)])
        });
    }
    simulator
}

/// Shown x of each particle, in the order of birth.
fn shown(simulator: &mut Simulator, blend: f32) -> Vec<f32> {
    let count = simulator.arrange(&view(blend)).unwrap();
    simulator.place()[..count].iter().map(|place| place[0]).collect()
}

fn rows(simulator: &mut Simulator) -> (Vec<[f32; 4]>, Vec<Attributes>) {
    let count = simulator.arrange(&view(0.4)).unwrap();
    (
        simulator.place()[..count].to_vec(),
        simulator.attributes()[..count].to_vec(),
    )
}

#[test]
fn each_moves_at_the_held_rate_and_they_are_staggered() {
    for (hold, moves) in [(2.0, 12), (3.0, 8), (4.0, 6)] {
        let mut simulator = procession(hold);
        steps(&mut simulator, 30);
        let mut moved = vec![0; COUNT as usize];
        let mut before = shown(&mut simulator, 0.5);
        for _ in 0..60 {
            simulator.step();
            let now = shown(&mut simulator, 0.5);
            let movers = (0..now.len()).filter(|i| now[*i] != before[*i]);
            let together = movers.inspect(|i| moved[*i] += 1).count();
            assert!(
                together < COUNT as usize / 2,
                "{together} moved at once on a hold of {hold}"
            );
            let true_x = simulator.particles().x[0];
            let oldest = true_x - (hold as f32 * 2.5).ceil() / 60.0;
            assert!(now.iter().all(|x| (oldest - 1e-4..=true_x + 1e-4).contains(x)));
            before = now;
        }
        assert!(moved.iter().all(|count| *count == moves), "{moved:?}");
    }
}

#[test]
fn nothing_moves_between_steps() {
    let mut simulator = procession(3.0);
    steps(&mut simulator, 40);
    assert_eq!(shown(&mut simulator, 0.0), shown(&mut simulator, 0.7));
}

#[test]
fn the_hash_ignores_it_and_hold_1_equals_no_hold() {
    let mut smooth = simulator(800, 4, &[LIVELY]);
    let mut held = simulator(800, 4, &[LIVELY, &[("style.hold", 4.0)]]);
    steps(&mut smooth, 200);
    steps(&mut held, 200);
    assert_eq!(held.hash(), smooth.hash());
    assert_ne!(rows(&mut held), rows(&mut smooth));
    held.set("style.hold", 1.0).unwrap();
    assert_eq!(rows(&mut held), rows(&mut smooth));
}

#[test]
fn saving_resizing_and_restoring_keep_the_shown_rows() {
    let mut original = simulator(800, 4, &[LIVELY, &[("style.hold", 3.0)]]);
    steps(&mut original, 150);
    let mut restored = simulator(800, 9, &[STILL]);
    restored.restore(&original.save()).unwrap();
    for _ in 0..40 {
        assert_eq!(rows(&mut restored), rows(&mut original));
        original.step();
        restored.step();
    }
    let before = rows(&mut original);
    original.resize(900).unwrap();
    assert_eq!(rows(&mut original), before);
}
