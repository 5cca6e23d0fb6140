//! Coverage against brute-force rays.

use crate::common::{STILL, newborn, simulator};
use proptest::prelude::*;
use sim::Simulator;
use sim::arrange::VIEW_FLOATS;
use sim::math::random::Random;
use sim::particles::Newborn;

/// The law of the paper: particles start at full size and have a row from the start.
const FULL: &[(&str, f64)] = &[("simulation.integrator", 1.0)];
const BALLS: usize = 8;
const VARIATIONS: usize = 3;
const NEAR: f64 = 0.1;
const FAR: f64 = 60.0;
/// Minimum and maximum distance at which a shadow starts, in radii.
const CAPS: [f64; 2] = [0.05, 0.4];

/// Maximum distance by which surfaces raise a ring of ink, per unit of its width.
const LIFT: f64 = 8.0;

type V3 = [f64; 3];

fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: V3, b: V3) -> V3 {
    std::array::from_fn(|i| a[i] - b[i])
}

fn unit(a: V3) -> V3 {
    a.map(|c| c / dot(a, a).sqrt())
}

fn cross(a: V3, b: V3) -> V3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// A random eye that looks at the centre of the cloud.
#[derive(Clone, Debug)]
struct Observer {
    at: V3,
    right: V3,
    up: V3,
    forward: V3,
    /// Half the height of the view at unit depth, or at any depth for an orthographic view.
    half: f64,
    is_perspective: bool,
}

impl Observer {
    fn new(at: V3, half: f64, is_perspective: bool) -> Self {
        let forward = unit(minus([0.1, 0.2, 0.3], at));
        let right = unit(cross(forward, [0.05, 1.0, 0.02]));
        let up = cross(right, forward);
        Self {
            at,
            right,
            up,
            forward,
            half,
            is_perspective,
        }
    }

    /// Right, up and forward axes of the eye.
    fn view(&self, place: V3) -> V3 {
        let from = minus(place, self.at);
        [dot(from, self.right), dot(from, self.up), dot(from, self.forward)]
    }

    fn w(&self, depth: f64) -> f64 {
        if self.is_perspective { depth } else { 1.0 }
    }

    /// Columns of clipFromWorld: a square, slightly off-axis view.
    fn matrix(&self) -> Vec<f32> {
        let f = 1.0 / self.half;
        let (a, b) = if self.is_perspective {
            ((FAR + NEAR) / (FAR - NEAR), -2.0 * FAR * NEAR / (FAR - NEAR))
        } else {
            (2.0 / (FAR - NEAR), -(FAR + NEAR) / (FAR - NEAR))
        };
        let row = |x: f64, y: f64, z: f64, offset: f64| {
            let normal: V3 = std::array::from_fn(|i| x * self.right[i] + y * self.up[i] + z * self.forward[i]);
            [normal[0], normal[1], normal[2], offset - dot(normal, self.at)]
        };
        let aside = if self.is_perspective { 0.1 } else { 0.0 };
        let last = if self.is_perspective {
            row(0.0, 0.0, 1.0, 0.0)
        } else {
            [0.0, 0.0, 0.0, 1.0]
        };
        let rows = [
            row(f, 0.0, aside, 0.0),
            row(0.0, f, 0.0, 0.0),
            row(0.0, 0.0, a, b),
            last,
        ];
        (0..16).map(|i| rows[i % 4][i / 4] as f32).collect()
    }

    /// Whether a point of the image plane at unit depth is in the picture.
    fn sees(&self, point: [f64; 2]) -> bool {
        let aside = if self.is_perspective { 0.1 } else { 0.0 };
        (point[0] / self.half + aside).abs() < 1.0 && (point[1] / self.half).abs() < 1.0
    }
}

