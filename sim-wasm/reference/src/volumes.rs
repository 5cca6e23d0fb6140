//! The shadow volume of a particle: what lies behind its puff, seen from the light.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec3};

use crate::look::Look;
use crate::ray::Camera;
use crate::scene::{Row, Scene, StartCaps};
use crate::shade::is_flat;

/// Radii between the farthest lit point and the beginning of the volume.
const SLACK: f64 = 0.02;
/// Where light and shadow differ even on the dark side, no volume begins within its own puff: radii behind the centre.
const BEHIND_THE_PUFF: f64 = 1.2;
/// What of a puff is seen lies no deeper behind its centre plane, in radii.
const DEEPEST: f64 = 0.6;

/// A cylinder without an end.
pub struct Volume {
    start: DVec3,
    travel: DVec3,
    radius: f64,
}

impl Volume {
    pub fn new(scene: &Scene, camera: &Camera, row: &Row) -> Self {
        let towards_light = DVec3::from(scene.towards_light);
        let begin = if is_flat(&scene.style.smoke_ramps[0]) {
            BEHIND_THE_PUFF
        } else {
            0.0
        };
        let cap = begin_behind(scene, camera, row).max(begin);
        Self {
            start: DVec3::from(row.place) - cap * row.radius * towards_light,
            travel: -towards_light,
            radius: scene.puffs.shadow_radius * row.radius,
        }
    }

    pub fn holds(&self, point: DVec3) -> bool {
        let offset = point - self.start;
        let along = offset.dot(self.travel);
        along >= 0.0 && offset.length_squared() - along * along <= self.radius * self.radius
    }
}

/// Radii from the centre, away from the light, to behind the farthest point of the puff that is lit.
fn begin_behind(scene: &Scene, camera: &Camera, row: &Row) -> f64 {
    let look = Look(row.look);
    let towards_light = DVec3::from(scene.towards_light);
    let in_puff = look.world_from_puff().transpose() * towards_light;
    let variation = look.variation() % scene.puffs.lobes.len();
    tabled(&scene.puffs.start_caps, variation, in_puff).max(0.0) + shear(camera, row, towards_light) + SLACK
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
