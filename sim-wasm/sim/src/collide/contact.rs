//! Collision of one particle, a sphere, with one obstacle.
//!
//! The path of the particle is traced in the obstacle's moving frame: from each point it can advance safely by its
//! distance to the surface (sphere tracing, Hart 1996), so nothing passes through thin obstacles. At a hit, restitution
//! reflects the velocity relative to the surface, friction reduces it, and the rest of the path follows the new
//! velocity. Finally the sphere is pushed out to the surface.

use crate::collide::core::Core;
use crate::collide::shapes::{Collider, Nearest};
use crate::math::bounds::Bounds;
use crate::math::pose_motion::PoseMotion;
use crate::math::scalar::{greater, lesser};
use crate::math::vector::Vector;

const TRACE_STEPS: u32 = 32;
/// Pieces (see [`PoseMotion`]) that make a quarter turn.
const QUARTER_TURN_PIECES: f32 = 8.0;
/// Overlap that is ignored, as a share of the radius; not visible.
const TOLERANCE: f32 = 1e-3;

/// Effect of a surface on a particle that touches it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Action {
    /// The particle bounces.
    #[default]
    Bounce,
    /// The particle dies.
    Kill,
    /// The particle continues with this tint, 1..=15.
    Tint(u8),
}

impl Action {
    /// Action 0 bounce, 1 kill, 2 tint.
    pub fn from_numbers(action: u8, tint: u8) -> Self {
        match action {
            0 => Self::Bounce,
            1 => Self::Kill,
            _ => Self::Tint(tint),
        }
    }
}

/// Material of a surface. All shares are 0..1.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Share of the normal velocity that is reflected.
    pub restitution: f32,
    /// Share of the tangential velocity that is lost.
    pub friction: f32,
    /// Share of its margin that a particle keeps as distance.
    pub roughness: f32,
    /// Restitution and friction apply to bouncing only.
    pub action: Action,
}

/// A shape and its motion over one step.
#[derive(Debug)]
pub struct Obstacle<C> {
    pub shape: C,
    pub motion: PoseMotion,
    pub material: Material,
    /// World-space box of the shape during the whole step.
    pub bounds: Bounds,
    /// A bounding solid of the shape.
    pub core: Core,
}

/// A particle and its path over one step.
#[derive(Clone, Copy, Debug)]
pub struct Traveller {
    /// Positions at the start and at the end of the path (m).
    pub from: Vector,
    pub to: Vector,
    /// Velocity at the end (m/s): air plus slip.
    pub velocity: Vector,
    /// Radius (m).
    pub radius: f32,
    /// Maximum extra distance (m) that it keeps from rough surfaces; differs per particle.
    pub margin: f32,
    /// Fraction of the step at which the path starts; above 0 for newborn particles.
    pub began: f32,
}

/// The round in which a particle meets an obstacle within one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// The first: the particle follows its own path.
    First,
    /// A later one: another obstacle may have pushed the particle. Friction has been applied.
    Again,
}

struct Hit {
    /// Fraction of the path.
    way: f32,
    /// Point of contact in the obstacle's frame.
    point: Vector,
    normal: Vector,
    /// Rest of the path in the obstacle's frame.
    rest: Vector,
}

impl<C: Collider> Obstacle<C> {
    /// Resolves a collision of `traveller` with the obstacle. Returns false and changes nothing if they do not touch.
    pub fn meet(&self, traveller: &mut Traveller, pass: Pass) -> bool {
        let end = self.motion.frame(1.0);
        let to = end.local_from_world(traveller.to);
        let from = self.motion.frame(traveller.began).local_from_world(traveller.from);
        let way = (to - from).length() + self.motion.detour(from, to);
        let radius = self.contact_radius(traveller);
        let last = self.shape.nearest(to, radius + way);
        if last.distance >= radius + way {
            return false;
        }
        if let Some(hit) = self.trace(traveller, from, &last, way, pass) {
            self.bounce(traveller, &hit, pass);
            return true;
        }
        if last.distance >= radius * (1.0 - TOLERANCE) {
            return false;
        }
        self.respond(traveller, end.rotate(last.normal), 1.0, traveller.to, pass);
        traveller.to = end.world_from_local(to + last.normal * (radius - last.distance));
        true
    }

    /// Puffs along a smooth surface end in one straight line. On a rough surface each keeps its own distance.
    #[inline]
    fn contact_radius(&self, traveller: &Traveller) -> f32 {
        traveller.radius + self.material.roughness * traveller.margin
    }

