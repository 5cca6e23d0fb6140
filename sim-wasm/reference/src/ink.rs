//! How wide a line is, beside a puff and else, and how much of it is ink. Widths and radii in pixels.

use std::f64::consts::TAU;

use glam::DVec2;

/// A line and how it swells: at 1 it is twice as wide away from the light, and half as wide towards it.
pub struct Line {
    /// Where it runs across the light.
    even: f64,
    /// 0 to 1: how much of it is ink beside a puff of this radius.
    boldness: f64,
    swell: f64,
    /// Of the unit vector towards the light, what lies in the image plane.
    light: DVec2,
    /// How much it trembles, 0 to 1, and where round the puff, radians.
    boil: f64,
    phase: f64,
}

impl Line {
    /// `full`: its even width beside a puff that is large enough, by what is widest of it.
    pub fn new(full: f64, radius: f64, swell: f64, light: DVec2) -> Self {
        Self {
            even: line_width(full * swell.exp2(), radius) / swell.exp2(),
            boldness: smooth_step(1.5, 3.0, radius / (full * swell.exp2()).max(1e-6)),
            swell,
            light,
            boil: 0.0,
            phase: 0.0,
        }
    }

    /// The same line drawn by an unsteady hand. `seed`: of the puff. `drawing`: number of the drawing.
    pub fn boiling(self, boil: f64, seed: u32, drawing: u32) -> Self {
        let bits = seed
            .wrapping_mul(747_796_405)
            .wrapping_add(drawing.wrapping_mul(2_891_336_453));
        let bits = (bits ^ bits >> 16).wrapping_mul(73_244_475);
        let phase = f64::from(bits >> 8 & 0xffff) / 65536.0 * TAU;
        Self { boil, phase, ..self }
    }

    /// Width where the silhouette looks in the direction of `outward`.
    pub fn width(&self, outward: DVec2) -> f64 {
        self.even * swelling(outward.normalize_or_zero(), self.light, self.swell) * self.steadiness(outward)
    }

    /// Share of the width that trembling leaves: waves of three and of eight periods round the puff.
    fn steadiness(&self, outward: DVec2) -> f64 {
        let turn = outward.to_angle();
        let waves = (3.0 * turn + self.phase).sin() + (8.0 * turn - 2.7 * self.phase).sin();
        1.0 - self.boil * (0.25 + 0.125 * waves)
    }

    /// How much of it is ink, where it is so wide: under a pixel it goes over into the colour of its smoke, and under half
    /// a pixel it is gone.
    pub fn share(&self, width: f64) -> f64 {
        self.boldness * smooth_step(0.5, 1.0, width)
    }

    pub fn widest(&self) -> f64 {
        self.even * self.swell.exp2()
    }
}

/// Factor on the width of a line that looks in the direction of `outward`, a unit vector of the image plane.
pub fn swelling(outward: DVec2, light: DVec2, swell: f64) -> f64 {
    (-swell * outward.dot(light)).exp2()
}

/// Full beside puffs with a radius of 3.5 widths and more, nothing beside those no larger than the line is wide.
fn line_width(full: f64, radius: f64) -> f64 {
    if full <= 0.0 {
        0.0
    } else {
        full * smooth_step(1.0, 3.5, radius / full)
    }
}

/// From 0 at `from` to 1 at `to`, flat at both ends.
pub fn smooth_step(from: f64, to: f64, value: f64) -> f64 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
