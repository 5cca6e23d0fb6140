//! Marks of a print: the share of each pixel that they cover. A mark is on a plane: across the view beside the centre of a puff,
//! along the world beneath another surface, or across the view of the backdrop. Lines on smoke follow directions from the centre.

use std::f64::consts::{PI, TAU};

use glam::{DMat2, DMat3, DVec2, DVec3};

use crate::scene::{Marks, Pattern};

/// Amount beside shadow of marks that end where the lightest tone begins, as a share of that in shadow.
const BESIDE_SHADOW: f64 = 0.6;
/// Radii by which dots roll for a full turn of the camera, and the smallest part of them.
const CIRCUMFERENCE: f64 = 6.0;
const FINEST: f64 = 0.25;
/// The noise has nearly a normal distribution, whose quantiles are about 0.6 standard deviations times the logit.
const SPREAD: f64 = 0.6 * 0.2145;

#[derive(Clone, Copy, PartialEq)]
pub enum On {
    Backdrop,
    Surface,
    Smoke,
}

/// What a pixel shows.
#[derive(Clone, Copy)]
pub struct Spot {
    pub on: On,
    /// On smoke from its centre in view space (radii), on surfaces in the world (m), on the backdrop a ray in view space.
    pub at: DVec3,
    /// Change of the place for a pixel, of dots and grain on smoke (radii) and of all marks on the backdrop.
    pub per_pixel: f64,
    /// Of marks that have their centre here, 0 to 1.
    pub amount: f64,
    /// Opacity of ink.
    pub ink: f64,
}

impl Pattern {
    /// Amount on smoke. `facing`: cosine between normal and light.
    pub fn on_smoke(&self, is_lit: bool, facing: f64) -> f64 {
        let share = match is_lit {
            true if self.on_tones => BESIDE_SHADOW * (1.0 - facing / self.full_from.max(1e-3)).clamp(0.0, 1.0),
            false if self.on_shadow => 1.0,
            _ => 0.0,
        };
        rounded(self.amount * share)
    }

    pub fn on_surface(&self, is_lit: bool) -> f64 {
        let share = if is_lit || !self.on_shadow { 0.0 } else { 1.0 };
        rounded(self.amount * share)
    }

    /// `height`: from the bottom to the top of the picture.
    pub fn on_backdrop(&self, height: f64) -> f64 {
        rounded(self.backdrop * height)
    }
}

/// As 8 bits hold it.
pub fn rounded(share: f64) -> f64 {
    (255.0 * share.clamp(0.0, 1.0)).round() / 255.0
}

/// A radius (m) as 8 bits hold its logarithm.
pub fn packed_radius(radius: f64) -> f64 {
    const LOG_RADII: [f64; 2] = [-10.0, 6.0];
    let range = LOG_RADII[1] - LOG_RADII[0];
    (LOG_RADII[0] + range * rounded((radius.log2() - LOG_RADII[0]) / range)).exp2()
}

/// The picture that marks are drawn over.
pub struct Sheet<'a> {
    pattern: &'a Pattern,
    width: i64,
    height: i64,
    spots: Vec<Spot>,
    view_from_world: DMat3,
    tilt: DVec2,
    rolled: DVec2,
}

/// A place on a plane, and its change for a pixel to the right and for one up.
struct Placed {
    place: DVec2,
    gradient: DMat2,
}

impl<'a> Sheet<'a> {
    pub fn new(pattern: &'a Pattern, width: usize, height: usize, spots: Vec<Spot>, view_from_world: DMat3) -> Self {
        // Grain has no direction.
        let angle = if pattern.marks == Marks::Grain {
            0.0
        } else {
            pattern.angle
        };
        let tilt = DVec2::from_angle(angle);
        // The direction to the camera.
        let back = view_from_world.row(2);
        let turns = back.x.atan2(back.z) / TAU;
        let elevation = back.y.clamp(-1.0, 1.0).asin();
        let way = |share: f64| (CIRCUMFERENCE * share / FINEST).round() * FINEST * turns;
        let rolled = DVec2::new(way(tilt.x) + elevation * tilt.y, way(-tilt.y) + elevation * tilt.x);
        let (width, height) = (width as i64, height as i64);
        Self {
            pattern,
            width,
            height,
            spots,
            view_from_world,
            tilt,
            rolled,
        }
    }

