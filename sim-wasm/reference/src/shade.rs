//! Colours: tones of ramps, and gradients. Channels 0 to 255, display-encoded.

use glam::DVec3;

use crate::form::Form;
use crate::scene::{Gradient, Illumination, Ramp, Style, Tone, Triple};

/// Minimum cosine to the fill light.
const FILL_BORDER: f64 = 0.65;
/// Number of texels of a ramp, read without interpolation.
const RAMP_TEXELS: f64 = 256.0;

/// Colours of a pixel in light and in shadow.
#[derive(Clone, Copy)]
pub struct Shade {
    pub lit: DVec3,
    pub unlit: DVec3,
    pub part: Part,
    /// Opacity of ink.
    pub ink: f64,
}

/// The displayed part of its colours.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// Numbers of the tones in light and in shadow, and whether the fill light reaches them.
    Tones {
        lit: usize,
        unlit: usize,
        is_filled: bool,
    },
    /// Where light leans on the form of the whole smoke: colours in light and in shadow.
    Leaning {
        lit: [u64; 3],
        unlit: [u64; 3],
    },
    Rim,
    Ink,
    /// A line so narrow that it blends into the colour of its smoke.
    FaintInk,
    Only,
}

impl Shade {
    pub fn same(color: DVec3, part: Part) -> Self {
        Self {
            lit: color,
            unlit: color,
            part,
            ink: if part == Part::Ink { 1.0 } else { 0.0 },
        }
    }

    /// `facing`: cosine between normal and light. With fill light the ramp starts with another colour.
    pub fn of(ramp: &Ramp, light: &Illumination, facing: f64, is_filled: bool) -> Self {
        let first = ramp.filled.filter(|_| is_filled);
        let facing = (facing.clamp(0.0, 1.0) * RAMP_TEXELS).floor() / RAMP_TEXELS;
        let part = Part::Tones {
            lit: tone_at(&ramp.lit, facing),
            unlit: tone_at(&ramp.unlit, facing),
            is_filled: first.is_some(),
        };
        let color = |tones| {
            let (tone, share) = color_at(tones, facing, first, ramp.is_blended);
            let ambient = linear(DVec3::from(ramp.unlit[0].color));
            // The fill light stays as it is.
            let by_fill = share * first.map_or(DVec3::ZERO, |first| linear(DVec3::from(first)) - ambient);
            let by_key = linear(tone) - ambient - by_fill;
            let scaled = ambient * DVec3::from(light.ambient) + by_key * DVec3::from(light.direct) + by_fill;
            display(scaled.lerp(linear(tone), ramp.glow))
        };
        Self {
            lit: color(&ramp.lit),
            unlit: color(&ramp.unlit),
            part,
            ink: 0.0,
        }
    }

    /// Shading of smoke, in view space. A rim covers silhouettes where the puff faces away from the light.
    pub fn of_puff(
        style: &Style,
        colors: &Illumination,
        ramp: &Ramp,
        normal: DVec3,
        light: DVec3,
        whole: Option<(&Form, f64)>,
    ) -> Self {
        let facing = normal.dot(light);
        // As a share of the radius of a ball.
        let band = 0.5 * style.rim * (0.5 - facing).clamp(0.0, 1.0);
        if band > 0.0 && normal.z < (band * (2.0 - band)).sqrt() {
            let own = linear(DVec3::from(style.rim_color));
            let scaled = (own * DVec3::from(colors.direct)).min(DVec3::ONE);
            return Self::same(display(scaled.lerp(own, ramp.glow)), Part::Rim);
        }
        let is_filled = normal.dot(towards_fill(light)) > FILL_BORDER;
        let shade = Self::of(ramp, colors, facing, is_filled);
        match whole {
            Some((form, whole)) => shade.leaning(colors, ramp, facing, form, whole),
            None => shade,
        }
    }

    /// Multiplies tones by a gradient.
    pub fn graded(self, gradient: DVec3) -> Self {
        match self.part {
            Part::Tones { .. } | Part::Leaning { .. } => Self {
                lit: self.lit * gradient,
                unlit: self.unlit * gradient,
                ..self
            },
            _ => self,
        }
    }

    /// Light and shadow where the light leans on the form of the whole smoke. `own`, `whole`: cosines to the light.
    fn leaning(self, light: &Illumination, ramp: &Ramp, own: f64, form: &Form, whole: f64) -> Self {
        let lit_from = ramp.lit_from();
        let lit_at = |own: f64| {
            let facing = own + form.lean * (whole - own);
            Self::of(ramp, light, facing.max(lit_from), false).as_lit()
        };
        let is_lit = |share| form.share(share, whole) > 0.5;
        let in_shadow = if is_lit(0.0) { lit_at(lit_from) } else { self.as_unlit() };
        let in_light = match own < lit_from {
            true => in_shadow,
            false if is_lit(1.0) => lit_at(own),
            false => Self::of(ramp, light, 0.0, false).as_unlit(),
        };
        Self {
            lit: in_light.lit,
            unlit: in_shadow.unlit,
            part: Part::Leaning {
                lit: in_light.shown(),
                unlit: in_shadow.shown(),
            },
            ink: 0.0,
        }
    }

