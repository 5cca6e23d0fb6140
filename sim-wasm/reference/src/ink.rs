//! How wide a line is, beside a puff and else, and how much of it is ink. Widths and radii in pixels.

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
}

impl Line {
    /// `full`: its even width beside a puff that is large enough, by what is widest of it.
    pub fn new(full: f64, radius: f64, swell: f64, light: DVec2) -> Self {
        Self {
            even: line_width(full * swell.exp2(), radius) / swell.exp2(),
            boldness: smooth_step(1.5, 3.0, radius / (full * swell.exp2()).max(1e-6)),
            swell,
            light,
        }
    }

    /// Width where the silhouette looks in the direction of `outward`.
    pub fn width(&self, outward: DVec2) -> f64 {
        self.even * swelling(outward.normalize_or_zero(), self.light, self.swell)
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
