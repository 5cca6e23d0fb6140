//! Growth, ageing, cooling and death.
//!
//! radius(age) = size * puff.size * growth(age) * (1 - age / lifetime), exactly 0 at death. growth(age) is
//! smoothstep(age / growthTime), and 1 where growthTime is 0: the linear loss of density of the paper.

/// Radius of a particle from its size and age; two numbers that hold for all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusLaw {
    /// Factor on every radius, `puff.size`.
    pub puff_size: f32,
    /// Seconds until a newborn particle has its full size, `emission.growthTime`; 0: from the start.
    pub growth_time: f32,
}

impl RadiusLaw {
    /// Radius (m) of a particle of `size` (m) at `age` of `lifetime` (s). 0 from the moment of death on; an age
    /// below 0 counts as 0.
    pub fn radius(&self, size: f32, age: f32, lifetime: f32) -> f32 {
        let age = age.max(0.0);
        let density = (1.0 - age / lifetime).max(0.0);
        size * self.puff_size * self.growth(age) * density
    }

    fn growth(&self, age: f32) -> f32 {
        if self.growth_time <= 0.0 {
            return 1.0;
        }
        let t = (age / self.growth_time).min(1.0);
        t * t * (3.0 - 2.0 * t)
    }
}
