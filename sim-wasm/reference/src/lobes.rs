//! A puff: balls; a ray along the view axis meets the nearest surface.

use glam::{DMat3, DVec2, DVec3};

use crate::attributes::unfolded;
use crate::contact::STEEPEST;
use crate::scene::Puffs;

#[derive(Clone, Copy)]
pub struct Lobe {
    pub center: DVec3,
    pub radius: f64,
}

/// The lobes of one variation in view space; lengths in particle radii, z towards the eye.
pub struct Lobes {
    lobes: Vec<Lobe>,
    pub middle: DVec3,
    fillet: f64,
    blend: f64,
}

/// The result over a point of the image plane.
pub struct Meeting {
    /// Height of the surface; outside of the silhouette that of the nearest lobe's rim.
    pub height: f64,
    /// Distance to the silhouette; at most 0 inside.
    pub outside: f64,
    /// Centre of the lobe with the nearest silhouette.
    pub rim: DVec2,
}

impl Lobes {
    /// `age` is a share of the lifetime.
    pub fn new(puffs: &Puffs, variation: usize, age: f64, view_from_puff: DMat3) -> Self {
        let lobes: Vec<Lobe> = puffs.lobes[variation % puffs.lobes.len()]
            .iter()
            .enumerate()
            .map(|(index, &[x, y, z, radius])| Lobe {
                center: view_from_puff * DVec3::new(x, y, z) * unfolded(index, age, puffs.billow),
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

    /// Maximum distance of the silhouette from the centre.
    pub fn reach(&self) -> f64 {
        self.lobes
            .iter()
            .map(|lobe| lobe.center.truncate().length() + lobe.radius)
            .fold(0.0, f64::max)
    }

    /// `surface`: height of an occluding surface. Lobes deeper by more than `slack` have no rim.
    pub fn meet(&self, point: DVec2, surface: f64, slack: f64) -> Meeting {
        let mut top = f64::NEG_INFINITY;
        let mut rim = Meeting {
            height: 0.0,
            outside: f64::INFINITY,
            rim: DVec2::ZERO,
        };
        for lobe in &self.lobes {
            let middle = lobe.center.truncate();
            let outside = point.distance(middle) - lobe.radius;
            if outside <= 0.0 {
                let beside = point.distance_squared(middle);
                top = top.max(lobe.center.z + (lobe.radius.powi(2) - beside).sqrt());
            } else if outside < rim.outside && lobe.center.z + STEEPEST * outside >= surface - slack {
                rim = Meeting {
                    height: lobe.center.z,
                    outside,
                    rim: middle,
                };
            }
        }
        if top > surface {
            Meeting {
                height: top,
                outside: 0.0,
                rim: point,
            }
        } else {
            rim
        }
    }

    /// Unit normal for shading: the normal of the form, mixed with the direction from the common centre.
    pub fn normal(&self, place: DVec3) -> DVec3 {
        self.form_normal(place)
            .lerp((place - self.middle).normalize(), self.blend)
            .normalize()
    }

    /// Unit normal of the lobes, blended along creases.
    pub fn form_normal(&self, place: DVec3) -> DVec3 {
        let mut own = DVec3::ZERO;
        for lobe in &self.lobes {
            let outward = place - lobe.center;
            let away = (outward.length() - lobe.radius).abs();
            own += (1.0 - away / self.fillet).max(0.0).powi(2) * outward.normalize_or_zero();
        }
        own.normalize()
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
