//! A puff: balls of which a ray along the view axis meets the nearest surface.

use glam::{DMat3, DVec2, DVec3};

use crate::scene::Puffs;

#[derive(Clone, Copy)]
pub struct Lobe {
    pub center: DVec3,
    pub radius: f64,
}

/// The lobes of one variation, turned into view space; lengths in radii of the particle, z towards the eye.
pub struct Lobes {
    lobes: Vec<Lobe>,
    pub middle: DVec3,
    fillet: f64,
    blend: f64,
}

/// What is met over a point of the image plane.
pub struct Meeting {
    /// Height of the surface, or outside the silhouette of the nearest lobe's rim.
    pub height: f64,
    /// To the silhouette; not above 0 inside.
    pub outside: f64,
}

impl Lobes {
    pub fn new(puffs: &Puffs, variation: usize, view_from_puff: DMat3) -> Self {
        let lobes: Vec<Lobe> = puffs.lobes[variation % puffs.lobes.len()]
            .iter()
            .map(|&[x, y, z, radius]| Lobe {
                center: view_from_puff * DVec3::new(x, y, z),
                radius,
            })
            .collect();
        Self {
            middle: middle_of(&lobes),
            lobes,
            fillet: puffs.fillet,
            blend: puffs.blend,
        }
    }

    /// Farthest that the silhouette goes from the centre.
    pub fn reach(&self) -> f64 {
        self.lobes
            .iter()
            .map(|lobe| lobe.center.truncate().length() + lobe.radius)
            .fold(0.0, f64::max)
    }

    pub fn meet(&self, point: DVec2) -> Meeting {
        let mut meeting = Meeting {
            height: 0.0,
            outside: f64::INFINITY,
        };
        let mut top = f64::NEG_INFINITY;
        for lobe in &self.lobes {
            let beside = point.distance(lobe.center.truncate());
            if beside - lobe.radius < meeting.outside {
                meeting = Meeting {
                    height: lobe.center.z,
                    outside: beside - lobe.radius,
                };
            }
            if beside < lobe.radius {
                top = top.max(lobe.center.z + (lobe.radius.powi(2) - beside.powi(2)).sqrt());
            }
        }
        if meeting.outside < 0.0 {
            Meeting { height: top, ..meeting }
        } else {
            meeting
        }
    }

    /// Unit normal at a place of the surface or its rim: of the lobes there, one going over into the next along a
    /// crease, mixed with the direction from the middle of all.
    pub fn normal(&self, place: DVec3) -> DVec3 {
        let mut own = DVec3::ZERO;
        for lobe in &self.lobes {
            let outward = place - lobe.center;
            let away = (outward.length() - lobe.radius).abs();
            own += (1.0 - away / self.fillet).max(0.0).powi(2) * outward.normalize_or_zero();
        }
        own.normalize()
            .lerp((place - self.middle).normalize(), self.blend)
            .normalize()
    }
}

/// Centre of the lobes' volumes.
fn middle_of(lobes: &[Lobe]) -> DVec3 {
    let total: f64 = lobes.iter().map(|lobe| lobe.radius.powi(3)).sum();
    lobes
        .iter()
        .map(|lobe| lobe.radius.powi(3) * lobe.center)
        .sum::<DVec3>()
        / total
}
