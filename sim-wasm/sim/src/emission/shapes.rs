//! The place and the direction of births.
//!
//! Places are uniform over the shape, by volume, area or length. Directions are uniform over the cone of half angle
//! `spread` about the emitter's direction; on a sphere or a surface, about the outward normal. A cone is a nozzle:
//! particles leave its disc as if they came from the apex, whose half angle is `spread`.

use crate::emission::surface::{Surface, Surfaces};
use crate::layout::parameters::emitter::Emitter;
use crate::math::double::direction;
use crate::math::random::{Random, in_ball};

/// Maximum half angle of a cone (rad): at a right angle its disc is infinite.
const MAX_CONE_ANGLE: f64 = 1.5;

/// The place of a birth (m), and the rule for its direction.
pub struct BirthPoint {
    pub place: [f32; 3],
    heading_rule: HeadingRule,
}

/// The rule for the direction of a birth.
enum HeadingRule {
    /// In the cone about the emitter's direction.
    Ahead,
    /// In the cone about this unit vector.
    About([f32; 3]),
    /// Along this unit vector.
    Along([f32; 3]),
}

/// An emitter prepared for many births.
pub struct Nozzle<'e> {
    emitter: &'e Emitter,
    surface: Option<&'e Surface>,
    centre: [f32; 3],
    ahead: Axis,
    /// 1 - cos(spread).
    cap: f32,
    /// Tangent of the half angle of a nozzle.
    slope: f32,
}

impl<'e> Nozzle<'e> {
    /// Prepares `emitter`, whose surface is one of `surfaces`.
    pub fn new(emitter: &'e Emitter, surfaces: &'e Surfaces) -> Self {
        Self {
            emitter,
            surface: surfaces.get(emitter.surface as usize),
            centre: emitter.position.map(|metres| metres as f32),
            ahead: Axis::new(direction(emitter.direction)),
            cap: 1.0 - libm::cos(emitter.spread) as f32,
            slope: libm::tan(emitter.spread.min(MAX_CONE_ANGLE)) as f32,
        }
    }

    /// Picks a place of birth. A missing surface counts as a point.
    pub fn birth_point(&self, random: &mut Random) -> BirthPoint {
        match self.emitter.shape as u32 {
            1 => self.ahead_from(self.across(disc(0.0, random))),
            2 => self.ahead_from(in_ball(random).map(|part| part * self.radius())),
            3 => self.ahead_from(self.across(disc(self.emitter.inner as f32, random))),
            4 => self.on_sphere(random),
            5 => self.ahead_from(self.emitter.extent.map(|half| random.signed() * half as f32)),
            6 => self.in_nozzle(random),
            7 => self.on_line(random),
            8 => self.on_surface(random),
            _ => self.ahead_from([0.0; 3]),
        }
    }

    /// Picks the unit direction of a birth at `point`.
    pub fn heading(&self, point: &BirthPoint, random: &mut Random) -> [f32; 3] {
        match point.heading_rule {
            HeadingRule::Ahead => self.ahead.cone(self.cap, random),
            HeadingRule::About(normal) => Axis::new(normal).cone(self.cap, random),
            HeadingRule::Along(heading) => heading,
        }
    }

    fn radius(&self) -> f32 {
        self.emitter.radius as f32
    }

    fn from(&self, offset: [f32; 3], heading_rule: HeadingRule) -> BirthPoint {
        BirthPoint {
            place: std::array::from_fn(|i| self.centre[i] + offset[i]),
            heading_rule,
        }
    }

    fn ahead_from(&self, offset: [f32; 3]) -> BirthPoint {
        self.from(offset, HeadingRule::Ahead)
    }

    /// The offset of a point of the unit disc.
    fn across(&self, [side, other_side]: [f32; 2]) -> [f32; 3] {
        self.ahead
            .vector(side, other_side, 0.0)
            .map(|part| part * self.radius())
    }

    fn on_sphere(&self, random: &mut Random) -> BirthPoint {
        // Archimedes: uniform along the axis is uniform over the sphere.
        let normal = self.ahead.cone(2.0, random);
        self.from(normal.map(|part| part * self.radius()), HeadingRule::About(normal))
    }

    fn in_nozzle(&self, random: &mut Random) -> BirthPoint {
        let place = disc(0.0, random);
        let [side, other_side] = place.map(|part| part * self.slope);
        let length = (1.0 + side * side + other_side * other_side).sqrt();
        let heading = self.ahead.vector(side, other_side, 1.0).map(|part| part / length);
        self.from(self.across(place), HeadingRule::Along(heading))
    }

    fn on_line(&self, random: &mut Random) -> BirthPoint {
        let along = random.signed();
        self.ahead_from(self.emitter.extent.map(|half| along * half as f32))
    }

    fn on_surface(&self, random: &mut Random) -> BirthPoint {
        let Some(surface) = self.surface else {
            return self.ahead_from([0.0; 3]);
        };
        let (place, normal) = surface.pick(random);
        self.from(place, HeadingRule::About(normal))
    }
}

/// An orthonormal basis.
struct Axis {
    direction: [f32; 3],
    side: [f32; 3],
    other_side: [f32; 3],
}

impl Axis {
    fn new(direction: [f32; 3]) -> Self {
        let [side, other_side] = normals(direction);
        Self {
            direction,
            side,
            other_side,
        }
    }

    /// The vector with these components in the basis.
    fn vector(&self, side: f32, other_side: f32, forward: f32) -> [f32; 3] {
        std::array::from_fn(|i| side * self.side[i] + other_side * self.other_side[i] + forward * self.direction[i])
    }

    /// A uniform unit vector in the cone about the axis; `cap` is 1 minus the cosine of its half angle.
    fn cone(&self, cap: f32, random: &mut Random) -> [f32; 3] {
        let forward = 1.0 - random.unit() * cap;
        let across = libm::sqrtf((1.0 - forward * forward).max(0.0));
        let (sine, cosine) = libm::sincosf(random.unit() * std::f32::consts::TAU);
        self.vector(across * cosine, across * sine, forward)
    }
}

/// A uniform point of the unit disc outside of the radius `inner`.
fn disc(inner: f32, random: &mut Random) -> [f32; 2] {
    let hole = inner * inner;
    let distance = libm::sqrtf(hole + random.unit() * (1.0 - hole));
    let (sine, cosine) = libm::sincosf(random.unit() * std::f32::consts::TAU);
    [distance * cosine, distance * sine]
}

/// Two unit vectors orthogonal to the unit vector `n` and to each other. Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6 (1), 2017.
fn normals([x, y, z]: [f32; 3]) -> [[f32; 3]; 2] {
    let sign = 1.0_f32.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
}