    /// Share of a pixel that marks cover.
    pub fn covered(&self, pixel: usize) -> f64 {
        let at = [pixel as i64 % self.width, pixel as i64 / self.width];
        let [x, y] = [0, 1].map(|axis| at[axis] - self.pattern.shift[axis]);
        self.marks([x, y]) * (1.0 - self.spots[pixel].ink)
    }

    fn marks(&self, at: [i64; 2]) -> f64 {
        let inside = self.clamped(at);
        let mut own = self.spot(inside);
        let changes = match own.on {
            On::Smoke if !self.is_flat() => self.changes(&own, inside),
            On::Surface => self.changes(&own, inside),
            _ => [own.per_pixel * DVec3::X, own.per_pixel * DVec3::Y],
        };
        // What is at the border continues beside the picture.
        let [right, up] = [0, 1].map(|axis| (at[axis] - inside[axis]) as f64);
        own.at += right * changes[0] + up * changes[1];
        let plane = plane_of(&own, changes[0].cross(changes[1]));
        let moved = |change: DVec3| Spot {
            at: own.at + change,
            ..own
        };
        let place = self.on_plane(&own, plane);
        let gradient = DMat2::from_cols(
            self.on_plane(&moved(changes[0]), plane) - place,
            self.on_plane(&moved(changes[1]), plane) - place,
        );
        let placed = Placed { place, gradient };
        let lines = |across: DVec2, amount: f64| self.lines(&own, &placed, changes, across, amount);
        match self.pattern.marks {
            Marks::Dots => self.dots(&own, plane, at, &placed),
            Marks::Grain => self.grain(&own, &placed),
            Marks::Lines => lines(DVec2::Y, own.amount),
            Marks::Crosshatch => {
                let second = (2.0 * own.amount - self.pattern.amount).max(0.0);
                lines(DVec2::Y, crossed(own.amount)).max(lines(DVec2::X, crossed(second)))
            }
        }
    }

    fn is_flat(&self) -> bool {
        matches!(self.pattern.marks, Marks::Dots | Marks::Grain)
    }

    fn clamped(&self, [x, y]: [i64; 2]) -> [i64; 2] {
        [x.clamp(0, self.width - 1), y.clamp(0, self.height - 1)]
    }

    /// With directions on smoke in world space where they matter.
    fn spot(&self, [x, y]: [i64; 2]) -> Spot {
        let spot = self.spots[(y * self.width + x) as usize];
        match spot.on {
            On::Smoke if self.is_flat() => Spot {
                at: spot.at.truncate().extend(0.0),
                ..spot
            },
            On::Smoke => Spot {
                at: self.view_from_world.transpose() * spot.at.normalize(),
                ..spot
            },
            _ => spot,
        }
    }

    /// Of a place, for a pixel to the right and for one up.
    fn changes(&self, own: &Spot, at: [i64; 2]) -> [DVec3; 2] {
        [[1, 0], [0, 1]].map(|way| self.change(own, at, way))
    }

    /// To the next pixel, on the side where what the spot is on continues.
    fn change(&self, own: &Spot, [x, y]: [i64; 2], way: [i64; 2]) -> DVec3 {
        let beside = |side: i64| {
            let at = [x + side * way[0], y + side * way[1]];
            let spot = self.spot(self.clamped(at));
            (self.clamped(at) == at && spot.on == own.on).then_some((spot.at - own.at) * side as f64)
        };
        match (beside(-1), beside(1)) {
            (Some(back), Some(forth)) if back.length_squared() >= forth.length_squared() => forth,
            (Some(back), _) => back,
            (None, Some(forth)) => forth,
            (None, None) => self.spot(self.clamped([x + way[0], y + way[1]])).at - own.at,
        }
    }