    /// Traces the path until the sphere touches. A sphere that touches at the start is traced with a smaller radius;
    /// one that was pushed is only kept from crossing the surface.
    fn trace(&self, traveller: &Traveller, from: Vector, last: &Nearest, way: f32, pass: Pass) -> Option<Hit> {
        let first = self.shape.nearest(from, f32::INFINITY);
        if first.distance <= 0.0 {
            return None;
        }
        let probe = match pass {
            Pass::First => lesser(self.contact_radius(traveller), 0.9 * first.distance),
            Pass::Again => 0.25 * lesser(self.contact_radius(traveller), first.distance),
        };
        if first.distance + last.distance.abs() >= way + 2.0 * probe && last.distance > 0.0 {
            return None;
        }
        let pieces = self.motion.pieces();
        let mut start = from;
        for piece in 1..=pieces {
            let part = piece as f32 / pieces as f32;
            let end = self.local_at(traveller, part);
            if let Some((along, point, normal)) = self.trace_piece(start, end, probe) {
                let way = (part - 1.0 / pieces as f32) + along / pieces as f32;
                return Some(Hit {
                    way,
                    point,
                    normal,
                    rest: self.rest(traveller, point, way, (end - start) * (1.0 - along)),
                });
            }
            start = end;
        }
        None
    }

    /// The rest of the path after `point`. A rotating path is followed for at most a quarter turn: beyond, it does not
    /// predict where the surface sends the particle.
    fn rest(&self, traveller: &Traveller, point: Vector, way: f32, within_piece: Vector) -> Vector {
        let pieces = self.motion.pieces();
        if pieces == 1 {
            return within_piece;
        }
        let quarter = QUARTER_TURN_PIECES / pieces as f32;
        self.local_at(traveller, (way + quarter).min(1.0)) - point
    }

    #[inline]
    fn local_at(&self, traveller: &Traveller, way: f32) -> Vector {
        let frame = self.motion.frame(traveller.began + (1.0 - traveller.began) * way);
        frame.local_from_world(traveller.from.towards(traveller.to, way))
    }

    fn trace_piece(&self, from: Vector, to: Vector, probe: f32) -> Option<(f32, Vector, Vector)> {
        let length = (to - from).length();
        let close = probe * 0.02 + 1e-5;
        let mut gone = 0.0;
        let mut last = None;
        for _ in 0..TRACE_STEPS {
            let point = if length > 0.0 {
                from.towards(to, gone / length)
            } else {
                from
            };
            let nearest = self.shape.nearest(point, probe + length - gone);
            let free = nearest.distance - probe;
            if free <= close {
                if nearest.normal.dot(to - from) < 0.0 {
                    return Some((gone / length, point, nearest.normal));
                }
                // Moving along or away from the surface is no hit, at any distance.
                gone += greater(close, length / TRACE_STEPS as f32);
            } else {
                gone += free;
            }
            if gone >= length {
                return None;
            }
            last = Some((gone / length, point, nearest.normal));
        }
        // A grazing path ends where tracing ends, outside of the surface: a late hit is better than a missed one.
        last
    }

    fn bounce(&self, traveller: &mut Traveller, hit: &Hit, pass: Pass) {
        let fraction = traveller.began + (1.0 - traveller.began) * hit.way;
        let frame = self.motion.frame(fraction);
        self.respond(
            traveller,
            frame.rotate(hit.normal),
            fraction,
            frame.world_from_local(hit.point),
            pass,
        );
        let rest = self.reflected(hit.rest, hit.normal, pass);
        let wanted = hit.point + rest;
        let radius = self.contact_radius(traveller);
        let nearest = self.shape.nearest(wanted, radius);
        let lack = greater(radius - nearest.distance, 0.0);
        traveller.to = self.motion.frame(1.0).world_from_local(wanted + nearest.normal * lack);
    }

    fn respond(&self, traveller: &mut Traveller, normal: Vector, fraction: f32, point: Vector, pass: Pass) {
        let surface = self.motion.velocity_at(point, fraction);
        traveller.velocity = surface + self.reflected(traveller.velocity - surface, normal, pass);
    }

    /// Applies restitution and friction to a relative velocity or displacement. No change if it leads away from the
    /// surface.
    #[inline]
    fn reflected(&self, velocity: Vector, normal: Vector, pass: Pass) -> Vector {
        let inward = velocity.dot(normal);
        if inward >= 0.0 {
            return velocity;
        }
        let along = velocity - normal * inward;
        let kept = if pass == Pass::First {
            1.0 - self.material.friction
        } else {
            1.0
        };
        along * kept - normal * (self.material.restitution * inward)
    }
}
