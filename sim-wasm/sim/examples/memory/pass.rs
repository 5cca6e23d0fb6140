//! What a step cannot be cheaper than: to read and to write the state that it reads and writes, and no more.

/// Columns that a step reads and writes: the places now and one step earlier, the slip, age and temperature.
const CHANGED: usize = 11;

/// As many bytes as a step touches, in columns as long as those of the simulator.
pub struct Columns {
    changed: Vec<Vec<f32>>,
    /// The lifetime is read and never changed.
    read: Vec<u32>,
}

impl Columns {
    /// Columns for `count` particles.
    pub fn new(count: usize) -> Self {
        Self {
            changed: (0..CHANGED).map(|_| vec![1.0; count]).collect(),
            read: vec![1; count],
        }
    }

    /// Reads every column once and writes the changed ones once. Returns a value of the read columns, so that no
    /// compiler drops it.
    pub fn pass(&mut self) -> u32 {
        for column in &mut self.changed {
            column.iter_mut().for_each(|value| *value += 0.25);
        }
        self.read.iter().fold(0, |sum, value| sum ^ value)
    }
}
