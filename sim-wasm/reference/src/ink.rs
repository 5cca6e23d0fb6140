//! Width and opacity of lines. Widths and radii in pixels.

use std::f64::consts::TAU;

use glam::DVec2;

/// Radius of a puff in line widths, and width of a line, between which a line grows or fades.
const LINE_RADII: [f64; 2] = [1.0, 3.5];
const FADE_WIDTHS: [f64; 2] = [0.5, 1.0];
const FADE_RADII: [f64; 2] = [1.5, 3.0];

/// A line and its swelling: at 1 it is twice as wide away from the light, and half as wide towards it.
pub struct Line {
    /// Width where it runs across the light.
    even: f64,
    /// Opacity beside a puff of this radius, 0 to 1.
    boldness: f64,
    swell: f64,
    /// Image-plane component of the unit vector to the light.
    light: DVec2,
    /// Amplitude (0 to 1) and phases (rad) of trembling.
    boil: f64,
    phase: f64,
}

impl Line {
    /// `full`: its width beside a sufficiently large puff, by its widest point.
    pub fn new(full: f64, radius: f64, swell: f64, light: DVec2) -> Self {
        Self {
            even: line_width(full * swell.exp2(), radius) / swell.exp2(),
            boldness: between(FADE_RADII, radius / (full * swell.exp2()).max(1e-6)),
            swell,
            light,
            boil: 0.0,
            phase: 0.0,
        }
    }

    /// The same line with trembling. `seed`: of the puff. `drawing`: index of the drawing.
    pub fn boiling(self, boil: f64, seed: u32, drawing: u32) -> Self {
        let bits = seed
            .wrapping_mul(747_796_405)
            .wrapping_add(drawing.wrapping_mul(2_891_336_453));
        let bits = (bits ^ bits >> 16).wrapping_mul(73_244_475);
        let phase = f64::from(bits >> 8 & 0xffff) / 65536.0 * TAU;
        Self { boil, phase, ..self }
    }

    /// Width where the silhouette faces `outward`.
    pub fn width(&self, outward: DVec2) -> f64 {
        self.even * swelling(outward.normalize_or_zero(), self.light, self.swell) * self.steadiness(outward)
    }

    /// Factor of trembling on the width: waves of three and of eight periods around the puff.
    fn steadiness(&self, outward: DVec2) -> f64 {
        let turn = outward.to_angle();
        let waves = (3.0 * turn + self.phase).sin() + (8.0 * turn - 2.7 * self.phase).sin();
        1.0 - self.boil * (0.25 + 0.125 * waves)
    }

    /// Opacity at this width: below one pixel it blends into the colour of its smoke, below half a pixel it is 0.
    pub fn share(&self, width: f64) -> f64 {
        self.boldness * between(FADE_WIDTHS, width)
    }

    pub fn widest(&self) -> f64 {
        self.even * self.swell.exp2()
    }
}

/// Factor on the width of a line that faces `outward`, a unit vector of the image plane.
pub fn swelling(outward: DVec2, light: DVec2, swell: f64) -> f64 {
    (-swell * outward.dot(light)).exp2()
}

/// 1 beside puffs with a radius of at least 3.5 widths, 0 beside those no larger than the line.
fn line_width(full: f64, radius: f64) -> f64 {
    if full <= 0.0 {
        0.0
    } else {
        full * between(LINE_RADII, radius / full)
    }
}

fn between([from, to]: [f64; 2], value: f64) -> f64 {
    smooth_step(from, to, value)
}

/// Smoothstep from 0 at `from` to 1 at `to`.
pub fn smooth_step(from: f64, to: f64, value: f64) -> f64 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
