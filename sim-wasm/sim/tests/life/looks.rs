//! Growth, size and density over life, and dissolution by looks.

use crate::common::{STILL, simulator, steps};
use proptest::prelude::*;
use sim::Simulator;
use sim::arrange::row_layout::{EROSION, LOOK, STRETCH, TINT};
use sim::arrange::view_layout::ViewNumbers;
use sim::layout::parameters::Parameters;
use sim::layout::parameters::emitter::Look;
use sim::layout::parameters::field::{STOP_STEPS, STOP_VALUE};
use sim::particles::radius::RadiusLaw;

fn packed(age: f64, value: f64) -> f64 {
    1.0 + (age * STOP_STEPS).round() + STOP_VALUE * (value * STOP_STEPS).round()
}

fn curve(stops: &[(f64, f64)]) -> [f64; 8] {
    std::array::from_fn(|index| stops.get(index).map_or(0.0, |(age, value)| packed(*age, *value)))
}

fn parameters(entries: &[(&str, f64)]) -> Parameters {
    let mut parameters = Parameters::default();
    parameters.set_all(entries).unwrap();
    parameters
}

/// Radius of a puff of size 1 at `age` of `lifetime` (s).
fn radius(parameters: &Parameters, look: &Look, age: f64, lifetime: f64) -> f64 {
    f64::from(RadiusLaw::of_look(parameters, look).radius(1.0, age as f32, lifetime as f32))
}

#[test]
fn no_look_has_the_law_of_the_smoke() {
    let parameters = parameters(&[
        ("emission.growthTime", 1.7),
        ("density.0.value", 0.4),
        ("emission.dissolve", 2.0),
    ]);
    assert_eq!(
        RadiusLaw::new(&parameters),
        RadiusLaw::of_look(&parameters, &Look::NONE)
    );
}

#[test]
fn a_look_with_a_lifetime_grows_within_a_quarter_of_it() {
    for (lifetime, common, own, expected) in [
        (0.4, 2.6, 0.0, 0.1),
        (0.2, 2.6, 0.0, 0.05),
        (2.0, 2.6, 0.0, 0.5),
        (2.0, 2.6, 0.3, 0.3),
        (2.0, 2.6, 5.0, 0.5),
        (100.0, 2.6, 0.0, 2.6),
        (100.0, 2.6, 4.0, 4.0),
        // Without a lifetime of its own, the growth time may be longer than life.
        (0.0, 2.6, 0.0, 2.6),
        (0.0, 2.6, 8.0, 8.0),
    ] {
        let parameters = parameters(&[("emission.growthTime", common)]);
        let look = Look {
            lifetime,
            growth_time: own,
            ..Look::NONE
        };
        // So long a life that nothing has faded: the growth alone, t (2 - t).
        for share in [0.25, 0.5, 0.9, 1.0, 1.5] {
            let found = radius(&parameters, &look, share * expected, 1e7);
            let t = f64::min(share, 1.0);
            assert!(
                (found - t * (2.0 - t)).abs() < 1e-5,
                "{found} at {share} of {expected} s"
            );
        }
    }
}

#[test]
fn size_over_life_is_a_factor() {
    let parameters = parameters(&[("emission.growthTime", 0.0), ("simulation.integrator", 1.0)]);
    let look = Look {
        size_curve: curve(&[(0.2, 0.25), (0.6, 1.0), (0.8, 0.5)]),
        ..Look::NONE
    };
    for (worn, size) in [
        (0.0, 0.25),
        (0.2, 0.25),
        (0.4, 0.625),
        (0.6, 1.0),
        (0.7, 0.75),
        (0.8, 0.5),
        (0.97, 0.5),
    ] {
        let found = radius(&parameters, &look, worn * 10.0, 10.0);
        assert!((found - size * (1.0 - worn)).abs() < 1e-4, "{found} at {worn}");
    }
    // Even one that falls as the density of the paper is a factor.
    let falling = Look {
        size_curve: curve(&[(0.0, 1.0), (1.0, 0.0)]),
        ..Look::NONE
    };
    assert!((radius(&parameters, &falling, 4.0, 10.0) - 0.36).abs() < 1e-4);
}

#[test]
fn density_over_life_replaces_that_of_the_smoke() {
    let common = [("emission.growthTime", 0.0), ("simulation.integrator", 1.0)];
    let parameters = parameters(&[&common[..], &[("density.0.value", 0.3)]].concat());
    assert!((radius(&parameters, &Look::NONE, 5.0, 10.0) - 0.3).abs() < 1e-6);
    let own = Look {
        density_curve: curve(&[(0.0, 1.0), (0.5, 0.8), (1.0, 0.6)]),
        ..Look::NONE
    };
    assert!((radius(&parameters, &own, 2.5, 10.0) - 0.9).abs() < 1e-4);
    let paper = Look {
        density_curve: curve(&[(0.0, 1.0), (1.0, 0.0)]),
        ..Look::NONE
    };
    assert!((radius(&parameters, &paper, 2.5, 10.0) - 0.75).abs() < 1e-4);
}

/// Rows of the eye: place, then attributes.
fn rows(simulator: &mut Simulator) -> Vec<([f32; 4], [u32; 4])> {
    let view = ViewNumbers {
        blend: 1.0,
        direction: [0.0, 0.0, -1.0],
        ..ViewNumbers::default()
    };
    let count = simulator.arrange(&view.to_array()).unwrap();
    let places = simulator.place()[..count].iter().copied();
    places.zip(simulator.attributes().iter().copied()).collect()
}

