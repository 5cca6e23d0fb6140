//! Flows against their law, evaluated along the exact spline in double precision.

use sim::Simulator;

use crate::common::{STEP, alone, assert_close, place, simulator, steps};

type Point = [f64; 3];

/// A point in metres as the table has it.
fn packed([x, y, z]: Point) -> f64 {
    let part = |metres: f64| (metres * 1000.0).round() + 100_000.0;
    part(x) + 200_000.0 * (part(y) + 200_000.0 * part(z))
}

fn of_points(points: &[Point]) -> Vec<(String, f64)> {
    let entries = points.iter().enumerate();
    entries
        .map(|(index, point)| (format!("flows.0.points.{index}"), packed(*point)))
        .collect()
}

fn with_points(settings: &[(&str, f64)], points: &[Point]) -> Simulator {
    let mut simulator = simulator(8, 1, &[crate::common::STILL, settings]);
    for (key, value) in of_points(points) {
        simulator.set(&key, value).unwrap();
    }
    simulator
}

fn sum(a: Point, b: Point, factor: f64) -> Point {
    std::array::from_fn(|axis| a[axis] + factor * b[axis])
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// A point of the centripetal Catmull-Rom spline by the pyramid of Barry and Goldman.
fn on_span([p, q, r, s]: [Point; 4], share: f64) -> Point {
    let knot = |a: Point, b: Point| {
        let offset = sum(b, a, -1.0);
        dot(offset, offset).sqrt().sqrt()
    };
    let mut knots = [0.0; 4];
    for (index, (a, b)) in [(p, q), (q, r), (r, s)].into_iter().enumerate() {
        knots[index + 1] = knots[index] + knot(a, b);
    }
    let t = knots[1] + share * (knots[2] - knots[1]);
    let mix = |a: Point, b: Point, from: f64, to: f64| {
        let share = (t - from) / (to - from);
        sum(a, sum(b, a, -1.0), share)
    };
    let [k0, k1, k2, k3] = knots;
    let [a, b, c] = [mix(p, q, k0, k1), mix(q, r, k1, k2), mix(r, s, k2, k3)];
    mix(mix(a, b, k0, k2), mix(b, c, k1, k3), k1, k2)
}

/// Places along the spline through `points`, closely spaced.
fn spline(points: &[Point], is_closed: bool) -> Vec<Point> {
    let count = points.len();
    let spans = if is_closed { count } else { count - 1 };
    let at = |index: usize| points[index % count];
    let span = |index: usize| {
        let before = if is_closed || index > 0 {
            at(index + count - 1)
        } else {
            sum(sum(at(0), at(0), 1.0), at(1), -1.0)
        };
        let after = if is_closed || index + 2 < count {
            at(index + 2)
        } else {
            sum(sum(at(count - 1), at(count - 1), 1.0), at(count - 2), -1.0)
        };
        let ends = [before, at(index), at(index + 1), after];
        (0..400).map(move |part| on_span(ends, f64::from(part) / 400.0))
    };
    let last = (!is_closed).then(|| at(count - 1));
    (0..spans).flat_map(span).chain(last).collect()
}

/// The law at a place.
struct Law<'p> {
    path: &'p [Point],
    is_closed: bool,
    speed: f64,
    radius: f64,
    swirl: f64,
    inflow: f64,
}

impl Law<'_> {
    fn air(&self, place: Point) -> Point {
        let count = self.path.len();
        let squared = |index: usize| {
            let offset = sum(place, self.path[index], -1.0);
            dot(offset, offset)
        };
        let nearest = (0..count).min_by(|a, b| squared(*a).total_cmp(&squared(*b))).unwrap();
        let at = |index: usize| self.path[index % count];
        let (before, after) = if self.is_closed {
            (at(nearest + count - 1), at(nearest + 1))
        } else {
            (at(nearest.max(1) - 1), at((nearest + 1).min(count - 1)))
        };
        let way = sum(after, before, -1.0);
        let direction = way.map(|part| part / dot(way, way).sqrt());
        let offset = sum(place, self.path[nearest], -1.0);
        let fade = (1.0 - squared(nearest) / self.radius.powi(2)).max(0.0).powi(2);
        let across = sum(offset, direction, -dot(offset, direction));
        let pull = -25.0 * 5.0_f64.sqrt() / 16.0 * self.inflow / self.radius;
        let along = sum(direction.map(|part| part * self.speed), across, pull);
        sum(along, cross(direction, across), self.swirl).map(|part| part * fade)
    }
}

