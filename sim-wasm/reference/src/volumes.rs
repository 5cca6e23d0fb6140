//! The shadow volume of a particle.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::attributes::{PackedAttributes, stretching, unfolded, unstretched};
use crate::billboards::Billboards;
use crate::bites::{self, FIRST_START, Lobe};
use crate::bodies::clearance;
use crate::light::Light;
use crate::ray::{Camera, Ray};
use crate::scene::{Row, Scene, StartCaps};

/// Distance (radii) from the farthest lit point to the start of the volume.
const SLACK: f64 = 0.02;
/// Number of places of a view ray that are compared with a silhouette, and the depth (m) of a place without an end.
const SAMPLES: usize = 200;
const FAR: f64 = 1e6;

/// Everything that the puff's lobes hide from the light, from behind the puff to infinity.
pub struct Volume<'a> {
    center: DVec3,
    /// Unit vector away from the light.
    axis: DVec3,
    /// Distance from the centre to its start (m).
    begin: f64,
    /// Inverse distance of the light; 0 for a directional light.
    growth: f64,
    /// Scales the places on the plane through the centre across the axis so that the discs of lobes are round.
    flat: DMat3,
    /// The discs of the lobes on this plane, in metres from the centre.
    discs: Vec<Disc>,
    eaten: Option<Eaten>,
    picture: Option<Picture<'a>>,
}

/// The picture of a billboard as it turns to the light, whose silhouette is what hides the light within the discs.
struct Picture<'a> {
    billboards: &'a Billboards,
    variation: usize,
    /// Its x and y axis, over the radius of the puff.
    axes: [DVec3; 2],
}

impl<'a> Picture<'a> {
    fn new(scene: &Scene, billboards: Option<&'a Billboards>, camera: &Camera, row: &Row, axis: DVec3) -> Option<Self> {
        let billboards = billboards.filter(|_| scene.puffs.are_silhouettes)?;
        let attributes = PackedAttributes(row.attributes);
        let world_from_puff = world_from_puff(scene, camera, attributes);
        let turned = DMat3::from_quat(DQuat::from_rotation_arc(world_from_puff.z_axis, -axis)) * world_from_puff;
        Some(Self {
            billboards,
            variation: attributes.variation(),
            axes: [turned.x_axis, turned.y_axis].map(|axis| axis / row.radius),
        })
    }

    /// `offset`: from the centre, on the plane across the axis.
    fn hides(&self, offset: DVec3) -> bool {
        let [x, y] = self.axes.map(|axis| axis.dot(offset));
        self.billboards.at(self.variation, DVec2::new(x, y), 0.0).outside < 0.0
    }
}

/// An eroded puff in a space about its centre where lobes and bites are balls of their own radii. A line to a lamp is treated
/// as parallel to the axis at each ball.
struct Eaten {
    from_world: DMat3,
    /// Unit vector away from the light.
    axis: DVec3,
    growth: f64,
    lobes: Vec<Lobe>,
    bites: Vec<Lobe>,
}

impl Eaten {
    /// `growth`: inverse distance of the light.
    fn new(scene: &Scene, row: &Row, axis: DVec3, growth: f64) -> Option<Self> {
        let attributes = PackedAttributes(row.attributes);
        let erosion = attributes.erosion();
        if !scene.puffs.is_eroded || erosion <= FIRST_START {
            return None;
        }
        let (along, ratio) = attributes.stretch();
        let from_world = (stretching((along, ratio)) * row.radius).inverse();
        let from_puff = from_world * attributes.world_from_puff() * row.radius;
        let variation = attributes.variation() % scene.puffs.lobes.len();
        let lobe = |(index, &[x, y, z, radius]): (usize, &[f64; 4])| Lobe {
            center: from_puff * DVec3::new(x, y, z) * unfolded(index, attributes.caster_age(), scene.puffs.billow),
            radius,
        };
        Some(Self {
            from_world,
            axis: (from_world * axis).normalize(),
            growth: growth * row.radius / ratio.sqrt(),
            lobes: scene.puffs.lobes[variation].iter().enumerate().map(lobe).collect(),
            bites: bites::bites(erosion, attributes.torn_along(&scene.puffs), from_puff),
        })
    }

