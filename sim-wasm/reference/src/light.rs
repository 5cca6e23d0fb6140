//! The light of the scene.

use glam::DVec3;

use crate::scene::{self, Illumination, Style};

pub enum Light {
    /// A directional light: the unit vector towards it.
    Sun(DVec3),
    /// A point light.
    Lamp { place: DVec3, decay: f64, scale: f64 },
}

impl Light {
    pub fn new(light: &scene::Light) -> Self {
        match *light {
            scene::Light::Sun { towards } => Self::Sun(DVec3::from(towards).normalize()),
            scene::Light::Lamp { place, decay, scale } => Self::Lamp {
                place: place.into(),
                decay,
                scale,
            },
        }
    }

    /// Unit vector from a position to the light.
    pub fn towards(&self, place: DVec3) -> DVec3 {
        match *self {
            Self::Sun(towards) => towards,
            Self::Lamp { place: lamp, .. } => (lamp - place).normalize(),
        }
    }

    /// Vector from a position to the light (m).
    pub fn distance(&self, place: DVec3) -> f64 {
        match *self {
            Self::Sun(_) => f64::INFINITY,
            Self::Lamp { place: lamp, .. } => lamp.distance(place),
        }
    }

    /// Colours and strengths of the light at a position.
    pub fn at(&self, place: DVec3, style: &Style) -> Illumination {
        let Illumination { mut direct, ambient } = style.illumination;
        if let (
            &Self::Lamp {
                place: lamp,
                decay,
                scale,
            },
            Some(at_one),
        ) = (self, style.lamp_light)
        {
            let factor = 1.0 / (scale * lamp.distance(place)).powf(decay).max(0.01);
            direct = at_one.map(|channel| channel * factor);
        }
        Illumination { direct, ambient }
    }
}
