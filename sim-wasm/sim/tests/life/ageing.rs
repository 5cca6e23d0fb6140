//! Radius, growth and death.

use crate::common::{STILL, newborn, simulator, steps};
use sim::life::WORLD_RADIUS;
use sim::particles::Newborn;
use sim::particles::radius::RadiusLaw;

const STEP: f32 = 1.0 / 60.0;

/// Radii of one particle at each step until it dies.
fn radii(growth_time: f32, lifetime: f32, size: f32) -> Vec<f32> {
    let mut simulator = simulator(1, 1, &[STILL, &[("emission.growthTime", f64::from(growth_time))]]);
    simulator.add(&Newborn {
        lifetime,
        size,
        ..newborn([0.0; 3])
    });
    let law = RadiusLaw::linear(1.0, growth_time);
    let mut radii = Vec::new();
    while simulator.alive() == 1 {
        radii.push(law.radius(size, simulator.particles().age[0], lifetime));
        simulator.step();
    }
    // The value of the particle at the age at which it died.
    radii.push(law.radius(size, radii.len() as f32 * STEP, lifetime));
    radii
}

#[test]
fn radius_falls_by_one_share_a_step_to_exactly_zero() {
    for lifetime in [0.1_f32, 1.0, 2.77] {
        let radii = radii(0.0, lifetime, 0.4);
        let share = 0.4 * STEP / lifetime;
        assert_eq!(radii[0], 0.4);
        assert_eq!(*radii.last().unwrap(), 0.0, "lifetime {lifetime}");
        for pair in radii.windows(2) {
            let fall = pair[0] - pair[1];
            assert!(
                fall >= 0.0 && fall <= share * 1.001 + 1e-7,
                "lifetime {lifetime}: {pair:?}, share {share}"
            );
        }
    }
}

#[test]
fn growth_starts_and_ends_at_zero_and_is_continuous() {
    for (growth_time, lifetime) in [(0.5_f32, 3.0_f32), (2.0, 1.0), (0.05, 1.0)] {
        let radii = radii(growth_time, lifetime, 0.4);
        let bound = 0.4 * STEP * (1.0 / lifetime + 2.0 / growth_time);
        assert_eq!((radii[0], *radii.last().unwrap()), (0.0, 0.0));
        let jump = radii
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).abs())
            .fold(0.0, f32::max);
        assert!(
            jump <= bound * 1.001,
            "growth {growth_time} of {lifetime}: jumps by {jump}, bound {bound}"
        );
        assert!(radii.iter().all(|radius| *radius <= 0.4));
    }
}

#[test]
fn particles_die_at_their_time_whatever_slot_they_have() {
    let mut simulator = simulator(50, 1, &[STILL]);
    for i in 0..50 {
        // Lifetimes between steps in a shuffled order, so that a dying particle is not the last one.
        let lifetime = ((i * 37 % 50) as f32 + 0.5) * STEP;
        simulator.add(&Newborn {
            lifetime,
            size: lifetime,
            ..newborn([i as f32, 0.0, 0.0])
        });
    }
    for step in 1..=50 {
        simulator.step();
        // A particle is still drawn in the step in which its life ends.
        assert_eq!(simulator.alive(), 51 - step);
        let particles = simulator.particles();
        for i in 0..simulator.alive() {
            assert!(particles.age[i] - STEP < particles.lifetime[i]);
            assert_eq!(
                particles.size[i], particles.lifetime[i],
                "columns of slot {i} got mixed up"
            );
            assert!(
                (particles.age[i] - step as f32 * STEP).abs() < 1e-4,
                "slot {i} aged by another count"
            );
        }
    }
}

#[test]
fn particles_that_leave_the_world_die() {
    let mut simulator = simulator(3, 1, &[STILL, &[("forces.wind.x", 50.0)]]);
    simulator.add(&newborn([WORLD_RADIUS - 60.0, 0.0, 0.0]));
    simulator.add(&newborn([0.0; 3]));
    simulator.add(&newborn([0.0, WORLD_RADIUS + 1.0, 0.0]));
    simulator.step();
    assert_eq!(simulator.alive(), 2);
    steps(&mut simulator, 80);
    assert_eq!(simulator.alive(), 1);
    assert!(simulator.particles().x[0] < 100.0);
}
