//! The state of all vortex particles, as a struct of arrays in the order of shedding.
//!
//! Gaussian cores spread by viscosity: at the age t, s^2 = s0^2 + 2 v t, and the angular velocity at the centre is w =
//! w0 (s0 / s)^5. This is the exact solution of the diffusion equation for the velocity in `field` without its end: the
//! analogue of Lamb-Oseen for a blob instead of a line. In addition the velocity fades as (1 - (t / T)^2)^2 towards the
//! lifetime T. 52 bytes each.

use wide::f32x4;

use crate::math::hash::Hash;
use crate::math::simd::{LANES, Vector4, blocks};

/// Maximum number of vortex particles. One more replaces the oldest.
pub const MAX_VORTEX_PARTICLES: usize = 1024;

pub const COLUMNS: usize = 13;

/// Maximum coordinate (m). Vortex particles beyond are removed.
const WORLD: f32 = 1e5;

/// One vortex particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VortexParticle {
    /// Centre (m).
    pub position: [f32; 3],
    /// Angular velocity (rad/s) of the air at the centre when it was shed.
    pub swirl: [f32; 3],
    /// Radius of the core (m) when it was shed: about the distance of the maximum speed from the axis.
    pub core_radius: f32,
    /// Rate of spreading (m2/s).
    pub viscosity: f32,
    /// Time since it was shed (s).
    pub age: f32,
    /// Age at its end (s).
    pub lifetime: f32,
}

impl VortexParticle {
    /// Returns true if it is valid: finite, within the world, with a core, and not past its lifetime.
    pub fn is_sound(&self) -> bool {
        self.position.iter().all(|metres| metres.abs() <= WORLD)
            && self.swirl.iter().all(|radians| radians.abs() <= 1e6)
            && (1e-3..=1e3).contains(&self.core_radius)
            && (0.0..=1e3).contains(&self.viscosity)
            && (1e-3..=1e4).contains(&self.lifetime)
            && (0.0..self.lifetime).contains(&self.age)
    }
}

/// Blocks of x, of y and of z.
type Blocks<'s> = [&'s [[f32; LANES]]; 3];

/// Columns of the state, each of the maximum length.
pub struct Swarm {
    /// Centre (m).
    place: [Vec<f32>; 3],
    /// Expected centre in the middle of the coming step (m).
    ahead: [Vec<f32>; 3],
    swirl: [Vec<f32>; 3],
    core_radius: Vec<f32>,
    viscosity: Vec<f32>,
    age: Vec<f32>,
    lifetime: Vec<f32>,
    count: usize,
}

/// A vortex particle at its current age.
pub struct VortexCore {
    pub ahead: [f32; 3],
    /// Angular velocity at the centre (rad/s).
    pub swirl: [f32; 3],
    pub radius: f32,
}

impl Swarm {
    pub fn new() -> Self {
        let zeros = || vec![0.0_f32; MAX_VORTEX_PARTICLES];
        let three = || [zeros(), zeros(), zeros()];
        Self {
            place: three(),
            ahead: three(),
            swirl: three(),
            core_radius: zeros(),
            viscosity: zeros(),
            age: zeros(),
            lifetime: zeros(),
            count: 0,
        }
    }

    pub fn count(&self) -> usize {
        self.count
    }

    /// Number of blocks of [`LANES`].
    pub fn blocks(&self) -> usize {
        self.count.div_ceil(LANES)
    }

    pub fn get(&self, i: usize) -> VortexParticle {
        VortexParticle {
            position: at(&self.place, i),
            swirl: at(&self.swirl, i),
            core_radius: self.core_radius[i],
            viscosity: self.viscosity[i],
            age: self.age[i],
            lifetime: self.lifetime[i],
        }
    }

    /// Removes the oldest so that `coming` more fit.
    pub fn make_room(&mut self, coming: usize) {
        let excess = (self.count + coming)
            .saturating_sub(MAX_VORTEX_PARTICLES)
            .min(self.count);
        if excess > 0 {
            let count = self.count;
            for column in self.columns_mut() {
                column.copy_within(excess..count, 0);
            }
            self.count -= excess;
        }
    }