    /// The same in light and in shadow.
    fn as_lit(self) -> Self {
        Self {
            unlit: self.lit,
            ..self
        }
    }

    fn as_unlit(self) -> Self {
        Self {
            lit: self.unlit,
            ..self
        }
    }

    /// The colour of something that is the same in light and in shadow, as a number.
    fn shown(&self) -> [u64; 3] {
        self.lit.to_array().map(f64::to_bits)
    }

    pub fn inked(self, ink: DVec3, share: f64) -> Self {
        Self {
            lit: self.lit.lerp(ink, share),
            unlit: self.unlit.lerp(ink, share),
            part: if share < 1.0 { Part::FaintInk } else { Part::Ink },
            ink: share,
        }
    }
}

/// The shadow over a position.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shadow {
    No,
    Plain,
    Deep,
}

impl Shadow {
    /// `count`: number of volumes that contain it.
    pub fn of(style: &Style, count: u32) -> Self {
        match style.shadow_depth {
            _ if count == 0 => Self::No,
            Some(depth) if count >= depth => Self::Deep,
            _ => Self::Plain,
        }
    }
}

impl Shade {
    /// Ink is the same in every light.
    pub fn under(&self, shadow: Shadow, style: &Style) -> DVec3 {
        match shadow {
            Shadow::No => self.lit,
            Shadow::Deep if self.part != Part::Ink => self.unlit * DVec3::from(style.deep_shadow) / 255.0,
            _ => self.unlit,
        }
    }
}

/// The last tone that starts at or below a cosine; below its start the first one.
fn tone_at(tones: &[Tone], facing: f64) -> usize {
    tones.iter().rposition(|tone| facing >= tone.from).unwrap_or(0)
}

/// The colour of a ramp, and the share of its first tone. `first` replaces this tone, if given. Tones are flat or blend.
fn color_at(tones: &[Tone], facing: f64, first: Option<Triple>, is_blended: bool) -> (DVec3, f64) {
    let color_of = |tone: usize| DVec3::from(first.filter(|_| tone == 0).unwrap_or(tones[tone].color));
    let tone = tone_at(tones, facing);
    match tones.get(tone + 1) {
        Some(next) if is_blended => {
            let share = ((facing - tones[tone].from) / (next.from - tones[tone].from)).max(0.0);
            let first_share = if tone == 0 { 1.0 - share } else { 0.0 };
            (color_of(tone).lerp(color_of(tone + 1), share), first_share)
        }
        _ => (color_of(tone), if tone == 0 { 1.0 } else { 0.0 }),
    }
}

/// The colour of lines. They are the same in all light, so they follow the mean of both parts.
pub fn ink_of(style: &Style) -> DVec3 {
    let Illumination { direct, ambient } = &style.illumination;
    let mean = 0.5 * (DVec3::from(*direct) + DVec3::from(*ambient));
    display(linear(DVec3::from(style.ink_color)) * DVec3::ONE.lerp(mean, style.ink_light))
}

/// Light of display-encoded channels, as IEC 61966-2-1 defines them.
pub fn linear(color: DVec3) -> DVec3 {
    let decoded = |code: f64| match code / 255.0 {
        code if code <= 0.04045 => code / 12.92,
        code => ((code + 0.055) / 1.055).powf(2.4),
    };
    DVec3::new(decoded(color.x), decoded(color.y), decoded(color.z))
}

/// The inverse. Light below 0 and above 1 is clamped.
pub fn display(light: DVec3) -> DVec3 {
    let encoded = |light: f64| match light.clamp(0.0, 1.0) {
        light if light <= 0.0031308 => 255.0 * 12.92 * light,
        light => 255.0 * (1.055 * light.powf(1.0 / 2.4) - 0.055),
    };
    DVec3::new(encoded(light.x), encoded(light.y), encoded(light.z))
}

/// A weaker light from opposite of the eye and slightly below.
fn towards_fill(light: DVec3) -> DVec3 {
    DVec3::new(-light.x, -0.4 * light.y, light.z.abs().max(0.3)).normalize()
}

/// Position along each kind of gradient, from 0 (its colour) to 1 (the smoke's colour).
pub struct Along {
    /// Height over the centre on the image plane (radii).
    pub puff: f64,
    /// World height (m).
    pub height: f64,
    /// From the bottom to the top of the picture.
    pub screen: f64,
    pub age: f64,
}

/// Factor on a colour of the ramp.
pub fn gradient_factor(style: &Style, along: &Along) -> DVec3 {
    let [bottom, top] = style.gradient_heights;
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