const S: &[Point] = &[
    [-0.8, 0.0, 0.1],
    [0.2, 0.3, 0.0],
    [0.5, 0.9, -0.2],
    [-0.4, 1.3, 0.0],
    [-0.5, 2.0, 0.3],
    [0.7, 2.3, 0.4],
];

/// A place within `reach` of a path along each axis, by a number.
fn beside(path: &[Point], number: u32, reach: f64) -> Point {
    let part = |salt: u32| f64::from((number * 7919 + salt * 104_729) % 2003) / 1001.5 - 1.0;
    let from = path[(number as usize * 131) % path.len()];
    sum(from, [part(1), part(2), part(3)], reach)
}

/// Returns true if two parts of the path are about as near, so that the law jumps nearby.
fn is_between(path: &[Point], place: Point, radius: f64) -> bool {
    let distance = |a: Point, b: Point| dot(sum(a, b, -1.0), sum(a, b, -1.0)).sqrt();
    let nearest = *path
        .iter()
        .min_by(|a, b| distance(**a, place).total_cmp(&distance(**b, place)))
        .unwrap();
    let others = path.iter().filter(|point| distance(**point, nearest) > radius);
    others
        .map(|point| distance(*point, place))
        .fold(f64::INFINITY, f64::min)
        < distance(nearest, place) + 0.45 * radius
}

#[test]
fn the_air_of_a_flow_obeys_the_law_beside_its_stroke() {
    // A long stroke has coarse cells.
    let long: Vec<Point> = S.iter().map(|point| point.map(|part| 12.0 * part)).collect();
    for (points, radius, is_closed, tolerance) in [
        (S, 0.12, false, 0.06),
        (S, 0.08, false, 0.06),
        (ring().as_slice(), 0.3, true, 0.02),
        (long.as_slice(), 0.6, false, 0.08),
    ] {
        let settings = [
            ("flows.0.speed", 2.0),
            ("flows.0.radius", radius),
            ("flows.0.swirl", 1.5 / radius),
            ("flows.0.inflow", 0.7),
            ("flows.0.closed", f64::from(u8::from(is_closed))),
        ];
        let flow = with_points(&settings, points);
        let path = spline(points, is_closed);
        let law = Law {
            path: &path,
            is_closed,
            speed: 2.0,
            radius,
            swirl: 1.5 / radius,
            inflow: 0.7,
        };
        let mut fast = 0;
        for number in 0..400 {
            let place = beside(&path, number, 0.6 * radius);
            if is_between(&path, place, radius) {
                continue;
            }
            let expected = law.air(place);
            let air = flow.air_velocity(place.map(|part| part as f32)).map(f64::from);
            let off = sum(air, expected, -1.0);
            let off = dot(off, off).sqrt();
            assert!(
                off < tolerance * 2.0,
                "radius {radius}: {air:?} at {place:?}, expected {expected:?}"
            );
            fast += u32::from(dot(expected, expected).sqrt() > 0.5);
        }
        assert!(fast > 100, "only {fast} places are in the flow");
    }
}

