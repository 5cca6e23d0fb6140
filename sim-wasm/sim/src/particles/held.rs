//! Columns of what is shown while particles are held.

/// Columns as in [`Particles`], of the last held moment.
#[derive(Clone, Debug)]
pub struct Held {
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub z: Vec<f32>,
    /// Below 0 for a particle that has had no held moment yet.
    pub age: Vec<f32>,
    pub size: Vec<f32>,
}

impl Held {
    /// The columns in the order in which they are declared.
    pub fn columns(&self) -> [&[f32]; 5] {
        [&self.x, &self.y, &self.z, &self.age, &self.size]
    }

    /// The columns, writable, in the order in which they are declared.
    pub fn columns_mut(&mut self) -> [&mut [f32]; 5] {
        [&mut self.x, &mut self.y, &mut self.z, &mut self.age, &mut self.size]
    }
}
