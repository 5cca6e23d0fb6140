//! One particle, a sphere, meets one obstacle.
//!
//! In the obstacle's own moving frame the particle's way over the step is followed from where it began: from each
//! point it can safely go on by its distance to the surface (sphere tracing, Hart 1996), so however thin the obstacle
//! is, nothing gets through. Where the two meet, the velocity relative to the surface is turned back by restitution
//! and slowed by friction, and the rest of the way is gone with what is left. At last the sphere is pushed out to the
//! surface.

use crate::collide::core::Core;
use crate::collide::shapes::{Collider, Nearest};
use crate::math::bounds::Bounds;
use crate::math::pose_motion::PoseMotion;
use crate::math::scalar::{greater, lesser};
use crate::math::vector::Vector;

const TRACE_STEPS: u32 = 32;
/// Pieces of a way (see [`PoseMotion`]) that make a quarter of a turn.
const QUARTER_TURN_PIECES: f32 = 8.0;
/// Overlap that counts as none, as a share of the radius; well below what can be seen.
const TOLERANCE: f32 = 1e-3;

/// What becomes of a particle that touches a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Action {
    /// It bounces.
    #[default]
    Bounce,
    /// It dies at once.
    Kill,
    /// It goes on, tinted by this number, 1..=15.
    Tint(u8),
}

impl Action {
    /// The action of these numbers: 0 bounce, 1 kill, 2 tint.
    pub fn from_numbers(action: u8, tint: u8) -> Self {
        match action {
            0 => Self::Bounce,
            1 => Self::Kill,
            _ => Self::Tint(tint),
        }
    }
}

/// How a surface treats what hits it; the shares are 0..1.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Share of the normal velocity that comes back.
    pub restitution: f32,
    /// Share of the tangential velocity that is lost.
    pub friction: f32,
    /// Share of its margin by which a particle keeps off.
    pub roughness: f32,
    /// Restitution and friction matter only where particles bounce.
    pub action: Action,
}

/// A shape on its way through one step.
#[derive(Debug)]
pub struct Obstacle<C> {
    pub shape: C,
    pub motion: PoseMotion,
    pub material: Material,
    /// The world box that holds the shape during the whole step.
    pub bounds: Bounds,
    /// A simple solid that holds the shape.
    pub core: Core,
}

/// A particle on its way through one step.
#[derive(Clone, Copy, Debug)]
pub struct Traveller {
    /// Position when its way began, and where it ends (m).
    pub from: Vector,
    pub to: Vector,
    /// Velocity at the end (m/s), air and slip together.
    pub velocity: Vector,
    /// Metres.
    pub radius: f32,
    /// How much farther (m) than its radius it keeps off the roughest surface, its own for each particle.
    pub margin: f32,
    /// Fraction of the step at which its way began; above 0 for the newborn.
    pub began: f32,
}

/// Which look at the same obstacle within one step this is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// The particle comes as it flew.
    First,
    /// It may have been pushed here by another obstacle: friction has been paid.
    Again,
}

struct Hit {
    /// Fraction of the traveller's way.
    way: f32,
    /// Where, in the obstacle's frame.
    point: Vector,
    normal: Vector,
    /// Where the rest of the way would have led, in the obstacle's frame.
    rest: Vector,
}

impl<C: Collider> Obstacle<C> {
    /// Lets `traveller` bump into the obstacle. False when the two do not touch; then nothing has changed.
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

    /// Along a smooth surface puffs end in one straight line; of a rough one each keeps its own distance.
    #[inline]
    fn contact_radius(&self, traveller: &Traveller) -> f32 {
        traveller.radius + self.material.roughness * traveller.margin
    }

    /// Follows the way until the sphere touches. A sphere that touches already from the start is followed by a smaller
    /// one that does not, and one that was pushed is only kept from crossing the surface.
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

    /// Where the way would have led from `point` on. One that turns is followed for a quarter of a turn at most: farther
    /// round it says nothing of where the surface sends the traveller.
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
                // Along or away from the surface nothing is hit, however near it is.
                gone += greater(close, length / TRACE_STEPS as f32);
            } else {
                gone += free;
            }
            if gone >= length {
                return None;
            }
            last = Some((gone / length, point, nearest.normal));
        }
        // A way that hugs the surface is given up where it has been followed to, outside: late is better than through.
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

    /// What the surface makes of a velocity, or of a way, relative to it; unchanged when it leads away.
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
