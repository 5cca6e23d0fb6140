//! Colours: the tones of ramps, and gradient fills. Channels from 0 to 255, display-encoded.

use glam::DVec3;

use crate::scene::{Gradient, Ramp, Style, Tone};

/// Cosine to the fill light from which it shows.
const FILL_BORDER: f64 = 0.65;
/// Numbers of tones that no ramp has.
const FILLED: usize = 1000;
const RIM: usize = 2000;

/// What a pixel shows in the light and in shadow, and which tone of the ramp each is.
#[derive(Clone, Copy)]
pub struct Shade {
    pub lit: DVec3,
    pub unlit: DVec3,
    pub tone: usize,
}

impl Shade {
    pub fn same(color: DVec3) -> Self {
        Self {
            lit: color,
            unlit: color,
            tone: 0,
        }
    }

    /// `facing`: cosine between normal and light.
    pub fn of(ramp: &Ramp, facing: f64) -> Self {
        let (lit, unlit) = (tone_at(&ramp.lit, facing), tone_at(&ramp.unlit, facing));
        Self {
            lit: DVec3::from(ramp.lit[lit].color),
            unlit: DVec3::from(ramp.unlit[unlit].color),
            tone: lit * ramp.unlit.len() + unlit,
        }
    }

    /// Of smoke: a rim along the silhouette lies over everything, a fill light within the first tone. In view space.
    pub fn of_puff(style: &Style, ramp: &Ramp, normal: DVec3, light: DVec3, gradient: DVec3) -> Self {
        let facing = normal.dot(light);
        if normal.z < style.rim * (0.5 - facing).clamp(0.0, 1.0) {
            return Self {
                tone: RIM,
                ..Self::same(DVec3::from(style.rim_color))
            };
        }
        let mut shade = Self::of(ramp, facing);
        if let Some(filled) = ramp.filled.filter(|_| normal.dot(towards_fill(light)) > FILL_BORDER) {
            let first = DVec3::from(ramp.lit[0].color);
            let fill = |color: DVec3| if color == first { DVec3::from(filled) } else { color };
            shade = Self {
                lit: fill(shade.lit),
                unlit: fill(shade.unlit),
                tone: shade.tone + FILLED,
            };
        }
        Self {
            lit: shade.lit * gradient,
            unlit: shade.unlit * gradient,
            ..shade
        }
    }

    pub fn inked(self, ink: DVec3, share: f64) -> Self {
        Self {
            lit: self.lit.lerp(ink, share),
            unlit: self.unlit.lerp(ink, share),
            ..self
        }
    }
}

/// The last tone that begins at or below a cosine; the first one reaches down to everything that looks away.
fn tone_at(tones: &[Tone], facing: f64) -> usize {
    tones.iter().rposition(|tone| facing.max(0.0) >= tone.from).unwrap_or(0)
}

/// A weaker light from across the eye and a little from below.
fn towards_fill(light: DVec3) -> DVec3 {
    DVec3::new(-light.x, -0.4 * light.y, light.z.abs().max(0.3)).normalize()
}

/// Where a point stands along each kind of gradient, from 0 (the gradient's colour) to 1 (the smoke's own).
pub struct Along {
    /// Height over the centre in radii, on the image plane.
    pub puff: f64,
    /// World height, metres.
    pub height: f64,
    /// From the bottom to the top of the picture.
    pub screen: f64,
    pub age: f64,
}

/// Factor on a colour of the ramp.
pub fn gradient_factor(style: &Style, along: &Along) -> DVec3 {
    let [bottom, top] = style.plume_height;
    let share = match style.gradient {
        Gradient::None => return DVec3::ONE,
        Gradient::Puff => 0.5 + 0.5 * along.puff,
        Gradient::Height => (along.height - bottom) / (top - bottom).max(1e-6),
        Gradient::Screen => along.screen,
        Gradient::Age => 1.0 - along.age,
    };
    let low = DVec3::from(style.gradient_color) / DVec3::from(style.smoke_color).max(DVec3::ONE);
    low.lerp(DVec3::ONE, share.clamp(0.0, 1.0))
}
