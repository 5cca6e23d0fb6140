//! A cloud of particles among rigids, and shapes with an independent distance function.
#![allow(dead_code, reason = "each test program uses its own share")]

pub mod shapes;

use sim::math::pose::Pose;
use sim::math::vector::Vector;
use sim::particles::radius::RadiusLaw;
use sim::particles::{Newborn, Particles};
use sim::rigids::{POSE_PAIR_FLOATS, RigidDescription, RigidKind, RigidShape, Rigids};
use sim::simulator::collisions::{Scratch, resolve};

pub const DT: f32 = 1.0 / 60.0;
pub const RADII: RadiusLaw = RadiusLaw::linear(1.0, 0.0);
pub const LIFETIME: f32 = 1e9;

/// A cloud in still air, with the velocity of each particle in its slip.
pub struct Cloud {
    pub particles: Particles,
    pub rigids: Rigids,
    pub scratch: Scratch,
    /// 1/s.
    pub drag: f32,
}

impl Cloud {
    pub fn new(count: usize) -> Self {
        Self {
            particles: Particles::new(count),
            rigids: Rigids::new(),
            scratch: Scratch::new(count),
            drag: 0.0,
        }
    }

    pub fn push(&mut self, position: [f32; 3], slip: [f32; 3], size: f32) {
        let newborn = Newborn {
            position,
            slip,
            age: 0.0,
            lifetime: LIFETIME,
            size,
            temperature: 0.0,
            attributes: 0,
        };
        assert!(self.particles.push(&newborn));
    }

    /// `pull`: a constant acceleration (m/s2) towards the first rigid.
    pub fn step(&mut self, pull: f32) {
        let centre = self.pose(0).position;
        self.rigids.advance(DT);
        let p = &mut self.particles;
        for i in 0..p.alive() {
            let at = Vector::new(p.x[i], p.y[i], p.z[i]);
            let change = (centre - at).unit_or(Vector::Y) * (pull * DT);
            [p.px[i], p.py[i], p.pz[i]] = at.into();
            let keep = 1.0 - self.drag * DT;
            (p.sx[i], p.sy[i], p.sz[i]) = (
                p.sx[i] * keep + change.x,
                p.sy[i] * keep + change.y,
                p.sz[i] * keep + change.z,
            );
            (p.x[i], p.y[i], p.z[i]) = (at.x + p.sx[i] * DT, at.y + p.sy[i] * DT, at.z + p.sz[i] * DT);
        }
        resolve(p, &RADII, std::iter::empty(), &mut self.rigids, DT, &mut self.scratch);
    }

    pub fn position(&self, i: usize) -> Vector {
        Vector::new(self.particles.x[i], self.particles.y[i], self.particles.z[i])
    }

    pub fn pose(&self, rigid: usize) -> Pose {
        let floats = &self.rigids.poses()[rigid * POSE_PAIR_FLOATS + 7..][..7];
        Pose {
            position: Vector::new(floats[0], floats[1], floats[2]),
            rotation: [floats[3], floats[4], floats[5], floats[6]],
        }
    }
}

pub fn rigid(kind: RigidKind, shape: RigidShape, pose: Pose) -> RigidDescription {
    RigidDescription {
        restitution: 0.1,
        friction: 0.2,
        density: 500.0,
        ..RigidDescription::new(kind, shape, pose)
    }
}

pub fn kinematic(shape: RigidShape) -> RigidDescription {
    rigid(RigidKind::Kinematic, shape, Pose::at(Vector::ZERO))
}

/// Numbers in -1..1 without a pattern.
pub fn random(k: usize, salt: usize) -> f32 {
    let mixed = (k as u32).wrapping_mul(0x9e37_79b9) ^ (salt as u32).wrapping_mul(0x85eb_ca6b);
    let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2c1b_3c6d);
    (mixed >> 8) as f32 / 8_388_608.0 - 1.0
}

pub fn turned(axis: Vector, angle: f32) -> [f32; 4] {
    let axis = axis.unit_or(Vector::Y) * (angle / 2.0).sin();
    [axis.x, axis.y, axis.z, (angle / 2.0).cos()]
}

/// How far a particle is inside beyond what is allowed: 5 % of its radius or 1 mm.
pub fn excess(distance: f32, radius: f32) -> f32 {
    radius - distance - (0.05 * radius).max(0.001)
}
