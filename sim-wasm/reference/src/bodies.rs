//! The body of a particle: a board through its centre, parallel to the image plane. Every ray meets the lobes along the
//! view axis, or the baked front of a billboard. A line of ink, deeper than the puff, surrounds the silhouette.

use glam::{DMat3, DVec2, DVec3};

use crate::attributes::{PackedAttributes, stretching};
use crate::billboards::Billboards;
use crate::contact::{Ground, Ring};
use crate::form::Form;
use crate::ink::{self, Line};
use crate::light::Light;
use crate::lobes::Lobes;
use crate::ray::{Camera, Ray};
use crate::scene::{Illumination, Row, Scene, Style};
use crate::shade::{Along, Shade, gradient_factor, ink_of};

pub struct Body<'a> {
    scene: &'a Scene,
    row: Row,
    attributes: PackedAttributes,
    puff: Puff<'a>,
    /// In view space.
    center: DVec3,
    radius: f64,
    /// View depth of the near plane.
    near: f64,
    /// Metres per pixel at the centre.
    pixel: f64,
    line: Line,
    /// The up direction of the world, in view space.
    up: DVec3,
    /// Unit vector from the centre to the light, in view space. The whole puff uses it.
    light: DVec3,
    /// The light at the centre, which the whole puff has.
    illumination: Illumination,
    form: Option<&'a Form<'a>>,
}

enum Puff<'a> {
    Lobes(Lobes),
    Billboard(&'a Billboards),
}

/// The result over a point of the board; heights and lengths in radii.
struct Met {
    height: f64,
    /// Distance to the silhouette; at most 0 inside.
    outside: f64,
    /// Unit vector towards the silhouette.
    inward: DVec2,
    /// Normal of the form, and normal for shading.
    form_normal: DVec3,
    normal: DVec3,
    /// Factor on the tones: C of Eq. 2.
    color: DVec3,
    /// Whether the line along the edge of a bite is here.
    is_edge: bool,
}

/// The intersection of a ray with a body.
pub struct BodyHit {
    pub depth: f64,
    pub shade: Shade,
    /// From the centre in view space (radii).
    pub place: DVec3,
    /// Of the puff (m).
    pub radius: f64,
    /// Cosine between the normal for shading and the light.
    pub facing: f64,
}

/// Share of its radius with which a particle with a stretch of this ratio is drawn and throws its shadow: it shrinks as
/// the eye moves into it.
pub fn clearance(camera: &Camera, row: &Row, ratio: f64) -> f64 {
    let center = camera.view_from_world.transform_point3(DVec3::from(row.place));
    let beyond_near = if camera.is_perspective() {
        center.length() - camera.near
    } else {
        (-center.z - camera.near).abs()
    };
    ink::smooth_step(0.0, 2.0 * row.radius * ratio.sqrt(), beyond_near)
}

impl<'a> Body<'a> {
    /// None unless the centre of the particle is behind the near plane.
    pub fn new(
        scene: &'a Scene,
        billboards: Option<&'a Billboards>,
        camera: &Camera,
        light: &Light,
        form: Option<&'a Form<'a>>,
        row: Row,
    ) -> Option<Self> {
        let attributes = PackedAttributes(row.attributes);
        let center = camera.view_from_world.transform_point3(DVec3::from(row.place));
        let (axis, ratio) = billboards.map_or_else(|| attributes.stretch(), |_| (DVec3::Z, 1.0));
        // A stretched puff is drawn in units of its width across the stretch.
        let across = ratio.sqrt().recip();
        let radius = row.radius * clearance(camera, &row, ratio) * across;
        if radius <= 0.0 || -center.z <= camera.near {
            return None;
        }
        let turn = DMat3::from_mat4(camera.view_from_world);
        let illumination = light.at(DVec3::from(row.place), &scene.style);
        let light = turn * light.towards(DVec3::from(row.place));
        let pixel = camera.metres_per_pixel(-center.z);
        let Style {
            ink_pixels,
            ink_swell,
            boil,
            drawing,
            ..
        } = scene.style;
        let ink_pixels = ink_pixels * attributes.look(&scene.style).map_or(1.0, |look| look.ink_weight);
        Some(Self {
            scene,
            row,
            attributes,
            puff: billboards.map_or_else(
                || {
                    Puff::Lobes(Lobes::new(
                        &scene.puffs,
                        attributes,
                        turn * attributes.world_from_puff() * across.recip(),
                        (stretching((turn * axis, ratio)) * across.recip(), ratio),
                    ))
                },
                Puff::Billboard,
            ),
            center,
            illumination,
            radius,
            near: camera.near,
            pixel,
            line: Line::new(ink_pixels, radius / pixel, ink_swell, light.truncate()).boiling(
                boil,
                attributes.seed(),
                drawing,
            ),
            up: turn.y_axis,
            light,
            form,
        })
    }