    fn on_plane(&self, spot: &Spot, [u, v]: [DVec3; 2]) -> DVec2 {
        let place = DVec2::new(spot.at.dot(u), spot.at.dot(v));
        let turned = DVec2::new(place.dot(self.tilt), place.dot(self.tilt.perp()));
        match spot.on {
            On::Smoke => turned + self.rolled,
            // It turns against the camera.
            On::Backdrop => turned - self.rolled,
            On::Surface => turned,
        }
    }

    /// Pitch of the coarser lattice, and how far the finer one has grown. `per_pixel`: change of the place for a pixel.
    /// On the backdrop a pitch that divides the roll of a full turn of the camera.
    fn level(&self, on: On, per_pixel: f64) -> (f64, f64) {
        if on == On::Backdrop {
            return (
                FINEST / (FINEST / (self.pattern.pitch * per_pixel)).round().max(1.0),
                0.0,
            );
        }
        let level = (self.pattern.pitch * per_pixel.max(1e-9)).log2();
        (level.ceil().exp2(), level.ceil() - level)
    }

    /// Share of a pixel inside of an edge at a distance in pixels.
    fn cover(&self, inside: f64) -> f64 {
        (inside / (1.0 + self.pattern.softness) + 0.5).clamp(0.0, 1.0)
    }

    /// Dots at the points of the coarser lattice, between four of them, and between two.
    fn dots(&self, own: &Spot, plane: [DVec3; 2], at: [i64; 2], placed: &Placed) -> f64 {
        let (pitch, between) = self.level(own.on, placed.gradient.determinant().abs().sqrt());
        let [second, third] = [smooth(2.0 * between), smooth(2.0 * between - 1.0)];
        let whole = pitch * pitch / (PI * (1.0 + second + 2.0 * third));
        let coarse = placed.place / pitch;
        let middle = coarse.floor() + 0.5;
        let nearest = (coarse + 0.5).floor();
        let beside = (coarse - middle).abs();
        let edge = if beside.x > beside.y {
            DVec2::new(nearest.x, middle.y)
        } else {
            DVec2::new(middle.x, nearest.y)
        };
        [(nearest, 1.0), (middle, second), (edge, third)]
            .into_iter()
            .filter(|&(_, grown)| grown > 0.0)
            .map(|(point, grown)| self.dot(own, plane, at, placed, point * pitch, whole * grown))
            .fold(0.0, f64::max)
    }

    /// `squared`: area on the plane, divided by pi and by the amount.
    fn dot(&self, own: &Spot, plane: [DVec3; 2], at: [i64; 2], placed: &Placed, point: DVec2, squared: f64) -> f64 {
        let Placed { place, gradient } = placed;
        let way = point - *place;
        let pixels = gradient.inverse() * way;
        let centre = [0, 1].map(|axis| (at[axis] as f64 + 0.5 + pixels[axis]).floor() as i64);
        let shown = self.clamped(centre);
        let there = self.spot(shown);
        let beside = DVec2::from_array([0, 1].map(|axis| (centre[axis] - shown[axis]) as f64));
        let off = (self.on_plane(&there, plane) + *gradient * beside - point).abs();
        let slack = 2.0 * (gradient.x_axis.abs() + gradient.y_axis.abs());
        if there.on != own.on || off.cmpge(slack).any() {
            return 0.0;
        }
        let away = way.length();
        let per_pixel = if away > 0.0 {
            DVec2::new(way.dot(gradient.x_axis), way.dot(gradient.y_axis)).length() / away
        } else {
            gradient.x_axis.length()
        };
        let radius = (squared * there.amount).sqrt() / per_pixel.max(1e-9);
        // Dots that are smaller than a pixel are lighter instead.
        (4.0 * radius * radius).min(1.0) * self.cover(radius.max(0.5) - away / per_pixel.max(1e-9))
    }