    /// Adds one; there must be capacity.
    pub fn push(&mut self, particle: &VortexParticle) {
        let i = self.count;
        for axis in 0..3 {
            self.place[axis][i] = particle.position[axis];
            self.ahead[axis][i] = particle.position[axis];
            self.swirl[axis][i] = particle.swirl[axis];
        }
        self.core_radius[i] = particle.core_radius;
        self.viscosity[i] = particle.viscosity;
        self.age[i] = particle.age;
        self.lifetime[i] = particle.lifetime;
        self.count += 1;
    }

    /// Vortex particle `i` at its current age.
    pub fn core(&self, i: usize) -> VortexCore {
        let first = self.core_radius[i] * self.core_radius[i];
        let now = first + 2.0 * self.viscosity[i] * self.age[i];
        let (share, spent) = (first / now, self.age[i] / self.lifetime[i]);
        let left = (1.0 - spent * spent).max(0.0);
        let strength = share * share * share.sqrt() * left * left;
        VortexCore {
            ahead: at(&self.ahead, i),
            swirl: at(&self.swirl, i).map(|component| component * strength),
            radius: now.sqrt(),
        }
    }

    /// Current places and those in the middle of the step, of `len` blocks from `first` on.
    pub fn places(&self, first: usize, len: usize) -> (Blocks<'_>, Blocks<'_>) {
        (part(&self.place, first, len), part(&self.ahead, first, len))
    }

    /// Moves the blocks from `first` on by the velocities `flow` (m/s) in `dt` seconds.
    pub fn follow(&mut self, first: usize, flow: &[Vector4], dt: f32) {
        for (block, flow) in flow.iter().enumerate() {
            let from = LANES * (first + block);
            for (axis, flow) in [flow.x, flow.y, flow.z].into_iter().enumerate() {
                let way = flow * f32x4::splat(dt);
                let (place, ahead) = (&mut self.place[axis], &mut self.ahead[axis]);
                for (lane, way) in way.to_array().into_iter().enumerate() {
                    place[from + lane] += way;
                    ahead[from + lane] = place[from + lane] + 0.5 * way;
                }
            }
        }
    }

    /// Ages all by `dt` seconds and removes those past their lifetime or outside of the world.
    pub fn age(&mut self, dt: f32) {
        let mut kept = 0;
        for i in 0..self.count {
            self.age[i] += dt;
            let is_here = self.place.iter().all(|column| column[i].abs() <= WORLD);
            if is_here && self.age[i] < self.lifetime[i] {
                if kept < i {
                    for column in self.columns_mut() {
                        column[kept] = column[i];
                    }
                }
                kept += 1;
            }
        }
        self.count = kept;
    }

    /// All columns in order.
    pub fn columns(&self) -> [&Vec<f32>; COLUMNS] {
        let ([x, y, z], [ax, ay, az], [wx, wy, wz]) =
            (self.place.each_ref(), self.ahead.each_ref(), self.swirl.each_ref());
        let (radius, viscosity, age, lifetime) = (&self.core_radius, &self.viscosity, &self.age, &self.lifetime);
        [x, y, z, ax, ay, az, wx, wy, wz, radius, viscosity, age, lifetime]
    }

    /// All columns in order, mutable.
    pub fn columns_mut(&mut self) -> [&mut Vec<f32>; COLUMNS] {
        let ([x, y, z], [ax, ay, az], [wx, wy, wz]) =
            (self.place.each_mut(), self.ahead.each_mut(), self.swirl.each_mut());
        let radius = &mut self.core_radius;
        let (viscosity, age, lifetime) = (&mut self.viscosity, &mut self.age, &mut self.lifetime);
        [x, y, z, ax, ay, az, wx, wy, wz, radius, viscosity, age, lifetime]
    }

    /// Sets the number of vortex particles after their columns were written.
    pub fn set_count(&mut self, count: usize) {
        assert!(count <= MAX_VORTEX_PARTICLES, "{count} vortex particles do not fit");
        self.count = count;
    }

    pub fn hash_into(&self, hash: &mut Hash) {
        hash.long(self.count as u64);
        for column in self.columns() {
            hash.floats(&column[..self.count]);
        }
    }
}

fn at(vector: &[Vec<f32>; 3], i: usize) -> [f32; 3] {
    std::array::from_fn(|axis| vector[axis][i])
}

fn part(vector: &[Vec<f32>; 3], first: usize, len: usize) -> Blocks<'_> {
    vector.each_ref().map(|column| &blocks(column, first + len)[first..])
}
