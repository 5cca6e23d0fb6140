//! The light of the scene.

use glam::DVec3;

use crate::scene;

pub enum Light {
    /// A directional light: the unit vector towards it.
    Sun(DVec3),
    /// A point light: its position.
    Lamp(DVec3),
}

impl Light {
    pub fn new(light: &scene::Light) -> Self {
        match *light {
            scene::Light::Sun { towards } => Self::Sun(DVec3::from(towards).normalize()),
            scene::Light::Lamp { place } => Self::Lamp(place.into()),
        }
    }

    /// Unit vector from a position to the light.
    pub fn towards(&self, place: DVec3) -> DVec3 {
        match *self {
            Self::Sun(towards) => towards,
            Self::Lamp(lamp) => (lamp - place).normalize(),
        }
    }

    /// Vector from a position to the light (m).
    pub fn distance(&self, place: DVec3) -> f64 {
        match *self {
            Self::Sun(_) => f64::INFINITY,
            Self::Lamp(lamp) => lamp.distance(place),
        }
    }
}
