//! What smoke bumps into: analytic colliders here, rigids of Rapier by the feature `rigids`.

use crate::life::RadiusLaw;
use crate::particles::Particles;
#[cfg(feature = "rigids")]
use crate::rigids::Rigids;

/// Shape of an [`AnalyticCollider`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColliderShape {
    /// The half space below `position`, `axis` is its outward normal.
    Plane,
    /// A ball of `radius`.
    Ball,
    /// A box of `half_extents`, its y axis along `axis`.
    Box,
    /// A capsule of `radius`, its straight part `half_extents[1]` to both sides of `position` along `axis`.
    Capsule,
}

/// A resting obstacle in closed form, as the parameters `colliders.#.*` describe it.
#[derive(Clone, Copy, Debug)]
pub struct AnalyticCollider {
    pub shape: ColliderShape,
    /// A point on the plane, or the centre (m).
    pub position: [f32; 3],
    /// Unit vector: the plane's normal, the capsule's or box's y axis.
    pub axis: [f32; 3],
    /// Half sides of the box (m); the capsule uses the second.
    pub half_extents: [f32; 3],
    /// Radius of ball and capsule (m).
    pub radius: f32,
    /// Share of the normal velocity that comes back, 0..1.
    pub restitution: f32,
    /// Share of the tangential velocity that is lost, 0..1.
    pub friction: f32,
}

/// Memory that [`resolve`] needs, made once: at most 8 bytes a particle.
#[derive(Debug)]
pub struct Scratch {}

impl Scratch {
    /// Scratch for `capacity` particles.
    pub fn new(_capacity: usize) -> Self {
        Self {}
    }
}

/// Moves particles out of colliders and rigids, after motion and before ageing; their positions of one step earlier
/// (`px`, `py`, `pz`) are still those of the step's start. Never allocates. `dt` in seconds; `radii.radius(..)` gives
/// the collision radius in metres.
pub fn resolve(
    _particles: &mut Particles,
    _radii: &RadiusLaw,
    _colliders: &[AnalyticCollider],
    #[cfg(feature = "rigids")] _rigids: &mut Rigids,
    _dt: f32,
    _scratch: &mut Scratch,
) {
}
