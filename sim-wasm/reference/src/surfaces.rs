//! Solids of the scene: intersection with rays, and their shadow counts.

use glam::DVec3;

use crate::light::Light;
use crate::mesh::Mesh;
use crate::ray::Ray;
use crate::scene::{Illumination, Shape, Style, Surface};
use crate::shade::Shade;
use crate::triangles::{Crossing, Triangles};

/// Distance (m) below its lit side at which a surface's shadow starts.
const SHADOW_INSET: f64 = 0.012;

enum Solid {
    Ball { center: DVec3, radius: f64 },
    Box { center: DVec3, half: DVec3 },
    Mesh(Triangles),
}

pub struct Solids<'a> {
    solids: Vec<(Solid, &'a Surface)>,
}

impl<'a> Solids<'a> {
    pub fn new(surfaces: &'a [Surface]) -> Self {
        Self {
            solids: surfaces
                .iter()
                .map(|surface| (Solid::new(&surface.shape), surface))
                .collect(),
        }
    }

    /// The surface that a ray meets between two depths, with its depth and colours.
    pub fn meet(&self, ray: Ray, depths: [f64; 2], light: &Light, style: &Style) -> Option<(usize, f64, Shade)> {
        let mut nearest: Option<(usize, Crossing)> = None;
        for (index, (solid, _)) in self.solids.iter().enumerate() {
            solid.cross(ray.origin, ray.direction, &mut |crossing| {
                let is_front = crossing.face.dot(ray.direction) < 0.0;
                let is_between = depths[0] <= crossing.at && crossing.at <= depths[1];
                let is_nearer = nearest.is_none_or(|(_, other)| crossing.at < other.at);
                if is_front && is_between && is_nearer {
                    nearest = Some((index, crossing));
                }
            });
        }
        nearest.map(|(index, crossing)| {
            let surface = self.solids[index].1;
            let place = ray.at(crossing.at);
            let facing = crossing.normal.dot(light.towards(place));
            let colors = match surface.glows {
                true => Illumination::SAME,
                false => light.at(place, style),
            };
            (index, crossing.at, Shade::of(&surface.ramp, &colors, facing, false))
        })
    }

    /// Number of lit faces between a point and the light.
    pub fn shadows_over(&self, point: DVec3, light: &Light) -> u32 {
        let (towards_light, distance) = (light.towards(point), light.distance(point));
        let mut count = 0;
        for (solid, surface) in &self.solids {
            if !surface.casts {
                continue;
            }
            solid.cross(point, towards_light, &mut |crossing| {
                let is_between = SHADOW_INSET < crossing.at && crossing.at < distance;
                count += u32::from(is_between && crossing.face.dot(towards_light) > 0.0);
            });
        }
        count
    }
}

impl Solid {
    fn new(shape: &Shape) -> Self {
        match shape {
            &Shape::Ball { center, radius } => Self::Ball {
                center: center.into(),
                radius,
            },
            &Shape::Box { center, half } => Self::Box {
                center: center.into(),
                half: half.into(),
            },
            Shape::Triangles { .. } => Self::Mesh(Triangles::new(&Mesh::of(shape).expect("triangles"))),
        }
    }

    fn cross(&self, origin: DVec3, direction: DVec3, found: &mut impl FnMut(Crossing)) {
        match self {
            Self::Ball { center, radius } => cross_ball(*center, *radius, origin, direction, found),
            Self::Box { center, half } => cross_box(*center, *half, origin, direction, found),
            Self::Mesh(triangles) => triangles.cross(origin, direction, found),
        }
    }
}

fn cross_ball(center: DVec3, radius: f64, origin: DVec3, direction: DVec3, found: &mut impl FnMut(Crossing)) {
    let middle = (center - origin).dot(direction) / direction.length_squared();
    let beside = (origin + middle * direction).distance_squared(center);
    if beside > radius * radius {
        return;
    }
    let half_chord = ((radius * radius - beside) / direction.length_squared()).sqrt();
    for at in [middle - half_chord, middle + half_chord] {
        let normal = (origin + at * direction - center) / radius;
        found(Crossing {
            at,
            face: normal,
            normal,
        });
    }
}

fn cross_box(center: DVec3, half: DVec3, origin: DVec3, direction: DVec3, found: &mut impl FnMut(Crossing)) {
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let at = (center[axis] + side * half[axis] - origin[axis]) / direction[axis];
            let offset = (origin + at * direction - center).abs();
            let is_inside = (0..3).all(|other| other == axis || offset[other] <= half[other]);
            if at.is_finite() && is_inside {
                let mut normal = DVec3::ZERO;
                normal[axis] = side;
                found(Crossing {
                    at,
                    face: normal,
                    normal,
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Ramp;

    /// Distances of the intersections of a line with a shape, nearest first.
    fn crossings(shape: &Shape, origin: DVec3, direction: DVec3) -> Vec<f64> {
        let mut found = Vec::new();
        Solid::new(shape).cross(origin, direction, &mut |crossing| found.push(crossing.at));
        found.sort_by(f64::total_cmp);
        found
    }

    #[test]
    fn a_box_of_triangles_is_crossed_as_the_box() {
        let corner = |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 1 { 1.0 } else { -1.0 });
        let positions: Vec<f64> = (0..8).flat_map(corner).collect();
        let faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let indices = faces.iter().flat_map(|&[a, b, c, d]| [a, b, c, a, c, d]).collect();
        let triangles = Shape::Triangles {
            normals: positions.clone(),
            positions,
            indices,
            world_from_model: None,
        };
        let cube = Shape::Box {
            center: [0.0; 3],
            half: [1.0; 3],
        };
        let mut met = 0;
        for turn in 0..200 {
            let (sin, cos) = (0.7 * f64::from(turn)).sin_cos();
            let origin = DVec3::new(4.0 * cos, 3.0 - 0.03 * f64::from(turn), 4.0 * sin);
            let direction = DVec3::new(0.3 * sin, 0.1, 0.4 * cos) - origin;
            let (found, expected) = (
                crossings(&triangles, origin, direction),
                crossings(&cube, origin, direction),
            );
            met += expected.len();
            assert!(found.len() == expected.len() && found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9));
        }
        assert!(met > 100);
    }

    #[test]
    fn a_ball_shadows_objects_behind_it_and_its_own_far_side() {
        let ramp = || Ramp {
            lit: Vec::new(),
            unlit: Vec::new(),
            filled: None,
            is_blended: false,
            glow: 0.0,
        };
        let ball = Shape::Ball {
            center: [0.0, 2.0, 0.0],
            radius: 1.0,
        };
        let surfaces = [Surface {
            shape: ball,
            ramp: ramp(),
            casts: true,
            inked: false,
            group: 0,
            carrier: None,
            glows: false,
        }];
        let count = |x: f64, y: f64| Solids::new(&surfaces).shadows_over(DVec3::new(x, y, 0.0), &Light::Sun(DVec3::Y));
        assert_eq!([count(0.9, 0.0), count(1.1, 0.0), count(0.0, 3.5)], [1, 0, 0]);
        assert_eq!([count(0.0, 3.0), count(0.0, 1.0)], [0, 1]);
    }
}