    /// Bounding box in the picture.
    pub fn extent(&self, camera: &Camera) -> [DVec2; 2] {
        let reach = match &self.puff {
            Puff::Lobes(lobes) => lobes.reach(),
            Puff::Billboard(_) => 1.0,
        };
        let reach = reach * self.radius + self.line.widest() * self.pixel;
        let corners =
            [-1.0, 1.0].map(|side| camera.pixel_of(self.center + DVec3::new(side * reach, side * reach, 0.0)));
        [corners[0].min(corners[1]), corners[0].max(corners[1])]
    }

    /// `screen`: 0 at the bottom of the picture, 1 at its top. `at`: the pixel.
    pub fn meet(&self, ray: Ray, screen: f64, ground: &Ground, at: [i64; 2]) -> Option<BodyHit> {
        let point = (ray.at(-self.center.z) - self.center).truncate() / self.radius;
        let width = self.line.width(point - self.middle());
        let surface = (ground.z(at) - self.center.z) / self.radius;
        let met = self.over(point, surface, width * self.pixel / self.radius);
        let is_ring = met.outside > 0.0;
        if is_ring && met.outside * self.radius > width * self.pixel {
            return None;
        }
        let place = point.extend(met.height);
        let z = (self.center.z + met.height * self.radius).min(-self.near);
        let is_ink = is_ring || met.is_edge || ground.is_seam(at, z, met.form_normal, self.pixel, width);
        let height = self.row.place[1] + self.up.dot(ray.at(-z) - self.center);
        let whole = self.form.map(|form| (form, form.facing(ray.at(-z))));
        let shade = self.shade(place, height, met.normal, screen, whole).graded(met.color);
        Some(BodyHit {
            place,
            radius: self.radius,
            facing: met.normal.dot(self.light),
            depth: if is_ring {
                ground.ring_depth(at, &self.ring(z, &met, width))
            } else if met.is_edge {
                self.scene.style.inner_line * self.radius - z
            } else {
                -z
            },
            shade: if is_ink {
                shade.inked(ink_of(&self.scene.style), self.line.share(width))
            } else {
                shade
            },
        })
    }

    /// Outward direction of the line.
    fn middle(&self) -> DVec2 {
        match &self.puff {
            Puff::Lobes(lobes) => lobes.middle.truncate(),
            Puff::Billboard(_) => DVec2::ZERO,
        }
    }

    /// `surface`: height of an occluding surface. `line`: width of the line.
    fn over(&self, point: DVec2, surface: f64, line: f64) -> Met {
        match &self.puff {
            Puff::Lobes(lobes) => {
                let meeting = lobes.meet(point, surface, line);
                let place = point.extend(meeting.height);
                let wall = meeting.wall.map(|bite| lobes.wall_normal(bite, place));
                Met {
                    height: meeting.height,
                    outside: meeting.outside,
                    inward: (meeting.rim - point).normalize_or_zero(),
                    form_normal: wall.unwrap_or_else(|| lobes.form_normal(place)),
                    normal: wall.unwrap_or_else(|| lobes.normal(place)),
                    is_edge: meeting.is_edge,
                    color: DVec3::ONE,
                }
            }
            Puff::Billboard(billboards) => {
                let roll = DVec2::from_angle(self.attributes.roll());
                let pixel = self.pixel / self.radius;
                let front = billboards.at(
                    self.attributes.variation(),
                    DVec2::new(roll.x, -roll.y).rotate(point),
                    pixel,
                );
                let normal = roll.rotate(front.normal.truncate()).extend(front.normal.z);
                Met {
                    height: front.height,
                    outside: front.outside,
                    inward: -point.normalize_or_zero(),
                    form_normal: normal,
                    normal,
                    is_edge: false,
                    color: front.color,
                }
            }
        }
    }

    fn ring(&self, z: f64, met: &Met, width: f64) -> Ring {
        let Style {
            inner_line,
            inner_taper,
            ..
        } = self.scene.style;
        let outside = met.outside * self.radius;
        let share = (outside.max(self.pixel) / (width * self.pixel)).min(1.0);
        Ring {
            rim: z,
            sunken: z - inner_line * self.radius * (1.0 + inner_taper * share),
            outside,
            inward: met.inward * (outside / self.pixel + 0.5),
        }
    }

    /// `height`: world height (m). `whole`: the form of the whole smoke, and its cosine to the light.
    fn shade(&self, place: DVec3, height: f64, normal: DVec3, screen: f64, whole: Option<(&Form, f64)>) -> Shade {
        let style = &self.scene.style;
        let ramp = &style.smoke_ramps[self.attributes.ramp(style)];
        let gradient = gradient_factor(style, &self.along(place.y, height, screen));
        Shade::of_puff(style, &self.illumination, ramp, normal, self.light, whole).graded(gradient)
    }

    fn along(&self, puff: f64, height: f64, screen: f64) -> Along {
        Along {
            puff,
            height,
            screen,
            age: self.attributes.age(),
        }
    }
}
