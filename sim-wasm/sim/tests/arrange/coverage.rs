//! Coverage against brute-force rays.

use crate::common::{STILL, newborn, simulator, steps};
use proptest::prelude::*;
use sim::Simulator;
use sim::arrange::row_layout::Attributes;
use sim::arrange::view_layout::ViewNumbers;
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
    fn matrix(&self) -> [f32; 16] {
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
        std::array::from_fn(|i| rows[i % 4][i / 4] as f32)
    }

    /// Share of its radius with which a puff is drawn, by its place in view space.
    fn clearance(&self, centre: V3, radius: f64, attributes: Attributes, form: Form) -> f64 {
        let beyond_near = if self.is_perspective {
            dot(centre, centre).sqrt() - NEAR
        } else {
            (centre[2] - NEAR).abs()
        };
        let ratio = match form {
            Form::Baked => 1.0,
            Form::Deformed => stretch(attributes).1,
        };
        smooth(beyond_near / (2.0 * radius * ratio.sqrt()))
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

fn smooth(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// A puff seen from the eye, in double precision.
struct Puff {
    centre: V3,
    radius: f64,
    balls: Vec<[f64; 4]>,
}

impl Puff {
    fn new(place: [f32; 4], attributes: Attributes, eye: &Observer, solids: &[f32], form: Form) -> Self {
        let centre = eye.view([place[0], place[1], place[2]].map(f64::from));
        let is_drawn = f64::from(u8::from(centre[2] > NEAR));
        let radius = is_drawn * f64::from(place[3]) * eye.clearance(centre, f64::from(place[3]), attributes, form);
        let columns = &solids[(attributes[1] & 0xff) as usize % VARIATIONS * 4 * BALLS..][..4 * BALLS];
        let ball = |ball: usize| {
            let age = f64::from(attributes[0] >> 16) / 65_535.0;
            let at = placed(columns, ball, attributes, age, form);
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

/// Whether the puffs of a cloud have their baked shapes, or turn, stretch and unfold with `puff.billow` 1.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    Baked,
    Deformed,
}

/// Centre of a ball in the world, in radii, without the place of the puff.
fn placed(columns: &[f32], ball: usize, attributes: Attributes, age: f64, form: Form) -> V3 {
    let at = [0, 1, 2].map(|axis| f64::from(columns[axis * BALLS + ball]));
    if form == Form::Baked {
        return turned(at, attributes);
    }
    let delay = 0.5 * (ball as f64 * 0.618_034).fract();
    let share = ((2.0 * age - delay) / 0.5).clamp(0.0, 1.0);
    let unfolded = 1.0 - 0.6 * (1.0 - share * share * (3.0 - 2.0 * share));
    let at = turned(at.map(|component| component * unfolded), attributes);

    let word = attributes[2] ^ 0xe008_0200;
    let rest = [0, 10, 20].map(|shift| (f64::from(word >> shift & 0x3ff) - 512.0) / 720.0);
    let mut turn = [0.0; 4];
    let largest = (word >> 30) as usize;
    (0..3).for_each(|place| turn[(largest + 1 + place) % 4] = rest[place]);
    turn[largest] = (1.0 - dot(rest, rest)).sqrt();
    let [x, y, z, w] = turn;
    let across = cross([x, y, z], at);
    let twice = cross([x, y, z], std::array::from_fn(|i| across[i] + w * at[i]));
    let at: V3 = std::array::from_fn(|i| at[i] + 2.0 * twice[i]);

    let (axis, ratio) = stretch(attributes);
    let along = (ratio - 1.0) * dot(at, axis);
    std::array::from_fn(|i| (at[i] + along * axis[i]) / ratio.sqrt())
}

/// Axis and ratio of the stretch of a row.
fn stretch(attributes: Attributes) -> (V3, f64) {
    let [u, v] = [0, 8].map(|shift| (f64::from(attributes[3] >> shift & 0xff) - 127.0) / 127.0);
    let z = 1.0 - u.abs() - v.abs();
    let axis = unit(if z < 0.0 {
        [(1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v), z]
    } else {
        [u, v, z]
    });
    (axis, 1.0 + 3.0 * f64::from(attributes[3] >> 16 & 0xff) / 255.0)
}

/// Transforms a direction from the frame of the puff to the world; see src/renderer/puffs/orientation.ts.
fn turned(at: V3, attributes: Attributes) -> V3 {
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

/// Puffs of all ages that turned and stretched for some steps.
fn deformed_cloud(count: u32, seed: u32, spread: f32) -> Simulator {
    let deforms = [
        ("puff.turn", 1.0),
        ("puff.stretch", STRETCH),
        ("puff.billow", 1.0),
        ("vortices.0.circulation", 20.0),
        ("vortices.0.reach", 9.0),
    ];
    let mut simulator = simulator(count, 1, &[STILL, FULL, &deforms]);
    let mut random = Random::new(seed);
    for _ in 0..count {
        let lifetime = 0.5 + random.unit();
        simulator.add(&Newborn {
            size: 0.3 + 0.35 * random.unit(),
            attributes: random.bits(),
            slip: std::array::from_fn(|_| random.signed() * 4.0),
            age: random.unit() * lifetime,
            lifetime,
            ..newborn(std::array::from_fn(|_| random.signed() * spread))
        });
    }
    steps(&mut simulator, 12);
    simulator
}

const STRETCH: f64 = 3.0;

fn cloud_of(form: Form, count: u32, seed: u32, spread: f32) -> Simulator {
    match form {
        Form::Baked => cloud(count, seed, spread),
        Form::Deformed => deformed_cloud(count, seed, spread),
    }
}

fn forms() -> impl Strategy<Value = Form> {
    prop_oneof![Just(Form::Baked), Just(Form::Deformed)]
}

/// A view with the tables that follow its numbers.
struct TabledView {
    numbers: ViewNumbers,
    tables: Vec<f32>,
}

impl TabledView {
    fn floats(&self) -> Vec<f32> {
        [&self.numbers.to_array(), &self.tables[..]].concat()
    }
}

fn view(eye: &Observer, ink: f64) -> ViewNumbers {
    let depth = dot(eye.at, eye.forward);
    let mut view = ViewNumbers {
        blend: 1.0,
        cull: 1.0,
        pad: ink as f32,
        clip_from_world: eye.matrix(),
        direction: eye.forward.map(|component| component as f32),
        reach: 1.0,
        receivers: [-3.0, -3.0, -3.0, 3.0, 3.0, 3.0],
        pixel: 0.001,
        nearest: (depth + NEAR) as f32,
        farthest: (depth + FAR) as f32,
        covers: 1.0,
        tolerance: 0.001,
        lift: (LIFT * ink) as f32,
        cap_range: CAPS.map(|cap| cap as f32),
        depth: 0.6,
        balls: BALLS as f32,
        lifters: 1.0,
        ..ViewNumbers::default()
    };
    view.lifter_boxes[0] = [-9.0, -9.0, -9.0, 9.0, 9.0, 9.0];
    view
}

fn with_reach(mut view: TabledView, form: Form) -> TabledView {
    if form == Form::Deformed {
        view.numbers.reach = STRETCH.powf(2.0 / 3.0) as f32;
    }
    view
}

fn body_view(eye: &Observer, ink: f64, solids: &[f32]) -> TabledView {
    TabledView {
        numbers: view(eye, ink),
        tables: solids.to_vec(),
    }
}

/// A sun by the direction of its light, or a lamp by its place.
#[derive(Clone, Copy, Debug)]
enum Light {
    Sun(V3),
    Lamp(V3),
}

impl Light {
    /// Direction and distance from the lamp; from the plane through the origin for a sun.
    fn travel(self, place: V3) -> (V3, f64) {
        match self {
            Self::Sun(travel) => (travel, dot(travel, place)),
            Self::Lamp(lamp) => {
                let way = minus(place, lamp);
                (unit(way), dot(way, way).sqrt())
            }
        }
    }

    /// A number of the ray through a place: a point of it for a sun, its direction for a lamp.
    fn ray(self, place: V3) -> V3 {
        match self {
            Self::Sun(_) => place,
            Self::Lamp(_) => self.travel(place).0,
        }
    }
}

fn lights() -> impl Strategy<Value = Light> {
    let away = prop::array::uniform3(-1.0..1.0_f64).prop_filter("a direction", |at| dot(*at, *at) > 0.1);
    let distance = prop_oneof![3 => 2.0..9.0_f64, 1 => 0.0..2.0_f64];
    (away, distance, prop::bool::ANY).prop_map(|(away, distance, is_sun)| match is_sun {
        true => Light::Sun(unit(away)),
        false => Light::Lamp(unit(away).map(|component| distance * component)),
    })
}

fn sun() -> Light {
    Light::Sun(unit([0.4, -0.8, 0.1]))
}

fn shadow_view(eye: &Observer, light: Light, covers: usize, solids: &[f32]) -> TabledView {
    let lamp = match light {
        Light::Sun(_) => [0.0; 3],
        Light::Lamp(lamp) => lamp,
    };
    TabledView {
        numbers: ViewNumbers {
            purpose: if matches!(light, Light::Sun(_)) { 1.0 } else { 2.0 },
            direction: light.travel([0.01, 0.0, 0.0]).0.map(|component| component as f32),
            lamp: lamp.map(|component| component as f32),
            covers: covers as f32,
            caps_follow: 1.0,
            ..view(eye, 0.0)
        },
        tables: solids.iter().copied().chain(start_caps()).collect(),
    }
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
fn start_cap(caps: &[f32], attributes: Attributes, [x, y, z]: V3) -> f64 {
    let column = (y.atan2(x) / std::f64::consts::TAU + 0.5) * TABLE[0] as f64;
    let row = z.clamp(-1.0, 1.0).acos() / std::f64::consts::PI * TABLE[1] as f64;
    let variation = (attributes[1] & 0xff) as usize % VARIATIONS;
    let row = variation * TABLE[1] + (row as usize).min(TABLE[1] - 1);
    f64::from(caps[row * TABLE[0] + (column as usize).min(TABLE[0] - 1)])
}

type Row = ([f32; 4], Attributes);

fn rows(simulator: &mut Simulator, view: &TabledView) -> Vec<Row> {
    let count = simulator.arrange(&view.floats()).unwrap();
    let (place, attributes) = (simulator.place(), simulator.attributes());
    (0..count).map(|row| (place[row], attributes[row])).collect()
}

/// The remaining rows, and those that only coverage culls. The remaining rows keep their order.
fn culled(simulator: &mut Simulator, mut view: TabledView) -> (Vec<Row>, Vec<Row>) {
    let kept = rows(simulator, &view);
    view.numbers.covers = 0.0;
    let all = rows(simulator, &view);
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
    a.0 == b.0 && a.1[0] & 0xffff == b.1[0] & 0xffff && a.1[1..] == b.1[1..]
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
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn culled_puffs_lie_behind_those_that_stay(
        eye in eyes(), count in 60..500_u32, seed in 0..1000_u32, spread in 0.3..1.5_f32, ink in 0.0..0.02_f64,
        form in forms(),
    ) {
        let solids = solids(seed);
        let mut simulator = cloud_of(form, count, seed, spread);
        let (kept, left) = culled(&mut simulator, with_reach(body_view(&eye, ink, &solids), form));
        let puff = |(place, attributes): &Row| Puff::new(*place, *attributes, &eye, &solids, form);
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
        eye in eyes(), count in 60..500_u32, seed in 0..1000_u32, covers in prop_oneof![4 => 1..4_usize, 1 => 4..9_usize], light in lights(),
        form in forms(),
    ) {
        let solids = solids(seed);
        let mut simulator = cloud_of(form, count, seed, 0.8);
        let (kept, left) = culled(&mut simulator, with_reach(shadow_view(&eye, light, covers, &solids), form));
        let caps = start_caps();
        let shadow = |row: &Row| Shadow::new(row, &eye, light, &caps, &solids, form);
        // Nothing is left of a puff around the eye.
        let is_left = |shadow: &Shadow| !shadow.discs.is_empty();
        let thrown: Vec<Shadow> = kept.iter().map(shadow).filter(is_left).collect();
        let mut random = Random::new(seed);
        for hidden in left.iter().map(shadow).filter(is_left) {
            for at in (0..60).map(|_| hidden.sample(&mut random)) {
                prop_assert!(darkens(&thrown, at, hidden.start(at), covers), "{:?} is lit at {at:?}", hidden.centre);
            }
        }
        for ended in thrown.iter().filter(|shadow| shadow.last.is_finite()) {
            prop_assert!(covers == 1);
            for at in (0..60).map(|_| ended.sample(&mut random)) {
                prop_assert!(darkens(&thrown, at, ended.end(at), 1), "{:?} is lit beyond its end at {at:?}", ended.centre);
            }
        }
    }
}

/// Whether `covers` shadows contain a ray of the light from a depth on. One can continue where another ends.
fn darkens(thrown: &[Shadow], at: V3, from: f64, covers: usize) -> bool {
    let holding: Vec<&Shadow> = thrown.iter().filter(|shadow| shadow.holds(at)).collect();
    if covers > 1 {
        return holding.iter().filter(|shadow| shadow.start(at) <= from).count() >= covers;
    }
    let mut reach = from;
    while let Some(next) = holding
        .iter()
        .find(|shadow| shadow.start(at) <= reach && shadow.end(at) > reach)
    {
        reach = next.end(at);
    }
    reach == f64::INFINITY
}

/// A shadow volume: the discs of its lobes across the light, starting at a depth along the light.
struct Shadow {
    light: Light,
    centre: V3,
    travel: V3,
    /// Depths along `travel`: of the centre, of the start, of the end.
    middle: f64,
    first: f64,
    last: f64,
    /// Centre, against that of the puff, and radius on the plane through the centre of the puff.
    discs: Vec<(V3, f64)>,
}

impl Shadow {
    fn new((place, attributes): &Row, eye: &Observer, light: Light, caps: &[f32], solids: &[f32], form: Form) -> Self {
        let centre = [place[0], place[1], place[2]].map(f64::from);
        let (travel, middle) = light.travel(centre);
        let seen = eye.view(centre);
        let radius = f64::from(place[3]) * eye.clearance(seen, f64::from(place[3]), *attributes, form);
        let reach = if form == Form::Deformed {
            STRETCH.powf(2.0 / 3.0)
        } else {
            1.0
        };
        let [x, y, depth] = seen;
        let aside = [dot(travel, eye.right), dot(travel, eye.up)];
        let ahead = depth.max(0.5 * radius);
        let ray = [x / ahead, y / ahead];
        let slope =
            -(aside[0] * ray[0].clamp(-1.1 * eye.half, 0.9 * eye.half) + aside[1] * ray[1].clamp(-eye.half, eye.half));
        let shear = if eye.is_perspective {
            slope.max(-0.6 * slope) + 0.5 * aside[0].hypot(aside[1]) * radius / ahead
        } else {
            0.0
        };
        let columns = &solids[(attributes[1] & 0xff) as usize % VARIATIONS * 4 * BALLS..][..4 * BALLS];
        let age = f64::from(attributes[1] >> 16) / 65_535.0;
        let disc = |ball: usize| {
            let at = placed(columns, ball, *attributes, age, form);
            let along = dot(at, travel);
            let growth = match light {
                Light::Sun(_) => 0.0,
                Light::Lamp(_) => radius / middle.max(1.2 * reach * radius),
            };
            let near = 1.0 / (1.0 + growth * along);
            let flat: V3 = std::array::from_fn(|i| radius * near * (at[i] - along * travel[i]));
            let ball = f64::from(columns[3 * BALLS + ball]) * near;
            (flat, radius * ball / (1.0 - (ball * growth).powi(2)).sqrt())
        };
        // Transforms back into the frame of the puff.
        let unturned = [attributes[0].wrapping_neg() & 0xffff, attributes[1], 0, 0];
        let cap = match form {
            Form::Baked => start_cap(caps, *attributes, turned(travel.map(|c| -c), unturned)),
            Form::Deformed => (0..BALLS)
                .filter(|ball| columns[3 * BALLS + ball] > 0.0)
                .map(|ball| dot(travel, placed(columns, ball, *attributes, age, form)))
                .fold(CAPS[0], f64::max),
        };
        let first = middle + (cap + shear + 0.02) * radius;
        let last = match attributes[0] >> 16 {
            0xffff => f64::INFINITY,
            steps => middle + f64::from(steps) / 256.0 * f64::from(place[3]),
        };
        let discs = (0..BALLS).map(disc).filter(|(_, radius)| *radius > 0.0).collect();
        Self {
            light,
            centre,
            travel,
            middle,
            first,
            last,
            discs,
        }
    }

    /// Where a ray is on the plane through the centre, against the centre, and the ratio of depths along the ray to those
    /// along `travel`.
    fn crossing(&self, ray: V3) -> (V3, f64) {
        let along = dot(ray, self.travel);
        match self.light {
            Light::Sun(_) => {
                let beside = minus(ray, self.centre);
                let along = dot(beside, self.travel);
                (std::array::from_fn(|i| beside[i] - along * self.travel[i]), 1.0)
            }
            Light::Lamp(_) if along <= 0.0 => ([f64::INFINITY; 3], f64::INFINITY),
            Light::Lamp(_) => {
                let beside = |i: usize| self.middle * (ray[i] / along - self.travel[i]);
                (std::array::from_fn(beside), 1.0 / along)
            }
        }
    }

    fn start(&self, ray: V3) -> f64 {
        self.first * self.crossing(ray).1
    }

    fn end(&self, ray: V3) -> f64 {
        self.last * self.crossing(ray).1
    }

    fn holds(&self, ray: V3) -> bool {
        let (at, _) = self.crossing(ray);
        let inside = |(middle, radius): &(V3, f64)| {
            let beside = minus(at, *middle);
            dot(beside, beside) < radius * radius
        };
        self.discs.iter().any(inside)
    }

    /// A ray between two points on the discs: shadow can be visible in the gaps between the discs.
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
        let place = std::array::from_fn(|i| self.centre[i] + a[i] + share * (b[i] - a[i]));
        self.light.ray(place)
    }
}

#[test]
fn a_dense_cloud_is_mostly_hidden_and_a_thin_one_is_not() {
    let solids = solids(1);
    let eye = Observer::new([0.0, 0.4, 8.0], 0.25, true);
    let share = |count: u32, spread: f32, covers: usize| {
        let mut cloud = cloud(count, 3, spread);
        let (bodies, _) = culled(&mut cloud, body_view(&eye, 0.002, &solids));
        let (casters, _) = culled(&mut cloud, shadow_view(&eye, sun(), covers, &solids));
        [bodies.len(), casters.len()].map(|kept| kept as f64 / f64::from(count))
    };
    let [thin, dense] = [share(40, 2.0, 1), share(4000, 1.0, 1)];
    assert!(thin[0] > 0.9 && thin[1] > 0.9, "{thin:?} of a thin cloud stay");
    assert!(dense[0] < 0.35 && dense[1] < 0.45, "{dense:?} of a dense cloud stay");
    let mut dense_cloud = cloud(4000, 3, 1.0);
    let casters = rows(&mut dense_cloud, &shadow_view(&eye, sun(), 1, &solids));
    let ended = casters
        .iter()
        .filter(|(_, attributes)| attributes[0] >> 16 < 0xffff)
        .count();
    assert!(4 * ended > casters.len(), "{ended} of {} shadows end", casters.len());
    let lamp = Light::Lamp([-2.0, 4.0, -0.5]);
    let (casters, _) = culled(&mut dense_cloud, shadow_view(&eye, lamp, 1, &solids));
    assert!(casters.len() < 2000, "{} of 4000 casters of a lamp stay", casters.len());
    // The same holds for parallel view rays and any direction of the light.
    let from_afar = Observer::new([3.0, 4.0, 5.0], 1.5, false);
    let casters = rows(&mut dense_cloud, &shadow_view(&from_afar, sun(), 1, &solids));
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
    view.numbers.cull = 0.0;
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
    type Change = fn(&mut TabledView);
    let cases: [(Change, &str); 11] = [
        (|view| view.numbers.pixel = -1.0, "view.pixel"),
        (|view| view.numbers.farthest = -1e9, "view.farthest"),
        (|view| view.numbers.covers = 17.0, "view.covers"),
        (|view| view.numbers.lift = -1.0, "view.lift"),
        (|view| view.numbers.tolerance = f32::NAN, "view[34]"),
        (|view| view.numbers.cap_range[1] = 0.0, "view.capMost"),
        (|view| view.numbers.balls = 5.0, "view.balls"),
        (|view| view.numbers.balls = 16.0, "view.balls"),
        (|view| view.numbers.balls = 0.0, "view.length"),
        (|view| view.tables[3] = f32::INFINITY, "view[100]"),
        (|view| view.numbers.caps_follow = 1.0, "view.length"),
    ];
    for (change, name) in cases {
        let mut view = body_view(&eye, 0.0, &solids(1));
        change(&mut view);
        assert_eq!(cloud.arrange(&view.floats()).unwrap_err().key, name);
    }
    let view = body_view(&eye, 0.0, &solids(1)).floats();
    assert_eq!(cloud.arrange(&view[..view.len() - 1]).unwrap_err().key, "view.length");
}