#[test]
fn beyond_its_ends_and_its_radius_a_flow_fades_without_a_pull_back() {
    let settings = [("flows.0.speed", 2.0), ("flows.0.inflow", 1.0)];
    let flow = simulator(1, 1, &[crate::common::STILL, &settings]);
    let fade = |distance: f64| (1.0 - distance * distance / 0.09).max(0.0).powi(2);
    for distance in [0.0, 0.1, 0.2, 0.29, 0.31, 5.0, 4000.0] {
        for y in [1.0 + distance, -distance] {
            let [x, air, z] = flow.air_velocity([0.0, y as f32, 0.0]).map(f64::from);
            assert!((air - 2.0 * fade(distance)).abs() < 1e-4, "{air} m/s at the height {y}");
            assert!(x.hypot(z) < 1e-5);
        }
        let [inwards, along, _] = flow.air_velocity([distance as f32, 0.4, 0.0]).map(f64::from);
        assert!(
            (along - 2.0 * fade(distance)).abs() < 1e-4,
            "{along} m/s at {distance} m"
        );
        let expected = -25.0 * 5.0_f64.sqrt() / 16.0 / 0.3 * distance * fade(distance);
        assert!((inwards - expected).abs() < 1e-4, "{inwards} m/s at {distance} m");
    }
}

#[test]
fn scale_and_position_move_a_flow_as_a_whole() {
    let settings = [("flows.0.speed", 2.0), ("flows.0.swirl", 3.0), ("flows.0.radius", 0.2)];
    let placed = [
        ("flows.0.scale", 3.0),
        ("flows.0.position.x", 40.0),
        ("flows.0.position.z", -2.0),
        ("flows.0.swirl", 1.0),
    ];
    let (plain, placed) = (
        with_points(&settings, S),
        with_points(&[&settings[..], &placed].concat(), S),
    );
    for number in 0..50 {
        let at = beside(S, number, 0.15);
        let there = [40.0 + 3.0 * at[0], 3.0 * at[1], -2.0 + 3.0 * at[2]];
        let [ours, theirs] = [
            plain.air_velocity(at.map(|part| part as f32)),
            placed.air_velocity(there.map(|part| part as f32)),
        ];
        for axis in 0..3 {
            // Far from the origin places are rounded.
            assert!(
                (ours[axis] - theirs[axis]).abs() < 2e-3,
                "{ours:?} and {theirs:?} at {at:?}"
            );
        }
    }
}

/// A circle of 1 m about the origin.
fn ring() -> Vec<Point> {
    let angle = |number: u32| std::f64::consts::TAU * f64::from(number) / 16.0;
    (0..16)
        .map(|number| [angle(number).cos(), 0.0, angle(number).sin()])
        .collect()
}

#[test]
fn smoke_circles_in_a_ring() {
    let settings = [("flows.0.speed", 3.0), ("flows.0.inflow", 0.3), ("flows.0.closed", 1.0)];
    let mut simulator = with_points(&settings, &ring());
    simulator.add(&crate::common::newborn([1.05, 0.05, 0.0]));
    let mut turns = 0;
    let mut before = 0.0;
    for _ in 0..1200 {
        simulator.step();
        let [x, y, z] = place(&simulator, 0).map(f64::from);
        assert!(
            (x.hypot(z) - 1.0).abs() < 0.08 && y.abs() < 0.08,
            "left the ring at {x} {y} {z}"
        );
        turns += u32::from(before < 0.0 && z >= 0.0 && x > 0.0);
        before = z;
    }
    // 20 s at about 3 m/s.
    assert!((8..=10).contains(&turns), "{turns} turns");
}

