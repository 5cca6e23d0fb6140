//! A puff: balls, stretched to ellipsoids; a ray along the view axis meets the nearest surface.

use glam::{DMat2, DMat3, DVec2, DVec3};

use crate::attributes::{unfolded, unstretched};
use crate::contact::STEEPEST;
use crate::scene::Puffs;

#[derive(Clone, Copy)]
pub struct Lobe {
    pub center: DVec3,
    pub radius: f64,
}

/// The lobes of one variation in view space; lengths in radii, z towards the eye.
pub struct Lobes {
    /// Where they are balls.
    lobes: Vec<Lobe>,
    pub middle: DVec3,
    /// From view space to where lobes are balls. Lines along z stay parallel to z.
    unstretched: DMat3,
    ratio: f64,
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
    /// `age` is a share of the lifetime, `stretching` the part of `view_from_puff` that is not a rotation, with a width of 1
    /// across the stretch, and `ratio` its length.
    pub fn new(
        puffs: &Puffs,
        variation: usize,
        age: f64,
        view_from_puff: DMat3,
        (stretching, ratio): (DMat3, f64),
    ) -> Self {
        let unstretched = unstretched(stretching);
        let lobes: Vec<Lobe> = puffs.lobes[variation % puffs.lobes.len()]
            .iter()
            .enumerate()
            .map(|(index, &[x, y, z, radius])| Lobe {
                center: unstretched * view_from_puff * DVec3::new(x, y, z) * unfolded(index, age, puffs.billow),
                radius,
            })
            .collect();
        Self {
            middle: unstretched.inverse() * middle_of(&lobes),
            lobes,
            unstretched,
            ratio,
            fillet: puffs.fillet,
            blend: puffs.blend,
        }
    }

    /// Maximum distance of the silhouette from the centre.
    pub fn reach(&self) -> f64 {
        self.lobes
            .iter()
            .map(|lobe| (lobe.center.length() + lobe.radius) * self.ratio)
            .fold(0.0, f64::max)
    }

    /// `surface`: height of an occluding surface. Lobes deeper by more than `slack` have no rim.
    pub fn meet(&self, point: DVec2, surface: f64, slack: f64) -> Meeting {
        let plane = DMat2::from_mat3(self.unstretched);
        let on_board = self.unstretched * point.extend(0.0);
        let depth = self.unstretched.z_axis.z;
        let (seen, surface) = (on_board.truncate(), on_board.z + depth * surface);
        let mut top = f64::NEG_INFINITY;
        let mut rim = Meeting {
            height: 0.0,
            outside: f64::INFINITY,
            rim: DVec2::ZERO,
        };
        for lobe in &self.lobes {
            let middle = lobe.center.truncate();
            let outside = seen.distance(middle) - lobe.radius;
            if outside <= 0.0 {
                let beside = seen.distance_squared(middle);
                top = top.max(lobe.center.z + (lobe.radius.powi(2) - beside).sqrt());
            } else if outside < rim.outside && lobe.center.z + STEEPEST * outside >= surface - slack {
                rim = Meeting {
                    height: lobe.center.z,
                    outside,
                    rim: middle,
                };
            }
        }
        let height = |height: f64| (height - on_board.z) / depth;
        if top > surface {
            Meeting {
                height: height(top),
                outside: 0.0,
                rim: point,
            }
        } else {
            // Distances along the gradient.
            let gradient = plane * (rim.rim - seen);
            Meeting {
                height: height(rim.height),
                outside: rim.outside / (plane * (rim.rim - seen).normalize()).length(),
                rim: point + gradient,
            }
        }
    }

    /// Unit normal for shading: the normal of the form, mixed with the direction from the common centre.
    pub fn normal(&self, place: DVec3) -> DVec3 {
        let outward = (self.unstretched * (place - self.middle)).normalize();
        (self.unstretched.transpose() * self.own_normal(place).lerp(outward, self.blend)).normalize()
    }

    /// Unit normal of the lobes, blended along creases.
    pub fn form_normal(&self, place: DVec3) -> DVec3 {
        (self.unstretched.transpose() * self.own_normal(place)).normalize()
    }

    /// The same where lobes are balls.
    fn own_normal(&self, place: DVec3) -> DVec3 {
        let place = self.unstretched * place;
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
