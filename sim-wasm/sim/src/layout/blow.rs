//! A blow: the description of a gust along a ray, as a user gives it.

use crate::layout::bytes::{Reader, Writer};
use crate::layout::error::{ParameterError, RestoreError};
use crate::layout::quantise::{quantise, within};
use crate::layout::quantised::direction;
use crate::layout::quantised::{
    Millimetres, direction_numbers, metres, millimetres, of_axis, read_direction, read_place, write_direction,
    write_place,
};

const MAX_SPEED: f64 = 50.0;
const MAX_RADIUS: f64 = 10.0;
const MAX_SECONDS: f64 = 10.0;
/// Units per m/s, per metre and per second. The last are steps.
const PARTS: [f64; 3] = [100.0, 1000.0, 60.0];

/// A blow in floating-point numbers.
#[derive(Clone, Copy, Debug)]
pub struct BlowNumbers {
    /// Origin of the ray (m), -1000..=1000 each.
    pub origin: [f64; 3],
    /// Direction of the ray, of any length.
    pub ray: [f64; 3],
    /// Peak velocity of the air on the ray (m/s), -50..=50 each.
    pub velocity: [f64; 3],
    /// Distance from the ray within which the air moves (m), 0.01..=10.
    pub radius: f64,
    /// Duration (s), 1/60..=10.
    pub seconds: f64,
}

/// A quantised blow: millimetres, centimetres per second, steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Blow {
    origin: Millimetres,
    ray: [i16; 3],
    velocity: [i16; 3],
    radius: u16,
    pub(crate) steps: u16,
}

impl Blow {
    /// Quantises `numbers`. A number that is not finite or out of range is an error.
    pub fn new(numbers: &BlowNumbers) -> Result<Self, ParameterError> {
        let mut velocity = [0; 3];
        for (axis, (whole, part)) in velocity.iter_mut().zip(numbers.velocity).enumerate() {
            let key = of_axis("blow.velocity", axis);
            *whole = quantise(&key, part, [-MAX_SPEED, MAX_SPEED], PARTS[0])? as i16;
        }
        Ok(Self {
            origin: millimetres("blow.origin", numbers.origin)?,
            ray: direction("blow.ray", numbers.ray)?,
            velocity,
            radius: quantise("blow.radius", numbers.radius, [0.01, MAX_RADIUS], PARTS[1])? as u16,
            steps: quantise("blow.seconds", numbers.seconds, [1.0 / PARTS[2], MAX_SECONDS], PARTS[2])? as u16,
        })
    }

    /// Origin of the ray (m).
    pub fn origin(&self) -> [f32; 3] {
        metres(self.origin)
    }

    /// Unit direction of the ray.
    pub fn ray(&self) -> [f32; 3] {
        direction_numbers(self.ray)
    }

    /// Peak velocity of the air (m/s).
    pub fn velocity(&self) -> [f32; 3] {
        self.velocity.map(|part| f32::from(part) / PARTS[0] as f32)
    }

    /// Distance from the ray within which the air moves (m).
    pub fn radius(&self) -> f32 {
        f32::from(self.radius) / PARTS[1] as f32
    }

    pub(crate) fn write(&self, body: &mut Writer) {
        write_place(self.origin, body);
        write_direction(self.ray, body);
        write_direction(self.velocity, body);
        body.short(self.radius);
        body.short(self.steps);
    }

    pub(crate) fn read(reader: &mut Reader) -> Result<Self, RestoreError> {
        let fastest = (MAX_SPEED * PARTS[0]) as i16;
        let (origin, ray) = (read_place(reader)?, read_direction(reader)?);
        let mut velocity = [0; 3];
        for part in &mut velocity {
            *part = within(reader.short()? as i16, -fastest, fastest)?;
        }
        Ok(Self {
            origin,
            ray,
            velocity,
            radius: within(reader.short()?, 10, (MAX_RADIUS * PARTS[1]) as u16)?,
            steps: within(reader.short()?, 1, (MAX_SECONDS * PARTS[2]) as u16)?,
        })
    }
}