#[test]
fn smoke_among_smoke_that_is_not_in_the_flow_moves_as_alone() {
    const COUNT: usize = 200;
    let settings = [("flows.0.speed", 2.0), ("flows.0.swirl", 3.0), ("flows.0.radius", 0.3)];
    let path = spline(S, false);
    let places: [[f32; 3]; COUNT] = std::array::from_fn(|number| {
        // Of three blocks of four, one is out of reach, and one has half of its smoke in reach.
        let is_far = [false, true, number % 2 == 0][number / 4 % 3];
        let from = beside(&path, number as u32, 0.1);
        sum(from, [if is_far { 9.0 } else { 0.0 }, 0.0, 0.0], 1.0).map(|part| part as f32)
    });
    let of = |places: &[[f32; 3]]| {
        let mut simulator = simulator(places.len() as u32, 1, &[crate::common::STILL, &settings]);
        for (key, value) in of_points(S) {
            simulator.set(&key, value).unwrap();
        }
        for place in places {
            simulator.add(&crate::common::newborn(*place));
        }
        steps(&mut simulator, 3);
        simulator
    };
    let crowd = of(&places);
    let mut moved = 0;
    for (number, start) in places.iter().enumerate() {
        let end = place(&crowd, number);
        assert_eq!(end, place(&of(&[*start]), 0), "particle {number} from {start:?}");
        moved += usize::from(end != *start);
    }
    assert_eq!(moved, COUNT / 2);
}

#[test]
fn a_swirl_without_inflow_keeps_the_distance_over_20_turns() {
    for swirl in [-2.0, 8.0, 50.0] {
        let settings = [("flows.0.swirl", swirl), ("flows.0.radius", 10.0)];
        let mut simulator = alone(&settings, [0.4, 0.5, 0.3], [0.0; 3]);
        let distance = |simulator: &Simulator| {
            let [x, _, z] = place(simulator, 0).map(f64::from);
            x.hypot(z)
        };
        let first = distance(&simulator);
        steps(
            &mut simulator,
            (20.0 * std::f64::consts::TAU / f64::abs(swirl) / STEP) as usize,
        );
        assert_close("distance", distance(&simulator), first, 1e-3);
    }
}

#[test]
fn smoke_goes_along_a_stroke_from_its_start_to_its_end() {
    let settings = [("flows.0.speed", 1.0), ("flows.0.inflow", 0.4)];
    let mut simulator = with_points(&settings, S);
    simulator.add(&crate::common::newborn(S[0].map(|part| part as f32)));
    let path = spline(S, false);
    let mut furthest = 0;
    for _ in 0..600 {
        simulator.step();
        let at = place(&simulator, 0).map(f64::from);
        let squared = |point: &Point| {
            let offset = sum(*point, at, -1.0);
            dot(offset, offset)
        };
        let nearest = (0..path.len())
            .min_by(|a, b| squared(&path[*a]).total_cmp(&squared(&path[*b])))
            .unwrap();
        assert!(nearest + 1 >= furthest, "went back from {furthest} to {nearest}");
        furthest = furthest.max(nearest);
        assert!(squared(&path[nearest]).sqrt() < 0.3, "left the stroke at {at:?}");
    }
    assert_eq!(furthest, path.len() - 1);
}

#[test]
fn a_stroke_without_length_has_no_effect() {
    let one = [("flows.0.speed", 1.0), ("flows.0.points.0", packed([0.0; 3]))];
    let same = [&one[..], &[("flows.0.points.1", packed([0.0; 3]))]].concat();
    for settings in [&one[..], &same] {
        let flow = simulator(1, 1, &[crate::common::STILL, settings]);
        assert_eq!(flow.air_velocity([0.0; 3]), [0.0; 3]);
    }
}

#[test]
fn a_changed_stroke_and_a_restored_one_act_at_once() {
    let mut flow = with_points(&[("flows.0.speed", 1.0)], S);
    let before = flow.air_velocity([0.2, 0.3, 0.0]);
    let saved = flow.save();
    for (key, value) in of_points(
        &S.iter()
            .map(|point| sum(*point, [5.0, 0.0, 0.0], 1.0))
            .collect::<Vec<_>>(),
    ) {
        flow.set(&key, value).unwrap();
    }
    assert_eq!(flow.air_velocity([0.2, 0.3, 0.0]), [0.0; 3]);
    let moved = flow.air_velocity([5.2, 0.3, 0.0]);
    (0..3).for_each(|axis| assert!((moved[axis] - before[axis]).abs() < 1e-3));
    flow.restore(&saved).unwrap();
    assert_eq!(flow.air_velocity([0.2, 0.3, 0.0]), before);
}
