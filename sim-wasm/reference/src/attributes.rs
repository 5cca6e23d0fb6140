//! The packed attributes of a row.

use std::f64::consts::TAU;

use glam::{DMat2, DMat3, DQuat, DVec2, DVec3};
use sim::arrange::row_layout::{
    AGE, Attributes, CASTER_AGE, EROSION, LOOK, NO_ROTATION, ROLL, SEED, STRETCH, STRETCH_AXIS, TEMPERATURE, TINT,
    TURN, TURN_LARGEST, VARIATION,
};

use crate::scene::{Look, Puffs, Style};

const TINTS: usize = 3;
const SEEDS: f64 = 256.0;
const QUATERNION_STEPS: f64 = 720.0;
const MAX_STRETCH: f64 = 4.0;
const BILLOW_DEPTH: f64 = 0.6;
const BILLOW_DELAY: f64 = 0.5;
const BILLOW_STEP: f64 = 0.618034;
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

#[derive(Clone, Copy)]
pub struct PackedAttributes(pub Attributes);

impl PackedAttributes {
    /// Roll (rad).
    pub fn roll(self) -> f64 {
        f64::from(ROLL.of(self.0)) / (f64::from(ROLL.max) + 1.0) * TAU
    }

    /// Age as a share of the lifetime.
    pub fn age(self) -> f64 {
        f64::from(AGE.of(self.0)) / f64::from(AGE.max)
    }

    /// The same in a row of a caster.
    pub fn caster_age(self) -> f64 {
        f64::from(CASTER_AGE.of(self.0)) / f64::from(CASTER_AGE.max)
    }

    /// How far it is dissolved, 0 to 1.
    pub fn erosion(self) -> f64 {
        f64::from(EROSION.of(self.0)) / f64::from(EROSION.max)
    }

    pub fn variation(self) -> usize {
        VARIATION.of(self.0) as usize
    }

    pub fn seed(self) -> u32 {
        SEED.of(self.0)
    }

    /// Its look, if it differs from that of the smoke.
    pub fn look(self, style: &Style) -> Option<&Look> {
        style.looks.get((LOOK.of(self.0) as usize).checked_sub(1)?)
    }

    /// Index of the smoke ramp: one of the tints in turn, or without a tint by age and temperature.
    pub fn ramp(self, style: &Style) -> usize {
        let own = self.look(style).and_then(|look| look.bands.as_ref());
        let bands = own.unwrap_or(&style.bands);
        match TINT.of(self.0) {
            // The ramps have 256 ages.
            0 => bands.ages[(AGE.of(self.0) >> 8) as usize] + bands.temperatures[TEMPERATURE.of(self.0) as usize],
            tint => 1 + (tint as usize - 1) % TINTS,
        }
    }

    /// Rotation by the roll about an axis of the particle: one of 256 on a golden spiral from pole to pole.
    pub fn world_from_puff(self) -> DMat3 {
        let seed = f64::from(self.seed());
        let z = 1.0 - (2.0 * seed + 1.0) / SEEDS;
        let (sin, cos) = (GOLDEN_ANGLE * seed).sin_cos();
        let axis = DVec3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z);
        stretching(self.stretch())
            * DMat3::from_quat(self.turn())
            * DMat3::from_axis_angle(axis.normalize(), self.roll())
    }

    /// The axis of the stretch in the puff's frame if bites lie along it.
    pub fn torn_along(self, puffs: &Puffs) -> Option<DVec3> {
        let (axis, ratio) = self.stretch();
        let rotation = stretching((axis, ratio)).inverse() * self.world_from_puff();
        puffs.is_torn.then(|| (rotation.transpose() * axis).normalize())
    }

    /// The turn by the air: a quaternion without its largest component.
    fn turn(self) -> DQuat {
        let mut attributes = self.0;
        attributes[TURN_LARGEST.word] ^= NO_ROTATION;
        let rest = TURN.map(|bits| (f64::from(bits.of(attributes)) - 512.0) / QUATERNION_STEPS);
        let largest = TURN_LARGEST.of(attributes) as usize;
        let mut turn = [0.0; 4];
        for (place, component) in rest.into_iter().enumerate() {
            turn[(largest + 1 + place) % 4] = component;
        }
        turn[largest] = (1.0 - rest.iter().map(|component| component * component).sum::<f64>()).sqrt();
        DQuat::from_array(turn)
    }

    /// Axis of the stretch and ratio of the axes.
    pub fn stretch(self) -> (DVec3, f64) {
        let ratio = 1.0 + (MAX_STRETCH - 1.0) * f64::from(STRETCH.of(self.0)) / f64::from(STRETCH.max);
        let [u, v] = STRETCH_AXIS.map(|bits| (f64::from(bits.of(self.0)) - 127.0) / 127.0);
        let z = 1.0 - u.abs() - v.abs();
        let axis = if z < 0.0 {
            DVec3::new((1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v), z)
        } else {
            DVec3::new(u, v, z)
        };
        (axis.normalize(), ratio)
    }
}

/// Longer along the axis of a stretch and thinner across it, at the same area seen across it.
pub fn stretching((axis, ratio): (DVec3, f64)) -> DMat3 {
    let along = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
    (DMat3::IDENTITY + (ratio - 1.0) * along) * ratio.sqrt().recip()
}

/// A linear map after which the ellipsoids into which a map turns balls are balls again, and lines along z are still
/// parallel to z.
pub fn unstretched(stretching: DMat3) -> DMat3 {
    // Ellipsoids are dot(x, form * x) = 1; completing the square of z leaves a form of x and y.
    let form = (stretching * stretching.transpose()).inverse();
    let shear = form.z_axis.truncate() / form.z_axis.z;
    let flat = DMat2::from_cols(form.x_axis.truncate(), form.y_axis.truncate())
        - form.z_axis.z * DMat2::from_cols(shear * shear.x, shear * shear.y);
    // The root of a symmetric matrix, after Cayley and Hamilton.
    let root = flat.determinant().sqrt();
    let trace = flat.x_axis.x + flat.y_axis.y;
    let plane = (flat + DMat2::from_diagonal(DVec2::splat(root))) * (trace + 2.0 * root).sqrt().recip();
    let depth = form.z_axis.z.sqrt();
    DMat3::from_cols(
        plane.x_axis.extend(depth * shear.x),
        plane.y_axis.extend(depth * shear.y),
        DVec3::new(0.0, 0.0, depth),
    )
}

/// Factor on the centre of lobe `index` at `age`, a share of the lifetime: lobes of young puffs are folded, and unfold one
/// after another.
pub fn unfolded(index: usize, age: f64, billow: f64) -> f64 {
    let delay = BILLOW_DELAY * (index as f64 * BILLOW_STEP).fract();
    let share = ((2.0 * age - delay) / (1.0 - BILLOW_DELAY)).clamp(0.0, 1.0);
    1.0 - BILLOW_DEPTH * billow * (1.0 - share * share * (3.0 - 2.0 * share))
}
