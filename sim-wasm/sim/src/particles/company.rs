//! Columns of ageing by company, see `life::company`.

/// Cells along each side of the grid, a power of two.
pub(crate) const SIDE: u32 = 32;

/// The ageing of each particle by company, and the grid of the update.
#[derive(Clone, Debug)]
pub struct Company {
    /// Additional ageing in a step (s); negative inside a group.
    pub extra_ageing: Vec<f32>,
    /// Sum of cubed radii in each cell.
    pub(crate) cells: Vec<f32>,
}

impl Company {
    /// No particle ages faster. `padded`: the length of the columns of the particles.
    pub fn new(padded: usize) -> Self {
        Self {
            extra_ageing: vec![0.0; padded],
            cells: vec![0.0; (SIDE * SIDE * SIDE) as usize],
        }
    }
}
