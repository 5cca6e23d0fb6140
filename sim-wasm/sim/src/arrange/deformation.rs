//! Turn and stretch in the packed attributes of a row.

use crate::arrange::row_layout::{
    Attributes, MAX_STRETCH, NO_ROTATION, QUATERNION_STEPS, STRETCH, STRETCH_AXIS, TURN, TURN_LARGEST,
};
use crate::math::scalar::greater;
use crate::particles::Particles;
use crate::particles::following::FlowLaw;

/// Packed turn and stretch of particle `i`, `back` seconds before the current state, by its `dissolution` and
/// `strand` as in [`RadiusLaw`](crate::particles::radius::RadiusLaw).
// Called from several loops; inlining would repeat it in each.
#[inline(never)]
pub(super) fn packed(
    law: &FlowLaw,
    particles: &Particles,
    i: usize,
    back: f32,
    dissolution: f32,
    strand: f32,
) -> [u32; 2] {
    let Some(flow) = &particles.flow else {
        return [0; 2];
    };
    let (turn, velocity) = law.shown(flow, particles, i, back);
    let speed = length(velocity);
    [
        packed_turn(turn),
        packed_stretch(
            velocity,
            speed,
            law.ratio(particles, i, speed, dissolution, strand),
            strand > 1.0,
        ),
    ]
}

/// Direction in an octahedral map, then the ratio of the axes. 0 without stretch, unless it `has_direction` nevertheless.
fn packed_stretch(velocity: [f32; 3], speed: f32, ratio: f32, has_direction: bool) -> u32 {
    let steps = ((ratio - 1.0) / (MAX_STRETCH - 1.0) * STRETCH.max as f32 + 0.5) as u32;
    if steps == 0 && !has_direction {
        return 0;
    }
    let [x, y, z] = velocity.map(|component| component / greater(speed, 1e-20));
    let sum = x.abs() + y.abs() + z.abs();
    let (x, y) = (x / sum, y / sum);
    let [u, v] = folded(x, y, z);
    let byte = |value: f32| (value * 127.0 + 127.5) as u32;
    STRETCH_AXIS[0].packed(byte(u)) | STRETCH_AXIS[1].packed(byte(v)) | STRETCH.packed(steps)
}

/// Folds the lower half of an octahedron over its upper half; its own inverse.
fn folded(x: f32, y: f32, z: f32) -> [f32; 2] {
    let sign = |value: f32| if value < 0.0 { -1.0 } else { 1.0 };
    if z < 0.0 {
        [(1.0 - y.abs()) * sign(x), (1.0 - x.abs()) * sign(y)]
    } else {
        [x, y]
    }
}

/// The largest component is left out and positive; its index is in the upper two bits.
fn packed_turn(turn: [f32; 4]) -> u32 {
    let mut largest = 3;
    for at in 0..3 {
        if turn[at].abs() > turn[largest].abs() {
            largest = at;
        }
    }
    let sign = if turn[largest] < 0.0 { -1.0 } else { 1.0 };
    let mut word = (largest as u32) << 30;
    for place in 0..3 {
        let component = turn[(largest + 1 + place) % 4] * sign;
        let steps = (component * QUATERNION_STEPS + 512.5) as u32;
        word |= steps.min(1023) << (10 * place);
    }
    word ^ NO_ROTATION
}

fn length([x, y, z]: [f32; 3]) -> f32 {
    (x * x + y * y + z * z).sqrt()
}

/// The transpose of a puff's stretch and turn, without its roll, applied to `row`.
#[inline(never)]
pub(crate) fn undeformed(attributes: Attributes, row: [f32; 3]) -> [f32; 3] {
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let ratio = ratio(attributes);
    let mut row = row;
    if ratio > 1.0 {
        let axis = stretch_axis(attributes);
        let along = (ratio - 1.0) * dot(row, axis);
        let across = across(ratio);
        row = std::array::from_fn(|i| (row[i] + along * axis[i]) * across);
    }
    let [x, y, z, w] = turn(attributes);
    // The rotation by the conjugate: row + 2 v x (v x row + w row) with v = -(x, y, z).
    let v = [-x, -y, -z];
    let cross = |a: [f32; 3], b: [f32; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    let inner = cross(v, row);
    let outer = cross(v, std::array::from_fn(|i| inner[i] + w * row[i]));
    std::array::from_fn(|i| row[i] + 2.0 * outer[i])
}

/// Ratio of the axes of a puff, at least 1.
pub(crate) fn ratio(attributes: Attributes) -> f32 {
    1.0 + (MAX_STRETCH - 1.0) * STRETCH.of(attributes) as f32 / STRETCH.max as f32
}

/// Width of a puff across its stretch. Seen across it, a lobe keeps its area.
pub(crate) fn across(ratio: f32) -> f32 {
    1.0 / ratio.sqrt()
}

/// The unit vector along which a puff is stretched.
fn stretch_axis(attributes: Attributes) -> [f32; 3] {
    let [u, v] = STRETCH_AXIS.map(|bits| (bits.of(attributes) as f32 - 127.0) / 127.0);
    let z = 1.0 - u.abs() - v.abs();
    let [x, y] = folded(u, v, z);
    let inverse = 1.0 / (x * x + y * y + z * z).sqrt();
    [x * inverse, y * inverse, z * inverse]
}

/// The unit quaternion of a puff's turn: x, y, z, w.
fn turn(mut attributes: Attributes) -> [f32; 4] {
    attributes[TURN_LARGEST.word] ^= NO_ROTATION;
    let largest = TURN_LARGEST.of(attributes) as usize;
    let mut turn = [0.0; 4];
    let mut square = 1.0;
    for (place, bits) in TURN.into_iter().enumerate() {
        let component = (bits.of(attributes) as f32 - 512.0) / QUATERNION_STEPS;
        turn[(largest + 1 + place) % 4] = component;
        square -= component * component;
    }
    turn[largest] = greater(square, 0.0).sqrt();
    turn
}