    fn grain(&self, own: &Spot, placed: &Placed) -> f64 {
        let amount = own.amount;
        let (pitch, between) = self.level(own.on, placed.gradient.determinant().abs().sqrt());
        let weights = DVec2::new(1.0 - between, between).normalize();
        let point = placed.place / pitch;
        let turn = (CIRCUMFERENCE / pitch).round().max(1.0);
        let noise = DVec2::new(noise(point, turn), noise(2.0 * point, 2.0 * turn)) - 0.5;
        if amount > 0.0 {
            self.cover((SPREAD * (amount / (1.0 - amount)).ln() - weights.dot(noise)) * self.pattern.pitch)
        } else {
            0.0
        }
    }

    /// At equal angles from an axis on smoke, at equal distances elsewhere.
    fn lines(&self, own: &Spot, placed: &Placed, changes: [DVec3; 2], across: DVec2, amount: f64) -> f64 {
        if own.on != On::Smoke {
            let Placed { place, gradient } = placed;
            let slope = DVec2::new(across.dot(gradient.x_axis), across.dot(gradient.y_axis));
            return self.line(own.on, across.dot(*place), slope, amount);
        }
        let axis = self.tilt.rotate(across).extend(0.0);
        let sine = own.at.dot(axis);
        let slope = DVec2::new(axis.dot(changes[0]), axis.dot(changes[1])) / (1.0 - sine * sine).max(1e-4).sqrt();
        self.line(own.on, sine.clamp(-1.0, 1.0).asin(), slope, amount)
    }

    /// `height`: coordinate across the lines.
    fn line(&self, on: On, height: f64, slope: DVec2, amount: f64) -> f64 {
        let per_pixel = slope.length();
        let (pitch, between) = self.level(on, per_pixel);
        let grown = smooth(between);
        let pixels = pitch / per_pixel.max(1e-9);
        let whole = amount * pixels / (1.0 + grown);
        let position = height / pitch;
        let away = (position - (position + 0.5).floor()).abs() * pixels;
        let beside = (position - position.floor() - 0.5).abs() * pixels;
        // Lines that are thinner than a pixel are lighter instead.
        let line = |width: f64, away: f64| self.cover(0.5 * width.max(1.0) - away) * width.min(1.0);
        line(whole, away).max(line(whole * grown, beside))
    }
}

/// The amount of each of two lines that cross and together cover an amount.
fn crossed(amount: f64) -> f64 {
    1.0 - (1.0 - amount).sqrt()
}

/// The axes of the plane that is closest to a surface.
fn plane_of(spot: &Spot, normal: DVec3) -> [DVec3; 2] {
    let a = normal.abs();
    match spot.on {
        On::Surface if a.y > a.x.max(a.z) => [DVec3::X, DVec3::NEG_Z],
        On::Surface if a.x > a.z => [DVec3::NEG_Z, DVec3::Y],
        _ => [DVec3::X, DVec3::Y],
    }
}

/// A random number from 0 to 1 at each point of a lattice, smooth between them. `turn`: number of points in a full turn of the
/// camera, after which they repeat.
fn noise(point: DVec2, turn: f64) -> f64 {
    let cell = point.floor().to_array().map(|axis| axis as i32);
    let share = point - point.floor();
    let column = |x: i32| (cell[0] + x).rem_euclid(turn as i32);
    let number = |x, y| f64::from(hash([column(x), cell[1] + y]) >> 8) / 16_777_215.0;
    let mixed = |low: f64, high: f64, share: f64| low + smooth(share) * (high - low);
    let [lower, upper] = [0, 1].map(|y| mixed(number(0, y), number(1, y), share.x));
    mixed(lower, upper, share.y)
}

fn hash(cell: [i32; 2]) -> u32 {
    let factors = [0x8da6_b343u32, 0xd816_3841];
    let sum = cell.into_iter().zip(factors).fold(0u32, |sum, (part, factor)| {
        sum.wrapping_add((part as u32).wrapping_mul(factor))
    });
    let first = (sum ^ (sum >> 15)).wrapping_mul(0x2c1b_3c6d);
    let second = (first ^ (first >> 12)).wrapping_mul(0x297a_2d39);
    second ^ (second >> 15)
}

fn smooth(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
