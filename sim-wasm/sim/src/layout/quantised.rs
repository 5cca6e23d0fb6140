//! Quantised positions (whole millimetres), directions and quaternions (units of 1 / 32,767).

use crate::layout::bytes::{Reader, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::quantise::{quantise, within};

/// Maximum distance of an input from the world's origin (mm, then m).
const MAX_COORDINATE: i32 = 1_000_000;
const MAX_METRES: f64 = 1000.0;
const PARTS_A_METRE: f64 = 1000.0;
/// Units of a quantised unit vector.
const UNIT: i16 = i16::MAX;
const AXES: [&str; 3] = ["x", "y", "z"];

/// A position in whole millimetres.
pub type Millimetres = [i32; 3];

/// Quantises a position (m). `key` names it in errors.
pub fn millimetres(key: &str, place: [f64; 3]) -> Result<Millimetres, ParameterError> {
    let mut whole = [0; 3];
    for (axis, (whole, metres)) in whole.iter_mut().zip(place).enumerate() {
        let range = [-MAX_METRES, MAX_METRES];
        *whole = quantise(&of_axis(key, axis), metres, range, PARTS_A_METRE)? as i32;
    }
    Ok(whole)
}

/// The position in metres.
pub fn metres(place: Millimetres) -> [f32; 3] {
    place.map(|whole| whole as f32 / PARTS_A_METRE as f32)
}

/// `key.x`, `key.y` or `key.z`.
pub fn of_axis(key: &str, axis: usize) -> String {
    [key, ".", AXES[axis]].concat()
}

/// Quantises the direction of a vector of any length but 0. `key` names it in errors.
pub fn direction<const N: usize>(key: &str, vector: [f64; N]) -> Result<[i16; N], ParameterError> {
    let length = libm::sqrt(vector.iter().map(|part| part * part).sum());
    if !(1e-6..=1e6).contains(&length) {
        return Err(ParameterError::out_of_range(key, length, 1e-6, 1e6));
    }
    Ok(vector.map(|part| libm::round(part / length * f64::from(UNIT)) as i16))
}

/// The direction as numbers, of length 1 up to quantisation.
pub fn direction_numbers<const N: usize>(direction: [i16; N]) -> [f32; N] {
    direction.map(|part| f32::from(part) / f32::from(UNIT))
}

pub fn write_place(place: Millimetres, body: &mut Writer) {
    place.iter().for_each(|whole| body.word(*whole as u32));
}

pub fn read_place(reader: &mut Reader) -> Result<Millimetres, RestoreError> {
    let mut place = [0; 3];
    for whole in &mut place {
        *whole = within(reader.word()? as i32, -MAX_COORDINATE, MAX_COORDINATE)?;
    }
    Ok(place)
}

pub fn write_direction<const N: usize>(direction: [i16; N], body: &mut Writer) {
    direction.iter().for_each(|part| body.short(*part as u16));
}

pub fn read_direction<const N: usize>(reader: &mut Reader) -> Result<[i16; N], RestoreError> {
    let mut direction = [0; N];
    for part in &mut direction {
        *part = within(reader.short()? as i16, -UNIT, UNIT)?;
    }
    let square: f32 = direction_numbers(direction).iter().map(|part| part * part).sum();
    within(square, 0.99, 1.01)?;
    Ok(direction)
}

/// A quantised position and rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuantisedPose {
    place: Millimetres,
    rotation: [i16; 4],
}

impl QuantisedPose {
    /// Quantises x, y, z (m) and the quaternion x, y, z, w.
    pub fn new(numbers: [f64; 7]) -> Result<Self, ParameterError> {
        let [x, y, z, rotation @ ..] = numbers;
        Ok(Self {
            place: millimetres("rigid.position", [x, y, z])?,
            rotation: direction("rigid.rotation", rotation)?,
        })
    }

    /// The seven numbers: x, y, z (m) and the quaternion x, y, z, w.
    pub fn numbers(&self) -> [f32; 7] {
        let ([x, y, z], [i, j, k, w]) = (metres(self.place), direction_numbers(self.rotation));
        [x, y, z, i, j, k, w]
    }

    pub(crate) fn write(&self, body: &mut Writer) {
        write_place(self.place, body);
        write_direction(self.rotation, body);
    }

    pub(crate) fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        Ok(Self {
            place: read_place(reader)?,
            rotation: read_direction(reader)?,
        })
    }
}

/// A point of a rigid, the position it is dragged to, and the stiffness of the spring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grip {
    anchor: Millimetres,
    target: Millimetres,
    /// In units of 0.1/s.
    stiffness: u16,
}

/// Range of the stiffness (1/s), and units per 1/s.
const STIFFNESSES: [f64; 2] = [0.1, 200.0];
const PARTS_OF_STIFFNESS: f64 = 10.0;

impl Grip {
    /// Quantises the point in the rigid's space (m), the target in world space (m) and the stiffness (1/s).
    pub fn new(numbers: [f64; 7]) -> Result<Self, ParameterError> {
        let [a, b, c, x, y, z, stiffness] = numbers;
        let parts = quantise("rigid.drag.stiffness", stiffness, STIFFNESSES, PARTS_OF_STIFFNESS)?;
        Ok(Self {
            anchor: millimetres("rigid.drag.anchor", [a, b, c])?,
            target: millimetres("rigid.drag.target", [x, y, z])?,
            stiffness: parts as u16,
        })
    }

    /// Point (m), target (m) and stiffness (1/s).
    pub fn numbers(&self) -> ([f32; 3], [f32; 3], f32) {
        let stiffness = f32::from(self.stiffness) / PARTS_OF_STIFFNESS as f32;
        (metres(self.anchor), metres(self.target), stiffness)
    }

    pub(crate) fn write(&self, body: &mut Writer) {
        write_place(self.anchor, body);
        write_place(self.target, body);
        body.short(self.stiffness);
    }

    pub(crate) fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let [least, most] = STIFFNESSES.map(|stiffness| (stiffness * PARTS_OF_STIFFNESS) as u16);
        Ok(Self {
            anchor: read_place(reader)?,
            target: read_place(reader)?,
            stiffness: within(reader.short()?, least, most)?,
        })
    }
}
