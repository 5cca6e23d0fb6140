//! Surfaces of meshes as emitters.

use crate::common::{STILL, place, simulator, steps};
use sim::Simulator;

/// Two triangles in the plane z = 0, of 0.5 and 4.5 m2, both facing +z, and one without area between them.
const VERTICES: [f32; 21] = [
    0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, // the small one
    10.0, 0.0, 0.0, 13.0, 0.0, 0.0, 10.0, 3.0, 0.0, // the large one
    5.0, 0.0, 0.0,
];
const INDICES: [u32; 9] = [0, 1, 2, 0, 1, 6, 3, 4, 5];

const SMOKE: &[(&str, f64)] = &[
    ("emission.rate", 6000.0),
    ("emission.lifetime", 60.0),
    ("emitters.0.shape", 8.0),
    ("emitters.0.lifetimeVariation", 0.0),
    ("emitters.0.speedVariation", 0.0),
    ("emitters.0.spread", 0.0),
    ("emitters.0.speed", 0.0),
];

fn smoking(settings: &[(&str, f64)]) -> Simulator {
    let mut simulator = simulator(6000, 1, &[STILL, SMOKE, settings]);
    assert_eq!(simulator.add_surface(&VERTICES, &INDICES).unwrap(), 0);
    steps(&mut simulator, 60);
    assert_eq!(simulator.alive(), 6000);
    simulator
}

#[test]
fn births_are_uniform_by_area() {
    let simulator = smoking(&[]);
    let places: Vec<[f64; 3]> = (0..6000).map(|i| place(&simulator, i).map(f64::from)).collect();
    let (small, large): (Vec<[f64; 3]>, Vec<[f64; 3]>) = places.iter().partition(|place| place[0] < 5.0);
    // 5 standard deviations of a binomial count.
    assert!(small.len().abs_diff(600) < 117, "{} of 6000 on a tenth", small.len());
    // A uniform triangle with legs l has mean l / 3, variance l^2 / 18 and covariance -l^2 / 36.
    let n = large.len() as f64;
    let mean = |part: fn(&[f64; 3]) -> f64| large.iter().map(part).sum::<f64>() / n;
    let (x, y) = (mean(|p| p[0] - 10.0), mean(|p| p[1]));
    let (xx, xy) = (mean(|p| (p[0] - 11.0).powi(2)), mean(|p| (p[0] - 11.0) * (p[1] - 1.0)));
    for (found, expected) in [(x, 1.0), (y, 1.0), (xx, 0.5), (xy, -0.25)] {
        assert!((found - expected).abs() < 0.05, "moments {x} {y} {xx} {xy}");
    }
    assert!(places.iter().all(|[x, y, z]| *z == 0.0 && *x >= 0.0 && *y >= 0.0));
    assert!(large.iter().all(|[x, y, _]| x - 10.0 + y <= 3.0 + 1e-5));
}

#[test]
fn smoke_leaves_along_the_normal_and_spreads_about_it() {
    let straight = smoking(&[("emitters.0.speed", 2.0)]);
    let particles = straight.particles();
    assert!((0..6000).all(|i| particles.sz[i] == 2.0 && particles.sx[i] == 0.0));
    let wide = smoking(&[("emitters.0.speed", 2.0), ("emitters.0.spread", 0.5)]);
    let forward: Vec<f32> = wide.particles().sz[..6000].iter().map(|z| z / 2.0).collect();
    let mean = forward.iter().sum::<f32>() / 6000.0;
    assert!(forward.iter().all(|cosine| *cosine >= 0.5_f32.cos() - 1e-5));
    assert!((mean - (1.0 + 0.5_f32.cos()) / 2.0).abs() < 0.005, "mean cosine {mean}");
}

#[test]
fn the_emitters_place_moves_its_surface() {
    let moved = smoking(&[("emitters.0.position.y", 7.0)]);
    assert!((0..6000).all(|i| place(&moved, i)[1] >= 7.0));
}

#[test]
fn a_surface_that_does_not_exist_is_a_point() {
    let point = smoking(&[("emitters.0.surface", 3.0), ("emitters.0.position.x", -2.0)]);
    assert!((0..6000).all(|i| place(&point, i) == [-2.0, 0.0, 0.0]));
}

#[test]
fn an_invalid_mesh_is_an_error_with_its_key() {
    let mut simulator = simulator(10, 1, &[]);
    let nan = [0.0, f32::NAN, 0.0];
    let far = [0.0, 0.0, 1000.5];
    let line = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0];
    let cases: [(&[f32], &[u32], &str, f64); 8] = [
        (&[], &INDICES, "surface.vertices", 0.0),
        (&VERTICES[..20], &INDICES, "surface.vertices", 20.0),
        (&VERTICES, &[], "surface.indices", 0.0),
        (&VERTICES, &INDICES[..8], "surface.indices", 8.0),
        (&VERTICES, &[0, 1, 7], "surface.indices.2", 7.0),
        (&nan, &[0, 0, 0], "surface.vertices.1", f64::NAN),
        (&far, &[0, 0, 0], "surface.vertices.2", 1000.5),
        (&line, &[0, 1, 2], "surface.area", 0.0),
    ];
    for (vertices, indices, key, value) in cases {
        let error = simulator.add_surface(vertices, indices).unwrap_err();
        assert_eq!(error.key, key);
        assert!(
            error.value == value || value.is_nan() && error.value.is_nan(),
            "{error:?}"
        );
        assert!(error.message.contains(key), "{error}");
    }
    for number in 0..16 {
        assert_eq!(simulator.add_surface(&VERTICES, &INDICES).unwrap(), number);
    }
    assert_eq!(
        simulator.add_surface(&VERTICES, &INDICES).unwrap_err().key,
        "surface.count"
    );
}

#[test]
fn surfaces_are_inputs_that_are_saved() {
    let mut original = smoking(&[("emission.lifetime", 2.0)]);
    let mut bare = simulator(6000, 1, &[STILL, SMOKE]);
    steps(&mut bare, 60);
    let mut other = simulator(6000, 9, &[]);
    other.restore(&original.save()).unwrap();
    assert_eq!(other.hash(), original.hash());
    assert_eq!(other.save(), original.save());
    // All particles die and respawn on the surface.
    for simulator in [&mut original, &mut other] {
        steps(simulator, 200);
    }
    assert_eq!(other.hash(), original.hash());
    assert_ne!(bare.hash(), original.hash());
    let before = simulator(5, 1, &[]).hash();
    let mut with = simulator(5, 1, &[]);
    with.add_surface(&VERTICES, &INDICES).unwrap();
    assert_eq!(with.hash(), before, "a surface alone is no state");
}

#[test]
fn a_take_of_another_surface_is_an_error() {
    let fresh = |scale: f32| {
        let mut simulator = simulator(600, 1, &[STILL, SMOKE]);
        simulator
            .add_surface(&VERTICES.map(|metres| metres * scale), &INDICES)
            .unwrap();
        simulator.record();
        simulator
    };
    let mut original = fresh(1.0);
    steps(&mut original, 10);
    let take = original.take("").unwrap();
    let mut same = fresh(1.0);
    same.replay(&take).unwrap();
    assert!(fresh(2.0).replay(&take).is_err());
}
