//! Wind with shear and gusts, and quadratic drag.

use std::f64::consts::TAU;

use crate::common::{STEP, STILL, alone, assert_close, place, simulator, slip, steps};
use sim::forces::wind::gust;
use sim::layout::parameters::settings::Weather;

#[test]
fn quadratic_drag_slows_like_one_over_time() {
    for c in [0.1, 0.5, 2.0] {
        let v = 3.0_f64;
        let mut simulator = alone(&[("drag.quadratic", c)], [0.0; 3], [v as f32, 0.0, 0.0]);
        for step in 1..=240 {
            simulator.step();
            let t = f64::from(step) * STEP;
            let expected = v / (1.0 + c * v * t);
            // The rate is evaluated at the start of each step: the error of a step is half the square of c v h.
            assert_close("speed", slip(&simulator, 0)[0].into(), expected, 0.6 * c * v * STEP);
            let way = (1.0 + c * v * t).ln() / c;
            assert_close("way", place(&simulator, 0)[0].into(), way, 0.6 * c * v * STEP);
        }
    }
}

#[test]
fn terminal_velocity_under_both_drags_is_the_root_of_its_equation() {
    for (linear, quadratic, multiplier) in [(0.0, 0.5, 1.0), (1.0, 0.3, 1.0), (0.4, 2.0, 3.0)] {
        let settings = [
            ("gravity.acceleration", 4.0),
            ("drag.rate", linear),
            ("drag.quadratic", quadratic),
            ("forces.drag", multiplier),
        ];
        let mut simulator = alone(&settings, [0.0; 3], [0.0; 3]);
        steps(&mut simulator, 900);
        // multiplier (linear + quadratic s) s = 4.
        let (b, a) = (linear * multiplier, quadratic * multiplier);
        let expected = (-b + (b * b + 16.0 * a).sqrt()) / (2.0 * a);
        assert_close("terminal velocity", -f64::from(slip(&simulator, 0)[1]), expected, 1e-4);
    }
}

#[test]
fn a_list_of_quadratic_drags_is_one_in_its_region() {
    let in_list = alone(&[("drags.0.quadratic", 0.7)], [0.0; 3], [2.0, 0.0, 0.0]);
    let everywhere = alone(&[("drag.quadratic", 0.7)], [0.0; 3], [2.0, 0.0, 0.0]);
    let slips = [in_list, everywhere].map(|mut simulator| {
        steps(&mut simulator, 60);
        slip(&simulator, 0)
    });
    assert_eq!(slips[0], slips[1]);
}

#[test]
fn shear_increases_wind_with_height_and_never_reverses_it() {
    let settings = [
        ("winds.0.velocity.x", 2.0),
        ("winds.0.velocity.z", -1.0),
        ("winds.0.shear", 0.25),
        ("winds.0.height", 1.0),
    ];
    let everywhere = [
        ("forces.wind.x", 2.0),
        ("forces.wind.z", -1.0),
        ("wind.shear", 0.25),
        ("wind.height", 1.0),
    ];
    for settings in [settings, everywhere] {
        let asked = simulator(1, 1, &[STILL, &settings]);
        for height in [-20.0_f64, -3.0, -2.9, 0.0, 1.0, 2.5, 40.0] {
            let factor = (1.0 + 0.25 * (height - 1.0)).max(0.0);
            let [x, y, z] = asked.air_velocity([5.0, height as f32, 2.0]).map(f64::from);
            assert!(
                (x - 2.0 * factor).abs() < 1e-5 && (z + factor).abs() < 1e-5,
                "at {height}: {x}, {z}"
            );
            assert_eq!(y, 0.0);
        }
        let mut simulator = alone(&settings, [0.0, 3.0, 0.0], [0.0; 3]);
        steps(&mut simulator, 60);
        assert_close("way", f64::from(place(&simulator, 0)[0]), 2.0 * 1.5, 1e-4);
    }
}

fn weather(gusts: f64, gust_time: f64) -> Weather {
    Weather {
        gusts,
        gust_time,
        ..Weather::default()
    }
}

#[test]
fn gusts_have_the_root_mean_square_speed_and_no_mean() {
    for seed in [1, 2, 99] {
        let (weather, count) = (weather(1.5, 2.0), 40_000);
        let speeds = (0..count).map(|k| gust(&weather, f64::from(k) * 0.5, seed));
        let (sum, squares) = speeds.fold((0.0, 0.0), |(sum, squares), s| (sum + s, squares + s * s));
        assert_close("rms", (squares / f64::from(count)).sqrt(), 1.5, 0.01);
        assert!((sum / f64::from(count)).abs() < 0.01, "mean {sum}");
    }
}