    /// Whether a light ray meets what is left, by its offset from the centre where it crosses the plane of the centre.
    fn is_met(&self, offset: DVec3) -> bool {
        let point = (self.from_world * offset).reject_from_normalized(self.axis);
        let through = |ball: &Lobe, cone: f64| {
            let middle = ball.center.dot(self.axis);
            let spread = 1.0 + self.growth * middle;
            let beside = (point * spread - ball.center).reject_from_normalized(self.axis);
            let slope = cone * ball.radius * self.growth / spread;
            let half = ball.radius * ball.radius / (1.0 - slope * slope) - beside.length_squared();
            (half > 0.0).then(|| (middle - half.sqrt(), middle + half.sqrt()))
        };
        let lobes: Vec<_> = self.lobes.iter().filter_map(|lobe| through(lobe, 1.0)).collect();
        let bites: Vec<_> = self.bites.iter().map(|bite| through(bite, 0.0)).collect();
        bites::top(&lobes, &bites).is_some()
    }
}

struct Disc {
    center: DVec3,
    radius: f64,
}

impl<'a> Volume<'a> {
    /// None if the light is within the puff, which it lights entirely, or if nothing is left of the puff near the eye.
    pub fn new(
        scene: &Scene,
        billboards: Option<&'a Billboards>,
        camera: &Camera,
        light: &Light,
        row: &Row,
    ) -> Option<Self> {
        let radius = row.radius * clearance(camera, row, stretch(scene, row).1);
        if radius <= 0.0 {
            return None;
        }
        let row = &Row { radius, ..*row };
        let center = DVec3::from(row.place);
        let growth = 1.0 / light.distance(center);
        let axis = -light.towards(center);
        let flat = flat(scene, row, axis);
        let discs = discs(scene, camera, row, (axis, flat), growth);
        let widest = discs.iter().map(|disc| disc.center.length() + disc.radius);
        if widest.fold(0.0, f64::max) * growth >= 1.0 {
            return None;
        }
        Some(Self {
            center,
            axis,
            begin: begin_behind(scene, camera, light, row) * row.radius,
            growth,
            flat,
            discs,
            eaten: Eaten::new(scene, row, axis, growth),
            picture: Picture::new(scene, billboards, camera, row, axis),
        })
    }

    /// Returns true if it contains a point.
    pub fn contains(&self, point: DVec3) -> bool {
        let offset = point - self.center;
        let along = offset.dot(self.axis);
        let seen = self.flat * offset / (1.0 + self.growth * along);
        let on_plane = (offset - along * self.axis) / (1.0 + self.growth * along);
        along >= self.begin
            && self.discs.iter().any(|disc| seen.distance(disc.center) <= disc.radius)
            && self.eaten.as_ref().is_none_or(|eaten| eaten.is_met(on_plane))
            && self.picture.as_ref().is_none_or(|picture| picture.hides(on_plane))
    }

    /// Returns true if it contains the point of a view ray at a depth, counted as the paper does: on each ray it extends
    /// from the first entry to the last exit.
    pub fn holds(&self, ray: Ray, depth: f64) -> bool {
        if (ray.at(depth) - self.center).dot(self.axis) < self.begin {
            return false;
        }
        let stretches = self.discs.iter().filter_map(|disc| self.stretch_in(disc, ray));
        let (enter, leave) = stretches.fold((f64::INFINITY, f64::NEG_INFINITY), |all, one| {
            (all.0.min(one.0), all.1.max(one.1))
        });
        enter <= depth && depth <= leave && self.is_between_hidden(ray, [enter, depth, leave])
    }