/// Puffs of random balls within the unit ball, as solids: x, y, z and radii of each variation.
fn solids(seed: u32) -> Vec<f32> {
    let mut random = Random::new(seed);
    let mut table = Vec::new();
    for _ in 0..VARIATIONS {
        let balls: Vec<[f32; 4]> = (0..BALLS)
            .map(|ball| {
                let radius = if ball == 0 { 0.6 } else { 0.2 + 0.3 * random.unit() };
                let way = unit(std::array::from_fn(|_| f64::from(random.signed())));
                let out = if ball == 0 { 0.1 } else { 1.0 - radius };
                let at = way.map(|c| c as f32 * out);
                // The last one of some variations is absent.
                [
                    at[0],
                    at[1],
                    at[2],
                    if ball == BALLS - 1 && seed.is_multiple_of(2) {
                        0.0
                    } else {
                        radius
                    },
                ]
            })
            .collect();
        (0..4).for_each(|column| table.extend(balls.iter().map(|ball| ball[column])));
    }
    table
}

/// The fraction of its radius with which a puff at this depth is drawn.
fn grown(depth: f64, radius: f64) -> f64 {
    let share = ((depth - NEAR) / (2.0 * radius)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// A puff seen from the eye, in double precision.
struct Puff {
    centre: V3,
    radius: f64,
    balls: Vec<[f64; 4]>,
}

impl Puff {
    fn new(place: [f32; 4], attributes: [u32; 2], eye: &Observer, solids: &[f32]) -> Self {
        let centre = eye.view([place[0], place[1], place[2]].map(f64::from));
        let full = f64::from(place[3]);
        let radius = full * grown(centre[2], full);
        let columns = &solids[(attributes[1] & 0xff) as usize % VARIATIONS * 4 * BALLS..][..4 * BALLS];
        let ball = |ball: usize| {
            let at = turned(
                [0, 1, 2].map(|axis| f64::from(columns[axis * BALLS + ball])),
                attributes,
            );
            let seen = [dot(at, eye.right), dot(at, eye.up), -dot(at, eye.forward)];
            [seen[0], seen[1], seen[2], f64::from(columns[3 * BALLS + ball])]
        };
        Self {
            centre,
            radius,
            balls: (0..BALLS).map(ball).filter(|ball| ball[3] > 0.0).collect(),
        }
    }

    /// Depth of the puff at a point of the image plane, or of its ring of ink if only the ring covers the point.
    fn depth(&self, eye: &Observer, point: [f64; 2], ink: f64) -> Option<(f64, bool)> {
        let w = eye.w(self.centre[2]);
        let at = [0, 1].map(|axis: usize| (point[axis] * w - self.centre[axis]) / self.radius);
        let (mut height, mut rim) = (f64::NEG_INFINITY, (ink * w / self.radius, f64::NEG_INFINITY));
        for [x, y, z, radius] in &self.balls {
            let beside = (at[0] - x).hypot(at[1] - y);
            if beside < *radius {
                height = height.max(z + (radius * radius - beside * beside).sqrt());
            } else if beside - radius < rim.0 {
                rim = (beside - radius, *z);
            }
        }
        let is_ink = height == f64::NEG_INFINITY;
        let lift = if is_ink { LIFT * ink * w } else { 0.0 };
        let depth = self.centre[2] - if is_ink { rim.1 } else { height } * self.radius - lift;
        depth.is_finite().then(|| (depth.clamp(NEAR, FAR), is_ink))
    }
}

/// Transforms a direction from the frame of the puff to the world; see src/puffs/orientation.ts.
fn turned(at: V3, attributes: [u32; 2]) -> V3 {
    let seed = f64::from(attributes[1] >> 8 & 0xff);
    let z = 1.0 - (2.0 * seed + 1.0) / 256.0;
    let angle = seed * std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let reach = (1.0 - z * z).sqrt();
    let axis = [reach * angle.cos(), reach * angle.sin(), z];
    let roll = f64::from(attributes[0] & 0xffff) / 65_536.0 * std::f64::consts::TAU;
    let (across, along) = (cross(axis, at), dot(axis, at) * (1.0 - roll.cos()));
    std::array::from_fn(|i| roll.cos() * at[i] + roll.sin() * across[i] + along * axis[i])
}

fn cloud(count: u32, seed: u32, spread: f32) -> Simulator {
    let mut simulator = simulator(count, 1, &[STILL, FULL]);
    let mut random = Random::new(seed);
    for _ in 0..count {
        simulator.add(&Newborn {
            size: 0.1 + 0.35 * random.unit(),
            attributes: random.bits(),
            ..newborn(std::array::from_fn(|_| random.signed() * spread))
        });
    }
    simulator
}

fn view(eye: &Observer, ink: f64) -> Vec<f32> {
    let mut view = vec![0.0; VIEW_FLOATS];
    (view[1], view[2], view[3]) = (1.0, 1.0, ink as f32);
    view[4..20].copy_from_slice(&eye.matrix());
    (0..3).for_each(|i| view[20 + i] = eye.forward[i] as f32);
    view[23] = 1.0;
    view[24..30].copy_from_slice(&[-3.0, -3.0, -3.0, 3.0, 3.0, 3.0]);
    let depth = dot(eye.at, eye.forward);
    let ends = [depth + NEAR, depth + FAR];
    let numbers = [
        0.001,
        ends[0],
        ends[1],
        1.0,
        0.001,
        0.0,
        0.0,
        LIFT * ink,
        CAPS[0],
        CAPS[1],
        0.6,
        BALLS as f64,
    ];
    (0..12).for_each(|i| view[30 + i] = numbers[i] as f32);
    view[42] = 1.0;
    view[43..49].copy_from_slice(&[-9.0, -9.0, -9.0, 9.0, 9.0, 9.0]);
    view
}

fn body_view(eye: &Observer, ink: f64, solids: &[f32]) -> Vec<f32> {
    let mut view = view(eye, ink);
    view.extend_from_slice(solids);
    view
}

fn shadow_view(eye: &Observer, travel: V3, covers: usize, solids: &[f32]) -> Vec<f32> {
    let mut view = body_view(eye, 0.0, solids);
    (view[0], view[33], view[91]) = (1.0, covers as f32, 1.0);
    (0..3).for_each(|i| view[20 + i] = travel[i] as f32);
    view.extend(start_caps());
    view
}

/// Columns and rows of a variation's table of start caps.
const TABLE: [usize; 2] = [64, 32];

fn start_caps() -> Vec<f32> {
    let mut random = Random::new(17);
    let [least, most] = CAPS.map(|cap| cap as f32);
    (0..VARIATIONS * TABLE[0] * TABLE[1])
        .map(|_| least + (most - least) * random.unit())
        .collect()
}

/// The entry for light from a direction in the frame of the puff.
fn start_cap(caps: &[f32], attributes: [u32; 2], [x, y, z]: V3) -> f64 {
    let column = (y.atan2(x) / std::f64::consts::TAU + 0.5) * TABLE[0] as f64;
    let row = z.clamp(-1.0, 1.0).acos() / std::f64::consts::PI * TABLE[1] as f64;
    let variation = (attributes[1] & 0xff) as usize % VARIATIONS;
    let row = variation * TABLE[1] + (row as usize).min(TABLE[1] - 1);
    f64::from(caps[row * TABLE[0] + (column as usize).min(TABLE[0] - 1)])
}

type Row = ([f32; 4], [u32; 2]);

fn rows(simulator: &mut Simulator, view: &[f32]) -> Vec<Row> {
    let count = simulator.arrange(view).unwrap();
    let (place, attributes) = (simulator.place(), simulator.attributes());
    (0..count).map(|row| (place[row], attributes[row])).collect()
}

/// The remaining rows, and those that only coverage culls. The remaining rows keep their order.
fn culled(simulator: &mut Simulator, view: &[f32]) -> (Vec<Row>, Vec<Row>) {
    let kept = rows(simulator, view);
    let mut uncovered = view.to_vec();
    uncovered[33] = 0.0;
    let all = rows(simulator, &uncovered);
    let mut rest = kept.iter().peekable();
    let left: Vec<Row> = all
        .iter()
        .filter(|row| rest.next_if(|kept| are_alike(kept, row)).is_none())
        .copied()
        .collect();
    assert!(rest.next().is_none(), "rows that stay are out of order");
    (kept, left)
}

/// Whether both are rows of one particle. The ends of shadows can differ.
fn are_alike(a: &Row, b: &Row) -> bool {
    a.0 == b.0 && a.1[0] & 0xffff == b.1[0] & 0xffff && a.1[1] == b.1[1]
}

fn eyes() -> impl Strategy<Value = Observer> {
    let at = prop_oneof![
        4 => prop::array::uniform3(-5.0..5.0_f64),
        2 => prop::array::uniform3(-0.8..0.8_f64),
        1 => Just([0.0, 0.4, 8.0]),
    ];
    (at, 0.15..0.6_f64, prop::bool::weighted(0.7))
        .prop_filter("far enough to have a direction", |(at, ..)| dot(*at, *at) > 0.3)
        .prop_map(|(at, half, is_perspective)| {
            Observer::new(at, if is_perspective { half } else { 3.0 * half }, is_perspective)
        })
}

/// Points of the image plane at unit depth that a puff can cover.
fn points(puff: &Puff, eye: &Observer, ink: f64, random: &mut Random) -> Vec<[f64; 2]> {
    let w = eye.w(puff.centre[2]);
    let reach = puff.radius / w + ink;
    (0..400)
        .map(|_| [0, 1].map(|axis: usize| puff.centre[axis] / w + reach * f64::from(random.signed())))
        .filter(|point| eye.sees(*point))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn culled_puffs_lie_behind_those_that_stay(
        eye in eyes(), count in 60..500_u32, seed in 0..1000_u32, spread in 0.3..1.5_f32, ink in 0.0..0.02_f64,
    ) {
        let solids = solids(seed);
        let mut simulator = cloud(count, seed, spread);
        let (kept, left) = culled(&mut simulator, &body_view(&eye, ink, &solids));
        let puff = |(place, attributes): &Row| Puff::new(*place, *attributes, &eye, &solids);
        let front: Vec<Puff> = kept.iter().map(puff).collect();
        let mut random = Random::new(seed);
        for hidden in left.iter().map(puff).filter(|puff| puff.radius > 0.0) {
            for point in points(&hidden, &eye, ink, &mut random) {
                let Some((depth, _)) = hidden.depth(&eye, point, ink) else { continue };
                let covers = |puff: &Puff| {
                    puff.radius > 0.0 && matches!(puff.depth(&eye, point, 0.0), Some((nearer, false)) if nearer < depth)
                };
                prop_assert!(front.iter().any(covers), "{:?} shows at {point:?}", hidden.centre);
            }
        }
    }

    #[test]
    fn culled_casters_cast_no_additional_shadow(
        eye in eyes(), count in 60..500_u32, seed in 0..1000_u32, covers in prop_oneof![4 => 1..4_usize, 1 => 4..9_usize], lamp in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        prop_assume!(dot(lamp, lamp) > 0.1);
        let (travel, solids) = (unit(lamp), solids(seed));
        let mut simulator = cloud(count, seed, 0.8);
        let (kept, left) = culled(&mut simulator, &shadow_view(&eye, travel, covers, &solids));
        let caps = start_caps();
        let shadow = |row: &Row| Shadow::new(row, &eye, travel, &caps, &solids);
        let thrown: Vec<Shadow> = kept.iter().map(shadow).collect();
        let mut random = Random::new(seed);
        for hidden in left.iter().map(shadow) {
            let start = hidden.start;
            for at in (0..60).map(|_| hidden.sample(&mut random)) {
                prop_assert!(darkens(&thrown, at, start, covers), "{:?} is lit at {at:?}", hidden.centre);
            }
        }
        for ended in thrown.iter().filter(|shadow| shadow.end.is_finite()) {
            prop_assert!(covers == 1);
            for at in (0..60).map(|_| ended.sample(&mut random)) {
                prop_assert!(darkens(&thrown, at, ended.end, 1), "{:?} is lit beyond its end at {at:?}", ended.centre);
            }
        }
    }
}

/// Whether `covers` shadows contain a line along the light from a depth on. One can continue where another ends.
fn darkens(thrown: &[Shadow], at: V3, from: f64, covers: usize) -> bool {
    let holding: Vec<&Shadow> = thrown.iter().filter(|shadow| shadow.holds(at)).collect();
    if covers > 1 {
        return holding.iter().filter(|shadow| shadow.start <= from).count() >= covers;
    }
    let mut reach = from;
    while let Some(next) = holding
        .iter()
        .find(|shadow| shadow.start <= reach && shadow.end > reach)
    {
        reach = next.end;
    }
    reach == f64::INFINITY
}

/// A shadow volume: the discs of its lobes across the light, starting at a depth along the light.
struct Shadow {
    centre: V3,
    start: f64,
    end: f64,
    /// Centre on the plane through the origin across the light, and radius.
    discs: Vec<(V3, f64)>,
}

impl Shadow {
    fn new((place, attributes): &Row, eye: &Observer, travel: V3, caps: &[f32], solids: &[f32]) -> Self {
        let centre = [place[0], place[1], place[2]].map(f64::from);
        let radius = f64::from(place[3]);
        let [x, y, depth] = eye.view(centre);
        let aside = [dot(travel, eye.right), dot(travel, eye.up)];
        let grown = grown(depth, radius);
        let ray = [x / depth, y / depth];
        let slope =
            -(aside[0] * ray[0].clamp(-1.1 * eye.half, 0.9 * eye.half) + aside[1] * ray[1].clamp(-eye.half, eye.half));
        let sheared = grown * (slope.max(-0.6 * slope) + 0.5 * grown * aside[0].hypot(aside[1]) * radius / depth);
        let shear = if eye.is_perspective && grown > 0.0 {
            sheared
        } else {
            0.0
        };
        let columns = &solids[(attributes[1] & 0xff) as usize % VARIATIONS * 4 * BALLS..][..4 * BALLS];
        let disc = |ball: usize| {
            let at = turned(
                [0, 1, 2].map(|axis| f64::from(columns[axis * BALLS + ball])),
                *attributes,
            );
            let middle: V3 = std::array::from_fn(|i| centre[i] + radius * at[i]);
            let along = dot(middle, travel);
            let flat = std::array::from_fn(|i| middle[i] - along * travel[i]);
            (flat, radius * f64::from(columns[3 * BALLS + ball]))
        };
        // Transforms back into the frame of the puff.
        let unturned = [attributes[0].wrapping_neg() & 0xffff, attributes[1]];
        let cap = start_cap(caps, *attributes, turned(travel.map(|c| -c), unturned));
        let start = dot(centre, travel) + (cap + shear + 0.02) * radius;
        let end = match attributes[0] >> 16 {
            0xffff => f64::INFINITY,
            steps => dot(centre, travel) + f64::from(steps) / 256.0 * radius,
        };
        let discs = (0..BALLS).map(disc).filter(|(_, radius)| *radius > 0.0).collect();
        Self {
            centre,
            start,
            end,
            discs,
        }
    }

    fn holds(&self, at: V3) -> bool {
        let inside = |(middle, radius): &(V3, f64)| {
            let beside = minus(at, *middle);
            dot(beside, beside) < radius * radius
        };
        self.discs.iter().any(inside)
    }

    /// A point between two points on the discs: shadow can be visible in the gaps between the discs.
    fn sample(&self, random: &mut Random) -> V3 {
        let mut on_disc = || {
            let (middle, radius) = self.discs[random.bits() as usize % self.discs.len()];
            // Every direction in the plane across the light is between two others.
            let way = minus(self.discs[random.bits() as usize % self.discs.len()].0, middle);
            let length = dot(way, way).sqrt();
            let reach = radius * f64::from(random.signed());
            let at: V3 = std::array::from_fn(|i| middle[i] + if length > 0.0 { reach * way[i] / length } else { 0.0 });
            at
        };
        let (a, b) = (on_disc(), on_disc());
        let share = f64::from(random.unit());
        std::array::from_fn(|i| a[i] + share * (b[i] - a[i]))
    }
}

#[test]
fn a_dense_cloud_is_mostly_hidden_and_a_thin_one_is_not() {
    let solids = solids(1);
    let eye = Observer::new([0.0, 0.4, 8.0], 0.25, true);
    let share = |count: u32, spread: f32, covers: usize| {
        let mut cloud = cloud(count, 3, spread);
        let (bodies, _) = culled(&mut cloud, &body_view(&eye, 0.002, &solids));
        let (casters, _) = culled(&mut cloud, &shadow_view(&eye, unit([0.4, -0.8, 0.1]), covers, &solids));
        [bodies.len(), casters.len()].map(|kept| kept as f64 / f64::from(count))
    };
    let [thin, dense] = [share(40, 2.0, 1), share(4000, 1.0, 1)];
    assert!(thin[0] > 0.9 && thin[1] > 0.9, "{thin:?} of a thin cloud stay");
    assert!(dense[0] < 0.35 && dense[1] < 0.45, "{dense:?} of a dense cloud stay");
    let mut dense_cloud = cloud(4000, 3, 1.0);
    let casters = rows(&mut dense_cloud, &shadow_view(&eye, unit([0.4, -0.8, 0.1]), 1, &solids));
    let ended = casters
        .iter()
        .filter(|(_, attributes)| attributes[0] >> 16 < 0xffff)
        .count();
    assert!(4 * ended > casters.len(), "{ended} of {} shadows end", casters.len());
    // The same holds for parallel view rays and any direction of the light.
    let from_afar = Observer::new([3.0, 4.0, 5.0], 1.5, false);
    let casters = rows(
        &mut dense_cloud,
        &shadow_view(&from_afar, unit([0.4, -0.8, 0.1]), 1, &solids),
    );
    assert!(casters.len() < 1800, "{} of 4000 casters stay", casters.len());
    // A higher required count culls fewer rows.
    let twice = share(4000, 1.0, 2);
    assert!(
        twice[1] > dense[1] + 0.02,
        "{dense:?} stay, {twice:?} where two covers are asked for"
    );
}

#[test]
fn more_ink_culls_less_and_zero_covers_cull_nothing() {
    let solids = solids(2);
    let eye = Observer::new([0.0, 0.4, 8.0], 0.25, true);
    let mut cloud = cloud(3000, 4, 1.0);
    let mut kept = |ink: f64| rows(&mut cloud, &body_view(&eye, ink, &solids)).len();
    let lines = [kept(0.0), kept(0.005), kept(0.02)];
    assert!(lines[0] < lines[1] && lines[1] < lines[2], "{lines:?}");
    let mut view = body_view(&eye, 0.0, &solids);
    view[2] = 0.0;
    assert_eq!(rows(&mut cloud, &view).len(), 3000);
}

#[test]
fn a_small_puff_is_hidden_behind_a_large_one_and_not_before_it() {
    let solids = solids(1);
    let eye = Observer::new([0.0, 0.0, 6.0], 0.3, true);
    let kept = |behind: f32| {
        let mut simulator = simulator(100, 1, &[STILL, FULL]);
        simulator.add(&Newborn {
            size: 1.0,
            ..newborn([0.0; 3])
        });
        simulator.add(&Newborn {
            size: 0.12,
            ..newborn([0.0, 0.0, -behind])
        });
        rows(&mut simulator, &body_view(&eye, 0.0, &solids)).len()
    };
    assert_eq!([kept(-0.9), kept(0.1), kept(0.6)], [2, 1, 1]);
}

#[test]
fn malformed_coverage_is_an_error_with_its_key() {
    let eye = Observer::new([0.0, 0.4, 8.0], 0.25, true);
    let mut cloud = cloud(10, 1, 1.0);
    let cases = [
        (30, -1.0, "view.pixel"),
        (32, -1e9, "view.farthest"),
        (33, 17.0, "view.covers"),
        (37, -1.0, "view.lift"),
        (34, f32::NAN, "view[34]"),
        (39, 0.0, "view.capMost"),
        (41, 5.0, "view.balls"),
        (41, 16.0, "view.balls"),
        (41, 0.0, "view.length"),
        (VIEW_FLOATS + 3, f32::INFINITY, "view[95]"),
        (91, 1.0, "view.length"),
    ];
    for (index, value, name) in cases {
        let mut view = body_view(&eye, 0.0, &solids(1));
        view[index] = value;
        assert_eq!(cloud.arrange(&view).unwrap_err().key, name);
    }
    let view = body_view(&eye, 0.0, &solids(1));
    assert_eq!(cloud.arrange(&view[..view.len() - 1]).unwrap_err().key, "view.length");
}