/// Power density of the gusts between two frequencies (Hz): their periodogram over `time` seconds with a Hann window.
fn density(weather: &Weather, low: f64, high: f64, time: f64) -> f64 {
    let dt = 0.025;
    let count = (time / dt) as u32;
    let windowed: Vec<f64> = (0..count)
        .map(|k| gust(weather, f64::from(k) * dt, 7) * (1.0 - (TAU * f64::from(k) / f64::from(count)).cos()))
        .collect();
    let bins = ((high - low) * time).ceil() as u32;
    let power = |bin: u32| {
        let turn = TAU * (low + (f64::from(bin) + 0.5) * (high - low) / f64::from(bins)) * dt;
        let waves = windowed.iter().enumerate();
        let (real, imaginary) = waves.fold((0.0, 0.0), |(real, imaginary), (k, speed)| {
            let (sine, cosine) = (turn * k as f64).sin_cos();
            (real + speed * cosine, imaginary + speed * sine)
        });
        real * real + imaginary * imaginary
    };
    (0..bins).map(power).sum::<f64>() / f64::from(bins) / time
}

/// Exponent of the spectrum between wave `from` and wave `to`, measured and by the law.
fn slopes(from: i32, to: i32, time: f64) -> (f64, f64) {
    let weather = weather(1.0, 2.0);
    // The frequencies of the waves have a ratio of 1.46, from 0.05 Hz; each band contains one wave.
    let band = |n: i32| [-0.5, 0.5].map(|half| 0.05 * 1.46_f64.powf(f64::from(n) + half));
    let measured = |n: i32| density(&weather, band(n)[0], band(n)[1], time);
    let law = |n: i32| (1.0 + 0.1 * 1.46_f64.powi(n)).powf(-5.0 / 3.0);
    let octaves = f64::from(to - from) * 1.46_f64.ln();
    let [measured, law] = [measured(to) / measured(from), law(to) / law(from)];
    (measured.ln() / octaves, law.ln() / octaves)
}

#[test]
fn beyond_the_gust_time_the_spectrum_falls_with_the_power_five_thirds() {
    let (fast, law) = slopes(12, 15, 60.0);
    assert!((fast - law).abs() < 0.05, "slope {fast}, not {law}");
    assert!((fast + 5.0 / 3.0).abs() < 0.12, "slope {fast}, not -5/3");
    let (slow, law) = slopes(1, 3, 300.0);
    assert!((slow - law).abs() < 0.05, "slope {slow}, not {law}");
    assert!(slow > -0.4, "slope {slow} where gusts are slow");
}

#[test]
fn seeds_and_winds_have_different_gusts() {
    let weather = weather(1.0, 2.0);
    let speeds = |seed: u32| -> Vec<f64> { (0..40_000).map(|k| gust(&weather, f64::from(k) * 0.5, seed)).collect() };
    let own = speeds(3);
    let product = |other: &[f64]| own.iter().zip(other).map(|(a, b)| a * b).sum::<f64>() / 40_000.0;
    assert_close("with itself", product(&own), 1.0, 0.05);
    let others: Vec<f64> = (0..8).map(|n| product(&speeds(100 + n))).collect();
    // Both use the same waves, so two sums can be similar by chance, but never equal and not on average.
    assert!(others.iter().all(|value| value.abs() < 0.95), "{others:?}");
    assert!(others.iter().sum::<f64>().abs() < 8.0 * 0.5, "{others:?}");
    let settings = [("winds.0.gusts", 1.0), ("winds.1.gusts", 1.0)];
    let sum = simulator(1, 5, &[STILL, &settings]).air_velocity([0.0; 3])[0];
    let one = simulator(1, 5, &[STILL, &settings[..1]]).air_velocity([0.0; 3])[0];
    assert!((sum - 2.0 * one).abs() > 1e-3, "both winds blow {one}");
}

#[test]
fn gusts_blow_along_the_wind() {
    let settings = [
        ("winds.0.velocity.x", 3.0),
        ("winds.0.velocity.z", 4.0),
        ("winds.0.gusts", 2.0),
    ];
    let mut simulator = simulator(1, 4, &[STILL, &settings]);
    let mut greatest = 0.0_f32;
    for _ in 0..120 {
        simulator.step();
        let [x, y, z] = simulator.air_velocity([1.0; 3]);
        assert!(
            (x * 4.0 - z * 3.0).abs() < 1e-4 && y == 0.0,
            "across the wind: {x}, {y}, {z}"
        );
        greatest = greatest.max((x - 3.0).abs());
    }
    assert!(greatest > 0.3, "no gusts");
}