    /// Returns true if a view ray passes behind the silhouette before the second of three depths, and after it.
    fn is_between_hidden(&self, ray: Ray, depths: [f64; 3]) -> bool {
        let Some(picture) = &self.picture else {
            return true;
        };
        // Places on the plane through the centre are on a line. A ray of infinite length ends at the point where it leaves to.
        let [first, here, last] = depths.map(|depth| {
            let offset = ray.at(depth.clamp(-FAR, FAR)) - self.center;
            let along = offset.dot(self.axis);
            (offset - along * self.axis) / (1.0 + self.growth * along)
        });
        let is_hidden = |end: DVec3| (0..=SAMPLES).any(|at| picture.hides(here.lerp(end, at as f64 / SAMPLES as f64)));
        is_hidden(first) && is_hidden(last)
    }

    /// Depths between which a view ray is within the light's rays through a disc.
    fn stretch_in(&self, disc: &Disc, Ray { origin, direction }: Ray) -> Option<(f64, f64)> {
        let origin = origin - self.center;
        // Divergence of the light's rays along the view ray: `scale + depth * gain`.
        let scale = 1.0 + self.growth * origin.dot(self.axis);
        let gain = self.growth * direction.dot(self.axis);
        let offset = self.flat * origin - scale * disc.center;
        let step = self.flat * direction - gain * disc.center;
        let square = disc.radius * disc.radius;
        let a = step.length_squared() - square * gain * gain;
        let b = offset.dot(step) - square * scale * gain;
        let c = offset.length_squared() - square * scale * scale;
        let root = (b * b - a * c).sqrt();
        if root.is_nan() {
            return None;
        }
        let (one, other) = ((-b - root) / a, (-b + root) / a);
        let (low, high) = (one.min(other), one.max(other));
        match (a > 0.0, gain > 0.0) {
            (true, _) => (scale + low * gain > 0.0).then_some((low, high)),
            (false, true) => Some((high, f64::INFINITY)),
            (false, false) => Some((f64::NEG_INFINITY, low)),
        }
    }
}

/// The stretch of a row: axis and ratio.
fn stretch(scene: &Scene, row: &Row) -> (DVec3, f64) {
    match scene.puffs.layers {
        Some(_) => (DVec3::Z, 1.0),
        None => PackedAttributes(row.attributes).stretch(),
    }
}

/// Projects along the light's axis and scales so that the ellipses of stretched lobes are discs, as wide as the lobes across
/// their stretch.
fn flat(scene: &Scene, row: &Row, axis: DVec3) -> DMat3 {
    let (side, up) = axis.any_orthonormal_pair();
    let frame = DMat3::from_cols(side, up, axis);
    let (along, ratio) = stretch(scene, row);
    let stretching = stretching((frame.transpose() * along, ratio)) * ratio.sqrt();
    let mut unstretched = unstretched(stretching);
    unstretched.x_axis.z = 0.0;
    unstretched.y_axis.z = 0.0;
    unstretched.z_axis = DVec3::ZERO;
    frame * unstretched * frame.transpose()
}

fn discs(scene: &Scene, camera: &Camera, row: &Row, (axis, flat): (DVec3, DMat3), growth: f64) -> Vec<Disc> {
    let across = stretch(scene, row).1.sqrt().recip();
    let attributes = PackedAttributes(row.attributes);
    let world_from_puff = world_from_puff(scene, camera, attributes);
    let lobes = &scene.puffs.lobes[attributes.variation() % scene.puffs.lobes.len()];
    let disc = |(index, &[x, y, z, radius]): (usize, &[f64; 4])| {
        let unfolded = unfolded(index, attributes.caster_age(), scene.puffs.billow);
        let center = row.radius * (world_from_puff * DVec3::new(x, y, z)) * unfolded;
        let nearness = 1.0 / (1.0 + growth * center.dot(axis));
        // The cone of rays that touch the lobe.
        let seen = across * radius * row.radius * nearness;
        Disc {
            center: nearness * (flat * center),
            radius: seen / (1.0 - (seen * growth).powi(2)).sqrt(),
        }
    };
    lobes.iter().enumerate().map(disc).collect()
}

fn world_from_puff(scene: &Scene, camera: &Camera, attributes: PackedAttributes) -> DMat3 {
    if scene.puffs.layers.is_some() {
        DMat3::from_mat4(camera.view_from_world).transpose() * DMat3::from_rotation_z(attributes.roll())
    } else {
        attributes.world_from_puff()
    }
}

