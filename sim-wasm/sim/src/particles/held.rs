//! Columns that are shown while particles are held.

/// Columns as in [`Particles`], at the last held moment.
#[derive(Clone, Debug)]
pub struct Held {
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub z: Vec<f32>,
    /// Below 0 until the first held moment.
    pub age: Vec<f32>,
    pub size: Vec<f32>,
}

impl Held {
    /// All columns in the order of declaration.
    pub fn columns(&self) -> [&[f32]; 5] {
        [&self.x, &self.y, &self.z, &self.age, &self.size]
    }

    /// All columns, mutable, in the order of declaration.
    pub fn columns_mut(&mut self) -> [&mut [f32]; 5] {
        [&mut self.x, &mut self.y, &mut self.z, &mut self.age, &mut self.size]
    }
}
