//! The shadow volume of a particle: what lies behind its puff, seen from the light.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec3};

use crate::light::Light;
use crate::look::Look;
use crate::ray::Camera;
use crate::scene::{Row, Scene, StartCaps};

/// Radii between the farthest lit point and the beginning of the volume.
const SLACK: f64 = 0.02;
/// What of a puff is seen lies no deeper behind its centre plane, in radii.
const DEEPEST: f64 = 0.6;

/// A lamp so near that its shadow would open more than this with each metre throws none that is wider.
const WIDEST: f64 = 2.0;

/// A cone without an end that is cut flat where it begins; a cylinder under a sun.
pub struct Volume {
    center: DVec3,
    /// Unit vector away from the light.
    axis: DVec3,
    /// Where it begins behind the centre, and its radius there beside the centre: metres.
    begin: f64,
    radius: f64,
    /// Of the radius, with each metre along the axis.
    growth: f64,
}

impl Volume {
    /// None where the light stands within the puff: it lights all of it then.
    pub fn new(scene: &Scene, camera: &Camera, light: &Light, row: &Row) -> Option<Self> {
        let center = DVec3::from(row.place);
        let ball = scene.puffs.shadow_radius * row.radius;
        // The cone from the lamp that touches the ball: a sun is endlessly far.
        let sine = ball / light.distance(center);
        if sine >= 1.0 {
            return None;
        }
        let growth = sine.asin().tan().min(WIDEST);
        Some(Self {
            center,
            axis: -light.towards(center),
            begin: begin_behind(scene, camera, light, row) * row.radius,
            radius: ball / growth.atan().cos(),
            growth,
        })
    }

    pub fn holds(&self, point: DVec3) -> bool {
        let offset = point - self.center;
        let along = offset.dot(self.axis);
        along >= self.begin && (offset - along * self.axis).length() <= self.radius + self.growth * along
    }
}

/// Radii from the centre, away from the light, to behind the farthest point of the puff that is lit.
fn begin_behind(scene: &Scene, camera: &Camera, light: &Light, row: &Row) -> f64 {
    let look = Look(row.look);
    let towards_light = light.towards(DVec3::from(row.place));
    let in_puff = look.world_from_puff().transpose() * towards_light;
    let variation = look.variation() % scene.puffs.lobes.len();
    tabled(&scene.puffs.start_caps, variation, in_puff).max(scene.style.least_cap)
        + shear(camera, row, towards_light)
        + SLACK
}

/// A board shows its relief along the view rays and not along the view axis: a point at a height over the board is
/// moved sideways by that height times the ray's slope. How much farther from the light that can take a lit point.
fn shear(camera: &Camera, row: &Row, towards_light: DVec3) -> f64 {
    if !camera.is_perspective() {
        return 0.0;
    }
    let center = camera.view_from_world.transform_point3(DVec3::from(row.place));
    let light = (DMat3::from_mat4(camera.view_from_world) * towards_light).truncate();
    // Per radius of height, at the middle of the board; heights go from -DEEPEST to 1.
    let slope = -light.dot(center.truncate()) / center.z;
    // Away from the middle the slope differs by the offset over the depth, and height times offset is at most 1/2.
    let aside = 0.5 * light.length() * row.radius / -center.z;
    slope.max(-DEEPEST * slope) + aside
}

fn tabled(caps: &StartCaps, variation: usize, towards: DVec3) -> f64 {
    let cell = |share: f64, count: usize| ((share * count as f64) as usize).min(count - 1);
    let column = cell(towards.y.atan2(towards.x) / TAU + 0.5, caps.width);
    let row = cell(towards.z.clamp(-1.0, 1.0).acos() / PI, caps.height);
    caps.values[(variation * caps.height + row) * caps.width + column]
}