/// Distance (radii) from the centre, away from the light, to behind the farthest lit point.
fn begin_behind(scene: &Scene, camera: &Camera, light: &Light, row: &Row) -> f64 {
    let attributes = PackedAttributes(row.attributes);
    let towards_light = light.towards(DVec3::from(row.place));
    let world_from_puff = world_from_puff(scene, camera, attributes);
    let variation = attributes.variation() % scene.puffs.lobes.len();
    let cap = if scene.puffs.is_deformed {
        // The lit part of a lobe ends where its normals are perpendicular to the light.
        let stretching = stretching(stretch(scene, row));
        let support = (stretching * towards_light).length_squared();
        let tilt = (support - (stretching.inverse() * towards_light).length_squared().recip()).max(0.0);
        let behind = |(index, &[x, y, z, radius]): (usize, &[f64; 4])| {
            let center = world_from_puff * DVec3::new(x, y, z);
            let unfolded = unfolded(index, attributes.caster_age(), scene.puffs.billow);
            radius * tilt.sqrt() - center.dot(towards_light) * unfolded
        };
        let lobes = scene.puffs.lobes[variation].iter().enumerate();
        lobes.map(behind).fold(0.0, f64::max)
    } else {
        tabled(
            &scene.puffs.start_caps,
            variation,
            world_from_puff.transpose() * towards_light,
        )
    };
    let shear = shear(scene, camera, row, towards_light);
    let start = cap.max(scene.style.min_cap) + shear + SLACK;
    if !scene.puffs.is_eroded {
        return start;
    }
    // Bites open the puff to the light up to its end.
    let reach = (stretching(stretch(scene, row)).transpose() * towards_light).length();
    let end = |(index, &[x, y, z, radius]): (usize, &[f64; 4])| {
        let unfolded = unfolded(index, attributes.caster_age(), scene.puffs.billow);
        radius * reach - (world_from_puff * DVec3::new(x, y, z)).dot(towards_light) * unfolded
    };
    let ends = scene.puffs.lobes[variation].iter().enumerate().map(end);
    let end = ends.fold(0.0, f64::max) + shear + SLACK;
    start + (end - start).max(0.0) * (attributes.erosion() / FIRST_START).min(1.0)
}

/// A board shows its relief along view rays instead of the view axis: a point at a height over the board is displaced
/// sideways by the height times the ray's slope. This is the maximum displacement of a visible lit point away from the
/// light, in particle radii.
fn shear(scene: &Scene, camera: &Camera, row: &Row, towards_light: DVec3) -> f64 {
    if !camera.is_perspective() {
        return 0.0;
    }
    let center = camera.view_from_world.transform_point3(DVec3::from(row.place));
    // A puff keeps its distance from the eye and leaves the picture before it is nearer than this.
    let ahead = (-center.z).max(0.5 * row.radius);
    let [least, greatest] = camera.slopes();
    let light = (DMat3::from_mat4(camera.view_from_world) * towards_light).truncate();
    // Per radius of height, at the board's visible point nearest to its centre; heights are -depth to 1.
    let slope = light.dot((center.truncate() / ahead).clamp(least, greatest));
    // Farther out the slope differs by at most the offset over the depth, and height times offset is at most 1/2. A
    // billboard's relief is baked as shown.
    let tallest = scene.puffs.tallest;
    let product = if scene.puffs.layers.is_some() {
        0.0
    } else {
        0.5 * tallest * tallest
    };
    let aside = product * light.length() * row.radius / ahead;
    (tallest * slope).max(-scene.puffs.depth * slope) + aside
}

fn tabled(caps: &StartCaps, variation: usize, towards: DVec3) -> f64 {
    let cell = |share: f64, count: usize| ((share * count as f64) as usize).min(count - 1);
    let column = cell(towards.y.atan2(towards.x) / TAU + 0.5, caps.width);
    let row = cell(towards.z.clamp(-1.0, 1.0).acos() / PI, caps.height);
    caps.values[(variation * caps.height + row) * caps.width + column]
}
