//! The state of every vortex particle, as a struct of arrays in the order in which they were shed.
//!
//! Their Gaussian cores spread by viscosity: with the age t, s^2 = s0^2 + 2 v t, and the swirl at the centre is
//! w = w0 (s0 / s)^5. This is the exact solution of the equation of diffusion for the velocity that `field` gives, but
//! for its end: like that of Lamb and Oseen, but of a blob in space instead of a line. On top of it the swirl fades as
//! (1 - (t / T)^2)^2, so that nothing jerks when one dies at its lifetime T. 52 bytes each.

use wide::f32x4;

use crate::math::hash::Hash;
use crate::math::simd::{LANES, Vector4, blocks};

/// Most vortex particles that live at once. When one more is shed, that goes which was shed first.
pub const MAX_VORTEX_PARTICLES: usize = 1024;

pub const COLUMNS: usize = 13;

/// What drifts farther from the origin along an axis (m) is given up.
const WORLD: f32 = 1e5;

/// One vortex particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VortexParticle {
    /// Its centre (m).
    pub position: [f32; 3],
    /// Angular velocity (rad/s) of the air at its centre when it was shed, along its axis.
    pub swirl: [f32; 3],
    /// Distance (m) from its axis at which the air was about fastest when it was shed.
    pub core_radius: f32,
    /// How fast it spreads (m2/s).
    pub viscosity: f32,
    /// Time since it was shed (s).
    pub age: f32,
    /// Age at its end (s).
    pub lifetime: f32,
}

impl VortexParticle {
    /// Whether it can be followed: finite, within the world, of a size, and not past its end.
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

/// Columns of the state, each as long as there can be vortex particles.
pub struct Swarm {
    /// Centre (m).
    place: [Vec<f32>; 3],
    /// Where it is expected in the middle of the coming step (m).
    ahead: [Vec<f32>; 3],
    swirl: [Vec<f32>; 3],
    core_radius: Vec<f32>,
    viscosity: Vec<f32>,
    age: Vec<f32>,
    lifetime: Vec<f32>,
    count: usize,
}

/// One as it is now.
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

    /// Blocks of [`LANES`] that hold them.
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

    /// Lets those go that were shed first, as many as it takes for `coming` more to fit.
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

    /// Adds one, for which there must be room.
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

    /// Number `i` as it is now.
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

    /// Places now and in the middle of the step, of `len` blocks from `first` on.
    pub fn places(&self, first: usize, len: usize) -> (Blocks<'_>, Blocks<'_>) {
        (part(&self.place, first, len), part(&self.ahead, first, len))
    }

    /// Moves the blocks from `first` on with the velocities `flow` (m/s) of a step of `dt` seconds.
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

    /// Makes all `dt` seconds older, and lets those go that have reached their lifetime or left the world.
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

    /// All columns in their order.
    pub fn columns(&self) -> [&Vec<f32>; COLUMNS] {
        let ([x, y, z], [ax, ay, az], [wx, wy, wz]) =
            (self.place.each_ref(), self.ahead.each_ref(), self.swirl.each_ref());
        let (radius, viscosity, age, lifetime) = (&self.core_radius, &self.viscosity, &self.age, &self.lifetime);
        [x, y, z, ax, ay, az, wx, wy, wz, radius, viscosity, age, lifetime]
    }

    /// All columns in their order, writable.
    pub fn columns_mut(&mut self) -> [&mut Vec<f32>; COLUMNS] {
        let ([x, y, z], [ax, ay, az], [wx, wy, wz]) =
            (self.place.each_mut(), self.ahead.each_mut(), self.swirl.each_mut());
        let radius = &mut self.core_radius;
        let (viscosity, age, lifetime) = (&mut self.viscosity, &mut self.age, &mut self.lifetime);
        [x, y, z, ax, ay, az, wx, wy, wz, radius, viscosity, age, lifetime]
    }

    /// Declares the first `count` slots to be vortex particles, after their columns were written.
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