/// Eight emitters at x = 0, 10, ..., each with a burst of 11 puffs that fly upwards.
fn bursts(settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(500, 2, &[STILL, &[("emission.rate", 0.0), ("emission.lifetime", 3.0)]]);
    for emitter in 0..8 {
        for (name, value) in [
            ("position.x", f64::from(emitter) * 10.0),
            ("burst.count", 11.0),
            ("speed", 0.4),
        ] {
            simulator.set(&format!("emitters.{emitter}.{name}"), value).unwrap();
        }
    }
    simulator.set_all(settings).unwrap();
    simulator
}

#[test]
fn each_row_has_the_radius_the_erosion_and_the_stretch_of_its_look() {
    let settings = [
        ("emission.dissolve", 1.0),
        ("emitters.1.look.dissolve", 1.0),
        ("emitters.2.look.dissolve", 4.0),
        ("emitters.3.look.growthTime", 2.0),
        ("emitters.4.look.sizeCurve.0", packed(0.0, 0.5)),
        ("emitters.5.tint", 6.0),
        ("emitters.6.look.lifetime", 9.0),
        ("emitters.7.look.style", 4e9),
        ("emitters.7.tint", 3.0),
    ];
    let mut simulator = bursts(&settings);
    for (hold, count) in [(1.0, 80), (2.0, 40)] {
        simulator.set("style.hold", hold).unwrap();
        steps(&mut simulator, count);
        let rows = rows(&mut simulator);
        assert_eq!(rows.len(), 88);
        let law = |look: Look| RadiusLaw::of_look(simulator.parameters(), &look);
        let looks = simulator.parameters().emitters.items();
        let particles = simulator.particles();
        for (place, attributes) in &rows {
            let emitter = (place[0] / 10.0).round() as usize;
            let expected = [0, 1, 2, 3, 4, 0, 5, 6][emitter];
            assert_eq!(LOOK.of(*attributes), expected, "of emitter {emitter}");
            // The tint of a look is that of the look.
            assert_eq!(TINT.of(*attributes), if emitter == 5 { 6 } else { 0 });
            let shown = |i: &usize| match &particles.held {
                Some(held) => [held.x[*i], held.y[*i], held.z[*i]] == place[..3],
                None => [particles.x[*i], particles.y[*i], particles.z[*i]] == place[..3],
            };
            let i = (0..88).find(shown).expect("a row is a particle");
            let (age, size) = match &particles.held {
                Some(held) => (held.age[i], held.size[i]),
                None => (particles.age[i], particles.size[i]),
            };
            let radius = law(looks[emitter].look).radius(size, age, particles.lifetime[i]);
            assert_eq!(place[3].to_bits(), radius.to_bits(), "of emitter {emitter}");
            let is_eroded = EROSION.of(*attributes) > 0;
            assert!(!is_eroded || ![1, 2].contains(&emitter), "of emitter {emitter}");
            assert!(STRETCH.of(*attributes) == 0 || emitter == 2, "of emitter {emitter}");
        }
        let eroded = rows
            .iter()
            .filter(|(_, attributes)| EROSION.of(*attributes) > 0)
            .count();
        let stretched = rows
            .iter()
            .filter(|(_, attributes)| STRETCH.of(*attributes) > 0)
            .count();
        assert!(
            eroded > 20 && stretched > 5,
            "{eroded} eroded and {stretched} stretched"
        );
        assert_eq!(simulator.whole(), 88 - eroded);
    }
    let styles = simulator.look_styles();
    assert_eq!(styles.len(), 45);
    assert_eq!(styles[3..6], [0.0, 0.0, 4.0]);
    assert_eq!(styles[15..21], [4e9, 3.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn without_looks_rows_have_tints_alone() {
    let mut simulator = bursts(&[("emitters.5.tint", 6.0)]);
    steps(&mut simulator, 20);
    assert!(!simulator.has_looks() && simulator.look_styles().is_empty());
    for (place, attributes) in rows(&mut simulator) {
        assert_eq!(
            TINT.of(attributes),
            if place[0] > 45.0 && place[0] < 55.0 { 6 } else { 0 }
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_radius_of_any_look_never_jumps_and_ends_at_0(
        lifetime in 0.3..20.0_f64,
        growth_time in 0.0..20.0_f64,
        sizes in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64), 0..8),
        densities in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64), 0..8),
        dissolve in 0..5_u32,
    ) {
        let look = Look {
            lifetime,
            growth_time,
            size_curve: curve(&sizes),
            density_curve: curve(&densities),
            dissolve: f64::from(dissolve),
            ..Look::NONE
        };
        let parameters = Parameters::default();
        let law = RadiusLaw::of_look(&parameters, &look);
        // Growth, size and density change at most this fast.
        let bound = 2.0 / f64::from(law.growth_time) + 50.0 / lifetime + 50.0 * 4.0 / lifetime;
        let step = lifetime / 4000.0;
        let mut before = 0.0;
        for index in 0..=4000 {
            let radius = radius(&parameters, &look, f64::from(index) * step, lifetime);
            prop_assert!((0.0..=1.0).contains(&radius));
            prop_assert!((radius - before).abs() <= bound * step * 1.001 + 1e-5);
            before = radius;
        }
        prop_assert_eq!(before, 0.0);
        prop_assert!(f64::from(law.growth_time) <= lifetime / 4.0 + 1e-6);
    }
}
