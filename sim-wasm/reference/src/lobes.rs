//! A puff: balls, stretched to ellipsoids; a ray along the view axis meets the nearest surface.

use glam::{DMat2, DMat3, DVec2, DVec3};

use crate::attributes::{PackedAttributes, unfolded, unstretched};
use crate::bites::{self, FIRST_START, Lobe};
use crate::contact::STEEPEST;
use crate::scene::Puffs;

/// Lines are as if no surface was steeper than this against the eye: the least cosine.
const STEEPEST_LINED: f64 = 0.3;
/// Width of the lines of bites in widths of the outline.
const BITE_LINE: f64 = 0.65;

/// The lobes of one variation in view space; lengths in radii, z towards the eye.
pub struct Lobes {
    /// Where they are balls.
    lobes: Vec<Lobe>,
    /// Balls that are cut out of them.
    bites: Vec<Lobe>,
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
    /// The bite whose wall this is; none for a lobe.
    pub wall: Option<usize>,
    /// Whether the line along the edge of a wall is here.
    pub is_edge: bool,
}

impl Lobes {
    /// `stretching` is the part of `view_from_puff` that is not a rotation, with a width of 1
    /// across the stretch, and `ratio` its length.
    pub fn new(
        puffs: &Puffs,
        attributes: PackedAttributes,
        view_from_puff: DMat3,
        (stretching, ratio): (DMat3, f64),
    ) -> Self {
        let unstretched = unstretched(stretching);
        let (variation, age, erosion) = (attributes.variation(), attributes.age(), attributes.erosion());
        let bites = if puffs.is_eroded && erosion > FIRST_START {
            bites::bites(erosion, attributes.torn_along(puffs), unstretched * view_from_puff)
        } else {
            Vec::new()
        };
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
            lobes: lobes.into_iter().filter(|lobe| !is_eaten(lobe, &bites)).collect(),
            bites,
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

    /// `surface`: height of an occluding surface. `line`: width of a line; lobes deeper by more than two of them have no
    /// rim.
    pub fn meet(&self, point: DVec2, surface: f64, line: f64) -> Meeting {
        let plane = DMat2::from_mat3(self.unstretched);
        let on_board = self.unstretched * point.extend(0.0);
        let depth = self.unstretched.z_axis.z;
        let (seen, surface) = (on_board.truncate(), on_board.z + depth * surface);
        let mut top = f64::NEG_INFINITY;
        let mut rim = Meeting {
            height: 0.0,
            outside: f64::INFINITY,
            rim: DVec2::ZERO,
            wall: None,
            is_edge: false,
        };
        for lobe in &self.lobes {
            let middle = lobe.center.truncate();
            let outside = seen.distance(middle) - lobe.radius;
            if outside <= 0.0 {
                let beside = seen.distance_squared(middle);
                top = top.max(lobe.center.z + (lobe.radius.powi(2) - beside).sqrt());
            }
            let is_seen = lobe.center.z + STEEPEST * outside >= surface - 2.0 * line;
            if outside > 0.0 && outside < rim.outside && is_seen {
                rim = Meeting {
                    height: lobe.center.z,
                    outside,
                    rim: middle,
                    ..rim
                };
            }
        }
        let height = |height: f64| (height - on_board.z) / depth;
        let mut wall = None;
        let mut is_edge = false;
        if !self.bites.is_empty() {
            (top, wall) = self.remains(seen).unwrap_or((f64::NEG_INFINITY, None));
            is_edge = self.is_edge(seen.extend(top), wall, line);
        }
        if top > surface {
            Meeting {
                height: height(top),
                outside: 0.0,
                rim: point,
                wall,
                is_edge,
            }
        } else {
            // Distances along the gradient.
            let gradient = plane * (rim.rim - seen);
            let outside = rim.outside / (plane * (rim.rim - seen).normalize()).length();
            let end = (seen + rim.outside * (rim.rim - seen).normalize_or_zero()).extend(rim.height);
            // The line around a lobe tapers towards a bite.
            let is_bitten = self
                .bites
                .iter()
                .any(|bite| power(end, bite) < 4.0 * outside * bite.radius);
            Meeting {
                height: height(rim.height),
                outside: if is_bitten { f64::INFINITY } else { outside },
                rim: point + gradient,
                ..rim
            }
        }
    }

    /// What is left over a point where lobes are balls: its height, and the bite whose wall it is.
    fn remains(&self, seen: DVec2) -> Option<(f64, Option<usize>)> {
        let through = |ball: &Lobe| bites::crossed(seen.extend(0.0), DVec3::Z, *ball);
        let lobes: Vec<_> = self.lobes.iter().filter_map(through).collect();
        let bites: Vec<_> = self.bites.iter().map(through).collect();
        bites::top(&lobes, &bites)
    }

    /// Whether a place where lobes are balls, on the wall of a bite or on a lobe, is within a line's width of an edge.
    fn is_edge(&self, place: DVec3, wall: Option<usize>, line: f64) -> bool {
        let out_of_lobes = self.ball_normal(place);
        let normal = wall.map_or(out_of_lobes, |bite| (self.bites[bite].center - place).normalize());
        let lean = normal.truncate() / normal.z.max(STEEPEST_LINED);
        // Line width times how fast the distance from an edge grows on the surface, if it grows along `offset`.
        let across = |offset: DVec3| {
            let slope = offset.truncate() - offset.z * lean;
            BITE_LINE * line * (DMat2::from_mat3(self.unstretched) * slope).length()
        };
        let is_beside = |bite: &Lobe| {
            let offset = place - bite.center;
            // Between two walls, each has half of the line.
            let share = if wall.is_some() && offset.z <= 0.0 { 0.5 } else { 1.0 };
            power(place, bite) < 2.0 * share * across(offset)
        };
        let others = self.bites.iter().enumerate().filter(|(bite, _)| Some(*bite) != wall);
        let depth = self.lobes.iter().map(|lobe| lobe.radius - place.distance(lobe.center));
        // Where the wall of a bite meets the front of a lobe, the line is on the front, unless the front is too narrow.
        let share = (1.0 - 2.0 * out_of_lobes.z).min(1.0);
        let is_behind = wall.is_some() && depth.fold(0.0, f64::max) < share * across(out_of_lobes);
        is_behind || others.into_iter().any(|(_, bite)| is_beside(bite))
    }

    /// Unit normal of the wall of a bite.
    pub fn wall_normal(&self, bite: usize, place: DVec3) -> DVec3 {
        let inward = self.bites[bite].center - self.unstretched * place;
        (self.unstretched.transpose() * inward).normalize()
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
        self.ball_normal(self.unstretched * place)
    }

    fn ball_normal(&self, place: DVec3) -> DVec3 {
        let mut own = DVec3::ZERO;
        for lobe in &self.lobes {
            let outward = place - lobe.center;
            let away = (outward.length() - lobe.radius).abs();
            own += (1.0 - away / self.fillet).max(0.0).powi(2) * outward.normalize_or_zero();
        }
        own.normalize_or(DVec3::Z)
    }
}

/// Positive outside of a ball.
fn power(place: DVec3, ball: &Lobe) -> f64 {
    place.distance_squared(ball.center) - ball.radius * ball.radius
}

/// Whether one bite contains a lobe.
fn is_eaten(lobe: &Lobe, bites: &[Lobe]) -> bool {
    bites
        .iter()
        .any(|bite| lobe.center.distance(bite.center) + lobe.radius < bite.radius)
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
