//! The packed attributes of a row, as described in ARCHITECTURE.md.

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};

use crate::scene::Bands;

const TINTS: usize = 3;
const SEEDS: f64 = 256.0;
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

#[derive(Clone, Copy)]
pub struct PackedAttributes(pub [u32; 2]);

impl PackedAttributes {
    /// Roll (rad).
    pub fn roll(self) -> f64 {
        f64::from(self.0[0] & 0xffff) / 65536.0 * TAU
    }

    /// Age as a share of the lifetime.
    pub fn age(self) -> f64 {
        f64::from(self.0[0] >> 16) / 65535.0
    }

    pub fn variation(self) -> usize {
        (self.0[1] & 0xff) as usize
    }

    pub fn seed(self) -> u32 {
        self.0[1] >> 8 & 0xff
    }

    /// Index of the smoke ramp: one of the tints in turn, or without a tint by age and temperature.
    pub fn ramp(self, bands: &Bands) -> usize {
        match self.0[1] >> 24 {
            0 => bands.ages[(self.0[0] >> 24) as usize] + bands.temperatures[(self.0[1] >> 16 & 0xff) as usize],
            tint => 1 + (tint as usize - 1) % TINTS,
        }
    }

    /// Rotation by the roll about an axis of the particle: one of 256 on a golden spiral from pole to pole.
    pub fn world_from_puff(self) -> DMat3 {
        let seed = f64::from(self.seed());
        let z = 1.0 - (2.0 * seed + 1.0) / SEEDS;
        let (sin, cos) = (GOLDEN_ANGLE * seed).sin_cos();
        let axis = DVec3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z);
        DMat3::from_axis_angle(axis.normalize(), self.roll())
    }
}
