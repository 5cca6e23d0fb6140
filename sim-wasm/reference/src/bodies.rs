//! The body of a particle: a board through its centre and parallel to the image plane, on which every ray meets the
//! lobes along the view axis. Round the silhouette runs a line of ink that lies deeper than the puff.

use glam::{DMat3, DVec2, DVec3};

use crate::contact::{Ground, Ring};
use crate::ink::{self, Line};
use crate::light::Light;
use crate::lobes::{Lobes, Meeting};
use crate::look::Look;
use crate::ray::{Camera, Ray};
use crate::scene::{Row, Scene, Style};
use crate::shade::{Along, Shade, gradient_factor};

pub struct Body<'a> {
    scene: &'a Scene,
    row: Row,
    look: Look,
    lobes: Lobes,
    /// In view space.
    center: DVec3,
    radius: f64,
    /// Metres that a pixel spans at the centre.
    pixel: f64,
    line: Line,
    /// What of the way up shows on the image plane.
    up: DVec2,
    /// Unit vector from the centre towards the light, in view space: the whole puff is lit from there.
    light: DVec3,
}

/// What a ray meets of a body.
pub struct BodyHit {
    pub depth: f64,
    pub shade: Shade,
}

/// The share of its radius that a particle is drawn with: a puff that the eye runs into shrinks away.
pub fn grown(camera: &Camera, row: &Row, center: DVec3) -> f64 {
    ink::smooth_step(camera.near, camera.near + 2.0 * row.radius, -center.z)
}

impl<'a> Body<'a> {
    /// None where the particle is not in front of the near plane.
    pub fn new(scene: &'a Scene, camera: &Camera, light: &Light, row: Row) -> Option<Self> {
        let look = Look(row.look);
        let center = camera.view_from_world.transform_point3(DVec3::from(row.place));
        let radius = row.radius * grown(camera, &row, center);
        if radius <= 0.0 {
            return None;
        }
        let turn = DMat3::from_mat4(camera.view_from_world);
        let light = turn * light.towards(DVec3::from(row.place));
        let pixel = camera.metres_per_pixel(-center.z);
        let Style {
            ink_pixels, ink_swell, ..
        } = scene.style;
        Some(Self {
            scene,
            row,
            look,
            lobes: Lobes::new(&scene.puffs, look.variation(), turn * look.world_from_puff()),
            center,
            radius,
            pixel,
            line: Line::new(ink_pixels, radius / pixel, ink_swell, light.truncate()),
            up: turn.y_axis.truncate(),
            light,
        })
    }

    /// Corners of a box in the picture that holds all of it.
    pub fn extent(&self, camera: &Camera) -> [DVec2; 2] {
        let reach = self.lobes.reach() * self.radius + self.line.widest() * self.pixel;
        let corners =
            [-1.0, 1.0].map(|side| camera.pixel_of(self.center + DVec3::new(side * reach, side * reach, 0.0)));
        [corners[0].min(corners[1]), corners[0].max(corners[1])]
    }

    /// `screen`: from 0 at the bottom of the picture to 1 at its top. `at`: the pixel.
    pub fn meet(&self, ray: Ray, screen: f64, ground: &Ground, at: [i64; 2]) -> Option<BodyHit> {
        let point = (ray.at(-self.center.z) - self.center).truncate() / self.radius;
        let width = self.line.width(point - self.lobes.middle.truncate());
        let surface = (ground.z(at) - self.center.z) / self.radius;
        let meeting = self.lobes.meet(point, surface, 2.0 * width * self.pixel / self.radius);
        let is_ring = meeting.outside > 0.0;
        if is_ring && meeting.outside * self.radius > width * self.pixel {
            return None;
        }
        let place = point.extend(meeting.height);
        let z = self.center.z + meeting.height * self.radius;
        let is_ink = is_ring || ground.is_seam(at, z, self.lobes.form_normal(place), self.pixel, width);
        let shade = self.shade(place, screen);
        Some(BodyHit {
            depth: if is_ring {
                ground.ring_depth(at, &self.ring(z, &meeting, point, width))
            } else {
                -z
            },
            shade: if is_ink {
                shade.inked(DVec3::from(self.scene.style.ink_color), self.line.share(width))
            } else {
                shade
            },
        })
    }

    fn ring(&self, z: f64, meeting: &Meeting, point: DVec2, width: f64) -> Ring {
        let Style {
            inner_line,
            inner_taper,
            ..
        } = self.scene.style;
        let outside = meeting.outside * self.radius;
        let share = (outside.max(self.pixel) / (width * self.pixel)).min(1.0);
        Ring {
            rim: z,
            sunken: z - inner_line * self.radius * (1.0 + inner_taper * share),
            outside,
            inward: (meeting.rim - point).normalize_or_zero() * (outside / self.pixel + 0.5),
        }
    }

    fn shade(&self, place: DVec3, screen: f64) -> Shade {
        let style = &self.scene.style;
        let ramp = &style.smoke_ramps[self.look.ramp(&style.bands)];
        let gradient = gradient_factor(style, &self.along(place.truncate(), screen));
        Shade::of_puff(style, ramp, self.lobes.normal(place), self.light, gradient)
    }

    fn along(&self, point: DVec2, screen: f64) -> Along {
        Along {
            puff: point.y,
            height: self.row.place[1] + self.up.dot(point) * self.radius,
            screen,
            age: self.look.age(),
        }
    }
}
